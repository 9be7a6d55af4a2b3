"""Whether a tier isolates here, and a message comes through: a slot asks before it judges its first answer.

Runs a program that tries what must not work and publishes what came of it.
"""

import json
import os
import shutil
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import rclpy
from rclpy.context import Context
from rclpy.node import Node
from std_msgs.msg import String

from workbook.observing.confine import ABI_OF_SIGNALS, ABI_OF_TCP, landlock_abi
from workbook.observing.process import NodeProcess
from workbook.observing.tiers import Isolation
from workbook.observing.uids import Ids
from workbook.observing.watch import Observer
from workbook.ros.scratch import remove_scratch, scratch_folder

PROBE = Path(__file__).with_name("tier_probe.py")
PATIENCE_S = 30.0
TURN_S = 0.01


def must_not(isolation: Isolation) -> set[str]:
    """What a program must not be able to do in a tier, in the words of the probe."""
    if isolation == "limits":
        return set()
    refused = {
        "reads a file of the grader",
        "changes its own file",
        "has capabilities",
        "can gain capabilities",
    }
    abi = landlock_abi()
    if isolation != "sandbox":  # there, what lies beside it is in memory and goes with it
        refused.add("writes beside its own file")
    if isolation == "uid" or (isolation == "landlock" and abi >= ABI_OF_SIGNALS):
        refused.add("signals the grader")  # in a sandbox the number means another process
    if isolation == "sandbox" or abi >= ABI_OF_TCP:
        refused.add("connects to this machine")
    return refused


def problem_in(isolation: Isolation, found: dict[str, Any], ids: Ids | None) -> str | None:
    """What is wrong with what the probe could do; None when nothing is."""
    wrong = sorted(name for name in must_not(isolation) if found[name])
    if ids is not None and set(found["user"]) | set(found["groups"]) != {ids.user}:
        wrong.append(
            f"runs as user {found['user']} in the groups {found['groups']}, and not as {ids.user} alone"
        )
    return f"it does not isolate here: a program {', '.join(wrong)}" if wrong else None


def try_out(
    isolation: Isolation, observer: Observer, limits: Mapping[str, int], port: int, ids: Ids | None
) -> str | None:
    """Run the probe as `observer` runs answers. Returns what is wrong with the tier, or None.

    `port`: of a listener on the machine.
    """
    folder, secrets = scratch_folder("probe"), scratch_folder("secret")
    secret = secrets / "secret"
    secret.write_text("secret")
    probe = folder / PROBE.name
    shutil.copyfile(PROBE, probe)
    arguments = [str(secret), str(os.getpid()), str(port)]
    context = Context()
    rclpy.init(
        context=context,
        domain_id=observer.domain_id,
        args=["--ros-args", "--disable-external-lib-logs"],
    )
    node = Node("tier_test", context=context, enable_rosout=False, start_parameter_services=False)
    subscription = node.create_subscription(String, "/tier_probe", lambda _: None, 10)
    process = NodeProcess(
        probe,
        observer.domain_id,
        arguments,
        limits=limits,
        cage=observer.cage,
        confinement=observer.confinement,
    )
    try:
        deadline = time.monotonic() + PATIENCE_S
        taken = None
        while taken is None and process.is_running() and time.monotonic() < deadline:
            with subscription.handle:
                taken = subscription.handle.take_message(String, False)
            time.sleep(TURN_S)
    finally:
        process.stop()
        node.destroy_node()
        rclpy.shutdown(context=context)
        remove_scratch(folder)
        remove_scratch(secrets)
        if process.killed:
            observer.move()
    if taken is not None:
        return problem_in(isolation, json.loads(taken[0].data), ids)
    said = process.record().log.strip()
    if said:
        return f"a program does not run there: {said[-300:]}"
    return f"a program runs there, but no message of it arrived within {PATIENCE_S:.0f} s"

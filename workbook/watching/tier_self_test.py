"""Test whether an isolation tier isolates programs on this machine and lets their messages through.

A grading slot runs this test before it judges its first answer. The test runs a program, the *probe*, which tries
everything that's forbidden and publishes the results.
"""

import json
import os
import shutil
import time
from pathlib import Path
from typing import Any

import rclpy
from rclpy.context import Context
from rclpy.node import Node
from std_msgs.msg import String

from workbook.isolation.tiers import Isolation, refuses
from workbook.isolation.user_ids import Ids
from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.recording.limits import Limits
from workbook.ros.scratch import remove_scratch, scratch_folder
from workbook.watching.observer import Observer

PROBE = Path(__file__).parents[1] / "inside" / "tier_probe.py"
PATIENCE_S = 30.0
POLL_S = 0.01


def problem_in(isolation: Isolation, found: dict[str, Any], ids: Ids | None) -> str | None:
    """Return the problem that the probe's results (`found`) show, or None if there is none.

    `ids`: the user ID as which the probe should run, or None for our own.
    """
    wrong = sorted(name for name in refuses(isolation) if found[name])
    if ids is not None and set(found["user"]) | set(found["groups"]) != {ids.user}:
        wrong.append(
            f"runs as user {found['user']} in the groups {found['groups']}, and not as {ids.user} alone"
        )
    return f"it does not isolate here: a program {', '.join(wrong)}" if wrong else None


def try_out(
    isolation: Isolation, observer: Observer, limits: Limits, port: int, ids: Ids | None
) -> str | None:
    """Run the probe as `observer` runs answers. Return the tier's problem, or None if there is none.

    `port`: a TCP port of this machine on which a process listens.
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
    process = NodeProcess(ProgramSpec(probe, arguments, limits=limits), observer.domain_id, observer.tier)
    try:
        deadline = time.monotonic() + PATIENCE_S
        taken = None
        while taken is None and process.is_running() and time.monotonic() < deadline:
            with subscription.handle:
                taken = subscription.handle.take_message(String, False)
            time.sleep(POLL_S)
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

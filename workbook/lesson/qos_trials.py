"""Run experiments for the lesson on QoS: all pairs of profiles, discovery by new publishers, and two domains."""

import os
from collections.abc import Callable, Mapping
from itertools import product
from pathlib import Path
from types import MappingProxyType
from typing import Any

import rclpy
from rclpy.context import Context
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.node import Node
from rclpy.qos import QoSProfile
from std_msgs.msg import String

from workbook.exercise.course import course_folder
from workbook.pictures.figures import figure, still
from workbook.pictures.palette import BLUE, GREEN, RED
from workbook.pictures.stills import Still
from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.ros.domains import lease_domain
from workbook.ros.environment import profile_with_default_times
from workbook.ros.fresh_nodes import fresh
from workbook.ros.session import spin_for

Pair = tuple[str, str]
POLL_S = 0.02
NEWCOMER_S = 30.0
"""The longest wait (s) for a new publisher's program. Even on a busy machine, it starts and gives up within this time.
"""


def try_pairs(profiles: Mapping[str, QoSProfile], new: int = 5) -> dict[Pair, list[str]]:
    """Return the messages that a subscription receives, for every pair of an offered and a requested profile.

    Each publisher sends one "old" message before its subscription exists, and afterward, `new` messages that say "new".
    """
    speaker, listener = fresh(Node, "speaker"), fresh(Node, "listener")
    publishers = []
    heard: dict[Pair, list[str]] = {}
    for number, (offered, requested) in enumerate(product(profiles, profiles)):
        got = heard[offered, requested] = []
        publisher = speaker.create_publisher(
            String,
            f"/pair_{number}",
            profiles[offered],
            event_callbacks=PublisherEventCallbacks(use_default_callbacks=False),
        )
        publisher.publish(String(data="old"))
        publishers.append(publisher)
        _listen(listener, f"/pair_{number}", profiles[requested], got)
    spin_for(speaker, listener, seconds=1.5)
    for publisher in publishers:
        for _ in range(new):
            publisher.publish(String(data="new"))
    spin_for(speaker, listener, seconds=1.5)
    return heard


def _keeper(got: list[str]) -> Callable[[String], None]:
    return lambda message: got.append(message.data)


def _listen(listener: Node, topic: str, qos: QoSProfile, got: list[str]) -> None:
    quiet = SubscriptionEventCallbacks(use_default_callbacks=False)
    listener.create_subscription(String, topic, _keeper(got), qos, event_callbacks=quiet)


def pairs_picture(heard: Mapping[Pair, list[str]], description: str) -> Still:
    """Draw a table of the messages from `try_pairs`: a row per offered profile, a column per requested profile."""
    names = list(dict.fromkeys(offered for offered, _ in heard))
    fig, axes = figure(6.4, 3.8)
    for (offered, requested), messages in heard.items():
        new, old = messages.count("new"), messages.count("old")
        words = f"✓ {new} new" + (f"\n+ {old} old" if old else "") if messages else "✗ nothing"
        at = (names.index(requested), names.index(offered))
        color = GREEN if messages else RED
        axes.text(*at, words, ha="center", va="center", color=color, weight="bold")
    count = len(names)
    axes.set(
        xlim=(-0.5, count - 0.5),
        ylim=(count - 0.5, -0.5),
        xlabel="requested by the subscription",
        ylabel="offered by the publisher",
        title="received: every offer at least as good as the request",
    )
    axes.set_xticks(range(count), names, fontsize=8)
    axes.set_yticks(range(count), names, fontsize=8)
    axes.grid(False)
    return still(fig, description)


def greet(programs: int, listener: str, **parameters: object) -> list[float]:
    """Run new publishers one after another and return the time (ms) that each takes to discover its subscription.

    `programs`: the number of publishers (lesson_nodes.first_words). `listener`: the topic with the subscription.
    `parameters`: the publishers' ROS parameters.
    """
    newcomer = _newcomer(listener, parameters)
    return [_greeted(newcomer, int(os.environ["ROS_DOMAIN_ID"])) for _ in range(programs)]


def greet_by_default(programs: int) -> list[float]:
    """Run new publishers as `greet` does, but with Fast DDS's default settings and on a separate domain.

    The subscriber, lesson_nodes.status_monitor, runs on that domain.
    """
    newcomer = _newcomer("/robot/status")
    with lease_domain() as aside:  # not this notebook's domain, because the notebook would respond quickly
        domain_id = aside.domain_id
        with NodeProcess(
            _lesson_node("status_monitor"), domain_id, write_profile=profile_with_default_times
        ) as monitor:
            while not monitor.log.text():  # the monitor prints a line when it has started
                if monitor.wait(POLL_S):
                    raise RuntimeError("the listener ended right away")
            return [_greeted(newcomer, domain_id, profile_with_default_times) for _ in range(programs)]


def _newcomer(listener: str, parameters: Mapping[str, object] = MappingProxyType({})) -> ProgramSpec:
    to = ("--ros-args", "-r", f"/robot/greeting:={listener}")
    return _lesson_node("first_words", arguments=to, parameters=parameters)


def _lesson_node(name: str, **options: Any) -> ProgramSpec:
    return ProgramSpec(course_folder() / "lesson_nodes" / f"{name}.py", **options)


def _greeted(newcomer: ProgramSpec, domain_id: int, profile: Callable[[Path], Path] | None = None) -> float:
    """Run one new publisher until it exits, and return the time (ms) that it prints. Raise RuntimeError if it fails."""
    with NodeProcess(newcomer, domain_id, write_profile=profile) as process:
        process.wait(NEWCOMER_S)
        ended = process.record()
    if ended.exit != 0:
        raise RuntimeError(f"a newcomer came to no good end:\n{ended.log.strip()}")
    return float(ended.log.splitlines()[-1])


def found_picture(here_ms: list[float], plain_ms: list[float], description: str) -> Still:
    """Draw two histograms, on a shared axis, of the times that new publishers took to find their subscription.

    `here_ms`: the times with this workbook's settings. `plain_ms`: the times with Fast DDS's defaults.
    """
    fig, (upper, lower) = figure(6.4, 3.6, rows=2)
    steps = [
        10 ** (power / 4) for power in range(15)
    ]  # 1 ms to 3 s, each step 1.8 times as long as the previous one
    for axes, title, times in (
        (upper, f"in this workbook: {_slowest(here_ms)}", here_ms),
        (lower, f"with the default settings of Fast DDS: {_slowest(plain_ms)}", plain_ms),
    ):
        axes.hist(times, bins=steps, color=BLUE)
        axes.set(xscale="log", ylabel="newcomers", xlim=(1, 5000))
        axes.set_title(title, fontsize=10)
        axes.set_xticks([1, 10, 100, 1000], ["1 ms", "10 ms", "0.1 s", "1 s"])
        axes.yaxis.get_major_locator().set_params(integer=True)
    lower.set_xlabel("time until the listener was found")
    return still(fig, description)


def _slowest(times: list[float]) -> str:
    return f"the slowest of {len(times)} took {max(times) / 1000:.2g} s"


def heard_between(speaks_on: Any, listens_on: Any, qos: QoSProfile) -> list[str]:
    """Return the messages that a node on one leased domain receives from a node on another within two seconds."""
    left, right = Context(), Context()
    rclpy.init(context=left, domain_id=speaks_on.domain_id)
    rclpy.init(context=right, domain_id=listens_on.domain_id)
    speaker, listener = Node("speaker", context=left), Node("listener", context=right)
    heard: list[str] = []
    publisher = speaker.create_publisher(String, "/robot/status", qos)
    listener.create_subscription(String, "/robot/status", _keeper(heard), qos)
    publisher.publish(String(data="operational"))
    spin_for(listener, seconds=2.0)
    rclpy.shutdown(context=left)
    rclpy.shutdown(context=right)
    return heard

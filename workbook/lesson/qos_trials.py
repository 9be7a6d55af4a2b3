"""Trials for the lesson on QoS: all pairs of profiles, newcomers that greet, and two domains."""

import os
import signal
import subprocess
import sys
from collections.abc import Callable, Mapping
from itertools import product
from typing import Any

import rclpy
from rclpy.context import Context
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.node import Node
from rclpy.qos import QoSProfile
from std_msgs.msg import String

from workbook.pictures.figures import figure, still
from workbook.pictures.palette import BLUE, GREEN, RED
from workbook.pictures.stills import Still
from workbook.ros.domains import lease_domain
from workbook.ros.fresh_nodes import fresh
from workbook.ros.session import spin_for

Pair = tuple[str, str]
PROFILE = "FASTRTPS_DEFAULT_PROFILES_FILE"
_COMMAND = (sys.executable, "-m")


def try_pairs(profiles: Mapping[str, QoSProfile], new: int = 5) -> dict[Pair, list[str]]:
    """What a subscription hears, for every pair of an offered and a requested profile.

    Each publisher sends one "old" message before its subscription exists, and some "new" ones after.
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
    """A table of what was heard: a row for each offer, a column for each request."""
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
        title="heard: every offer at least as good as the request",
    )
    axes.set_xticks(range(count), names, fontsize=8)
    axes.set_yticks(range(count), names, fontsize=8)
    axes.grid(False)
    return still(fig, description)


def greet(programs: int, listener: str, **parameters: object) -> list[float]:
    """Run newcomers (lesson_nodes.first_words), one after another; how long (ms) each took to find the listener."""
    return _greet(programs, listener, dict(os.environ), parameters)


def greet_without_profile(programs: int) -> list[float]:
    """Newcomers and a listener with the settings that Fast DDS comes with, on a domain of their own: times (ms)."""
    plain = {name: value for name, value in os.environ.items() if name != PROFILE}
    with lease_domain() as aside:  # a domain without this notebook, which would answer quickly
        plain |= {"ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST", "ROS_DOMAIN_ID": str(aside.domain_id)}
        with subprocess.Popen(
            [*_COMMAND, "lesson_nodes.status_monitor"],
            env=plain,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        ) as monitor:
            try:
                assert monitor.stderr is not None
                monitor.stderr.readline()  # it says that it has started
                return _greet(programs, "/robot/status", plain, {})
            finally:
                monitor.send_signal(signal.SIGINT)


def _greet(
    programs: int, listener: str, environment: Mapping[str, str], parameters: Mapping[str, object]
) -> list[float]:
    options = [item for name, value in parameters.items() for item in ("-p", f"{name}:={value}")]
    command = [*_COMMAND, "lesson_nodes.first_words", "--ros-args", "-r", f"/robot/greeting:={listener}"]
    found_ms = []
    for _ in range(programs):
        newcomer = subprocess.run(
            [*command, *options], env=dict(environment), capture_output=True, text=True, check=True
        )
        found_ms.append(float(newcomer.stdout))
    return found_ms


def found_picture(here_ms: list[float], plain_ms: list[float], description: str) -> Still:
    """How long newcomers took to find their listener, as two histograms over one axis."""
    fig, (upper, lower) = figure(6.4, 3.6, rows=2)
    steps = [
        10 ** (power / 4) for power in range(15)
    ]  # 1 ms to 3 s, each 1.8 times as long as the one before
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
    """What a node on one leased domain hears of a node on another, within two seconds."""
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

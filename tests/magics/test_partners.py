"""What %start runs next to a program: the solution's messages move the robot, and no partner outlives the program.

The news of the panel's observer is what a browser receives.
"""

import os
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.magics.conftest import Kernel
from tests.programs.support import is_gone, wait_until
from tests.ros.panel_watcher import Watcher
from workbook.exercise.source import load, partner_of, stems
from workbook.inside.proc import process_tree

ROOT = Path(__file__).resolve().parents[2]
STEMS = stems(ROOT / "solutions")
GUARD, MONITOR = "01_the_context", "04_subscriptions_and_callbacks"

MOVES = {
    "01_the_context": {"walk"},
    "02_nodes": {"look"},
    "03_publishers_and_messages": {"battery"},
    "04_subscriptions_and_callbacks": {"battery", "alert"},
    "05_timers": {"beat", "battery", "tilt"},
    "06_spinning": {"beat", "look"},
    "07_typed_nodes": {"face", "battery"},
    "08_humanoid_status_publisher": {"face", "battery"},
    "09_joint_positions": {"pose", "face", "battery"},
    "10_slow_callbacks": {"beat", "thought"},
    "11_polling_against_callbacks": {"touch"},
    "12_services": {"pose", "beat", "face", "nod", "shake"},
    "13_qos_and_discovery": {"beat", "face", "alarm"},
    "14_arrays_and_filters": {"raw", "pose"},
    "15_camera": {"image", "look"},
    "16_ai_model": {"image", "boxes", "tilt", "face"},
}
"""What the robot does in each exercise while its solution runs."""


@pytest.fixture
def watcher(kernel: Kernel) -> Iterator[Watcher]:
    """Start an observer of the kernel's domain."""
    one = Watcher()
    one.order(domain=int(kernel.good("import os; print(os.environ['ROS_DOMAIN_ID'])").text))
    one.wait("graph")
    try:
        yield one
    finally:
        kernel.good("%stop")
        one.close()


def answer(kernel: Kernel, stem: str, text: str = "") -> None:
    source = load(ROOT / "solutions" / f"{stem}.py")
    kernel.good(f"%%answer {stem}\n{text or source.solution_code}")


def reported(watcher: Watcher, effect: str) -> list[Any]:
    """Return the values of an effect that were reported so far, without the ends of effects."""
    values = (one[effect] for one in list(watcher.told) if one["kind"] == "robot" and effect in one)
    return [value for value in values if value is not None and value is not False]


def wait_for(watcher: Watcher, *effects: str, fits: Callable[[Any], bool] = lambda value: True) -> None:
    """Wait until each of the effects was reported with a matching value."""
    watcher.wait("robot", lambda _: all(any(map(fits, reported(watcher, effect))) for effect in effects))


def below(kernel: Kernel, stem: str) -> set[int]:
    """Return the processes of a program and of its partner."""
    files = (f"answers/{stem}.py", f"partners/{stem}.py")

    def runs_one(pid: int) -> bool:
        try:
            command = Path(f"/proc/{pid}/cmdline").read_text(encoding="utf-8", errors="replace")
        except OSError:
            return False
        return any(file in command for file in files)

    return {pid for pid in process_tree(kernel.pid) if runs_one(pid)}


def test_each_exercise_has_its_moves() -> None:
    assert tuple(MOVES) == STEMS


@pytest.mark.slow
@pytest.mark.whole
@pytest.mark.parametrize("stem", STEMS)
def test_the_robot_does_what_the_solution_publishes(kernel: Kernel, watcher: Watcher, stem: str) -> None:
    answer(kernel, stem)
    # Exercise 03's program publishes only when its notebook's desk requests it.
    code = load(ROOT / "solutions" / f"{stem}.py").live if stem.startswith("03") else "%start"
    said = kernel.good(code).text
    assert "Running: node" in said
    has_partner = partner_of(ROOT / "solutions" / f"{stem}.py") is not None
    assert ("The rest of the robot runs with it: node /" in said) == has_partner
    wait_for(watcher, *MOVES[stem])


def test_the_guard_parks_its_arms_if_its_program_says_so(kernel: Kernel, watcher: Watcher) -> None:
    parks = load(ROOT / "solutions" / f"{GUARD}.py").solution_code
    for program, folded in ((parks, True), (parks.replace("guard.park()", "pass"), False)):
        answer(kernel, GUARD, program)
        kernel.good("%start")
        watcher.told.clear()
        wait_for(watcher, "walk", fits=lambda speed: speed[0] > 0)
        assert kernel.good("%stop").text == f"Stopped {GUARD}.\n"
        wait_for(watcher, "pose")
        elbow = reported(watcher, "pose")[-1][3]
        assert (elbow < -1.0) is folded, "folded arms have bent elbows, and a frozen robot has its arms up"


def test_only_the_monitor_moves_the_gauge(kernel: Kernel, watcher: Watcher) -> None:
    answer(kernel, MONITOR)
    kernel.good("%start")
    wait_for(watcher, "alert")
    watcher.told.clear()
    wait_for(watcher, "alert")
    assert all(0.0 <= charge <= 100.0 for charge in reported(watcher, "battery"))


@pytest.mark.slow
@pytest.mark.whole
def test_in_the_end_the_robot_of_16_lies_on_the_ground_and_reports_it(
    kernel: Kernel, watcher: Watcher
) -> None:
    answer(kernel, "16_ai_model")
    kernel.good("%start")
    wait_for(watcher, "tilt", fits=lambda angle: 1.2 < angle < 1.5)  # a push
    wait_for(watcher, "face", fits=lambda face: face == "error")
    assert reported(watcher, "face")[0] == "operational"
    wait_for(watcher, "boxes", fits=lambda boxes: {label for label, *_ in boxes} >= {"ball", "cup", "plate"})


def test_the_other_who_publishes_has_the_topic_alone(kernel: Kernel, watcher: Watcher) -> None:
    """The exercise's cell replaces the simulated sensor, and lets it publish again at the end."""
    answer(kernel, MONITOR)
    said = kernel.good(load(ROOT / "solutions" / f"{MONITOR}.py").live).text
    rows = re.findall(r"^/robot/battery +(\S+) +(.*)$", said, re.MULTILINE)
    assert [(reading, words.split()[-1].rstrip('"')) for reading, words in rows] == [
        ("64", "64"), ("63.5", "63.5"), ("-3", "-3.0"), ("63", "63"), ("62.5", "62.5")
    ]  # fmt: skip
    watcher.told.clear()
    wait_for(watcher, "battery", fits=lambda charge: charge > 90)


@pytest.mark.parametrize("by", ["%stop", "%start", "itself"])
def test_a_partner_ends_with_its_program(kernel: Kernel, watcher: Watcher, by: str) -> None:
    program = load(ROOT / "solutions" / f"{MONITOR}.py").solution_code
    ends = "import threading, os\nthreading.Timer(4.0, lambda: os._exit(0)).start()\n"
    answer(kernel, MONITOR, f"{ends}{program}" if by == "itself" else program)
    kernel.good("%start")
    both = below(kernel, MONITOR)
    assert len(both) == 2
    if by != "itself":
        kernel.good(by)
        assert all(map(is_gone, both))
    wait_until(lambda: all(map(is_gone, both)))
    assert len(below(kernel, MONITOR)) == (2 if by == "%start" else 0)


def test_a_partner_ends_if_its_program_was_never_started(kernel: Kernel, watcher: Watcher) -> None:
    answer(kernel, MONITOR)
    kernel.good(
        "from workbook.magics.running import Running\n"
        "kept = Running.start\n"
        "def interrupted(*arguments): raise KeyboardInterrupt\n"
        "Running.start = interrupted"
    )
    try:
        assert "KeyboardInterrupt" in (kernel.run("%start").error or "")
        assert len(below(kernel, MONITOR)) == 1
        assert kernel.good("%stop").text == "Nothing was running.\n"
    finally:
        kernel.good("Running.start = kept")
    assert not below(kernel, MONITOR)


@pytest.mark.parametrize("hard", [False, True], ids=["shut down", "killed"])
def test_a_partner_ends_with_the_kernel(fresh_kernel: Kernel, hard: bool) -> None:
    answer(fresh_kernel, MONITOR)
    fresh_kernel.good("%start")
    both = below(fresh_kernel, MONITOR)
    assert len(both) == 2
    if hard:
        os.kill(fresh_kernel.pid, 9)
    else:
        fresh_kernel.shut_down()
    wait_until(lambda: all(map(is_gone, both)))


def test_a_partner_that_cannot_start_says_so(kernel: Kernel, watcher: Watcher, tmp_path: Path) -> None:
    answer(kernel, MONITOR)
    broken = tmp_path / "broken.py"
    broken.write_text("raise RuntimeError('the cable is cut')\n", encoding="utf-8")
    kernel.good(
        "from workbook.magics import extension\n"
        "kept = extension.partner_of\n"
        f"extension.partner_of = lambda path: __import__('pathlib').Path({str(broken)!r})"
    )
    try:
        said = kernel.good("%start").text
    finally:
        kernel.good("extension.partner_of = kept")
    assert "The rest of the robot did not start.\n" in said and "RuntimeError: the cable is cut" in said
    assert "Running: node /battery_monitor" in said and "runs with it" not in said

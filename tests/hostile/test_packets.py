"""An answer's packets that would keep DDS, and so the judge, busy forever: GAP and HEARTBEAT over 2^61 messages.

All of them go to the loopback of the slot's private network.
"""

import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.programs.support import wait_until
from workbook.exercise.answers import Answer
from workbook.exercise.definition import load_exercise
from workbook.grading.judges import Job
from workbook.grading.slots import health as slot_health
from workbook.grading.slots.client import Slot, SlotBroken
from workbook.grading.slots.health import SlotHealth
from workbook.grading.slots.pool import STOPPED_JUDGE, Kind, judge_warm, warm_slots
from workbook.isolation.bubblewrap import sandbox_problem

pytestmark = [pytest.mark.sandbox, pytest.mark.slow, pytest.mark.whole]
ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
SPEAKS_FOR_DDS = """
import socket
import struct
import threading
import time

import rclpy.node

_create = rclpy.node.Node.create_publisher


def create_publisher(self, kind, name, *arguments, **options):
    publisher = _create(self, kind, name, *arguments, **options)
    if name.endswith("joint_positions"):
        threading.Thread(target=send, args=(self, publisher), daemon=True).start()
    return publisher


def send(node, publisher):
    while publisher.get_subscription_count() == 0:
        time.sleep(0.05)
    [info] = node.get_publishers_info_by_topic("/robot/joint_positions")
    gid = bytes(info.endpoint_gid)
    to_all, first, last = bytes(4) + gid[12:16], (0, 2), (1 << 29, 0)
    gap = to_all + struct.pack("<iIiII", *first, *last, 0)
    heartbeat = to_all + struct.pack("<iIiIi", *last, *last, 1000)
    kind, body = {"gap": (8, gap), "heartbeat": (7, heartbeat)}["@@KIND@@"]
    packet = b"RTPS\\x02\\x03\\x01\\x0f" + gid[:12] + bytes((kind, 1)) + struct.pack("<H", len(body)) + body
    out = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    while True:
        lines = open("/proc/net/udp").readlines()[1:]
        for port in {int(line.split()[1].rsplit(":", 1)[1], 16) for line in lines}:
            if 7400 <= port < 33000:
                try:
                    out.sendto(packet, ("127.0.0.1", port))
                except OSError:
                    pass
        time.sleep(0.2)


rclpy.node.Node.create_publisher = create_publisher
"""


@pytest.fixture(scope="module", autouse=True)
def _needs_a_sandbox() -> None:
    problem = sandbox_problem()
    if problem is not None:
        pytest.skip(f"programs cannot be sandboxed: {problem}")


@pytest.mark.parametrize("kind", ["gap", "heartbeat"])
def test_packets_over_all_messages_that_there_can_be_stop_no_grader(
    kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The judge doesn't wait until the answer's deadline, because it notices that the slot stands still."""
    monkeypatch.setattr(slot_health, "STUCK_S", 1.0)
    solution = load_exercise(STEM, ROOT).source.solution_code
    hostile = Answer(SPEAKS_FOR_DDS.replace("@@KIND@@", kind) + solution)
    judgement = judge_warm(warm_slots, Kind("sandbox"), Job(kind, STEM, hostile), soak=False)
    assert judgement.status in ("graded", "ungradable"), judgement.reason
    assert judgement.score is None or judgement.score < 10.0
    if judgement.status == "ungradable":
        reason = judgement.reason or ""
        assert reason.startswith(f"{STOPPED_JUDGE}: the slot ") and "in time" not in reason


WORKS = "import threading\ndef work():\n    while True: pass\nthreading.Thread(target=work, daemon=True).start()\n"


@pytest.mark.parametrize(
    ("program", "is_stuck"),
    [
        (f"{WORKS}lock = threading.Lock(); lock.acquire(); lock.acquire()", True),
        (f"{WORKS}while True: threading.Event().wait(0.05)", False),
        ("import threading\nlock = threading.Lock(); lock.acquire(); lock.acquire()", False),
    ],
    ids=["waits for those at work", "waits again and again", "waits where nobody works"],
)
def test_a_slot_is_given_up_once_it_waits_for_those_at_work(
    program: str, is_stuck: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(slot_health, "STUCK_S", 0.4)
    with subprocess.Popen([sys.executable, "-c", program]) as process:
        try:
            health = SlotHealth(process.pid, ("-c",))
            if is_stuck:
                told = "the slot made no more progress"
                wait_until(lambda: health.problem() == told, "it is seen to stand still")
            else:
                over = time.monotonic() + 1.2
                while time.monotonic() < over:
                    assert health.problem() is None
                    time.sleep(0.1)
        finally:
            process.kill()


def test_a_slot_is_given_up_once_it_takes_too_much_memory(monkeypatch: pytest.MonkeyPatch) -> None:
    """Only the memory of the judging process counts, in any tier, not that of the judged program."""
    waits = Answer("import threading\nthreading.Event().wait(60)\n")
    with Slot("sandbox") as slot:
        monkeypatch.setattr(slot_health, "SLOT_BYTES", 1)
        with pytest.raises(SlotBroken, match="too much memory"):
            slot.judge(STEM, waits, soak=False)
        slot.kill()

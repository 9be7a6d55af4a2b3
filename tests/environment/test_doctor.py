"""`workbook doctor`: the problems it finds, and its advice for each."""

import io
import socket
from pathlib import Path
from typing import Any, BinaryIO

import pytest
from jupyter_client import manager

from workbook.cli import doctor
from workbook.lab import health
from workbook.lab.health import HealthFinding


def test_two_processes_talk() -> None:
    finding = health.check_two_processes()
    assert finding.status == "ok", finding
    assert "was discovered after" in finding.saw


def test_a_silent_second_process_is_told_with_what_it_said(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    program = tmp_path / "mute.py"
    program.write_text("raise RuntimeError('no voice today')\n")
    monkeypatch.setattr(health, "PING_PUBLISHER", program)
    finding = health.check_two_processes()
    assert finding.status == "fix"
    assert "ended by itself (exit 1)" in finding.saw
    assert "no voice today" in finding.saw
    assert finding.todo


def test_a_kernel_starts_and_leaves_nothing_behind(temporary: Path) -> None:
    finding = health.check_kernel()
    assert (finding.status, "the magics" in finding.saw) == ("ok", True)
    assert list(temporary.iterdir()) == []


@pytest.mark.parametrize(("faults", "status"), [(2, "ok"), (3, "fix")])
def test_a_kernel_whose_port_was_taken_is_started_again(
    faults: int, status: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    start_new_kernel = manager.start_new_kernel
    started: list[int] = []

    def start(*, stderr: BinaryIO, **options: Any) -> Any:
        started.append(0)
        if len(started) > faults:
            return start_new_kernel(stderr=stderr, **options)
        stderr.write(b"zmq.error.ZMQError: Address already in use (addr='tcp://127.0.0.1:41333')\n")
        raise RuntimeError("Kernel died before replying to kernel_info")

    monkeypatch.setattr(manager, "start_new_kernel", start)
    [finding] = health._made("Jupyter kernel", health.check_kernel)
    assert (len(started), finding.status) == (3, status)
    assert ("41333" in finding.saw) == (status == "fix")


def test_the_last_words_of_a_kernel_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    def start(*, stderr: BinaryIO, **_: Any) -> None:
        stderr.write(b"Traceback\nImportError: no such library\n")
        raise RuntimeError("Kernel died before replying to kernel_info")

    monkeypatch.setattr(manager, "start_new_kernel", start)
    with pytest.raises(RuntimeError, match="no such library"):
        health.check_kernel()


def test_the_rest_of_this_machine() -> None:
    assert health.check_loopback().status == "ok"
    assert health.check_domain().status == "ok"
    assert health.check_python().status == "ok"
    assert health.check_folders().status == "ok"
    rclpy = health.check_rclpy()
    assert (rclpy.status, "rmw_fastrtps_cpp" in rclpy.saw) == ("ok", True)


def test_a_lost_packet_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    class Filtered(socket.socket):
        def recv(self, *_: object) -> bytes:
            raise TimeoutError

    monkeypatch.setattr(socket, "socket", Filtered)
    finding = health.check_loopback()
    assert finding.status == "fix"
    assert "firewall" in finding.todo


def test_leftovers_of_a_sourced_ros_are_named() -> None:
    found = health.leftovers({"HOME": "/home/ada", "RMW_IMPLEMENTATION": "x", "PYTHONPATH": "/opt/ros"})
    assert found == ["PYTHONPATH", "RMW_IMPLEMENTATION"]
    assert health.check_leftovers(found).status == "note"
    assert "RMW_IMPLEMENTATION" in health.check_leftovers(found).saw
    assert health.check_leftovers([]).status == "ok"


def test_another_source_of_ros_is_named_with_what_differs_there(tmp_path: Path) -> None:
    apt = health.check_route(Path("/opt/ros/jazzy/lib/python3.12/site-packages/rclpy"), "Linux")
    assert apt.status == "note" and "/opt/ros/jazzy" in apt.saw
    assert "wrong type" in apt.todo and "%check" not in apt.todo
    (tmp_path / "conda-meta").mkdir()
    conda = health.check_route(tmp_path / "lib" / "python3.12" / "site-packages" / "rclpy", "Darwin")
    assert "RoboStack" in conda.saw
    assert "On Darwin" in conda.todo and "%check and grading don't" in conda.todo


def test_a_home_that_cannot_be_written(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HOME", "/proc")
    finding = health.check_folders()
    assert finding.status == "fix"
    assert "Set HOME" in finding.todo


def test_a_check_that_raises_becomes_a_finding() -> None:
    def fails() -> HealthFinding:
        raise OSError("the cable is out\nsecond line")

    (finding,) = health._made("Cable", fails)
    assert (finding.status, finding.title) == ("fix", "Cable")
    assert "the cable is out" in finding.saw
    assert "second line" not in finding.saw


@pytest.mark.parametrize(
    ("findings", "code", "last"),
    [
        ([HealthFinding("ok", "A", "fine"), HealthFinding("note", "B", "odd", "look")], 0, "Ready."),
        (
            [HealthFinding("fix", "A", "broken", "Run `make env`."), HealthFinding("ok", "B", "fine")],
            1,
            "1 to fix.",
        ),
    ],
)
def test_exit_code_and_summary(
    findings: list[HealthFinding],
    code: int,
    last: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(health, "examine", lambda: iter(findings))
    from workbook.cli.main import main

    assert main(["doctor"]) == code
    lines = capsys.readouterr().out.strip().splitlines()
    assert lines[-1].startswith(last)
    for finding in findings:
        assert any(finding.title in line and finding.saw in line and finding.status in line for line in lines)
        assert not finding.todo or any(finding.todo in line for line in lines)


def test_a_terminal_without_unicode_gets_plain_signs() -> None:
    stream = io.TextIOWrapper(io.BytesIO(), encoding="ascii")
    text = doctor.line(HealthFinding("fix", "RMW", "missing", "install it"), stream)
    text.encode("ascii")
    assert "x fix" in text
    assert "> install it" in text

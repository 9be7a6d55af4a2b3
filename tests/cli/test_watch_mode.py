"""`workbook check --watch` judges again at each save, on one screen, and leaves nothing behind."""

import fcntl
import os
import pty
import select
import signal
import struct
import subprocess
import sys
import termios
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tests.cli.conftest import ROOT
from workbook.cli.watch.screen import fitted
from workbook.inside.proc import pids, process_tree

STEM = "09_joint_positions"
SOLUTION = (ROOT / "solutions" / f"{STEM}.py").read_text(encoding="utf-8")
WRONG_NAME = SOLUTION.replace('"/robot/joint_positions"', '"/robot/joints"')
LIMIT_S = 120.0
ROWS, COLUMNS = 24, 80
CLEAR = "\x1b[H\x1b[2J\x1b[3J"


def heed_ctrl_c() -> None:
    """In the child, handle Ctrl-C before it becomes the command, even if the tests run in the background."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def in_a_terminal() -> None:
    """In the child, make the terminal on its input its controlling terminal."""
    heed_ctrl_c()
    fcntl.ioctl(0, termios.TIOCSCTTY, 0)


class Watching:
    """A running `workbook check --watch` in a separate terminal."""

    def __init__(self, file: Path, *more: str) -> None:
        self.ours, theirs = pty.openpty()
        fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", ROWS, COLUMNS, 0, 0))
        command = [sys.executable, "-m", "workbook.cli.main", "check", "09", *more, "--watch"]
        environ = {name: value for name, value in os.environ.items() if name not in ("COLUMNS", "LINES")}
        self.process = subprocess.Popen(
            command,
            stdin=theirs,
            stdout=theirs,
            stderr=theirs,
            env=environ | {"NO_COLOR": "1"},
            cwd=file.parent,
            start_new_session=True,
            preexec_fn=in_a_terminal,
        )
        os.close(theirs)
        self.file = file
        self.seen = ""

    def save(self, text: str) -> None:
        """Save as editors do: a new file replaces the old one."""
        partial = self.file.with_suffix(".part")
        partial.write_text(text)
        partial.replace(self.file)

    def press(self, key: str) -> None:
        os.write(self.ours, key.encode())

    def screen_with(self, *words: str) -> str:
        """Wait for a screen that contains all these words. Return its text from the first line on."""
        deadline = time.monotonic() + LIMIT_S
        while True:
            screen = self.seen.rpartition(CLEAR)[2].replace("\r\n", "\n")
            if all(word in screen for word in words):
                self.seen = ""
                return screen
            assert time.monotonic() < deadline, screen
            if select.select([self.ours], [], [], 1.0)[0]:
                self.seen += os.read(self.ours, 1 << 16).decode()

    def wait_for_another_than(self, known: list[int]) -> None:
        """Wait for a process that isn't among these: an answer that runs."""
        deadline = time.monotonic() + LIMIT_S
        while not set(process_tree(self.process.pid)) - set(known):
            assert time.monotonic() < deadline
            time.sleep(0.01)

    def end(self) -> int:
        """Wait until it ends, and check that it leaves nothing behind."""
        family = process_tree(self.process.pid)
        self.press("\x03")
        code = self.process.wait(LIMIT_S)
        deadline = time.monotonic() + LIMIT_S
        while left := set(family) & set(pids()):
            assert time.monotonic() < deadline, left
            time.sleep(0.01)
        return code


@pytest.fixture
def watch(tmp_path: Path) -> Iterator[Callable[..., Watching]]:
    started: list[Watching] = []

    def start(text: str, *more: str) -> Watching:
        file = tmp_path / f"{STEM}.py"
        file.write_text(text)
        started.append(Watching(file, str(file), *more))
        return started[-1]

    yield start
    for one in started:
        if one.process.poll() is None:
            os.killpg(one.process.pid, signal.SIGKILL)
            one.process.wait()
        os.close(one.ours)


def test_each_save_is_judged_in_the_same_slot_on_one_screen(watch: Callable[..., Watching]) -> None:
    watching = watch(WRONG_NAME)
    first = watching.screen_with("points.", "Keys: h hint")
    assert "/robot/joints" in first
    slot = process_tree(watching.process.pid)[1]
    watching.save(SOLUTION)
    second = watching.screen_with("Full marks", "Hand in this file", "Keys: h hint")
    assert "more than before this save" in second
    watching.save("this is no Python\n")
    third = watching.screen_with("SyntaxError", "fewer than before this save", "Keys: h hint")
    for screen in (first, second, third):
        assert len(screen.rstrip("\n").split("\n")) < ROWS
        assert max(map(len, screen.split("\n"))) <= COLUMNS
    assert process_tree(watching.process.pid)[1] == slot, "it stayed warm"
    watching.press("c")
    watching.screen_with("SyntaxError", "Keys: h hint")
    assert watching.end() == 1
    assert "Stopped watching." in watching.screen_with("Stopped watching.")


def test_it_shows_how_far_a_judgement_is(watch: Callable[..., Watching]) -> None:
    watching = watch(SOLUTION, "--as-graded")
    watching.screen_with("Still watching your program ...", " s, ", " on /robot/battery")
    watching.end()


def test_ctrl_c_ends_an_answer_under_way(watch: Callable[..., Watching]) -> None:
    watching = watch(SOLUTION)
    watching.screen_with("Full marks", "Keys: h hint")
    idle = process_tree(watching.process.pid)
    watching.save("import time\ntime.sleep(1000)\n")
    watching.wait_for_another_than(idle)
    watching.end()
    watching.screen_with("Stopped watching.")


def test_a_missing_or_empty_file_is_waited_for(watch: Callable[..., Watching]) -> None:
    watching = watch("")
    watching.screen_with("the answer is empty", "Keys: h hint")
    watching.file.unlink()
    watching.press("c")
    watching.screen_with("there is no file", "Keys: h hint")
    watching.save(SOLUTION)
    watching.screen_with("Full marks", "Keys: h hint")
    watching.press("q")
    assert watching.process.wait(LIMIT_S) == 0


def test_the_first_start_writes_the_starter_and_hints_count(course: Path) -> None:
    """It starts in the course's folder, without an answer. Pressing `h` shows a hint instead of the verdict."""
    watching = Watching(course / "none.py")
    try:
        watching.screen_with("points.", "work/answers/09_joint_positions.py", "Keys: h hint")
        written = course / "work" / "answers" / f"{STEM}.py"
        assert "TODO" in written.read_text()
        watching.press("h")
        watching.screen_with("Hint 1 of 3, a nudge", "Keys: h hint")
        watching.end()
    finally:
        if watching.process.poll() is None:
            os.killpg(watching.process.pid, signal.SIGKILL)
            watching.process.wait()
        os.close(watching.ours)


def test_without_a_terminal_verdicts_follow_one_another(tmp_path: Path) -> None:
    file = tmp_path / f"{STEM}.py"
    file.write_text("this is no Python\n")
    command = [sys.executable, "-m", "workbook.cli.main", "check", "09", str(file), "--watch"]
    process = subprocess.Popen(
        command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True, preexec_fn=heed_ctrl_c
    )
    assert process.stdout is not None
    said = ""
    while "Press Ctrl-C to stop." not in said:
        said += process.stdout.readline()
    process.send_signal(signal.SIGINT)
    said += process.stdout.read()
    assert process.wait(LIMIT_S) == 1
    process.stdout.close()
    assert "SyntaxError" in said
    assert "\x1b" not in said
    assert "Keys:" not in said


def test_a_long_text_leaves_room_for_the_notes() -> None:
    text = "\n".join(str(number) for number in range(10))
    assert fitted(text, 10) == text
    assert fitted(text, 4) == "0\n1\n2\n  … and 7 more lines"

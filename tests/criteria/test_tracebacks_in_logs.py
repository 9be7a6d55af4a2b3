"""Tracebacks of every kind: the first exception is the cause, whatever its name and the order of the threads."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbook.criteria.vocabulary.known_errors import find_error
from workbook.criteria.vocabulary.tracebacks import TRACEBACK, chains_in


def block(line: int, source: str, error: str) -> str:
    return f'{TRACEBACK}:\n  File "/a/answer.py", line {line}, in go\n    {source}\n{error}\n'


CHAIN = "\nDuring handling of the above exception, another exception occurred:\n\n"
DIRECT = "\nThe above exception was the direct cause of the following exception:\n\n"


def thread(name: str, line: int, source: str, error: str) -> list[str]:
    return [
        f"Exception in thread {name} ({name}_work):\n",
        f"{TRACEBACK}:\n",
        '  File "/usr/lib/threading.py", line 1045, in _bootstrap_inner\n    self.run()\n',
        '  File "/usr/lib/threading.py", line 982, in run\n    self._target()\n',
        f'  File "/a/answer.py", line {line}, in {name}_work\n    {source}\n',
        f"{error}\n",
    ]


ONE = thread("One", 12, 'found["joint"]', "KeyError: 'joint'")
TWO = thread("Two", 31, "elbow.bend()", "NameError: name 'elbow' is not defined")


@pytest.mark.parametrize("joint", [CHAIN, DIRECT])
def test_the_first_of_a_chain_is_the_cause(joint: str) -> None:
    log = (
        block(3, "make()", "ValueError: first") + joint + block(9, "node.stop()", "NameError: name 'node' is")
    )
    found = find_error(log, "answer.py")
    assert found is not None and (found.error, found.line) == ("ValueError: first", 3)


@pytest.mark.parametrize(
    "expected", ["KeyboardInterrupt", "rclpy.executors.ExternalShutdownException", "_queue.Empty"]
)
def test_an_exception_that_the_program_waits_for_is_no_cause(expected: str) -> None:
    log = (
        block(3, "spin()", expected)
        + CHAIN
        + block(9, "node.stop()", "NameError: name 'node' is not defined")
    )
    found = find_error(log, "answer.py")
    assert found is not None and (found.cause, found.line) == ("error.name-not-defined", 9)


def test_what_a_library_caught_itself_is_no_cause() -> None:
    library = block(3, "table[key]", "KeyError: 'x'").replace("/a/answer.py", "/lib/enum.py")
    found = find_error(library + CHAIN + block(9, "Kind.x", "ValueError: no kind"), "answer.py")
    assert found is not None and (found.error, found.line) == ("ValueError: no kind", 9)


@pytest.mark.parametrize(
    "error",
    [
        "cv2.error: OpenCV(4.9.0) bad",
        "termios.error: (25, 'no tty')",
        "Kaputt",
        "ошибка: нет",
        "a.b.oops: x",
        "socket.gaierror: [1]",
    ],
)
def test_an_exception_of_any_name_is_seen(error: str) -> None:
    found = find_error(f"[INFO] [a]: hello\n{block(7, 'go()', error)}[INFO] [a]: bye\n", "answer.py")
    assert found is not None and (found.error, found.line) == (error, 7)


def test_a_word_printed_into_a_traceback_is_no_error() -> None:
    whole = block(7, "go()", "ValueError: x").splitlines(keepends=True)
    log = "".join([*whole[:1], *whole[1:3], "hello\n", *whole[1:]]).replace("line 7", "line 8", 1)
    found = find_error(log, "answer.py")
    assert found is not None and (found.error, found.line) == ("ValueError: x", 7)


def test_the_first_of_a_group_stands_for_it() -> None:
    group = (
        f"  + Exception Group {TRACEBACK}:\n"
        '  |   File "/a/answer.py", line 2, in <module>\n  |     raise group\n'
        "  | ExceptionGroup: several (2 sub-exceptions)\n"
        "  +-+---------------- 1 ----------------\n"
        f'    | {TRACEBACK}:\n    |   File "/a/answer.py", line 5, in <module>\n    |     1 / 0\n'
        "    | ZeroDivisionError: division by zero\n"
        "    +---------------- 2 ----------------\n"
        "    | ValueError: second\n"
        "    +------------------------------------\n"
    )
    found = find_error(group, "answer.py")
    assert found is not None and (found.error, found.line) == ("ZeroDivisionError: division by zero", 5)


@st.composite
def mixed(draw: st.DrawFn) -> str:
    left, right = list(ONE), list(TWO)
    lines = []
    while left or right:
        source = draw(st.sampled_from([one for one in (left, right) if one]))
        lines.append(source.pop(0))
    return "".join(lines)


@given(mixed())
def test_two_threads_in_any_order_have_the_same_cause(log: str) -> None:
    found = find_error(log, "answer.py")
    assert found is not None and (found.error, found.line) == ("KeyError: 'joint'", 12), log


@given(st.permutations(["".join(ONE), "".join(TWO), block(90, "join()", "OSError: gone")]))
def test_the_main_program_comes_before_threads(parts: list[str]) -> None:
    found = find_error("".join(parts), "answer.py")
    assert found is not None and (found.error, found.line) == ("OSError: gone", 90)


@pytest.mark.parametrize(
    "head", ["Exception ignored in: <function A.__del__ at 0x1>", "Exception ignored in atexit callback: <f>"]
)
def test_what_python_ignores_comes_last(head: str) -> None:
    ignored = f"{head}\n{block(50, 'park()', 'ValueError: late')}"
    found = find_error(block(4, "go()", "OSError: gone") + ignored, "answer.py")
    assert found is not None and found.line == 4
    alone = find_error(ignored, "answer.py")
    assert alone is not None and alone.line == 50


def test_what_comes_after_a_traceback_is_not_part_of_its_message() -> None:
    log = (
        "Traceback (most recent call last):\n"
        '  File "/answer/answer.py", line 3, in <module>\n'
        '    raise ValueError("out of reach")\n'
        "ValueError: out of reach\n"
        "two lines long\n"
        "Still running: ThreadPoolExecutor-0_0\n"
        "The following exception was never retrieved: Failed to publish: publisher's context is invalid\n"
    )
    [[raised]] = chains_in(log)
    assert raised.notes == ["two lines long"]

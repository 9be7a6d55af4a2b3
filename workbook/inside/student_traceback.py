"""Print exceptions as a student would see them without the host, that is, without our stack frames.

Each exception is printed in a single write. Otherwise, if two threads failed at the same time, their lines would be
mixed.
"""

import os
import sys
import threading
import time
import traceback
from collections.abc import Callable, Iterator
from types import FrameType

from workbook.inside.field_values import note_of
from workbook.inside.missing_names import note_of_name

FOLDER = os.path.dirname(os.path.abspath(__file__))
PATIENCE_WITH_THREADS_S = 1.0
LOOK_EVERY_S = 0.02
STILL_RUNNING = "Still running:"
"""The beginning of the line about each thread that keeps a program from exiting."""


def shown(error: BaseException, ends_with_host: Callable[[traceback.FrameSummary], bool]) -> str:
    """Format an exception's traceback with its causes, but without frames from files in this folder.

    `ends_with_host`: a function that returns whether a frame is the one that imported the answer. That frame and the
    frames before it are left out, too.
    """
    for raised in _chained(error):
        note = note_of(raised) or note_of_name(raised)
        if note and note not in getattr(raised, "__notes__", ()):
            raised.add_note(note)
    told = traceback.TracebackException.from_exception(error)
    waiting, seen = [told], set[int]()
    while waiting:
        one = waiting.pop()
        if id(one) in seen:
            continue
        seen.add(id(one))
        frames = list(one.stack)
        start = max((place for place, frame in enumerate(frames, 1) if ends_with_host(frame)), default=0)
        one.stack = traceback.StackSummary.from_list(
            [frame for frame in frames[start:] if os.path.dirname(frame.filename) != FOLDER]
        )
        parts = getattr(one, "exceptions", None) or ()
        waiting += [more for more in (one.__cause__, one.__context__, *parts) if more is not None]
    return "".join(told.format()) if told.stack else "".join(_without_a_head(told))


def _chained(error: BaseException) -> Iterator[BaseException]:
    """Yield an exception, and then its causes or contexts."""
    seen = set[int]()
    one: BaseException | None = error
    while one is not None and id(one) not in seen:
        seen.add(id(one))
        yield one
        one = one.__cause__ or one.__context__


def _without_a_head(told: traceback.TracebackException) -> list[str]:
    """Format an exception that has no frames, such as a SyntaxError, without the "Traceback" heading.

    If the exception has a cause or context, keep the headings.
    """
    if told.__cause__ is not None or (told.__context__ is not None and not told.__suppress_context__):
        return list(told.format())
    return list(told.format_exception_only())


def write(text: str) -> None:
    """Write `text` to standard error, if there is one, after all earlier output has been written."""
    for stream in (sys.stdout, sys.stderr):
        if stream is not None:
            stream.flush()
    if sys.stderr is not None:
        sys.stderr.write(text)
        sys.stderr.flush()


def take_over_threads(show: Callable[[BaseException], str]) -> None:
    """Print each uncaught exception of a thread in a single write from now on. `show` formats the exception."""

    def hook(arguments: threading.ExceptHookArgs) -> None:
        if arguments.exc_value is None or issubclass(arguments.exc_type, SystemExit):
            return
        name = arguments.thread.name if arguments.thread is not None else threading.get_ident()
        write(f"Exception in thread {name}:\n{show(arguments.exc_value)}")

    threading.excepthook = hook


def tell_who_stays(path: str) -> None:
    """Print which threads keep the program at `path` from exiting, each with the program's line that it's executing."""
    until = time.monotonic() + PATIENCE_WITH_THREADS_S
    others = [
        one for one in threading.enumerate() if one is not threading.current_thread() and not one.daemon
    ]
    while time.monotonic() < until and any(one.ident in sys._current_frames() for one in others):
        time.sleep(LOOK_EVERY_S)
    frames = sys._current_frames()
    for thread in others:
        if thread.ident in frames:  # not is_alive(), which returns False after an interrupted join()
            write(f"{STILL_RUNNING} {thread.name}{_line_of(frames[thread.ident], path)}\n")


def _line_of(frame: FrameType | None, path: str) -> str:
    while frame is not None and frame.f_code.co_filename != path:
        frame = frame.f_back
    return "" if frame is None else f", line {frame.f_lineno}"

"""Split a program's log into tracebacks, including chained exceptions, several threads, and exception groups."""

import re
from collections.abc import Iterator
from dataclasses import dataclass, field

TRACEBACK = "Traceback (most recent call last)"
FRAME = re.compile(r'^  File "(?P<file>[^"]+)", line (?P<line>\d+)(?:, in (?P<function>\S+))?')
MAIN, THREAD, IGNORED = range(3)
"""The place of an exception: in the main thread, in another thread, or where Python ignores it, as in finalizers."""
_START = re.compile(r"^(?:Exception Group )?" + re.escape(TRACEBACK) + ":$")
_THREAD = re.compile(r"^Exception in thread (?P<name>.*):$")
_IGNORED = re.compile(r"^(?:Exception ignored (?:in|from|while)\b|Task exception was never|Error in atexit)")
_CHAINED = re.compile(
    r"^(?:During handling of the above exception, another exception occurred|"
    r"The above exception was the direct cause of the following exception):$"
)
_ERROR = re.compile(r"^(?P<name>[^\W\d][\w.<>]*)(?::(?: .*)?)?$")
_EXCEPTIONAL = re.compile(r"(?:Error|Exception|Interrupt|Handle|Iteration|Exit|Group)$")
_OF_GROUP = re.compile(r"^ *[|+] ")
_PART_OF_GROUP = re.compile(r"^ *\+-.*- (?P<number>\d+) -+$|^ *\+-+$")
_QUOTED = re.compile(r"'([^'\s]+)'")
_THREADS_OWN = ("_bootstrap", "_bootstrap_inner", "run", "_worker")
_LEFT_OUT = re.compile(r"^… \d+ bytes left out …$")
_NO_NOTE = re.compile(
    r"^(?:Still running: |The following exception was never retrieved|\[(?:DEBUG|INFO|WARN|ERROR|FATAL)\] )"
)
"""Matches lines after a traceback that aren't part of its message. They come from the host, tasks, or loggers."""
_CAUGHT_ON_PURPOSE = re.compile(
    r"(?:KeyboardInterrupt|ExternalShutdownException|SystemExit|GeneratorExit|StopIteration|StopAsyncIteration|"
    r"CancelledError|\bEmpty|\bFull)$"
)
"""Matches exceptions that a program catches on purpose, around a spin, a generator, or a queue.

If another error occurs while the program handles such an exception, that error is the fault.
"""


@dataclass
class Raised:
    """One traceback: its frames and source lines (`lines`), its error line, and the rest of the message (`notes`)."""

    origin: int = MAIN
    thread: str = ""
    lines: list[str] = field(default_factory=list)
    error: str = ""
    notes: list[str] = field(default_factory=list)

    @property
    def name(self) -> str:
        """The exception's class name, as written in the error line."""
        found = _ERROR.match(self.error)
        return found["name"] if found else ""

    @property
    def text(self) -> str:
        """The whole traceback, as it was printed."""
        return "\n".join([f"{TRACEBACK}:", *self.lines, self.error, *self.notes])

    @property
    def excerpt(self) -> str:
        """The part for the error table: two lines before the error, the error, and the rest of its message."""
        return "\n".join([*self.lines[-2:], self.error, *self.notes])

    def frames(self) -> Iterator[re.Match[str]]:
        """Return the frames, outermost first."""
        return (frame for line in self.lines if (frame := FRAME.match(line)))

    def line_in(self, program: str) -> int | None:
        """Return the last line number in the student's file, or in any file if the program's name is unknown.

        The result is None if there is no such frame.
        """
        found = [int(one["line"]) for one in self.frames() if is_of(one, program)]
        return found[-1] if found else None

    def fits(self, frame: re.Match[str]) -> bool:
        """Return whether `frame` may be this traceback's next frame. This separates interleaved tracebacks."""
        last = [one["function"] for one in self.frames()]
        if frame["function"] in _THREADS_OWN[1:2]:
            return not last or last[-1] == "_bootstrap"
        if not last:
            return False
        if frame["function"] == "run" and last[-1] == "_bootstrap_inner":
            return True
        return last[-1] == "run" and f"({frame['function']})" in self.thread

    def speaks_of(self, error: str) -> bool:
        """Return whether the last source line contains a word that the error quotes."""
        source = next((one for one in reversed(self.lines) if not FRAME.match(one) and one.strip(" ^~")), "")
        return any(word in source for word in _QUOTED.findall(error))


def is_of(frame: re.Match[str], program: str) -> bool:
    """Return whether a frame is in the file named `program`. If the name is empty, every frame counts."""
    return not program or frame["file"].rsplit("/", 1)[-1] == program


class _Reader:
    """Reads a log one line at a time. `chains`: one list for each chain of exceptions, in the order of raising."""

    def __init__(self) -> None:
        self.chains: list[list[Raised]] = []
        self._open: list[Raised] = []
        self._heads: list[tuple[int, str]] = []
        self._closed: Raised | None = None
        self._chained = False
        self._part = 0

    def read(self, line: str) -> None:
        part = _PART_OF_GROUP.match(line)
        if part:
            self._part = int(part["number"] or 0)
            return
        line = _OF_GROUP.sub("", line, count=1)
        head = _THREAD.match(line)
        if head or _IGNORED.match(line):
            self._heads.append((THREAD, head["name"]) if head else (IGNORED, ""))
            self._closed = None
        elif _CHAINED.match(line):
            self._chained = True
        elif _START.match(line):
            self._start()
        elif _LEFT_OUT.match(line):
            self._open.clear()
            self._heads.clear()
            self._closed = None
        elif frame := FRAME.match(line):
            self._frame(line, frame)
        elif line.startswith(" ") and self._open:
            self._open[-1].lines.append(line)
        elif self._open and (found := _ERROR.match(line)):
            self._close(line, found["name"])
        elif _NO_NOTE.match(line):
            self._closed = None
        elif self._closed is not None and line:
            self._closed.notes.append(line)

    def _start(self) -> None:
        origin, thread = self._heads.pop(0) if self._heads else (MAIN, "")
        self._open.append(Raised(origin, thread))
        self._closed = None

    def _frame(self, line: str, frame: re.Match[str]) -> None:
        if not self._open:
            closed = self._closed
            if closed is not None and not _EXCEPTIONAL.search(closed.name):
                closed.lines.append(closed.error)  # a word that the program printed rather than an error
                closed.error, closed.notes = "", []
                self._drop(closed)
                self._open.append(closed)
                self._closed = None
            else:
                self._start()
        fitting = next((one for one in self._open if one.fits(frame)), self._open[-1])
        self._open.remove(fitting)
        self._open.append(fitting)  # its source line comes next
        fitting.lines.append(line)

    def _drop(self, one: Raised) -> None:
        self.chains = [kept for chain in self.chains if (kept := [each for each in chain if each is not one])]

    def _close(self, line: str, name: str) -> None:
        if not any(FRAME.match(one) for one in self._open[-1].lines) and not _EXCEPTIONAL.search(name):
            return
        spoken_of = [one for one in self._open if one.speaks_of(line)]
        done = spoken_of[0] if len(spoken_of) == 1 else self._open[-1]
        self._open.remove(done)
        done.error = line
        self._closed = done
        if self._part and self.chains:
            self._of_a_group(done)
        elif self._chained and self.chains:
            done.origin = self.chains[-1][0].origin
            self.chains[-1].append(done)
        else:
            self.chains.append([done])
        self._chained = False

    def _of_a_group(self, done: Raised) -> None:
        """Add an exception in a group to the last chain. The group's first exception replaces the group itself."""
        chain = self.chains[-1]
        done.origin = chain[0].origin
        if self._part == 1 and chain[-1].name.endswith("ExceptionGroup"):
            chain[-1] = done
        else:
            chain.append(done)


def chains_in(log: str) -> list[list[Raised]]:
    """Return the exceptions in a log, grouped into chains. In a chain, each exception results from the previous one."""
    reader = _Reader()
    for line in log.splitlines():
        reader.read(line)
    return reader.chains


def first_cause(chain: list[Raised], program: str) -> Raised:
    """Return the exception in a chain that caused the later ones.

    An exception without a frame in the program was caught inside a library, so it isn't the cause. Nor is an exception
    that programs catch on purpose.
    """
    own = [one for one in chain if one.line_in(program) is not None] or chain[-1:]
    return next((one for one in own if not _CAUGHT_ON_PURPOSE.search(one.name)), own[-1])


def main_one(chains: list[list[Raised]], program: str) -> Raised | None:
    """Return the exception to blame: the main program's last one, or else the one with the lowest line number.

    For threads, the line number decides, because the order in which they print is a matter of chance. The result is
    None if there are no exceptions.
    """
    causes = [first_cause(chain, program) for chain in chains]
    of_main = [one for one in causes if one.origin == MAIN]
    if of_main:
        return of_main[-1]
    return min(causes, key=lambda one: (one.origin, one.line_in(program) or 10**9, one.error), default=None)

"""What may end a program from outside: a limit of the judge that it went over, or a signal."""

from dataclasses import dataclass

from workbook.criteria.verdict import Verdict, failed
from workbook.recording.limits import ANSWER_LIMITS, MB
from workbook.recording.recording import ProcessRecord


@dataclass(frozen=True)
class Stop:
    """What a program did that it was stopped for: the cause id, why such a thing happens, and what to try."""

    cause: str
    did: str
    because: str
    try_this: str


_MEMORY_GB = (ANSWER_LIMITS.memory or 0) / 1000 / MB
_QUEUED_MB = (ANSWER_LIMITS.queued or 0) // MB
_STORED_MB = (ANSWER_LIMITS.stored or 0) // MB
_FILES = f"{ANSWER_LIMITS.files:,}".replace(",", " ")
_KERNEL_MB = (ANSWER_LIMITS.kernel or 0) // MB
_STOPS = {
    "output": Stop(
        "stopped.output",
        f"printed more than {ANSWER_LIMITS.output // MB} MB",
        "Something prints in an endless loop.",
        "Look for a print or log line that runs without a timer or a pause.",
    ),
    "processes": Stop(
        "stopped.processes",
        f"ran more than {ANSWER_LIMITS.processes} processes, or {ANSWER_LIMITS.threads} threads, at the same time",
        "A loop starts processes or threads without end (os.fork, subprocess, multiprocessing, threading).",
        "One process is enough for a node. Start others only when you must, and only a fixed number of them.",
    ),
    "memory": Stop(
        "stopped.memory",
        f"used more than {_MEMORY_GB:g} GB of memory in all its processes together",
        "A list grows without end, or each of several processes keeps a copy of a lot of data.",
        "Keep only what the next message needs, and start only the processes that you need.",
    ),
    "sockets": Stop(
        "stopped.sockets",
        f"opened more than {ANSWER_LIMITS.sockets} sockets, or left more than {_QUEUED_MB} MB unread in them",
        "A loop opens sockets or creates ROS contexts without end, or it sends to a socket that is never read.",
        "One context and one node are enough; close each socket that you open.",
    ),
    "descriptors": Stop(
        "stopped.descriptors",
        f"opened more than {ANSWER_LIMITS.descriptors} files, pipes, and sockets, waited for more than "
        f"{ANSWER_LIMITS.watches}, or made the kernel keep over {_KERNEL_MB} MB",
        "A loop opens files, pipes, or sockets without end, or it registers them with a selector again and again.",
        "Close each file that you open, for example with a `with` statement.",
    ),
    "files": Stop(
        "stopped.files",
        f"created more than {_FILES} files",
        "A loop creates new files without end.",
        "Write to one file, or to none: the judge reads no files of an answer.",
    ),
    "disk": Stop(
        "stopped.disk",
        f"wrote more than {_STORED_MB} MB to files",
        "A loop writes to a file without end.",
        "Write less, or nothing: the judge reads no files of an answer.",
    ),
}
_CRASHES = ("SIGSEGV", "SIGABRT", "SIGBUS", "SIGFPE", "SIGILL")


def stopped_for(process: ProcessRecord) -> Stop | None:
    """What the judge stopped the program for; None if it did not."""
    if process.ended_by != "judge":
        return None
    return next((_STOPS[limit] for limit in process.limits_hit if limit in _STOPS), None)


def ended_by_signal(process: ProcessRecord, saw: str, expected: str) -> Verdict:
    """A failed verdict that blames the signal that ended the program."""
    if process.signal == "SIGXCPU":
        return failed(
            "signal.processor-time",
            saw,
            expected,
            f"The program used all the processor time that an answer may use ({ANSWER_LIMITS.cpu} s): a loop runs "
            "without a pause.",
            "Let a timer do repeated work.",
        )
    if process.signal == "SIGKILL":
        return failed(
            "signal.killed",
            saw,
            expected,
            "The program was killed: by itself (os.kill), or by the system, because no memory was left.",
            "Look for a list that grows without end, and for calls of os.kill.",
        )
    if process.signal in _CRASHES:
        return failed(
            "signal.crashed",
            saw,
            expected,
            "The program crashed in compiled code: through ctypes, by os.abort(), or because of threads. Two "
            "threads used one ROS object at the same time, or one used an object that was already destroyed.",
            "Let one executor spin each node, and destroy nodes only after the spin has returned.",
        )
    return failed(
        "signal.other",
        saw,
        expected,
        "A signal ended the program, and nothing in the program handles that signal.",
        "Look for calls of os.kill and signal.alarm.",
    )

"""Words about the program as a whole: does it run, live on, end well?"""

from dataclasses import dataclass

from workbook.criteria.mishaps import failed_by_error, find_mishap, shutdown_overtaken
from workbook.criteria.phrasing import listing, seconds
from workbook.criteria.verdict import Verdict, failed, passed
from workbook.observing.recording import ProcessRecord, Recording

AT_ONCE_S = 8.0
"""How long (s) a program may take to start on a very busy machine."""
ANOTHER_MIDDLEWARE = "Expected RMW implementation identifier"
"""What rcl logs before it ends a program with code 102."""


@dataclass(frozen=True)
class _Stopped:
    """What a program did that it was stopped for, why such a thing happens, and what to try."""

    did: str
    because: str
    try_this: str


_STOPPED = {
    "output": _Stopped(
        "printed more than 50 MB",
        "Something prints in an endless loop.",
        "Look for a print or log line that runs without a timer or a pause.",
    ),
    "processes": _Stopped(
        "started more than 60 other processes",
        "A loop starts processes without end (os.fork, subprocess, multiprocessing).",
        "One process is enough for a node; start others only when you must, and a fixed number.",
    ),
    "memory": _Stopped(
        "took more than 2.5 GB of memory, all its processes together",
        "A list grows without end, or each of several processes keeps a copy of much data.",
        "Keep only what the next message needs, and start no process that you do not need.",
    ),
    "files": _Stopped(
        "made more than 20 000 files",
        "A loop makes a new file each time, without end.",
        "Write to one file, or to none: nobody reads the files of an answer.",
    ),
}
_SIGNALS = {
    "SIGXCPU": (
        "It has used all the processor time that an answer may use (60 s): a loop computes without a pause.",
        "Let a timer do the work that repeats.",
    ),
    "SIGKILL": (
        "It was killed: by itself (os.kill), or by the machine, which had no memory left for it.",
        "Look for a list that grows without end, and for calls of kill.",
    ),
    **dict.fromkeys(
        ("SIGSEGV", "SIGABRT", "SIGBUS", "SIGFPE", "SIGILL"),
        (
            "It crashed below Python, in compiled code: by way of ctypes, by os.abort(), or because two threads used "
            "one ROS object at the same time, or one that was destroyed.",
            "Let one executor spin each node, and destroy nodes only after the spin has returned.",
        ),
    ),
}


def _stopped_for(process: ProcessRecord) -> _Stopped | None:
    """What the bench stopped the program for; None if it did not."""
    if process.ended_by != "bench":
        return None
    return next((_STOPPED[limit] for limit in process.limits_hit if limit in _STOPPED), None)


def _ended_by_signal(process: ProcessRecord, saw: str, expected: str) -> Verdict:
    because, try_this = _SIGNALS.get(
        process.signal or "",
        ("A signal ended it, and nothing in the program handles it.", "Look for calls of kill and of alarm."),
    )
    return failed(saw, expected, because, try_this)


def program_runs(recording: Recording) -> Verdict:
    """The program starts and its node or a publisher of it is seen on the graph."""
    expected = "a program that starts, makes its node and keeps it running"
    if _got_going(recording):
        nodes = sorted({node.name for node in recording.nodes})
        return passed(f"node {listing(nodes)} is on the graph" if nodes else "publishers are on the graph")
    process = recording.process
    at_home = recording.domain_id in process.domains_used
    strangers = [domain for domain in process.domains_used if domain != recording.domain_id]
    if strangers and not at_home:
        return failed(
            f"your node is on domain {strangers[0]}, the exercise on another one",
            "a node on the domain that the environment gives (ROS_DOMAIN_ID)",
            "The program chooses a domain itself, so nobody here can hear it.",
            "Remove the domain_id argument or the ROS_DOMAIN_ID line from your program.",
        )
    if process.ended_by == "itself":
        return _ended_before_it_was_seen(recording, expected)
    stopped = _stopped_for(process)
    if stopped is not None:
        return failed(
            f"the program {stopped.did} and was stopped", expected, stopped.because, stopped.try_this
        )
    if at_home and not recording.nodes:
        return failed(
            "your program has opened the ports of ROS, and yet nobody can find a node of it",
            expected,
            "The program changes how nodes find each other: ROS_AUTOMATIC_DISCOVERY_RANGE, ROS_LOCALHOST_ONLY, "
            "ROS_STATIC_PEERS, RMW_IMPLEMENTATION, FASTRTPS_DEFAULT_PROFILES_FILE or another variable of ROS.",
            "Remove the lines that set such variables: the environment has set them already.",
        )
    if any(topic.publishers for topic in recording.topics.values()):
        return failed(
            "the publishers of your node appeared and vanished again, while the program runs on",
            expected,
            "The node was destroyed before it was spun (destroy_node, shutdown, or a with block that ended).",
            "Destroy the node only after rclpy.spin(node) has returned.",
        )
    if recording.nodes:
        names = listing(sorted(node.name for node in recording.nodes))
        return failed(
            f"node {names} is there, but it publishes nothing at all",
            expected,
            "No create_publisher() call was reached: there is none, or a call above it does not come back, such as "
            "rclpy.spin(node) above create_publisher().",
            "Create the publishers in __init__ and make sure that __init__ runs to its end.",
        )
    return failed(
        f"the program runs, but no node of it appeared within {seconds(process.watched_for)}",
        expected,
        "It is still busy in its first lines (a loop, a sleep, a wait), or never makes a node.",
        "Make the node first, and let timers do the work that repeats.",
    )


def _got_going(recording: Recording) -> bool:
    """A message arrived, or a publisher is there and stays while the program runs.

    A program that fails in its first lines may show publishers for a moment, and say one word on each topic; that is
    not yet running.
    """
    topics = recording.topics.values()
    if _failed_at_once(recording):
        return False
    if any(topic.arrivals or topic.undecodable or topic.not_kept for topic in topics):
        return True
    if recording.said or recording.calls:
        return bool(recording.nodes)  # one that was spoken to may have nothing to publish yet
    if recording.process.ended_by == "itself":
        return False
    return any(publisher.last_seen is None for topic in topics for publisher in topic.publishers)


def _failed_at_once(recording: Recording) -> bool:
    """An error ended the program before any topic had a second message."""
    process = recording.process
    if process.ended_by != "itself" or find_mishap(process.log, process.program) is None:
        return False
    return (
        bool(recording.topics)
        and not recording.said
        and not recording.calls
        and all(len(topic.arrivals) <= 1 for topic in recording.topics.values())
        and (process.ended_at or 0.0) < AT_ONCE_S
    )


def _ended_before_it_was_seen(recording: Recording, expected: str) -> Verdict:
    process = recording.process
    blamed = failed_by_error(recording, "", expected)
    if blamed is not None:
        return blamed
    ended = f"the program ended after {seconds(process.ended_at or 0.0)}"
    if process.signal is not None:
        return _ended_by_signal(
            process, f"{ended} (signal {process.signal}), before any message came", expected
        )
    if ANOTHER_MIDDLEWARE in process.log:
        return failed(
            f"{ended}: it asks for a middleware that is not there",
            expected,
            "The program sets RMW_IMPLEMENTATION.",
            "Remove the line that sets it: the environment has chosen a middleware already.",
        )
    return failed(
        f"{ended} (exit code {process.exit}), before any message came",
        expected,
        "Nothing keeps it alive: a program ends with its last line unless something spins.",
        "Make the node in main(), call rclpy.spin(node), and call main() at the end of the file.",
    )


def alive_at_end(recording: Recording) -> Verdict:
    """The program still runs when the watch ends."""
    process = recording.process
    expected = "a program that goes on until it is stopped"
    stopped = _stopped_for(process)
    if stopped is not None:
        return failed(
            f"the program was stopped after {seconds(process.ended_at or 0.0)}: it {stopped.did}",
            expected,
            stopped.because,
            stopped.try_this,
        )
    if process.ended_by != "itself":
        return passed(f"still running after {seconds(process.watched_for)}")
    ended = f"the program ended by itself after {seconds(process.ended_at or 0.0)}"
    blamed = failed_by_error(recording, ended, expected)
    if blamed is not None:
        return blamed
    if process.signal is not None:
        return _ended_by_signal(process, f"{ended} (signal {process.signal})", expected)
    return failed(
        f"{ended} (exit code {process.exit})",
        expected,
        "A loop that counts, a spin with an end, or a missing rclpy.spin(node).",
        "Keep the node alive with rclpy.spin(node) until Ctrl-C.",
    )


def exits_cleanly(recording: Recording) -> Verdict:
    """On Ctrl-C (SIGINT) the program ends with exit code 0 and without a traceback.

    One traceback is forgiven: see `shutdown_overtaken`.

    Needs `watching(to_the_end=True)`; raises ValueError when the recording does not hold the end.
    """
    process = recording.process
    if process.ended_by is None:
        raise ValueError("exits_cleanly needs watching(to_the_end=True) in the criteria file")
    expected = "exit code 0 and no traceback after Ctrl-C"
    if process.ended_by == "itself":
        return failed(
            f"the program ended by itself after {seconds(process.ended_at or 0.0)}, before Ctrl-C was sent",
            expected,
            "Nothing keeps it alive, or an error ended it.",
            "Keep it running with rclpy.spin(node) first.",
        )
    if process.signal == "SIGKILL":
        return failed(
            "it went on running after Ctrl-C and had to be killed",
            expected,
            "KeyboardInterrupt is swallowed inside a loop, or a thread goes on.",
            "Let KeyboardInterrupt leave the spin; catch it around rclpy.spin(node) only.",
        )
    if process.signal == "SIGABRT":
        return failed(
            "it aborted at its end (SIGABRT)",
            expected,
            "A thread was still spinning when the interpreter went down.",
            "Shut the executor down first, then join its thread.",
        )
    if process.signal == "SIGSEGV":
        return failed(
            "it crashed while Ctrl-C ended it (SIGSEGV)",
            expected,
            "A thread still used the node or its context when these were destroyed. On a very busy machine it can also "
            "be rclpy's own fault.",
            "Run it again. If it crashes again, shut the executor down first, join its thread, and call "
            "rclpy.try_shutdown() last.",
        )
    if process.exit == 1 and shutdown_overtaken(process.end_log):
        return passed(
            "it ended after Ctrl-C as it should; that rclpy's own handling of Ctrl-C overtook try_shutdown() is no "
            "fault of the program"
        )
    mishap = find_mishap(process.end_log, process.program)
    if mishap is None and process.exit == 0:
        return passed("ended with exit code 0 after Ctrl-C, no traceback")
    if mishap is not None:
        return failed(
            f"after Ctrl-C: {mishap.where}{mishap.error} (exit code {process.exit})",
            expected,
            mishap.because,
            mishap.try_this,
        )
    how = f"ended by signal {process.signal}" if process.signal else f"exit code {process.exit}"
    return failed(
        f"{how} after Ctrl-C",
        expected,
        "KeyboardInterrupt leaves main() without being caught.",
        "Wrap rclpy.spin(node) in try/except (KeyboardInterrupt, ExternalShutdownException), and call "
        "rclpy.try_shutdown() in finally.",
    )

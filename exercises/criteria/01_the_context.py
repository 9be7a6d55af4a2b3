"""Judge exercise 01 by the program's behavior until Ctrl-C, its log after Ctrl-C, and the nodes it leaves behind."""

from dataclasses import dataclass

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, watching

WATCH_S = 4.0  # the task states it
WATCH = watching(wall_seconds=WATCH_S, to_the_end=True)
WORDS = see.Words(__file__)

NODE = "/night_guard"
PARKED = "arms parked"  # compared in lowercase, because the program may log it in any case
LEAST_ROUNDS = 4  # of the eight rounds that are due; the task states it
RAISED_BY_SPIN = ("ExternalShutdownException", "RCLError", "InvalidHandle")  # after the context was shut down
LONGEST_QUOTE = 60  # characters of a log line that feedback quotes
LONGEST_SILENCE_S = 1.5  # before Ctrl-C: three rounds; the task states it


@dataclass(frozen=True)
class Night:
    """The program's log before and after Ctrl-C, and the program's exit."""

    recording: Recording

    @property
    def log(self) -> str:
        return self.recording.process.log.lower()

    @property
    def end_log(self) -> str:
        return self.recording.process.end_log.lower()

    @property
    def signal(self) -> str | None:
        return self.recording.process.signal

    @property
    def lines(self) -> int:
        return sum(bool(line.strip()) for line in self.log.splitlines())

    @property
    def silent(self) -> float:
        """The time (s) from the last log line to Ctrl-C."""
        printed_at = self.recording.process.printed_at
        return 0.0 if printed_at is None else self.recording.wall_s - printed_at

    @property
    def others(self) -> list[str]:
        return sorted({node.name for node in self.recording.nodes} - {NODE})

    @property
    def walked_after_parking(self) -> bool:
        """Whether the guard logged more than one line after it logged that its arms are parked."""
        after = self.end_log.partition(PARKED)[2].splitlines()[1:]
        return sum(bool(line.strip()) and PARKED not in line for line in after) > 1

    @property
    def about_parking(self) -> str | None:
        """A line after Ctrl-C that mentions parking in other words, or None if there is none."""
        lines = self.recording.process.end_log.splitlines()
        return next((line.strip()[:LONGEST_QUOTE] for line in lines if "park" in line.lower()), None)


ROUNDS = WORDS.rules(
    Night,
    "walks-its-rounds",
    ("stands-still", lambda night: night.lines < LEAST_ROUNDS),
    ("stops", lambda night: night.silent > LONGEST_SILENCE_S),
    about_time=["stops"],
)
OTHER_NODES = WORDS.rules(Night, "guard-on-the-graph", ("another-node", lambda night: night.others))
NOT_PARKED = WORDS.rules(
    Night,
    "arms-parked",
    ("too-early", lambda night: PARKED in night.log),
    ("ignores-ctrl-c", lambda night: night.signal == "SIGKILL"),
    ("killed-by-ctrl-c", lambda night: night.signal == "SIGINT" and not night.end_log.strip()),
    ("error", see.otherwise, see.failed_at_the_end),
    ("other-words", lambda night: night.about_parking),
    ("never", see.otherwise),
)
KILLED = WORDS.rules(
    Night,
    "ends-cleanly",
    ("walks-on", lambda night: night.signal == "SIGKILL" and night.walked_after_parking),
    ("goes-on-after-parking", lambda night: night.signal == "SIGKILL" and PARKED in night.end_log),
)
THREAD_RAISED = WORDS.cause("ends-cleanly.thread-raised", ("expected",))
NODE_LEFT = WORDS.cause("node-gone.killed", ("saw", "expected"))


@criterion(points=0, title="Your program runs without an error")
def program_runs(recording: Recording) -> Verdict:
    process = recording.process
    if process.ended_by == "itself" and process.exit == 0:
        return see.passed("it ran and ended with exit code 0")
    is_up = recording.nodes and process.ended_by != "itself"
    return see.passed("it runs") if is_up else see.program_runs(recording)


@criterion(points=1, title="The program keeps running until Ctrl-C", needs=[program_runs])
def runs_until_told(recording: Recording) -> Verdict:
    return see.alive_at_end(recording)


@criterion(points=1, title="The guard makes its rounds", needs=[runs_until_told])
def walks_its_rounds(recording: Recording) -> Verdict:
    night = Night(recording)
    return ROUNDS.first(night) or see.passed(f"{see.count(night.lines, 'line')} in the log")


@criterion(points=1, title="/night_guard appears in the graph exactly once", needs=[runs_until_told])
def guard_on_the_graph(recording: Recording) -> Verdict:
    how = "Don't change the class NightGuard, don't remap anything, and don't give the node a namespace."
    verdict = see.on_the_graph(recording, NODE, how=how)
    return (verdict.ok and OTHER_NODES.first(Night(recording))) or verdict


@criterion(
    points=2,
    title="The arms are parked after Ctrl-C, and not before",
    needs=[runs_until_told],
    about_end=True,
)
def arms_parked(recording: Recording) -> Verdict:
    night = Night(recording)
    if PARKED in night.end_log and PARKED not in night.log:
        return see.passed("the arms were parked after Ctrl-C")
    return NOT_PARKED.verdict(night)


@criterion(
    points=3,
    title="Ctrl-C ends the program with exit code 0 and no traceback",
    needs=[runs_until_told],
    about_end=True,
)
def ends_cleanly(recording: Recording) -> Verdict:
    killed = KILLED.first(Night(recording))
    if killed is not None:
        return killed
    process, verdict = recording.process, see.exits_cleanly(recording)
    by_thread = not verdict.ok and process.exit == 0 and "Exception in thread" in process.end_log
    by_spin = any(name in process.end_log for name in RAISED_BY_SPIN)
    if by_thread and (by_spin or verdict.cause == "exits-cleanly.prints-a-traceback"):
        return THREAD_RAISED.verdict(expected=verdict.expected)
    return verdict


@criterion(
    points=2,
    title="After Ctrl-C, the program's node disappears from the graph",
    needs=[runs_until_told],
    about_end=True,
)
def node_gone(recording: Recording) -> Verdict:
    verdict = see.nodes_gone_at_end(recording)
    if verdict.ok or recording.process.signal != "SIGKILL":
        return verdict
    return NODE_LEFT.verdict(saw=verdict.saw, expected=verdict.expected)

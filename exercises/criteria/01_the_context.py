"""How exercise 01 is judged: what the program does until Ctrl-C, what it says then, and what it leaves behind."""

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, watching

WATCH_S = 4.0  # the task names it
WATCH = watching(wall_seconds=WATCH_S, to_the_end=True)

NODE = "/night_guard"
PARKED = "arms parked"  # compared in lower case: the program may log it as it likes
LEAST_ROUNDS = 4  # of the eight that are due; the task names it
RAISED_BY_SPIN = ("ExternalShutdownException", "RCLError", "InvalidHandle")  # when the context is gone
LONGEST_QUOTE = 60  # characters of a line of the log that feedback quotes
LONGEST_SILENCE_S = 1.5  # before Ctrl-C: three rounds; the task names it


@criterion(points=0, title="Your program runs without an error")
def program_runs(recording: Recording) -> Verdict:
    if came_to_its_end(recording):
        return see.passed("it ran to its end")
    if recording.nodes and recording.process.ended_by != "itself":
        return see.passed("it runs")
    return see.program_runs(recording)


@criterion(points=1, title="The program runs until it is told to end", needs=[program_runs])
def runs_until_told(recording: Recording) -> Verdict:
    return see.alive_at_end(recording)


@criterion(points=1, title="The guard walks its rounds", needs=[runs_until_told])
def walks_its_rounds(recording: Recording) -> Verdict:
    process = recording.process
    lines = [line for line in process.log.splitlines() if line.strip()]
    seen = f"{see.count(len(lines), 'line')} in the log"
    if len(lines) < LEAST_ROUNDS:
        return see.failed(
            "walks-its-rounds.stands-still",
            f"{seen} after {WATCH_S:g} s",
            f"a line in the log for each round; {LEAST_ROUNDS} of them are enough in {WATCH_S:g} s",
            "Either the timer doesn't fire, or not every round is logged. A timer fires only while its node is "
            "spun. A sleep, an event, or an empty loop keeps the program alive but doesn't spin the node.",
            "Keep the guard working with rclpy.spin(guard), and don't change walk_round.",
        )
    silent = 0.0 if process.printed_at is None else recording.wall_s - process.printed_at
    if silent <= LONGEST_SILENCE_S:
        return see.passed(seen)
    return see.failed(
        "walks-its-rounds.stops",
        f"{seen}, but none in the last {see.number(round(silent, 1))} s before Ctrl-C",
        f"a line in the log for each round, and at most {LONGEST_SILENCE_S:g} s without a line before Ctrl-C",
        "The guard walked at first but then stopped. Its timer was canceled, or nothing spins the node any more.",
        "Spin the guard until Ctrl-C: rclpy.spin(guard) doesn't return earlier.",
        about_time=True,
    )


@criterion(points=1, title="/night_guard is on the graph, once", needs=[runs_until_told])
def guard_on_the_graph(recording: Recording) -> Verdict:
    how = "Don't change the class NightGuard, don't remap anything, and don't give the node a namespace."
    verdict = see.on_the_graph(recording, NODE, how=how)
    others = sorted({node.name for node in recording.nodes} - {NODE})
    if not verdict.ok or not others:
        return verdict
    return see.failed(
        "guard-on-the-graph.another-node",
        f"{NODE}, but also {see.listing(others)}",
        f"one node, {NODE}",
        "The program creates more nodes than it needs.",
        "Create the guard and no other node.",
    )


@criterion(
    points=2,
    title="The arms are parked after Ctrl-C, and not before",
    needs=[runs_until_told],
    about_end=True,
)
def arms_parked(recording: Recording) -> Verdict:
    expected = f"the words {PARKED!r} in the log after Ctrl-C, and not before"
    process = recording.process
    if PARKED in process.log.lower():
        return see.failed(
            "arms-parked.too-early",
            "the arms were parked while the guard was still on duty",
            expected,
            "park() is called before rclpy.spin(guard), or in a callback.",
            "Call guard.park() after the spin has ended: in finally.",
        )
    if PARKED in process.end_log.lower():
        return see.passed("the arms were parked after Ctrl-C")
    if process.signal == "SIGKILL":
        return see.failed(
            "arms-parked.ignores-ctrl-c",
            "the program kept running after Ctrl-C, with the arms up, and had to be killed",
            expected,
            "The program ignores Ctrl-C. Or it catches KeyboardInterrupt and continues, in a loop or with slow "
            "work before it parks.",
            "Put the try around the whole loop, and park in the first line of finally.",
        )
    return why_never_parked(recording, expected)


def why_never_parked(recording: Recording, expected: str) -> Verdict:
    """Why the program ended after Ctrl-C without the words."""
    process = recording.process
    if process.signal == "SIGINT" and not process.end_log.strip():
        return see.failed(
            "arms-parked.killed-by-ctrl-c",
            "the Ctrl-C signal ended the program immediately, with the arms still up",
            expected,
            "No Python code ran after Ctrl-C. The signal's handler was set to the default, SIG_DFL, which ends a "
            "process silently.",
            "Keep the handler that rclpy.init() sets, or set one that lets your program clean up.",
        )
    verdict = see.failed_at_the_end(recording, "the arms are still up", expected)
    if verdict is not None:
        return verdict
    said = next((line.strip() for line in process.end_log.splitlines() if "park" in line.lower()), None)
    if said is not None:
        return see.failed(
            "arms-parked.other-words",
            f"after Ctrl-C, the log contains {said[:LONGEST_QUOTE]!r}",
            expected,
            "The judge searches the log for the expected words, but these are different. If park() logs them, it "
            "was changed.",
            "Restore the class NightGuard: its park() logs 'arms parked'.",
        )
    return see.failed(
        "arms-parked.never",
        "the program ended after Ctrl-C, but the arms are still up",
        expected,
        "Nothing calls park() after Ctrl-C. rclpy.spin() doesn't return on Ctrl-C: it raises KeyboardInterrupt, so "
        "the lines after it never run. By then, rclpy.ok() is False, and on_shutdown callbacks aren't called.",
        "Call guard.park() in the finally block of a try around rclpy.spin(guard), without a condition.",
    )


@criterion(
    points=3,
    title="Ctrl-C ends it with exit code 0, without a traceback",
    needs=[runs_until_told],
    about_end=True,
)
def ends_cleanly(recording: Recording) -> Verdict:
    process = recording.process
    if process.signal == "SIGKILL" and walked_after_parking(recording):
        return see.failed(
            "ends-cleanly.walks-on",
            "the arms were parked after Ctrl-C, but the guard kept walking and had to be killed",
            "exit code 0 and no traceback after Ctrl-C",
            "The guard is still spun after it has parked. Either your own signal handler parks but doesn't end the "
            "spin, or a loop starts the spin again.",
            "Leave SIGINT to rclpy: spin raises KeyboardInterrupt. Park in finally, and let main() return.",
        )
    if process.signal == "SIGKILL" and PARKED in process.end_log.lower():
        return see.failed(
            "ends-cleanly.goes-on-after-parking",
            "the arms were parked after Ctrl-C, but the program kept running and had to be killed",
            "exit code 0 and no traceback after Ctrl-C",
            "Something keeps running after the arms are parked: a loop that starts again, a sleep, or an input. It "
            "may also be a non-daemon thread, or a process that your program started.",
            "Let main() return after cleaning up, and don't start anything that outlives it.",
        )
    verdict = see.exits_cleanly(recording)
    of_a_thread = process.exit == 0 and "Exception in thread" in process.end_log
    of_rclpy = verdict.cause == "exits-cleanly.prints-a-traceback" or any(
        name in process.end_log for name in RAISED_BY_SPIN
    )
    if verdict.ok or not of_a_thread or not of_rclpy:
        return verdict
    return see.failed(
        "ends-cleanly.thread-raised",
        "exit code 0 after Ctrl-C, but a thread's traceback",
        verdict.expected,
        "A thread was still spinning when Ctrl-C shut the context down. Then spin raises an exception, which "
        "nothing in that thread catches. Sometimes, this aborts the program.",
        "Catch ExternalShutdownException in the thread's function, and join the thread before main() ends.",
    )


@criterion(points=2, title="Its node is gone from the graph", needs=[runs_until_told], about_end=True)
def node_gone(recording: Recording) -> Verdict:
    verdict = see.nodes_gone_at_end(recording)
    if verdict.ok or recording.process.signal != "SIGKILL":
        return verdict
    return see.failed(
        "node-gone.killed",
        verdict.saw,
        verdict.expected,
        "The program didn't end on Ctrl-C and was killed, so its node was never removed from the graph. Other "
        "programs still see the node for up to 20 s.",
        "First, make the program end on Ctrl-C. Its node then disappears with it.",
    )


def walked_after_parking(recording: Recording) -> bool:
    """Whether the guard logged something else after the words that say that its arms are parked."""
    _, parked, after = recording.process.end_log.lower().partition(PARKED)
    lines = [line for line in after.splitlines()[1:] if line.strip() and PARKED not in line]
    return bool(parked) and len(lines) > 1


def came_to_its_end(recording: Recording) -> bool:
    """Whether the program ended by itself without an error, as one does that has nothing more to do."""
    process = recording.process
    return process.ended_by == "itself" and process.exit == 0

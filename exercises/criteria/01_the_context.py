"""How exercise 01 is judged: what the program does until Ctrl-C, what it says then, and what it leaves behind."""

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, watching

WATCH_S = 4.0  # the task names it
WATCH = watching(wall_seconds=WATCH_S, to_the_end=True)

NODE = "/night_guard"
PARKED = "arms parked"  # compared in lower case: the program may log it as it likes
LEAST_ROUNDS = 4  # of the eight that are due; the task names it


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
    lines = [line for line in recording.process.log.splitlines() if line.strip()]
    expected = f"a line in the log for each round; {LEAST_ROUNDS} of them are enough in {WATCH_S:g} s"
    if len(lines) >= LEAST_ROUNDS:
        return see.passed(f"{see.count(len(lines), 'line')} in the log")
    return see.failed(
        "walks-its-rounds.stands-still",
        f"{see.count(len(lines), 'line')} in the log after {WATCH_S:g} s: the node is there, but it does almost "
        "nothing",
        expected,
        "A timer walks the rounds, and a timer works only while its node is spun. A sleep keeps the program "
        "alive, but it does not spin the node.",
        "Keep the guard at work with rclpy.spin(guard).",
    )


@criterion(points=1, title="/night_guard is on the graph, once", needs=[runs_until_told])
def guard_on_the_graph(recording: Recording) -> Verdict:
    verdict = see.on_the_graph(recording, NODE)
    others = sorted({node.name for node in recording.nodes} - {NODE})
    if not verdict.ok or not others:
        return verdict
    return see.failed(
        "guard-on-the-graph.another-node",
        f"{NODE}, and {see.listing(others)} as well",
        f"one node, {NODE}",
        "The program makes one more node than it needs.",
        "Make the guard, and no other node.",
    )


@criterion(points=2, title="The arms are parked after Ctrl-C, and not before", needs=[runs_until_told])
def arms_parked(recording: Recording) -> Verdict:
    expected = f"the words {PARKED!r} after Ctrl-C, and not before"
    process = recording.process
    if PARKED in process.log.lower():
        return see.failed(
            "arms-parked.too-early",
            "the arms were parked while the guard was still on duty",
            expected,
            "park() is called before rclpy.spin(guard), or in a callback.",
            "Call guard.park() once spin has ended: in finally.",
        )
    if PARKED in process.end_log.lower():
        return see.passed("the arms were parked after Ctrl-C")
    if process.signal == "SIGKILL":
        return see.failed(
            "arms-parked.ignores-ctrl-c",
            "the program went on after Ctrl-C, with its arms up, and had to be killed",
            expected,
            "The program ignores Ctrl-C. Or it catches KeyboardInterrupt and goes on: in a loop, or with slow "
            "work before it parks.",
            "Put the try around the whole loop, and park first thing in finally.",
        )
    return see.failed_at_the_end(recording, "the arms are still up", expected) or see.failed(
        "arms-parked.never",
        "the program ended after Ctrl-C, and its arms are still up",
        expected,
        "Nothing calls park() after Ctrl-C. rclpy.spin() does not return on Ctrl-C: it raises KeyboardInterrupt, "
        "so the lines after it never run. on_shutdown callbacks are not called either.",
        "Call guard.park() in the finally block of a try around rclpy.spin(guard).",
    )


@criterion(points=3, title="Ctrl-C ends it with exit code 0, without a traceback", needs=[runs_until_told])
def ends_cleanly(recording: Recording) -> Verdict:
    process = recording.process
    if process.signal == "SIGKILL" and PARKED in process.end_log.lower():
        return see.failed(
            "ends-cleanly.goes-on-after-parking",
            "the arms were parked after Ctrl-C, and the program went on and had to be killed",
            "exit code 0 and no traceback after Ctrl-C",
            "Something keeps running after the arms are parked: a loop that starts again, a sleep, an input, or a "
            "thread that is not a daemon.",
            "Let main() return when it has cleaned up.",
        )
    verdict = see.exits_cleanly(recording)
    if verdict.ok or process.exit != 0 or "Exception in thread" not in process.end_log:
        return verdict
    return see.failed(
        "ends-cleanly.thread-raised",
        "exit code 0 after Ctrl-C, and the traceback of a thread",
        verdict.expected,
        "A thread was still spinning when Ctrl-C shut the context down. Then spin raises an exception, and "
        "nothing in that thread catches it. Such a program sometimes aborts.",
        "Catch ExternalShutdownException in the function of the thread, and join the thread before main() ends.",
    )


@criterion(points=2, title="Its node is gone from the graph", needs=[runs_until_told])
def node_gone(recording: Recording) -> Verdict:
    verdict = see.nodes_gone_at_end(recording)
    if verdict.ok or recording.process.signal != "SIGKILL":
        return verdict
    return see.failed(
        "node-gone.killed",
        verdict.saw,
        verdict.expected,
        "The program did not end on Ctrl-C and was killed, so its node was never removed from the graph. Other "
        "programs see such a ghost for up to 20 s.",
        "First make the program end on Ctrl-C. Its node then disappears with it.",
    )


def came_to_its_end(recording: Recording) -> bool:
    """Whether the program ended by itself without an error, as one does that has nothing more to do."""
    process = recording.process
    return process.ended_by == "itself" and process.exit == 0

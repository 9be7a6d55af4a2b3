"""How exercise 01 is judged: what the program does until Ctrl-C, what it says then, and what it leaves behind."""

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, watching

WATCH = watching(wall_seconds=2.0, to_the_end=True)

NODE = "/night_guard"
PARKED = "arms parked"


def came_to_its_end(recording: Recording) -> bool:
    """The program ended of its own accord, as a program does that has nothing more to do."""
    process = recording.process
    return process.ended_by == "itself" and process.exit == 0


def parks_at_the_end(recording: Recording) -> Verdict:
    """It said that the arms are parked after Ctrl-C, and not before."""
    expected = f"the words {PARKED!r} after Ctrl-C, and not before"
    process = recording.process
    if PARKED in process.log.lower():
        return see.failed(
            "the arms were parked while the guard was still on duty",
            expected,
            "park() is called before rclpy.spin(guard), or in a callback.",
            "Call guard.park() once spin has ended: in finally.",
        )
    if PARKED in process.end_log.lower():
        return see.passed("the arms were parked after Ctrl-C")
    if process.signal == "SIGKILL":
        return see.failed(
            "the program went on after Ctrl-C, with its arms up, and had to be killed",
            expected,
            "KeyboardInterrupt is caught inside a loop, and the loop goes on.",
            "Put the try around the whole loop, and park in finally.",
        )
    return see.failed(
        "the program ended after Ctrl-C, and its arms are still up",
        expected,
        "spin does not return on Ctrl-C, it raises KeyboardInterrupt; the lines after it are never reached. "
        "Or the line that parks stands in a branch that this exception does not take.",
        "Call guard.park() in the finally block of a try around rclpy.spin(guard).",
    )


@criterion(points=0, title="Your program runs without an error")
def program_runs(recording: Recording) -> Verdict:
    if came_to_its_end(recording):
        return see.passed("it ran to its end")
    if recording.nodes and recording.process.ended_by != "itself":
        return see.passed("it runs")
    return see.program_runs(recording)


@criterion(points=2, title="The program runs until it is told to end", needs=[program_runs])
def runs_until_told(recording: Recording) -> Verdict:
    return see.alive_at_end(recording)


@criterion(points=1, title="/night_guard is on the graph, once", needs=[runs_until_told])
def guard_on_the_graph(recording: Recording) -> Verdict:
    return see.on_the_graph(recording, NODE)


@criterion(points=2, title="The arms are parked after Ctrl-C, and not before", needs=[runs_until_told])
def arms_parked(recording: Recording) -> Verdict:
    return parks_at_the_end(recording)


@criterion(points=3, title="Ctrl-C ends it with exit code 0, without a traceback", needs=[runs_until_told])
def ends_cleanly(recording: Recording) -> Verdict:
    return see.exits_cleanly(recording)


@criterion(points=2, title="Its node is gone from the graph", needs=[runs_until_told])
def node_gone(recording: Recording) -> Verdict:
    return see.nodes_gone_at_end(recording)

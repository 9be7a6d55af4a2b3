"""Judges the program as a whole: whether it runs, and whether it runs until the judge stops watching."""

from workbook.criteria.criterion import criterion
from workbook.criteria.verdict import Verdict, failed, passed
from workbook.criteria.vocabulary.driver import forged_report
from workbook.criteria.vocabulary.known_errors import failed_by_error, failed_while_spinning, find_error
from workbook.criteria.vocabulary.phrasing import listing, nodes_are, seconds
from workbook.criteria.vocabulary.spins import held_by_a_spin, initialized_again
from workbook.criteria.vocabulary.stops import ended_by_signal, stopped_for
from workbook.recording.recording import Recording

AT_ONCE_S = 8.0
"""How long (s) a program may take to start on a very busy machine."""
A_ROUND_S = 0.95
"""A program that spun for so long (s) has been seen. Sooner than that, it is chance whether its publishers were."""
ANOTHER_MIDDLEWARE = "Expected RMW implementation identifier"
"""What rcl logs before it ends a program with code 102."""
_EXPECTED = "a program that starts, creates its node, and keeps it running"


@criterion(points=0, title="Your program runs and its node is on the graph")
def program_runs(recording: Recording) -> Verdict:
    """The program starts, and its node or a publisher of it is seen on the graph.

    A criterion already, which costs no points: `from workbook.criteria import program_runs` puts it into a criteria
    file, for others to need.
    """
    forged = forged_report(recording)
    if forged is not None:
        return forged
    if _got_going(recording):
        nodes = sorted({node.name for node in recording.nodes})
        return passed(f"{nodes_are(nodes) if nodes else 'publishers are'} on the graph")
    process = recording.process
    at_home = recording.domain_id in process.domains_used
    strangers = [domain for domain in process.domains_used if domain != recording.domain_id]
    if strangers and not at_home:
        return failed(
            "program-runs.other-domain",
            f"your node is on domain {strangers[0]}, but the exercise uses another one",
            "a node on the domain that the environment gives (ROS_DOMAIN_ID)",
            "The program chooses its own domain, so nothing on this domain can receive its messages.",
            "Remove the domain_id argument or the ROS_DOMAIN_ID line from your program.",
        )
    if process.ended_by == "itself":
        return _ended_before_it_was_seen(recording)
    stop = stopped_for(process)
    if stop is not None:
        saw = f"the program {stop.did} and was stopped"
        return failed(stop.cause, saw, _EXPECTED, stop.because, stop.try_this)
    return _runs_unseen(recording, at_home)


def _runs_unseen(recording: Recording, at_home: bool) -> Verdict:
    """Why a program that still runs shows nothing that lasts."""
    begins_again = initialized_again(recording, "no node of your program stays on the graph", _EXPECTED)
    if begins_again is not None:
        return begins_again
    if at_home and not recording.nodes:
        return failed(
            "program-runs.discovery-changed",
            "your program uses ROS, but none of its nodes can be found",
            _EXPECTED,
            "The program changes how nodes find each other: ROS_AUTOMATIC_DISCOVERY_RANGE, ROS_LOCALHOST_ONLY, "
            "ROS_STATIC_PEERS, RMW_IMPLEMENTATION, FASTRTPS_DEFAULT_PROFILES_FILE or another variable of ROS.",
            "Remove the lines that set such variables: the environment already sets them.",
        )
    if any(topic.publishers for topic in recording.topics.values()):
        return failed(
            "program-runs.node-destroyed",
            "the publishers of your node appeared and disappeared again, but the program still runs",
            _EXPECTED,
            "The node was destroyed before it was spun: by destroy_node, shutdown, or the end of a with block.",
            "Destroy the node only after rclpy.spin(node) has returned.",
        )
    if recording.nodes:
        names = listing(sorted(node.name for node in recording.nodes))
        saw = f"no publisher at all; the graph shows only {names}"
        return held_by_a_spin(recording, saw, _EXPECTED) or failed(
            "program-runs.publishes-nothing",
            saw,
            _EXPECTED,
            "No create_publisher() call was reached. There is none, or a call before it never returns, such as "
            "rclpy.spin(node).",
            "Create the publishers in __init__ and make sure that __init__ runs to its end.",
        )
    return failed(
        "program-runs.no-node",
        f"the program runs, but none of its nodes appeared within {seconds(recording.process.watched_for)}",
        _EXPECTED,
        "The program is still busy in its first lines (a loop, a sleep, a wait), or it never creates a node.",
        "Create the node first, and let timers do repeated work.",
    )


def _got_going(recording: Recording) -> bool:
    """A message arrived, or a publisher is there and stays while the program runs.

    A program that fails in its first lines may show publishers for a moment, and say one word on each topic; that is
    not yet running. One that fails in a callback was running, even if that was the first round of its timer: how many
    of its messages still arrived is chance.
    """
    topics = recording.topics.values()
    if _failed_at_once(recording):
        return False
    if any(topic.arrivals or topic.undecodable or topic.not_kept for topic in topics):
        return True
    if recording.published or recording.calls:
        return bool(recording.nodes)  # one that was spoken to may have nothing to publish yet
    if recording.process.ended_by == "itself":
        return failed_while_spinning(recording.process.log) and any(topic.publishers for topic in topics)
    return any(publisher.last_seen is None for topic in topics for publisher in topic.publishers)


def _failed_at_once(recording: Recording) -> bool:
    """An error ended the program before any topic had a second message, and it had not been spinning for a second."""
    process = recording.process
    if process.ended_by != "itself" or find_error(process.log, process.program) is None:
        return False
    if failed_while_spinning(process.log) and recording.simulated_s >= A_ROUND_S:
        return False
    return (
        bool(recording.topics)
        and not recording.published
        and not recording.calls
        and all(len(topic.arrivals) <= 1 for topic in recording.topics.values())
        and (process.ended_at or 0.0) < AT_ONCE_S
    )


def _ended_before_it_was_seen(recording: Recording) -> Verdict:
    process = recording.process
    blamed = failed_by_error(recording, "", _EXPECTED)
    if blamed is not None:
        return blamed
    ended = f"the program ended after {seconds(process.ended_at or 0.0)}"
    if process.signal is not None:
        return ended_by_signal(
            process, f"{ended} (signal {process.signal}), before any message arrived", _EXPECTED
        )
    if ANOTHER_MIDDLEWARE in process.log:
        return failed(
            "program-runs.other-middleware",
            f"{ended}: it requests a middleware that isn't installed",
            _EXPECTED,
            "The program sets RMW_IMPLEMENTATION.",
            "Remove the line that sets it: the environment already chooses a middleware.",
        )
    return failed(
        "program-runs.ended",
        f"{ended} (exit code {process.exit}), before any message arrived",
        _EXPECTED,
        "Nothing keeps the program alive: without a spin, it ends after its last line.",
        "Create the node in main(), call rclpy.spin(node), and call main() at the end of the file.",
    )


def ended_by_error(recording: Recording, saw: str, expected: str) -> Verdict | None:
    """A failed verdict that blames the error which ended the program; None if it lived on or ended without one."""
    if recording.process.ended_by != "itself":
        return None
    return failed_by_error(recording, f"{saw}. An error had ended the program", expected)


def alive_at_end(recording: Recording) -> Verdict:
    """The program still runs when the judge stops watching."""
    process = recording.process
    expected = "a program that runs until it is stopped"
    stop = stopped_for(process)
    if stop is not None:
        saw = f"the program was stopped after {seconds(process.ended_at or 0.0)}: it {stop.did}"
        return failed(stop.cause, saw, expected, stop.because, stop.try_this)
    if process.ended_by != "itself":
        return passed(f"still running after {seconds(process.watched_for)}")
    ended = f"the program ended by itself after {seconds(process.ended_at or 0.0)}"
    blamed = failed_by_error(recording, ended, expected)
    if blamed is not None:
        return blamed
    if process.signal is not None:
        return ended_by_signal(process, f"{ended} (signal {process.signal})", expected)
    return failed(
        "alive-at-end.ended",
        f"{ended} (exit code {process.exit})",
        expected,
        "The cause is often a loop that counts, a spin with a time limit, a callback that shuts rclpy down, or a "
        "missing rclpy.spin(node).",
        "Keep the node alive with rclpy.spin(node) until Ctrl-C, and shut rclpy down only after it.",
    )

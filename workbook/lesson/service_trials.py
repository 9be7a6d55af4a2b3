"""Run experiments for the lesson on services: a node with a heartbeat sends a request in various ways."""

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor

from workbook.lesson.programs import Program, arrivals, record
from workbook.pictures.palette import BLUE
from workbook.pictures.stills import Still
from workbook.pictures.timeline import Row, draw
from workbook.recording.recording import Recording

HEART, ASKED, ANSWERED = "/robot/heartbeat", "/robot/asked", "/robot/answered"
PERIODS = {HEART: 0.1, ASKED: 0.5, ANSWERED: 0.5}
SECONDS = 2.2
AT_ONCE = 3
"""The number of programs that run at the same time."""
GOES_ON_TO = 1.2
"""The heartbeat counts as stopped if its last message is at least this long (s) before the recording's end."""

Case = tuple[str, str, int]
"""The way that the node sends its request, its client's callback group, and its executor's number of threads."""


def try_out(program: Program, case: Case, **parameters: object) -> Recording:
    """Run a node that sends its request in the given way, and record it for about two seconds of real time.

    Extra `parameters` are passed to the node.
    """
    way, group, threads = case
    return record(
        program,
        PERIODS,
        seconds=SECONDS,
        clock="wall",
        way=way,
        group=group,
        threads=threads,
        **parameters,
    )


def try_all(program: Program, cases: Sequence[Case], **parameters: object) -> list[Recording]:
    """Run and record all cases, three at a time. Return the recordings in the order of the cases."""
    with ThreadPoolExecutor(AT_ONCE) as pool:
        return list(pool.map(lambda case: try_out(program, case, **parameters), cases))


def answers(recording: Recording) -> str:
    """Return "come" if the node received responses to its requests, and "never" if it didn't."""
    return "come" if len(arrivals(recording, ANSWERED)) >= 2 else "never"


def heart(recording: Recording) -> str:
    """Return "beats" if the heartbeat continues while a request waits, "limps" if most of it is missing, or "stops"."""
    beats, had = arrivals(recording, HEART), arrivals(recording, ANSWERED)
    if max(beats, default=0.0) < recording.watched_s - GOES_ON_TO:
        return "stops"
    waits = [(t, min([a for a in had if a > t], default=t + 0.4)) for t in arrivals(recording, ASKED)]
    due = sum(end - begin for begin, end in waits) / PERIODS[HEART]
    came = sum(begin < beat < end for begin, end in waits for beat in beats)
    return "limps" if due > 3 and came < 0.4 * due else "beats"


def hearts_picture(recordings: dict[str, Recording], title: str, description: str) -> Still:
    """Draw each recording's heartbeats as a row, labeled with the results of `heart` and `answers`."""
    rows = []
    for label, recording in recordings.items():
        goes, come = heart(recording), answers(recording)
        note = f"{'✓' if goes == 'beats' else '✗'} heart {goes}, {'✓' if come == 'come' else '✗'} responses {come}"
        rows.append(_heart_row(recording, label, note))
    return Still(draw(rows, end=SECONDS, title=title), description)


def questions_picture(recording: Recording, title: str, description: str) -> Still:
    """Draw one recording's heartbeats, requests, and responses."""
    asked, had = arrivals(recording, ASKED), arrivals(recording, ANSWERED)
    goes = heart(recording)
    rows = [
        _heart_row(recording, "heartbeats", f"{'✓' if goes == 'beats' else '✗'} heart {goes}"),
        Row("requests", asked, note=f"{len(asked)} asked", color=BLUE),
        Row("responses", had, note=f"{len(had)} answered", color=BLUE),
    ]
    return Still(draw(rows, end=SECONDS, title=title), description)


def _heart_row(recording: Recording, label: str, note: str) -> Row:
    beats = arrivals(recording, HEART)
    start = min(beats, default=0.0)
    return Row(label, beats, period=PERIODS[HEART], start=start, end=SECONDS, note=note, color=BLUE)

"""Record how messages and timer ticks reach their callbacks and play the recording in a lesson."""

import json
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from rclpy.node import Node

from workbook.inside import machine_tap
from workbook.inside.machine_tap import MachineTap
from workbook.lesson.programs import Program, program_file
from workbook.pictures.machine_film import MovingMachine, play
from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.recording.machine import MachineRecording, from_notes
from workbook.ros.scratch import remove_scratch, scratch_folder
from workbook.watching.observer import Observer

STARTS_WITHIN_S = 30.0
"""The longest time (s) that a program may take to start spinning on a busy machine."""
POLL_S = 0.02


@dataclass
class Seen:
    """Holds the recording of a `watch_machine` block. `recording` is None until the block has finished."""

    recording: MachineRecording | None = None


@contextmanager
def watch_machine(*nodes: Node) -> Iterator[Seen]:
    """Record how messages and timer ticks of these nodes reach their callbacks while the `with` block runs.

    The nodes belong to this notebook. After `with watch_machine(node) as seen:`, `show_machine(seen, ...)` plays the
    recording.
    """
    seen = Seen()
    with MachineTap(nodes) as tap:
        yield seen
    seen.recording = from_notes(tap.notes())


def record_machine(program: Program, seconds: float = 3.0, **parameters: object) -> MachineRecording:
    """Run a program in its own process and record how messages and timer ticks reach its node's callbacks.

    The recording begins when the node first spins, and lasts `seconds`. `parameters` are ROS parameters. `program` is a
    module or file of `lesson_nodes`. It needs a `main()`, and its node needs the file's name. Raise RuntimeError with
    the program's log if the program exits early or never spins.
    """
    file = program_file(program)
    folder = scratch_folder("machine")
    notes = folder / "notes.json"
    try:
        driver = Path(machine_tap.__file__)
        spec = ProgramSpec(file, [str(notes), str(seconds), file.stem], parameters=parameters, driver=driver)
        with Observer() as observer, NodeProcess(spec, observer.domain_id) as process:
            deadline = time.monotonic() + seconds + STARTS_WITHIN_S
            while not notes.exists() and not process.wait(POLL_S) and time.monotonic() < deadline:
                pass
            process.stop()
            if process.killed:
                observer.move()
            if not notes.exists():
                raise RuntimeError(f"nothing was recorded from {file.name}:\n{process.record().log.strip()}")
        return from_notes(json.loads(notes.read_text(encoding="utf-8")))
    finally:
        remove_scratch(folder)


def show_machine(
    seen: Seen | MachineRecording, description: str, begin: float = 0.0, end: float | None = None
) -> None:
    """Play a recording in the cell, from `begin` to `end` (s), or to the recording's end if `end` is None.

    `description` is the alternative text. Keep measured numbers out of it, because they vary from run to run.
    """
    from IPython.display import display

    display(film_of(seen, description, begin, end))


def film_of(
    seen: Seen | MachineRecording, description: str, begin: float = 0.0, end: float | None = None
) -> MovingMachine:
    """Return the film that `show_machine` shows. Raise RuntimeError if the `watch_machine` block hasn't finished."""
    recording = seen.recording if isinstance(seen, Seen) else seen
    if recording is None:
        raise RuntimeError("the watch_machine block hasn't ended yet: show its recording after the block")
    return play(recording, description, begin, end)

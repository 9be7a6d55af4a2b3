"""Starts an answer before the judge is loaded: both take a third of a second, and side by side only one does.

Imports nothing that needs ROS, so that it can run first.
"""

from pathlib import Path

from workbook.exercise.answers import Answer
from workbook.exercise.source import ExerciseSource
from workbook.observing.process import NodeProcess, ros_arguments
from workbook.ros.domains import lease_domain
from workbook.ros.environment import prepare
from workbook.ros.scratch import remove_scratch, scratch_folder


def write_program(folder: Path, stem: str, answer: Answer) -> Path:
    """Put the answer as a program file into `folder`."""
    program = folder / f"{stem}.py"
    program.write_text(answer.text, encoding="utf-8")
    return program


class StartedAnswer:
    """An answer that runs on a leased domain and waits to be watched, on the clock that its exercise starts with.

    Leaving the block ends what nobody has taken over.
    """

    def __init__(self, source: ExerciseSource, answer: Answer) -> None:
        self.lease = lease_domain()
        prepare(domain_id=self.lease.domain_id)
        self.folder = scratch_folder("answer")
        program = write_program(self.folder, source.stem, answer)
        parameters = {"use_sim_time": True} if source.clock == "simulated" else {}
        self.process = NodeProcess(program, self.lease.domain_id, ros_arguments(parameters))

    def __enter__(self) -> "StartedAnswer":
        return self

    def __exit__(self, *_: object) -> None:
        self.process.stop()
        remove_scratch(self.folder)
        self.lease.release()

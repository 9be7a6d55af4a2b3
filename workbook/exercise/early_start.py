"""Start an answer before importing the judge.

Starting the answer and importing the judge each take a third of a second, and in this order, they overlap.

This module imports nothing that needs ROS, so it can run first.
"""

from pathlib import Path

from workbook.exercise.answers import Answer, domains_named
from workbook.exercise.source import ExerciseSource, driver_of
from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.ros.domains import lease_domain
from workbook.ros.environment import prepare
from workbook.ros.scratch import remove_scratch, scratch_folder


def write_program(folder: Path, stem: str, answer: Answer) -> Path:
    """Write the answer to `folder` as a program file, and return its path."""
    program = folder / f"{stem}.py"
    program.write_text(answer.text, encoding="utf-8")
    return program


class StartedAnswer:
    """An answer that runs on a leased domain and waits to be watched.

    If an exercise is judged on the wall clock from the start, the program isn't started yet (`process` is None). So the
    judge can watch the program from its start. Leaving the `with` block stops the program and releases the domain.
    """

    def __init__(self, source: ExerciseSource, answer: Answer) -> None:
        self.lease = lease_domain(avoid=domains_named(answer.text))
        prepare(domain_id=self.lease.domain_id)
        self.folder = scratch_folder("answer")
        self.process: NodeProcess | None = None
        if source.clock == "simulated":
            program = write_program(self.folder, source.stem, answer)
            spec = ProgramSpec(program, driver=driver_of(source.path))
            self.process = NodeProcess(spec, self.lease.domain_id)

    def __enter__(self) -> "StartedAnswer":
        return self

    def __exit__(self, *_: object) -> None:
        if self.process is not None:
            self.process.stop()
        remove_scratch(self.folder)
        self.lease.release()

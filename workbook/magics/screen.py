"""Read the answer cell's text from the screen, even if the cell hasn't been run, and put an answer on the screen.

JupyterLab sends the text with each cell that runs (workbook/lab/front_end/answers.js). With other front ends, the
version that was run is judged, and we compare it with the saved notebook.
"""

import os
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from workbook.exercise.answer_files import answer_file, same_program
from workbook.exercise.answers import ANSWER_MAGIC, Ungradable, answer_in_notebook, means, named_exercise

ANSWER_PAYLOAD = "workbook_answer"
STARTED_PAYLOAD = "workbook_started"


@dataclass(frozen=True)
class Version:
    """The version of an answer that was run, for use if we can't read the screen.

    `ran_at`: the time at which the student ran it, as text. `differs`: whether the notebook was saved later with a
    different answer.
    """

    ran_at: str
    differs: bool = False

    def line(self, doing: str) -> str:
        """Return a sentence or two for the student, such as "Judging the version you ran at 14:03."."""
        said = f"{doing} the version you ran {self.ran_at}."
        if self.differs:
            said += " The saved notebook contains a different version: run its answer cell first."
        return said


def answers_on_screen(request: Any) -> list[tuple[str, str]] | None:
    """Return the exercise name and program of each answer cell, or None if the front end doesn't send the cells.

    The cells are in order from top to bottom. `request` is the message that requested the running cell.
    """
    told = request.get("metadata", {}).get("workbook") if isinstance(request, dict) else None
    sources = told.get("answers") if isinstance(told, dict) else None
    if not isinstance(sources, list):
        return None
    found = []
    for source in sources:
        if not isinstance(source, str):
            continue
        first, _, program = source.lstrip("\n \t").partition("\n")
        name = named_exercise(first)
        if name is not None:
            found.append((name, program))
    return found


def answer_on_screen(request: Any, stem: str) -> str | None:
    """Return the program in the last answer cell of an exercise.

    The result is None if there is no such cell, or if the front end doesn't send the cells.
    """
    fitting = [program for name, program in answers_on_screen(request) or [] if means(name, stem)]
    return fitting[-1] if fitting else None


def version_that_ran(stem: str, names: dict[str, Any]) -> Version:
    """Describe the version in the answer file.

    `names`: the kernel's variables. They're needed because VS Code stores the notebook's path in one of them.
    """
    file = answer_file(stem)
    moment = file.stat().st_mtime
    ran = time.localtime(moment)
    today = time.localtime()[:3] == ran[:3]
    ran_at = time.strftime("at %H:%M" if today else "on %Y-%m-%d at %H:%M", ran)
    notebook = Path(str(names.get("__vsc_ipynb_file__") or os.environ.get("JPY_SESSION_NAME", "")))
    if notebook.suffix != ".ipynb":
        return Version(ran_at)
    try:
        if notebook.stat().st_mtime < moment:
            return Version(ran_at)
        saved = answer_in_notebook(notebook, stem).text
    except (OSError, Ungradable):
        return Version(ran_at)
    return Version(ran_at, not same_program(saved, file.read_text(encoding="utf-8", errors="replace")))


def put_on_screen(shell: Any, request: Any, stem: str, program: str) -> None:
    """Put `program` into the answer cell or, if that isn't possible, into a new cell below."""
    if answer_on_screen(request, stem) is None:
        shell.set_next_input(f"{ANSWER_MAGIC} {stem}\n{program.rstrip()}", replace=False)
        return
    names = sorted({name for name, _ in answers_on_screen(request) or [] if means(name, stem)})
    write: Callable[..., None] = shell.payload_manager.write_payload
    write({"source": ANSWER_PAYLOAD, "exercises": names, "text": program.rstrip()})


def offer_panel(shell: Any) -> None:
    """Have JupyterLab open the robot panel, which it does only for the first program started in each browser tab."""
    shell.payload_manager.write_payload({"source": STARTED_PAYLOAD})

"""Run mypy from a notebook and show its findings on a program line by line."""

import threading
from collections.abc import Iterator, Mapping, Set
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

from workbook.criteria.vocabulary.phrasing import count
from workbook.exercise.answer_files import answer_file
from workbook.exercise.source import STEM
from workbook.lesson.predictions import unattended
from workbook.pictures.figures import figure, still
from workbook.pictures.palette import AMBER, GREEN, GREY, RED
from workbook.pictures.stills import Still
from workbook.recording.recording import Finding
from workbook.typechecking.typecheck import BARE, NOTE, SETTINGS, TYPINGS, MypyOptions, type_check

_STRICT = ("--strict",)
SILENT_AT_MOST_S = 1.5
"""If mypy takes longer than this (s), a line says that it's running."""


@dataclass(frozen=True)
class TypeReport:
    """mypy's findings on a program, formatted for a cell."""

    program: str
    findings: tuple[Finding, ...]

    @property
    def lines(self) -> tuple[int, ...]:
        """The numbers of the lines with errors, each once."""
        return tuple(sorted({finding.line for finding in self.findings if finding.code != NOTE}))

    def __len__(self) -> int:
        """Return the number of lines with errors."""
        return len(self.lines)

    def __repr__(self) -> str:
        text = self.program.splitlines()
        shown = [f"mypy: {count(len(self), 'line')} with a mistake" if len(self) else "mypy: nothing found"]
        last = -1
        for finding in self.findings:
            if finding.line != last:
                source = text[finding.line - 1].strip() if 0 < finding.line <= len(text) else ""
                shown.append(f"line {finding.line}: {source}".rstrip(": "))
            last = finding.line
            shown.append(f"    {finding.message}" + ("" if finding.code == NOTE else f" [{finding.code}]"))
        return "\n".join(shown)


def check_types(
    program: str | Path | ModuleType, *, stubs: bool = True, strict: bool = True, notes: bool = False
) -> TypeReport:
    """Check a program with mypy and return its findings.

    `program`: the program's source text, the path of its file, a module, or the name of an exercise, whose answer is
    then checked. `stubs`: use the course's stubs for message packages (`workbook/typings`), rather than only the
    installed ROS packages. `strict`: every function must be annotated; with stubs, explicit Any isn't allowed either.
    `notes`: also show the output of `reveal_type`.
    """
    text = _text_of(program)
    if stubs:
        settings = (f"--config-file={SETTINGS}",) if strict else BARE
    else:
        settings = ("--config-file=", *(_STRICT if strict else ()))
    with _waiting_line():
        return TypeReport(text, type_check(text, options=MypyOptions(settings, stubs, notes)))


@contextmanager
def _waiting_line() -> Iterator[None]:
    """Print a line if mypy takes long, as its first run does, because it reads rclpy. Builds don't print the line."""
    if unattended():
        yield
        return
    timer = threading.Timer(
        SILENT_AT_MOST_S, print, ["mypy is running. Its first run reads rclpy, too: up to 20 s."]
    )
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()


def _text_of(program: str | Path | ModuleType) -> str:
    if isinstance(program, ModuleType):
        if program.__file__ is None:
            raise ValueError(f"{program.__name__} has no file that could be read")
        program = Path(program.__file__)
    elif isinstance(program, str) and STEM.fullmatch(program):
        program = answer_file(program)
    return program.read_text(encoding="utf-8") if isinstance(program, Path) else program


def stub_of(message_class: type) -> str:
    """Return the class declaration of a message class, such as `Float32`, from the course's stubs."""
    package, kind = message_class.__module__.split(".")[:2]
    stub = (TYPINGS / package / kind / "__init__.pyi").read_text(encoding="utf-8")
    name = message_class.__name__
    return f"class {name}:\n" + stub.partition(f"\nclass {name}:\n")[2].partition("\nclass ")[0].rstrip()


def nets_picture(
    nets: Mapping[str, Set[int]], names: Mapping[int, str], description: str, *, title: str
) -> Still:
    """Draw which check catches which mistake.

    `nets`: for each check, the numbers of the mistakes that it catches. `names`: the mistakes, by number. A check with
    "run time" in its name sees only lines that run.
    """
    fig, axes = figure(7.6, 1.0 + 0.37 * len(names))
    for column, (net, caught) in enumerate(nets.items()):
        late = "run time" in net
        words = ("raises", "silent") if late else ("found", "missed")
        for number in names:
            is_caught = number in caught
            color = RED if not is_caught else AMBER if late else GREEN
            fill = "full" if is_caught else "none"
            axes.plot(column, number, "o", markersize=14, color=color, fillstyle=fill)
            axes.annotate(
                words[not is_caught],
                (column, number),
                (11, 0),
                textcoords="offset points",
                va="center",
                fontsize=8,
            )
    before = sum("run time" not in net for net in nets)
    axes.text((before - 1) / 2 + 0.1, 0.25, "before anything runs", ha="center", fontsize=9)
    if before < len(nets):
        axes.axvline(before - 0.38, color=GREY, linestyle="--", linewidth=1)
        axes.text(
            (before + len(nets) - 1) / 2 + 0.1, 0.25, "once the line is reached", ha="center", fontsize=9
        )
    axes.set_yticks(list(names), [f"{number}  {name}" for number, name in names.items()])
    axes.set_xticks(range(len(nets)), list(nets))
    axes.set(ylim=(max(names) + 0.6, -0.1), xlim=(-0.4, len(nets) - 0.4))
    axes.set_title(title, fontsize=11)
    axes.tick_params(length=0)
    axes.grid(False)
    return still(fig, description)

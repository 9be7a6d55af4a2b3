"""mypy from a notebook: what it says of a program, line by line, without running it."""

from collections.abc import Mapping, Set
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

from workbook.criteria.vocabulary.phrasing import count
from workbook.exercise.answer_files import answer_file
from workbook.exercise.source import STEM
from workbook.pictures.figures import figure, still
from workbook.pictures.palette import AMBER, GREEN, GREY, RED
from workbook.pictures.stills import Still
from workbook.recording.recording import Finding
from workbook.typechecking.typecheck import BARE, NOTE, SETTINGS, TYPINGS, MypyOptions, type_check

_STRICT = ("--strict",)


@dataclass(frozen=True)
class TypeReport:
    """What mypy found, as a cell shows it."""

    program: str
    findings: tuple[Finding, ...]

    @property
    def lines(self) -> tuple[int, ...]:
        """The lines in which mypy finds something wrong, each once."""
        return tuple(sorted({finding.line for finding in self.findings if finding.code != NOTE}))

    def __len__(self) -> int:
        """How many lines that are."""
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
    """Let mypy read a program: its text, its file, a module, or your answer to an exercise by the name of that.

    `stubs`: with the stubs of the course for message packages (`workbook/typings`); without, plain mypy on what ROS
    installs. `strict`: every function has to be annotated; with stubs, Any may not be written either. `notes`: show
    what `reveal_type` says, too.
    """
    text = _text_of(program)
    if stubs:
        settings = (f"--config-file={SETTINGS}",) if strict else BARE
    else:
        settings = ("--config-file=", *(_STRICT if strict else ()))
    return TypeReport(text, type_check(text, options=MypyOptions(settings, stubs, notes)))


def _text_of(program: str | Path | ModuleType) -> str:
    if isinstance(program, ModuleType):
        if program.__file__ is None:
            raise ValueError(f"{program.__name__} has no file that could be read")
        program = Path(program.__file__)
    elif isinstance(program, str) and STEM.fullmatch(program):
        program = answer_file(program)
    return program.read_text(encoding="utf-8") if isinstance(program, Path) else program


def stub_of(message_class: type) -> str:
    """What the stubs of the course say of a message, such as `Float32`."""
    package, kind = message_class.__module__.split(".")[:2]
    stub = (TYPINGS / package / kind / "__init__.pyi").read_text(encoding="utf-8")
    name = message_class.__name__
    return f"class {name}:\n" + stub.partition(f"\nclass {name}:\n")[2].partition("\nclass ")[0].rstrip()


def nets_picture(
    nets: Mapping[str, Set[int]], names: Mapping[int, str], description: str, *, title: str
) -> Still:
    """Which net catches which mistake. A net with "run time" in its name catches when the line is reached."""
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

"""Pages that are made from the lessons: the error museum, the glossary, and the list of lessons."""

import json
import re
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

from workbook.authoring.tree import Tree
from workbook.exercise.museum import Exhibit, Museum, load_museum
from workbook.exercise.source import SourceError, load

MUSEUM, GLOSSARY, LIST = "error_museum.md", "glossary.md", "README.md"
PAGES = (MUSEUM, GLOSSARY, LIST)
RUN_TIMES = "run_times.json"
_MINUTES = re.compile(r"\*\*Minutes:\*\* (\d+)")


def pages(tree: Tree) -> dict[Path, str]:
    """Every page with what it must hold."""
    museum = load_museum(tree.root)
    return {
        tree.notebooks / MUSEUM: museum_page(tree, museum),
        tree.notebooks / GLOSSARY: glossary_page(tree, museum),
        tree.notebooks / LIST: list_page(tree),
    }


def write_pages(tree: Tree) -> list[Path]:
    """Bring the pages up to date. Returns those that changed."""
    changed = []
    for path, text in pages(tree).items():
        if not path.is_file() or path.read_text(encoding="utf-8") != text:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
            changed.append(path)
    return changed


def title_of(tree: Tree, stem: str) -> str:
    """The title of a lesson, such as "05 · Timers"."""
    for line in (tree.sources / f"{stem}.py").read_text(encoding="utf-8").splitlines():
        if line.startswith("# # "):
            return line[4:].strip()
    return stem


def _link(tree: Tree, stem: str) -> str:
    return f"[{title_of(tree, stem)}]({stem}.ipynb)"


def _sign(exhibit: Exhibit) -> str:
    """The symptom as code when it is a text of Python, as words when it is a silence."""
    looks_printed = re.match(r"[\w.]*(Error|Exception|Warning|Interrupt|Handle|Iteration)\b", exhibit.symptom)
    return f"`{exhibit.symptom}`" if looks_printed and "`" not in exhibit.symptom else exhibit.symptom


def museum_page(tree: Tree, museum: Museum) -> str:
    """Symptom, cause, fix; lesson by lesson."""
    lines = [
        "# The error museum",
        "",
        "Everything here really happens: each error and each silence is provoked by a cell of the lesson that it hangs",
        "in. Search this page for a piece of your message (Ctrl-F), read the cause, try the fix.",
        "",
    ]
    for stem in dict.fromkeys(exhibit.lesson for exhibit in museum.exhibits):
        lines += [f"## {title_of(tree, stem)}", ""]
        for exhibit in museum.exhibits:
            if exhibit.lesson == stem:
                lines += [
                    f"### {_sign(exhibit)}",
                    "",
                    f"**Cause.** {exhibit.cause}",
                    "",
                    f"**Fix.** {exhibit.fix}",
                    "",
                    f"Seen in {_link(tree, stem)}, cell `{exhibit.cell}`.",
                    "",
                ]
    return "\n".join(lines).rstrip() + "\n"


def glossary_page(tree: Tree, museum: Museum) -> str:
    """All terms, from a to z, with the lesson that introduces them."""
    lines = [
        "# Glossary",
        "",
        "The words of ROS 2 as the lessons use them, and where each one comes up first.",
        "",
    ]
    for term in sorted(museum.terms, key=lambda one: one.name.casefold()):
        lines += [f"- **{term.name}** · {term.meaning} {_link(tree, term.lesson)}"]
    return "\n".join(lines).rstrip() + "\n"


def list_page(tree: Tree) -> str:
    """The lessons in order: minutes, exercise, and how long the cells of a lesson run."""
    times = run_times(tree)
    lines = [
        "# The lessons",
        "",
        "Take them in this order. *You* is the time that a lesson takes a reader, *cells* what its code takes when all",
        f"of it runs. Words that are new: the [glossary]({GLOSSARY}). Something fails: the [error museum]({MUSEUM}).",
        "",
        "| lesson | you | cells | exercise |",
        "|---|---:|---:|---|",
    ]
    exercises = {}
    for stem in tree.exercise_stems():
        with suppress(SourceError):  # told when the exercise itself is built
            exercises[stem] = load(tree.solutions / f"{stem}.py")
    for stem in tree.lesson_stems():
        found = _MINUTES.search((tree.sources / f"{stem}.py").read_text(encoding="utf-8"))
        minutes = f"{found[1]} min" if found else ""
        cells = f"{times[stem]} s" if stem in times else ""
        exercise = ""
        if stem in exercises:
            one = exercises[stem]
            exercise = f"[{one.title}](../exercises/{stem}.ipynb), {one.minutes} min"
        lines.append(f"| {_link(tree, stem)} | {minutes} | {cells} | {exercise} |")
    return "\n".join(lines) + "\n"


def run_times(tree: Tree) -> dict[str, int]:
    """How long the cells of each lesson ran when it was last measured, in s."""
    path = tree.sources / RUN_TIMES
    if not path.is_file():
        return {}
    times: dict[str, int] = json.loads(path.read_text(encoding="utf-8"))
    return times


def note_run_times(tree: Tree, measured: dict[str, float]) -> None:
    """Keep measured times (s), rounded to five seconds: the next run will not be the same to the second."""
    times = run_times(tree) | {stem: max(5, 5 * round(seconds / 5)) for stem, seconds in measured.items()}
    known = {stem: times[stem] for stem in sorted(times) if stem in tree.lesson_stems()}
    (tree.sources / RUN_TIMES).write_text(json.dumps(known, indent=1) + "\n", encoding="utf-8")


def museum_problems(tree: Tree, museum: Museum) -> Iterator[tuple[str, str]]:
    """Exhibits that no cell shows, and terms that are explained twice: file name and words."""
    outputs: dict[str, dict[str, str]] = {}
    for exhibit in museum.exhibits:
        name = f"{exhibit.lesson}.toml"
        if exhibit.lesson not in outputs:
            outputs[exhibit.lesson] = _outputs(tree.notebooks / f"{exhibit.lesson}.ipynb")
        cells = outputs[exhibit.lesson]
        if exhibit.cell not in cells:
            yield name, f"the lesson has no code cell {exhibit.cell!r}"
        elif exhibit.shows not in cells[exhibit.cell]:
            yield name, f"cell {exhibit.cell!r} does not show {exhibit.shows!r}"
    first: dict[str, str] = {}
    for term in museum.terms:
        key = term.name.casefold()
        if key in first:
            yield f"{term.lesson}.toml", f"the term {term.name!r} is explained in {first[key]} already"
        first.setdefault(key, term.lesson)


def _outputs(path: Path) -> dict[str, str]:
    """What each code cell of a built lesson shows as text."""
    if not path.is_file():
        return {}
    found = {}
    for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]:
        if cell["cell_type"] == "code":
            found[cell["id"]] = "\n".join(map(_text, cell["outputs"]))
    return found


def _text(output: dict[str, object]) -> str:
    if output["output_type"] == "stream":
        return _joined(output["text"])
    if output["output_type"] == "error":
        return f"{output['ename']}: {output['evalue']}"
    data = output.get("data")
    assert isinstance(data, dict)
    return _joined(data.get("text/plain", "")) + "\n" + _joined(data.get("text/markdown", ""))


def _joined(text: object) -> str:
    return "".join(map(str, text)) if isinstance(text, list) else str(text)

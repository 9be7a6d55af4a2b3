"""Generate the pages of the error museum and the glossary from `notebooks/sources/museum`."""

import json
import re
from collections.abc import Iterator
from pathlib import Path

from workbook.authoring.lesson_links import lesson_link, title_of
from workbook.authoring.tree import Tree
from workbook.exercise.museum import Exhibit, Museum

MUSEUM, GLOSSARY = "error_museum.md", "glossary.md"


def is_printed(symptom: str) -> bool:
    """Return whether a symptom is a message that Python or ROS prints, rather than a description in words."""
    return bool(re.match(r"[\w.]*(Error|Exception|Warning|Interrupt|Handle|Iteration)\b", symptom))


def _sign(exhibit: Exhibit) -> str:
    """Return the symptom for a heading: as code if Python or ROS prints it, otherwise unchanged."""
    is_code = is_printed(exhibit.symptom) and "`" not in exhibit.symptom
    return f"`{exhibit.symptom}`" if is_code else exhibit.symptom


def museum_page(tree: Tree, museum: Museum) -> str:
    """Return the museum page: each exhibit's symptom, cause, and fix, grouped by lesson."""
    lines = [
        "# The error museum",
        "",
        "Everything on this page really happens: a cell of the named lesson causes each error and each silence. Search",
        "the page (Ctrl-F) for a part of your message, read the cause, and try the fix.",
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
                    f"Seen in {lesson_link(tree, stem)}, cell `{exhibit.cell}`.",
                    "",
                ]
    return "\n".join(lines).rstrip() + "\n"


def glossary_page(tree: Tree, museum: Museum) -> str:
    """Return the glossary page: all terms in alphabetical order, each with the lesson that introduces it."""
    lines = [
        "# Glossary",
        "",
        "ROS 2 terms as this course uses them. Each one links to the lesson that introduces it.",
        "",
    ]
    for term in sorted(museum.terms, key=lambda one: one.name.casefold()):
        lines += [f"- **{term.name}** · {term.meaning} {lesson_link(tree, term.lesson)}"]
    return "\n".join(lines).rstrip() + "\n"


def museum_violations(tree: Tree, museum: Museum) -> Iterator[tuple[str, str]]:
    """Yield a file name and message for each exhibit missing in its cell's output, and each term explained twice."""
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
    """Return the text output of each code cell in a built lesson, keyed by cell ID.

    The dictionary is empty if there is no notebook.
    """
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

"""Finds what is stale, misplaced, missing or against the rules, without running anything."""

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

from workbook.authoring import document, template
from workbook.authoring.exercise import read_exercise, starter_document
from workbook.authoring.lesson import read_lesson
from workbook.authoring.outputs import texts
from workbook.authoring.pages import PAGES, RUN_TIMES, museum_problems, pages
from workbook.authoring.tree import AuthoringError, Tree, entries
from workbook.exercise.definition import Exercise
from workbook.exercise.museum import BrokenMuseum, load_museum
from workbook.exercise.source import STEM
from workbook.feedback.wording import points

IGNORE_OUTPUT = "nbval-ignore-output"
LARGEST_IGNORED_SHARE = 1 / 3
NOT_COMPARED = ("image/png", "image/jpeg", "application/vnd.jupyter.widget-view+json")
FEWEST_ANSWERS = {"right": 3, "wrong": 5}
FEWEST_ANSWERS_OF = {"09_joint_positions": {"right": 10, "wrong": 25}}
_MARKERS = re.compile(
    r"^\s*#.*\b(NBVAL_IGNORE_OUTPUT|NBVAL_CHECK_OUTPUT|NBVAL_SKIP|NBVAL_RAISES_EXCEPTION|"
    r"PYTEST_VALIDATE_IGNORE_OUTPUT)\b",
    re.MULTILINE,
)
_CODE = re.compile(r"(`+).+?\1", re.DOTALL)
_LINK = re.compile(r"(?P<image>!?)\[(?P<text>[^\]]*)\]\(\s*(?P<target>[^)\s]+)[^)]*\)")


@dataclass(frozen=True)
class Problem:
    """One thing to mend, in the file `where` (relative to the course)."""

    where: str
    words: str

    def __str__(self) -> str:
        return f"{self.where}: {self.words}"


def check(tree: Tree) -> list[Problem]:
    """All that is wrong with the lessons and exercises of a course. Empty when nothing is."""
    found: list[Problem] = []
    found += misplaced(tree)
    for stem in tree.lesson_stems():
        found += check_lesson(tree, stem)
    for stem in tree.exercise_stems():
        found += check_exercise(tree, stem)
    found += check_pages(tree)
    return found


def check_pages(tree: Tree) -> Iterator[Problem]:
    """The museum and the pages that are made from the lessons."""
    try:
        museum = load_museum(tree.root)
        yield from (
            Problem(tree.name(tree.museum / name), words) for name, words in museum_problems(tree, museum)
        )
        for path, text in pages(tree).items():
            if not path.is_file() or path.read_text(encoding="utf-8") != text:
                yield Problem(tree.name(path), "is not what the lessons say: run `make notebooks`")
    except BrokenMuseum as error:
        yield Problem(tree.name(tree.museum), str(error))


def check_lesson(tree: Tree, stem: str) -> Iterator[Problem]:
    """One lesson: its shape, its notebook and what that shows."""
    text_name = f"notebooks/sources/{stem}.py"
    try:
        wanted = read_lesson(tree, stem)
    except AuthoringError as error:
        yield Problem(text_name, str(error).removeprefix(f"{text_name}").lstrip(":, "))
        return
    number = int(stem[:2])
    has_exercise = any(other.startswith(stem[:3]) for other in tree.exercise_stems())
    for words in template.problems(wanted.cells, number, has_exercise=has_exercise):
        yield Problem(text_name, words)
    for words in _next_lesson(tree, stem, wanted):
        yield Problem(text_name, words)
    for words in compared_enough(wanted):
        yield Problem(text_name, words)
    for words in dead_links(tree, tree.notebooks, wanted):
        yield Problem(text_name, words)
    target = tree.notebooks / f"{stem}.ipynb"
    name = tree.name(target)
    yield from _compare(tree, target, wanted)
    if target.is_file():
        try:
            built = document.read(target)
        except ValueError:
            return
        yield from (Problem(name, words) for words in outputs_in_order(built))


def check_exercise(tree: Tree, stem: str) -> Iterator[Problem]:
    """One exercise: its source, its criteria, its notebook and the answers that prove it."""
    source_name = f"solutions/{stem}.py"
    try:
        exercise = read_exercise(tree, stem)
    except AuthoringError as error:
        yield Problem(source_name, str(error).removeprefix(f"{source_name}:"))
    else:
        yield from (Problem(source_name, words) for words in _story_tells(exercise))
        text = exercise.solution_path.read_text(encoding="utf-8")
        yield from (Problem(source_name, words) for words in _unwritten(text))
        wanted = starter_document(tree, exercise)
        yield from (Problem(source_name, words) for words in dead_links(tree, tree.exercises, wanted))
        yield from _compare(tree, tree.exercises / f"{stem}.ipynb", wanted)
    criteria = tree.criteria / f"{stem}.py"
    if criteria.is_file():
        text = criteria.read_text(encoding="utf-8")
        yield from (Problem(tree.name(criteria), words) for words in _unwritten(text))
    if not any(other.startswith(stem[:3]) for other in tree.lesson_stems()):
        yield Problem(source_name, f"no lesson {stem[:2]} leads to this exercise")
    yield from _answers(tree, stem)


def misplaced(tree: Tree) -> Iterator[Problem]:
    """Files that fit nowhere, and notebooks without a text."""
    lessons, exercises = tree.lesson_stems(), tree.exercise_stems()
    rules: list[tuple[Path, str, tuple[str, ...], tuple[str, ...]]] = [
        (tree.notebooks, ".ipynb", lessons, ("sources", *PAGES)),
        (tree.sources, ".py", lessons, ("museum", RUN_TIMES)),
        (tree.museum, ".toml", lessons, ()),
        (tree.exercises, ".ipynb", exercises, ("criteria", "drivers", "README.md")),
        (tree.drivers, ".py", exercises, ()),
        (tree.criteria, ".py", exercises, ("__init__.py", "conftest.py")),
        (tree.solutions, ".py", exercises, ("__init__.py",)),
        (tree.right_answers, "", exercises, ()),
        (tree.wrong_answers, "", exercises, ()),
    ]
    for stems, folder in ((lessons, tree.sources), (exercises, tree.solutions)):
        for one, other in pairwise(stems):
            if one[:2] == other[:2]:
                yield Problem(tree.name(folder / f"{other}.py"), f"number {one[:2]} is taken by {one}")
    for folder, suffix, stems, others in rules:
        for path in entries(folder):
            if path.name in others:
                continue
            if path.suffix != suffix or not STEM.fullmatch(path.stem):
                form = f"NN_slug{suffix}" if suffix else "folders NN_slug"
                yield Problem(tree.name(path), f"fits nowhere: {tree.name(folder)}/ holds {form} only")
            elif path.stem not in stems:
                home = "notebooks/sources" if stems is lessons else "solutions"
                yield Problem(tree.name(path), f"has no text: {home}/{path.stem}.py is missing")


def compared_enough(wanted: document.Document) -> Iterator[str]:
    """Rules on outputs that nbval is told to ignore."""
    code = [cell for cell in wanted.cells if cell.kind == "code"]
    for cell in code:
        found = _MARKERS.search(cell.source)
        if found:
            yield f"cell {cell.id}: write a tag instead of the comment {found[1]}"
    ignored = [cell for cell in code if IGNORE_OUTPUT in cell.tags]
    if len(ignored) > len(code) * LARGEST_IGNORED_SHARE:
        yield f"{len(ignored)} of {len(code)} code cells ignore their output; a third is the most"
    waiting: document.Cell | None = None
    for cell in code:
        if cell not in ignored:
            waiting = None
        elif waiting is not None:
            yield f"{_unstated(waiting)} before the next one, {cell.id}"
            waiting = cell
        else:
            waiting = cell
    if waiting is not None:
        yield _unstated(waiting)


def outputs_in_order(built: document.Notebook) -> Iterator[str]:
    """Rules on what a built lesson shows."""
    code = [cell for cell in built.cells if cell.cell_type == "code"]
    if [cell.execution_count for cell in code] != list(range(1, len(code) + 1)):
        yield "was not run from top to bottom: run `make notebooks`"
        return
    waiting = None
    for cell in code:
        tags = cell.metadata.get("tags", [])
        kinds = [kind for output in cell.outputs for kind in _kinds(output)]
        if "error" in kinds and "raises-exception" not in tags:
            yield f"cell {cell.id} shows an error without the tag raises-exception"
        if "error" not in kinds and "raises-exception" in tags:
            yield f"cell {cell.id} is tagged raises-exception, but raised none"
        yield from _pictures(cell)
        if IGNORE_OUTPUT in tags:
            waiting = cell
        elif waiting is not None and any(kind not in NOT_COMPARED for kind in kinds):
            waiting = None
    if waiting is not None:
        yield f"after cell {waiting.id}, whose output is ignored, no compared cell shows anything"
    if not any(
        kind.startswith(("image/", "text/html")) for cell in code for o in cell.outputs for kind in _kinds(o)
    ):
        yield "shows no picture: a lesson has at least one that moves or explains"


def dead_links(tree: Tree, folder: Path, wanted: document.Document) -> Iterator[str]:
    """Links to files that are not there, and pictures without alternative text."""
    for cell in wanted.cells:
        if cell.kind != "markdown":
            continue
        for link in _LINK.finditer(_CODE.sub("", cell.source)):
            target = link["target"].split("#", 1)[0]
            if link["image"] and not link["text"].strip():
                yield f"cell {cell.id}: the picture {target} has no alternative text"
            if not target or re.match(r"[a-z]+:", target):
                continue
            path = (folder / target).resolve()
            named = tree.sources if path.parent == tree.notebooks.resolve() else tree.solutions
            known = path.suffix == ".ipynb" and (named / f"{path.stem}.py").is_file()
            if not known and not path.exists():
                yield f"cell {cell.id}: the link to {target} leads nowhere"


def _unstated(cell: document.Cell) -> str:
    return f"after cell {cell.id}, whose output is ignored, a compared cell must state what it showed"


def _kinds(output: document.Notebook) -> list[str]:
    if output.output_type in ("stream", "error"):
        return [output.output_type]
    return list(output.data)


def _pictures(cell: document.Notebook) -> Iterator[str]:
    for output in cell.outputs:
        if not any(kind.startswith("image/") for kind in _kinds(output)):
            continue
        described = [text for text in texts(output) if not text.lstrip().startswith("<")]
        if not described:
            yield f"cell {cell.id}: its picture has no text/plain that says what it shows"


def _compare(tree: Tree, target: Path, wanted: document.Document) -> Iterator[Problem]:
    name = tree.name(target)
    if not target.is_file():
        yield Problem(name, "is not built: run `make notebooks`")
        return
    try:
        built = document.read(target)
    except ValueError as error:
        yield Problem(name, str(error))
        return
    for words in differences(document.without_outputs(built), document.as_notebook(wanted)):
        yield Problem(name, f"{words}: run `make notebooks`")


def differences(built: document.Notebook, wanted: document.Notebook) -> Iterator[str]:
    """How a built notebook differs from what its text generates; outputs aside."""
    ids, wanted_ids = [cell.get("id") for cell in built.cells], [cell.id for cell in wanted.cells]
    if ids != wanted_ids:
        extra = [str(one) for one in ids if one not in wanted_ids]
        lacking = [one for one in wanted_ids if one not in ids]
        told = [f"has {', '.join(extra)}" * bool(extra), f"lacks {', '.join(lacking)}" * bool(lacking)]
        yield f"cell ids differ from the text ({'; '.join(filter(None, told)) or 'other order'})"
    by_id = {cell.id: cell for cell in wanted.cells}
    for cell in built.cells:
        other = by_id.get(cell.get("id"))
        if other is None:
            continue
        if (cell.cell_type, cell.source) != (other.cell_type, other.source):
            yield f"cell {cell.id} differs from the text"
        elif cell.metadata.get("tags", []) != other.metadata.get("tags", []):
            yield f"cell {cell.id} has other tags than the text"
        elif dict(cell.metadata) != dict(other.metadata):
            yield f"cell {cell.id} has metadata that the text does not give"
    if dict(built.metadata) != dict(wanted.metadata):
        mine, theirs = (dict(n.metadata.get("workbook", {})) for n in (built, wanted))
        hashes = mine.pop("source_sha256", None), theirs.pop("source_sha256", None)
        rest_same = mine == theirs and {**built.metadata, "workbook": 0} == {**wanted.metadata, "workbook": 0}
        if rest_same and hashes[0] != hashes[1]:
            yield "its outputs are older than its text or a lesson node that it runs"
        else:
            yield "its metadata is not what the text gives"
    if built.nbformat_minor != wanted.nbformat_minor:
        yield f"has notebook format 4.{built.nbformat_minor} and not 4.{wanted.nbformat_minor}"


def _next_lesson(tree: Tree, stem: str, wanted: document.Document) -> Iterator[str]:
    later = [other for other in tree.lesson_stems() if other > stem]
    last = next((c for c in reversed(wanted.cells) if c.kind == "markdown" and "**Next:**" in c.source), None)
    if later and last is not None and f"({later[0]}.ipynb)" not in last.source:
        yield f"## Take away: **Next:** must link to the next lesson, ({later[0]}.ipynb)"
    earlier = [other for other in tree.lesson_stems() if other < stem]
    before = (
        re.compile(rf"^\*\*Before:\*\* \[.*\]\({earlier[-1]}\.ipynb\)", re.MULTILINE) if earlier else None
    )
    if before is not None and last is not None and not before.search(last.source):
        yield f"## Take away: needs the line '**Before:** [title]({earlier[-1]}.ipynb)' with the lesson before"


def _story_tells(exercise: Exercise) -> Iterator[str]:
    source = exercise.source
    story = "\n".join(source.story)
    wanted = [
        f"{source.minutes} minutes",
        f"difficulty {source.difficulty} of 5",
        f"{points(exercise.max_points)} points",
    ]
    for words in wanted:
        if words not in story:
            yield f"the story must say '{words}', as header and criteria do"
    title = f"# Exercise {source.number:02d} · "
    if not source.story[0].startswith(title):
        yield f"the story must begin with '{title}{source.title}'"
    per_criterion = [float(text) for text in re.findall(r"^\| *(\d+(?:\.\d+)?) *\|", story, re.MULTILINE)]
    shown = sum(one.points for one in exercise.criteria if not one.hidden)
    if abs(sum(per_criterion) - shown) > 1e-9:
        yield (
            f"the table of points must have rows '| 2 | what is judged |' that add up to {points(shown)}, "
            f"not {points(sum(per_criterion))}"
        )


def _unwritten(text: str) -> Iterator[str]:
    for number, line in enumerate(text.splitlines(), start=1):
        if template.UNWRITTEN in line:
            yield f"line {number} is still to be written: {line.strip().lstrip('#| ')}"


def _answers(tree: Tree, stem: str) -> Iterator[Problem]:
    fewest = FEWEST_ANSWERS_OF.get(stem, FEWEST_ANSWERS)
    for kind, folder in (("right", tree.right_answers / stem), ("wrong", tree.wrong_answers / stem)):
        answers = list(entries(folder))
        for path in answers:
            name = tree.name(path)
            if not (path.is_file() and path.suffix == ".py"):
                yield Problem(name, "fits nowhere: answers are Python files")
                continue
            text = path.read_text(encoding="utf-8", errors="replace")
            loses = re.search(r"^# loses: \S", text.partition("\n\n")[0], re.MULTILINE)
            if kind == "wrong" and not loses:
                yield Problem(name, "must begin with '# loses: ' and the criteria that it loses")
            yield from (Problem(name, words) for words in _unwritten(text))
        count = sum(path.suffix == ".py" for path in answers)
        if count < fewest[kind]:
            yield Problem(tree.name(folder), f"has {count} {kind} answers; {fewest[kind]} are the fewest")


def report(found: Iterable[Problem]) -> str:
    """The problems, grouped by file."""
    lines: list[str] = []
    by_file: dict[str, list[str]] = {}
    for problem in found:
        by_file.setdefault(problem.where, []).append(problem.words)
    for where, words in by_file.items():
        lines += [where, *(f"  - {one}" for one in words)]
    return "\n".join(lines)

"""Find misplaced files, and files that don't belong to any lesson or exercise."""

from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

from workbook.authoring.pages import BESIDE_LESSONS, PAGES
from workbook.authoring.tree import Tree, entries
from workbook.authoring.violations import Violation
from workbook.exercise.source import DEEPER, STEM


def misplaced(tree: Tree) -> Iterator[Violation]:
    """Yield a violation for each misplaced file, each file without a lesson or exercise, and each number used twice."""
    lessons, exercises = tree.lesson_stems(), tree.exercise_stems()
    # Each rule has a folder, the suffixes of its files, their stems, and the names of other allowed entries.
    rules: list[tuple[Path, str, tuple[str, ...], tuple[str, ...]]] = [
        (tree.notebooks, ".ipynb", lessons, ("sources", *PAGES)),
        (tree.sources, ".py", lessons, BESIDE_LESSONS),
        (tree.museum, ".toml", lessons, ()),
        (
            tree.exercises,
            ".ipynb",
            exercises,
            ("criteria", "drivers", "partners", "README.md", "teaching.md"),
        ),
        (tree.drivers, ".py", exercises, ()),
        (tree.partners, ".py", exercises, ()),
        (tree.criteria, ".py .toml", exercises, ("__init__.py", "conftest.py")),
        (tree.solutions, ".py", exercises, ("__init__.py",)),
        (tree.right_answers, "", exercises, ()),
        (tree.wrong_answers, "", exercises, ()),
        (tree.requirements, ".toml", exercises, ()),
        (tree.mutants, ".toml", exercises, ()),
    ]
    for stem in (*lessons, *exercises):
        if stem.endswith(DEEPER) and (stem in exercises or stem.removesuffix(DEEPER) not in lessons):
            yield Violation(
                tree.name((tree.solutions if stem in exercises else tree.sources) / f"{stem}.py"),
                "a notebook …_deeper goes with the lesson of the same name, and doesn't have its own exercise",
            )
    for stems, folder in ((tree.main_stems(), tree.sources), (exercises, tree.solutions)):
        for one, other in pairwise(stems):
            if one[:2] == other[:2]:
                yield Violation(tree.name(folder / f"{other}.py"), f"number {one[:2]} is taken by {one}")
    for folder, suffix, stems, others in rules:
        for path in entries(folder):
            if path.name in others:
                continue
            if path.suffix not in (suffix.split() or [""]) or not STEM.fullmatch(path.stem):
                form = " and ".join(f"NN_slug{one}" for one in suffix.split()) or "folders NN_slug"
                yield Violation(
                    tree.name(path), f"does not belong here: {tree.name(folder)}/ holds {form} only"
                )
            elif path.stem not in stems:
                home = "notebooks/sources" if stems is lessons else "solutions"
                yield Violation(tree.name(path), f"has no text: {home}/{path.stem}.py is missing")

"""Runs nbval over all notebooks in a scratch copy that looks like a student's folder."""

import os
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType

import nbformat

from workbook.authoring import building
from workbook.authoring.replay import RAN
from workbook.authoring.running import CELL_TIMEOUT_S
from workbook.authoring.tree import AuthoringError, Tree
from workbook.lesson.sealed_predictions import FOLDER

GLUE = "workbook.authoring.nbval_glue"
NBVAL = ("--nbval", "--nbval-current-env", f"--nbval-cell-timeout={CELL_TIMEOUT_S}")


def compare_run(tree: Tree, stem: str, ran: Path) -> int:
    """Compare what a lesson showed when it was run elsewhere, as `compare` does. Returns pytest's exit code.

    Raises:
        AuthoringError: the notebook is not built.
    """
    with tempfile.TemporaryDirectory(prefix="notebooks-") as scratch:
        top = Path(scratch)
        built = tree.notebooks / f"{stem}.ipynb"
        _put(top / "notebooks" / built.name, _read(built))
        return _nbval(tree, top, ["nbval.plugin", GLUE], environment={RAN: str(ran)})


def compare(tree: Tree, names: Iterable[str] = (), *, jobs: int = 1, extra: Sequence[str] = ()) -> int:
    """Run the named notebooks, or all, and compare what they show with what is committed.

    `extra` goes to pytest. Returns its exit code.

    Raises:
        AuthoringError: a notebook is not built, or an exercise cannot be.
    """
    lessons, exercises = building.select(tree, names)
    return compare_stems(tree, lessons, exercises, jobs=jobs, extra=extra)


def compare_stems(
    tree: Tree,
    lessons: Iterable[str],
    exercises: Iterable[str],
    *,
    jobs: int = 1,
    extra: Sequence[str] = (),
) -> int:
    """Run these lessons and exercises, and compare as `compare` does.

    Lessons run as they are, exercises as a student goes through them: with the starter, and then, in the same
    kernel, with the solution put in.

    Raises:
        AuthoringError: a notebook is not built, or an exercise cannot be.
    """
    with tempfile.TemporaryDirectory(prefix="notebooks-") as scratch:
        top = Path(scratch)
        for stem in lessons:
            built = tree.notebooks / f"{stem}.ipynb"
            _put(top / "notebooks" / built.name, _read(built))
        for stem in exercises:
            building.build_exercise(tree, stem)
            built = tree.exercises / f"{stem}.ipynb"
            _put(top / "exercises" / built.name, _one_after_the_other(built, tree.solved / built.name))
        spread = ["-n", str(jobs), "--dist", "loadfile"] if jobs > 1 else []
        plugins = [*(["xdist.plugin"] if jobs > 1 else []), "nbval.plugin", GLUE]
        return _nbval(tree, top, plugins, [*spread, *extra])


def _nbval(
    tree: Tree,
    top: Path,
    plugins: Iterable[str],
    options: Iterable[str] = (),
    environment: Mapping[str, str] = MappingProxyType({}),
) -> int:
    """Run nbval over the notebooks below `top`. Returns pytest's exit code."""
    (top / "pytest.ini").write_text(
        "[pytest]\nfilterwarnings = ignore::DeprecationWarning\n", encoding="utf-8"
    )
    command = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider"]
    for plugin in plugins:
        command += ["-p", plugin]
    environ = {k: v for k, v in os.environ.items() if not k.startswith("PYTEST_")}
    environ[FOLDER] = str(tree.sealed)
    environ["IPYTHONDIR"] = str(top / "ipython")
    environ["PYTEST_DISABLE_PLUGIN_AUTOLOAD"] = "1"  # what else is installed takes a third of the start
    command += ["-q", *NBVAL, *options, "."]
    return subprocess.run(command, cwd=top, env={**environ, **environment}, check=False).returncode


def _read(path: Path) -> nbformat.NotebookNode:
    if not path.is_file():
        raise AuthoringError(f"{path.parent.name}/{path.name} is not built: run `make notebooks`")
    notebook: nbformat.NotebookNode = nbformat.read(path, nbformat.NO_CONVERT)
    return notebook


def _one_after_the_other(starter: Path, solved: Path) -> nbformat.NotebookNode:
    """Both in one notebook: to start a kernel and all that judges in it takes as long as to judge."""
    first, second = _read(starter), _read(solved)
    for cell in second.cells:
        cell.id = f"solved-{cell.id}"
    second.cells = [*first.cells, *second.cells]
    return second


def _put(path: Path, notebook: nbformat.NotebookNode) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    nbformat.write(notebook, path)

"""Compare notebooks with their committed outputs, by running nbval in a scratch folder laid out like a student's."""

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
    """Compare the outputs in `ran`, a lesson that ran elsewhere, with the committed ones. Return pytest's exit code.

    Raises:
        AuthoringError: the lesson hasn't been built.
    """
    with tempfile.TemporaryDirectory(prefix="notebooks-") as scratch:
        top = Path(scratch)
        built = tree.notebooks / f"{stem}.ipynb"
        _put(top / "notebooks" / built.name, _read(built))
        return _nbval(tree, top, ["nbval.plugin", GLUE], environment={RAN: str(ran)})


def compare(tree: Tree, names: Iterable[str] = (), *, jobs: int = 1, extra: Sequence[str] = ()) -> int:
    """Run the named notebooks, or all of them if none are named, and compare their outputs with the committed ones.

    Pass the arguments in `extra` to pytest and return pytest's exit code. Raises AuthoringError if a lesson hasn't been
    built, or if an exercise can't be built.
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
    """Run these lessons and exercises and compare their outputs as `compare` does.

    Lessons run unchanged. Exercises run the way a student works: first with the starter and then, in the same kernel,
    with the solution. Raises AuthoringError if a lesson hasn't been built, or if an exercise can't be built.
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
    """Run nbval on the notebooks under `top`. Return pytest's exit code."""
    (top / "pytest.ini").write_text(
        "[pytest]\nfilterwarnings = ignore::DeprecationWarning\n", encoding="utf-8"
    )
    command = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider"]
    for plugin in plugins:
        command += ["-p", plugin]
    environ = {k: v for k, v in os.environ.items() if not k.startswith("PYTEST_")}
    environ[FOLDER] = str(tree.sealed)
    environ["IPYTHONDIR"] = str(top / "ipython")
    environ["PYTEST_DISABLE_PLUGIN_AUTOLOAD"] = "1"  # loading other plugins takes a third of the startup time
    command += ["-q", *NBVAL, *options, "."]
    return subprocess.run(command, cwd=top, env={**environ, **environment}, check=False).returncode


def _read(path: Path) -> nbformat.NotebookNode:
    if not path.is_file():
        raise AuthoringError(f"{path.parent.name}/{path.name} is not built: run `make notebooks`")
    notebook: nbformat.NotebookNode = nbformat.read(path, nbformat.NO_CONVERT)
    return notebook


def _one_after_the_other(starter: Path, solved: Path) -> nbformat.NotebookNode:
    """Join two notebooks, so that both run in one kernel.

    Starting another kernel and judge would take as long as the judging itself.
    """
    first, second = _read(starter), _read(solved)
    for cell in second.cells:
        cell.id = f"solved-{cell.id}"
    second.cells = [*first.cells, *second.cells]
    return second


def _put(path: Path, notebook: nbformat.NotebookNode) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    nbformat.write(notebook, path)

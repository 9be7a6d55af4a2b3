"""Runs nbval over all notebooks in a scratch copy that looks like a student's folder."""

import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Sequence
from pathlib import Path

from workbook.authoring import building
from workbook.authoring.running import CELL_TIMEOUT_S
from workbook.authoring.tree import AuthoringError, Tree

NBVAL = ("--nbval", "--nbval-current-env", f"--nbval-cell-timeout={CELL_TIMEOUT_S}")


def compare(tree: Tree, names: Iterable[str] = (), *, jobs: int = 1, extra: Sequence[str] = ()) -> int:
    """Run the named notebooks, or all, and compare what they show with what is committed.

    Lessons run as they are, exercises with the starter and once more with the solution put in. `extra` goes to
    pytest. Returns pytest's exit code.

    Raises:
        AuthoringError: a notebook is not built, or an exercise cannot be.
    """
    lessons, exercises = building.select(tree, names)
    with tempfile.TemporaryDirectory(prefix="notebooks-") as scratch:
        top = Path(scratch)
        for stem in lessons:
            _copy(tree.notebooks / f"{stem}.ipynb", top / "lessons" / "notebooks")
        for stem in exercises:
            building.build_exercise(tree, stem)
            _copy(tree.exercises / f"{stem}.ipynb", top / "starters" / "exercises")
            _copy(tree.solved / f"{stem}.ipynb", top / "solved" / "exercises")
        (top / "pytest.ini").write_text(
            "[pytest]\nfilterwarnings = ignore::DeprecationWarning\n", encoding="utf-8"
        )
        spread = ["-n", str(jobs), "--dist", "loadfile"] if jobs > 1 else []
        command = [
            sys.executable,
            "-m",
            "pytest",
            "-p",
            "workbook.authoring.nbval_glue",
            "-p",
            "no:cacheprovider",
        ]
        environment = {k: v for k, v in os.environ.items() if not k.startswith("PYTEST_")}
        environment["IPYTHONDIR"] = str(top / "ipython")
        return subprocess.run(
            [*command, "-q", *NBVAL, *spread, *extra, "."], cwd=top, env=environment, check=False
        ).returncode


def _copy(path: Path, folder: Path) -> None:
    if not path.is_file():
        raise AuthoringError(f"{path.parent.name}/{path.name} is not built: run `make notebooks`")
    folder.mkdir(parents=True, exist_ok=True)
    shutil.copy(path, folder)

"""Run a lesson from top to bottom in a fresh kernel, as a student's JupyterLab would."""

import os
import re
import tempfile
from copy import deepcopy
from pathlib import Path

import nbformat
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError, CellTimeoutError, DeadKernelError

from workbook.authoring.outputs import normalize, texts
from workbook.authoring.tree import AuthoringError, Tree
from workbook.lesson.predictions import UNATTENDED
from workbook.lesson.sealed_predictions import FOLDER

CELL_TIMEOUT_S = 60
_ANSI = re.compile(r"\x1b\[[0-9;]*m")


def run(tree: Tree, stem: str, notebook: nbformat.NotebookNode) -> None:
    """Run all cells of a lesson and store the normalized outputs in `notebook`.

    Raises:
        AuthoringError: a cell failed, took longer than 60 s, killed its kernel, or printed a machine path.
    """
    metadata = deepcopy(notebook.metadata)
    with tempfile.TemporaryDirectory(prefix="lesson-") as scratch:
        folder = Path(scratch) / "notebooks"
        folder.mkdir()
        client = NotebookClient(
            notebook,
            timeout=CELL_TIMEOUT_S,
            kernel_name="python3",
            record_timing=False,
            resources={"metadata": {"path": str(folder)}},
        )
        environment = {k: v for k, v in os.environ.items() if k != "PYTEST_CURRENT_TEST"}
        environment |= {UNATTENDED: "1", FOLDER: str(tree.sealed)}
        environment["IPYTHONDIR"] = str(Path(scratch) / "ipython")  # ignore the author's own settings
        try:
            client.execute(env=environment)
        except CellExecutionError as error:
            raise AuthoringError(f"{stem}: {_failure(notebook, error)}") from error
        except CellTimeoutError as error:
            cell = _running(notebook)
            raise AuthoringError(
                f"{stem}: a cell was still running after {CELL_TIMEOUT_S} s. What can hang belongs in a child "
                f"process with a watchdog.\n\n{cell}"
            ) from error
        except DeadKernelError as error:
            raise AuthoringError(f"{stem}: the kernel died.\n\n{_running(notebook)}") from error
        notebook.metadata = metadata  # nbclient has added the kernel's own metadata
        normalize(notebook)
        _refuse_machine_paths(stem, notebook, [str(tree.root), scratch, str(Path.home())])


def _failure(notebook: nbformat.NotebookNode, error: CellExecutionError) -> str:
    for cell in notebook.cells:
        for output in cell.get("outputs", []):
            if output.output_type == "error" and "raises-exception" not in cell.metadata.get("tags", []):
                trace = _ANSI.sub("", "\n".join(output.traceback))
                return (
                    f"cell {cell.id} failed. If it is meant to, tag it raises-exception.\n\n"
                    f"{cell.source}\n\n{trace}"
                )
    return str(error)


def _running(notebook: nbformat.NotebookNode) -> str:
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    cell = next((cell for cell in code if cell.execution_count is None), code[-1])
    return f"In or before cell {cell.id}:\n{cell.source}"


def _refuse_machine_paths(stem: str, notebook: nbformat.NotebookNode, paths: list[str]) -> None:
    for cell in notebook.cells:
        for output in cell.get("outputs", []):
            for text in texts(output):
                for path in paths:
                    if len(path) > 1 and re.search(rf"{re.escape(path)}(?![\w-])", text):
                        raise AuthoringError(
                            f"{stem}: the output of cell {cell.id} names {path}, a folder of this machine only. "
                            "Let the cell show a shorter name."
                        )

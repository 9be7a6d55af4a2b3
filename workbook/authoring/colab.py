"""Prepare lessons for Colab and other notebook services by adding a first cell that installs the course."""

from pathlib import Path

import nbformat

from workbook.authoring.tree import Tree
from workbook.lab.work_folder import without_outputs

PACKAGE = "rclpy-workbook"
FIRST_CELL = """\
# Run this cell first. It installs the course, which takes about two minutes. Then restart the session, as it says, and
# run it once more.
%pip install --quiet {package}
%load_ext workbook.lab.kernel"""


def lessons_for_colab(tree: Tree, folder: Path, package: str = PACKAGE) -> list[Path]:
    """Write each lesson to `folder`, without outputs and with a first cell that installs the course.

    `package` is pip's argument: a package name or a wheel's URL. Return the paths of the files that were written.
    """
    folder.mkdir(parents=True, exist_ok=True)
    written = []
    for stem in tree.lesson_stems():
        text = without_outputs((tree.notebooks / f"{stem}.ipynb").read_text(encoding="utf-8"))
        notebook = nbformat.reads(text, nbformat.NO_CONVERT)
        cell = nbformat.v4.new_code_cell(FIRST_CELL.format(package=package), id="install-the-course")
        notebook.cells.insert(0, cell)
        written.append(folder / f"{stem}.ipynb")
        nbformat.write(notebook, written[-1])
    return written

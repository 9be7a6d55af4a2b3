"""Write the sources that Sphinx reads. Most files keep their path in the repository."""

import shutil
import tempfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from workbook.authoring.site.errors import ErrorPages
from workbook.authoring.site.guides import FOLDER, Guides
from workbook.authoring.site.links import Links
from workbook.authoring.site.notebooks import NotebookPage, Pictures, robot_figure
from workbook.authoring.site.recordings import recording_file, site_robots
from workbook.authoring.tree import Tree
from workbook.lab.jupyter_files import FRONT_END
from workbook.lesson.sealed_predictions import all_predictions
from workbook.pictures.humanoid import draw
from workbook.pictures.joints import NEUTRAL

HERE = Path(__file__).parent
OWN_PAGES = HERE / "pages"
COPIED = (
    "environment.md", "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md", "exercises/README.md", "exercises/teaching.md",
    "notebooks/glossary.md",
)  # fmt: skip
GREETING = "A recorded node from lesson 00 moves this robot."
MOVED = {"README.md": "index.md", "notebooks/error_museum.md": "errors/index.md"}
"""Repository pages that the site replaces with other pages, at other paths."""


def write_sources(tree: Tree, folder: Path) -> None:
    """Write everything that Sphinx needs to `folder`, which is new or empty."""
    errors, guides = ErrorPages(tree), Guides(tree)
    texts = {**dict(_own_pages(tree)), **dict(errors.texts()), **dict(guides.texts())}
    notebooks = [*sorted(tree.notebooks.glob("[0-9]*.ipynb")), *sorted(tree.exercises.glob("[0-9]*.ipynb"))]
    copied = [*COPIED, *(tree.name(path) for path in sorted((tree.root / "docs").glob("*.md")))]
    names = frozenset([*texts, *copied, *map(tree.name, notebooks)])
    for name, text in texts.items():
        _write(folder / name, text)
    for name in copied:
        text = _without_diagrams((tree.root / name).read_text(encoding="utf-8"))
        _write(folder / name, Links(name, names, MOVED).in_page(text))
    pictures, predictions = (
        Pictures(folder / "_static" / "pictures", "../_static/pictures"),
        all_predictions(),
    )
    for path in notebooks:
        name = tree.name(path)
        cells = errors.cells(path.stem) if path.parent == tree.notebooks else frozenset()
        page = NotebookPage(path.stem, Links(name, names, MOVED), pictures, predictions, cells)
        _write(folder / name, page.convert(path))
    _write_static(folder / "_static")
    shutil.copy(HERE / "conf.py", folder / "conf.py")
    with tempfile.TemporaryDirectory(prefix="site-") as scratch:
        guides.write_class(folder / "_extra" / FOLDER / "class", Path(scratch))


def _own_pages(tree: Tree) -> Iterator[tuple[str, str]]:
    """Yield the path and text of each page that exists only on the site, with its placeholders replaced."""
    put_in = {
        "@ROBOT@": robot_figure(replace(site_robots()[0], about=GREETING), root=""),
        "@LESSONS@": "\n".join(tree.lesson_stems()),
        "@EXERCISES@": "\n".join(tree.exercise_stems()),
    }
    for path in sorted(OWN_PAGES.rglob("*.md")):
        text = path.read_text(encoding="utf-8")
        for mark, value in put_in.items():
            text = text.replace(mark, value)
        yield path.relative_to(OWN_PAGES).as_posix(), text


def _write_static(folder: Path) -> None:
    """Copy the static files: the site's own, the front end's figure and film player, and the recordings."""
    shutil.copytree(HERE / "static", folder, dirs_exist_ok=True)
    for file in ("panel/rig.js", "panel/figure.json", "desk/film.js"):
        shutil.copy(FRONT_END / file, folder)
    (folder / "robot.png").write_bytes(draw(NEUTRAL, scale=1.0))
    (folder / "recordings").mkdir()
    for robot in site_robots():
        for name in robot.names:
            shutil.copy(recording_file(name), folder / "recordings" / f"{name}.json")


def _without_diagrams(text: str) -> str:
    """Return the page with its Mermaid diagrams as plain text, because drawing them would need a large script."""
    return text.replace("```mermaid", "```text")


def _write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")

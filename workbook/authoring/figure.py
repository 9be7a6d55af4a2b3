"""Generate workbook/lab/front_end/panel/figure.json, the robot that web pages animate, from the drawing in Python."""

from collections.abc import Iterator

from workbook.authoring.tree import Tree
from workbook.authoring.violations import Violation
from workbook.pictures.rig import description

FILE = "workbook/lab/front_end/panel/figure.json"


def write_figure(tree: Tree) -> bool:
    """Update figure.json if the course has its own front end. Return whether the file has changed."""
    path = tree.root / FILE
    text = description()
    if not path.parent.is_dir() or (path.is_file() and path.read_text(encoding="utf-8") == text):
        return False
    path.write_text(text, encoding="utf-8")
    return True


def check_figure(tree: Tree) -> Iterator[Violation]:
    """Yield a violation if figure.json is missing or differs from the drawing in Python."""
    path = tree.root / FILE
    if path.parent.is_dir() and (not path.is_file() or path.read_text(encoding="utf-8") != description()):
        yield Violation(FILE, "differs from the robot that Python draws: run `make notebooks`")

"""The README's image of the robot: it comes from a recording, it moves, and it exists."""

from pathlib import Path

from PIL import Image

from workbook.authoring.robot_picture import PICTURE, PROGRAM, ROUND, write_robot_picture
from workbook.authoring.tree import Tree

ROOT = Path(__file__).resolve().parents[2]


def frames(path: Path) -> int:
    with Image.open(path) as picture:
        return int(getattr(picture, "n_frames", 1))


def test_it_is_drawn_from_what_the_program_published(tmp_path: Path) -> None:
    program = tmp_path / PROGRAM
    program.parent.mkdir()
    program.write_bytes((ROOT / PROGRAM).read_bytes())
    (tmp_path / PICTURE).parent.mkdir()
    assert frames(write_robot_picture(Tree(tmp_path))) == ROUND


def test_the_committed_one_moves() -> None:
    assert frames(ROOT / PICTURE) == ROUND

"""A separate course with an empty `work/`, and the command as a person types it."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest

from workbook.cli.main import main

ROOT = Path(__file__).resolve().parents[2]


@dataclass(frozen=True)
class Published:
    """A command's output and exit code."""

    code: int
    out: str
    err: str


Type = Callable[..., Published]


@pytest.fixture
def course(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Make a course with its own `work/`, and change to its folder."""
    folder = tmp_path / "course"
    folder.mkdir()
    for name in ("exercises", "solutions", "notebooks"):
        (folder / name).symlink_to(ROOT / name)
    (folder / "work" / "answers").mkdir(parents=True)
    (folder / "work" / ".state").mkdir()
    (folder / "work" / "notebooks").mkdir()
    monkeypatch.setenv("WORKBOOK_COURSE", str(folder))
    # commands set this variable in their process; monkeypatch restores it
    monkeypatch.setenv("WORKBOOK_ANSWERS", "")
    monkeypatch.chdir(folder)
    return folder


@pytest.fixture
def typed(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> Type:
    """Run `workbook` with arguments, in a terminal of 80 columns unless `columns` says otherwise."""

    def type_it(*arguments: str, columns: int = 80) -> Published:
        monkeypatch.setenv("COLUMNS", str(columns))
        monkeypatch.setenv("WORKBOOK_ANSWERS", "")  # a command may set it; monkeypatch restores it
        capsys.readouterr()
        try:
            code = main(arguments)
        except SystemExit as ended:
            code = int(ended.code or 0)
        said = capsys.readouterr()
        return Published(code, said.out, said.err)

    return type_it

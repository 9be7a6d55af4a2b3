"""Start JupyterLab: the command, the port, the environment, and the messages if it can't start."""

import os
import socket
import sys
from pathlib import Path

import pytest

from workbook.cli.main import main
from workbook.lab import launch


def test_the_persons_arguments_come_last_and_so_win(tmp_path: Path) -> None:
    line = launch.command(
        ["--no-browser", "--port=8899"],
        work=tmp_path,
        lesson="notebooks/00_start_here.ipynb",
        root_user=False,
    )
    assert line[:4] == [sys.executable, "-P", "-m", "jupyterlab"]
    assert f"--ServerApp.root_dir={tmp_path}" in line
    assert "--LabApp.default_url=/lab/tree/notebooks/00_start_here.ipynb" in line
    assert line[-2:] == ["--no-browser", "--port=8899"]
    assert "--allow-root" not in line


def test_a_terminal_keeps_the_search_path_of_the_environment(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # A shell from $SHELL starts as a plain shell. Without it, JupyterLab starts a login shell, which resets PATH.
    monkeypatch.setenv("SHELL", "/bin/some-shell")
    line = launch.command([], work=tmp_path, lesson=None, root_user=False)
    assert "--ServerApp.terminado_settings={'shell_command': ['/bin/some-shell']}" in line
    monkeypatch.delenv("SHELL")
    unnamed = launch.command([], work=tmp_path, lesson=None, root_user=False)
    assert any("shell_command" in argument and "sh" in argument for argument in unnamed)


def test_root_is_allowed_only_for_root(tmp_path: Path) -> None:
    def count(*arguments: str) -> int:
        return launch.command(arguments, work=tmp_path, lesson=None, root_user=True).count("--allow-root")

    assert count() == 1
    assert count("--allow-root") == 1


@pytest.mark.parametrize("arguments", [["--port={}"], ["--port", "{}"], ["--ServerApp.port={}"]])
def test_a_taken_port_is_said_before_jupyter_starts(
    arguments: list[str], capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with socket.socket() as holder:
        holder.bind(("127.0.0.1", 0))
        holder.listen()
        port = holder.getsockname()[1]
        assert main(["lab", "--no-browser", *(argument.format(port) for argument in arguments)]) == 1
    said = capsys.readouterr().err
    assert f"Port {port} cannot be used" in said
    assert len(said.strip().splitlines()) == 1


def test_a_port_that_is_no_number(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["lab", "--port=eight"]) == 1
    assert "'eight'" in capsys.readouterr().err


def test_a_free_port_and_no_port_are_fine() -> None:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        free = probe.getsockname()[1]
    launch.check_port([f"--port={free}"])
    launch.check_port(["--no-browser"])


def test_kernels_do_not_inherit_a_sourced_ros() -> None:
    dirty = {
        "PATH": "/usr/bin",
        "HOME": "/home/ada",
        "PYTHONPATH": "/opt/ros/jazzy/lib/python3.12/site-packages",
        "RMW_IMPLEMENTATION": "rmw_cyclonedds_cpp",
        "ROS_DOMAIN_ID": "7",
        "PYTHONDONTWRITEBYTECODE": "1",
    }
    clean = launch.lab_environment(dirty)
    assert set(clean) == {"PATH", "HOME"}
    assert clean["PATH"].split(os.pathsep)[0] == str(Path(sys.executable).parent)


def test_a_folder_that_is_no_course_is_said(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("WORKBOOK_COURSE", str(tmp_path))
    assert main(["lab"]) == 1
    assert str(tmp_path) in capsys.readouterr().err
    assert not (tmp_path / "work").exists()


def test_a_copy_that_cannot_be_written_is_said(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "exercises" / "criteria").mkdir(parents=True)
    (tmp_path / "work").write_text("a file where the folder should be")
    monkeypatch.setenv("WORKBOOK_COURSE", str(tmp_path))
    assert main(["lab"]) == 1
    assert "cannot write the student's copy" in capsys.readouterr().err


def test_the_first_start_opens_the_first_lesson_and_later_ones_open_at_home(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "exercises" / "criteria").mkdir(parents=True)
    (tmp_path / "notebooks").mkdir()
    (tmp_path / "notebooks" / "00_start_here.ipynb").write_text('{"cells": []}')
    monkeypatch.setenv("WORKBOOK_COURSE", str(tmp_path))
    monkeypatch.chdir(tmp_path)  # restores the current folder at the end
    started: list[list[str]] = []
    monkeypatch.setattr(os, "execve", lambda program, line, environ: started.append(line))
    main(["lab"])
    main(["lab"])
    opened = [[one for one in line if "default_url" in one] for line in started]
    assert opened == [["--LabApp.default_url=/lab/tree/notebooks/00_start_here.ipynb"], []]


@pytest.mark.parametrize("variable", ["HOME", "JUPYTER_RUNTIME_DIR", "IPYTHONDIR"])
def test_a_folder_that_jupyter_cannot_write_is_said_in_one_line(
    variable: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """If a file has the folder's name, not even root can write into it."""
    for name in (
        "JUPYTER_RUNTIME_DIR",
        "JUPYTER_DATA_DIR",
        "JUPYTER_CONFIG_DIR",
        "IPYTHONDIR",
        "XDG_RUNTIME_DIR",
    ):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("HOME", str(tmp_path))
    file = tmp_path / "file"
    file.touch()
    monkeypatch.setenv(variable, str(file))
    assert main(["lab", "--no-browser"]) == 1
    said = capsys.readouterr().err
    assert f"JupyterLab stores files in {file}" in said
    assert "Set HOME to a folder that you own" in said
    assert len(said.strip().splitlines()) == 1


@pytest.fixture
def from_wheel(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """Make a student's folder whose package was installed from a wheel."""
    monkeypatch.setattr(launch, "is_from_wheel", lambda: True)
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    folder = tmp_path / "robots"
    folder.mkdir()
    monkeypatch.chdir(folder)
    return folder


def test_the_copy_of_a_wheel_is_the_empty_folder_in_which_one_stands(from_wheel: Path) -> None:
    (from_wheel / ".venv").mkdir()
    assert launch.student_folder() == from_wheel


def test_the_copy_of_a_wheel_is_found_from_below(from_wheel: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (from_wheel / launch.STATE).parent.mkdir()
    (from_wheel / launch.STATE).write_text("{}")
    (from_wheel / "answers").mkdir()
    monkeypatch.chdir(from_wheel / "answers")
    assert launch.student_folder() == from_wheel


@pytest.mark.parametrize("folder", ["robots", "home"])
def test_the_copy_of_a_wheel_never_mixes_with_other_files(
    folder: str, from_wheel: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The home folder is not considered empty, even if it's new."""
    place = from_wheel.parent / folder
    place.mkdir(exist_ok=True)
    if folder == "robots":
        (place / "thesis.txt").touch()
    monkeypatch.chdir(place)
    assert launch.student_folder() == place / "rclpy-workbook"


def test_an_environment_that_cannot_be_written_is_said_before_anything_is_copied(
    from_wheel: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    file = from_wheel.parent / "file"
    file.touch()
    monkeypatch.setattr(sys, "prefix", str(file))
    assert main(["lab", "--only-copy"]) == 1
    assert "Install rclpy-workbook into a separate environment" in " ".join(capsys.readouterr().err.split())
    assert not list(from_wheel.iterdir())

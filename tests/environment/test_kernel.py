"""Every kernel of the environment is set up before its first cell, no matter which program starts it."""

import json
import os
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from workbook.authoring.kernels import PrivateKernelManager
from workbook.lab import jupyter_files, kernel, work_folder


@pytest.fixture
def run_cell(tmp_path: Path) -> Iterator[Callable[..., str]]:
    """Run one cell in a new kernel that has only the configuration from `make env`."""
    opened: list[tuple[PrivateKernelManager, Any]] = []
    profile = tmp_path / "profile_default"
    profile.mkdir()
    (profile / "ipython_kernel_config.py").write_text(jupyter_files.KERNEL_CONFIG)

    def run(code: str, **environ: str) -> str:
        manager = PrivateKernelManager(kernel_name="python3")
        assert manager.kernel_spec is not None
        manager.kernel_spec.argv = [sys.executable, "-m", "ipykernel_launcher", "-f", "{connection_file}"]
        manager.start_kernel(env=os.environ | {"IPYTHONDIR": str(tmp_path)} | environ)
        client = manager.client()
        client.start_channels()
        opened.append((manager, client))
        client.wait_for_ready(timeout=60)
        texts: list[str] = []

        def keep(message: dict[str, Any]) -> None:
            texts.append(message["content"].get("text") or message["content"].get("evalue") or "")

        client.execute_interactive(code, timeout=60, output_hook=keep)
        return "".join(texts)

    yield run
    for manager, client in opened:
        manager.shutdown_kernel()
        client.stop_channels()


def test_ros_and_the_magics_are_there_before_the_first_cell(run_cell: Callable[..., str]) -> None:
    said = run_cell(
        "import os\n"
        "print(sorted(get_ipython().extension_manager.loaded))\n"
        "print('domain', os.environ['ROS_DOMAIN_ID'], os.environ['ROS_PYTHON_CHECK_FIELDS'])\n"
        "print('pytest', os.environ.get('PYTEST_CURRENT_TEST'))\n",
        RMW_IMPLEMENTATION="rmw_other",
    )
    assert "workbook.magics" in said
    assert "domain " in said
    assert "pytest None" in said


def test_ros_logs_show_in_the_cell_under_pytest_too(run_cell: Callable[..., str]) -> None:
    said = run_cell(
        "import rclpy\n"
        "rclpy.init()\n"
        "node = rclpy.create_node('left_leg')\n"
        "node.get_logger().info('standing')\n"
        "node.destroy_node()\n"
        "rclpy.shutdown()\n"
    )
    assert "[INFO] [left_leg]: standing" in said


def test_a_sourced_ros_does_not_reach_the_kernel(run_cell: Callable[..., str], tmp_path: Path) -> None:
    other = tmp_path / "opt" / "rclpy"
    other.mkdir(parents=True)
    (other / "__init__.py").write_text("raise ImportError('built for another Python')\n")
    code = "import rclpy, os\nprint(rclpy.get_rmw_implementation_identifier(), os.environ.get('PYTHONPATH'))"
    said = run_cell(code, PYTHONPATH=str(other.parent), RMW_IMPLEMENTATION="rmw_cyclonedds_cpp")
    assert said.strip() == "rmw_fastrtps_cpp None"


def test_two_kernels_have_two_domains(run_cell: Callable[..., str]) -> None:
    code = "import os\nprint(os.environ['ROS_DOMAIN_ID'])"
    assert run_cell(code).strip() != run_cell(code).strip()


class Shell:
    """The part of IPython's shell that the startup needs."""

    def __init__(self, load: Callable[[str], str | None]) -> None:
        self.hooks: list[Callable[..., None]] = []
        self.extension_manager = SimpleNamespace(load_extension=load)
        self.events = SimpleNamespace(register=lambda name, hook: self.hooks.append(hook))


def broken(_name: str) -> str | None:
    raise ImportError("no module named wheels")


@pytest.mark.parametrize(
    ("load", "said"),
    [
        (broken, "did not load: ImportError: no module named wheels"),
        (lambda _: "no load function", "are not there"),
    ],
)
def test_what_is_wrong_is_said_once_above_the_first_cell(
    load: Callable[[str], str | None], said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    shell = Shell(load)
    kernel.start(shell)
    (hook,) = shell.hooks
    hook()
    hook()
    assert capsys.readouterr().err.count(said) == 1


def test_nothing_is_said_when_all_is_well() -> None:
    shell = Shell(lambda _: None)
    kernel.start(shell)
    assert shell.hooks == []


def test_files_go_where_jupyter_looks(tmp_path: Path) -> None:
    written = jupyter_files.install(tmp_path, "/env/bin/python")
    names = {path.relative_to(tmp_path).as_posix() for path in written}
    assert "etc/ipython/ipython_kernel_config.py" in names
    extension = tmp_path / "share/jupyter/labextensions/rclpy-workbook"
    load = json.loads((extension / "package.json").read_text())["jupyterlab"]["_build"]["load"]
    assert (extension / load).is_file()
    settings = json.loads((tmp_path / "share/jupyter/lab/settings/overrides.json").read_text())
    assert settings["@jupyterlab/apputils-extension:notification"]["fetchNews"] == "false"
    spec = json.loads((tmp_path / "share/jupyter/kernels/python3/kernel.json").read_text())
    assert spec["argv"][0] == "/env/bin/python"
    assert spec["env"]["_ROS_WHEELS_BOOTSTRAP_COMPLETE"] == ""


def test_a_file_that_another_environment_has_too_stays_as_it_is_there(tmp_path: Path) -> None:
    """uv installs files as hard links to its cache, ipykernel's kernel specification among them."""
    name = "share/jupyter/kernels/python3/kernel.json"
    ours, theirs = tmp_path / "ours" / name, tmp_path / "theirs" / name
    jupyter_files.install(tmp_path / "theirs", "/their/bin/python")
    ours.parent.mkdir(parents=True)
    ours.hardlink_to(theirs)
    jupyter_files.install(tmp_path / "ours", "/our/bin/python")
    assert json.loads(ours.read_text())["argv"][0] == "/our/bin/python"
    assert json.loads(theirs.read_text())["argv"][0] == "/their/bin/python"
    assert sorted(path.name for path in ours.parent.iterdir()) == ["kernel.json"]


def test_what_a_lesson_writes_does_not_lie_among_the_lessons(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)  # restores the current folder at the end
    (tmp_path / "notebooks").mkdir()
    kernel.leave_the_lessons(tmp_path / "notebooks")
    assert Path.cwd() == tmp_path, "a folder of notebooks that is not a student's copy"
    (tmp_path / ".state").mkdir()
    (tmp_path / kernel.STATE).write_text("{}")
    kernel.leave_the_lessons(tmp_path / "notebooks")
    assert Path.cwd() == tmp_path / "scratch"
    assert str(kernel.STATE) == str(work_folder.STATE)

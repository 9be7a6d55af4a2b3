"""The bootstrap with a fake uv: what it requests, when it does nothing, and how it recovers."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from workbook.lab import bootstrap

ROOT = Path(bootstrap.__file__).resolve().parents[2]
# Writes its arguments to a log, creates what the real uv would create, and fails on request.
FAKE_UV = """\
#!{python}
import os, pathlib, sys
root = pathlib.Path(__file__).resolve().parents[1]
with open(root / "calls.log", "a") as log:
    log.write(" ".join(sys.argv[1:]) + "\\n")
if sys.argv[1] == "pip":
    (pathlib.Path(os.environ["TMPDIR"]) / "uv.lock").touch()
if sys.argv[1] == "venv":
    target = pathlib.Path(sys.argv[-1])
    (target / "bin").mkdir(parents=True, exist_ok=True)
    (target / "pyvenv.cfg").touch()
    python = target / "bin" / "python"
    python.write_text("#!/bin/sh\\necho jupyter >>'" + str(root / "calls.log") + "'\\necho 3.12\\n")
    python.chmod(0o755)
elif (root / "fail").exists():
    sys.exit(3)
elif "-r" in sys.argv:
    listed = pathlib.Path(sys.argv[sys.argv.index("-r") + 1]).read_text()
    with open(root / "installed.log", "a") as log:
        log.write(listed)
elif "--editable" in sys.argv:
    (root / "course" / ".venv" / "bin" / "workbook").touch()
"""


class Checkout:
    """A folder with the bootstrap, a small lock file, and the fake uv on the PATH."""

    def __init__(self, folder: Path) -> None:
        self.top = folder
        self.course = folder / "course"
        lab = self.course / "workbook" / "lab"
        lab.mkdir(parents=True)
        for name in ("bootstrap.py", "jupyter_files.py"):
            shutil.copy(ROOT / "workbook" / "lab" / name, lab)
        (self.course / "pyproject.toml").write_text("[project]\n")
        sections = {"build": "flit-core==1", "student": "rclpy==7", "dev": "pytest==9", "torch": "torch==2"}
        text = "".join(
            f"#: {name}\n{line} \\\n    --hash=sha256:{name}\n\n" for name, line in sections.items()
        )
        (self.course / "requirements.lock").write_text(text)
        self.temporary = folder / "temporary"
        self.temporary.mkdir()
        (folder / "bin").mkdir()
        fake = folder / "bin" / "uv"
        fake.write_text(FAKE_UV.format(python=sys.executable))
        fake.chmod(0o755)

    def make(
        self, *arguments: str, python: str | Path = sys.executable
    ) -> "subprocess.CompletedProcess[str]":
        for log in ("calls.log", "installed.log"):
            (self.top / log).unlink(missing_ok=True)
        environ = {
            "PATH": f"{self.top / 'bin'}:{os.defpath}",
            "HOME": str(self.top),
            "TMPDIR": str(self.temporary),
        }
        script = self.course / "workbook" / "lab" / "bootstrap.py"
        command = [str(python), "-I", str(script), *arguments]
        return subprocess.run(command, env=environ, capture_output=True, text=True, timeout=600)

    def log(self, name: str) -> str:
        path = self.top / name
        return path.read_text() if path.exists() else ""

    @property
    def venv(self) -> Path:
        return self.course / ".venv"


@pytest.fixture
def checkout(tmp_path: Path) -> Checkout:
    return Checkout(tmp_path)


def test_first_run_installs_the_student_sections_and_a_second_does_nothing(checkout: Checkout) -> None:
    first = checkout.make()
    assert first.returncode == 0, first.stderr
    assert "The environment is ready" in first.stdout
    installed = checkout.log("installed.log")
    assert "flit-core==1" in installed and "rclpy==7" in installed
    assert "pytest" not in installed and "torch" not in installed
    assert all(
        "--require-hashes" in call for call in checkout.log("calls.log").splitlines() if " -r " in call
    )
    assert json.loads((checkout.venv / bootstrap.STAMP).read_text())["sections"] == ["build", "student"]
    assert not (checkout.venv / bootstrap.UNFINISHED).exists()

    second = checkout.make()
    assert (second.returncode, second.stdout, checkout.log("calls.log")) == (0, "", "")


def test_more_is_added_and_never_taken_away(checkout: Checkout) -> None:
    checkout.make("--extras", "torch")
    assert checkout.make("--extras", "dev").returncode == 0
    stamp = json.loads((checkout.venv / bootstrap.STAMP).read_text())
    assert stamp["sections"] == ["build", "student", "dev", "torch"]
    assert checkout.make().stdout == ""


def test_no_temporary_file_is_left_whatever_the_installer_leaves(checkout: Checkout) -> None:
    assert checkout.make().returncode == 0
    assert "--editable" in checkout.log("calls.log")
    assert list(checkout.temporary.iterdir()) == []


def test_a_changed_lock_updates_in_place(checkout: Checkout) -> None:
    checkout.make()
    (checkout.venv / "mine").touch()
    lock = checkout.course / "requirements.lock"
    lock.write_text(lock.read_text().replace("rclpy==7", "rclpy==8"))
    again = checkout.make()
    assert "Updating" in again.stdout
    assert "rclpy==8" in checkout.log("installed.log")
    assert (checkout.venv / "mine").exists()


def test_a_failed_installation_is_told_and_repaired(checkout: Checkout) -> None:
    (checkout.top / "fail").touch()
    failed = checkout.make()
    assert failed.returncode == 1
    assert len(failed.stderr.strip().splitlines()) == 1
    assert "Installing the packages failed" in failed.stderr and "environment.md" in failed.stderr
    assert (checkout.venv / bootstrap.UNFINISHED).exists()
    (checkout.venv / "half").touch()
    (checkout.top / "fail").unlink()
    repaired = checkout.make()
    assert repaired.returncode == 0, repaired.stderr
    assert "Creating" in repaired.stdout
    assert not (checkout.venv / "half").exists()


@pytest.mark.whole
@pytest.mark.parametrize("with_uv", [True, False], ids=["uv", "pip"])
def test_an_active_environment_that_is_unfinished_is_made_anew(checkout: Checkout, with_uv: bool) -> None:
    """In VS Code's terminal, `.venv` comes first on the PATH.

    Its Python must not create the new environment, because the old folder is being removed.
    """
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", checkout.venv], check=True)
    (checkout.venv / bootstrap.UNFINISHED).touch()
    (checkout.venv / "half").touch()
    if not with_uv:
        (checkout.top / "bin" / "uv").unlink()
    made = checkout.make(python=checkout.venv / "bin" / "python")
    assert not (checkout.venv / "half").exists()
    assert "Traceback" not in made.stderr
    assert (checkout.venv / "bin" / "python").exists()
    if with_uv:
        assert made.returncode == 0, made.stderr
        base = checkout.log("calls.log").split("--python ")[1].split()[0]
        assert Path(base).exists() and checkout.venv not in Path(base).parents


def test_a_moved_course_gets_a_new_environment(checkout: Checkout) -> None:
    checkout.make()
    moved = checkout.top / "elsewhere"
    checkout.course.rename(moved)
    (checkout.top / "course").symlink_to(moved)
    checkout.course = moved
    assert "Creating" in checkout.make().stdout


def test_another_named_python_makes_it_anew_and_an_unnamed_one_does_not(checkout: Checkout) -> None:
    checkout.make()
    stamp = json.loads((checkout.venv / bootstrap.STAMP).read_text())
    stamp["python"] = "3.99"
    (checkout.venv / bootstrap.STAMP).write_text(json.dumps(stamp))
    assert checkout.make().stdout == ""
    assert "Creating" in checkout.make("--chosen-python").stdout


@pytest.mark.parametrize("arguments", [(), ("--chosen-python",)])
def test_an_environment_made_by_hand_is_kept_and_filled(
    checkout: Checkout, arguments: tuple[str, ...]
) -> None:
    venv = checkout.venv
    (venv / "bin").mkdir(parents=True)
    (venv / "pyvenv.cfg").touch()
    (venv / "mine").touch()
    python = venv / "bin" / "python"
    python.write_text(f"#!/bin/sh\necho {bootstrap.version_text(sys.version_info[:2])}\n")
    python.chmod(0o755)
    done = checkout.make(*arguments)
    assert done.returncode == 0, done.stderr
    assert "Updating" in done.stdout
    assert (venv / "mine").exists()


def test_a_strange_folder_is_not_deleted(checkout: Checkout) -> None:
    checkout.venv.mkdir()
    (checkout.venv / "thesis.txt").write_text("three years of work")
    refused = checkout.make()
    assert refused.returncode == 1
    assert "is not an environment" in refused.stderr
    assert (checkout.venv / "thesis.txt").exists()


def test_an_unknown_extra_is_named(checkout: Checkout) -> None:
    refused = checkout.make("--extras", "robots")
    assert refused.returncode == 2
    assert "robots" in refused.stderr


GOOD = {
    "system": "Linux",
    "machine": "x86_64",
    "libc": ("glibc", "2.36"),
    "version": (3, 12),
    "implementation": "CPython",
}


def test_a_good_machine_passes() -> None:
    bootstrap.check_machine(**GOOD)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("changed", "said", "section"),
    [
        ({"system": "Darwin"}, "this is Darwin", "macOS and ARM"),
        ({"system": "Windows"}, "this is Windows", "Windows"),
        ({"machine": "aarch64"}, "aarch64", "macOS and ARM"),
        ({"version": (3, 10)}, "is Python 3.10", "Supported Python versions"),
        ({"version": (3, 15)}, "is Python 3.15", "Supported Python versions"),
        ({"implementation": "PyPy"}, "PyPy", "Supported Python versions"),
        ({"libc": ("glibc", "2.17")}, "glibc 2.17", "Docker"),
        ({"libc": ("", "")}, "another C library", "Docker"),
    ],
)
def test_each_lack_is_named_with_the_section_that_helps(
    changed: dict[str, object], said: str, section: str
) -> None:
    with pytest.raises(bootstrap.EnvironmentProblem) as caught:
        bootstrap.check_machine(**(GOOD | changed))  # type: ignore[arg-type]
    text = str(caught.value)
    assert said in text
    assert f"'{section}' in environment.md" in text
    assert "\n" not in text
    headings = [
        line.lstrip("# ") for line in (ROOT / "environment.md").read_text().splitlines() if line[:1] == "#"
    ]
    assert section in headings


def test_a_missing_venv_module_is_named_with_the_package_that_brings_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setitem(sys.modules, "ensurepip", None)
    with pytest.raises(bootstrap.EnvironmentProblem, match=r"sudo apt install python3\.\d+-venv"):
        bootstrap.check_venv_module(None)
    bootstrap.check_venv_module("/usr/bin/uv")


def test_the_file_is_readable_by_an_old_python() -> None:
    import ast

    source = Path(bootstrap.__file__).read_text(encoding="utf-8")
    ast.parse(source, feature_version=(3, 8))

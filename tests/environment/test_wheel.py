"""The students' wheel: built twice, installed into an empty environment, and used there from an empty folder."""

import csv
import json
import os
import re
import shutil
import subprocess
import sys
import venv
import zipfile
from importlib import metadata
from pathlib import Path

import nbformat
import pytest
from jupyter_client.kernelspec import KernelSpec
from jupyter_client.manager import AsyncKernelManager
from nbclient import NotebookClient
from nbformat import NotebookNode

from workbook.authoring.colab import lessons_for_colab
from workbook.authoring.comparing import GLUE, NBVAL
from workbook.authoring.tree import Tree
from workbook.authoring.wheel import LOCKED, SEARCH_PATH, build_wheel, ros_pins
from workbook.authoring.wrong_answers import read_wrong_answer
from workbook.exercise.course import IN_A_WHEEL
from workbook.grading.students_edition import students_edition
from workbook.lab import bootstrap
from workbook.lab.kernel import RESTART
from workbook.lab.packages import differing, locked_versions
from workbook.lab.work_folder import without_outputs

ROOT = Path(__file__).resolve().parents[2]
LOCK = (ROOT / "requirements.lock").read_text(encoding="utf-8")
LESSON = "02_nodes"
STEM = "09_joint_positions"
FROM_OUTSIDE = (
    "PYTEST_",
    "WORKBOOK_",
    "ROS_",
    "VIRTUAL_ENV",
    "LD_LIBRARY_PATH",
    "_ROS",
    "FAST",
    "RC",
    "JUPYTER",
)


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return build_wheel(ROOT, tmp_path_factory.mktemp("dist"))


@pytest.fixture(scope="module")
def names(wheel: Path) -> set[str]:
    with zipfile.ZipFile(wheel) as archive:
        return set(archive.namelist())


def test_the_same_files_give_the_same_bytes(
    wheel: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "315532800")  # the earliest date that a zip file can store
    assert build_wheel(ROOT, tmp_path).read_bytes() == wheel.read_bytes()
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1800000000")
    assert build_wheel(ROOT, tmp_path).read_bytes() != wheel.read_bytes()


def test_lessons_and_exercises_are_there_and_nothing_of_an_authors_or_instructors(names: set[str]) -> None:
    tree = Tree(ROOT)
    for stem in tree.lesson_stems():
        assert f"workbook/course/notebooks/{stem}.ipynb" in names
    for stem in tree.exercise_stems():
        for path in (f"exercises/{stem}.ipynb", f"exercises/criteria/{stem}.py", f"solutions/{stem}.py"):
            assert f"workbook/course/{path}" in names
    assert "workbook/course/lesson_nodes/two_arms.py" in names
    for catalog in (ROOT / "exercises" / "criteria").glob("*.toml"):
        assert f"workbook/course/exercises/criteria/{catalog.name}" in names
    for catalog in (ROOT / "workbook" / "criteria").rglob("*.toml"):
        assert catalog.relative_to(ROOT).as_posix() in names
    strange = (
        "authoring",
        "right_answers",
        "wrong_answers",
        "tests/",
        "sources/",
        "teaching",
        "cli/new",
        ".pyc",
    )
    assert not [name for name in names if any(part in name for part in strange)]


def test_no_lesson_gives_away_what_happens(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        for name in (one for one in archive.namelist() if one.endswith(".ipynb")):
            assert not [one for one in json.loads(archive.read(name))["cells"] if one.get("outputs")], name


def test_it_has_nothing_that_is_not_in_the_students_edition(wheel: Path, tmp_path: Path) -> None:
    """That edition contains no solution (tests/grading/test_students_edition.py), so the wheel doesn't, either."""
    edition = tmp_path / "edition"
    students_edition(ROOT, edition)
    apart = {SEARCH_PATH, f"workbook/{IN_A_WHEEL}/requirements.lock"}
    with zipfile.ZipFile(wheel) as archive:
        for name in sorted(set(archive.namelist()) - apart):
            if ".dist-info/" in name:
                continue
            theirs = (edition / name.removeprefix(f"workbook/{IN_A_WHEEL}/")).read_bytes()
            own = archive.read(name)
            assert own in (theirs, without_outputs(theirs.decode("utf-8", "replace")).encode()), name


def test_pip_gets_every_package_of_ros_pinned(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        [described] = [name for name in archive.namelist() if name.endswith("dist-info/METADATA")]
        lines = archive.read(described).decode("utf-8").splitlines()
    required = {line.removeprefix("Requires-Dist: ") for line in lines if line.startswith("Requires-Dist: ")}
    here = {f"{one.name}=={one.version}" for one in metadata.distributions() if one.name.startswith("ros-")}
    assert "ros-rclpy==7.1.6" in here
    assert here == set(ros_pins(LOCK))
    assert here <= required
    assert not [one for one in required if "pytest" in one or "extra == 'dev'" in one]


def test_the_doctor_names_each_package_that_differs_from_the_lock() -> None:
    versions = locked_versions(LOCK)
    assert differing(LOCK, versions.get) == []
    changed = {**versions, "ros-rclpy": "7.0.0", "jupyterlab": "9.9"}
    del changed["numpy"]
    found = differing(LOCK, changed.get)
    assert [(one.name, one.found) for one in found] == [
        ("ros-rclpy", "7.0.0"),
        ("jupyterlab", "9.9"),
        ("numpy", None),
    ]
    assert found[0].locked == versions["ros-rclpy"]


class Installed:
    """The wheel in a separate environment, and a student's folder. Both are outside the checkout."""

    def __init__(self, place: Path, wheel: Path) -> None:
        self.folder = place / "my robots"
        self.folder.mkdir()
        self.prefix = place / "environment"
        self.python = self.prefix / "bin" / "python"
        constraints = place / "constraints.txt"
        sections = bootstrap.read_sections(LOCK)
        constraints.write_text("\n".join(line for name in LOCKED for line in sections[name]) + "\n")
        venv.create(self.prefix, with_pip=True)
        tool = [str(self.python), "-m", "pip", "install", "--quiet"]
        if uv := shutil.which("uv"):
            tool = [uv, "pip", "install", "--quiet", "--compile-bytecode", "--python", str(self.python)]
        self.do(*tool, str(wheel), "--constraint", str(constraints))

    @property
    def environ(self) -> dict[str, str]:
        kept = {name: value for name, value in os.environ.items() if not name.startswith(FROM_OUTSIDE)}
        return bootstrap.clean_environ() | kept

    def do(self, *command: str, **more: str) -> str:
        """Run a command in the student's folder, and return its output."""
        done = subprocess.run(
            command, cwd=self.folder, env=self.environ | more, capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    def fails(self, *command: str) -> str:
        """Run a command that has to end with exit code 1, and return its output."""
        done = subprocess.run(command, cwd=self.folder, env=self.environ, capture_output=True, text=True)
        assert done.returncode == 1, done.stdout + done.stderr
        return done.stdout

    def script(self, name: str = "rclpy-workbook") -> str:
        return str(self.prefix / "bin" / name)


@pytest.fixture(scope="module")
def installed(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Installed:
    """Install the wheel and make the student's copy, as the first start does."""
    found = Installed(tmp_path_factory.mktemp("elsewhere"), wheel)
    assert "notebooks to my robots/." in found.do(found.script(), "lab", "--only-copy")
    return found


@pytest.mark.slow
@pytest.mark.whole
class TestInAnEmptyEnvironment:
    """Tests that share one installation."""

    def test_the_second_start_touches_nothing_of_the_students(self, installed: Installed) -> None:
        lesson = installed.folder / "notebooks" / "05_timers.ipynb"
        changed = lesson.read_text(encoding="utf-8").replace("timer", "rhythm")
        lesson.write_text(changed, encoding="utf-8")
        below = installed.folder / "answers"
        said = subprocess.run(
            [installed.script("workbook"), "lab", "--only-copy"],
            cwd=below, env=installed.environ, capture_output=True, text=True, check=True,
        )  # fmt: skip
        assert said.stdout == "Your copy in my robots/ is up to date.\n"
        assert lesson.read_text(encoding="utf-8") == changed
        assert not list(below.iterdir())

    def test_the_doctor_finds_every_locked_version(self, installed: Installed) -> None:
        said = installed.do(installed.script(), "doctor")
        assert re.search(r"ok +Packages", said), said
        assert "`rclpy-workbook lab` opens the lessons" in said

    def test_a_lesson_shows_what_is_committed(self, installed: Installed, tmp_path: Path) -> None:
        """nbval runs here, but its kernel runs there. The last cell proves it."""
        notebook = nbformat.read(ROOT / "notebooks" / f"{LESSON}.ipynb", 4)
        where = nbformat.v4.new_code_cell(
            "import workbook, lesson_nodes\nprint(workbook.__path__, lesson_nodes.__path__)"
        )
        [package] = installed.prefix.glob("lib/python3.*/site-packages/workbook")
        expected = f"{[str(package)]} {[str(package / 'course' / 'lesson_nodes')]}\n"
        where.outputs = [nbformat.v4.new_output("stream", name="stdout", text=expected)]
        where.execution_count = 1
        notebook.cells.append(where)
        nbformat.write(notebook, tmp_path / f"{LESSON}.ipynb")
        options = [one for one in NBVAL if one != "--nbval-current-env"]
        installed.do(
            sys.executable, "-m", "pytest", "-q", "-p", "nbval.plugin", "-p", GLUE, *options,
            "--nbval-kernel-name=python3", f"--rootdir={tmp_path}", str(tmp_path),
            JUPYTER_PATH=str(installed.prefix / "share" / "jupyter"),
            PYTEST_DISABLE_PLUGIN_AUTOLOAD="1",
        )  # fmt: skip

    def test_a_right_and_a_wrong_answer_are_judged(self, installed: Installed, tmp_path: Path) -> None:
        right, wrong = hand_ins(tmp_path)
        assert "10 of 10 points" in installed.do(installed.script(), "check", STEM, str(right))
        assert "10 of 10 points" not in installed.fails(installed.script(), "check", STEM, str(wrong))

    def test_a_lesson_runs_in_a_plain_kernel(self, installed: Installed, wheel: Path, tmp_path: Path) -> None:
        """As in Colab:

        we configured nothing, and the first cell installs the course into the kernel's own environment.
        """
        folder = tmp_path / "colab"
        lessons_for_colab(Tree(ROOT), folder, str(wheel))
        notebook = nbformat.read(folder / f"{LESSON}.ipynb", 4)
        config = installed.prefix / "etc" / "ipython" / "ipython_kernel_config.py"
        config.rename(tmp_path / config.name)
        try:
            plain = {name: value for name, value in installed.environ.items() if name != "IPYTHONDIR"}
            before = {
                **plain,
                "_ROS_WHEELS_BOOTSTRAP_COMPLETE": "1",
            }  # Python was running before ROS was installed
            first = nbformat.v4.new_notebook(cells=notebook.cells[:1])
            run_in_kernel(first, installed.python, folder, before)
            assert RESTART in text_of(first)
            run_in_kernel(notebook, installed.python, folder, plain)
        finally:
            (tmp_path / config.name).rename(config)
        assert "%start" not in text_of(notebook) and "/robot/camera" in text_of(notebook)
        kinds = {
            kind for cell in notebook.cells for out in cell.get("outputs", []) for kind in out.get("data", {})
        }
        assert kinds & {"image/png", "image/svg+xml", "text/html"}, "no picture without our front end"

    def test_a_batch_is_graded(self, installed: Installed, tmp_path: Path) -> None:
        answers = tmp_path / "answers"
        answers.mkdir()
        hand_ins(answers)
        out = tmp_path / "grades"
        installed.do(
            installed.script(), "grade", str(answers), "--exercise", STEM, "--out", str(out),
            "--isolation", "limits",
        )  # fmt: skip
        with (out / "grades.csv").open(encoding="utf-8-sig", newline="") as file:
            scores = {row["student"]: float(row["score"]) for row in csv.DictReader(file)}
        assert scores["right"] == 10
        assert scores["wrong"] < 10


def run_in_kernel(notebook: NotebookNode, python: Path, folder: Path, environ: dict[str, str]) -> None:
    """Run all cells in a new kernel of this Python, without our kernel specification. An error fails the test."""
    manager = AsyncKernelManager()
    manager.kernel_spec_manager.ensure_native_kernel = False
    manager._kernel_spec = KernelSpec(
        argv=[str(python), "-m", "ipykernel_launcher", "-f", "{connection_file}"]
    )
    client = NotebookClient(notebook, km=manager, timeout=120, resources={"metadata": {"path": str(folder)}})
    client.execute(env=environ, cleanup_kc=True)


def text_of(notebook: NotebookNode) -> str:
    """Return the text that the cells printed or displayed."""
    outputs = [out for cell in notebook.cells for out in cell.get("outputs", [])]
    return "".join(out.get("text", "") or out.get("data", {}).get("text/plain", "") for out in outputs)


def hand_ins(folder: Path) -> tuple[Path, Path]:
    """Write a right and a wrong answer to files."""
    tree = Tree(ROOT)
    wrong = read_wrong_answer(tree, ROOT / "tests" / "wrong_answers" / STEM / "eleven_values.py")
    shutil.copy(ROOT / "tests" / "right_answers" / STEM / "class_alone.py", folder / "right.py")
    (folder / "wrong.py").write_text(wrong.answer.text, encoding="utf-8")
    return folder / "right.py", folder / "wrong.py"

"""Strict nbval on notebooks from our builder: real ROS, moving images, and mistakes that must not pass."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.programs.support import wait_until
from workbook.authoring.building import build_exercise
from workbook.authoring.comparing import NBVAL, compare, compare_run
from workbook.authoring.document import Cell, Document, as_notebook, to_text, with_ids
from workbook.authoring.nbval_glue import LiveOutputs
from workbook.authoring.running import run
from workbook.authoring.skeleton import new_exercise
from workbook.authoring.tree import AuthoringError, Tree

PUB_SUB = """\
import rclpy
from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
from std_msgs.msg import String

context = Context()
rclpy.init(context=context)
node = rclpy.create_node("talker_and_listener", context=context)
heard = []
node.create_subscription(String, "/robot/status", lambda message: heard.append(message.data), 10)
publisher = node.create_publisher(String, "/robot/status", 10)
executor = SingleThreadedExecutor(context=context)
executor.add_node(node)
for word in ("operational", "operational", "error"):
    publisher.publish(String(data=word))
    while not heard or heard[-1] != word:
        executor.spin_once(timeout_sec=1.0)
    print("heard", heard[-1])
node.get_logger().info("that was all")
print(node)
heard"""
END = """\
executor.shutdown()
node.destroy_node()
rclpy.shutdown(context=context)
context.ok()"""
MOVING = """\
from IPython.display import display
handle = display({"text/plain": "the robot stands"}, raw=True, display_id=True)
for angle in (10, 20, 30):
    handle.update({"text/plain": f"the robot leans by {angle} degrees"}, raw=True)
print("done")"""
CLEARED = """\
from IPython.display import clear_output
for battery in (99, 98, 97):
    print("battery", battery)
    clear_output(wait=True)
print("battery", 96)"""


@pytest.fixture(autouse=True)
def no_answers_folder(monkeypatch: pytest.MonkeyPatch) -> None:
    """Unset the answers folder, which an earlier test in this process may have set."""
    monkeypatch.delenv("WORKBOOK_ANSWERS", raising=False)


def built(folder: Path, *programs: str, tags: tuple[str, ...] = ()) -> Path:
    """Build a notebook as the builder does, outputs included."""
    cells = with_ids([Cell("code", program, tags=tags) for program in programs])
    notebook = as_notebook(Document(cells, {"lesson": "21_try"}))
    run(Tree(folder), "21_try", notebook)
    path = folder / "notebooks" / "21_try.ipynb"
    path.parent.mkdir(exist_ok=True)
    path.write_text(to_text(notebook), encoding="utf-8")
    return path


def nbval(path: Path) -> tuple[int, str]:
    plugins = ("-pworkbook.authoring.nbval_glue", "-pno:cacheprovider")
    done = subprocess.run(
        [sys.executable, "-m", "pytest", *plugins, "-q", "--color=no", *NBVAL, path.name],
        cwd=path.parent,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    return done.returncode, done.stdout


def changed(path: Path, old: str, new: str) -> Path:
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new), encoding="utf-8")
    return path


@pytest.mark.whole
def test_a_lesson_on_real_ros_passes_again_and_again(tmp_path: Path) -> None:
    path = built(tmp_path, PUB_SUB, END)
    assert "heard error" in path.read_text(encoding="utf-8")
    assert "that was all" in path.read_text(encoding="utf-8")
    for _ in range(2):
        code, said = nbval(path)
        assert code == 0, said
        assert "2 passed" in said


@pytest.mark.whole
def test_files_that_a_lesson_writes_are_gone_afterward_and_new_each_time(tmp_path: Path) -> None:
    path = built(tmp_path, "%%writefile my_wave.py\nwave = 1", "import my_wave\nprint(my_wave.wave)")
    assert "Writing my_wave.py" in path.read_text(encoding="utf-8")
    for _ in range(2):
        code, said = nbval(path)
        assert code == 0, said
        assert [one.name for one in path.parent.iterdir()] == [path.name]


def test_two_builds_of_a_lesson_on_real_ros_are_the_same(tmp_path: Path) -> None:
    first = built(tmp_path, PUB_SUB, END).read_bytes()
    assert built(tmp_path, PUB_SUB, END).read_bytes() == first


@pytest.mark.whole
def test_the_last_state_is_compared_and_noise_is_not(tmp_path: Path) -> None:
    place = "import os\nprint('answers at', len(os.environ.get('WORKBOOK_ANSWERS', '')) > 0)"
    path = built(tmp_path, MOVING, CLEARED, "print(object())", place)
    text = path.read_text(encoding="utf-8")
    assert "the robot leans by 20 degrees" not in text
    assert "battery 97" not in text
    assert "0x…" in text
    changed(path, "answers at False", "answers at True")  # nbval runs each notebook in a separate folder
    code, said = nbval(path)
    assert code == 0, said
    changed(path, "the robot leans by 30 degrees", "the robot falls")
    changed(path, "battery 96", "battery 95")
    code, said = nbval(path)
    assert code == 1
    assert "Cell 0: Cell outputs differ" in said
    assert "Cell 1: Cell outputs differ" in said
    assert "2 failed, 2 passed" in said


MEASURED = """\
from workbook.lesson import about
age = 23.1
print(f"JPEG: {about(age, 'ms', between=(5, 60)):>10} old, raw: {about(9.4, 'ms', between=(5, 60)):>10} old")"""


def test_a_marked_number_may_differ_within_its_range_and_the_words_may_not(tmp_path: Path) -> None:
    path = built(tmp_path, MEASURED, MEASURED)
    assert "JPEG:    ≈ 23 ms old, raw:   ≈ 9.4 ms old" in path.read_text(encoding="utf-8")
    changed(path, "JPEG:    ≈ 23 ms old", "JPEG: ≈ 1,402.5 ms old")
    code, said = nbval(path)
    assert code == 0, said
    changed(path, "raw:   ≈ 9.4 ms old", "raw:   ≈ 9.4 s old")
    code, said = nbval(path)
    assert code == 1
    assert "Cell outputs differ" in said


@pytest.mark.parametrize("tags", [(), ("nbval-ignore-output",)], ids=["compared", "ignored"])
def test_a_marked_number_outside_of_its_range_fails(tags: tuple[str, ...], tmp_path: Path) -> None:
    path = built(
        tmp_path, "from pathlib import Path\nage = 23.1", MEASURED.replace("age = 23.1\n", ""), tags=tags
    )
    changed(path, "age = 23.1", "age = 81.0")
    code, said = nbval(path)
    assert code == 1
    assert "unusual on this machine" in said


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("1 of 2\\n", "1 of 3\\n", "Cell outputs differ"),
        ('"print(2)"', '"print(1 + 1)"', "another cell here"),
        ('"execution_count": 2', '"execution_count": null', "was not run"),
    ],
    ids=["another output", "another source", "not run"],
)
def test_what_was_run_elsewhere_is_compared_as_strictly(
    old: str, new: str, said: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    tree, ran = Tree(tmp_path), tmp_path / "ran.ipynb"
    shutil.copy(built(tmp_path, "print('1 of 2')", "print(2)"), ran)
    assert compare_run(tree, "21_try", ran) == 0, capfd.readouterr().out
    changed(ran, old, new)
    assert compare_run(tree, "21_try", ran) == 1
    assert said in capfd.readouterr().out


def test_a_magic_that_does_not_exist_fails_even_where_nothing_is_compared(tmp_path: Path) -> None:
    path = built(tmp_path, "print(1)")
    changed(path, "print(1)", "%no_such_magic")
    changed(path, '"execution_count": 1', '"execution_count": null')
    path.write_text(re.sub(r'"outputs": \[.*?\n   \]', '"outputs": []', path.read_text(), flags=re.DOTALL))
    code, said = nbval(path)
    assert code == 1
    assert "UsageError: Line magic function `%no_such_magic` not found" in said


@pytest.mark.whole
def test_an_exercise_is_run_with_the_starter_and_with_the_solution(
    tmp_path: Path,
    temporary: Path,
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setenv("WORKBOOK_COURSE", str(tmp_path))
    tree = Tree(tmp_path)
    new_exercise(tree, "21_horn")
    build_exercise(tree, "21_horn")
    solution = tree.solutions / "21_horn.py"
    changed(solution, "self.create_timer(0.5,", "self.create_timer(0.25,")
    assert compare(tree, extra=["--color=no"]) == 1
    said = capfd.readouterr().out
    assert "1 failed, 11 passed" in said
    assert "exercises/21_horn.ipynb::Cell 9" in said
    # Helpers notice some time after the kill that their kernel is gone, and clean up.
    wait_until(lambda: not list(temporary.iterdir()), "no temporary folder is left")


def test_a_notebook_that_is_not_built_is_named(tmp_path: Path) -> None:
    tree = Tree(tmp_path)
    tree.sources.mkdir(parents=True)
    (tree.sources / "21_horn.py").touch()
    with pytest.raises(AuthoringError, match=r"notebooks/21_horn\.ipynb is not built"):
        compare(tree)


def message(kind: str, name: str | None = None, text: str = "", **content: object) -> dict[str, object]:
    inner: dict[str, object] = {"data": {"text/plain": text}, **content}
    if name:
        inner["transient"] = {"display_id": name}
    return {"msg_type": kind, "content": inner}


def test_updates_reach_the_display_that_they_name() -> None:
    waiting = [
        message("display_data", "a", "1"),
        message("display_data", "b", "2"),
        message("update_display_data", "a", "3"),
        message("update_display_data", "unknown", "4"),
        message("clear_output", wait=True),
        message("status"),
        message("stream", text="new"),
    ]
    outputs: list[dict[str, object]] = []
    ask = LiveOutputs(lambda **_: waiting.pop(0), lambda: outputs)
    for _ in range(2):
        outputs.append({"data": ask()["content"]["data"]})
    assert ask()["msg_type"] == "status"
    assert outputs == [{"data": {"text/plain": "3"}}, {"data": {"text/plain": "2"}}]
    assert ask()["msg_type"] == "stream"
    assert outputs == []

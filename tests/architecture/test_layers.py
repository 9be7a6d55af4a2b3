"""Imports point one way: down the layers of `workbook/`, and never from the workbook into lessons or solutions."""

import ast
import subprocess
import sys
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
LAYERS = (
    ("cli", "magics", "lab", "authoring"),
    ("lesson",),
    ("grading",),
    ("feedback", "pictures"),
    ("exercise",),
    ("criteria",),
    ("watching",),
    ("isolation", "typechecking"),
    ("programs",),
    ("recording",),
    ("models",),
    ("scenes",),
    ("ros",),
    ("inside",),
)
"""From top to bottom. A package may import from lower layers, and from its own layer if that makes no cycle."""
ONLY = {
    "inside": set(),
    "recording": set(),
    "scenes": set(),
    "models": {"scenes"},
    "criteria": {"recording", "scenes"},
}
"""Packages that may import fewer packages of the workbook than their layer allows, because they run without ROS."""
DEPTH_OF = {package: depth for depth, layer in enumerate(LAYERS) for package in layer}
MESSAGES = {
    "std_msgs",
    "sensor_msgs",
    "geometry_msgs",
    "nav_msgs",
    "trajectory_msgs",
    "diagnostic_msgs",
    "std_srvs",
    "visualization_msgs",
}
MODULES = sorted((ROOT / "workbook").rglob("*.py"))


def imported(path: Path) -> set[str]:
    """Return the fully qualified names of all modules that a file imports, anywhere in the file."""
    names: set[str] = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            names.add(node.module)
            names |= {f"{node.module}.{alias.name}" for alias in node.names}
    return names


def label(path: Path) -> str:
    return str(path.relative_to(ROOT))


def packages_imported(path: Path) -> set[str]:
    """Return the other packages of the workbook that a file imports."""
    found = {name.split(".")[1] for name in imported(path) if name.startswith("workbook.")}
    return (found & set(DEPTH_OF)) - {path.relative_to(ROOT / "workbook").parts[0]}


def points_up(path: Path) -> set[str]:
    """Return the packages above its own layer that a file imports."""
    parts = path.relative_to(ROOT / "workbook").parts
    if len(parts) < 2:
        return set()
    return {package for package in packages_imported(path) if DEPTH_OF[package] < DEPTH_OF[parts[0]]}


def test_every_package_is_in_a_layer() -> None:
    packages = {path.parent.name for path in (ROOT / "workbook").glob("*/__init__.py")}
    assert packages == set(DEPTH_OF)


@pytest.mark.parametrize("path", MODULES, ids=label)
def test_imports_point_down(path: Path) -> None:
    assert not {
        name for name in imported(path) if name.split(".")[0] in ("lesson_nodes", "solutions", "tests")
    }
    assert not points_up(path)


def test_no_circle_of_packages() -> None:
    graph: dict[str, set[str]] = {}
    for path in MODULES:
        parts = path.relative_to(ROOT / "workbook").parts
        if len(parts) > 1:
            graph.setdefault(parts[0], set()).update(packages_imported(path))
    assert set(TopologicalSorter(graph).static_order()) == set(DEPTH_OF)


@pytest.mark.parametrize("package", ONLY)
def test_packages_that_need_no_ros_import_few_others(package: str) -> None:
    for path in MODULES:
        if path.relative_to(ROOT / "workbook").parts[0] == package:
            assert packages_imported(path) <= ONLY[package], label(path)


@pytest.mark.parametrize("path", sorted((ROOT / "workbook" / "recording").glob("*.py")), ids=label)
def test_recordings_need_the_standard_library_only(path: Path) -> None:
    for name in imported(path):
        assert name.startswith("workbook.recording") or name.split(".")[0] in sys.stdlib_module_names, name


@pytest.mark.parametrize("path", sorted((ROOT / "workbook" / "models").glob("*.py")), ids=label)
def test_models_need_no_ros(path: Path) -> None:
    allowed = {"numpy", "onnxruntime", "workbook", *sys.stdlib_module_names}
    extras = {"train.py": {"torch"}, "export.py": {"onnx"}, "networks.py": {"torch", "keras"}}
    assert {name.split(".")[0] for name in imported(path)} <= allowed | extras.get(path.name, set())


def test_a_detector_waits_for_neither_torch_nor_keras() -> None:
    code = (
        "import sys, workbook.models; workbook.models.DeskDetector();"
        "assert not {'torch', 'keras', 'onnx', 'rclpy'} & set(sys.modules)"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def test_templating_is_below_all_layers() -> None:
    """From the workbook, it imports only the module that makes text plain, which needs only the standard library."""
    found = {name for name in imported(ROOT / "workbook" / "templating.py") if name.startswith("workbook")}
    plain_text = "workbook.recording.plain_text"
    assert found <= {plain_text, f"{plain_text}.without_commands"}
    assert not {name for name in imported(ROOT / f"{plain_text.replace('.', '/')}.py") if "workbook" in name}


@pytest.mark.parametrize(
    "module", ["workbook.cli.check", "workbook.grading.slots.worker", "workbook.feedback.text"]
)
def test_who_shows_no_html_does_not_wait_for_jinja2(module: str) -> None:
    code = f"import sys, {module}; assert 'jinja2' not in sys.modules"
    subprocess.run([sys.executable, "-c", code], check=True)


@pytest.mark.parametrize("path", sorted((ROOT / "exercises" / "criteria").glob("*.py")), ids=label)
def test_criteria_import_the_vocabulary_and_messages_only(path: Path) -> None:
    """Criteria import the vocabulary from `workbook.criteria`, so its modules can be rearranged."""
    for name in imported(path):
        top = name.split(".")[0]
        assert not name.startswith("workbook.criteria.vocabulary"), name
        assert name.startswith("workbook.criteria") or top in MESSAGES | set(sys.stdlib_module_names), name


@pytest.mark.parametrize("path", sorted((ROOT / "lesson_nodes").glob("*.py")), ids=label)
def test_lesson_nodes_import_ros_scenes_models_numpy_and_opencv_only(path: Path) -> None:
    for name in imported(path):
        top = name.split(".")[0]
        if name.startswith(("workbook.scenes", "workbook.models")):
            continue
        assert top in {"rclpy", "lesson_nodes", "cv2", "numpy"} | MESSAGES | set(sys.stdlib_module_names), (
            name
        )


def test_no_path_of_a_machine_and_no_registry_host_is_tracked() -> None:
    hosts = "|".join(("pypi", r"registry\.npmjs", r"deb\.debian")) + r"\.org"
    here = str(ROOT).replace(".", r"\.")
    pattern = rf"(python{'hosted'}|https?://({hosts})|{here}/|/{'root'}/[.])"
    found = subprocess.run(
        ["git", "grep", "-nIE", pattern, "--", ".", f":!{Path(__file__).relative_to(ROOT)}"],
        cwd=ROOT,
        capture_output=True,
        text=True,
    )
    if found.returncode not in (0, 1):
        pytest.skip(f"no git checkout: {found.stderr.strip()}")
    assert found.stdout == ""

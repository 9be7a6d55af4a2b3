"""requirements.lock: hashes for all packages, no registry, and sections that match each other and pyproject.toml."""

import re
import tomllib
from pathlib import Path

import pytest

from workbook.lab import bootstrap, lock

ROOT = Path(lock.__file__).resolve().parents[2]
TEXT = (ROOT / "requirements.lock").read_text(encoding="utf-8")
SECTIONS = bootstrap.read_sections(TEXT)


def names(*sections: str) -> set[str]:
    return {line.partition("==")[0] for section in sections for line in SECTIONS[section]}


def normal(requirement: str) -> str:
    return re.split(r"[\[<>=!~; ]", requirement)[0].lower().replace("_", "-")


def test_sections() -> None:
    assert tuple(SECTIONS) == bootstrap.SECTIONS
    assert all(SECTIONS.values())


def test_every_package_has_hashes_and_an_exact_version() -> None:
    for entries in SECTIONS.values():
        for requirement, hashes in entries.items():
            assert re.match(r"[a-z0-9-]+==[\w.]+(?: ; .+)?$", requirement), requirement
            assert hashes, requirement
            assert all(re.fullmatch(r"--hash=sha256:[0-9a-f]{64}", line) for line in hashes), requirement


def test_no_registry_and_no_machine_is_named() -> None:
    assert not re.search(r"://|--(extra-)?index|--find-links|@ ", TEXT)


def test_it_has_what_the_project_file_asks_for() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert {normal(item) for item in project["dependencies"]} <= names("build", "student")
    for extra, wanted in project["optional-dependencies"].items():
        assert {normal(item) for item in wanted} <= names("build", "student", extra), extra
    assert "ros-jazzy-rclpy==7.1.6" in SECTIONS["student"]


def test_a_students_environment_is_lean() -> None:
    assert not {"pytest", "ruff", "torch", "jupyterlab-lsp", "playwright", "distributed"} & names(
        "build", "student"
    )


@pytest.mark.parametrize("python", [(3, 11), (3, 12), (3, 13), (3, 14)])
def test_one_version_of_a_package_for_each_python(python: tuple[int, int]) -> None:
    from packaging.requirements import Requirement

    environment = {
        "python_version": f"{python[0]}.{python[1]}",
        "python_full_version": f"{python[0]}.{python[1]}.9",
    }
    chosen: dict[str, str] = {}
    for entries in SECTIONS.values():
        for line in entries:
            requirement = Requirement(line)
            if requirement.marker is None or requirement.marker.evaluate(environment):
                assert chosen.setdefault(requirement.name, str(requirement.specifier)) == str(
                    requirement.specifier
                )
    assert {"numpy", "ros-rclpy", "jupyterlab", "pytest", "torch"} <= set(chosen)


def test_sections_become_requirements_text_without_repetition() -> None:
    text = bootstrap.requirements(SECTIONS, ["build", "student", "dev"])
    lines = [line for line in text.splitlines() if not line.startswith("    ")]
    assert len(lines) == len(set(lines))
    assert "pytest" in text
    assert "torch" not in text
    assert bootstrap.read_sections("#: all\n" + text)["all"].keys() == {line.rstrip(" \\") for line in lines}


def test_the_compiled_text_is_read_whole() -> None:
    compiled = (
        "numpy==2.4.6 ; python_full_version < '3.12' and platform_machine == 'x86_64' and sys_platform == 'linux' \\\n"
        "    --hash=sha256:aa \\\n    --hash=sha256:bb\n"
        "six==1.17.0 ; platform_machine == 'x86_64' and sys_platform == 'linux' \\\n    --hash=sha256:cc\n"
    )
    assert lock.parse(compiled) == {
        "numpy==2.4.6 ; python_full_version < '3.12'": "--hash=sha256:aa\n--hash=sha256:bb",
        "six==1.17.0": "--hash=sha256:cc",
    }

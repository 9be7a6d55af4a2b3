"""Ways to start that no test can try here: their files must agree with each other and with the package."""

import json
import re
import subprocess
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DOCKERFILE = (ROOT / "Dockerfile").read_text(encoding="utf-8")
PACKAGE = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
NAMES_ELSEWHERE = {"opencv-python-headless": "py-opencv"}
"""Packages that have another name in conda."""


def required() -> dict[str, str]:
    """Return the package's requirements except ROS: name and limits."""
    found = [
        re.fullmatch(r"([\w-]+)(\S*)", one) for one in PACKAGE["dependencies"] if not one.startswith("ros-")
    ]
    return {one[1]: one[2] for one in found if one}


def test_robostack_has_what_the_package_asks_for() -> None:
    pixi = tomllib.loads((ROOT / "pixi.toml").read_text(encoding="utf-8"))
    there = pixi["dependencies"]
    assert {
        NAMES_ELSEWHERE.get(name, name): limits for name, limits in required().items()
    }.items() <= there.items()
    assert {"ros-jazzy-rclpy", "ros-jazzy-common-interfaces"} <= there.keys()
    assert {"osx-arm64", "osx-64", "win-64", "linux-aarch64"} <= set(pixi["workspace"]["platforms"])
    assert {"lab", "doctor", "check"} <= pixi["tasks"].keys()


def test_the_script_for_apt_installs_what_the_package_asks_for() -> None:
    script = ROOT / "deploy" / "with_apt_ros.sh"
    subprocess.run(["sh", "-n", script], check=True)
    text = script.read_text(encoding="utf-8")
    assert not [name + limits for name, limits in required().items() if f"'{name}{limits}'" not in text]


def test_the_image_for_arm_installs_what_the_package_asks_for() -> None:
    text = (ROOT / "deploy" / "arm64.Dockerfile").read_text(encoding="utf-8")
    assert not [name + limits for name, limits in required().items() if f"'{name}{limits}'" not in text]


def test_the_image_is_for_students() -> None:
    """Its user isn't root, it contains just the course's wheel, it checks its health, and a student's work survives."""
    last = DOCKERFILE.rpartition("\nFROM ")[2]
    assert "COPY --from=build /opt/workbook" in last and last.count("COPY") == 1
    assert "USER student" in last and "HEALTHCHECK" in last and "VOLUME /home/student/robots" in last
    assert 'CMD ["rclpy-workbook", "lab"' in last


def test_codespaces_and_binder_use_the_same_image() -> None:
    folder = ROOT / ".devcontainer"
    container = json.loads((folder / "devcontainer.json").read_text(encoding="utf-8"))
    assert (folder / container["build"]["dockerfile"]).resolve() == ROOT / "Dockerfile"
    assert (folder / container["build"]["context"]).resolve() == ROOT
    assert container["remoteUser"] == "student"
    assert (ROOT / ".binder" / "Dockerfile").resolve() == ROOT / "Dockerfile"

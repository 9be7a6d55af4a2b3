"""The message packages' stubs: up to date, sound, and as strict as the field checks at run time."""

import importlib
import subprocess
import sys
from pathlib import Path

import pytest

from workbook.authoring.typings import PACKAGES, stubs, write
from workbook.typechecking.typecheck import SETTINGS, TYPINGS, type_check


def test_the_stubs_are_those_of_the_installed_messages(tmp_path: Path) -> None:
    made = dict(stubs())
    kept = {str(path.relative_to(TYPINGS)): path.read_text() for path in TYPINGS.rglob("*.pyi")}
    assert kept == made, "run `python -m workbook.authoring typings`"
    assert write(tmp_path) == len(made)
    assert {str(path.relative_to(tmp_path)) for path in tmp_path.rglob("*.pyi")} == set(made)


def test_mypy_finds_nothing_in_the_stubs_themselves(tmp_path: Path) -> None:
    packages = [part for package in PACKAGES for part in ("-p", package)]
    done = subprocess.run(
        [sys.executable, "-m", "mypy", f"--config-file={SETTINGS}", f"--cache-dir={tmp_path}", *packages],
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize("package", PACKAGES)
def test_every_message_has_its_class_and_its_fields(package: str) -> None:
    for path in (TYPINGS / package).glob("*/__init__.pyi"):
        module = importlib.import_module(f"{package}.{path.parent.name}")
        text = path.read_text()
        for name, one in vars(module).items():
            if isinstance(one, type):
                assert f"\nclass {name}:\n" in text
                if hasattr(one, "get_fields_and_field_types"):
                    body = text.partition(f"\nclass {name}:\n")[2].partition("\nclass ")[0]
                    for field in one.get_fields_and_field_types():  # type: ignore[attr-defined]
                        assert f"    {field}: " in body or f"    def {field}(self) -> " in body


HEAD = """\
from array import array
import numpy as np
from builtin_interfaces.msg import Time
from geometry_msgs.msg import Point, PoseWithCovariance, Twist
from sensor_msgs.msg import BatteryState, Image, JointState
from std_msgs.msg import ByteMultiArray, Float32, Float32MultiArray, Header, String
from std_srvs.srv import SetBool, Trigger
"""
RIGHT = """\
level = Float32(data=99.5)
level.data = 98.0
twist = Twist()
twist.linear.x = 0.5
joints = JointState(name=["hip", "knee"], position=[0.1, 0.2])
joints.position = array("d", [0.1])
joints.position.append(0.3)
joints.name.append("ankle")
joints.header = Header(stamp=Time(sec=1), frame_id="body")
picture = Image(data=bytes(12), height=2)
pose = PoseWithCovariance(covariance=np.zeros(36))
pose.covariance = [0.0] * 36
spread: float = float(pose.covariance.max())
state = BatteryState(power_supply_status=BatteryState.POWER_SUPPLY_STATUS_FULL)
angles = Float32MultiArray(data=[0.0] * 12)
raw = ByteMultiArray(data=[b"\\x01"])
request = SetBool.Request(data=True)
reply = Trigger.Response(success=True, message="fine")
checked = String(data="ok", check_fields=True)
"""
WRONG = {
    'Float32(data="full")': "arg-type",
    'Float32().data = "full"': "assignment",
    "Float32(dta=1.0)": "call-arg",
    "Float32().dta": "attr-defined",
    "Float32().dta = 1.0": "attr-defined",
    "Float32(99.5)": "call-arg",
    "String(data=3)": "arg-type",
    "String(data=None)": "arg-type",
    'JointState(name="knee")': "arg-type",
    "JointState(position=0.5)": "arg-type",
    'JointState().position = ["far"]': "list-item",
    "Twist(linear=Point())": "arg-type",
    "Twist().linear.w = 1.0": "attr-defined",
    "Image(data=1)": "arg-type",
    'SetBool.Request(data="yes")': "arg-type",
    "Trigger.Response(sucess=True)": "call-arg",
    "BatteryState.POWER_SUPPLY_STATUS_FUL": "attr-defined",
}


def test_right_use_of_messages_is_no_error() -> None:
    assert type_check(HEAD + RIGHT) == ()


def test_right_use_of_messages_runs_with_field_checks_on() -> None:
    switch = "import os\nos.environ['ROS_PYTHON_CHECK_FIELDS'] = '1'\n"
    done = subprocess.run(
        [sys.executable, "-c", switch + HEAD + RIGHT], capture_output=True, text=True, timeout=60
    )
    assert done.returncode == 0, done.stderr


def test_wrong_use_of_messages_is_an_error_each_time() -> None:
    found = type_check(HEAD + "\n".join(WRONG))
    first = HEAD.count("\n") + 1
    codes = {finding.line - first: finding.code for finding in reversed(found)}
    said = {text: codes.get(line) for line, text in enumerate(WRONG)}
    assert said == WRONG

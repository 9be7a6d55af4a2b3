"""A lesson's cells in a plain Python that no kernel has set up."""

import os
import subprocess
import sys

from workbook.ros.environment import LOOPBACK_PROFILE

CELL = """
import os
from pathlib import Path

import rclpy

from workbook.lesson import init

init()
node = rclpy.create_node("robot")
print(os.environ["FASTRTPS_DEFAULT_PROFILES_FILE"])
print("/dev/shm/fastrtps" in Path("/proc/self/maps").read_text())
"""


def test_its_traffic_stays_here_and_uses_no_shared_memory() -> None:
    """A killed program would leave its shared memory behind, because Fast DDS removes it only at an orderly end."""
    environ = {name: value for name, value in os.environ.items() if not name.startswith(("FASTRTPS", "ROS_"))}
    done = subprocess.run(
        [sys.executable, "-c", CELL], env=environ, capture_output=True, text=True, timeout=120
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines() == [str(LOOPBACK_PROFILE), "False"]

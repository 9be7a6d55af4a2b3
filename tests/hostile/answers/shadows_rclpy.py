# score: 0
# says: hides the package
"""Puts files beside itself that have the names of modules, as a folder full of tries has them, and imports from one."""
import os
import site
import sys

personal = site.getusersitepackages()
os.makedirs(personal)
for name in ("rclpy.py", "sensor_msgs.py", "conftest.py", "sitecustomize.py", f"{personal}/usercustomize.py"):
    with open(name, "w") as file:
        file.write("def init(*_, **__): pass\n")
with open(f"{personal}/mine.pth", "w") as file:
    file.write("import usercustomize\n")
sys.path.insert(0, ".")
from sensor_msgs.msg import JointState

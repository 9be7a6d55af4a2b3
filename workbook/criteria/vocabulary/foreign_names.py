"""Explain names that don't exist here, but do exist in ROS 1, a full ROS 2 installation, or another Python package."""

import re
from collections.abc import Mapping

from workbook.criteria.rules import Reason, Words

WORDS = Words(__file__)

_MODULES = (
    ("desktop.plain", "nav2_simple_commander moveit urdf_parser_py xacro rosbag2_py rqt_gui rqt_gui_py"),
    ("desktop.plain", "rqt_py_common python_qt_binding"),
    ("desktop.by-hand", "image_geometry tf2_ros tf2_py tf2_msgs tf2_geometry_msgs tf2_sensor_msgs tf2_kdl"),
    ("desktop.by-hand", "tf_transformations laser_geometry control_toolbox"),
    ("desktop.messages", "turtlesim control_msgs vision_msgs moveit_msgs nav2_msgs map_msgs pcl_msgs"),
    ("desktop.messages", "action_tutorials_interfaces ros_gz_interfaces gazebo_msgs"),
    ("desktop.image_transport", "image_transport image_transport_py"),
    ("desktop.joint_state_publisher", "joint_state_publisher joint_state_publisher_gui"),
    ("tools.start-in-main", "launch launch_ros launch_xml launch_yaml"),
    ("tools.plain", "launch_testing launch_testing_ros launch_param_builder ros2cli ros2pkg ros2run"),
    ("tools.plain", "ros2topic ament_package colcon"),
    ("ros-1.plain", "catkin catkin_pkg rospkg rosbag rosmsg rosunit rostest actionlib moveit_commander"),
    ("ros-1.by-hand", "tf tf_conversions"),
    ("ros-1.start-in-main", "roslaunch"),
    ("python.by-hand", "transforms3d"),
    ("python.plain", "pandas torch torchvision tensorflow keras jax ultralytics transformers mediapipe"),
    ("python.plain", "pygame serial pyserial RPi smbus smbus2 gpiozero pynput keyboard simple_pid pid"),
    (
        "python.plain",
        "control filterpy sympy numba skimage open3d pyrealsense2 pybullet mujoco gym gymnasium",
    ),
    (
        "python.plain",
        "imutils dlib face_recognition pyttsx3 speech_recognition board busio adafruit_servokit",
    ),
)
"""Modules by catalog entry: Jazzy desktop packages that aren't in the wheels, ROS 1 modules, and PyPI packages.

Source of the ROS packages: https://www.ros.org/reps/rep-2001.html.
"""
_WITH_AN_ENTRY = {
    "desktop": "cv_bridge sensor_msgs_py message_filters example_interfaces rosidl_runtime_py",
    "ros-1": "rospy roscpp roslib rosgraph rosnode rostopic rosparam rosservice dynamic_reconfigure",
    "python": "cv",
}
"""More modules by catalog section. Each module has a catalog entry under its name."""
_OF_RCLPY = {
    "rospy": "Rate sleep Timer Time get_time get_rostime Duration init_node Publisher Subscriber Subscription Service "
    "ServiceProxy wait_for_service wait_for_message get_param set_param has_param get_name get_namespace get_caller_id "
    "is_shutdown on_shutdown signal_shutdown",
    "rospy-class": "ROSInterruptException ROSException ServiceException Message AnyMsg",
}
"""rospy names that students look for in rclpy, by catalog section."""


def _own(sections: Mapping[str, str]) -> dict[str, Reason]:
    return {
        name: WORDS.reason(f"{section}.{name}", ("name",))
        for section, names in sections.items()
        for name in names.split()
    }


_MODULE = _own(_WITH_AN_ENTRY) | {
    name: WORDS.reason(entry, ("name",)) for entry, names in _MODULES for name in names.split()
}
_IN_RCLPY = _own(_OF_RCLPY)
_LOG = WORDS.reason("rospy.log", ("name", "severity"))
_SEVERITIES = {"debug": "debug", "info": "info", "warn": "warning", "err": "error", "fatal": "fatal"}
_OF_STD_SRVS = WORDS.reason("std_srvs.names")
_LOGS = re.compile(rf"log(?P<level>{'|'.join(_SEVERITIES)})(?:_once|_throttle)?")
_NOT_FOUND = re.compile(r"ModuleNotFoundError: No module named '(?P<module>[\w.]+)'")
_NO_ATTRIBUTE = re.compile(
    r"module 'rclpy' has no attribute '(?P<name>\w+)'|cannot import name '(?P<from>\w+)' from 'rclpy'|"
    r"No module named 'rclpy\.(?P<module>\w+)'"
)
_SERVICES = re.compile(r"No module named '(?:std|geometry|sensor|nav)_msgs\.srv'")


def foreign_name(error: str) -> tuple[str, str, str] | None:
    """Return the cause id for a name from elsewhere, and the strings `because` and `try`.

    The result is None if the error isn't about such a name.
    """
    if _SERVICES.search(error):
        return "error.name-in-other-module", *_OF_STD_SRVS()
    asked = _NO_ATTRIBUTE.search(error)
    missing = None if asked else _NOT_FOUND.search(error)
    if missing is not None:
        return _missing(missing["module"].split(".")[0])
    name = (asked["name"] or asked["from"] or asked["module"].capitalize()) if asked else ""
    log = _LOGS.fullmatch(name)
    if log is not None:
        return "error.name-of-ros-1", *_LOG(name=name, severity=_SEVERITIES[log["level"]])
    return ("error.name-of-ros-1", *_IN_RCLPY[name](name=name)) if name in _IN_RCLPY else None


def _missing(module: str) -> tuple[str, str, str] | None:
    alike = "colcon" if module.startswith(("ament_", "colcon_")) else module
    reason = _MODULE.get(alike)
    if reason is None:
        return None
    cause = "error.module-of-ros-1" if reason.id.startswith("ros-1.") else "error.module-not-installed"
    return cause, *reason(name=module)

"""Names that exist in another ROS or a full installation, but not here: where each is from, what to use here."""

import re

_ROS1, _DESKTOP, _COMMAND, _PYPI = (
    "{name} belongs to ROS 1. It doesn't exist in ROS 2.",
    "{name} is a package of a full ROS 2 installation. It isn't installed here.",
    "{name} belongs to the tools that build and start ROS 2 packages. They aren't installed here.",
    "{name} is a Python package that isn't installed here.",
)
_NUMPY_IMAGE = (
    "Read the pixels with NumPy: np.frombuffer(image.data, np.uint8), then reshape with image.height and "
    "image.step."
)
_PLAIN = "Use only rclpy, the message packages and the packages that the exercise names."
_BY_HAND = "Compute it in your node, with math or NumPy."
_MODULES: dict[str, tuple[str, str]] = {
    "cv_bridge": (_DESKTOP, _NUMPY_IMAGE),
    "image_geometry": (_DESKTOP, _BY_HAND),
    "image_transport": (_DESKTOP, "Subscribe to the Image topic itself."),
    "image_transport_py": (_DESKTOP, "Subscribe to the Image topic itself."),
    "sensor_msgs_py": (_DESKTOP, "Read the bytes of the message with np.frombuffer."),
    "message_filters": (_DESKTOP, "Keep the latest message of each topic, and compare their stamps."),
    "tf2_ros": (_DESKTOP, _BY_HAND),
    "tf2_py": (_DESKTOP, _BY_HAND),
    "tf2_msgs": (_DESKTOP, _BY_HAND),
    "tf2_geometry_msgs": (_DESKTOP, _BY_HAND),
    "tf2_sensor_msgs": (_DESKTOP, _BY_HAND),
    "tf2_kdl": (_DESKTOP, _BY_HAND),
    "tf_transformations": (_DESKTOP, _BY_HAND),
    "transforms3d": (_PYPI, _BY_HAND),
    "laser_geometry": (_DESKTOP, _BY_HAND),
    "example_interfaces": (_DESKTOP, "Use std_msgs.msg and std_srvs.srv."),
    "turtlesim": (_DESKTOP, "Use the messages that the exercise names."),
    "control_msgs": (_DESKTOP, "Use the messages that the exercise names."),
    "vision_msgs": (_DESKTOP, "Use the messages that the exercise names."),
    "moveit_msgs": (_DESKTOP, "Use the messages that the exercise names."),
    "nav2_msgs": (_DESKTOP, "Use the messages that the exercise names."),
    "map_msgs": (_DESKTOP, "Use the messages that the exercise names."),
    "pcl_msgs": (_DESKTOP, "Use the messages that the exercise names."),
    "action_tutorials_interfaces": (_DESKTOP, "Use the messages that the exercise names."),
    "control_toolbox": (_DESKTOP, _BY_HAND),
    "nav2_simple_commander": (_DESKTOP, _PLAIN),
    "moveit": (_DESKTOP, _PLAIN),
    "ros_gz_interfaces": (_DESKTOP, "Use the messages that the exercise names."),
    "gazebo_msgs": (_DESKTOP, "Use the messages that the exercise names."),
    "joint_state_publisher": (_DESKTOP, "Publish a JointState from your node."),
    "joint_state_publisher_gui": (_DESKTOP, "Publish a JointState from your node."),
    "urdf_parser_py": (_DESKTOP, _PLAIN),
    "xacro": (_DESKTOP, _PLAIN),
    "rosbag2_py": (_DESKTOP, _PLAIN),
    "rosidl_runtime_py": (_DESKTOP, "Read the fields of the message by their names."),
    "rqt_gui": (_DESKTOP, _PLAIN),
    "rqt_gui_py": (_DESKTOP, _PLAIN),
    "rqt_py_common": (_DESKTOP, _PLAIN),
    "python_qt_binding": (_DESKTOP, _PLAIN),
    "launch": (_COMMAND, "Start the node in main(): rclpy.init(), then rclpy.spin(node)."),
    "launch_ros": (_COMMAND, "Start the node in main(): rclpy.init(), then rclpy.spin(node)."),
    "launch_xml": (_COMMAND, "Start the node in main(): rclpy.init(), then rclpy.spin(node)."),
    "launch_yaml": (_COMMAND, "Start the node in main(): rclpy.init(), then rclpy.spin(node)."),
    "launch_testing": (_COMMAND, _PLAIN),
    "launch_testing_ros": (_COMMAND, _PLAIN),
    "launch_param_builder": (_COMMAND, _PLAIN),
    "ros2cli": (_COMMAND, _PLAIN),
    "ros2pkg": (_COMMAND, _PLAIN),
    "ros2run": (_COMMAND, _PLAIN),
    "ros2topic": (_COMMAND, _PLAIN),
    "ament_package": (_COMMAND, _PLAIN),
    "colcon": (_COMMAND, _PLAIN),
    "catkin": (_ROS1, _PLAIN),
    "catkin_pkg": (_ROS1, _PLAIN),
    "rospy": (_ROS1, "Import rclpy, and write a class that inherits from rclpy.node.Node."),
    "roscpp": (_ROS1, "Import rclpy."),
    "roslib": (_ROS1, "Remove the line: ROS 2 finds its packages without it."),
    "rospkg": (_ROS1, _PLAIN),
    "rosbag": (_ROS1, _PLAIN),
    "rosgraph": (_ROS1, "Use node.get_node_names() and node.get_topic_names_and_types()."),
    "rosnode": (_ROS1, "Use node.get_node_names()."),
    "rostopic": (_ROS1, "Use node.get_topic_names_and_types()."),
    "rosparam": (_ROS1, "Use node.declare_parameter() and node.get_parameter()."),
    "rosservice": (_ROS1, "Use node.create_client()."),
    "roslaunch": (_ROS1, "Start the node in main(): rclpy.init(), then rclpy.spin(node)."),
    "rosmsg": (_ROS1, _PLAIN),
    "rosunit": (_ROS1, _PLAIN),
    "rostest": (_ROS1, _PLAIN),
    "tf": (_ROS1, _BY_HAND),
    "tf_conversions": (_ROS1, _BY_HAND),
    "actionlib": (_ROS1, _PLAIN),
    "dynamic_reconfigure": (_ROS1, "Use node.declare_parameter() and a parameter callback."),
    "moveit_commander": (_ROS1, _PLAIN),
    "cv": (_PYPI, "Import cv2."),
}
"""The ROS packages of https://www.ros.org/reps/rep-2001.html that a Jazzy desktop has and the wheels don't, and the
Python modules of ROS 1."""
_PIP = frozenset(
    {
        "pandas",
        "torch",
        "torchvision",
        "tensorflow",
        "keras",
        "jax",
        "ultralytics",
        "transformers",
        "mediapipe",
        "pygame",
        "serial",
        "pyserial",
        "RPi",
        "smbus",
        "smbus2",
        "gpiozero",
        "pynput",
        "keyboard",
        "simple_pid",
        "pid",
        "control",
        "filterpy",
        "sympy",
        "numba",
        "skimage",
        "open3d",
        "pyrealsense2",
        "pybullet",
        "mujoco",
        "gym",
        "gymnasium",
        "imutils",
        "dlib",
        "face_recognition",
        "pyttsx3",
        "speech_recognition",
        "board",
        "busio",
        "adafruit_servokit",
    }
)
_SHUTDOWN = "while rclpy.ok()"
_LOG = "self.get_logger()"
_RCLPY: dict[str, tuple[str, str]] = {
    "Rate": ("rospy.Rate", "Use node.create_timer(period, callback). It needs no loop."),
    "sleep": ("rospy.sleep", "Use node.create_timer(period, callback) instead of waiting."),
    "Timer": ("rospy.Timer", "Use node.create_timer(period, callback)."),
    "Time": ("rospy.Time", "Use node.get_clock().now()."),
    "get_time": ("rospy.get_time", "Use node.get_clock().now()."),
    "get_rostime": ("rospy.get_rostime", "Use node.get_clock().now()."),
    "Duration": ("rospy.Duration", "Use Duration(seconds=1.0) from rclpy.duration."),
    "init_node": ("rospy.init_node", "Call rclpy.init(), then create the node: Node('name')."),
    "Publisher": ("rospy.Publisher", "Use node.create_publisher(String, 'topic', 10)."),
    "Subscriber": ("rospy.Subscriber", "Use node.create_subscription(String, 'topic', callback, 10)."),
    "Subscription": ("rospy.Subscriber", "Use node.create_subscription(String, 'topic', callback, 10)."),
    "Service": ("rospy.Service", "Use node.create_service(SetBool, 'name', callback)."),
    "ServiceProxy": ("rospy.ServiceProxy", "Use node.create_client(SetBool, 'name')."),
    "wait_for_service": ("rospy.wait_for_service", "Use client.wait_for_service(timeout_sec=1.0)."),
    "wait_for_message": (
        "rospy.wait_for_message",
        "Use node.create_subscription(String, 'topic', callback, 10).",
    ),
    "get_param": (
        "rospy.get_param",
        "Use node.declare_parameter(name, value), then node.get_parameter(name).value.",
    ),
    "set_param": ("rospy.set_param", "Use node.declare_parameter(name, value), then node.set_parameters()."),
    "has_param": ("rospy.has_param", "Use node.has_parameter(name)."),
    "get_name": ("rospy.get_name", "Use node.get_name()."),
    "get_namespace": ("rospy.get_namespace", "Use node.get_namespace()."),
    "get_caller_id": ("rospy.get_caller_id", "Use node.get_fully_qualified_name()."),
    "is_shutdown": ("rospy.is_shutdown", f"Use {_SHUTDOWN}, or let rclpy.spin(node) wait."),
    "on_shutdown": ("rospy.on_shutdown", "Put it after rclpy.spin(node), in a finally block."),
    "signal_shutdown": ("rospy.signal_shutdown", "Use rclpy.try_shutdown()."),
    "ROSInterruptException": ("rospy", "Catch KeyboardInterrupt and ExternalShutdownException."),
    "ROSException": ("rospy", "Catch the exception that the rclpy call raises."),
    "ServiceException": ("rospy", "Call exception() on the future that call_async() returns."),
    "Message": ("rospy", "Import the message class from its package, such as std_msgs.msg."),
    "AnyMsg": ("rospy", "Import the message class from its package, such as std_msgs.msg."),
    **{
        f"log{level}{more}": (f"rospy.log{level}{more}", f"Use {_LOG}.{word}('text').")
        for level, word in [
            ("debug", "debug"),
            ("info", "info"),
            ("warn", "warning"),
            ("err", "error"),
            ("fatal", "fatal"),
        ]
        for more in ("", "_once", "_throttle")
    },
}
_NOT_FOUND = re.compile(r"ModuleNotFoundError: No module named '(?P<module>[\w.]+)'")
_NO_ATTRIBUTE = re.compile(
    r"module 'rclpy' has no attribute '(?P<name>\w+)'|cannot import name '(?P<from>\w+)' from 'rclpy'|"
    r"No module named 'rclpy\.(?P<module>\w+)'"
)
_SERVICES = re.compile(r"No module named '(?:std|geometry|sensor|nav)_msgs\.srv'")


def foreign_name(error: str) -> tuple[str, str, str] | None:
    """The cause id for a name that is from elsewhere, where it is from, and what to use here; None for others."""
    if _SERVICES.search(error):
        where = "The services SetBool, Trigger and Empty are in std_srvs.srv."
        return "error.name-in-other-module", where, "Write, for example, from std_srvs.srv import SetBool."
    asked = _NO_ATTRIBUTE.search(error)
    missing = None if asked else _NOT_FOUND.search(error)
    if missing is not None:
        return _missing(missing["module"].split(".")[0])
    name = (asked["name"] or asked["from"] or asked["module"].capitalize()) if asked else ""
    if name not in _RCLPY:
        return None
    source, instead = _RCLPY[name]
    return "error.name-of-ros-1", f"This name belongs to ROS 1 ({source}). rclpy doesn't have it.", instead


def _missing(module: str) -> tuple[str, str, str] | None:
    source, instead = _MODULES.get(module, ("", ""))
    if module.startswith(("ament_", "colcon_")):
        source, instead = _COMMAND, _PLAIN
    if module in _PIP:
        source, instead = _PYPI, _PLAIN
    if not source:
        return None
    cause = "error.module-of-ros-1" if source == _ROS1 else "error.module-not-installed"
    return cause, source.format(name=module), instead

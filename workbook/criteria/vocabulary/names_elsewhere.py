"""Names that rclpy and the message packages have, but in another module; and methods of ROS 1 and of C++."""

import re

_MODULES = {
    "rclpy.node": "Node",
    "rclpy.executors": "ExternalShutdownException MultiThreadedExecutor SingleThreadedExecutor",
    "rclpy.callback_groups": "MutuallyExclusiveCallbackGroup ReentrantCallbackGroup",
    "rclpy.qos": "QoSProfile DurabilityPolicy HistoryPolicy LivelinessPolicy ReliabilityPolicy QoSDurabilityPolicy "
    "QoSHistoryPolicy QoSLivelinessPolicy QoSReliabilityPolicy qos_profile_sensor_data",
    "rclpy.duration": "Duration",
    "rclpy.time": "Time",
    "rclpy.clock": "Clock ROSClock",
    "rclpy.parameter": "Parameter",
    "rclpy.task": "Future Task",
    "rclpy.publisher": "Publisher",
    "rclpy.subscription": "Subscription",
    "std_msgs.msg": "Bool Byte Char ColorRGBA Empty Float32 Float32MultiArray Float64 Float64MultiArray Header Int8 "
    "Int16 Int32 Int32MultiArray Int64 MultiArrayDimension MultiArrayLayout String UInt8 UInt8MultiArray UInt16 "
    "UInt32 UInt64",
    "geometry_msgs.msg": "Point Point32 PointStamped Pose Pose2D PoseStamped PoseWithCovarianceStamped Quaternion "
    "QuaternionStamped Transform TransformStamped Twist TwistStamped Vector3 Vector3Stamped Wrench",
    "sensor_msgs.msg": "BatteryState CameraInfo CompressedImage Image Imu JointState Joy LaserScan MagneticField "
    "NavSatFix PointCloud2 Range RegionOfInterest Temperature",
    "nav_msgs.msg": "MapMetaData OccupancyGrid Odometry Path",
    "visualization_msgs.msg": "ImageMarker InteractiveMarker Marker MarkerArray",
    "std_srvs.srv": "SetBool Trigger",
}
_HOMES = {name: module for module, names in _MODULES.items() for name in names.split()}
_ROS1, _CPP = "ROS 1 (rospy)", "the C++ library (rclcpp)"
_METHODS: dict[str, tuple[str, str]] = {
    **{
        f"log{level}": (_ROS1, f"Use get_logger().{word}('text').")
        for level, word in (
            ("debug", "debug"),
            ("info", "info"),
            ("warn", "warning"),
            ("err", "error"),
            ("error", "error"),
            ("fatal", "fatal"),
        )
    },
    **{
        f"{level}_throttle": (_CPP, f"Use {level}('text', throttle_duration_sec=1.0).")
        for level in ("debug", "info", "warn", "warning", "error")
    },
    "to_sec": (_ROS1, "Use nanoseconds / 1e9."),
    "to_nsec": (_ROS1, "Use nanoseconds."),
    "get_num_connections": (_ROS1, "Use get_subscription_count()."),
    "is_shutdown": (_ROS1, "Use rclpy.ok()."),
    "seconds": (_CPP, "Use nanoseconds / 1e9."),
    "create_wall_timer": (_CPP, "Use create_timer(period, callback)."),
    "async_send_request": (_CPP, "Use call_async(request)."),
    "spin_some": (_CPP, "Use rclpy.spin_once(node, timeout_sec=0.0), or let rclpy.spin(node) wait."),
}
_METHOD = re.compile(r"(?:'(?P<owner>\w+)' object|module 'rclpy') has no attribute '(?P<name>\w+)'")
_OF_TIMES = ("seconds", "to_sec", "to_nsec")
"""An object of another class may have an attribute of its own with this name."""
_NAME = re.compile(
    r"module '(?P<in>[\w.]+)' has no attribute '(?P<name>\w+)'|"
    r"cannot import name '(?P<imported>\w+)' from '(?P<from>[\w.]+)'"
)
_ROS_MODULE = re.compile(r"rclpy\b|\w+_(?:msgs|srvs|interfaces)\b")


def name_elsewhere(error: str) -> tuple[str, str, str] | None:
    """The cause id for a name that is at another place, where it is, and what to write; None for others."""
    asked = _NAME.search(error)
    name, module = (asked["name"] or asked["imported"], asked["in"] or asked["from"]) if asked else ("", "")
    home = _HOMES.get(name, module)
    if module.endswith(".msg") and home in ("rclpy.duration", "rclpy.time"):
        home = "builtin_interfaces.msg"  # std_msgs of ROS 1 had them
    if home != module and _ROS_MODULE.match(module):
        return (
            "error.name-in-other-module",
            f"{name} is in {home}, not in {module}.",
            f"Write from {home} import {name}.",
        )
    method = _METHOD.search(error)
    if method is None or method["name"] not in _METHODS:
        return None
    if method["name"] in _OF_TIMES and method["owner"] not in ("Time", "Duration", None):
        return None
    source, instead = _METHODS[method["name"]]
    return (
        "error.name-of-ros-1" if source == _ROS1 else "error.name-of-cpp",
        f"The name {method['name']} belongs to {source}. rclpy doesn't have it here.",
        instead,
    )

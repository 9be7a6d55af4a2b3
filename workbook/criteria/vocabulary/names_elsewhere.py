"""Explain names that rclpy or the message packages define in another module, and methods from ROS 1 and C++."""

import re

from workbook.criteria.rules import Words

WORDS = Words(__file__)

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
_ELSEWHERE = WORDS.reason("error.name-in-other-module", ("name", "home", "module"))
_SEVERITIES = {
    "debug": "debug",
    "info": "info",
    "warn": "warning",
    "err": "error",
    "error": "error",
    "fatal": "fatal",
}
_METHODS = {
    **{f"log{level}": ("ros-1.log", severity) for level, severity in _SEVERITIES.items()},
    **{
        f"{level}_throttle": ("cpp.throttle", level)
        for level in ("debug", "info", "warn", "warning", "error")
    },
    **{name: (f"ros-1.{name}", "") for name in ("to_sec", "to_nsec", "get_num_connections", "is_shutdown")},
    **{
        name: (f"cpp.{name}", "")
        for name in ("seconds", "create_wall_timer", "async_send_request", "spin_some")
    },
}
_OF_METHODS = {
    name: (WORDS.reason(entry, ("name", "severity")), severity)
    for name, (entry, severity) in _METHODS.items()
}
_METHOD = re.compile(r"(?:'(?P<owner>\w+)' object|module 'rclpy') has no attribute '(?P<name>\w+)'")
_OF_TIMES = ("seconds", "to_sec", "to_nsec")
"""Names that we explain only for times, because other classes may define attributes with these names."""
_NAME = re.compile(
    r"module '(?P<in>[\w.]+)' has no attribute '(?P<name>\w+)'|"
    r"cannot import name '(?P<imported>\w+)' from '(?P<from>[\w.]+)'"
)
_ROS_MODULE = re.compile(r"rclpy\b|\w+_(?:msgs|srvs|interfaces)\b")


def name_elsewhere(error: str) -> tuple[str, str, str] | None:
    """Return the cause id and the strings `because` and `try` for a name from elsewhere, or None for other errors."""
    asked = _NAME.search(error)
    name, module = (asked["name"] or asked["imported"], asked["in"] or asked["from"]) if asked else ("", "")
    home = _HOMES.get(name, module)
    if module.endswith(".msg") and home in ("rclpy.duration", "rclpy.time"):
        home = "builtin_interfaces.msg"  # in ROS 1, std_msgs had these messages
    if home != module and _ROS_MODULE.match(module):
        return _ELSEWHERE.id, *_ELSEWHERE(name=name, home=home, module=module)
    method = _METHOD.search(error)
    if method is None or method["name"] not in _OF_METHODS:
        return None
    if method["name"] in _OF_TIMES and method["owner"] not in ("Time", "Duration", None):
        return None
    reason, severity = _OF_METHODS[method["name"]]
    cause = "error.name-of-ros-1" if reason.id.startswith("ros-1.") else "error.name-of-cpp"
    return cause, *reason(name=method["name"], severity=severity)

"""Errors of calls of rclpy: QoS, timers, loggers, parameters, times. A part of `KNOWN_ERRORS`, see `error_table`."""

from dataclasses import dataclass


@dataclass(frozen=True)
class KnownError:
    """An error by its cause id: the regular expression that recognizes it, why it happens, and what to try."""

    cause: str
    pattern: str
    because: str
    try_this: str


ERRORS_OF_CALLS = (
    KnownError(
        "error.qos-as-words",
        r"\bassert isinstance\(value, QoS(?:Durability|Reliability|History|Liveliness)Policy\)",
        "A QoS policy must be a value of its enum in rclpy, not a string or a number.",
        "Import the enum from rclpy.qos: DurabilityPolicy.TRANSIENT_LOCAL, ReliabilityPolicy.BEST_EFFORT.",
    ),
    KnownError(
        "error.qos-duration",
        r"\bassert isinstance\(value, Duration\)",
        "Lifespan, deadline, and lease duration take an rclpy Duration, not a number.",
        "Write lifespan=Duration(seconds=0.3), with Duration from rclpy.duration.",
    ),
    KnownError(
        "error.qos-depth",
        r"rclpy/qos\.py\", line \d+, in depth|history depth must be greater",
        "The depth of a QoS profile is a whole number, 0 or more.",
        "Write depth=10.",
    ),
    KnownError(
        "error.qos-keyword",
        r"Invalid arguments passed to constructor: dict_keys",
        "QoSProfile has no setting with one of these names. The error lists the names that it was given.",
        "Use depth, history, reliability, durability, deadline, lifespan or liveliness.",
    ),
    KnownError(
        "error.qos-without-depth",
        r"History and/or depth settings are required|QoSProfile\.__init__\(\) takes 1 positional",
        "A QoSProfile needs a depth, as a keyword argument.",
        "Write QoSProfile(depth=10).",
    ),
    KnownError(
        "error.qos-not-a-profile",
        r"Expected QoSProfile or int, but received",
        "The argument for the queue depth (QoS) is neither a number nor a QoSProfile. For a subscription, the "
        "callback comes before it.",
        "Give a depth such as 10, or a QoSProfile.",
    ),
    KnownError(
        "error.logger-takes-text",
        r"Invoked with: <LoggingSeverity|RcutilsLogger\.\w+\(\) takes 2 positional",
        "An rclpy logger takes a single string and nothing else.",
        "Put the values into the string: self.get_logger().info(f'level {level}').",
    ),
    KnownError(
        "error.timer-once",
        r"create_timer\(\) got an unexpected keyword argument '(?:oneshot|once)'",
        "An rclpy timer repeats until it is canceled. The keyword oneshot belongs to ROS 1 (rospy).",
        "Keep the timer in an attribute, and call its cancel() in the callback.",
    ),
    KnownError(
        "error.qos-setting-alone",
        r"create_(?:publisher|subscription)\(\) got an unexpected keyword argument '(?:qos|depth|history|reliability|"
        r"durability|deadline|lifespan|liveliness)'",
        "The call takes all QoS settings together, as one QoS profile. Its keyword is qos_profile.",
        "Give the profile as the last argument: QoSProfile(depth=10), with QoSProfile from rclpy.qos.",
    ),
    KnownError(
        "error.ros-1-keyword",
        r"got an unexpected keyword argument '(?:queue_size|latch|buff_size|tcp_nodelay|subscriber_listener|"
        r"callback_args|anonymous)'",
        "This keyword belongs to ROS 1 (rospy). rclpy doesn't have it: queue settings belong in the QoS profile.",
        "Give the depth as the last argument: create_publisher(Float32, name, 10). For latch, use "
        "DurabilityPolicy.TRANSIENT_LOCAL.",
    ),
    KnownError(
        "error.no-event-loop",
        r"no running event loop|no current event loop|Timeout should be used inside a task",
        "rclpy's executor runs async callbacks without an asyncio event loop. So asyncio.sleep and other asyncio "
        "calls fail in a callback.",
        "Replace the asyncio call with a timer: create_timer(period, callback).",
    ),
    KnownError(
        "error.timer-period",
        r"timer period must be non-negative|timer_period_sec[^\n]*\n(?:[ ^~]*\n)?[^\n]*cannot convert float "
        r"(?:infinity|NaN) to integer",
        "A timer received a negative, infinite, or NaN period. A period is a time in seconds.",
        "Check the line that computes the period, and give create_timer a positive number.",
    ),
    KnownError(
        "error.timer-arguments-swapped",
        r"float\(\) argument must be a string or a real number, not '(?:method|function|Node|"
        r"builtin_function_or_method)'",
        "A number was expected, but a function or a node was given. create_timer takes the period first, then the "
        "callback.",
        "Write create_timer(1.0, self.on_timer).",
    ),
    KnownError(
        "error.topic-name-none",
        r"topic_name argument is null",
        "The name of the topic is None.",
        "Give the name as a string: create_publisher(String, 'name', 10).",
    ),
    KnownError(
        "error.parameter-not-declared",
        r"ParameterNotDeclaredException|Invalid access to undeclared parameter",
        "A parameter must be declared before the program reads or sets it.",
        "Call self.declare_parameter('name', value) in __init__ first.",
    ),
    KnownError(
        "error.parameter-declared-twice",
        r"ParameterAlreadyDeclaredException",
        "The parameter was declared a second time.",
        "Declare each parameter once, in __init__.",
    ),
    KnownError(
        "error.spin-on-no-node",
        r"node\.executor = self\n[\s\S]*object has no attribute 'executor'",
        "The spin function received something that isn't a node.",
        "Create the node first, then spin it: node = Humanoid(), then rclpy.spin(node).",
    ),
    KnownError(
        "error.nothing-to-spin",
        r"spin\w*\(\) missing 1 required positional argument: 'node'",
        "The spin function received no node.",
        "Write rclpy.spin(node).",
    ),
    KnownError(
        "error.executor-attribute",
        r"object has no attribute 'add_node'",
        "The attribute executor of a node is rclpy's own. Only an executor of rclpy can be put into it.",
        "Give your attribute another name, such as self.pool.",
    ),
    KnownError(
        "error.service-itself",
        r"Service classes can not be instantiated",
        "The class of a service only holds the two classes of its messages: Request and Response.",
        "Make the message: Trigger.Request() for a call, Trigger.Response() for an answer.",
    ),
    KnownError(
        "error.no-request",
        r"rclpy/client\.py\", line \d+, in call(?:_async)?\n +raise TypeError",
        "A call sends a request of the client's service class, and it was given something else.",
        "Give it a request: call_async(Trigger.Request()).",
    ),
    KnownError(
        "error.no-response",
        r"rclpy/service\.py\", line \d+, in send_response\n +raise TypeError",
        "The callback of a service returns the response that rclpy sends. This one returned something else.",
        "End the callback with return response.",
    ),
    KnownError(
        "error.time-without-to-msg",
        r"'Time' object has no attribute '(?:sec|nanosec)'",
        "This is an rclpy Time, not a Time message. It has the attribute nanoseconds, but not sec.",
        "Convert it to a message with to_msg().",
    ),
    KnownError(
        "error.time-minus-number",
        r"unsupported operand type\(s\) for [-+]: 'Time' and '(?:int|float)'",
        "An rclpy Time and a plain number can't be added or subtracted.",
        "Use Duration(seconds=1.0) from rclpy.duration, or compare the nanoseconds.",
    ),
    KnownError(
        "error.duration-by-position",
        r"(?:Duration|Time)\.__init__\(\) takes 1 positional argument",
        "Time and Duration take keyword arguments only.",
        "Write Duration(seconds=1.0).",
    ),
    KnownError(
        "error.field-by-position",
        r"\b(?:U?Int\d+|Float\d+|String|Bool|Header|Twist|Vector3|Point|Pose|Quaternion|Image|Imu|"
        r"JointState)\w*\.__init__\(\) takes 1 positional argument but 2 were given",
        "A message's constructor takes its fields as keyword arguments only.",
        "Write the field's name: Float32(data=1.0).",
    ),
)

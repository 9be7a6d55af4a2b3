"""List errors that rclpy functions raise for wrong calls, about QoS, timers, parameters, and so on.

The table is part of `KNOWN_ERRORS` in `error_table`.
"""

from dataclasses import dataclass

from workbook.criteria.rules import Reason, Words
from workbook.recording.limits import ANSWER_LIMITS, WRITABLE_MIB

WORDS = Words(__file__)


@dataclass(frozen=True)
class KnownError:
    """A known error: a regular expression that matches it, and the reason to give the student.

    The reason's id is also the id of the verdict's cause.
    """

    reason: Reason
    pattern: str

    @property
    def cause(self) -> str:
        """The cause id."""
        return self.reason.id

    def explained(self) -> tuple[str, str]:
        """Return the strings `because` and `try` for this error."""
        return self.reason(limits=ANSWER_LIMITS, writable_mib=WRITABLE_MIB)


def known_errors(words: Words, *table: tuple[str, str]) -> tuple[KnownError, ...]:
    """Build the rows of an error table from pairs of a cause id and a pattern. `words`: the catalog for the ids."""
    return tuple(
        KnownError(words.reason(cause, ("limits", "writable_mib")), pattern) for cause, pattern in table
    )


ERRORS_OF_CALLS = known_errors(
    WORDS,
    (
        "error.qos-as-words",
        r"\bassert isinstance\(value, QoS(?:Durability|Reliability|History|Liveliness)Policy\)",
    ),
    ("error.qos-duration", r"\bassert isinstance\(value, Duration\)"),
    ("error.qos-depth", r"rclpy/qos\.py\", line \d+, in depth|history depth must be greater"),
    ("error.qos-keyword", r"Invalid arguments passed to constructor: dict_keys"),
    (
        "error.qos-without-depth",
        r"History and/or depth settings are required|QoSProfile\.__init__\(\) takes 1 positional",
    ),
    ("error.qos-not-a-profile", r"Expected QoSProfile or int, but received"),
    ("error.logger-takes-text", r"Invoked with: <LoggingSeverity|RcutilsLogger\.\w+\(\) takes 2 positional"),
    ("error.timer-once", r"create_timer\(\) got an unexpected keyword argument '(?:oneshot|once)'"),
    (
        "error.qos-setting-alone",
        r"create_(?:publisher|subscription)\(\) got an unexpected keyword argument '(?:qos|depth|history|reliability|"
        r"durability|deadline|lifespan|liveliness)'",
    ),
    (
        "error.ros-1-keyword",
        r"got an unexpected keyword argument '(?:queue_size|latch|buff_size|tcp_nodelay|subscriber_listener|"
        r"callback_args|anonymous)'",
    ),
    (
        "error.no-event-loop",
        r"no running event loop|no current event loop|Timeout should be used inside a task",
    ),
    (
        "error.timer-period",
        r"timer period must be non-negative|timer_period_sec[^\n]*\n(?:[ ^~]*\n)?[^\n]*cannot convert float "
        r"(?:infinity|NaN) to integer",
    ),
    (
        "error.timer-arguments-swapped",
        r"float\(\) argument must be a string or a real number, not '(?:method|function|Node|"
        r"builtin_function_or_method)'",
    ),
    ("error.topic-name-none", r"topic_name argument is null"),
    ("error.parameter-not-declared", r"ParameterNotDeclaredException|Invalid access to undeclared parameter"),
    ("error.parameter-declared-twice", r"ParameterAlreadyDeclaredException"),
    ("error.spin-on-no-node", r"node\.executor = self\n[\s\S]*object has no attribute 'executor'"),
    ("error.nothing-to-spin", r"spin\w*\(\) missing 1 required positional argument: 'node'"),
    ("error.executor-attribute", r"object has no attribute 'add_node'"),
    ("error.service-itself", r"Service classes can not be instantiated"),
    ("error.no-request", r"rclpy/client\.py\", line \d+, in call(?:_async)?\n +raise TypeError"),
    ("error.no-response", r"rclpy/service\.py\", line \d+, in send_response\n +raise TypeError"),
    ("error.time-without-to-msg", r"'Time' object has no attribute '(?:sec|nanosec)'"),
    ("error.time-minus-number", r"unsupported operand type\(s\) for [-+]: 'Time' and '(?:int|float)'"),
    ("error.duration-by-position", r"(?:Duration|Time)\.__init__\(\) takes 1 positional argument"),
    (
        "error.field-by-position",
        r"\b(?:U?Int\d+|Float\d+|String|Bool|Header|Twist|Vector3|Point|Pose|Quaternion|Image|Imu|"
        r"JointState)\w*\.__init__\(\) takes 1 positional argument but 2 were given",
    ),
)

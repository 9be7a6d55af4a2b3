"""Recognizes common errors in a program's log and says in plain words what they mean and what to do."""

import re
from dataclasses import dataclass

from workbook.criteria.verdict import Verdict, failed
from workbook.observing.recording import Recording


@dataclass(frozen=True)
class Mishap:
    """An error that ended (or crippled) a program: its last line, where it happened, why, and what to try."""

    error: str
    line: int | None
    because: str
    try_this: str

    @property
    def where(self) -> str:
        return f"line {self.line}: " if self.line is not None else ""


@dataclass(frozen=True)
class _Known:
    pattern: str
    because: str
    try_this: str


TRACEBACK = "Traceback (most recent call last)"
_OVERTAKEN = (
    r'rclpy/context\.py", line \d+, in try_shutdown\n'
    r"[^\n]*\n"
    r"\S*RCLError: failed to shutdown: rcl_shutdown already called"
)

_KNOWN = (
    _Known(
        r"'NoneType' object does not support the context manager protocol",
        "`with rclpy.init():` belongs to a newer rclpy. In Jazzy rclpy.init() returns None.",
        "Call rclpy.init() on its own line, and rclpy.try_shutdown() in a finally block.",
    ),
    _Known(
        r"NotInitializedException|rclpy\.init\(\) has not been called",
        "A node was made before the ROS context was started.",
        "Call rclpy.init() once, before the first node is made.",
    ),
    _Known(
        r"Context\.init\(\) must only be called once",
        "rclpy.init() was called a second time while the first context was still up.",
        "Call rclpy.init() exactly once, in main().",
    ),
    _Known(
        _OVERTAKEN,
        "rclpy itself was still handling Ctrl-C when try_shutdown() asked whether the context was up. That happens "
        "now and then on a busy machine, and is no fault of the program.",
        "Nothing: run it again.",
    ),
    _Known(
        r"Context must be initialized before it can be shutdown|rcl_shutdown already called",
        "The context was shut down twice (Ctrl-C has already done it).",
        "Use rclpy.try_shutdown(), which may be called at any time.",
    ),
    _Known(
        r"has no attribute '_default_callback_group'|object has no attribute '_parameters'",
        "The Node was never set up: super().__init__('name') is missing or comes too late.",
        "Make super().__init__('your_node_name') the first line of __init__.",
    ),
    _Known(
        r"missing 1 required positional argument: 'qos_profile'",
        "create_publisher and create_subscription need a queue depth (QoS) as their last argument.",
        "Add a depth, for example 10: create_publisher(String, '/robot/status', 10).",
    ),
    _Known(
        r"callback should be either be callable with one argument",
        "The callback of a subscription takes the message, or the message and what is known about it. This one takes "
        "neither.",
        "Give it one argument besides self: def on_battery(self, message: Float32).",
    ),
    _Known(
        r"missing 1 required positional argument: 'node_name'",
        "A node needs a name, and Node.__init__ was given none.",
        "Write super().__init__('your_node_name').",
    ),
    _Known(
        r"create_timer\(\) missing 1 required positional argument: 'callback'",
        "A timer needs a period and a function to call, and it was given one of the two.",
        "Write create_timer(1.0, self.on_timer), without parentheses after the function.",
    ),
    _Known(
        r"missing 1 required positional argument: '\w+'",
        "A function was called without an argument that it needs. The callback of a timer is called with none; that of "
        "a subscription is called with the message, and must be handed over, not called.",
        "For a timer: def on_timer(self). For a subscription: create_subscription(Float32, '/robot/battery', "
        "self.on_battery, 10), without parentheses.",
    ),
    _Known(
        r"'NoneType' object is not callable",
        "A callback was called instead of handed over, so the timer got its result, None.",
        "Pass the function without parentheses: create_timer(2.0, self.publish_joints).",
    ),
    _Known(
        r"Expected <class '[\w.]*\.(\w+)'>, got <class '([\w.]+)'>",
        "publish() was given something that is not the message type of this publisher.",
        "Make a message of the right class, fill its fields, and publish that.",
    ),
    _Known(
        r"has no attribute '_TYPE_SUPPORT'",
        "What was given as the message type is no message class. (The words about ROS 1 are a guess, mostly a wrong "
        "one.)",
        "Give the class itself, for example Float32 from std_msgs.msg: no Python type, and no name in quotes.",
    ),
    _Known(
        r"existing topic name \S+ with incompatible type",
        "In this program the topic is there already, with another message type.",
        "Use one message type per topic name, or give the other one a name of its own.",
    ),
    _Known(
        r"property '(\w+)' of '\w+' object has no setter",
        "The attribute name is taken: Node already has a property of that name.",
        "Give your attribute another name, for example joint_pub instead of publishers.",
    ),
    _Known(
        r"InvalidTopicNameException|Invalid topic name",
        "The topic name breaks the naming rules (no space, hyphen, trailing slash or leading digit).",
        "Write the name exactly as the exercise gives it.",
    ),
    _Known(
        r"InvalidNodeNameException|Invalid node name",
        "The node name breaks the naming rules (letters, digits and underscores only, no slash).",
        "Give the node a plain name such as humanoid_status_publisher.",
    ),
    _Known(
        r"(?:must be real number, not str|bad argument type for built-in operation|a float is required)",
        "A value of the wrong type was put into a message field.",
        "Put Python floats into float fields: float(angle).",
    ),
    _Known(
        r"AssertionError: The '\w+' field must be",
        "A message field was given a value of another type than it holds.",
        "Give the field what its type says: float(angle) for a float, str(word) for a text, a list for an array.",
    ),
    _Known(
        r"type 'Publisher' is not subscriptable|'type' object is not subscriptable",
        "Publisher[String] is written for a newer rclpy. In Jazzy Publisher takes no type parameter.",
        "Annotate with plain Publisher.",
    ),
    _Known(
        r"EOFError: EOF when reading a line",
        "The program waits for the keyboard. A robot program has none, and neither has the judge.",
        "Remove input(), or read the value from a parameter.",
    ),
    _Known(
        r"module '(?:rclpy|\w+_(?:msgs|srvs|interfaces))[\w.]*' has no attribute",
        "There is nothing of that name in it. Or it is not the real one: another file of that name (rclpy.py) "
        "hides it.",
        "Check the spelling; and give no file of yours the name of a module of ROS.",
    ),
    _Known(
        r"'\w+' is not a package",
        "A file of that name (with .py) lies beside the program and hides the package.",
        "Give no file of yours the name of a package.",
    ),
    _Known(
        r"ModuleNotFoundError: No module named '([\w.]+)'|ImportError: cannot import name",
        "A module or a name that the program imports is not there.",
        "Check the spelling of the import. Messages come from, for example, std_msgs.msg. Code of a second file of "
        "yours belongs in the answer: only one file is run.",
    ),
    _Known(
        r"NameError: name '(\w+)' is not defined",
        "A name is used that was never defined or imported in this file.",
        "Import or define it; the file runs on its own, without the cells of the notebook.",
    ),
    _Known(
        r"(?:Indentation|Tab)Error",
        "The indentation does not fit, so Python cannot read the file.",
        "Line the block up with its neighbors (four spaces per level).",
    ),
    _Known(
        r"Missing parentheses in call to 'print'",
        "print without parentheses is Python 2. ROS 2 needs Python 3.",
        "Write print(...), and look for other things of Python 2.",
    ),
    _Known(
        r"(?s)^ *(?:!|%%?)\w.*SyntaxError",
        "A line that begins with % or ! is a command for a notebook, and no Python.",
        "Take that line out of the answer.",
    ),
    _Known(
        r"SyntaxError",
        "Python cannot read the file, so nothing of it ran.",
        "Look at the line named above and at the one before it: brackets, quotes, colons.",
    ),
    _Known(
        r"MemoryError",
        "The program asked for more memory than an answer may use.",
        "Look for a list that grows without end.",
    ),
    _Known(
        r"No space left on device|File too large",
        "The program wrote more than the 64 MB that an answer may write.",
        "Write less, or nothing: nobody reads the files of an answer.",
    ),
    _Known(
        r"Too many open files",
        "The program holds more files or connections open than an answer may.",
        "Close what you open (with open(...) as file), and make each publisher and node once.",
    ),
    _Known(
        r"can't start new thread|Resource temporarily unavailable",
        "The program started more threads or processes than an answer may.",
        "Look for a loop that starts one each time.",
    ),
)

_ERROR_LINE = re.compile(
    r"^(?P<name>[A-Za-z_][\w.]*(?:Error|Exception|Interrupt|Handle|Iteration|Exit))(?::.*)?$"
)
_EXECUTOR_LEFT = re.compile(
    r"Exception ignored in: <function Executor\.__del__ at \S+>\n"
    + re.escape(TRACEBACK)
    + r":\n(?: .*\n)+\S*InvalidHandle: .*\n?"
)
_FRAME = re.compile(r'^  File "(?P<file>[^"]+)", line (?P<line>\d+)')


def find_mishap(log: str, program_name: str = "") -> Mishap | None:
    """The last Python error in a log, explained; None if there is none.

    Only frames of the student's own file (`program_name`) give the line number, when the name is known.
    """
    log = without_executors_end(log)
    last = max(0, log.rfind(TRACEBACK))
    if TRACEBACK in log[:last] and re.search(_OVERTAKEN, log[last:]):
        return find_mishap(log[:last], program_name)  # what had gone wrong before that matters more
    lines = log.splitlines()
    error_at = next(
        (index for index in range(len(lines) - 1, -1, -1) if _ERROR_LINE.match(lines[index].strip())), None
    )
    if error_at is None or not any("Traceback" in line or _FRAME.match(line) for line in lines[:error_at]):
        return None
    error = lines[error_at].strip()
    if error.startswith("KeyboardInterrupt"):
        return None
    line_number: int | None = None
    for line in lines[:error_at]:
        if line.startswith("Traceback"):
            line_number = None
        frame = _FRAME.match(line)
        if frame and (not program_name or frame["file"].rsplit("/", 1)[-1] == program_name):
            line_number = int(frame["line"])
    for known in _KNOWN:
        if re.search(known.pattern, error) or re.search(
            known.pattern, "\n".join(lines[max(0, error_at - 2) : error_at + 1])
        ):
            return Mishap(error, line_number, known.because, known.try_this)
    return Mishap(
        error,
        line_number,
        "The program raised an exception that nothing caught.",
        "Read the last lines of the log from the bottom up: the error, then the line of your file.",
    )


def without_executors_end(log: str) -> str:
    """The log without what rclpy says when an executor is thrown away after a part of it was.

    Python may throw away an executor's guard condition before the executor, which then wants to give it back. That
    changes nothing and is no fault of the program. Seen twice in some thousand ends.
    Source: https://github.com/ros2/rclpy/blob/jazzy/rclpy/rclpy/executors.py (Executor.__del__).
    """
    return _EXECUTOR_LEFT.sub("", log)


def shutdown_overtaken(log: str) -> bool:
    """Whether the only error in a log is that Ctrl-C overtook `rclpy.try_shutdown()`.

    It asks whether the context is up, and then shuts it down. The thread of rclpy that handles Ctrl-C may do so in
    between, and then any program in order ends with a traceback and exit code 1. Measured: 4 of about 550 ends on two
    processors with work for ten.
    Source: https://github.com/ros2/rclpy/blob/jazzy/rclpy/rclpy/context.py (Context.try_shutdown).
    """
    log = without_executors_end(log)
    return log.count(TRACEBACK) == 1 and re.search(_OVERTAKEN, log) is not None


def ended_in_order(exit_code: int | None, end_log: str) -> bool:
    """Whether a program ended with exit code 0 and no traceback, or would have but for what rclpy itself does.

    See `shutdown_overtaken` and `without_executors_end`.
    """
    if exit_code == 1:
        return shutdown_overtaken(end_log)
    return exit_code == 0 and TRACEBACK not in without_executors_end(end_log)


def failed_by_error(
    recording: Recording, saw: str, expected: str, *, about_time: bool = False
) -> Verdict | None:
    """A failed verdict that blames the last Python error in the program's log; None if there is none.

    `saw` says what is missing because of it; the error is put behind it.
    """
    mishap = find_mishap(recording.process.log, recording.process.program)
    if mishap is None:
        return None
    told = f"{mishap.where}{mishap.error}"
    return failed(
        f"{saw}: {told}" if saw else told, expected, mishap.because, mishap.try_this, about_time=about_time
    )

"""List common errors in ROS programs, each with a pattern, its cause, and advice. The first match is used."""

from workbook.criteria.rules import Words
from workbook.criteria.vocabulary.error_table_of_calls import ERRORS_OF_CALLS, known_errors

WORDS = Words(__file__)

TRY_SHUTDOWN_OVERTAKEN = (
    r'rclpy/context\.py", line \d+, in try_shutdown\n'
    r"[^\n]*\n"
    r"\S*RCLError: failed to shutdown: rcl_shutdown already called[^\n]*"
)
"""Matches a traceback from a Ctrl-C between the check in `rclpy.try_shutdown()` and the shutdown itself.

See `shutdown_overtaken`.
"""

SPIN_OVERTAKEN = (
    r'rclpy/executors\.py", line \d+, in _wait_for_ready_callbacks\n'
    r"(?: [^\n]*\n)+"
    r"(?:\S*RCLError: failed to initialize wait set: the given context is not valid|"
    r"AttributeError: 'NoneType' object has no attribute 'handle')[^\n]*|"
    r'rclpy/executors\.py", line \d+, in handler\n'
    r" +gc\.trigger\(\)\n"
    r"(?: [^\n]*\n)+"
    r"\S*InvalidHandle: [^\n]*"
)
"""Matches a traceback from a context that was shut down just before a spin began to wait. See `shutdown_overtaken`."""

TAKE_OVERTAKEN = (
    r'rclpy/executors\.py", line \d+, in _take_\w+\n'
    r"(?: [^\n]*\n)+"
    r"RuntimeError: Unable to convert call argument '\d' to Python object[^\n]*"
)
"""Matches a traceback from a Ctrl-C that arrived while rclpy was creating the message for a callback.

rclpy's C++ code raises this exception for any error in a message class. Source:
https://github.com/ros2/rclpy/blob/jazzy/rclpy/src/rclpy/subscription.cpp (Subscription::take_message).
"""

OVERTAKEN = f"{TRY_SHUTDOWN_OVERTAKEN}|{SPIN_OVERTAKEN}|{TAKE_OVERTAKEN}"

[UNKNOWN_ERROR] = known_errors(WORDS, ("error.exception", r""))

KNOWN_ERRORS = (
    *ERRORS_OF_CALLS,
    *known_errors(
        WORDS,
        ("error.context-manager", r"'NoneType' object does not support the context manager protocol"),
        ("error.not-initialized", r"NotInitializedException|rclpy\.init\(\) has not been called"),
        ("error.init-twice", r"Context\.init\(\) must only be called once"),
        ("error.shutdown-overtaken", OVERTAKEN),
        (
            "error.shutdown-twice",
            r"Context must be initialized before it can be shutdown|rcl_shutdown already called",
        ),
        (
            "error.no-super-init",
            r"has no attribute '_default_callback_group'|object has no attribute '_parameters'",
        ),
        ("error.no-qos", r"missing 1 required positional argument: 'qos_profile'"),
        ("error.callback-takes-no-message", r"callback should be either be callable with one argument"),
        ("error.node-without-name", r"missing 1 required positional argument: 'node_name'"),
        (
            "error.timer-without-callback",
            r"create_timer\(\) missing 1 required positional argument: 'callback'",
        ),
        ("error.missing-argument", r"missing 1 required positional argument: '\w+'"),
        ("error.callback-called", r"'NoneType' object is not callable"),
        ("error.no-message-object", r"Expected <class '[\w.]*\.(\w+)'>, got <class '([\w.]+)'>"),
        ("error.no-message-class", r"has no attribute '_TYPE_SUPPORT'"),
        ("error.topic-of-two-types", r"existing topic name \S+ with incompatible type"),
        ("error.name-taken", r"property '(\w+)' of '\w+' object has no setter"),
        ("error.callback-without-signature", r"no signature found for builtin"),
        ("error.method-in-with", r"'method' object does not support the context manager protocol"),
        ("error.invalid-topic-name", r"InvalidTopicNameException|Invalid topic name"),
        ("error.invalid-node-name", r"InvalidNodeNameException|Invalid node name"),
        ("error.topic-name-no-text", r"rclpy_resolve_name\(\): incompatible function arguments"),
        ("error.ros-arguments", r"RCLInvalidROSArgsError"),
        ("error.context-down", r"publisher's context is invalid"),
        ("error.destroyed", r"InvalidHandle: cannot use Destroyable because destruction was requested"),
        (
            "error.wrong-value-type",
            r"(?:must be real number, not str|bad argument type for built-in operation|a float is required)",
        ),
        ("error.field-of-other-type", r"AssertionError: The '\w+' field must be"),
        (
            "error.generic-publisher",
            r"type 'Publisher' is not subscriptable|'type' object is not subscriptable",
        ),
        ("error.reads-keyboard", r"EOFError: EOF when reading a line"),
        (
            "error.module-without-name",
            r"module '(?:rclpy|\w+_(?:msgs|srvs|interfaces))[\w.]*' has no attribute",
        ),
        ("error.module-hides-package", r"'\w+' is not a package"),
        (
            "error.import-not-found",
            r"ModuleNotFoundError: No module named '([\w.]+)'|ImportError: cannot import name",
        ),
        ("error.name-not-defined", r"NameError: name '(\w+)' is not defined"),
        ("error.indentation", r"(?:Indentation|Tab)Error"),
        ("error.print-statement", r"Missing parentheses in call to 'print'"),
        ("error.notebook-command", r"(?s)^ *(?:!|%%?)\w.*SyntaxError"),
        ("error.syntax", r"SyntaxError"),
        ("error.out-of-memory", r"MemoryError"),
        ("error.disk-full", r"No space left on device|File too large"),
        ("error.too-many-files", r"Too many open files"),
        ("error.too-many-threads", r"can't start new thread|Resource temporarily unavailable"),
    ),
)

"""The common errors of a ROS program: how to recognize each, what it means, what to do. The first that fits counts."""

from workbook.criteria.vocabulary.error_table_of_calls import ERRORS_OF_CALLS, KnownError
from workbook.recording.limits import ANSWER_LIMITS, WRITABLE_MIB

TRY_SHUTDOWN_OVERTAKEN = (
    r'rclpy/context\.py", line \d+, in try_shutdown\n'
    r"[^\n]*\n"
    r"\S*RCLError: failed to shutdown: rcl_shutdown already called[^\n]*"
)
"""Ctrl-C came between the question of `rclpy.try_shutdown()` and its shutdown. See `shutdown_overtaken`."""

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
"""The context was shut down while a spin was about to wait. See `shutdown_overtaken`."""

TAKE_OVERTAKEN = (
    r'rclpy/executors\.py", line \d+, in _take_\w+\n'
    r"(?: [^\n]*\n)+"
    r"RuntimeError: Unable to convert call argument '\d' to Python object[^\n]*"
)
"""Ctrl-C came while rclpy made the message for a callback. Its C++ part makes this of any error in a message's class.

Source: https://github.com/ros2/rclpy/blob/jazzy/rclpy/src/rclpy/subscription.cpp (Subscription::take_message).
"""

OVERTAKEN = f"{TRY_SHUTDOWN_OVERTAKEN}|{SPIN_OVERTAKEN}|{TAKE_OVERTAKEN}"

UNKNOWN_ERROR = KnownError(
    "error.exception",
    r"",
    "The program raised an exception that nothing caught.",
    "Read the end of the log from the bottom up: first the error, then the line of your file.",
)

KNOWN_ERRORS = (
    *ERRORS_OF_CALLS,
    KnownError(
        "error.context-manager",
        r"'NoneType' object does not support the context manager protocol",
        "`with rclpy.init():` belongs to a newer rclpy. In Jazzy, rclpy.init() returns None.",
        "Call rclpy.init() on its own line, and rclpy.try_shutdown() in a finally block.",
    ),
    KnownError(
        "error.not-initialized",
        r"NotInitializedException|rclpy\.init\(\) has not been called",
        "A node was created before the ROS context was initialized.",
        "Call rclpy.init() once, before the first node is created.",
    ),
    KnownError(
        "error.init-twice",
        r"Context\.init\(\) must only be called once",
        "rclpy.init() was called a second time while the context was still up.",
        "Call rclpy.init() exactly once, in main().",
    ),
    KnownError(
        "error.shutdown-overtaken",
        OVERTAKEN,
        "Ctrl-C arrived in the middle of rclpy's own work. This happens occasionally. It's a bug in rclpy, not in "
        "your program.",
        "Run it again. There's nothing to fix in your program.",
    ),
    KnownError(
        "error.shutdown-twice",
        r"Context must be initialized before it can be shutdown|rcl_shutdown already called",
        "The context was shut down twice. Ctrl-C had already shut it down.",
        "Use rclpy.try_shutdown(), which may be called at any time.",
    ),
    KnownError(
        "error.no-super-init",
        r"has no attribute '_default_callback_group'|object has no attribute '_parameters'",
        "The Node was never initialized: super().__init__('name') is missing or is called too late.",
        "Make super().__init__('your_node_name') the first line of __init__.",
    ),
    KnownError(
        "error.no-qos",
        r"missing 1 required positional argument: 'qos_profile'",
        "create_publisher and create_subscription need a queue depth (QoS) as their last argument.",
        "Add a depth as the last argument, for example 10.",
    ),
    KnownError(
        "error.callback-takes-no-message",
        r"callback should be either be callable with one argument",
        "A subscription's callback takes one argument (the message) or two (the message and its message info). "
        "Yours can't be called like that.",
        "Give it one argument besides self: def on_battery(self, message: Float32).",
    ),
    KnownError(
        "error.node-without-name",
        r"missing 1 required positional argument: 'node_name'",
        "A node needs a name, but Node.__init__ didn't receive one.",
        "Write super().__init__('your_node_name').",
    ),
    KnownError(
        "error.timer-without-callback",
        r"create_timer\(\) missing 1 required positional argument: 'callback'",
        "A timer needs a period and a function to call, but it was given only one of them.",
        "Write create_timer(1.0, self.on_timer), without parentheses after the function.",
    ),
    KnownError(
        "error.missing-argument",
        r"missing 1 required positional argument: '\w+'",
        "A function was called without an argument that it needs. A timer calls its callback without arguments, "
        "and a subscription passes it the message. Or your code called the callback instead of passing it.",
        "For a timer: def on_timer(self). For a subscription: create_subscription(Float32, name, "
        "self.on_battery, 10), without parentheses.",
    ),
    KnownError(
        "error.callback-called",
        r"'NoneType' object is not callable",
        "The callback is None. Usually it was called instead of passed, so the timer received its return value, "
        "None.",
        "Pass the function without parentheses: create_timer(2.0, self.publish_joints).",
    ),
    KnownError(
        "error.no-message-object",
        r"Expected <class '[\w.]*\.(\w+)'>, got <class '([\w.]+)'>",
        "publish() was given something that is not a message of the publisher's type.",
        "Make a message of the right class, fill its fields, and publish that.",
    ),
    KnownError(
        "error.no-message-class",
        r"has no attribute '_TYPE_SUPPORT'",
        "The message type that was given is not a message class. (The mention of ROS 1 is rclpy's guess, and "
        "usually wrong.)",
        "Give the class itself, for example Float32 from std_msgs.msg, not a Python type or a string.",
    ),
    KnownError(
        "error.topic-of-two-types",
        r"existing topic name \S+ with incompatible type",
        "This program already uses the topic with another message type.",
        "Use one message type per topic name, or give the second topic another name.",
    ),
    KnownError(
        "error.name-taken",
        r"property '(\w+)' of '\w+' object has no setter",
        "Node already has a property with this name, so you cannot set it.",
        "Give your attribute another name, for example joint_pub instead of publishers.",
    ),
    KnownError(
        "error.callback-without-signature",
        r"no signature found for builtin",
        "rclpy checks how many arguments a callback takes, but this built-in method has no signature to check.",
        "Write the callback yourself, for example lambda message: self.inbox.append(message).",
    ),
    KnownError(
        "error.method-in-with",
        r"'method' object does not support the context manager protocol",
        "A with statement received a method. If the error is in the line super().__init__, your class has a method "
        "named handle, but Node needs this name itself.",
        "Rename your method handle. If the with statement is your own, call the method in it.",
    ),
    KnownError(
        "error.invalid-topic-name",
        r"InvalidTopicNameException|Invalid topic name",
        "The topic name breaks the naming rules (no space, hyphen, trailing slash or leading digit).",
        "Write the name exactly as the exercise gives it.",
    ),
    KnownError(
        "error.invalid-node-name",
        r"InvalidNodeNameException|Invalid node name",
        "The node name breaks the naming rules (letters, digits and underscores only, no slash).",
        "Give the node a plain name, such as my_robot.",
    ),
    KnownError(
        "error.topic-name-no-text",
        r"rclpy_resolve_name\(\): incompatible function arguments",
        "The name of a topic or service must be a string, but your code passes something else. In ROS 2, the "
        "message type comes first, then the name. In ROS 1, it was the other way around.",
        "Write the type first, then the name as a string: create_publisher(String, 'name', 10).",
    ),
    KnownError(
        "error.ros-arguments",
        r"RCLInvalidROSArgsError",
        "ROS can't parse one of its arguments; the error quotes it. A remapping rule is a single string with := in "
        "it. A node's new name may contain only letters, digits, and underscores, no slash.",
        "Write each rule as two strings: '-r', '__node:=new_name'. To change the namespace, use the argument "
        "namespace.",
    ),
    KnownError(
        "error.context-down",
        r"publisher's context is invalid",
        "The context was already shut down, so nothing can be published. On Ctrl-C, rclpy shuts it down right away.",
        "Leave the message out, or publish it before the context is shut down.",
    ),
    KnownError(
        "error.destroyed",
        r"InvalidHandle: cannot use Destroyable because destruction was requested",
        "An object is used after it was destroyed. A Destroyable in the error is a node, a publisher, a timer, or "
        "the like.",
        "Call destroy_node() and similar methods only after the last use.",
    ),
    KnownError(
        "error.wrong-value-type",
        r"(?:must be real number, not str|bad argument type for built-in operation|a float is required)",
        "A value of the wrong type was put into a message field.",
        "Put Python floats into float fields: float(angle).",
    ),
    KnownError(
        "error.field-of-other-type",
        r"AssertionError: The '\w+' field must be",
        "A message field was given a value of the wrong type.",
        "Give the field a value of its type: float(angle) for a float, str(word) for a string, a list for an array.",
    ),
    KnownError(
        "error.generic-publisher",
        r"type 'Publisher' is not subscriptable|'type' object is not subscriptable",
        "Publisher[String] is written for a newer rclpy. In Jazzy, Publisher takes no type parameter.",
        "Annotate with plain Publisher.",
    ),
    KnownError(
        "error.reads-keyboard",
        r"EOFError: EOF when reading a line",
        "The program waits for keyboard input. A robot program has no keyboard, and neither does the judge.",
        "Remove input(), or read the value from a parameter.",
    ),
    KnownError(
        "error.module-without-name",
        r"module '(?:rclpy|\w+_(?:msgs|srvs|interfaces))[\w.]*' has no attribute",
        "The module contains no such name. Or a file of yours has the module's name (for example rclpy.py) and "
        "hides the real module.",
        "Check the spelling, and don't name your file like a ROS module.",
    ),
    KnownError(
        "error.module-hides-package",
        r"'\w+' is not a package",
        "A .py file with that name, next to your program, hides the package.",
        "Don't name your file like a package.",
    ),
    KnownError(
        "error.import-not-found",
        r"ModuleNotFoundError: No module named '([\w.]+)'|ImportError: cannot import name",
        "The program imports a module or a name that does not exist here.",
        "Check the spelling of the import. Message classes come from modules such as std_msgs.msg. Put code from "
        "a second file into the answer: only one file is run.",
    ),
    KnownError(
        "error.name-not-defined",
        r"NameError: name '(\w+)' is not defined",
        "The program uses a name that was never defined or imported in this file.",
        "Import or define it. The file runs on its own, without the other cells of the notebook.",
    ),
    KnownError(
        "error.indentation",
        r"(?:Indentation|Tab)Error",
        "The indentation is wrong, so Python cannot read the file.",
        "Indent the block like the lines around it (four spaces per level).",
    ),
    KnownError(
        "error.print-statement",
        r"Missing parentheses in call to 'print'",
        "print without parentheses is Python 2, but ROS 2 needs Python 3.",
        "Write print(...), and look for other Python 2 code.",
    ),
    KnownError(
        "error.notebook-command",
        r"(?s)^ *(?:!|%%?)\w.*SyntaxError",
        "A line that begins with % or ! is a notebook command, not Python.",
        "Remove that line from the answer.",
    ),
    KnownError(
        "error.syntax",
        r"SyntaxError",
        "Python cannot read the file, so none of it ran.",
        "Check the line named above and the line before it: brackets, quotes, colons.",
    ),
    KnownError(
        "error.out-of-memory",
        r"MemoryError",
        "The program asked for more memory than an answer may use.",
        "Look for a list that grows without end.",
    ),
    KnownError(
        "error.disk-full",
        r"No space left on device|File too large",
        f"The program wrote more than the {WRITABLE_MIB} MB that an answer may write.",
        "Write less, or nothing: the judge reads no files of an answer.",
    ),
    KnownError(
        "error.too-many-files",
        r"Too many open files",
        "The program keeps more files or connections open than an answer may.",
        "Close each file that you open (with open(...) as file), and create each publisher and node only once.",
    ),
    KnownError(
        "error.too-many-threads",
        r"can't start new thread|Resource temporarily unavailable",
        f"The program started more than the {ANSWER_LIMITS.processes} threads and processes that an answer may have.",
        "Look for a loop that starts a new one in each iteration. If a library starts them, limit it: set "
        "os.environ['OMP_NUM_THREADS'] before the import, or call torch.set_num_threads or cv2.setNumThreads.",
    ),
)

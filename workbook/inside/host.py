"""Runs one answer as the main program.

    python -P run.py host [--parent PID] [--attended] [--limit NAME=VALUE]... [--driver DRIVER.py]
        [--tap DOMAIN] ANSWER.py [...]

Whatever reasonable shape an answer has is accepted. The file runs as `__main__`. Only if it ends normally and no
context was ever initialized does the host help: it calls an argument-less `main()`, or else spins the one leaf
Node subclass that the file defines.

With a driver, that one runs as `__main__`, and the file is the module `answer`, which it imports. Before that, the host
reads a key from standard input. The driver finds a function `sign` that signs what it reports (see `signer`).
"""

import asyncio
import inspect
import itertools
import os
import resource
import select
import signal
import sys
import types
from collections.abc import Callable
from contextlib import suppress
from importlib.machinery import ModuleSpec

from workbook.inside.libc import die_with_parent
from workbook.inside.student_traceback import shown, take_over_threads, tell_who_stays, write

SWITCH_INTERVAL_S = 1e-4
"""While a handler waits for its thread, rclpy's MultiThreadedExecutor loops without a pause. With the 5 ms that Python
gives a thread it would keep the others from their work again and again: counts came out wrong, and checks took 20 s."""
MOST_KEY_BYTES = 64
BEHIND_THE_KEY = bytes(512)
"""When the hash has been given so many bytes, it has mixed in its first blocks, which hold the key, and reused their
memory."""
LONGEST_REPORT = 2_000
"""Characters of a report. A text that is too long is cut in recordings, and its signature does not fit any more."""
LIMITS = {
    "memory": resource.RLIMIT_AS,
    "processes": resource.RLIMIT_NPROC,
    "file_size": resource.RLIMIT_FSIZE,
    "open_files": resource.RLIMIT_NOFILE,
    "cpu": resource.RLIMIT_CPU,
    "core": resource.RLIMIT_CORE,
    "signals": resource.RLIMIT_SIGPENDING,
}


def end_if_nobody_reads() -> None:
    """End this process if the reader of its output is gone: it was killed before the sandbox was set to die with it."""
    pipe = select.poll()
    pipe.register(1, 0)
    if any(event & select.POLLERR for _, event in pipe.poll(0)):
        os._exit(1)


def apply_limit(text: str) -> None:
    """Set a limit, given as NAME=VALUE, that the program cannot raise.

    For processor time the hard limit is one second higher, so that SIGXCPU comes before SIGKILL.
    """
    name, value = text.split("=")
    _, hard = resource.getrlimit(LIMITS[name])
    wanted = int(value)
    if hard != resource.RLIM_INFINITY:
        wanted = min(wanted, hard)
    grace = 1 if name == "cpu" and hard == resource.RLIM_INFINITY else 0
    resource.setrlimit(LIMITS[name], (wanted, wanted + grace))


def watch_contexts() -> list[object]:
    """Return a list that grows by one whenever any rclpy context is initialized."""
    from rclpy.context import Context

    started: list[object] = []
    original = Context.init

    def init(self, *args, **kwargs):  # type: ignore[no-untyped-def]
        started.append(True)
        return original(self, *args, **kwargs)

    init.__doc__ = original.__doc__
    Context.init = init  # type: ignore[method-assign]
    return started


def callable_without_arguments(function: object) -> bool:
    """Whether this is a Python function that needs no arguments."""
    if not inspect.isfunction(function):
        return False
    try:
        inspect.signature(function).bind()
    except TypeError:
        return False
    return True


def leaf_node_classes(module: types.ModuleType) -> list[type]:
    """Node subclasses that this file defines, apart from those that are only bases of another one here."""
    from rclpy.node import Node

    own = [
        value
        for value in vars(module).values()
        if isinstance(value, type) and issubclass(value, Node) and value.__module__ == "__main__"
    ]
    unique = list(dict.fromkeys(own))
    return [one for one in unique if not any(other is not one and issubclass(other, one) for other in unique)]


def spin_class(node_class: type) -> None:
    """Initialize ROS, make one node of this class, and spin it until Ctrl-C or a shutdown."""
    import rclpy
    from rclpy.executors import ExternalShutdownException

    rclpy.init()
    try:
        rclpy.spin(node_class())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


def help_along(module: types.ModuleType) -> None:
    """Call the file's `main()` if it needs no arguments; otherwise spin its leaf Node subclass if there is only one."""
    main = getattr(module, "main", None)
    if inspect.iscoroutinefunction(main) and callable_without_arguments(main):
        asyncio.run(main())
    elif callable_without_arguments(main):
        main()  # type: ignore[misc]
    else:
        leaves = leaf_node_classes(module)
        if len(leaves) == 1:
            spin_class(leaves[0])


def student_traceback(error: BaseException) -> str:
    """The traceback without this host, a driver that imported the file, and what reports to the panel."""
    return shown(error, lambda frame: frame.filename == __file__ and frame.name == "exec_module")


def was_interrupted(error: BaseException | None) -> bool:
    """Whether Ctrl-C came: it has left the program, or rclpy has shut the context down."""
    rclpy = sys.modules.get("rclpy")
    return isinstance(error, KeyboardInterrupt) or (rclpy is not None and not rclpy.ok())


def compiled(path: str) -> types.CodeType:
    """The code of a file. Raises SyntaxError."""
    with open(path, "rb") as file:
        return compile(file.read(), path, "exec", dont_inherit=True)


def execute(path: str, **given: object) -> types.ModuleType:
    """Run the file as `__main__`, with what it is `given` as globals."""
    module = types.ModuleType("__main__")
    module.__file__ = path
    module.__dict__.update(given, __builtins__=__builtins__)
    code = compiled(path)
    sys.modules["__main__"] = module
    exec(code, module.__dict__)
    return module


class AnswerFinder:
    """For `sys.meta_path`, and a loader: the answer as the module `answer`."""

    def __init__(self, path: str) -> None:
        self.path = path

    def find_spec(self, name: str, path: object = None, target: object = None) -> ModuleSpec | None:
        """Part of the import protocol: the answer; None for all other names."""
        return ModuleSpec(name, self, origin=self.path) if name == "answer" else None  # type: ignore[arg-type]

    def create_module(self, spec: ModuleSpec) -> None:
        """Part of the import protocol: None asks for an ordinary module."""

    def exec_module(self, module: types.ModuleType) -> None:
        """Part of the import protocol: run the answer's code in its module."""
        module.__file__ = self.path
        exec(compiled(self.path), module.__dict__)


def signer() -> Callable[[str, str], str]:
    """A function that signs a report for a topic: it returns a number, a signature, and the text, with blanks between.
    Without a key it returns the text.

    It takes the key from standard input, which is empty from then on. It keeps a hash that has taken in the key, not
    the key itself. Code in this process can still find and call the function.
    """
    from hashlib import blake2b

    key = bytearray(MOST_KEY_BYTES)
    length = os.readv(0, [key])
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0)
    os.close(nothing)
    keyed = blake2b(key=memoryview(key)[:length], digest_size=16)
    keyed.update(BEHIND_THE_KEY)
    key[:] = bytes(MOST_KEY_BYTES)
    numbers = itertools.count(1)
    if not length:
        return lambda topic, text: text

    def sign(topic: str, text: str) -> str:
        """What to publish on `topic` for `text`, which loses what a message cannot carry."""
        text = text[:LONGEST_REPORT].replace("\0", " ").encode(errors="backslashreplace").decode()
        number, mine = next(numbers), keyed.copy()
        mine.update(f"{topic}\n{number}\n{text}".encode())
        return f"{number} {mine.hexdigest()} {text}"

    return sign


def run(path: str) -> None:
    """Run the file as `__main__`; if it never initializes a context, see `help_along`."""
    started = watch_contexts()
    module = execute(path)
    if not started:
        help_along(module)


def run_with_driver(path: str, driver: str) -> None:
    """Run the driver as `__main__`. It imports the answer when it is ready for that."""
    sign = signer()
    sys.meta_path.insert(0, AnswerFinder(path))
    execute(driver, sign=sign)


def obey(options: list[str]) -> tuple[str | None, list[str]]:
    """Do as the options at the front say. Returns the driver, if there is one, and the program with its arguments."""
    driver = None
    while options and options[0] in (
        "--parent",
        "--attended",
        "--limit",
        "--driver",
        "--tap",
    ):
        if options[0] == "--attended":
            end_if_nobody_reads()
            options = options[1:]
            continue
        if options[0] == "--parent":
            die_with_parent(int(options[1]))
        elif options[0] == "--driver":
            driver = options[1]
        elif options[0] == "--tap":
            from workbook.inside.tap import install

            install(int(options[1]))
        else:
            apply_limit(options[1])
        options = options[2:]
    return driver, options


def main(arguments: list[str]) -> None:
    """Run the program that the command line names. Exits with code 1 after an exception, 130 after Ctrl-C."""
    driver, program = obey(arguments)
    path = program[0]
    sys.argv = program
    sys.setswitchinterval(SWITCH_INTERVAL_S)
    # Whoever started us may ignore Ctrl-C (a slot does), and a program inherits that. In a terminal it would not.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    take_over_threads(student_traceback)
    error: BaseException | None = None
    try:
        if driver is None:
            run(path)
        else:
            run_with_driver(path, driver)
    except SystemExit:
        raise
    except BaseException as raised:
        error = raised
        write(student_traceback(error))
        sys.exit(130 if isinstance(error, KeyboardInterrupt) else 1)
    finally:
        if was_interrupted(error):
            with suppress(KeyboardInterrupt):
                tell_who_stays(path)

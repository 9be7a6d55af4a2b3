"""Run one answer as the main program.

    python -P run.py host [--parent PID] [--attended] [--limit NAME=VALUE]... [--driver DRIVER.py]
        [--tap DOMAIN] ANSWER.py [...]

The file runs as `__main__` and may have any reasonable form. If it finishes normally without ever initializing an rclpy
context, the host calls its `main()`, if that can be called without arguments. Otherwise, the host spins the file's leaf
Node subclass, if there's exactly one.

If there's a driver, it runs as `__main__` instead and imports the file as the module `answer`. Before that, the host
reads a key from standard input. It gives the driver a global function `sign`, which signs reports with the key (see
`signer`).
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

SWITCH_INTERVAL_S = 4e-5
"""The interval (s) at which Python switches threads.

While a handler waits for a free thread, rclpy's MultiThreadedExecutor busy-waits. With Python's default of 5 ms, the
busy thread delayed the other threads again and again, so counts were wrong and checks took 20 s. With 0.1 ms, checks
usually took 2 s. But on one machine, the judge saw no rest within its limit and went to the wall clock. With 0.01 ms,
checks of programs with a single thread took 0.1 s longer.
"""
MOST_KEY_BYTES = 64
BEHIND_THE_KEY = bytes(512)
"""Padding that is hashed after the key.

After this many bytes, the hash object has processed the key and overwritten it in its buffer.
"""
LONGEST_REPORT = 2_000
"""The maximum length of a report, in characters.

Recordings truncate longer strings, and then the signature wouldn't match.
"""
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
    """Exit if no process reads our output. Then the reader was killed before the sandbox was tied to it."""
    pipe = select.poll()
    pipe.register(1, 0)
    if any(event & select.POLLERR for _, event in pipe.poll(0)):
        os._exit(1)


def apply_limit(text: str) -> None:
    """Set a limit that the program can't raise. `text` has the form NAME=VALUE (see `LIMITS`).

    For CPU time, the hard limit is one second higher, so that the kernel sends SIGXCPU before SIGKILL.
    """
    name, value = text.split("=")
    _, hard = resource.getrlimit(LIMITS[name])
    wanted = int(value)
    if hard != resource.RLIM_INFINITY:
        wanted = min(wanted, hard)
    grace = 1 if name == "cpu" and hard == resource.RLIM_INFINITY else 0
    resource.setrlimit(LIMITS[name], (wanted, wanted + grace))


def watch_contexts() -> list[object]:
    """Return a list to which an item is added each time an rclpy context is initialized."""
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
    """Return whether `function` is a Python function that can be called without arguments."""
    if not inspect.isfunction(function):
        return False
    try:
        inspect.signature(function).bind()
    except TypeError:
        return False
    return True


def leaf_node_classes(module: types.ModuleType) -> list[type]:
    """Return the Node subclasses that the module defines, except those that have a subclass in the module."""
    from rclpy.node import Node

    own = [
        value
        for value in vars(module).values()
        if isinstance(value, type) and issubclass(value, Node) and value.__module__ == "__main__"
    ]
    unique = list(dict.fromkeys(own))
    return [one for one in unique if not any(other is not one and issubclass(other, one) for other in unique)]


def spin_class(node_class: type) -> None:
    """Initialize ROS, create one node of this class, and spin it until Ctrl-C or a shutdown."""
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
    """Call the file's `main()` if it needs no arguments.

    Otherwise, spin its leaf Node subclass if there's exactly one.
    """
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
    """Format an exception's traceback, leaving out the frames of this folder's files and of a driver."""
    return shown(error, lambda frame: frame.filename == __file__ and frame.name == "exec_module")


def was_interrupted(error: BaseException | None) -> bool:
    """Return whether the program was interrupted with Ctrl-C.

    In that case, `error` is a KeyboardInterrupt, or rclpy has shut the context down.
    """
    rclpy = sys.modules.get("rclpy")
    return isinstance(error, KeyboardInterrupt) or (rclpy is not None and not rclpy.ok())


def compiled(path: str) -> types.CodeType:
    """Compile a file. Raises SyntaxError if its code is invalid."""
    with open(path, "rb") as file:
        return compile(file.read(), path, "exec", dont_inherit=True)


def execute(path: str, **given: object) -> types.ModuleType:
    """Run the file at `path` as `__main__`, with `given` as additional globals. Return the module."""
    module = types.ModuleType("__main__")
    module.__file__ = path
    module.__dict__.update(given, __builtins__=__builtins__)
    code = compiled(path)
    sys.modules["__main__"] = module
    exec(code, module.__dict__)
    return module


class AnswerFinder:
    """Makes the answer importable as the module `answer`. It's both a finder (for `sys.meta_path`) and a loader."""

    def __init__(self, path: str) -> None:
        self.path = path

    def find_spec(self, name: str, path: object = None, target: object = None) -> ModuleSpec | None:
        """Return the spec of the module `answer`, or None for any other name. Part of the import protocol."""
        return ModuleSpec(name, self, origin=self.path) if name == "answer" else None  # type: ignore[arg-type]

    def create_module(self, spec: ModuleSpec) -> None:
        """Return None to request an ordinary module. Part of the import protocol."""

    def exec_module(self, module: types.ModuleType) -> None:
        """Run the answer's code in its module. Part of the import protocol."""
        module.__file__ = self.path
        exec(compiled(self.path), module.__dict__)


def signer() -> Callable[[str, str], str]:
    """Return a function that signs a report for a topic.

    That function returns a number, a signature, and the report, separated by spaces, or only the report if there's no
    key. The key is read from standard input, which is empty from then on. The function keeps a hash state that includes
    the key, but not the key itself, so the answer can't read the key. However, code in this process can still find and
    call the function.
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
        """Return the signed report to publish on `topic`. Replace characters that a message can't contain."""
        text = text[:LONGEST_REPORT].replace("\0", " ").encode(errors="backslashreplace").decode()
        number, mine = next(numbers), keyed.copy()
        mine.update(f"{topic}\n{number}\n{text}".encode())
        return f"{number} {mine.hexdigest()} {text}"

    return sign


def run(path: str) -> None:
    """Run the file as `__main__`. If it never initializes a context, call `help_along`."""
    started = watch_contexts()
    module = execute(path)
    if not started:
        help_along(module)


def run_with_driver(path: str, driver: str) -> None:
    """Run the driver as `__main__`. The driver then imports the answer as the module `answer`."""
    sign = signer()
    sys.meta_path.insert(0, AnswerFinder(path))
    execute(driver, sign=sign)


def obey(options: list[str]) -> tuple[str | None, list[str]]:
    """Apply the leading options.

    Return the driver's path, or None if there is none, and the program with its arguments.
    """
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
    """Run the program from the command line. Exit with code 1 after an exception, or 130 after Ctrl-C."""
    driver, program = obey(arguments)
    path = program[0]
    sys.argv = program
    sys.setswitchinterval(SWITCH_INTERVAL_S)
    # If our parent ignores SIGINT, as a slot does, we've inherited that. Restore the behavior in a terminal.
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

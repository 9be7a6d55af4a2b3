"""Runs one answer as the main program.

    python -P run.py host [--parent PID] [--attended] [--limit NAME=VALUE]... [--driver DRIVER.py]
        [--tap DOMAIN] ANSWER.py [...]

Whatever reasonable shape an answer has is accepted. The file runs as `__main__`. Only if it ends normally and no
context was ever initialized does the host help: it calls an argument-less `main()`, or else spins the one leaf
Node subclass that the file defines.

With a driver, the file is loaded as the module `answer`, and the driver, which imports it, runs as `__main__`.
"""

import asyncio
import inspect
import os
import resource
import select
import signal
import sys
import traceback
import types

from workbook.inside.libc import die_with_parent

SWITCH_INTERVAL_S = 1e-4
"""While a handler waits for its thread, rclpy's MultiThreadedExecutor loops without a pause. With the 5 ms that Python
gives a thread it would keep the others from their work again and again: counts came out wrong, and checks took 20 s."""
TAP = "workbook.inside.tap"
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


def print_student_traceback(error: BaseException) -> None:
    """Print the traceback without the frames of this host and of what reports to the panel."""
    frames = error.__traceback__
    while frames is not None and frames.tb_frame.f_code.co_filename == __file__:
        frames = frames.tb_next
    frame = frames
    while frame is not None:
        while frame.tb_next is not None and frame.tb_next.tb_frame.f_globals.get("__name__") == TAP:
            frame.tb_next = frame.tb_next.tb_next
        frame = frame.tb_next
    sys.stdout.flush()
    traceback.print_exception(type(error), error, frames)


def execute(path: str, name: str) -> types.ModuleType:
    """Run the file as the module `name`."""
    with open(path, "rb") as file:
        source = file.read()
    module = types.ModuleType(name)
    module.__file__ = path
    module.__dict__["__builtins__"] = __builtins__
    code = compile(source, path, "exec", dont_inherit=True)
    sys.modules[name] = module
    exec(code, module.__dict__)
    return module


def run(path: str) -> None:
    """Run the file as `__main__`; if it never initializes a context, see `help_along`."""
    started = watch_contexts()
    module = execute(path, "__main__")
    if not started:
        help_along(module)


def run_with_driver(path: str, driver: str) -> None:
    """Load the answer as the module `answer`, then run the driver as `__main__`."""
    execute(path, "answer")
    execute(driver, "__main__")


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
    try:
        if driver is None:
            run(path)
        else:
            run_with_driver(path, driver)
    except SystemExit:
        raise
    except BaseException as error:
        print_student_traceback(error)
        sys.stderr.flush()
        sys.exit(130 if isinstance(error, KeyboardInterrupt) else 1)

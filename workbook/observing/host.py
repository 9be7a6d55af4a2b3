"""Runs one answer as the main program. It needs nothing of the workbook, only rclpy.

    python host.py [--parent PID] [--attended] [--fence] [--limit NAME=VALUE]... [--driver DRIVER.py] ANSWER.py [...]

Whatever reasonable shape an answer has is accepted. The file runs as `__main__`. Only if it ends normally and no
context was ever initialized does the host help: it calls an argument-less `main()`, or else spins the one leaf
Node subclass that the file defines.

With a driver, the file is loaded as the module `answer`, and the driver, which imports it, runs as `__main__`.
"""

import asyncio
import ctypes
import importlib.util
import inspect
import os
import resource
import select
import signal
import sys
import traceback
import types

PR_SET_PDEATHSIG = 1
LIMITS = {
    "memory": resource.RLIMIT_AS,
    "processes": resource.RLIMIT_NPROC,
    "file_size": resource.RLIMIT_FSIZE,
    "open_files": resource.RLIMIT_NOFILE,
    "cpu": resource.RLIMIT_CPU,
    "core": resource.RLIMIT_CORE,
}


def die_with_parent(parent: int) -> None:
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
    if os.getppid() != parent:
        os._exit(1)


def end_if_nobody_reads() -> None:
    """End if nobody can read what we say any more: who started us was killed before our box was tied to it."""
    pipe = select.poll()
    pipe.register(1, 0)
    if any(event & select.POLLERR for _, event in pipe.poll(0)):
        os._exit(1)


def fence() -> None:
    """Refuse system calls that no node needs, here and in all children: see `powers.py` beside this file."""
    place = os.path.join(os.path.dirname(os.path.abspath(__file__)), "powers.py")
    spec = importlib.util.spec_from_file_location("powers", place)
    assert spec is not None and spec.loader is not None
    powers = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(powers)
    powers.fence()


def apply_limit(text: str) -> None:
    """Set a limit that the program cannot raise. Of processor time it has a second more, to be told that it is over."""
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
    """Print the traceback without the frames of this host."""
    frames = error.__traceback__
    while frames is not None and frames.tb_frame.f_code.co_filename == __file__:
        frames = frames.tb_next
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
    started = watch_contexts()
    module = execute(path, "__main__")
    if not started:
        help_along(module)


def run_with_driver(path: str, driver: str) -> None:
    execute(path, "answer")
    execute(driver, "__main__")


def start(arguments: list[str]) -> None:
    driver = None
    while arguments and arguments[0] in ("--parent", "--attended", "--limit", "--driver", "--fence"):
        if arguments[0] in ("--attended", "--fence"):
            end_if_nobody_reads() if arguments[0] == "--attended" else fence()
            arguments = arguments[1:]
            continue
        if arguments[0] == "--parent":
            die_with_parent(int(arguments[1]))
        elif arguments[0] == "--driver":
            driver = arguments[1]
        else:
            apply_limit(arguments[1])
        arguments = arguments[2:]
    path = arguments[0]
    sys.argv = arguments
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


if __name__ == "__main__":
    start(sys.argv[1:])

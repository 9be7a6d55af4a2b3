"""Runs one answer as the main program. It needs nothing of the workbook, only rclpy.

    python host.py [--parent PID] [--fence] [--limit NAME=VALUE]... [--driver DRIVER.py] ANSWER.py [--ros-args ...]

Whatever reasonable shape an answer has is accepted. The file runs as `__main__`. Only if it ends normally and no
context was ever initialized does the host help: it calls an argument-less `main()`, or else spins the one leaf
Node subclass that the file defines.

With a driver, the file is loaded as the module `answer`, and the driver, which imports it, runs as `__main__`.
"""

import asyncio
import ctypes
import errno
import inspect
import os
import platform
import resource
import signal
import struct
import sys
import traceback
import types

PR_SET_PDEATHSIG = 1
PR_SET_SECCOMP = 22
SECCOMP_MODE_FILTER = 2
ALLOW, REFUSE, PRETEND = 0x7FFF0000, 0x00050000 | errno.EPERM, 0x00050000
"""What a filter answers: go on; "not permitted"; success without doing anything."""
LOAD, IF_EQUAL, IF_AT_LEAST, ANSWER = 0x20, 0x15, 0x35, 0x06
X86_64, OTHER_ABI = 0xC000003E, 0x40000000
REFUSED_CALLS = (
    *(
        101,
        310,
        311,
        312,
        438,
    ),  # into other processes: ptrace, process_vm_readv and _writev, kcmp, pidfd_getfd
    *(248, 249, 250),  # keys, which the whole session of the grader shares: add_key, request_key, keyctl
    *(321, 323, 298),  # bpf, userfaultfd, perf_event_open
    *(425, 426, 427),  # io_uring
    *(272, 308),  # unshare, setns
    *(165, 166, 155, 428, 429, 430, 431, 432, 433, 442),  # mounting
    *(
        304,
        175,
        313,
        176,
        246,
        320,
        163,
        167,
        168,
        169,
    ),  # open_by_handle_at, modules, kexec, acct, swap, reboot
    *(188, 189, 190, 197, 198, 199, 463, 466),  # attributes of files; some of them are rights
)
CHANGES_OF_RIGHTS = (90, 91, 268, 452)  # chmod, fchmod, fchmodat, fchmodat2
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


def fence() -> None:
    """Refuse system calls that no node needs and that programs have got out of boxes with, here and in all children.

    The devices in a box are those of the machine, and belong to root. If the grader is root, an answer could change
    their rights, so it may only believe that it does. A kernel that knows no filters leaves this out: it is a second
    fence behind that of the box.
    """
    if platform.machine() != "x86_64":
        return
    answers = dict.fromkeys(REFUSED_CALLS, REFUSE)
    if os.stat(os.devnull).st_uid == os.getuid():
        answers |= dict.fromkeys(CHANGES_OF_RIGHTS, PRETEND)
    steps = [
        (LOAD, 0, 0, 4),
        (IF_EQUAL, 1, 0, X86_64),
        (ANSWER, 0, 0, REFUSE),
        (LOAD, 0, 0, 0),
        (IF_AT_LEAST, 0, 1, OTHER_ABI),
        (ANSWER, 0, 0, REFUSE),
    ]
    for call, answer in answers.items():
        steps += [(IF_EQUAL, 0, 1, call), (ANSWER, 0, 0, answer)]
    steps.append((ANSWER, 0, 0, ALLOW))
    code = ctypes.create_string_buffer(b"".join(struct.pack("=HBBI", *step) for step in steps))
    program = struct.pack("HP", len(steps), ctypes.addressof(code))
    ctypes.CDLL(None).prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, ctypes.c_char_p(program), 0, 0)


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
    while arguments and arguments[0] in ("--parent", "--limit", "--driver", "--fence"):
        if arguments[0] == "--fence":
            fence()
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

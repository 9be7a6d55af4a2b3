"""Starts answers by forking: Python and rclpy are imported once, and not again for every answer.

    python -P fork_server.py CHANNEL

CHANNEL is the number of an inherited socket. On it comes one request after another (see `Request`), each with two
descriptors: where the program's output goes, and where to tell what became of it. For each, an usher is forked, and it
forks the program, after joining the box that was made for it, if there is one. Such a program is shut in before a line
of the answer is read: in the name spaces of its box, without capabilities, with nothing open but its output. A program
without a box dies with its usher, and that with this process.

A program must not notice that something was imported before it. So the modules are put on a shelf (`Shelf`) and come
out only when the program imports them.

This file runs by itself and needs nothing of the workbook but `host.py` and `powers.py` beside it.
"""

import builtins
import contextlib
import ctypes
import gc
import importlib.util
import json
import os
import signal
import socket
import sys
import types
import warnings
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from importlib.machinery import ModuleSpec
from pathlib import Path
from typing import Any

REQUEST_BYTES = 100_000
PR_SET_PDEATHSIG = 1
SIGSET_BYTES = 128
FENCE = "--fence"
MARK = b"WORKBOOK_RUN="
MARK_BYTES = 80
"""Room for the mark of a program (see `Mark`), which whoever starts this process leaves in its environment: blanks."""
FAILED = 126
NAMESPACES = 0x10000000 | 0x00020000 | 0x20000000 | 0x08000000 | 0x04000000 | 0x02000000
"""CLONE_NEWUSER, NEWNS, NEWPID, NEWIPC, NEWUTS, NEWCGROUP. The network is that of the observer, as for any answer."""
WARMED = (
    "rclpy.node",
    "rclpy.executors",
    "rclpy.qos",
    "rclpy.time_source",
    "rosgraph_msgs.msg",
    "std_msgs.msg",
    "std_srvs.srv",
    "numpy",  # every first node imports it: messages with arrays need it
)
TYPE_SUPPORT = (
    "builtin_interfaces",
    "rcl_interfaces",
    "rosgraph_msgs",
    "service_msgs",
    "std_msgs",
    "std_srvs",
    "type_description_interfaces",
)
"""Packages whose compiled part is loaded when the first node, publisher, subscription or service is made."""
CHECKS = "ros_python_check_fields"

_libc = ctypes.CDLL(None, use_errno=True)


@dataclass(frozen=True)
class Request:
    """One program to start: the first process of its box (0: none), and what `host.start` and the program are given."""

    box: int
    arguments: list[str]
    environ: dict[str, str]
    folder: str


class Shelf:
    """Modules that are imported and do not show: an import takes them out, as if it had loaded them then.

    What a module imports at its top is taken out with it, so that the same names appear as in a fresh Python.
    """

    def __init__(self) -> None:
        self._modules: dict[str, types.ModuleType] = {}
        self._imports: dict[str, dict[str, None]] = {}

    def fill(self, load: Callable[[], object]) -> None:
        """Call `load`, and put all modules on the shelf that it imports."""
        before = set(sys.modules)
        original = builtins.__import__

        def noted(
            name: str, globals: Any = None, locals: Any = None, fromlist: Any = None, level: int = 0
        ) -> types.ModuleType:
            module = original(name, globals, locals, fromlist, level)
            self._note(name, globals or {}, fromlist or (), level)
            return module

        builtins.__import__ = noted
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                load()
        finally:
            builtins.__import__ = original
        for name in sorted(set(sys.modules) - before, reverse=True):
            module = self._modules[name] = sys.modules.pop(name)
            parent, _, child = name.rpartition(".")
            holder = sys.modules.get(parent) or self._modules.get(parent)
            if holder is not None and getattr(holder, child, None) is module:
                delattr(holder, child)

    def _note(self, name: str, importer: dict[str, Any], fromlist: Iterable[str], level: int) -> None:
        who = importer.get("__name__")
        if who == "importlib._bootstrap":
            who = _compiled_module_being_loaded()
        if not isinstance(who, str):
            return
        base = importlib.util.resolve_name("." * level + name, importer["__package__"]) if level else name
        wanted = [base, *(f"{base}.{item}" for item in fromlist if f"{base}.{item}" in sys.modules)]
        self._imports.setdefault(who, {}).update(dict.fromkeys(wanted))

    def find_spec(self, name: str, path: object = None, target: object = None) -> ModuleSpec | None:
        """For `sys.meta_path`: a module of the shelf."""
        module = self._modules.get(name)
        if module is None:
            return None
        spec = ModuleSpec(name, self, is_package=hasattr(module, "__path__"))  # type: ignore[arg-type]
        spec.loader_state = module.__spec__
        return spec

    def create_module(self, spec: ModuleSpec) -> types.ModuleType:
        return self._modules[spec.name]

    def exec_module(self, module: types.ModuleType) -> None:
        spec = module.__spec__
        assert spec is not None
        module.__spec__ = spec.loader_state
        del self._modules[spec.name]
        if hasattr(module, CHECKS):  # a message module asks for this when it is loaded
            setattr(module, CHECKS, os.environ.get("ROS_PYTHON_CHECK_FIELDS", ""))
        for name in self._imports.get(spec.name, ()):
            if name not in sys.modules and name in self._modules:
                importlib.import_module(name)


def _compiled_module_being_loaded() -> str | None:
    """Whose import a compiled module makes while it is loaded: the import system seems to ask for it itself."""
    frame: types.FrameType | None = sys._getframe()
    while frame is not None:
        spec = frame.f_locals.get("spec")
        if frame.f_globals.get("__name__") == "importlib._bootstrap" and isinstance(spec, ModuleSpec):
            return spec.name
        frame = frame.f_back
    return None


def import_what_answers_need() -> None:
    """Import rclpy, what the first node loads, and the messages that most answers use.

    Not the middleware: which one it is, a program may choose with RMW_IMPLEMENTATION until it makes a context.
    """
    for name in WARMED:
        importlib.import_module(name)
    for package in TYPE_SUPPORT:
        importlib.import_module(f"{package}.{package}_s__rosidl_typesupport_c")


def load(name: str) -> types.ModuleType:
    """A file beside this one. It does not stay among the modules that a program sees."""
    spec = importlib.util.spec_from_file_location(name, Path(__file__).with_name(f"{name}.py"))
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Tracer:
    """LTTng, which rclpy's wheels load, and the forks of this process.

    It has two threads, which a forked process does not get. Unless it is told so (what `liblttng-ust-fork` is for), at
    the program's end it cancels whatever threads have their place by then, and the program may hang.
    """

    def __init__(self) -> None:
        with open("/proc/self/maps") as maps:
            paths = {
                line.split()[-1] for line in maps if "/liblttng-ust-" in line or "/liblttng-ust.so" in line
            }
        libraries = [ctypes.CDLL(path) for path in sorted(paths)]
        self._library = next((one for one in libraries if hasattr(one, "ust_before_fork")), None)
        self._signals = ctypes.create_string_buffer(SIGSET_BYTES)

    def before_fork(self) -> None:
        if self._library is not None:
            self._library.ust_before_fork(self._signals)

    def after_fork_in_parent(self) -> None:
        if self._library is not None:
            self._library.ust_after_fork_parent(self._signals)

    def after_fork_in_program(self) -> None:
        if self._library is not None:
            self._library.ust_after_fork_child(self._signals)


class Mark:
    """The variable by which others find a program, and all that came of it, among the processes of the machine.

    The kernel goes on showing the environment that this process was started with, from its memory: there the mark has
    to be written.
    """

    def __init__(self) -> None:
        with open("/proc/self/stat") as file:
            fields = file.read().rsplit(")", 1)[1].split()
        begin, end = (int(text) for text in fields[47:49])  # env_start and env_end, see proc(5)
        place = ctypes.string_at(begin, end - begin).find(MARK + b" " * MARK_BYTES)
        self._address = begin + place + len(MARK) if place >= 0 else 0

    def write(self, mark: str) -> None:
        """Show `mark` as the mark of this process. Raises ValueError when there is no room for it."""
        text = mark.encode()
        if not self._address or len(text) > MARK_BYTES:
            raise ValueError(f"there is no room for the mark {mark!r}")
        ctypes.memmove(self._address, text.ljust(MARK_BYTES, b"\0"), MARK_BYTES)


def join_box(first: int) -> None:
    """Enter the name spaces of the process `first`; the process space takes effect for children.

    All at once: a process may enter a box that its own user has made, and afterwards has no power outside.
    """
    descriptor = os.pidfd_open(first)
    try:
        powers.checked("setns", _libc.setns(descriptor, NAMESPACES))
    finally:
        os.close(descriptor)


def become_program(request: Request, parent: int, output: int, tracer: Tracer, mark: Mark) -> None:
    """Turn this forked process into the one that runs the answer."""
    try:
        if request.box:
            powers.close_the_bounds()
            powers.be_powerless()
            powers.be_seen()
        else:
            mark.write(request.environ[MARK.decode().rstrip("=")])
            host.die_with_parent(parent)
        if FENCE in request.arguments:
            request.arguments.remove(FENCE)
            powers.fence()
        tracer.after_fork_in_program()  # only now: what it starts has no more powers than we
        os.setsid()
        os.chdir(request.folder)
        os.dup2(output, 1)
        os.dup2(output, 2)
        os.closerange(3, os.sysconf("SC_OPEN_MAX"))
        os.environ.clear()
        os.environ.update(request.environ)
    except BaseException as error:
        os.write(output, f"the program could not be started: {error}\n".encode())
        os._exit(FAILED)


def tell(status: int, text: str) -> bool:
    """Write to whoever waits for the program. Returns False when nobody does any more."""
    try:
        os.write(status, text.encode())
    except OSError:
        return False
    return True


def usher(request: Request, output: int, status: int, tracer: Tracer, mark: Mark) -> None:
    """In a fork: bring the program into its box. Returns in the program; the usher itself ends here.

    It writes the program's process number to `status`, and how it ended (as `os.waitpid` has it) when it has.
    With a program in a box all that it has started ends: the box goes.
    """
    code = 1
    try:
        _libc.prctl(PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0)
        if request.box:
            join_box(request.box)
        parent = os.getpid()
        program = os.fork()
        if program == 0:
            become_program(request, parent, output, tracer, mark)
            return
        os.close(output)
        if not tell(status, f"{program}\n"):
            os.kill(program, signal.SIGKILL)
        _, ended = os.waitpid(program, 0)
        if request.box:
            # Whoever has ended the box already has ended the program, too.
            with contextlib.suppress(ProcessLookupError):
                os.kill(request.box, signal.SIGKILL)
        tell(status, f"{ended}\n")
        code = 0
    except BaseException as error:
        tell(status, f"failed: {error}\n")
    os._exit(code)


def _reap() -> None:
    """Take note of ushers that have ended."""
    try:
        while os.waitpid(-1, os.WNOHANG)[0]:
            pass
    except ChildProcessError:
        pass


def serve(channel: socket.socket, tracer: Tracer, mark: Mark) -> list[str] | None:
    """Fork a program for each request. Returns its arguments in the program, None when the channel is closed."""
    while True:
        try:
            data, descriptors, _, _ = socket.recv_fds(channel, REQUEST_BYTES, 2)
        except ConnectionError:
            return None
        if not data:
            return None
        output, status = descriptors
        request = Request(**json.loads(data))
        tracer.before_fork()
        if os.fork() == 0:
            channel.detach()
            usher(request, output, status, tracer, mark)
            return request.arguments
        tracer.after_fork_in_parent()
        os.close(output)
        os.close(status)
        _reap()


def main() -> None:
    importlib.import_module("rclpy.context")  # as the host does for every answer
    shelf = Shelf()
    shelf.fill(import_what_answers_need)
    sys.meta_path.insert(0, shelf)
    channel = socket.socket(fileno=int(sys.argv[1]))
    channel.send(b"ready")
    gc.collect()
    gc.freeze()
    arguments = serve(channel, Tracer(), Mark())
    if arguments is not None:
        host.start(arguments)


host = load("host")
powers = load("powers")

if __name__ == "__main__":
    main()

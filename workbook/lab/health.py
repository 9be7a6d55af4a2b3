"""Check this machine for `workbook doctor` and suggest a fix for each problem.

Each check returns one HealthFinding. If a check raises an exception, `examine` reports it as a finding.
"""

import os
import platform
import shutil
import socket
import sys
import tempfile
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    from jupyter_client.blocking.client import BlockingKernelClient
    from jupyter_client.manager import KernelManager

    from workbook.recording.recording import ProcessRecord

Status = Literal["ok", "note", "fix"]
PING_PUBLISHER = Path(__file__).with_name("ping_publisher.py")
PING_LIMIT_S = 40.0
"""The longest wait (s) for a ping. With an empty disk cache and a busy processor, a program takes many seconds to
start.
"""
KERNEL_LIMIT_S = 50.0
"""The longest wait (s) for a kernel, which also has to import IPython."""
KERNEL_TRIES = 3
PORT_TAKEN = "Address already in use"
GIB = 2**30


@dataclass(frozen=True)
class HealthFinding:
    """One line of the report.

    The status is "fix" for a problem that has to be fixed, "note" for information that may be useful, and otherwise
    "ok".
    """

    status: Status
    title: str
    saw: str
    todo: str = ""


def check_python() -> HealthFinding:
    """Check the interpreter and the operating system."""
    from workbook.exercise.course import is_from_wheel
    from workbook.lab.bootstrap import EnvironmentProblem, check_machine

    saw = f"{platform.python_version()} on {platform.system()} {platform.machine()}, {' '.join(platform.libc_ver())}"
    if sys.prefix == sys.base_prefix:
        return HealthFinding(
            "note",
            "Python",
            f"{saw}, outside any environment",
            "Install the course into its own environment."
            if is_from_wheel()
            else "The wheels route uses .venv/bin/workbook.",
        )
    from workbook.ros.environment import uses_wheels

    if uses_wheels():
        try:
            check_machine()
        except EnvironmentProblem as problem:
            return HealthFinding("fix", "Python", saw, f"{str(problem)[0].upper()}{str(problem)[1:]}")
    return HealthFinding("ok", "Python", saw)


def leftovers(environ: Mapping[str, str]) -> list[str]:
    """Return the names of environment variables that a sourced ROS installation or another environment left behind."""
    from workbook.ros.environment import is_leftover

    return sorted(name for name in environ if is_leftover(name))


def check_leftovers(names: list[str]) -> HealthFinding:
    """Report variables that a sourced ROS left behind in the shell. Our own processes drop them."""
    from workbook.ros.environment import uses_wheels

    if not names:
        return HealthFinding("ok", "Shell", "no variables of another ROS")
    shown = ", ".join(names[:6]) + (f" and {len(names) - 6} more" if len(names) > 6 else "")
    if not uses_wheels():
        return HealthFinding("ok", "Shell", f"a ROS installation is sourced ({shown})")
    return HealthFinding(
        "note",
        "Shell",
        f"{shown}: left by a sourced ROS or another environment",
        "The workbook drops them. Your own scripts see them: use a terminal without that `source` line.",
    )


def check_rclpy() -> HealthFinding:
    """Check that rclpy imports from the right folder, and report its RMW."""
    import rclpy
    import std_msgs.msg

    from workbook.ros.environment import uses_wheels

    home = Path(rclpy.__file__).resolve()
    if uses_wheels() and not home.is_relative_to(Path(sys.prefix).resolve()):
        return HealthFinding(
            "fix",
            "rclpy",
            f"imported from {home.parent}, not from the environment",
            "Another ROS comes first on Python's path: open a terminal without its `source` line (PYTHONPATH must not "
            "name it).",
        )
    identifier = rclpy.get_rmw_implementation_identifier()
    return HealthFinding(
        "ok", "rclpy", f"imports, with messages ({std_msgs.msg.__package__}); RMW {identifier}"
    )


def check_route(rclpy_folder: Path, system: str) -> HealthFinding:
    """Report the origin of a ROS installation that isn't from the wheels, and its differences from the wheels.

    `system` is a value of `platform.system()`.
    """
    is_conda = any((parent / "conda-meta").is_dir() for parent in rclpy_folder.parents)
    source = "RoboStack's conda packages" if is_conda else f"the packages in {rclpy_folder.parent}"
    differs = [
        "The lock file isn't used, so versions differ from ours.",
        "A value of the wrong type in a message field may end the whole process, but our wheels send 0.0 instead.",
    ]
    if system != "Linux":
        differs.append(
            f"On {system}, lessons run, but %check and grading don't: they need Linux's /proc and abstract sockets."
        )
    differs.append("`environment.md` describes this route.")
    return HealthFinding("note", "Route", f"ROS comes from {source}, not from the wheels", " ".join(differs))


def _route() -> HealthFinding:
    import rclpy

    return check_route(Path(rclpy.__file__).resolve().parent, platform.system())


def check_domain() -> HealthFinding:
    """Check that a domain can be leased and that a second lease of it is refused."""
    from workbook.ros.domains import lease_domain

    with lease_domain() as first, lease_domain(first.domain_id) as second:
        if first.domain_id == second.domain_id:
            return HealthFinding(
                "fix",
                "Domains",
                f"domain {first.domain_id} was leased twice",
                "Notebooks may receive each other's messages. See 'When something fails' in environment.md.",
            )
        return HealthFinding(
            "ok", "Domains", f"leased {first.domain_id} and {second.domain_id}, each held by one process"
        )


def check_loopback() -> HealthFinding:
    """Check that a UDP packet sent to 127.0.0.1 arrives."""
    with (
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as receiver,
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender,
    ):
        receiver.bind(("127.0.0.1", 0))
        receiver.settimeout(10.0)
        sender.sendto(b"ping", receiver.getsockname())
        try:
            receiver.recv(16)
        except TimeoutError:
            return HealthFinding(
                "fix",
                "Loopback",
                "a UDP packet to 127.0.0.1 did not arrive",
                "A firewall drops it, or the interface `lo` is down (`ip link set lo up`).",
            )
    return HealthFinding("ok", "Loopback", "UDP on 127.0.0.1 arrives")


def check_folders() -> HealthFinding:
    """Check that the home folder, the temporary folder, and shared memory are writable and have space left."""
    temporary = Path(tempfile.gettempdir())
    saw = []
    for name, folder, needed in (
        ("home", Path.home(), 0.1),
        ("temporary", temporary, 0.1),
        ("/dev/shm", None, 0.0),
    ):
        place = Path("/dev/shm") if folder is None else folder
        try:
            with tempfile.NamedTemporaryFile(dir=place):
                pass
        except OSError as error:
            if folder is None:
                saw.append("/dev/shm is not writable (the workbook doesn't need it)")
                continue
            todo = (
                "Set HOME to a folder that you own."
                if name == "home"
                else "Set TMPDIR to a folder that you own."
            )
            return HealthFinding(
                "fix", "Folders", f"{name} folder {place} cannot be written: {error.strerror}", todo
            )
        free = shutil.disk_usage(place).free / GIB
        if free < needed:
            return HealthFinding(
                "fix", "Folders", f"{name} folder {place} has {free * 1024:.0f} MB left", "Free some space."
            )
        saw.append(f"{name} {free:.1f} GB free")
    return HealthFinding("ok", "Folders", ", ".join(saw))


def check_two_processes() -> HealthFinding:
    """Check that this process receives messages that another process publishes."""
    record, took = _receive_ping()
    if took is not None:
        return HealthFinding(
            "ok", "Two processes", f"a node in another process was discovered after {took:.1f} s"
        )
    said = record.log.strip().splitlines()
    last = f" It said: {said[-1]}" if said else ""
    if record.ended_by == "itself":
        from workbook.lab.packages import install_again

        return HealthFinding(
            "fix",
            "Two processes",
            f"the other process ended by itself (exit {record.exit}).{last}",
            install_again(),
        )
    return HealthFinding(
        "fix",
        "Two processes",
        f"nothing was received from another process in {PING_LIMIT_S:.0f} s.{last}",
        "A firewall or VPN often filters multicast and UDP on 127.0.0.1. See 'When something fails' in environment.md.",
    )


def _receive_ping() -> "tuple[ProcessRecord, float | None]":
    """Start a publisher. Return its process record and the time (s) until its first message, or None without one."""
    import rclpy
    from rclpy.context import Context
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.signals import SignalHandlerOptions
    from std_msgs.msg import String

    from workbook.programs.process import NodeProcess
    from workbook.programs.spec import ProgramSpec
    from workbook.ros.domains import lease_domain

    pings: list[str] = []
    with lease_domain() as lease:
        context = Context()
        rclpy.init(context=context, domain_id=lease.domain_id, signal_handler_options=SignalHandlerOptions.NO)
        node = rclpy.create_node("doctor", context=context)
        executor = SingleThreadedExecutor(context=context)
        executor.add_node(node)

        def on_ping(message: String) -> None:
            pings.append(message.data)

        node.create_subscription(String, "/doctor/ping", on_ping, 10)
        program = NodeProcess(ProgramSpec(PING_PUBLISHER), lease.domain_id)
        try:
            while not pings and program.is_running() and time.monotonic() - program.started_at < PING_LIMIT_S:
                executor.spin_once(timeout_sec=0.05)
            took = time.monotonic() - program.started_at
        finally:
            program.stop()
            executor.shutdown()
            node.destroy_node()
            rclpy.shutdown(context=context)
            lease.release(killed=program.killed)
    return program.record(), took if pings else None


_CELL = "import os, rclpy"
_SAID = """\
f"domain {os.environ.get('ROS_DOMAIN_ID')} magics {'workbook.magics' in get_ipython().extension_manager.loaded}"
"""


def _start_kernel() -> tuple["KernelManager", "BlockingKernelClient"]:
    """Start a kernel, and try again if another program has taken one of its ports.

    jupyter_client chooses free ports, but the kernel opens them only about a second later, so another program may take
    them first. Raise RuntimeError with the last line of the kernel's output if the kernel doesn't start.
    """
    from jupyter_client import manager

    for tries_left in reversed(range(KERNEL_TRIES)):
        with tempfile.TemporaryFile() as errors:
            try:
                return manager.start_new_kernel(
                    startup_timeout=KERNEL_LIMIT_S, kernel_name="python3", stderr=errors
                )
            except RuntimeError as error:
                errors.seek(0)
                said = errors.read().decode(errors="replace").strip()
                if not tries_left or PORT_TAKEN not in said:
                    raise RuntimeError(f"{error}. {said.splitlines()[-1]}" if said else str(error)) from None
    raise AssertionError("unreachable")


def check_kernel() -> HealthFinding:
    """Check that a Jupyter kernel starts with a domain and the magics."""
    started = time.monotonic()
    manager, client = _start_kernel()
    try:
        # A client that has just connected may miss a cell's printed output, but it always receives the reply.
        reply = client.execute(
            _CELL, reply=True, timeout=KERNEL_LIMIT_S, user_expressions={"said": _SAID.strip()}
        )["content"]
        took = time.monotonic() - started
    finally:
        manager.shutdown_wait_time = KERNEL_LIMIT_S  # a killed kernel leaves its folders behind
        manager.shutdown_kernel()
        client.stop_channels()
    told = reply.get("user_expressions", {}).get("said", {})
    said = str(
        told.get("data", {}).get("text/plain") or told.get("evalue") or reply.get("evalue") or ""
    ).strip("'\"")
    if "domain None" in said or "magics True" not in said or "domain" not in said:
        from workbook.exercise.course import is_from_wheel

        todo = "Run `rclpy-workbook lab --only-copy`." if is_from_wheel() else "Run `make env`."
        return HealthFinding(
            "fix", "Jupyter kernel", f"starts, but is not set up: {said or 'no answer'}", todo
        )
    domain = said.split("domain ")[1].split()[0]
    return HealthFinding(
        "ok", "Jupyter kernel", f"starts in {took:.1f} s, with domain {domain} and the magics"
    )


def check_machine_size() -> HealthFinding:
    """Report the number of processors and the memory."""
    processors = len(os.sched_getaffinity(0))
    memory = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") / GIB
    saw = f"{processors} processor{'s' if processors != 1 else ''}, {memory:.1f} GB of memory"
    if processors < 2 or memory < 1.8:
        return HealthFinding(
            "note", "Machine", saw, "Lessons work, but slowly. Two processors and 2 GB are recommended."
        )
    return HealthFinding("ok", "Machine", saw)


def chromium() -> str | None:
    """Return the path of the Chromium that the browser tests use, or None if no Chromium is installed."""
    for name in (
        "chromium-headless-shell",
        "chromium",
        "chromium-browser",
        "google-chrome",
        "google-chrome-stable",
    ):
        if found := shutil.which(name):
            return found
    return None


def check_chromium() -> HealthFinding:
    """Check for the browser that the tests use. Only authors need it."""
    found = chromium()
    if found:
        return HealthFinding("ok", "Chromium", found)
    return HealthFinding(
        "note", "Chromium", "not found", "Only the browser tests of `make test` need it (apt: chromium)."
    )


def check_sandbox() -> HealthFinding:
    """Check how well this machine can isolate untrusted programs. Only instructors need isolation."""
    from workbook.grading.tier_check import best_below_sandbox, tier_problem
    from workbook.isolation.memory_groups import groups_in_words
    from workbook.isolation.tiers import covers, leaves_open, unfiltered

    problem = tier_problem("sandbox")
    if problem is None:
        saw = f"sandbox: bubblewrap isolates a program. {groups_in_words()}"
        if calls := unfiltered("sandbox"):
            return HealthFinding(
                "note", "Isolation", f"{saw} {calls}", "Grade other people's answers elsewhere."
            )
        return HealthFinding("ok", "Isolation", saw)
    best = best_below_sandbox()
    return HealthFinding(
        "note",
        "Isolation",
        f"no sandbox: {problem}. The best that works here is {best}: {covers(best)}. {leaves_open(best)} "
        f"{groups_in_words()}",
        "Only grading other people's answers needs it (apt: bubblewrap).",
    )


def examine(environ: Mapping[str, str] | None = None) -> Iterator[HealthFinding]:
    """Run all checks and yield their findings. Set up this process for ROS before the first check that needs it."""
    found = leftovers(os.environ if environ is None else environ)
    from workbook.lab.packages import check_packages

    yield from _made("Python", check_python)
    yield from _made("Packages", check_packages)
    yield from _made("Shell", lambda: check_leftovers(found))
    yield from _made("Machine", check_machine_size)
    yield from _made("Folders", check_folders)
    yield from _made("Loopback", check_loopback)
    yield from _made("Domains", check_domain)
    from workbook.ros.environment import prepare

    with suppress(Exception):  # the checks that follow report any failure
        prepare()
    from workbook.ros.environment import uses_wheels

    if not uses_wheels():
        yield from _made("Route", _route)
    for title, check in (
        ("rclpy", check_rclpy),
        ("Two processes", check_two_processes),
        ("Jupyter kernel", check_kernel),
        ("Chromium", check_chromium),
        ("Isolation", check_sandbox),
    ):
        yield from _made(title, check)


def _made(title: str, check: Callable[[], HealthFinding]) -> Iterable[HealthFinding]:
    try:
        return [check()]
    except Exception as error:
        from workbook.lab.packages import install_again

        text = str(error).strip() or "no further text"
        return [
            HealthFinding(
                "fix",
                title,
                f"{type(error).__name__}: {text.splitlines()[0]}",
                f"{install_again()} If the problem remains, see 'When something fails' in environment.md.",
            )
        ]

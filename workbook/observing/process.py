"""Starting a program as its own process, keeping its log bounded, and ending all of it."""

import codecs
import contextlib
import os
import re
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from workbook.observing.confinement import Confinement
from workbook.observing.recording import ProcessRecord
from workbook.observing.sandbox import ANSWER_FOLDER, HOME, Cage, exit_status, first_pid, program_pid
from workbook.observing.tree import process_tree, read_proc
from workbook.observing.usage import limits_told, memory_of, most_files
from workbook.observing.warm_start import RUN_MARK, ForkServer, NoWarmStart, WarmProgram, own_server
from workbook.ros.domains import domain_of_port
from workbook.ros.environment import child_environment, profile_with_lease
from workbook.ros.scratch import remove_scratch, scratch_folder

HOST = Path(__file__).with_name("host.py")
LOG_KEPT_BYTES = 8_000
LOG_LIMIT_BYTES = 50_000_000
PROFILE = "profile.xml"
TURN_S = 0.05
COUNT_EVERY_S = 0.05
BOX_GOES_S = 2.0
_CONTROL = re.compile(
    r"\x1b\[[0-?]*[ -/]*[@-~]|\x1b\][^\x07\x1b]*(?:\x07|\x1b\\)|[\x00-\x08\x0b-\x1f\x7f-\x9f]"
    r"|[\u200e\u200f\u202a-\u202e\u2066-\u2069]"
)


def plain_text(raw: bytes) -> str:
    """Text that no terminal, page or file can take for a command: no escapes, no control characters.

    Marks that turn the direction of writing go, too: they can make a line read as something that it is not.
    """
    return without_commands(codecs.decode(raw, "utf-8", "replace").replace("\r\n", "\n"))


def without_commands(text: str) -> str:
    """The same text, with everything taken out that a terminal or a reader's eye could take for a command."""
    return _CONTROL.sub("", text)


def ros_arguments(parameters: Mapping[str, object]) -> list[str]:
    """Command-line arguments that set ROS parameters for every node of a program; none for no parameters."""
    if not parameters:
        return []
    arguments = ["--ros-args"]
    for name, value in parameters.items():
        text = str(value).lower() if isinstance(value, bool) else str(value)
        arguments += ["-p", f"{name}:={text}"]
    return arguments


class ProgramLog:
    """Reads what a program prints; keeps the first and the last part, and tells when there was far too much."""

    def __init__(self, stream_fd: int, on_flood: Callable[[], None]) -> None:
        self._fd = stream_fd
        self._on_flood = on_flood
        self._head = bytearray()
        self._tail = bytearray()
        self._seen = 0
        self.flooded = False
        self._thread = threading.Thread(target=self._read, name="program log", daemon=True)
        self._thread.start()

    def _read(self) -> None:
        half = LOG_KEPT_BYTES // 2
        try:
            while chunk := os.read(self._fd, 65536):
                self._seen += len(chunk)
                room = half - len(self._head)
                if room > 0:
                    self._head += chunk[:room]
                    chunk = chunk[room:]
                self._tail += chunk
                del self._tail[:-half]
                if self._seen > LOG_LIMIT_BYTES and not self.flooded:
                    self.flooded = True
                    self._on_flood()
        except OSError:
            pass
        finally:
            os.close(self._fd)

    def finish(self, timeout_s: float) -> None:
        self._thread.join(timeout_s)

    @property
    def truncated(self) -> bool:
        return self._seen > LOG_KEPT_BYTES

    def text(self) -> str:
        head, tail = bytes(self._head), bytes(self._tail)
        if self._seen <= len(head) + len(tail):
            return plain_text(head + tail)
        left_out = self._seen - len(head) - len(tail)
        return f"{plain_text(head)}\n… {left_out} bytes left out …\n{plain_text(tail)}"


def processes_marked(mark: str) -> list[int]:
    """Processes (of this user) whose `WORKBOOK_RUN` begins with `mark`, whatever session they moved to."""
    needle = f"{RUN_MARK}={mark}".encode()
    found = []
    for entry in os.listdir("/proc"):
        if not entry.isdigit() or int(entry) == os.getpid():
            continue
        try:
            environ = Path(f"/proc/{entry}/environ").read_bytes()
        except OSError:
            continue
        if any(variable.startswith(needle) for variable in environ.split(b"\0")):
            found.append(int(entry))
    return found


def kill_programs_of(bench_pid: int) -> None:
    """Kill what the dead process `bench_pid` had started as a `NodeProcess`, and all that came of it."""
    for _ in range(20):
        left = processes_marked(f"{bench_pid}-")
        if not left:
            return
        for pid in left:
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        time.sleep(0.005)


def processor_seconds(pids: Sequence[int]) -> float | None:
    """Processor time (s) that these processes have used; None when none of them is there any more."""
    used = [
        sum(int(field) for field in stat.rsplit(")", 1)[1].split()[11:13])
        for stat in (_stat(pid) for pid in pids)
        if stat is not None
    ]
    return sum(used) / os.sysconf("SC_CLK_TCK") if used else None


def _stat(pid: int) -> str | None:
    try:
        return read_proc(f"/proc/{pid}/stat").decode(errors="replace")
    except OSError:
        return None


def domains_of(pids: Sequence[int]) -> tuple[int, ...]:
    """ROS domains on which these processes have DDS ports open."""
    inodes: set[str] = set()
    for pid in pids:
        try:
            links = [os.readlink(f"/proc/{pid}/fd/{fd}") for fd in os.listdir(f"/proc/{pid}/fd")]
        except OSError:
            continue
        inodes |= {link[8:-1] for link in links if link.startswith("socket:[")}
    ports: set[int] = set()
    for line in Path("/proc/net/udp").read_text().splitlines()[1:]:
        fields = line.split()
        if fields[9] in inodes:
            ports.add(int(fields[1].rsplit(":", 1)[1], 16))
    return domains_of_ports(ports)


def domains_of_ports(ports: Collection[int]) -> tuple[int, ...]:
    """ROS domains whose participants listen on these UDP ports.

    A participant has two: discovery on an even offset from 10 on, messages on the next. A single port is
    the one it sends from, which the system chose.
    """
    found = {
        domain_of_port(port)
        for port in ports
        if (port - 7400) % 250 >= 10 and (port - 7400) % 250 % 2 == 0 and port + 1 in ports
    }
    return tuple(sorted(domain_id for domain_id in found if domain_id is not None))


def _place(name: str, files: Mapping[str, Path], cage: Cage | None) -> str:
    """Where a program finds one of its files: in its cage, or on the machine."""
    return str(files[name]) if cage is None else f"{ANSWER_FOLDER}/{name}"


@dataclass(frozen=True)
class _Order:
    """A program to start: what the host is told, its files by name, its environment, and where its output goes."""

    wanted: Sequence[str]
    files: Mapping[str, Path]
    environ: Mapping[str, str]
    output_fd: int


class NodeProcess:
    """A program that runs as its own process, in its own session, and whose whole tree ends with `stop`.

    `program` is a Python file; it runs as `__main__` with `arguments`. With a `driver`, that one runs as `__main__` and
    can import the program as the module `answer`. With `lease_s`, others remember it for so many seconds if it
    vanishes without a good-bye (usually two). With a `cage` all of it is shut in, with a `confinement` kept in as that
    one can. Use as a context manager, or call `stop`.
    """

    def __init__(
        self,
        program: Path,
        domain_id: int,
        arguments: Sequence[str] = (),
        *,
        check_fields: bool = False,
        limits: Mapping[str, int] | None = None,
        driver: Path | None = None,
        lease_s: int | None = None,
        cage: Cage | None = None,
        confinement: Confinement | None = None,
    ) -> None:
        if not program.is_file():
            raise FileNotFoundError(f"there is no program {program}")
        self.program = program
        self.domain_id = domain_id
        self._folder = scratch_folder("run")
        self._confinement = confinement or Confinement()
        self._shelf = scratch_folder("shelf") if self._confinement.shuts_in else self._folder
        self._mark = f"{os.getpid()}-{self._folder.name}."
        self._limits_hit: list[str] = []
        self._ended_at: float | None = None
        self._ended_by_bench = False
        self._log_before_end: str | None = None
        self._domains_used: tuple[int, ...] = ()
        self._processor: list[tuple[float, float]] = []
        self.killed = False
        wanted = ["--fence"] if cage is not None else []
        self._limits = limits = dict(limits or {})
        for name, value in (limits if cage else self._confinement.host_limits(limits)).items():
            if name != "files":  # the kernel has no such limit
                wanted += ["--limit", f"{name}={value}"]
        files = {program.name: self._confinement.bring(program, program.name, self._shelf)}
        if driver is not None:
            name = f"driver_of_{driver.name}"
            files[name] = self._confinement.bring(driver, name, self._shelf)
            wanted += ["--driver", _place(name, files, cage)]
        wanted += [_place(program.name, files, cage), *arguments]
        environ = child_environment(domain_id, check_fields=check_fields, log_folder=self._folder)
        environ[RUN_MARK] = self._mark
        if lease_s is not None:
            files[PROFILE] = profile_with_lease(self._folder, lease_s)
            environ["FASTRTPS_DEFAULT_PROFILES_FILE"] = _place(PROFILE, files, cage)
        read_fd, write_fd = os.pipe()
        self._caged = cage is not None
        self._info_fd = os.memfd_create("what the cage says of itself")
        self._box: subprocess.Popen[bytes] | None = None
        self.started_at = time.monotonic()
        try:
            order = _Order(wanted, files, environ, write_fd)
            self._process = self._start_warm(cage, order) or self._start_fresh(cage, order)
        except OSError:
            os.close(read_fd)
            os.close(self._info_fd)
            self._remove_folders()
            raise
        finally:
            os.close(write_fd)
        self.log = ProgramLog(read_fd, self._stop_flood)
        if "processes" in limits:
            guard = threading.Thread(
                target=self._guard, args=(dict(limits),), name="process guard", daemon=True
            )
            guard.start()

    def _start_fresh(self, cage: Cage | None, order: _Order) -> subprocess.Popen[bytes]:
        environ = order.environ
        if cage is not None:
            command = [sys.executable, "-P", str(HOST), "--attended", *order.wanted]
            command = cage.command(command, order.files, order.environ, self._info_fd)
        else:  # a cage dies with us by itself, and its processes do not know our number
            command = [sys.executable, "-P", str(HOST), "--parent", str(os.getpid()), *order.wanted]
            command, environ = self._confinement.enter(
                command, order.environ, self._limits, shelf=self._shelf, scratch=self._folder
            )
        return self._popen(command, environ, order.output_fd, order.output_fd)

    def _start_warm(self, cage: Cage | None, order: _Order) -> WarmProgram | None:
        """Fork the program from a Python that has loaded what programs need. None if that does not work here."""
        if cage is not None and cage.server is not None:
            return self._start_in_box(cage, cage.server, order)
        server = None if cage is not None or self._confinement.shuts_in else own_server.ready()
        if server is None:
            return None
        self.started_at = time.monotonic()  # not before: to wait for the server is no part of its life
        try:
            return server.spawn(0, order.wanted, order.environ, str(self._folder), order.output_fd)
        except NoWarmStart:
            return None

    def _start_in_box(self, cage: Cage, server: ForkServer, order: _Order) -> WarmProgram | None:
        """Make an empty box and fork the program into it. None if that does not work here."""
        environ = cage.environment(order.environ)
        server.start(environ)
        ready_fd, said_fd = os.pipe()
        try:
            self._box = self._popen(
                cage.empty_box(order.files, self._info_fd), order.environ, said_fd, order.output_fd
            )
        finally:
            os.close(said_fd)
        with os.fdopen(ready_fd, "rb") as ready:
            ready.readline()
        first = first_pid(self._info())
        try:
            if first is None:
                raise NoWarmStart("there is no box")
            return server.spawn(first, order.wanted, environ, HOME, order.output_fd)
        except NoWarmStart:
            self._box.kill()
            self._box.wait()
            self._box = None
            os.ftruncate(self._info_fd, 0)
            os.lseek(self._info_fd, 0, os.SEEK_SET)
            return None

    def _popen(
        self, command: Sequence[str], environ: Mapping[str, str], output_fd: int, error_fd: int
    ) -> subprocess.Popen[bytes]:
        return subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL,
            stdout=output_fd,
            stderr=error_fd,
            env=environ,
            cwd=self._folder,
            start_new_session=True,
            pass_fds=[self._info_fd] if self._caged else [],
        )

    def _info(self) -> str:
        return os.pread(self._info_fd, 4096, 0).decode()

    def _tree(self) -> list[int]:
        """The program and all that came of it; for one that is shut in, its box as well."""
        box = [] if self._box is None else process_tree(self._box.pid)
        return [*process_tree(self.pid), *box]

    def _close_info(self) -> None:
        if self._info_fd >= 0:
            os.close(self._info_fd)
            self._info_fd = -1

    def _remove_folders(self) -> None:
        remove_scratch(self._folder)
        remove_scratch(self._shelf)

    def _stop_flood(self) -> None:
        self._limits_hit.append("output")
        self._kill_tree()

    def _guard(self, limits: Mapping[str, int]) -> None:
        """End a program that takes too much. The kernel's own limits hold for single processes, and not for root's."""
        while self.is_running():
            hit = self._exceeded(limits)
            if hit is not None:
                self._limits_hit.append(hit)
                self._kill_tree()
                return
            time.sleep(COUNT_EVERY_S)

    def _exceeded(self, limits: Mapping[str, int]) -> str | None:
        tree = self._tree()
        if len(tree) > limits["processes"]:
            return "processes"
        if "memory" in limits and memory_of(tree, limits["memory"]) > limits["memory"]:
            return "memory"
        if "files" in limits and most_files(tree) > limits["files"]:
            return "files"
        return None

    @property
    def pid(self) -> int:
        return self._process.pid

    def is_running(self) -> bool:
        if self._process.poll() is None:
            return True
        if self._ended_at is None:
            self._ended_at = time.monotonic()
        return False

    def wait(self, timeout_s: float) -> bool:
        """Wait for the program to end by itself. Returns whether it has."""
        try:
            self._process.wait(timeout_s)
        except subprocess.TimeoutExpired:
            return False
        return not self.is_running()

    def interrupt(self) -> None:
        """Send SIGINT, what Ctrl-C sends."""
        if not self.is_running():
            return
        if not self._caged or self._box is not None:
            self._process.send_signal(signal.SIGINT)
            return
        pid = program_pid(self._info())
        if pid is not None:
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGINT)

    def domains_used(self) -> tuple[int, ...]:
        """ROS domains on which the program (or a child of it) has sockets at this moment."""
        if self.is_running():
            used = domains_of(self._tree())
            self._domains_used = tuple(sorted({*self._domains_used, *used}))
        return self._domains_used

    def processor_seconds(self) -> float | None:
        """Processor time (s) of the program and all that it has started; None when it has ended."""
        return processor_seconds(self._tree()) if self.is_running() else None

    def note_processor_time(self) -> None:
        """Note for the record how much processor time the program has used up to now."""
        used = self.processor_seconds()
        if used is not None:
            self._processor.append((round(time.monotonic() - self.started_at, 4), round(used, 3)))

    def _kill_tree(self) -> None:
        for _ in range(20):
            alive = {*self._tree(), *processes_marked(self._mark)}
            if self._process.poll() is not None:
                alive.discard(self.pid)
            if self._box is not None and self._box.poll() is not None:
                alive.discard(self._box.pid)
            if not alive:
                return
            for pid in alive:
                try:
                    os.kill(pid, signal.SIGKILL)
                except ProcessLookupError:
                    pass
            time.sleep(0.005)

    def stop(self, patience_s: float = 2.0, meanwhile: Callable[[], object] = lambda: None) -> None:
        """End the program: SIGINT, wait up to `patience_s`, then SIGKILL to everything it started.

        `meanwhile` is called again and again while it waits. SIGTERM is not used: this rclpy loses some of them
        while it spins.
        """
        if self.is_running():
            self._ended_by_bench = True
            self._log_before_end = self.log.text()
            self.interrupt()
            deadline = time.monotonic() + patience_s
            while not self.wait(max(0.0, min(TURN_S, deadline - time.monotonic()))):
                if time.monotonic() >= deadline:
                    self.killed = True
                    break
                meanwhile()
        if self._box is not None and not self.killed:  # it goes with the program
            with contextlib.suppress(subprocess.TimeoutExpired):
                self._box.wait(BOX_GOES_S)
        if self.killed or processes_marked(self._mark):
            self.killed = True
            self._kill_tree()
            self._process.wait()
            self.is_running()
        if self._box is not None:
            self._box.wait()
        if isinstance(self._process, WarmProgram):
            self._process.close()
        if self._confinement.sweep():
            self.killed = True
        self.log.finish(1.0)
        self._close_info()
        self._remove_folders()

    def record(self) -> ProcessRecord:
        """What the process did so far."""
        code = None if self.is_running() else self._process.returncode
        if code is not None and self._caged and self._box is None:
            code = exit_status(code)
        ended_at = None if self._ended_at is None else self._ended_at - self.started_at
        limits = [*self._limits_hit]
        by_bench = self._ended_by_bench or bool(limits)
        log = end_log = self.log.text()
        if code is not None and -code == signal.SIGXCPU:
            limits.append("cpu")
        elif code and not by_bench:
            limits += limits_told(log)
        if self._log_before_end is None:
            end_log = ""
        else:
            log, end_log = self._log_before_end, end_log.removeprefix(self._log_before_end)
        return ProcessRecord(
            program=self.program.name,
            exit=code if code is not None and code >= 0 else None,
            signal=signal.Signals(-code).name if code is not None and code < 0 else None,
            ended_at=ended_at,
            ended_by=None if code is None else ("bench" if by_bench else "itself"),
            watched_for=(ended_at if ended_at is not None else time.monotonic() - self.started_at),
            limits_hit=tuple(limits),
            log=log,
            end_log=end_log,
            log_truncated=self.log.truncated,
            domains_used=self._domains_used,
            processor=tuple(self._processor),
        )

    def __enter__(self) -> "NodeProcess":
        return self

    def __exit__(self, *_: object) -> None:
        self.stop()

"""Run a program in its own process: start it, limit it, stop it, and record what happened."""

import os
import signal
import subprocess
import threading
import time
from collections.abc import Callable
from pathlib import Path

from workbook.inside import proc
from workbook.programs.domains_used import domains_of
from workbook.programs.ending import RUN_MARK, kill_all, processes_marked
from workbook.programs.log import ProgramLog
from workbook.programs.spec import ProgramSpec
from workbook.programs.tier import Confinement, Order, Tier
from workbook.programs.unconfined import Unconfined
from workbook.programs.usage import limit_exceeded, limits_in_log, until_next_look_s
from workbook.recording.recording import ProcessRecord
from workbook.ros.environment import child_environment
from workbook.ros.scratch import remove_scratch, scratch_folder

PROFILE = "FASTRTPS_DEFAULT_PROFILES_FILE"
POLL_S = 0.05
SANDBOX_END_S = 2.0


def _pipe_with(data: bytes) -> int:
    """Return the read end of a pipe that contains `data` and has no writer."""
    read_fd, write_fd = os.pipe()
    os.write(write_fd, data)
    os.close(write_fd)
    return read_fd


class NodeProcess:
    """A program that runs in its own process and session. `stop` stops the program and all its descendants.

    `tier`: its isolation tier, or None for no isolation. `write_profile`: a function that writes a DDS profile for the
    program into a folder and returns the profile's path. If it's None, the program uses the profile that all our
    processes use. Use a NodeProcess as a context manager, or call `stop`. Raises FileNotFoundError if the program
    doesn't exist, and OSError if it can't be started.
    """

    def __init__(
        self,
        spec: ProgramSpec,
        domain_id: int,
        tier: Tier | None = None,
        *,
        write_profile: Callable[[Path], Path] | None = None,
    ) -> None:
        if not spec.file.is_file():
            raise FileNotFoundError(f"there is no program {spec.file}")
        self.spec = spec
        self.domain_id = domain_id
        self.killed = False
        self._folder = scratch_folder("run")
        self._confinement = (tier or Unconfined()).confine(self._folder)
        self._mark = f"{os.getpid()}-{self._folder.name}."
        self._limits_hit: list[str] = []
        self._ended_at: float | None = None
        self._ended_by_judge = False
        self._log_before_end: str | None = None
        self._printed_before_end: float | None = None
        self._domains_used: tuple[int, ...] = ()
        self._processor: list[tuple[float, float]] = []
        read_fd, write_fd = os.pipe()
        input_fd = _pipe_with(spec.driver_key) if spec.driver is not None and spec.driver_key else None
        try:
            started = self._confinement.start(self._order(write_fd, input_fd, write_profile))
        except OSError:
            os.close(read_fd)
            self._remove_files()
            raise
        finally:
            os.close(write_fd)
            if input_fd is not None:
                os.close(input_fd)
        self._child, self.started_at = started.child, started.at
        self.log = ProgramLog(read_fd, spec.limits.output, self._stop_flood)
        if spec.limits.processes is not None:
            threading.Thread(target=self._guard, name="process guard", daemon=True).start()

    def _order(
        self, output_fd: int, input_fd: int | None, write_profile: Callable[[Path], Path] | None
    ) -> Order:
        """Make the program's files available in its confinement, and return the `Order` for starting the program."""
        spec, confinement = self.spec, self._confinement
        arguments = confinement.host_options(spec.limits)
        if spec.in_panel:
            arguments += ["--tap", str(self.domain_id)]
        program = confinement.bring(spec.file, spec.file.name)
        if spec.driver is not None:
            arguments += ["--driver", confinement.bring(spec.driver, f"driver_of_{spec.driver.name}")]
        environ = child_environment(self.domain_id, check_fields=spec.check_fields, log_folder=self._folder)
        environ[RUN_MARK] = self._mark
        if write_profile is not None:
            environ[PROFILE] = confinement.bring(write_profile(self._folder), "profile.xml")
        command = [*arguments, program, *spec.command_line]
        return Order(command, environ, spec.limits, output_fd, input_fd=input_fd)

    def _remove_files(self) -> None:
        self._confinement.remove()
        remove_scratch(self._folder)

    def _stop_flood(self) -> None:
        self._limits_hit.append("output")
        self._kill_tree()

    def _guard(self) -> None:
        """Poll the program, and kill it if it exceeds its limits.

        The kernel's own limits apply to single processes, not to a program's processes together, and some don't apply
        to root.
        """
        while self.is_running():
            pids = self._child.tree()
            hit = limit_exceeded(self.spec.limits, pids, self._confinement)
            if hit is not None:
                self._limits_hit.append(hit)
                self._kill_tree()
                return
            time.sleep(until_next_look_s(self.spec.limits, pids))

    @property
    def confinement(self) -> Confinement:
        """The confinement in which this program runs."""
        return self._confinement

    @property
    def pid(self) -> int:
        """The ID of the process on this machine whose process tree contains the program."""
        return self._child.pid

    def is_running(self) -> bool:
        """Return whether the program is still running."""
        if self._child.poll() is None:
            return True
        if self._ended_at is None:
            self._ended_at = time.monotonic()
        return False

    def wait(self, timeout_s: float) -> bool:
        """Wait up to `timeout_s` seconds for the program to exit by itself. Return whether it has exited."""
        try:
            self._child.wait(timeout_s)
        except subprocess.TimeoutExpired:
            return False
        return not self.is_running()

    def interrupt(self) -> None:
        """Send SIGINT, like Ctrl-C."""
        if self.is_running():
            self._child.interrupt()

    def domains_used(self) -> tuple[int, ...]:
        """Return the ROS domains that the program or its descendants use, or used during an earlier call.

        A domain counts as used if one of its DDS ports is open.
        """
        if self.is_running():
            used = domains_of(self._child.tree())
            self._domains_used = tuple(sorted({*self._domains_used, *used}))
        return self._domains_used

    def processor_seconds(self) -> float | None:
        """Return the CPU time, in seconds, of the program and its descendants, or None if the program has exited."""
        return proc.processor_seconds(self._child.tree()) if self.is_running() else None

    def note_processor_time(self) -> None:
        """Record the CPU time that the program has used so far, with the current time."""
        used = self.processor_seconds()
        if used is not None:
            self._processor.append((round(time.monotonic() - self.started_at, 4), round(used, 3)))

    def _kill_tree(self) -> None:
        kill_all(lambda: {*self._child.tree(), *processes_marked(self._mark)})

    def stop(self, patience_s: float = 2.0, meanwhile: Callable[[], object] = lambda: None) -> None:
        """Stop the program: send SIGINT, wait up to `patience_s` seconds, and kill all remaining processes.

        `meanwhile` is called repeatedly during the wait. SIGTERM isn't used, because this build's rclpy ignores some
        SIGTERM signals that arrive while it spins. Raises StillThere if the tier can't kill the processes that the
        program left behind.
        """
        if self.is_running():
            self._ended_by_judge = True
            self._log_before_end, self._printed_before_end = self.log.text(), self.log.printed_at
            self._child.interrupt()
            deadline = time.monotonic() + patience_s
            while not self.wait(max(0.0, min(POLL_S, deadline - time.monotonic()))):
                if time.monotonic() >= deadline:
                    self.killed = True
                    break
                meanwhile()
        # a sandbox is removed when its program exits, unless the process that would remove the sandbox was killed
        if not self.killed:
            try:
                self._child.wait_for_sandbox(SANDBOX_END_S)
            except subprocess.TimeoutExpired:
                self.killed = True
        if self.killed or processes_marked(self._mark):
            self.killed = True
            self._kill_tree()
            self._child.wait()
            self.is_running()
        self._child.wait_for_sandbox()
        self._child.close()
        if self._confinement.sweep():
            self.killed = True
        self.log.finish(1.0)
        self._remove_files()

    def record(self) -> ProcessRecord:
        """Return the record of the process so far."""
        code = None if self.is_running() else self._child.poll()
        ended_at = None if self._ended_at is None else self._ended_at - self.started_at
        limits = [*self._limits_hit]
        ended_by_kernel = self._confinement.exceeded()
        if not limits and ended_by_kernel is not None:
            limits.append(ended_by_kernel)
        by_judge = self._ended_by_judge or bool(limits)
        log = end_log = self.log.text()
        printed_at = self.log.printed_at
        if code is not None and -code == signal.SIGXCPU:
            limits.append("cpu")
        elif code and not by_judge:
            limits += limits_in_log(log)
        if self._log_before_end is None:
            end_log = ""
        else:
            log, end_log = self._log_before_end, end_log.removeprefix(self._log_before_end)
            printed_at = self._printed_before_end
        return ProcessRecord(
            program=self.spec.file.name,
            exit=code if code is not None and code >= 0 else None,
            signal=signal.Signals(-code).name if code is not None and code < 0 else None,
            ended_at=ended_at,
            ended_by=None if code is None else ("judge" if by_judge else "itself"),
            watched_for=(ended_at if ended_at is not None else time.monotonic() - self.started_at),
            limits_hit=tuple(limits),
            log=log,
            end_log=end_log,
            log_truncated=self.log.truncated,
            domains_used=self._domains_used,
            processor=tuple(self._processor),
            printed_at=None if printed_at is None else printed_at - self.started_at,
            driver_key="" if self.spec.driver is None else self.spec.driver_key.hex(),
            unfiltered=self._confinement.unfiltered(),
        )

    def __enter__(self) -> "NodeProcess":
        return self

    def __exit__(self, *_: object) -> None:
        self.stop()

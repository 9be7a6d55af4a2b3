"""Run robot programs next to the notebook: start them as processes, record their messages, and stop them."""

import atexit
import os
import time
from collections import Counter
from collections.abc import Mapping, Sequence
from contextlib import closing
from pathlib import Path
from types import ModuleType

from workbook.criteria.vocabulary.known_errors import shutdown_overtaken, without_executors_end
from workbook.inside.proc import processor_seconds as processor_seconds_of
from workbook.inside.proc import run_queue_s
from workbook.lesson.startup import node_names, wait_for_nodes, wait_until_gone, wait_until_it_serves
from workbook.programs.fork_client import own_server
from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.recording.plan import Plan
from workbook.recording.recording import Clock, ProcessRecord, Recording
from workbook.ros.scratch import remove_scratch, scratch_folder
from workbook.watching.observer import Observer
from workbook.watching.rest import RestDetector
from workbook.watching.watch import Watch

Program = ModuleType | Path | str
POLL_S = 0.02
AT_WORK_WITHIN_S = 30.0
"""The longest time (s) that a program may take to open its DDS ports on a busy machine."""
SETTLE_S = 1.0
"""The wait (s) after the ports are open. After this wait, imports and discovery are over, so only the work itself is
measured.
"""

own_server.keep()  # a lesson runs many programs
_started: dict[str, NodeProcess] = {}
_nodes: dict[str, list[str]] = {}


def program_file(program: Program) -> Path:
    """Return a program's file. `program` is a module, such as `lesson_nodes.status_monitor`, or a path."""
    if isinstance(program, ModuleType):
        if program.__file__ is None:
            raise ValueError(f"{program.__name__} has no file that could be run")
        return Path(program.__file__)
    return Path(program)


def start(program: Program, **parameters: object) -> str:
    """Start a program in its own process on this notebook's domain. Any earlier run of the program is stopped first.

    `parameters` are ROS parameters for its nodes, such as `period_s=0.5`. Return the nodes' names, separated by commas,
    once the program is spinning. `stop` stops the program. Raise RuntimeError with the program's log if it exits right
    away.
    """
    file = program_file(program)
    _end(file.stem)
    known = node_names()
    spec = ProgramSpec(file, parameters=parameters, in_panel=True)
    process = NodeProcess(spec, int(os.environ["ROS_DOMAIN_ID"]))
    _started[file.stem] = process
    nodes = _nodes[file.stem] = wait_for_nodes(process, known)
    if nodes:
        wait_until_it_serves(process, nodes[0])
    if not process.is_running():
        _end(file.stem)
        raise RuntimeError(f"{file.name} ended right away:\n{process.record().log.strip()}")
    return ", ".join(nodes)


def stop(program: Program | None = None) -> None:
    """Stop a program as Ctrl-C would. Without `program`, stop all programs that `start` started.

    Return when the nodes have left the graph, or after a second per program.
    """
    for name in [program_file(program).stem] if program is not None else list(_started):
        _end(name)


def still_running() -> list[str]:
    """Return the names of the programs launched by `start` that are still running."""
    return [name for name, process in _started.items() if process.is_running()]


def _end(name: str) -> ProcessRecord | None:
    process = _started.pop(name, None)
    if process is None:
        return None
    names = _nodes.pop(name, [])
    there = (
        Counter({one: number for one, number in node_names().items() if one in names}) if names else Counter()
    )
    process.stop()
    wait_until_gone(there)
    return process.record()


@atexit.register
def _stop_all() -> None:
    _nodes.clear()  # the notebook's own node, which queries the graph, is being destroyed as well
    stop()


def record(
    program: Program,
    periods: Mapping[str, float],
    seconds: float = 60.0,
    clock: Clock = "simulated",
    **parameters: object,
) -> Recording:
    """Run a program on its own domain and record its messages.

    `periods`: the topics to record, each with its expected period in seconds. `parameters` are ROS parameters for the
    program's nodes. `clock`: with "simulated", `seconds` are simulated time, which passes as fast as the program can
    follow; with "wall", they're real time.
    """
    if clock not in ("simulated", "wall"):
        raise ValueError(f'clock is "simulated" or "wall", not {clock!r}')
    if clock == "simulated":  # set from the start, so that even the first message is recorded
        parameters = {"use_sim_time": True, **parameters}
    plan = Plan(
        tuple(periods),
        min(periods.values()),
        max(periods.values()),
        simulated_seconds=seconds,
        wall_seconds=seconds,
    )
    with Observer() as observer:
        with Watch(observer, ProgramSpec(program_file(program), parameters=parameters), plan, clock) as watch:
            return watch.finish(watch.observe())


def processor_seconds(
    program: Program, seconds: float = 4.0, *, with_start: bool = True, **parameters: object
) -> float:
    """Run a program on its own domain for `seconds` of real time, and return the CPU time (s) that it uses.

    Without `with_start`, measurement starts a second after the program has opened its DDS ports. The result then
    includes the time that the program's first thread spends in the run queue. Without that time, the result would be
    too low on a busy machine. Raise RuntimeError if the program exits early.
    """
    spec = ProgramSpec(program_file(program), parameters=parameters)
    with Observer() as observer:
        with NodeProcess(spec, observer.domain_id) as process:
            before = 0.0
            if not with_start:
                _wait_until_at_work(process, observer.domain_id)
                before = (processor_seconds_of([process.pid]) or 0.0) + run_queue_s(process.pid)
            if process.wait(seconds):
                raise RuntimeError(f"the program ended early:\n{process.record().log}")
            used = processor_seconds_of([process.pid]) or 0.0
            if not with_start:
                used += run_queue_s(process.pid)
    return used - before


def _wait_until_at_work(process: NodeProcess, domain_id: int) -> None:
    deadline = time.monotonic() + AT_WORK_WITHIN_S
    while domain_id not in process.domains_used() and time.monotonic() < deadline:
        if process.wait(POLL_S):
            return
    process.wait(SETTLE_S)


def arrivals(recording: Recording, topic: str) -> list[float]:
    """Return the arrival times of the messages on `topic`, in seconds on the recording's clock."""
    return [arrival.t for arrival in recording.topic(topic).arrivals]


def values(recording: Recording, topic: str, field: str = "data") -> list[object]:
    """Return the value of `field` from each message on `topic`."""
    return [arrival.value[field] for arrival in recording.topic(topic).arrivals]


def run_program(
    program: Program,
    seconds: float = 30.0,
    arguments: Sequence[str] = (),
    interrupt_at: str | None = None,
    silence: float | None = None,
) -> ProcessRecord:
    """Run a program on its own domain with a time limit, and return its process record.

    `program`: a module, a path, or code as text. `seconds`: the time limit, so that the program can't hang the
    notebook. `arguments`: the program's command-line arguments. `interrupt_at`: once the program has printed this text
    and is waiting, it receives SIGINT, as from Ctrl-C. `silence`: after its first output, the program is stopped if it
    doesn't print anything for this many seconds. If rclpy itself disturbed the shutdown (see `shutdown_overtaken` and
    `without_executors_end`), the program runs once more.
    """
    code = program if isinstance(program, str) else program_file(program).read_text(encoding="utf-8")
    ended = _run_once(code, seconds, arguments, interrupt_at, silence)
    log = ended.log + ended.end_log
    if shutdown_overtaken(log) or without_executors_end(log) != log:
        ended = _run_once(code, seconds, arguments, interrupt_at, silence)
    return ended


def _run_once(
    code: str, seconds: float, arguments: Sequence[str], interrupt_at: str | None, silence: float | None
) -> ProcessRecord:
    folder = scratch_folder("program")
    file = folder / "program.py"
    file.write_text(code, encoding="utf-8")
    deadline = time.monotonic() + seconds
    try:
        with Observer() as observer, NodeProcess(ProgramSpec(file, arguments), observer.domain_id) as process:
            printed, printed_at = "", time.monotonic()
            while not process.wait(POLL_S) and time.monotonic() < deadline:
                if (log := process.log.text()) != printed:
                    printed, printed_at = log, time.monotonic()
                if interrupt_at is not None and interrupt_at in printed:
                    with closing(RestDetector(process.pid)) as rest:
                        rest.wait_until_quiet()  # a person never presses Ctrl-C while the program is still at work
                    process.interrupt()
                    interrupt_at = None
                if silence is not None and printed and time.monotonic() - printed_at > silence:
                    break
            process.stop()
            if process.killed:
                observer.move()
            return process.record()
    finally:
        remove_scratch(folder)

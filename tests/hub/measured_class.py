"""Measure how much memory a class takes and how long it waits for its cards. Each simulated student has a server."""

import os
import statistics
import tempfile
import time
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import psutil

from tests.hub.class_server import ClassServer, class_server
from tests.hub.simulated_student import SimulatedStudent
from workbook.grading.slots.service import ADDRESS

STARTED_AT_ONCE = 4
CELLS_READ = 9
TEN_PER_MINUTE_S = 6.0
RUSH_S = 60.0
LOOK_EVERY_S = 5.0
"""Adding up the memory of a class takes processor time that answers need as well."""
OWN_JUDGE = f"import os; os.environ.pop({ADDRESS!r}, None)"


@dataclass(frozen=True)
class Checks:
    """How long each check took (s), and how many right answers didn't get full marks."""

    took: list[float]
    refused: int


@dataclass(frozen=True)
class MeasuredClass:
    """Memory per student (MB), and waiting times (s).

    `idle`: a server without a kernel. `reading`: with a kernel that has run part of a lesson. `checking`: the most
    that one student had while kernels judged their own answers. `starts`: from the click to a server that answers.
    `checks`: for each way to check, from `%check` to its card. `free`: memory (MB) that was left at the worst moment.
    """

    idle: float
    reading: float
    checking: float
    starts: list[float]
    checks: dict[str, Checks]
    free: float


def measure(students: int, stem: str, answer: str) -> MeasuredClass:
    """Have students log in, read, and check a right answer: with the check service, and then each with an own judge."""
    slots = len(os.sched_getaffinity(0))
    with (
        tempfile.TemporaryDirectory() as folder,
        class_server(Path(folder) / "class", check_slots=slots) as server,
    ):
        class_ = [server.student(f"student{number}") for number in range(students)]
        with ThreadPoolExecutor(STARTED_AT_ONCE) as few:
            starts = [*few.map(lambda one: seconds(one.start_server), class_)]
            idle = statistics.median(megabytes(server, class_))
            kernels = dict(zip(class_, few.map(SimulatedStudent.start_kernel, class_), strict=True))
            [*few.map(lambda one: read(one, kernels[one], stem), class_)]
        reading = statistics.median(megabytes(server, class_))
        free = [psutil.virtual_memory().available]

        def check(student: SimulatedStudent, after_s: float) -> tuple[float, bool]:
            with student.connected(kernels[student]) as kernel:
                time.sleep(after_s)
                began = time.monotonic()
                passed = "Full marks" in kernel.run("%check").shown
                return time.monotonic() - began, passed

        def run_in_each(cell: str) -> None:
            for student in class_:
                with student.connected(kernels[student]) as kernel:
                    kernel.run(cell)

        checks: dict[str, Checks] = {}
        checking = reading

        def all_check(name: str, apart_s: float) -> None:
            nonlocal checking
            with ThreadPoolExecutor(students) as all_of_them:
                running = [
                    all_of_them.submit(check, one, apart_s * number) for number, one in enumerate(class_)
                ]
                while not all(one.done() for one in running):
                    free.append(psutil.virtual_memory().available)
                    checking = max(checking, *megabytes(server, class_))
                    time.sleep(LOOK_EVERY_S)
            results = [one.result() for one in running]
            checks[name] = Checks(
                [took for took, _ in results], [passed for _, passed in results].count(False)
            )

        run_in_each(f"%%answer {stem}\n{answer}")
        for judges in (f"{slots} shared slots", "own judges"):
            all_check(f"ten per minute, {judges}", TEN_PER_MINUTE_S)
            all_check(f"all within a minute, {judges}", RUSH_S / students)
            run_in_each(OWN_JUDGE)
        for student in class_:
            student.stop_server()
    return MeasuredClass(idle, reading, checking, starts, checks, min(free) / 1e6)


def seconds(work: Callable[[], object]) -> float:
    """Return how many seconds some work takes."""
    began = time.monotonic()
    work()
    return time.monotonic() - began


def read(student: SimulatedStudent, kernel: str, stem: str) -> None:
    """Run the first cells of a lesson."""
    cells = student.notebook(f"notebooks/{stem}.ipynb")["cells"]
    with student.connected(kernel) as connection:
        for cell in [one["source"] for one in cells if one["cell_type"] == "code"][:CELLS_READ]:
            connection.run(cell)


def megabytes(server: ClassServer, class_: Sequence[SimulatedStudent]) -> list[float]:
    """Return the memory (MB) of each student's processes and gate. Shared pages count proportionally."""
    processes = {one.pid: one for one in psutil.process_iter(["ppid", "uids"])}
    gates = {one.pid for one in server.gates()}
    families: dict[int, list[psutil.Process]] = {gate: [] for gate in gates}
    for one in processes.values():
        above = one.pid
        while above in processes and above not in gates:
            above = processes[above].info["ppid"]
        if above in gates:
            families[above].append(one)
    owned = {
        one.info["uids"].real: family for family in families.values() for one in family if one.info["uids"]
    }
    return [sum(map(share_of_memory, owned.get(server.user_id(one.name), []))) / 1e6 for one in class_]


def share_of_memory(process: psutil.Process) -> int:
    """Return a process's proportional share of memory in bytes, or 0 if the process has ended."""
    try:
        return int(process.memory_full_info().pss)
    except psutil.Error:
        return 0

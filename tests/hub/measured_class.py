"""Measure how much memory a class takes and how long it waits for its cards. Each simulated student has a server."""

import statistics
import tempfile
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import psutil

from tests.hub.class_server import ClassServer, class_server
from tests.hub.simulated_student import SimulatedStudent

STARTED_AT_ONCE = 4
CELLS_READ = 9
BETWEEN_CHECKS_S = 6.0
"""Ten checks per minute."""


@dataclass(frozen=True)
class MeasuredClass:
    """Memory per student (MB), and waiting times (s).

    `idle`: a server without a kernel. `reading`: with a kernel that has run a part of a lesson. `checking`: the largest
    amount for any student while answers were judged. `starts`: from the click until the server responds. `checks`: from
    `%check` to its card. `refused`: how many checks of a right answer didn't give full marks.
    """

    idle: float
    reading: float
    checking: float
    starts: list[float]
    checks: list[float]
    refused: int


def measure(students: int, stem: str, answer: str) -> MeasuredClass:
    """Let `students` students log in, read, and check a right answer, one every few seconds."""
    with tempfile.TemporaryDirectory() as folder, class_server(Path(folder) / "class") as server:
        class_ = [server.student(f"student{number}") for number in range(students)]
        with ThreadPoolExecutor(STARTED_AT_ONCE) as few:
            starts = [*few.map(lambda one: seconds(one.start_server), class_)]
            idle = statistics.median(megabytes(server, one) for one in class_)
            kernels = dict(zip(class_, few.map(SimulatedStudent.start_kernel, class_), strict=True))
            [*few.map(lambda one: read(one, kernels[one], stem), class_)]
        reading = statistics.median(megabytes(server, one) for one in class_)

        def check(number: int, student: SimulatedStudent) -> tuple[float, bool]:
            with student.connected(kernels[student]) as kernel:
                kernel.run(f"%%answer {stem}\n{answer}")
                time.sleep(number * BETWEEN_CHECKS_S)
                began = time.monotonic()
                passed = "Full marks" in kernel.run("%check").shown
                return time.monotonic() - began, passed

        with ThreadPoolExecutor(students) as all_of_them:
            running = [all_of_them.submit(check, *one) for one in enumerate(class_)]
            checking = reading
            while not all(one.done() for one in running):
                checking = max(checking, *(megabytes(server, one) for one in class_))
                time.sleep(1.0)
        results = [one.result() for one in running]
        for student in class_:
            student.stop_server()
    checks, passed = [one for one, _ in results], [one for _, one in results]
    return MeasuredClass(idle, reading, checking, starts, checks, passed.count(False))


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


def megabytes(server: ClassServer, student: SimulatedStudent) -> float:
    """Return the memory (MB) of a student's processes and of the gate. Shared pages count proportionally."""
    total = 0
    own = server.user_id(student.name)
    for gate in server.gates():
        family = [gate, *gate.children(recursive=True)]
        if own in {user_of(one) for one in family}:
            total += sum(map(share_of_memory, family))
    return total / 1e6


def user_of(process: psutil.Process) -> int:
    """Return a process's user id, or -1 if the process has ended."""
    try:
        return int(process.uids().real)
    except psutil.Error:
        return -1


def share_of_memory(process: psutil.Process) -> int:
    """Return a process's proportional share of memory in bytes, or 0 if the process has ended."""
    try:
        return int(process.memory_full_info().pss)
    except psutil.Error:
        return 0

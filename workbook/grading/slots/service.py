"""Run a service that judges the answers of a whole class, a fixed number of them at a time. Students take turns.

    python -m workbook.grading.slots.service FOLDER --slots N

The service judges answers on slots, which are processes. When only the real-time watch of a program remains, the
student already has the feedback, so the service starts judging the next answer.

The service listens on the Unix socket FOLDER/socket. Each client connects, sends one `JudgingOrder`, and receives the
lines that a slot sends (see `protocol`) and its place in the queue. The service identifies the student by the connected
process's user ID, which it gets from the operating system's kernel.
"""

import argparse
import contextlib
import os
import select
import socket
import struct
import threading
import time
from collections import Counter, deque
from collections.abc import Callable, Hashable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Generic, TypeVar

from workbook.exercise.answers import Answer
from workbook.exercise.course import course_folder
from workbook.exercise.judgement import Judgement, Report
from workbook.exercise.source import stems
from workbook.grading.judges import Job
from workbook.grading.slots.client import ShowProgress
from workbook.grading.slots.pool import Kind, SlotPool
from workbook.grading.slots.protocol import (
    JudgingOrder,
    LineReader,
    Message,
    Progress,
    error_message,
    judgement_in,
    judgement_message,
    line_of,
    progress_message,
)
from workbook.grading.slots.scheduler import WAITING_PER_SLOT, Permit, WorkPermits, fits_in_memory
from workbook.isolation.tiers import Isolation, named_tier

ADDRESS = "WORKBOOK_CHECK_SERVICE"
"""The environment variable with the socket's path for a notebook's kernel.

If it isn't set, the kernel has its own slot.
"""
SOCKET = "socket"
LONGEST_ORDER = 1_000_000
"""The maximum size of an order, in bytes. An answer is a program that a person wrote, so it's short."""
LONGEST_SILENCE_S = 10.0
"""The longest time (s) that a client may take to send its order. Clients prepare the order before they connect."""
LOOK_S = 0.2
"""How often (s) a client checks whether its student has stopped the check."""
MOST_CONNECTIONS = 16
MOST_WAITING = 4
"""The maximum number of answers that one student may have in the queue."""

Item = TypeVar("Item")


class TooMany(RuntimeError):
    """Raised when an owner has too many items in the queue. The message is for the owner."""


class FairQueue(Generic[Item]):
    """A queue in which the items' owners take turns, so an owner with many items doesn't delay the other owners.

    Thread-safe.
    """

    def __init__(self, most: int = MOST_WAITING) -> None:
        self._most = most
        self._waiting: dict[Hashable, deque[Item]] = {}
        self._changed = threading.Condition()

    def put(self, owner: Hashable, item: Item) -> None:
        """Add an item behind its owner's other items. Raises TooMany if the owner has too many items in the queue."""
        with self._changed:
            own = self._waiting.setdefault(owner, deque())
            if len(own) >= self._most:
                raise TooMany(f"{len(own)} of your answers are waiting already. Wait for one of their cards")
            own.append(item)
            self._changed.notify()

    def take(self) -> Item:
        """Wait for the next item, and return it. Move its owner to the end of the queue."""
        with self._changed:
            while not self._waiting:
                self._changed.wait()
            owner = next(iter(self._waiting))
            own = self._waiting.pop(owner)
            item = own.popleft()
            if own:
                self._waiting[owner] = own
            return item

    def remove(self, item: Item) -> None:
        """Remove an item from the queue if it's there."""
        with self._changed:
            for owner, own in [*self._waiting.items()]:
                if item in own:
                    own.remove(item)
                    if not own:
                        del self._waiting[owner]

    def in_order(self) -> list[Item]:
        """Return all items in the order in which `take` will return them if no item is added."""
        with self._changed:
            rounds = max(map(len, self._waiting.values()), default=0)
            return [own[turn] for turn in range(rounds) for own in self._waiting.values() if turn < len(own)]


@dataclass(eq=False)
class _Request:
    connection: socket.socket
    owner: Hashable
    order: JudgingOrder
    place: int = -1
    _is_gone: bool = False
    _one_at_a_time: threading.Lock = field(default_factory=threading.Lock)

    def send(self, message: Message) -> None:
        """Send a message as a line. After a failure, because the client is gone or doesn't read, do nothing."""
        with self._one_at_a_time:
            if not self._is_gone:
                try:
                    self.connection.sendall(line_of(message))
                except OSError:
                    self._is_gone = True

    def is_wanted(self) -> bool:
        """Return whether the client still waits for the result. A client sends nothing after its order."""
        return not select.select([self.connection], [], [], 0.0)[0]

    def show_place(self, place: int) -> None:
        """Send the answer's place in the queue to the client if the place has changed."""
        if place != self.place:
            self.place = place
            self.send(progress_message(Progress(place)))


def user_of(connection: socket.socket) -> int:
    """Return the user ID of the process at the other end of a Unix socket."""
    credentials = connection.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, struct.calcsize("3i"))
    return int(struct.unpack("3i", credentials)[1])


class CheckService:
    """Judges the answers that arrive at a socket. `owner_of`: a function that returns a connection's owner."""

    def __init__(
        self,
        folder: Path,
        slots: int,
        isolation: Isolation = "sandbox",
        owner_of: Callable[[socket.socket], Hashable] = user_of,
    ) -> None:
        self.path = folder / SOCKET
        self.path.unlink(missing_ok=True)
        self.pool = SlotPool()
        self._kind = Kind(isolation)
        self._most_programs = slots * (1 + WAITING_PER_SLOT)
        self._permits = WorkPermits(
            slots, lambda: self.pool.take_warm(self._kind), lambda _: fits_in_memory()
        )
        self._owner_of = owner_of
        self._connections: Counter[Hashable] = Counter()
        self._counting = threading.Lock()
        self._queue: FairQueue[_Request] = FairQueue()
        self._listener = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        self._listener.bind(str(self.path))
        os.chmod(self.path, 0o666)
        self._listener.listen(128)

    def serve(self) -> None:
        """Accept orders until the service is closed."""
        self.pool.fork_from_now_on(self._kind)
        for number in range(self._most_programs):
            threading.Thread(target=self._work, name=f"check {number}", daemon=True).start()
        while True:
            try:
                connection, _ = self._listener.accept()
            except OSError:  # closed
                return
            owner = self._owner_of(connection)
            if self._count(owner, 1) > MOST_CONNECTIONS:
                self._end(connection, owner)
            else:
                connection.settimeout(LONGEST_SILENCE_S)
                threading.Thread(target=self._take_in, args=[connection, owner], daemon=True).start()

    def close(self) -> None:
        """Stop accepting orders, and stop all slots."""
        with contextlib.suppress(OSError):
            self._listener.shutdown(socket.SHUT_RDWR)
        self._listener.close()
        self.path.unlink(missing_ok=True)
        self.pool.close()

    def _count(self, owner: Hashable, change: int) -> int:
        with self._counting:
            self._connections[owner] += change
            return self._connections[owner]

    def _end(self, connection: socket.socket, owner: Hashable) -> None:
        connection.close()
        self._count(owner, -1)

    def _take_in(self, connection: socket.socket, owner: Hashable) -> None:
        try:
            request = _Request(connection, owner, read_order(connection))
        except (EOFError, OSError, KeyError, ValueError):
            self._end(connection, owner)
            return
        try:
            self._queue.put(owner, request)
        except TooMany as error:
            request.send(error_message(str(error)))
            self._end(connection, owner)
            return
        self._show_places()

    def _show_places(self) -> None:
        for place, request in enumerate(self._queue.in_order(), start=1):
            request.show_place(place)

    def _work(self) -> None:
        while True:
            permit = self._permits.take()
            while not (request := self._queue.take()).is_wanted():
                self._end(request.connection, request.owner)
            self._show_places()
            request.send(self._last_line(permit, request))
            self._end(request.connection, request.owner)

    def _last_line(self, permit: Permit, request: _Request) -> Message:
        """Judge an answer. Send all messages about it except the last one, and return the last one."""
        try:
            judgement = permit.judge(
                self.pool,
                self._kind,
                Job("", request.order.exercise, Answer(request.order.answer)),
                soak=request.order.soak,
                report=lambda one: request.send(judgement_message(one, final=False)),
                progress=lambda one: request.send(progress_message(one)),
            )
            return judgement_message(judgement, final=True)
        except Exception as error:  # an invalid order, which no notebook would send, must not stop the thread
            return error_message(f"{type(error).__name__}: {error}")


def read_order(connection: socket.socket) -> JudgingOrder:
    """Read a request to judge an answer from a connection.

    Raises EOFError, OSError, KeyError, or ValueError if no valid order arrives. An order may name only one of the
    course's exercises, because we run an exercise's criteria, which are code.
    """
    lines = LineReader(connection.fileno(), LONGEST_ORDER)
    deadline = time.monotonic() + LONGEST_SILENCE_S
    while (message := lines.next(LONGEST_SILENCE_S)) is None:
        if time.monotonic() > deadline:
            raise EOFError
    order = JudgingOrder(str(message["exercise"]), str(message["answer"]), soak=True, progress=True)
    if order.exercise not in stems(course_folder() / "solutions"):
        raise ValueError(f"there is no exercise {order.exercise}")
    return order


def judge_there(
    path: str,
    stem: str,
    answer: Answer,
    report: Report,
    progress: ShowProgress | None = None,
    stop: Callable[[], bool] = lambda: False,
) -> Judgement:
    """Have the service at `path` judge an answer. Pass the progress, such as the place in the queue, to `progress`.

    Once `stop()` returns True, leave the queue or skip the rest of the watch, and return the latest judgment.
    """
    latest: Judgement | None = None
    reason = "the check service of this class does not answer. Run %check again in a minute"
    try:
        with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as connection:
            connection.connect(path)
            connection.sendall(line_of(JudgingOrder(stem, answer.text, soak=True, progress=True)))
            lines = LineReader(connection.fileno())
            while True:
                message = lines.next(LOOK_S)
                if stop():
                    reason = "the check was stopped"
                    break
                if message is None:
                    continue
                if "progress" in message:
                    if progress is not None:
                        progress(Progress(**message["progress"]))
                    continue
                latest = judgement_in(message, stem, answer.sha256)
                if message["final"]:
                    return latest
                report(latest)
    except (OSError, EOFError, ValueError):
        latest = None
    return latest or Judgement(stem, answer.sha256, "infra_error", reason, (), None)


def main() -> None:
    """Parse the command line, and serve until the process is stopped."""
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=Path)
    parser.add_argument("--slots", type=int, default=2)
    parser.add_argument("--isolation", type=named_tier, default="sandbox")
    asked = parser.parse_args()
    asked.folder.mkdir(mode=0o755, parents=True, exist_ok=True)
    service = CheckService(asked.folder, asked.slots, asked.isolation)
    try:
        service.serve()
    except KeyboardInterrupt:
        pass
    finally:
        service.close()


if __name__ == "__main__":
    main()

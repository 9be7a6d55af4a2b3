"""Record the times at which messages and timer ticks arrive, are taken, and are handled by nodes' callbacks.

While a `MachineTap` is open, it wraps methods of rclpy's executors, wait sets, and entities in this process. All times
are in ns on the system clock, as DDS's timestamps are. `notes()` returns plain data for JSON.

This file can also be a driver, which runs another program's `main()` (``ANSWER.py FILE SECONDS NODE``). It records the
node NODE for SECONDS seconds after the node was added to an executor, and then writes the notes to FILE.
"""

import importlib
import json
import os
import sys
import threading
import time
from collections.abc import Awaitable, Callable, Generator, Iterable
from contextlib import suppress
from functools import partial
from typing import Any

SHADOW_DEPTH = 1000
SHADOW_NAME = "_workbook_machine"
MATCHED_WITHIN_S = 5.0
POLL_S = 0.01
KINDS = ("subscription", "timer", "client", "service")
OF_RCLPY = ("parameters", "parameters_atomically", "parameter_types", "get_type_description")
"""The name endings of the services that rclpy creates for every node."""
Note = dict[str, Any]


class _Watched:
    """Awaits a callback, and records when the callback pauses and resumes.

    During a pause, its thread can do other work.
    """

    def __init__(self, awaited: Awaitable[Any], call: Note) -> None:
        self._awaited, self._call = awaited, call

    def __await__(self) -> Generator[Any, Any, Any]:
        call, inner = self._call, self._awaited.__await__()
        call["begin"] = time.time_ns()
        try:
            while True:
                try:
                    given = next(inner)
                except StopIteration as end:
                    return end.value
                pause: list[int | None] = [time.time_ns(), None]
                call["pauses"].append(pause)
                yield given
                pause[1] = time.time_ns()
        finally:
            call["end"] = time.time_ns()


class MachineTap:
    """Records the callbacks of `nodes` while it's open. It's a context manager. Call `watch` to add more nodes.

    `drain`: whether to also take the responses that are still in the queues when recording stops (see
    `_look_into_queues`).
    """

    def __init__(self, nodes: Iterable[Any] = (), *, drain: bool = False) -> None:
        self.began: int | None = None
        self.ended: int | None = None
        self._drain = drain
        self._nodes: list[Any] = []
        self._entities: list[Any] = []
        self._sources: list[Note] = []
        self._index: dict[int, int] = {}
        self._pointers: dict[tuple[str, int], int] = {}
        self._shadow_node: Any = None
        self._shadows: dict[int, Any] = {}
        self._arrivals: dict[int, dict[int, int]] = {}
        self._calls: list[Note] = []
        self._waits: list[Note] = []
        self._sets: dict[int, list[int]] = {}
        self._taken = threading.local()
        self._executor: Note = {"name": "", "threads": 1}
        self._undo: list[tuple[type, str, Any]] = []
        for node in nodes:
            self.watch(node)

    def watch(self, node: Any) -> None:
        """Watch a node's current subscriptions, timers, clients, and services.

        For each of its subscriptions, create a copy (see `_shadow`). Return when the copies have been matched with
        their publishers, or after `MATCHED_WITHIN_S` seconds, whichever comes first.
        """
        self._nodes.append(node)
        for kind, found in _entities_of(node):
            place = len(self._entities)
            self._entities.append(found)
            self._index[id(found)] = place
            self._pointers[kind, found.handle.pointer] = place
            self._sources.append(_described(kind, found, node))
            if kind == "subscription":
                self._arrivals[place] = {}
                self._shadow(place, found, node)
        deadline = time.monotonic() + MATCHED_WITHIN_S
        while not self._matched() and time.monotonic() < deadline:
            time.sleep(POLL_S)

    def _shadow(self, place: int, subscription: Any, node: Any) -> None:
        """Create a copy of a subscription with a deep queue.

        rclpy doesn't report dropped messages, but they can be found in the copy's queue, which doesn't drop any.
        """
        from rclpy.node import Node
        from rclpy.qos import QoSProfile

        if self._shadow_node is None:
            self._shadow_node = Node(
                SHADOW_NAME,
                context=node.context,
                enable_rosout=False,
                start_parameter_services=False,
                use_global_arguments=False,
            )
        asked = subscription.qos_profile
        qos = QoSProfile(depth=SHADOW_DEPTH, reliability=asked.reliability, durability=asked.durability)
        self._shadows[place] = self._shadow_node.create_subscription(
            subscription.msg_type, subscription.topic_name, _nothing, qos, raw=True
        )

    def _matched(self) -> bool:
        return all(
            shadow.get_publisher_count() >= self._entities[place].get_publisher_count()
            for place, shadow in self._shadows.items()
        )

    def __enter__(self) -> "MachineTap":
        from rclpy.executors import Executor
        from rclpy.impl.implementation_singleton import rclpy_implementation as lower

        for kind in KINDS:
            self._replace(Executor, f"_take_{kind}", self._taking)
            self._replace(lower.WaitSet, f"add_{kind}", partial(self._adding, kind))
        self._replace(lower.Subscription, "take_message", self._stamping)
        self._replace(lower.Client, "take_response", self._stamping)
        self._replace(lower.Service, "service_take_request", self._stamping)
        self._replace(lower.WaitSet, "wait", self._waiting)
        self._replace(Executor, "wait_for_ready_callbacks", self._spinning)
        self.began = time.time_ns()
        return self

    def __exit__(self, *_: object) -> None:
        self.stop()
        if self._shadow_node is not None:
            self._shadow_node.destroy_node()
            self._shadow_node = None

    def stop(self) -> None:
        """Stop recording. Add the messages that are still in the queues to the notes."""
        if self.ended is not None:
            return
        self.ended = time.time_ns()
        while self._undo:
            owner, name, before = self._undo.pop()
            setattr(owner, name, before)
        self._look_into_queues()

    def _replace(self, owner: type, name: str, make: Callable[[Any], Any]) -> None:
        before = getattr(owner, name)
        self._undo.append((owner, name, before))
        setattr(owner, name, make(before))

    def _taking(self, original: Any) -> Any:
        tap = self

        def take(executor: Any, entity: Any) -> Any:
            place = tap._index.get(id(entity))
            if place is None:
                return original(executor, entity)
            due = _due(entity)
            tap._taken.stamp = None
            execute = original(executor, entity)
            if execute is None:
                return None
            call = {"source": place, "thread": threading.get_ident(), "taken": time.time_ns(), "pauses": []}
            stamp = tap._taken.stamp
            call["due"], call["next_due"] = due, _due(entity)
            call["sent"], call["arrived"] = stamp or (None, None)
            call["begin"] = call["end"] = None
            tap._calls.append(call)

            async def run() -> Any:
                return await _Watched(execute(), call)

            return run

        return take

    def _stamping(self, original: Any) -> Any:
        """Wrap a function that takes an item, such as a message, and keep its timestamps for the callback."""
        kept = self._taken

        def take(handle: Any, *wanted: Any) -> Any:
            found = original(handle, *wanted)
            kept.stamp = _stamps(found)
            return found

        return take

    def _adding(self, kind: str, original: Any) -> Any:
        def add(wait_set: Any, handle: Any) -> Any:
            place = self._pointers.get((kind, handle.pointer))
            if place is not None:
                self._sets.setdefault(id(wait_set), []).append(place)
            return original(wait_set, handle)

        return add

    def _waiting(self, original: Any) -> Any:
        def wait(wait_set: Any, *timeout: Any) -> Any:
            places = self._sets.pop(id(wait_set), None)
            if places is None and getattr(self._taken, "outer", None) is None:
                return original(wait_set, *timeout)
            noted = {
                "thread": threading.get_ident(),
                "in": places or [],
                "begin": time.time_ns(),
                "end": None,
            }
            self._waits.append(noted)
            try:
                return original(wait_set, *timeout)
            finally:
                noted["end"] = time.time_ns()

        return wait

    def _spinning(self, original: Any) -> Any:
        """Wrap an executor's method for waiting.

        The wrapper records which executor serves a watched node, and marks the thread that waits.
        """

        def wait_for_ready_callbacks(executor: Any, *args: Any, **named: Any) -> Any:
            if not any(node in self._nodes for node in executor.get_nodes()):
                return original(executor, *args, **named)
            self._executor = _described_executor(executor)
            self._taken.outer = executor
            try:
                return original(executor, *args, **named)
            finally:
                self._taken.outer = None

        return wait_for_ready_callbacks

    def _look_into_queues(self) -> None:
        """Record when messages arrived, including messages that were never taken, and when timers are due next.

        The copies of the subscriptions have received all messages. Responses that weren't taken are recorded only if
        `drain` is set.
        """
        for place, shadow in self._shadows.items():
            with shadow.handle:
                while (found := shadow.handle.take_message(shadow.msg_type, True)) is not None:
                    self._came(place, found)
        for place, entity in enumerate(self._entities):
            kind = self._sources[place]["kind"]
            if kind == "timer":
                self._sources[place]["next_due"] = _due(entity)
            elif kind == "client" and self._drain:
                with entity.handle:
                    while (found := entity.handle.take_response(entity.srv_type.Response))[0] is not None:
                        self._came(place, found)

    def _came(self, place: int, found: Any) -> None:
        stamps = _stamps(found)
        if stamps is not None:
            self._arrivals.setdefault(place, {})[stamps[0]] = stamps[1]

    def notes(self) -> Note:
        """Return everything that was recorded, as plain data."""
        return {
            "began": self.began,
            "ended": self.ended,
            "executor": self._executor,
            "sources": self._sources,
            "arrivals": [
                {"source": place, "sent": sent, "arrived": arrived}
                for place, found in self._arrivals.items()
                for sent, arrived in found.items()
            ],
            "calls": [dict(call) for call in self._calls],
            "waits": [dict(wait) for wait in self._waits],
        }


def _nothing(message: Any) -> None:
    """Ignore a message.

    This is the callback of the copied subscriptions. It never runs, because no executor serves them.
    """


def _entities_of(node: Any) -> list[tuple[str, Any]]:
    """Return the kind and object of each of a node's subscriptions, timers, clients, and services.

    Leave out the subscriptions and services that rclpy creates for every node.
    """
    named = [
        ("subscription", [one for one in node.subscriptions if one.topic_name != "/parameter_events"]),
        ("timer", node.timers),
        ("client", node.clients),
        ("service", [one for one in node.services if not one.service_name.endswith(OF_RCLPY)]),
    ]
    return [(kind, one) for kind, found in named for one in found]


def _described(kind: str, entity: Any, node: Any) -> Note:
    name = (
        getattr(entity, "topic_name", None)
        or getattr(entity, "service_name", None)
        or getattr(entity, "srv_name", "")
    )
    callback = getattr(entity, "callback", None)
    depth = {"subscription": lambda: entity.qos_profile.depth, "timer": lambda: 1}.get(kind, lambda: 10)()
    return {
        "kind": kind,
        "name": name,
        "callback": getattr(callback, "__name__", "") if callback is not None else "",
        "depth": depth,
        "period": entity.timer_period_ns if kind == "timer" else None,
        "group": id(entity.callback_group) if entity.callback_group is not None else 0,
        "node": node.get_name(),
        "next_due": None,
    }


def _described_executor(executor: Any) -> Note:
    from rclpy.executors import MultiThreadedExecutor

    if isinstance(executor, MultiThreadedExecutor):
        return {"name": "MultiThreadedExecutor", "threads": executor._executor._max_workers}
    return {"name": "SingleThreadedExecutor", "threads": 1}


def _due(entity: Any) -> int | None:
    """Return the time (ns) at which a timer is due next. If the timer is overdue, this time is in the past.

    Return None for a canceled timer and for all other entities.
    """
    if not hasattr(entity.handle, "time_until_next_call"):
        return None
    left = entity.handle.time_until_next_call()
    return None if left is None else time.time_ns() + left


def _stamps(found: Any) -> tuple[int, int] | None:
    """Return the times (ns) at which a taken item was sent and received, according to DDS, or None if unknown."""
    for part in found or ():
        if isinstance(part, dict):
            return part["source_timestamp"], part["received_timestamp"]
        if hasattr(part, "received_timestamp"):
            return part.source_timestamp, part.received_timestamp
    return None


def _run_and_write(file: str, seconds: float, name: str) -> None:
    """Run `answer.main()`.

    Record its node `name` for `seconds` after the node was added to an executor, and then write the notes to `file`.
    """
    from rclpy.executors import Executor

    answer = importlib.import_module("answer")
    tap = MachineTap(drain=True)
    original = Executor.add_node

    def add_node(executor: Any, node: Any) -> Any:
        if node.get_name() == name and tap.began is None:
            tap.watch(node)
            tap.__enter__()
            threading.Thread(target=write, daemon=True).start()
        return original(executor, node)

    def write() -> None:
        time.sleep(seconds)
        tap.stop()
        with open(f"{file}.part", "w", encoding="utf-8") as target:
            json.dump(tap.notes(), target)
        os.replace(f"{file}.part", file)

    Executor.add_node = add_node  # type: ignore[method-assign,assignment]
    with suppress(KeyboardInterrupt):
        answer.main()


if __name__ == "__main__":
    program, to, watched_for, watched_node, *rest = sys.argv
    sys.argv = [program, *rest]
    _run_and_write(to, float(watched_for), watched_node)

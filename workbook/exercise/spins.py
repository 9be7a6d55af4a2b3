"""Find the calls in a program's source that spin a node.

They help explain why a node is silent, but they never cost points: only the recording decides.
"""

import ast
from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import Literal

from workbook.recording.recording import SpinSeen

BLOCKING = "spin"
SPINS = frozenset(
    {BLOCKING, "spin_once", "spin_some", "spin_until_future_complete", "spin_once_until_future_complete"}
)
TAKES_CALLBACK = frozenset({"create_timer", "create_subscription", "create_service", "add_done_callback"})
CREATES = frozenset(
    {"create_timer", "create_publisher", "create_subscription", "create_service", "create_client"}
)
RATE, SLEEP = "create_rate", "sleep"
MANY_THREADS = "MultiThreadedExecutor"
"""The executor in which another thread can run a rate's timer while a callback waits for the rate."""
OTHER_THREADS = frozenset(
    {MANY_THREADS, "Thread", "ThreadPoolExecutor", "run_in_executor", "to_thread", "Process"}
)
"""If the program uses one of these names, another thread or process may spin while the main thread waits."""
GROUPS = frozenset({"MutuallyExclusiveCallbackGroup", "ReentrantCallbackGroup"})
LONGEST_CODE = 60
Function = ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda
_DEFINES = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda, ast.ClassDef)


@lru_cache(maxsize=1)  # each phase of judging an answer asks again
def spins_in(text: str) -> tuple[SpinSeen, ...]:
    """Return the calls that spin in a callback, wait in vain, or keep later lines from running, in this order."""
    try:
        return _Spins(ast.parse(text)).found()
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return ()


def spins_in_a_callback(text: str) -> bool:
    """Return whether a callback spins, in which case simulated time wouldn't prove anything.

    The simulated clock waits for the program to become idle, which never happens while a callback spins.
    """
    return any(one.callback and not one.waits for one in spins_in(text))


@lru_cache(maxsize=1)
def repeated_init(text: str) -> int:
    """Return the line (from 1) of an rclpy.init() call in a loop.

    The result is 0 if there is none.
    """
    try:
        return _Spins(ast.parse(text)).init_in_a_loop()
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return 0


class _Spins:
    """The analysis of one program's syntax tree."""

    def __init__(self, tree: ast.Module) -> None:
        self._tree = tree
        nodes = list(ast.walk(tree))
        self._functions = {
            node.name: node
            for node in nodes
            if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)) and node.name != "__init__"
        }
        self._makers = {
            node.name: part
            for node in nodes
            if isinstance(node, ast.ClassDef)
            for part in node.body
            if isinstance(part, ast.FunctionDef) and part.name == "__init__"
        }
        self._calls = [node for node in nodes if isinstance(node, ast.Call)]
        self._named = {_name(node) for node in nodes} | {
            node.name for node in nodes if isinstance(node, ast.alias)
        }
        self._rates = {
            _name(target)
            for node in nodes
            if isinstance(node, (ast.Assign, ast.AnnAssign, ast.NamedExpr))
            if isinstance(node.value, ast.Call) and _called(node.value) == RATE
            for target in (node.targets if isinstance(node, ast.Assign) else (node.target,))
        }

    def found(self) -> tuple[SpinSeen, ...]:
        functions = (*self._functions.values(), *self._makers.values())
        bodies = [self._tree.body, *(function.body for function in functions)]
        unreached = (seen for body in bodies for seen in self._unreached(body))
        return (*self._in_callbacks(), *self._waits_for_rates(), *self._waits_for_futures(), *unreached)

    def init_in_a_loop(self) -> int:
        loops = (node for node in ast.walk(self._tree) if isinstance(node, (ast.For, ast.While)))
        for call in (call for loop in loops for call in self._reached_in(loop.body)):
            if _called(call) == "init" and "init" not in self._functions:
                return call.lineno
        return 0

    def _in_callbacks(self) -> Iterator[SpinSeen]:
        for name, call in self._called_in_callbacks():
            if self._spins(call):
                yield SpinSeen(call.lineno, _code(call), callback=name)

    def _waits_for_rates(self) -> Iterator[SpinSeen]:
        """Yield waits for a rate in a callback, and waits for a rate while nothing can be spinning."""
        in_callbacks = {id(call): name for name, call in self._called_in_callbacks() if self._waits(call)}
        for call in filter(self._waits, self._calls):
            name = in_callbacks.get(id(call), "")
            if not self._named & ({MANY_THREADS} if name else OTHER_THREADS):
                yield SpinSeen(call.lineno, _code(call), callback=name, waits="rate")

    def _waits_for_futures(self) -> Iterator[SpinSeen]:
        """Yield the first `await` in each async callback, unless the program names a callback group.

        In a node's default group, no other callback can run in the meantime to complete the future.
        """
        if self._named & GROUPS:
            return
        for name, callback in dict(self._callbacks()).items():
            awaited = (node for node in ast.walk(callback) if isinstance(node, ast.Await))
            first = next(awaited, None) if isinstance(callback, ast.AsyncFunctionDef) else None
            if first is not None:
                yield SpinSeen(first.lineno, _code(first), callback=name, waits="future")

    def _waits(self, call: ast.Call) -> bool:
        """Return whether a call is a rate's `sleep`."""
        if _called(call) != SLEEP or not isinstance(call.func, ast.Attribute):
            return False
        rate = call.func.value
        return _called(rate) == RATE if isinstance(rate, ast.Call) else _name(rate) in self._rates

    def _called_in_callbacks(self) -> Iterator[tuple[str, ast.Call]]:
        """Yield each call that callbacks make, with the name of the first callback that makes it."""
        seen: set[int] = set()
        for name, callback in self._callbacks():
            for call in self._reached_from(callback):
                if id(call) not in seen:
                    seen.add(id(call))
                    yield name, call

    def _callbacks(self) -> Iterator[tuple[str, Function]]:
        for call in self._calls:
            if _called(call) not in TAKES_CALLBACK:
                continue
            for given in (*call.args, *(keyword.value for keyword in call.keywords)):
                for part in (
                    given,
                    *(given.args if isinstance(given, ast.Call) else ()),
                ):  # functools.partial
                    if isinstance(part, ast.Lambda):
                        yield "lambda", part
                    elif (name := _name(part)) in self._functions:
                        yield name, self._functions[name]

    def _reached_from(self, function: Function) -> Iterator[ast.Call]:
        """Yield the calls that a function makes, directly or through the program's other functions."""
        return self._reached_in(function.body if isinstance(function.body, list) else [function.body])

    def _reached_in(self, part_of_it: Sequence[ast.AST]) -> Iterator[ast.Call]:
        waiting, known = [part_of_it], set[int]()
        while waiting:
            body = waiting.pop()
            for call in (call for part in body for call in _calls_in(part)):
                yield call
                other = self._functions.get(_called(call))
                if other is not None and id(other) not in known:
                    known.add(id(other))
                    waiting.append(other.body)

    def _spins(self, call: ast.Call) -> bool:
        """Return whether a call has the name of a spin function, and the program doesn't define this name itself."""
        return _called(call) in SPINS and _called(call) not in self._functions

    def _blocks(self, statement: ast.stmt, depth: int = 0) -> ast.Call | None:
        """Return the call in a statement that blocks until ROS is shut down, or None if there is none."""
        if depth > 3 or isinstance(statement, _DEFINES):
            return None
        if isinstance(statement, (ast.Try, ast.With)):
            return next((call for part in statement.body if (call := self._blocks(part, depth))), None)
        if not isinstance(statement, (ast.Expr, ast.Assign, ast.AnnAssign)):
            return None
        for call in _calls_in(statement):
            if _called(call) == BLOCKING and self._spins(call):
                return call
            other = self._makers.get(_called(call)) or self._functions.get(_called(call))
            if other is not None and any(self._blocks(part, depth + 1) for part in other.body):
                return call
        return None

    def _unreached(self, body: list[ast.stmt]) -> Iterator[SpinSeen]:
        """Yield the calls in a block, or in its inner blocks, that block and so keep later statements from running."""
        for number, statement in enumerate(body):
            if isinstance(statement, _DEFINES):
                continue
            blocking = self._blocks(statement)
            later = next(filter(None, map(self._does_more, body[number + 1 :])), None)
            if blocking is not None and later is not None:
                kind: Literal["spin", "create"] = "spin" if self._is_spin(later) else "create"
                yield SpinSeen(
                    blocking.lineno, _code(blocking), kept=kind, later=later.lineno, later_code=_code(later)
                )
            inner = getattr(statement, "body", [])
            if isinstance(statement, ast.For):
                again = next(filter(None, map(self._blocks, inner)), None)
                if again is not None:
                    yield SpinSeen(again.lineno, _code(again), kept="round", later=statement.lineno)
            if isinstance(inner, list):
                yield from self._unreached(inner)

    def _does_more(self, statement: ast.stmt) -> ast.Call | None:
        """Return the first call in a statement that would spin, or create something that the node lacks."""
        if isinstance(statement, _DEFINES):
            return None
        return next(
            (call for call in _calls_in(statement) if self._is_spin(call) or _called(call) in CREATES), None
        )

    def _is_spin(self, call: ast.Call) -> bool:
        other = self._functions.get(_called(call))
        return self._spins(call) or (other is not None and any(map(self._blocks, other.body)))


def _calls_in(node: ast.AST) -> Iterator[ast.Call]:
    """Yield the calls in a part of a program, in the order of the source, except those in inner functions."""
    if isinstance(node, _DEFINES):
        return
    if isinstance(node, ast.Call):
        yield node
    for part in ast.iter_child_nodes(node):
        yield from _calls_in(part)


def _name(node: ast.AST) -> str:
    return node.attr if isinstance(node, ast.Attribute) else node.id if isinstance(node, ast.Name) else ""


def _called(call: ast.Call) -> str:
    return _name(call.func)


def _code(node: ast.AST) -> str:
    text = ast.unparse(node)
    return text if len(text) <= LONGEST_CODE else f"{text[:LONGEST_CODE]}..."

"""Create nodes that replace the nodes of the same name when a cell runs again, so that no duplicates remain."""

import threading
import weakref
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import wraps
from typing import Any, TypeVar

from rclpy.context import Context
from rclpy.exceptions import InvalidHandle
from rclpy.node import Node
from rclpy.utilities import get_default_context

Made = TypeVar("Made")
_Key = tuple[int, str, str, tuple[str, ...]]

_made: "weakref.WeakValueDictionary[_Key, Node]" = weakref.WeakValueDictionary()


def destroy(node: Node) -> None:
    """Remove a node from its executor, and destroy the node unless it was already destroyed."""
    executor = node.executor
    if executor is not None:
        executor.remove_node(node)
    try:
        node.destroy_node()
    except InvalidHandle:
        pass


def destroy_all() -> None:
    """Destroy all nodes made with `fresh`."""
    for node in list(_made.values()):
        destroy(node)
    _made.clear()


def nodes_in(context: Context) -> list[Node]:
    """Return the nodes in `context` that were made with `fresh` and haven't been destroyed."""
    return [node for node in _made.values() if node.context is context and context.ok() and _is_alive(node)]


def _is_alive(node: Node) -> bool:
    try:
        with node.handle:
            return True
    except InvalidHandle:
        return False


def _full_namespace(namespace: str | None) -> str:
    return "/" + (namespace or "").strip("/")


def fresh(
    make: Callable[..., Made],
    *args: Any,
    name: str | None = None,
    namespace: str | None = None,
    **kwargs: Any,
) -> Made:
    """Call `make(*args, **kwargs)`, and replace nodes of the same name that an earlier run of the cell made.

    `make` is a node class, or a function that makes one or more nodes. `name` and `namespace` rename the first node
    that `make` creates, even if its class doesn't take such arguments.
    """
    with _replacing(name, namespace) as made:
        try:
            return make(*args, **kwargs)
        except BaseException:
            for node in made:
                if hasattr(node, "_type_description_service"):  # the last attribute that Node.__init__ sets
                    destroy(node)
            raise


@contextmanager
def _replacing(new_name: str | None, new_namespace: str | None) -> Iterator[list[Node]]:
    """While the block runs, let each node that this thread makes replace an earlier node of the same name."""
    here = threading.get_ident()
    made: list[Node] = []
    original = Node.__init__

    @wraps(original)
    def replacing_init(self: Node, node_name: str, **settings: Any) -> None:
        if threading.get_ident() != here:
            original(self, node_name, **settings)
            return
        if not made:
            node_name = new_name or node_name
            if new_namespace is not None:
                settings["namespace"] = new_namespace
        context = settings.get("context") or get_default_context()
        remapped = tuple(settings.get("cli_args") or ())
        key = (id(context), _full_namespace(settings.get("namespace")), node_name, remapped)
        duplicate = _made.pop(key, None)
        if duplicate is not None:
            destroy(duplicate)
        made.append(self)
        original(self, node_name, **settings)
        _made[key] = self

    Node.__init__ = replacing_init  # type: ignore[method-assign]
    try:
        yield made
    finally:
        Node.__init__ = original  # type: ignore[method-assign]

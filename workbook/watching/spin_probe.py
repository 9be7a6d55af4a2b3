"""Whether nodes spin: one that does answers its parameter service, and has set up all that its constructor makes."""

from collections.abc import Iterable
from typing import Any

from rcl_interfaces.srv import ListParameters
from rclpy.node import Node


class SpinProbe:
    """Calls the parameter service of nodes from `node`, which nobody needs to spin."""

    def __init__(self, node: Node) -> None:
        self._node = node
        self._clients: dict[str, Any] = {}
        self._called: set[str] = set()
        self._spinning: set[str] = set()

    def all_spin(self, names: Iterable[str]) -> bool:
        """Whether each of these nodes (fully qualified names) has answered by now. False for no nodes."""
        wanted = set(names)
        for name in wanted - self._spinning:
            self._poll(name)
        return bool(wanted) and wanted <= self._spinning

    def _poll(self, name: str) -> None:
        client = self._clients.get(name)
        if client is None:
            client = self._clients[name] = self._node.create_client(ListParameters, f"{name}/list_parameters")
        if name not in self._called and client.service_is_ready():
            with client.handle:
                client.handle.send_request(ListParameters.Request())
            self._called.add(name)
        if name in self._called:
            with client.handle:
                header, _ = client.handle.take_response(ListParameters.Response)
            if header is not None:
                self._spinning.add(name)

    def close(self) -> None:
        """Destroy the clients."""
        while self._clients:
            self._node.destroy_client(self._clients.popitem()[1])

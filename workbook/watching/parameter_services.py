"""Read and set `use_sim_time` in another program's nodes, through the parameter services that rclpy gives each node.

Because the judge starts a program without arguments, the program can't detect at startup that it's being judged. If a
node responds, it's spinning, and its constructor has finished.
"""

import time
from collections.abc import Callable, Iterable
from typing import Any

from rcl_interfaces.msg import Parameter, ParameterType, ParameterValue
from rcl_interfaces.srv import GetParameters, SetParameters
from rclpy.node import Node

USE_SIM_TIME = "use_sim_time"
POLL_S = 0.001


class ParameterServices:
    """Calls other nodes' parameter services from `node`, which needn't be spun."""

    def __init__(self, node: Node) -> None:
        self._node = node
        self._clients: dict[tuple[type, str], Any] = {}
        self._asked: set[str] = set()
        self._spinning: set[str] = set()

    def all_spin(self, names: Iterable[str]) -> bool:
        """Return whether there are names, and all nodes with these fully qualified names have responded so far."""
        wanted = set(names)
        for name in wanted - self._spinning:
            if name not in self._asked and self._send(GetParameters, name, names=[USE_SIM_TIME]):
                self._asked.add(name)
            if name in self._asked and self._take(GetParameters, name) is not None:
                self._spinning.add(name)
            self._client(SetParameters, name)  # so that the node's service discovers our client early
        return bool(wanted) and wanted <= self._spinning

    def set_sim_time(
        self, names: Iterable[str], value: bool, until: float, meanwhile: Callable[[], bool]
    ) -> bool:
        """Set `use_sim_time` of the named nodes to `value`, and return whether all of them have accepted the value.

        Give up at the time `until` (`time.monotonic`, s). While waiting for responses, call `meanwhile` repeatedly, and
        give up if it returns False.
        """
        wanted = Parameter(
            name=USE_SIM_TIME, value=ParameterValue(type=ParameterType.PARAMETER_BOOL, bool_value=value)
        )
        unasked, unanswered = set(names), set[str]()
        while unasked or unanswered:
            for name in [*unasked]:
                if self._send(SetParameters, name, parameters=[wanted]):
                    unasked.remove(name)
                    unanswered.add(name)
            for name in [*unanswered]:
                response = self._take(SetParameters, name)
                if response is not None:
                    unanswered.remove(name)
                    if not all(result.successful for result in response.results):
                        return False
            if unasked or unanswered:
                if time.monotonic() > until or not meanwhile():
                    return False
                time.sleep(POLL_S)
        return True

    def _client(self, kind: Any, name: str) -> Any:
        service = "get_parameters" if kind is GetParameters else "set_parameters"
        key = (kind, name)
        if key not in self._clients:
            self._clients[key] = self._node.create_client(kind, f"{name}/{service}")
        return self._clients[key]

    def _send(self, kind: Any, name: str, **fields: Any) -> bool:
        """Send a request. Return False if the service isn't available yet."""
        client = self._client(kind, name)
        if not client.service_is_ready():
            return False
        with client.handle:
            client.handle.send_request(kind.Request(**fields))
        return True

    def _take(self, kind: Any, name: str) -> Any:
        """Return a node's response to our request, or None if it hasn't arrived yet."""
        client = self._client(kind, name)
        with client.handle:
            header, response = client.handle.take_response(kind.Response)
        return None if header is None else response

    def close(self) -> None:
        """Destroy the clients."""
        while self._clients:
            self._node.destroy_client(self._clients.popitem()[1])

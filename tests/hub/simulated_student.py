"""Simulate a student without a browser: log in, start a server, open a kernel, and run cells in it."""

import json
import time
import uuid
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import requests
import websocket

LONGEST_START_S = 300.0
LONGEST_CELL_S = 180.0
POLL_S = 0.2


@dataclass
class Ran:
    """The outputs of a cell: printed text, displayed text, and the error if there was one."""

    text: str = ""
    shown: str = ""
    error: str = ""


class SimulatedStudent:
    """A browser session at a hub."""

    def __init__(self, address: str, name: str, password: str | None) -> None:
        """Log in. Without a password, don't."""
        self.address, self.name = address, name
        self._session = requests.Session()
        if password is None:
            return
        page = self._session.get(f"{address}/hub/login")
        page.raise_for_status()
        form = {"username": name, "password": password, "_xsrf": self._session.cookies["_xsrf"]}
        answer = self._session.post(f"{address}/hub/login?next=/hub/home", data=form)
        answer.raise_for_status()

    def get(self, path: str) -> requests.Response:
        """Request an address of the hub as this student."""
        return self._session.get(self.address + path)

    def send(self, method: str, path: str, data: Any = None) -> requests.Response:
        """Send a request to the API of the hub or of a server."""
        marks = [
            one.value or ""
            for one in self._session.cookies
            if one.name == "_xsrf" and path.startswith(one.path)
        ]
        headers = {"X-XSRFToken": marks[-1]}
        return self._session.request(method, self.address + path, json=data or {}, headers=headers)

    @property
    def has_server(self) -> bool:
        """Return whether the student's server is ready, according to the hub."""
        servers = self.get(f"/hub/api/users/{self.name}").json()["servers"]
        return bool(servers.get("", {}).get("ready"))

    def start_server(self) -> None:
        """Start the server unless it runs, wait until it responds, and get its cookie."""
        if not self.has_server:
            self.send("POST", f"/hub/api/users/{self.name}/server").raise_for_status()
        deadline = time.monotonic() + LONGEST_START_S
        while not self.has_server:
            assert time.monotonic() < deadline, "the server does not start"
            time.sleep(POLL_S)
        self.get(f"/user/{self.name}/lab").raise_for_status()

    def stop_server(self) -> None:
        """Stop the server, and wait until it has ended."""
        self.send("DELETE", f"/hub/api/users/{self.name}/server").raise_for_status()
        deadline = time.monotonic() + LONGEST_START_S
        while self.get(f"/hub/api/users/{self.name}").json()["servers"]:
            assert time.monotonic() < deadline, "the server does not end"
            time.sleep(POLL_S)

    def notebook(self, path: str) -> dict[str, Any]:
        """Return the content of a notebook in the work folder."""
        content: dict[str, Any] = self.get(f"/user/{self.name}/api/contents/{path}").json()["content"]
        return content

    def start_kernel(self, path: str = "notebooks") -> str:
        """Start a kernel in a folder, and return its id."""
        return str(self.send("POST", f"/user/{self.name}/api/kernels", {"path": path}).json()["id"])

    @contextmanager
    def connected(self, kernel: str) -> Iterator["Connection"]:
        """Connect to a kernel."""
        cookies = "; ".join(f"{one.name}={one.value}" for one in self._session.cookies)
        url = f"{self.address.replace('http', 'ws', 1)}/user/{self.name}/api/kernels/{kernel}/channels"
        socket = websocket.create_connection(url, cookie=cookies, timeout=LONGEST_CELL_S)
        try:
            yield Connection(socket)
        finally:
            socket.close()


class Connection:
    """Runs cells, one after another."""

    def __init__(self, socket: websocket.WebSocket) -> None:
        self._socket = socket

    def run(self, code: str) -> Ran:
        """Run one cell and wait for its end."""
        mark = uuid.uuid4().hex
        header = {
            "msg_id": mark,
            "msg_type": "execute_request",
            "username": "",
            "session": mark,
            "version": "5.3",
        }
        content = {"code": code, "silent": False, "store_history": True, "allow_stdin": False}
        message = {
            "header": header,
            "parent_header": {},
            "metadata": {},
            "content": content,
            "channel": "shell",
        }
        self._socket.send(json.dumps(message))
        ran, is_idle, is_answered = Ran(), False, False
        while not (is_idle and is_answered):
            told = json.loads(self._socket.recv())
            if told["parent_header"].get("msg_id") != mark:
                continue
            kind, content = told["msg_type"], told["content"]
            if kind == "stream":
                ran.text += content["text"]
            elif kind in ("execute_result", "display_data", "update_display_data"):
                ran.shown += content["data"].get("text/plain", "") + "\n"
            elif kind == "error":
                ran.error = f"{content['ename']}: {content['evalue']}"
            is_answered = is_answered or kind == "execute_reply"
            is_idle = is_idle or (kind == "status" and content["execution_state"] == "idle")
        return ran

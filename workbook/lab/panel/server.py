"""Serve the panel from JupyterLab's server: follow the active notebook, and forward its observer's reports."""

import asyncio
import contextlib
import json
import os
import sys
from typing import Any

from jupyter_server.auth.decorator import ws_authenticated
from jupyter_server.base.handlers import JupyterHandler
from jupyter_server.base.websocket import WebSocketMixin
from jupyter_server.utils import url_path_join
from tornado.ioloop import PeriodicCallback
from tornado.websocket import WebSocketHandler

from workbook.ros.environment import child_environment
from workbook.ros.notebook_registry import OpenNotebook, open_notebooks

FOLLOW_EVERY_MS = 1000
LONGEST_LINE = 1 << 22
END_WITHIN_S = 3.0


class ObserverProcess:
    """The observer process of one panel. It exits when its input closes, this server ends, or `end` is called."""

    def __init__(self, process: asyncio.subprocess.Process) -> None:
        self._process = process

    @classmethod
    async def started(cls) -> "ObserverProcess":
        """Start an observer. Raise OSError if that fails."""
        process = await asyncio.create_subprocess_exec(
            sys.executable,
            *("-P", "-m", "workbook.lab.panel.observer", str(os.getpid())),
            stdin=asyncio.subprocess.PIPE,
            stdout=asyncio.subprocess.PIPE,
            stderr=asyncio.subprocess.DEVNULL,
            env=child_environment(0),
            limit=LONGEST_LINE,
        )
        return cls(process)

    def order(self, **order: object) -> None:
        """Send the observer a domain or a topic to watch."""
        assert self._process.stdin is not None
        if not self._process.stdin.is_closing():
            self._process.stdin.write(json.dumps(order).encode() + b"\n")

    async def line(self) -> str:
        """Return the observer's next line; empty if it has ended."""
        assert self._process.stdout is not None
        return (await self._process.stdout.readline()).decode()

    async def end(self) -> None:
        """End the observer, and wait until its process has exited."""
        assert self._process.stdin is not None
        self._process.stdin.close()
        try:
            await asyncio.wait_for(self._process.wait(), END_WITHIN_S)
        except TimeoutError:
            with contextlib.suppress(ProcessLookupError):
                self._process.kill()
            await self._process.wait()


class PanelSocket(WebSocketMixin, WebSocketHandler, JupyterHandler):
    """The connection to an open panel. It sends {"kernel": ID} and {"echo": TOPIC}, and gets reports."""

    auth_resource = "kernels"

    @ws_authenticated
    async def get(self) -> None:
        """Open the connection for an authorized user."""
        await super().get()

    async def open(self) -> None:
        """Start an observer for a panel that has appeared on the screen."""
        self._kernel: str | None = None
        self._notebook: OpenNotebook | None = None
        self._observer: ObserverProcess | None = None
        self._closed = False
        self._ticker = PeriodicCallback(self._follow, FOLLOW_EVERY_MS)
        self._observer = await ObserverProcess.started()
        if self._closed:
            await self._observer.end()
            return
        self._ticker.start()
        self._passing = asyncio.ensure_future(self._pass_on(self._observer))
        self._follow()

    async def on_message(self, message: str | bytes) -> None:
        """Handle a change of the active notebook or of the echoed topic."""
        said = json.loads(message)
        if "kernel" in said:
            self._kernel = said["kernel"]
            self._follow()
        if "echo" in said and self._observer is not None:
            self._observer.order(echo=said["echo"])

    def on_close(self) -> None:
        """Handle a panel that was closed or hidden."""
        super().on_close()
        self._closed = True
        self._ticker.stop()
        if self._observer is not None:
            self._ending = asyncio.ensure_future(self._observer.end())

    def _follow(self) -> None:
        """Have the observer watch the active notebook's domain."""
        if self._observer is None:
            return
        pid = self._pid()
        notebook = next((one for one in open_notebooks() if one.pid == pid), None) if pid else None
        if notebook != self._notebook:
            self._notebook = notebook
            self._observer.order(domain=None if notebook is None else notebook.domain_id)
            self._tell({"kind": "domain", "domain": None if notebook is None else notebook.domain_id})

    def _pid(self) -> int | None:
        """Return the process ID of the active notebook's kernel; None if there is none."""
        if self._kernel is None or self._kernel not in self.kernel_manager:
            return None
        provisioner = self.kernel_manager.get_kernel(self._kernel).provisioner
        pid = getattr(provisioner, "pid", None)
        return pid if isinstance(pid, int) else None

    async def _pass_on(self, observer: ObserverProcess) -> None:
        while line := await observer.line():
            self._tell(line)
        if not self._closed:
            self.close()

    def _tell(self, what: Any) -> None:
        with contextlib.suppress(Exception):  # the connection is closing
            self.write_message(what)


def add_handlers(app: Any) -> None:
    """Add the panel's handler to JupyterLab's server."""
    base = app.web_app.settings["base_url"]
    app.web_app.add_handlers(".*$", [(url_path_join(base, "workbook/panel"), PanelSocket)])

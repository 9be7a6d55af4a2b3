"""A real kernel with the magics, and the student's folder in which it works."""

import os
import sys
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

from workbook.authoring.kernels import PrivateKernelManager

PATIENCE_S = 90.0
WAITING = "Watching "
START = """
from workbook.ros.environment import prepare
_ = prepare()
if 'workbook.magics' not in get_ipython().extension_manager.loaded:
    get_ipython().run_line_magic('load_ext', 'workbook.magics')
"""


@dataclass
class Shown:
    """The outputs of a cell: printed text, displays as text, the error, and instructions for the screen."""

    text: str = ""
    displays: list[str] = field(default_factory=list)
    html: list[str] = field(default_factory=list)
    error: str | None = None
    payloads: list[dict[str, Any]] = field(default_factory=list)


class Kernel:
    """A kernel. `run` executes a cell as a notebook does."""

    def __init__(self, folder: Path) -> None:
        environ = {name: value for name, value in os.environ.items() if name != "PYTEST_CURRENT_TEST"}
        for name in ("ROS_DOMAIN_ID", "JPY_SESSION_NAME", "WORKBOOK_ANSWERS"):
            environ.pop(name, None)
        self.manager = PrivateKernelManager(kernel_name="python3")
        self.manager.kernel_spec.argv = [
            sys.executable,
            "-m",
            "ipykernel_launcher",
            "-f",
            "{connection_file}",
        ]
        self.manager.kernel_spec.env = {}
        self.manager.start_kernel(env=environ, cwd=str(folder))
        self.client: Any = self.manager.client()
        self.client.start_channels()
        self.client.wait_for_ready(timeout=PATIENCE_S)
        self.folder = folder
        assert self.run(START).error is None

    @property
    def pid(self) -> int:
        return int(self.manager.provisioner.pid)

    def start(self, code: str, on_screen: Sequence[str] | None = None) -> str:
        """Start the kernel.

        `on_screen`: the contents of the answer cells, which JupyterLab sends with each running cell.
        """
        if on_screen is None:
            return str(self.client.execute(code))
        message = self.client.session.msg("execute_request", {"code": code, "silent": False})
        message["metadata"] = {"workbook": {"answers": list(on_screen)}}
        self.client.shell_channel.send(message)
        return str(message["header"]["msg_id"])

    def finish(self, request: str) -> Shown:
        shown = Shown()
        deadline = time.monotonic() + PATIENCE_S
        while True:
            message = self.client.get_iopub_msg(timeout=max(0.1, deadline - time.monotonic()))
            if message["parent_header"].get("msg_id") != request:
                continue
            content, kind = message["content"], message["msg_type"]
            if kind == "stream":
                shown.text += content["text"]
            elif kind in ("display_data", "execute_result", "update_display_data"):
                if (
                    kind == "update_display_data"
                ):  # an earlier cell's message, or the card that replaces a waiting line
                    if not shown.displays or not shown.displays[-1].startswith(WAITING):
                        continue
                    shown.displays.pop()
                    shown.html.pop()
                shown.displays.append(content["data"].get("text/markdown") or content["data"]["text/plain"])
                shown.html.append(content["data"].get("text/html", ""))
            elif kind == "error":
                shown.error = "\n".join(content["traceback"])
            elif kind == "status" and content["execution_state"] == "idle":
                return shown

    def run(self, code: str, on_screen: Sequence[str] | None = None) -> Shown:
        request = self.start(code, on_screen)
        shown = self.finish(request)
        while True:
            reply = self.client.get_shell_msg(timeout=PATIENCE_S)
            if reply["parent_header"].get("msg_id") == request:
                shown.payloads = reply["content"].get("payload", [])
                return shown

    def good(self, code: str, on_screen: Sequence[str] | None = None) -> Shown:
        shown = self.run(code, on_screen)
        assert shown.error is None, shown.error
        return shown

    def work_in(self, folder: Path) -> None:
        """Continue as a student whose folder is still empty."""
        (folder / "answers").mkdir(parents=True)
        self.good(f"import os; os.chdir({str(folder)!r})\n%stop")
        self.folder = folder

    def shut_down(self) -> None:
        self.client.stop_channels()
        self.manager.shutdown_kernel()

    def close(self) -> None:
        if self.manager.has_kernel:
            self.client.stop_channels()
            self.manager.shutdown_kernel(now=True)


@pytest.fixture(scope="module")
def shared_kernel(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Kernel]:
    kernel = Kernel(tmp_path_factory.mktemp("work"))
    yield kernel
    kernel.close()


@pytest.fixture
def kernel(shared_kernel: Kernel, tmp_path: Path) -> Kernel:
    shared_kernel.work_in(tmp_path / "work")
    return shared_kernel


@pytest.fixture
def fresh_kernel(tmp_path: Path) -> Iterator[Kernel]:
    (tmp_path / "answers").mkdir()
    kernel = Kernel(tmp_path)
    yield kernel
    kernel.close()

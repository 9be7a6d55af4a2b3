"""Kernels and scripts, each in a separate process with a separate domain."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from queue import Empty
from typing import Any

import pytest
from jupyter_client.manager import KernelManager

from workbook.authoring.kernels import PrivateKernelManager
from workbook.ros.domains import lease_domain
from workbook.ros.environment import child_environment

CELL_LIMIT_S = 60.0
START = """
from workbook.ros.environment import prepare
prepare({domain})
from workbook.ros import kernel
kernel.install({label!r})
"""
NAMES = """
import asyncio, time, rclpy
from rclpy.node import Node
from std_msgs.msg import String
from workbook.ros import fresh, init, live, run, shutdown, spin_for
def go():
    print('go', flush=True)
class Talker(Node):
    def __init__(self, period=0.05):
        super().__init__('talker')
        self.pub = self.create_publisher(String, 'chatter', 10)
        self.heard = []
        self.create_subscription(String, 'chatter', lambda msg: self.heard.append(msg.data), 10)
        self.create_timer(period, self.tick)
        self.ticks = 0
    def tick(self):
        self.ticks += 1
        self.pub.publish(String(data=f'tick {self.ticks}'))
"""
FORGET = """
shutdown(); rclpy.try_shutdown()
get_ipython().reset(new_session=False)
"""


@dataclass
class Outcome:
    """The outcome of a cell: its streams in order, its result, its error."""

    text: str = ""
    stderr: str = ""
    result: str | None = None
    error: str | None = None
    message: str = ""
    traceback: str = ""


@dataclass
class Kernel:
    manager: KernelManager
    client: Any
    pending: list[str] = field(default_factory=list)

    def start(self, code: str) -> str:
        return str(self.client.execute(code))

    def finish(self, request: str, limit: float = CELL_LIMIT_S) -> Outcome:
        outcome = Outcome()
        end = time.monotonic() + limit
        while True:
            try:
                message = self.client.get_iopub_msg(timeout=max(0.1, end - time.monotonic()))
            except Empty:
                raise AssertionError(f"the cell did not end in {limit} s; so far: {outcome}") from None
            if message["parent_header"].get("msg_id") != request:
                continue
            content = message["content"]
            kind = message["msg_type"]
            if kind == "stream" and content["name"] == "stdout":
                outcome.text += content["text"]
            elif kind == "stream":
                outcome.stderr += content["text"]
            elif kind == "execute_result":
                outcome.result = content["data"]["text/plain"]
            elif kind == "error":
                outcome.error, outcome.message = content["ename"], content["evalue"]
                outcome.traceback = "\n".join(content["traceback"])
            elif kind == "status" and content["execution_state"] == "idle":
                return outcome

    def run(self, code: str) -> Outcome:
        return self.finish(self.start(code))

    def good(self, code: str) -> Outcome:
        outcome = self.run(code)
        assert outcome.error is None, outcome.traceback
        return outcome

    def wait_for_text(self, request: str, text: str) -> None:
        """Read a running cell's output until it contains `text`."""
        seen = ""
        while text not in seen:
            message = self.client.get_iopub_msg(timeout=CELL_LIMIT_S)
            if message["parent_header"].get("msg_id") == request and message["msg_type"] == "stream":
                seen += message["content"]["text"]

    def interrupt(self) -> None:
        self.manager.interrupt_kernel()

    @property
    def pid(self) -> int:
        return int(self.manager.provisioner.pid)

    def close(self) -> int | None:
        """End the kernel as Jupyter does. Return its exit code (None if it was killed or the code is unknown)."""
        process = self.manager.provisioner.process
        self.client.shutdown()
        try:
            code = process.wait(timeout=10)
        except subprocess.TimeoutExpired:
            code = None
        self.client.stop_channels()
        self.manager.shutdown_kernel(now=True)
        return None if code is None else int(code)


def launch(folder: Path, label: str = "lesson", *, domain: str = "", **environ: str) -> Kernel:
    manager = PrivateKernelManager(kernel_name="python3")
    manager.kernel_spec.argv = [sys.executable, "-m", "ipykernel_launcher", "-f", "{connection_file}"]
    manager.kernel_spec.env = {}
    ours = {name: value for name, value in os.environ.items() if name != "PYTEST_CURRENT_TEST"}
    ours.pop("ROS_DOMAIN_ID", None)
    manager.start_kernel(env=ours | environ, cwd=str(folder))
    client = manager.client()
    client.start_channels()
    client.wait_for_ready(timeout=60)
    kernel = Kernel(manager, client)
    kernel.good(START.format(domain=domain, label=label) + NAMES)
    return kernel


@pytest.fixture
def open_kernel(tmp_path: Path) -> Iterator[Callable[..., Kernel]]:
    opened: list[Kernel] = []

    def open_one(label: str = "lesson", **options: str) -> Kernel:
        opened.append(launch(tmp_path, label, **options))
        return opened[-1]

    yield open_one
    for (
        kernel
    ) in opened:  # in order: after a killed kernel, the next owner of its domain would still see its node
        if kernel.manager.has_kernel:
            kernel.close()


@pytest.fixture
def kernel(open_kernel: Callable[..., Kernel]) -> Kernel:
    return open_kernel()


@pytest.fixture(scope="module")
def kernels_at_hand() -> Iterator[list[Kernel]]:
    """Provide kernels whose namespace is reset between tests."""
    at_hand: list[Kernel] = []
    yield at_hand
    for kernel in at_hand:
        assert kernel.close() == 0


@pytest.fixture
def used_kernel(kernels_at_hand: list[Kernel], tmp_path_factory: pytest.TempPathFactory) -> Iterator[Kernel]:
    """Provide a kernel in which another lesson seems to have run before."""
    kernel = kernels_at_hand.pop() if kernels_at_hand else launch(tmp_path_factory.mktemp("kernel"))
    kernel.good(NAMES)
    yield kernel
    if kernel.run(FORGET).error:
        kernel.close()
    else:
        kernels_at_hand.append(kernel)


@pytest.fixture
def domain() -> Iterator[int]:
    with lease_domain() as lease:
        yield lease.domain_id


@pytest.fixture
def start_script(tmp_path: Path, domain: int) -> Iterator[Callable[..., "subprocess.Popen[str]"]]:
    """Start Python code as a process on the test's domain."""
    started: list[subprocess.Popen[str]] = []

    def start(code: str, **environ: str) -> "subprocess.Popen[str]":
        file = tmp_path / f"script_{len(started)}.py"
        file.write_text(code)
        process = subprocess.Popen(
            [sys.executable, str(file)],
            env=child_environment(domain) | environ,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            start_new_session=True,
        )
        started.append(process)
        return process

    yield start
    for process in started:
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGINT)
            try:
                process.wait(5)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)
                process.wait()
        for pipe in (process.stdout, process.stderr):
            if pipe is not None:
                pipe.close()

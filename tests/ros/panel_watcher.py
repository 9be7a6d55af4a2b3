"""An observer as the panel starts it, with the events that it reports."""

import json
import os
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from typing import Any

from workbook.ros.environment import child_environment

LIMIT_S = 60.0


class Watcher:
    """An observer process. `told` contains all its reports so far; `wait` waits for more."""

    def __init__(self) -> None:
        self.told: list[dict[str, Any]] = []
        self._news = threading.Condition()
        self.process = subprocess.Popen(
            [sys.executable, "-P", "-m", "workbook.lab.panel.observer", str(os.getpid())],
            env=child_environment(0),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            with self._news:
                self.told.append(json.loads(line))
                self._news.notify_all()

    def order(self, **order: object) -> None:
        assert self.process.stdin is not None
        self.process.stdin.write(json.dumps(order) + "\n")
        self.process.stdin.flush()

    def wait(self, kind: str, fits: Callable[[dict[str, Any]], object] = lambda news: True) -> dict[str, Any]:
        """Wait until the last report of a kind fits, and return it."""
        end = time.monotonic() + LIMIT_S
        with self._news:
            while True:
                last = next((one for one in reversed(self.told) if one["kind"] == kind), None)
                if last is not None and fits(last):
                    return last
                assert self._news.wait(end - time.monotonic()), f"so far: {str(self.told)[-2000:]}"

    def heard(self, kind: str, fits: Callable[[dict[str, Any]], object]) -> None:
        """Wait until any report of a kind fits, even if later ones don't."""
        end = time.monotonic() + LIMIT_S
        with self._news:
            while not any(one["kind"] == kind and fits(one) for one in self.told):
                assert self._news.wait(end - time.monotonic()), f"so far: {str(self.told)[-2000:]}"

    def close(self) -> int:
        """Close its input, and return its exit code."""
        assert self.process.stdin is not None and self.process.stdout is not None
        self.process.stdin.close()
        code = self.process.wait(20)
        self._reader.join()
        self.process.stdout.close()
        return code

"""A stand-in for a kernel that replays the outputs of a notebook that was run elsewhere, for example in JupyterLab.

With this stand-in, nbval compares that run as if nbval had run the notebook itself.
"""

import itertools
from collections import deque
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import nbformat

RAN = "WORKBOOK_RAN"
"""Environment variable with the path of the notebook that was run elsewhere, for nbval to compare."""


class Replay:
    """Stands in for `nbval.kernel.RunningKernel`. `ran` is the path of the notebook that was run elsewhere."""

    def __init__(self, ran: Path) -> None:
        cells = nbformat.read(ran, nbformat.NO_CONVERT).cells
        self._cells: Iterator[Any] = (cell for cell in cells if cell.cell_type == "code")
        self._numbers = itertools.count(1)
        self._messages: deque[dict[str, Any]] = deque()
        self._alive = True

    def execute_cell_input(self, source: str, allow_stdin: bool | None = None) -> str:
        """Queue the messages of the next cell's outputs and return the request's id.

        Raises RuntimeError if that cell has a different source, or if it wasn't run.
        """
        cell = next(self._cells, None)
        if cell is None or cell.source != source:
            raise RuntimeError("the notebook that was run has another cell here")
        if source.strip() and cell.execution_count is None:
            raise RuntimeError("this cell was not run")
        request = f"cell {next(self._numbers)}"
        for output in cell.outputs:
            self._add(request, output.output_type, {k: v for k, v in output.items() if k != "output_type"})
        self._add(request, "status", {"execution_state": "idle"})
        return request

    def _add(self, request: str, kind: str, content: dict[str, Any]) -> None:
        self._messages.append({"msg_type": kind, "parent_header": {"msg_id": request}, "content": content})

    def get_message(self, stream: str, timeout: float | None = None) -> dict[str, Any]:
        """Return the cell's next message."""
        return self._messages.popleft()

    def await_reply(self, msg_id: str, timeout: float | None = None) -> None:
        """Return right away, because the cell has already run."""

    def await_idle(self, parent_id: str, timeout: float) -> None:
        """Discard the cell's remaining messages."""
        self._messages.clear()

    def is_alive(self) -> bool:
        """Return True until `stop` is called."""
        return self._alive

    def stop(self) -> None:
        """Mark the replay as stopped."""
        self._alive = False

"""A kernel that runs nothing: it repeats what a notebook showed that was run elsewhere, as in JupyterLab.

nbval then compares that run as it compares its own.
"""

import itertools
from collections import deque
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import nbformat

RAN = "WORKBOOK_RAN"
"""Environment variable: the notebook, run elsewhere, that nbval is to compare."""


class Replay:
    """Stands in for `nbval.kernel.RunningKernel`. Raises RuntimeError for a cell that was not run, or reads otherwise.

    `ran`: the notebook with the outputs of its run.
    """

    def __init__(self, ran: Path) -> None:
        cells = nbformat.read(ran, nbformat.NO_CONVERT).cells
        self._cells: Iterator[Any] = (cell for cell in cells if cell.cell_type == "code")
        self._numbers = itertools.count(1)
        self._messages: deque[dict[str, Any]] = deque()
        self._alive = True

    def execute_cell_input(self, source: str, allow_stdin: bool | None = None) -> str:
        """Get ready to repeat what the next cell showed. Returns the number of this request."""
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
        """The next message of the cell."""
        return self._messages.popleft()

    def await_reply(self, msg_id: str, timeout: float | None = None) -> None:
        """Return at once: the cell has been run."""

    def await_idle(self, parent_id: str, timeout: float) -> None:
        """Pass over what is left of the cell."""
        self._messages.clear()

    def is_alive(self) -> bool:
        """Whether it has not been stopped."""
        return self._alive

    def stop(self) -> None:
        """Repeat nothing more."""
        self._alive = False

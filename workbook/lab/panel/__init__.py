"""The panel beside a notebook: the robot, the graph and the topics of the notebook's domain.

`observer` is a process that watches a domain, `server` the part of JupyterLab's server that starts it and passes on
what it tells; `workbook/lab/front_end/panel/` draws that. None of it subscribes to a topic: see `workbook.inside.tap`.
"""

from typing import Any


def _jupyter_server_extension_points() -> list[dict[str, str]]:
    return [{"module": "workbook.lab.panel"}]


def _load_jupyter_server_extension(app: Any) -> None:
    from workbook.lab.panel.server import add_handlers

    add_handlers(app)

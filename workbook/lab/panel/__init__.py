"""Show the panel next to a notebook: the robot, the graph, and the topics of the notebook's domain.

The `observer` process watches a domain. `server`, part of JupyterLab's server, starts it and forwards its reports.
`workbook/lab/front_end/panel/` draws them. None of these subscribes to a topic; `workbook.inside.tap` explains how they
get the messages.
"""

from typing import Any


def _jupyter_server_extension_points() -> list[dict[str, str]]:
    return [{"module": "workbook.lab.panel"}]


def _load_jupyter_server_extension(app: Any) -> None:
    from workbook.lab.panel.server import add_handlers

    add_handlers(app)

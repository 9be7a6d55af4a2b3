"""Read the data that JupyterLab's front end sends with the running cell, and send data back.

The front end draws predictions (workbook/lab/front_end/predictions) and robots (workbook/lab/front_end/panel/cell.js).
Other front ends don't send any data.
"""

from typing import Any

from IPython.core.getipython import get_ipython

PREDICTION_PAYLOAD = "workbook_prediction"


def request() -> dict[str, Any]:
    """Return the message that requested the running cell, or an empty dictionary outside of a kernel."""
    found: dict[str, Any] = getattr(get_ipython(), "get_parent", dict)()
    return found


def front_end_data() -> dict[str, Any]:
    """Return the data that our front end sent with the running cell, or an empty dictionary with other front ends."""
    found = request().get("metadata", {}).get("workbook")
    return found if isinstance(found, dict) else {}


def asked() -> dict[str, Any] | None:
    """Return the prediction for which the front end draws buttons in the running cell, or None if it draws none.

    The keys are `name` and, after a click, `choice`.
    """
    found = front_end_data().get("prediction")
    return found if isinstance(found, dict) else None


def show_prediction(name: str, choice: str | None, words: str, outcome: str | None) -> None:
    """Send a prediction's state to its buttons: the choice, a line of text, and the outcome's letter.

    `outcome`: None until the reader has seen the outcome.
    """
    payloads = getattr(get_ipython(), "payload_manager", None)
    if payloads is not None and front_end_data():
        state = {"name": name, "choice": choice, "words": words, "outcome": outcome}
        payloads.write_payload({"source": PREDICTION_PAYLOAD, **state}, single=False)

"""Store the predictions' outcomes and explanations in `sealed/`, so that readers don't see them by accident.

`make notebooks` writes one file per lesson from the lesson's text. The files are encoded, not encrypted.
"""

import base64
import json
import os
import textwrap
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path

from workbook.lesson.prediction import Option, Prediction

FOLDER = "WORKBOOK_SEALED"
"""Environment variable that names another folder of sealed files, for a course that isn't the installed one."""
SUFFIX = ".txt"
_FIRST_LINE = "Written by `make notebooks`. It tells what the predictions of this lesson come to."


def seal(predictions: Sequence[Prediction]) -> str:
    """Encode a lesson's predictions as the text of its sealed file. The same predictions always give the same text."""
    data = json.dumps([asdict(one) for one in predictions], sort_keys=True)
    return "\n".join([_FIRST_LINE, *textwrap.wrap(base64.b64encode(data.encode()).decode(), 100), ""])


def unseal(text: str) -> tuple[Prediction, ...]:
    """Decode a sealed file's text into predictions. Raise ValueError if it contains anything else."""
    try:
        data = json.loads(base64.b64decode("".join(text.split("\n")[1:]), validate=True))
        return tuple(
            Prediction(one["name"], tuple(Option(**option) for option in one["options"]), one["usual"])
            for one in data
        )
    except (KeyError, TypeError) as error:
        raise ValueError(f"holds no predictions: {error}") from error


def sealed_folder() -> Path:
    """Return the folder with this course's sealed files."""
    return Path(os.environ.get(FOLDER) or Path(__file__).with_name("sealed"))


def all_predictions() -> dict[str, Prediction]:
    """Load all of the course's predictions, keyed by name. A damaged file counts as empty."""
    found: dict[str, Prediction] = {}
    for path in sorted(sealed_folder().glob(f"[0-9]*{SUFFIX}")):
        try:
            found |= {one.name: one for one in unseal(path.read_text(encoding="utf-8"))}
        except (OSError, ValueError):
            continue
    return found

"""Frozen dataclasses to JSON data and back, by their type hints: for recordings, judgements and results.

Hints that it knows: `str`, `int`, `float`, `bool`, `None`, `Any`, `Literal`, `X | None`, `tuple`, `Mapping[str, X]`,
and dataclasses. A field keeps its name, unless its metadata say otherwise (`stored_as`, `NOT_STORED`,
`STORED_IF_SET`). One with a default may be missing from what an older version wrote, unless it is `ALWAYS_STORED`. A
field that the class does not know is refused; it is kept where the class has a mapping for it (`UNKNOWN_FIELDS`), or
dropped where it says `ignores_unknown_fields: ClassVar[bool] = True`.

In fields that are declared as `Any`, and only there, numbers may be infinite or NaN: `{"float": "nan"}`.
"""

from workbook.recording.decoding import decode
from workbook.recording.encoding import encode
from workbook.recording.stored_fields import (
    ALWAYS_STORED,
    NOT_STORED,
    STORED_IF_SET,
    UNKNOWN_FIELDS,
    Malformed,
    stored_as,
)

__all__ = [
    "ALWAYS_STORED",
    "NOT_STORED",
    "STORED_IF_SET",
    "UNKNOWN_FIELDS",
    "Malformed",
    "decode",
    "encode",
    "stored_as",
]

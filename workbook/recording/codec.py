"""Convert frozen dataclasses, such as recordings, judgments, and results, to JSON data and back by their type hints.

The supported hints are `str`, `int`, `float`, `bool`, `None`, `Any`, `Literal`, `X | None`, `tuple`, `Mapping[str, X]`,
and dataclasses. A field is stored under its name, unless its metadata differ (`stored_as`, `NOT_STORED`,
`STORED_IF_SET`). A field with a default may be missing from an older version's data, unless it's `ALWAYS_STORED`.
Unknown fields raise Malformed. A class can instead keep them in a mapping (`UNKNOWN_FIELDS`), or drop them with
`ignores_unknown_fields: ClassVar[bool] = True`.

Only fields declared as `Any` may contain infinite numbers or NaN, which are stored as `{"float": "nan"}`.
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

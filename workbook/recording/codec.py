"""Convert frozen dataclasses, such as recordings, judgments, and results, to JSON data and back.

The type hints of a class determine how its fields are converted.

The supported hints are `str`, `int`, `float`, `bool`, `None`, `Any`, `Literal`, `X | None`, `tuple`, `Mapping[str, X]`,
and dataclasses. Every field is stored under its own name unless its metadata say otherwise (`stored_as`, `NOT_STORED`,
`STORED_IF_SET`). A field with a default may be missing from data that an older version wrote, unless its metadata are
`ALWAYS_STORED`. Decoding raises Malformed if the data contains unknown fields. A class can instead keep such fields in
a mapping (`UNKNOWN_FIELDS`), or drop them with `ignores_unknown_fields: ClassVar[bool] = True`.

Only fields declared as `Any` may contain infinite numbers or NaN. They're stored in the form `{"float": "nan"}`.
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

# Made by `python -m workbook.authoring typings` from the installed message classes; do not edit.
import std_msgs.msg
from collections.abc import Sequence, Set as AbstractSet
from typing import ClassVar

class DiagnosticArray:
    header: std_msgs.msg.Header
    @property
    def status(self) -> list[DiagnosticStatus]: ...
    @status.setter
    def status(self, value: Sequence[DiagnosticStatus] | AbstractSet[DiagnosticStatus]) -> None: ...
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        status: Sequence[DiagnosticStatus] | AbstractSet[DiagnosticStatus] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class DiagnosticStatus:
    OK: ClassVar[bytes]
    WARN: ClassVar[bytes]
    ERROR: ClassVar[bytes]
    STALE: ClassVar[bytes]
    level: bytes
    name: str
    message: str
    hardware_id: str
    @property
    def values(self) -> list[KeyValue]: ...
    @values.setter
    def values(self, value: Sequence[KeyValue] | AbstractSet[KeyValue]) -> None: ...
    def __init__(
        self,
        *,
        level: bytes = ...,
        name: str = ...,
        message: str = ...,
        hardware_id: str = ...,
        values: Sequence[KeyValue] | AbstractSet[KeyValue] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class KeyValue:
    key: str
    value: str
    def __init__(self, *, key: str = ..., value: str = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

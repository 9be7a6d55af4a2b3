# Made by `python -m workbook.authoring typings` from the installed message classes; do not edit.
import builtin_interfaces.msg
import numpy
from collections.abc import Sequence, Set as AbstractSet
from numpy.typing import NDArray
from typing import ClassVar

class ServiceEventInfo:
    REQUEST_SENT: ClassVar[int]
    REQUEST_RECEIVED: ClassVar[int]
    RESPONSE_SENT: ClassVar[int]
    RESPONSE_RECEIVED: ClassVar[int]
    event_type: int
    stamp: builtin_interfaces.msg.Time
    @property
    def client_gid(self) -> NDArray[numpy.uint8]: ...
    @client_gid.setter
    def client_gid(self, value: NDArray[numpy.uint8] | Sequence[int] | AbstractSet[int]) -> None: ...
    sequence_number: int
    def __init__(
        self,
        *,
        event_type: int = ...,
        stamp: builtin_interfaces.msg.Time = ...,
        client_gid: NDArray[numpy.uint8] | Sequence[int] | AbstractSet[int] = ...,
        sequence_number: int = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

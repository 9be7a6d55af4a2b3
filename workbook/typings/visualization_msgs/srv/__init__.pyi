# Made by `python -m workbook.authoring typings` from the installed message classes; do not edit.
import service_msgs.msg
import visualization_msgs.msg
from collections.abc import Sequence, Set as AbstractSet
from typing import TypeAlias

class GetInteractiveMarkers:
    Request: TypeAlias = GetInteractiveMarkers_Request
    Response: TypeAlias = GetInteractiveMarkers_Response
    Event: TypeAlias = GetInteractiveMarkers_Event

class GetInteractiveMarkers_Event:
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[GetInteractiveMarkers_Request]: ...
    @request.setter
    def request(self, value: Sequence[GetInteractiveMarkers_Request] | AbstractSet[GetInteractiveMarkers_Request]) -> None: ...
    @property
    def response(self) -> list[GetInteractiveMarkers_Response]: ...
    @response.setter
    def response(self, value: Sequence[GetInteractiveMarkers_Response] | AbstractSet[GetInteractiveMarkers_Response]) -> None: ...
    def __init__(
        self,
        *,
        info: service_msgs.msg.ServiceEventInfo = ...,
        request: Sequence[GetInteractiveMarkers_Request] | AbstractSet[GetInteractiveMarkers_Request] = ...,
        response: Sequence[GetInteractiveMarkers_Response] | AbstractSet[GetInteractiveMarkers_Response] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class GetInteractiveMarkers_Request:
    def __init__(self, *, check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class GetInteractiveMarkers_Response:
    sequence_number: int
    @property
    def markers(self) -> list[visualization_msgs.msg.InteractiveMarker]: ...
    @markers.setter
    def markers(self, value: Sequence[visualization_msgs.msg.InteractiveMarker] | AbstractSet[visualization_msgs.msg.InteractiveMarker]) -> None: ...
    def __init__(
        self,
        *,
        sequence_number: int = ...,
        markers: Sequence[visualization_msgs.msg.InteractiveMarker] | AbstractSet[visualization_msgs.msg.InteractiveMarker] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

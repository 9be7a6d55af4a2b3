# Made by `python -m workbook.authoring typings` from the installed message classes; do not edit.
import sensor_msgs.msg
import service_msgs.msg
from collections.abc import Sequence, Set as AbstractSet
from typing import TypeAlias

class SetCameraInfo:
    Request: TypeAlias = SetCameraInfo_Request
    Response: TypeAlias = SetCameraInfo_Response
    Event: TypeAlias = SetCameraInfo_Event

class SetCameraInfo_Event:
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[SetCameraInfo_Request]: ...
    @request.setter
    def request(self, value: Sequence[SetCameraInfo_Request] | AbstractSet[SetCameraInfo_Request]) -> None: ...
    @property
    def response(self) -> list[SetCameraInfo_Response]: ...
    @response.setter
    def response(self, value: Sequence[SetCameraInfo_Response] | AbstractSet[SetCameraInfo_Response]) -> None: ...
    def __init__(
        self,
        *,
        info: service_msgs.msg.ServiceEventInfo = ...,
        request: Sequence[SetCameraInfo_Request] | AbstractSet[SetCameraInfo_Request] = ...,
        response: Sequence[SetCameraInfo_Response] | AbstractSet[SetCameraInfo_Response] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class SetCameraInfo_Request:
    camera_info: sensor_msgs.msg.CameraInfo
    def __init__(
        self,
        *,
        camera_info: sensor_msgs.msg.CameraInfo = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class SetCameraInfo_Response:
    success: bool
    status_message: str
    def __init__(
        self,
        *,
        success: bool = ...,
        status_message: str = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

# Made by `python -m workbook.authoring typings` from the installed message classes; do not edit.
import service_msgs.msg
from collections.abc import Sequence, Set as AbstractSet
from typing import TypeAlias

class Empty:
    Request: TypeAlias = Empty_Request
    Response: TypeAlias = Empty_Response
    Event: TypeAlias = Empty_Event

class Empty_Event:
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[Empty_Request]: ...
    @request.setter
    def request(self, value: Sequence[Empty_Request] | AbstractSet[Empty_Request]) -> None: ...
    @property
    def response(self) -> list[Empty_Response]: ...
    @response.setter
    def response(self, value: Sequence[Empty_Response] | AbstractSet[Empty_Response]) -> None: ...
    def __init__(
        self,
        *,
        info: service_msgs.msg.ServiceEventInfo = ...,
        request: Sequence[Empty_Request] | AbstractSet[Empty_Request] = ...,
        response: Sequence[Empty_Response] | AbstractSet[Empty_Response] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Empty_Request:
    def __init__(self, *, check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Empty_Response:
    def __init__(self, *, check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class SetBool:
    Request: TypeAlias = SetBool_Request
    Response: TypeAlias = SetBool_Response
    Event: TypeAlias = SetBool_Event

class SetBool_Event:
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[SetBool_Request]: ...
    @request.setter
    def request(self, value: Sequence[SetBool_Request] | AbstractSet[SetBool_Request]) -> None: ...
    @property
    def response(self) -> list[SetBool_Response]: ...
    @response.setter
    def response(self, value: Sequence[SetBool_Response] | AbstractSet[SetBool_Response]) -> None: ...
    def __init__(
        self,
        *,
        info: service_msgs.msg.ServiceEventInfo = ...,
        request: Sequence[SetBool_Request] | AbstractSet[SetBool_Request] = ...,
        response: Sequence[SetBool_Response] | AbstractSet[SetBool_Response] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class SetBool_Request:
    data: bool
    def __init__(self, *, data: bool = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class SetBool_Response:
    success: bool
    message: str
    def __init__(self, *, success: bool = ..., message: str = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Trigger:
    Request: TypeAlias = Trigger_Request
    Response: TypeAlias = Trigger_Response
    Event: TypeAlias = Trigger_Event

class Trigger_Event:
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[Trigger_Request]: ...
    @request.setter
    def request(self, value: Sequence[Trigger_Request] | AbstractSet[Trigger_Request]) -> None: ...
    @property
    def response(self) -> list[Trigger_Response]: ...
    @response.setter
    def response(self, value: Sequence[Trigger_Response] | AbstractSet[Trigger_Response]) -> None: ...
    def __init__(
        self,
        *,
        info: service_msgs.msg.ServiceEventInfo = ...,
        request: Sequence[Trigger_Request] | AbstractSet[Trigger_Request] = ...,
        response: Sequence[Trigger_Response] | AbstractSet[Trigger_Response] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Trigger_Request:
    def __init__(self, *, check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Trigger_Response:
    success: bool
    message: str
    def __init__(self, *, success: bool = ..., message: str = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

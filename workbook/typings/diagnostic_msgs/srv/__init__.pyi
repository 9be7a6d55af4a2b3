# Made by `python -m workbook.authoring typings` from the installed message classes; do not edit.
import diagnostic_msgs.msg
import service_msgs.msg
from collections.abc import Sequence, Set as AbstractSet
from typing import TypeAlias

class AddDiagnostics:
    Request: TypeAlias = AddDiagnostics_Request
    Response: TypeAlias = AddDiagnostics_Response
    Event: TypeAlias = AddDiagnostics_Event

class AddDiagnostics_Event:
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[AddDiagnostics_Request]: ...
    @request.setter
    def request(self, value: Sequence[AddDiagnostics_Request] | AbstractSet[AddDiagnostics_Request]) -> None: ...
    @property
    def response(self) -> list[AddDiagnostics_Response]: ...
    @response.setter
    def response(self, value: Sequence[AddDiagnostics_Response] | AbstractSet[AddDiagnostics_Response]) -> None: ...
    def __init__(
        self,
        *,
        info: service_msgs.msg.ServiceEventInfo = ...,
        request: Sequence[AddDiagnostics_Request] | AbstractSet[AddDiagnostics_Request] = ...,
        response: Sequence[AddDiagnostics_Response] | AbstractSet[AddDiagnostics_Response] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class AddDiagnostics_Request:
    load_namespace: str
    def __init__(self, *, load_namespace: str = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class AddDiagnostics_Response:
    success: bool
    message: str
    def __init__(self, *, success: bool = ..., message: str = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class SelfTest:
    Request: TypeAlias = SelfTest_Request
    Response: TypeAlias = SelfTest_Response
    Event: TypeAlias = SelfTest_Event

class SelfTest_Event:
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[SelfTest_Request]: ...
    @request.setter
    def request(self, value: Sequence[SelfTest_Request] | AbstractSet[SelfTest_Request]) -> None: ...
    @property
    def response(self) -> list[SelfTest_Response]: ...
    @response.setter
    def response(self, value: Sequence[SelfTest_Response] | AbstractSet[SelfTest_Response]) -> None: ...
    def __init__(
        self,
        *,
        info: service_msgs.msg.ServiceEventInfo = ...,
        request: Sequence[SelfTest_Request] | AbstractSet[SelfTest_Request] = ...,
        response: Sequence[SelfTest_Response] | AbstractSet[SelfTest_Response] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class SelfTest_Request:
    def __init__(self, *, check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class SelfTest_Response:
    id: str
    passed: bytes
    @property
    def status(self) -> list[diagnostic_msgs.msg.DiagnosticStatus]: ...
    @status.setter
    def status(self, value: Sequence[diagnostic_msgs.msg.DiagnosticStatus] | AbstractSet[diagnostic_msgs.msg.DiagnosticStatus]) -> None: ...
    def __init__(
        self,
        *,
        id: str = ...,
        passed: bytes = ...,
        status: Sequence[diagnostic_msgs.msg.DiagnosticStatus] | AbstractSet[diagnostic_msgs.msg.DiagnosticStatus] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

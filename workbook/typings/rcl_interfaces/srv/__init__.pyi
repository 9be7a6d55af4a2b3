# Made by `python -m workbook.authoring typings` from the installed message classes; do not edit.
import rcl_interfaces.msg
import service_msgs.msg
from array import array
from collections.abc import Sequence, Set as AbstractSet
from typing import ClassVar
from typing import TypeAlias

class DescribeParameters:
    Request: TypeAlias = DescribeParameters_Request
    Response: TypeAlias = DescribeParameters_Response
    Event: TypeAlias = DescribeParameters_Event

class DescribeParameters_Event:
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[DescribeParameters_Request]: ...
    @request.setter
    def request(self, value: Sequence[DescribeParameters_Request] | AbstractSet[DescribeParameters_Request]) -> None: ...
    @property
    def response(self) -> list[DescribeParameters_Response]: ...
    @response.setter
    def response(self, value: Sequence[DescribeParameters_Response] | AbstractSet[DescribeParameters_Response]) -> None: ...
    def __init__(
        self,
        *,
        info: service_msgs.msg.ServiceEventInfo = ...,
        request: Sequence[DescribeParameters_Request] | AbstractSet[DescribeParameters_Request] = ...,
        response: Sequence[DescribeParameters_Response] | AbstractSet[DescribeParameters_Response] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class DescribeParameters_Request:
    @property
    def names(self) -> list[str]: ...
    @names.setter
    def names(self, value: list[str] | tuple[str, ...] | AbstractSet[str]) -> None: ...
    def __init__(
        self,
        *,
        names: list[str] | tuple[str, ...] | AbstractSet[str] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class DescribeParameters_Response:
    @property
    def descriptors(self) -> list[rcl_interfaces.msg.ParameterDescriptor]: ...
    @descriptors.setter
    def descriptors(self, value: Sequence[rcl_interfaces.msg.ParameterDescriptor] | AbstractSet[rcl_interfaces.msg.ParameterDescriptor]) -> None: ...
    def __init__(
        self,
        *,
        descriptors: Sequence[rcl_interfaces.msg.ParameterDescriptor] | AbstractSet[rcl_interfaces.msg.ParameterDescriptor] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class GetLoggerLevels:
    Request: TypeAlias = GetLoggerLevels_Request
    Response: TypeAlias = GetLoggerLevels_Response
    Event: TypeAlias = GetLoggerLevels_Event

class GetLoggerLevels_Event:
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[GetLoggerLevels_Request]: ...
    @request.setter
    def request(self, value: Sequence[GetLoggerLevels_Request] | AbstractSet[GetLoggerLevels_Request]) -> None: ...
    @property
    def response(self) -> list[GetLoggerLevels_Response]: ...
    @response.setter
    def response(self, value: Sequence[GetLoggerLevels_Response] | AbstractSet[GetLoggerLevels_Response]) -> None: ...
    def __init__(
        self,
        *,
        info: service_msgs.msg.ServiceEventInfo = ...,
        request: Sequence[GetLoggerLevels_Request] | AbstractSet[GetLoggerLevels_Request] = ...,
        response: Sequence[GetLoggerLevels_Response] | AbstractSet[GetLoggerLevels_Response] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class GetLoggerLevels_Request:
    @property
    def names(self) -> list[str]: ...
    @names.setter
    def names(self, value: list[str] | tuple[str, ...] | AbstractSet[str]) -> None: ...
    def __init__(
        self,
        *,
        names: list[str] | tuple[str, ...] | AbstractSet[str] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class GetLoggerLevels_Response:
    @property
    def levels(self) -> list[rcl_interfaces.msg.LoggerLevel]: ...
    @levels.setter
    def levels(self, value: Sequence[rcl_interfaces.msg.LoggerLevel] | AbstractSet[rcl_interfaces.msg.LoggerLevel]) -> None: ...
    def __init__(
        self,
        *,
        levels: Sequence[rcl_interfaces.msg.LoggerLevel] | AbstractSet[rcl_interfaces.msg.LoggerLevel] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class GetParameterTypes:
    Request: TypeAlias = GetParameterTypes_Request
    Response: TypeAlias = GetParameterTypes_Response
    Event: TypeAlias = GetParameterTypes_Event

class GetParameterTypes_Event:
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[GetParameterTypes_Request]: ...
    @request.setter
    def request(self, value: Sequence[GetParameterTypes_Request] | AbstractSet[GetParameterTypes_Request]) -> None: ...
    @property
    def response(self) -> list[GetParameterTypes_Response]: ...
    @response.setter
    def response(self, value: Sequence[GetParameterTypes_Response] | AbstractSet[GetParameterTypes_Response]) -> None: ...
    def __init__(
        self,
        *,
        info: service_msgs.msg.ServiceEventInfo = ...,
        request: Sequence[GetParameterTypes_Request] | AbstractSet[GetParameterTypes_Request] = ...,
        response: Sequence[GetParameterTypes_Response] | AbstractSet[GetParameterTypes_Response] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class GetParameterTypes_Request:
    @property
    def names(self) -> list[str]: ...
    @names.setter
    def names(self, value: list[str] | tuple[str, ...] | AbstractSet[str]) -> None: ...
    def __init__(
        self,
        *,
        names: list[str] | tuple[str, ...] | AbstractSet[str] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class GetParameterTypes_Response:
    @property
    def types(self) -> array[int]: ...
    @types.setter
    def types(self, value: Sequence[int] | AbstractSet[int]) -> None: ...
    def __init__(
        self,
        *,
        types: Sequence[int] | AbstractSet[int] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class GetParameters:
    Request: TypeAlias = GetParameters_Request
    Response: TypeAlias = GetParameters_Response
    Event: TypeAlias = GetParameters_Event

class GetParameters_Event:
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[GetParameters_Request]: ...
    @request.setter
    def request(self, value: Sequence[GetParameters_Request] | AbstractSet[GetParameters_Request]) -> None: ...
    @property
    def response(self) -> list[GetParameters_Response]: ...
    @response.setter
    def response(self, value: Sequence[GetParameters_Response] | AbstractSet[GetParameters_Response]) -> None: ...
    def __init__(
        self,
        *,
        info: service_msgs.msg.ServiceEventInfo = ...,
        request: Sequence[GetParameters_Request] | AbstractSet[GetParameters_Request] = ...,
        response: Sequence[GetParameters_Response] | AbstractSet[GetParameters_Response] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class GetParameters_Request:
    @property
    def names(self) -> list[str]: ...
    @names.setter
    def names(self, value: list[str] | tuple[str, ...] | AbstractSet[str]) -> None: ...
    def __init__(
        self,
        *,
        names: list[str] | tuple[str, ...] | AbstractSet[str] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class GetParameters_Response:
    @property
    def values(self) -> list[rcl_interfaces.msg.ParameterValue]: ...
    @values.setter
    def values(self, value: Sequence[rcl_interfaces.msg.ParameterValue] | AbstractSet[rcl_interfaces.msg.ParameterValue]) -> None: ...
    def __init__(
        self,
        *,
        values: Sequence[rcl_interfaces.msg.ParameterValue] | AbstractSet[rcl_interfaces.msg.ParameterValue] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class ListParameters:
    Request: TypeAlias = ListParameters_Request
    Response: TypeAlias = ListParameters_Response
    Event: TypeAlias = ListParameters_Event

class ListParameters_Event:
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[ListParameters_Request]: ...
    @request.setter
    def request(self, value: Sequence[ListParameters_Request] | AbstractSet[ListParameters_Request]) -> None: ...
    @property
    def response(self) -> list[ListParameters_Response]: ...
    @response.setter
    def response(self, value: Sequence[ListParameters_Response] | AbstractSet[ListParameters_Response]) -> None: ...
    def __init__(
        self,
        *,
        info: service_msgs.msg.ServiceEventInfo = ...,
        request: Sequence[ListParameters_Request] | AbstractSet[ListParameters_Request] = ...,
        response: Sequence[ListParameters_Response] | AbstractSet[ListParameters_Response] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class ListParameters_Request:
    DEPTH_RECURSIVE: ClassVar[int]
    @property
    def prefixes(self) -> list[str]: ...
    @prefixes.setter
    def prefixes(self, value: list[str] | tuple[str, ...] | AbstractSet[str]) -> None: ...
    depth: int
    def __init__(
        self,
        *,
        prefixes: list[str] | tuple[str, ...] | AbstractSet[str] = ...,
        depth: int = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class ListParameters_Response:
    result: rcl_interfaces.msg.ListParametersResult
    def __init__(
        self,
        *,
        result: rcl_interfaces.msg.ListParametersResult = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class SetLoggerLevels:
    Request: TypeAlias = SetLoggerLevels_Request
    Response: TypeAlias = SetLoggerLevels_Response
    Event: TypeAlias = SetLoggerLevels_Event

class SetLoggerLevels_Event:
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[SetLoggerLevels_Request]: ...
    @request.setter
    def request(self, value: Sequence[SetLoggerLevels_Request] | AbstractSet[SetLoggerLevels_Request]) -> None: ...
    @property
    def response(self) -> list[SetLoggerLevels_Response]: ...
    @response.setter
    def response(self, value: Sequence[SetLoggerLevels_Response] | AbstractSet[SetLoggerLevels_Response]) -> None: ...
    def __init__(
        self,
        *,
        info: service_msgs.msg.ServiceEventInfo = ...,
        request: Sequence[SetLoggerLevels_Request] | AbstractSet[SetLoggerLevels_Request] = ...,
        response: Sequence[SetLoggerLevels_Response] | AbstractSet[SetLoggerLevels_Response] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class SetLoggerLevels_Request:
    @property
    def levels(self) -> list[rcl_interfaces.msg.LoggerLevel]: ...
    @levels.setter
    def levels(self, value: Sequence[rcl_interfaces.msg.LoggerLevel] | AbstractSet[rcl_interfaces.msg.LoggerLevel]) -> None: ...
    def __init__(
        self,
        *,
        levels: Sequence[rcl_interfaces.msg.LoggerLevel] | AbstractSet[rcl_interfaces.msg.LoggerLevel] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class SetLoggerLevels_Response:
    @property
    def results(self) -> list[rcl_interfaces.msg.SetLoggerLevelsResult]: ...
    @results.setter
    def results(self, value: Sequence[rcl_interfaces.msg.SetLoggerLevelsResult] | AbstractSet[rcl_interfaces.msg.SetLoggerLevelsResult]) -> None: ...
    def __init__(
        self,
        *,
        results: Sequence[rcl_interfaces.msg.SetLoggerLevelsResult] | AbstractSet[rcl_interfaces.msg.SetLoggerLevelsResult] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class SetParameters:
    Request: TypeAlias = SetParameters_Request
    Response: TypeAlias = SetParameters_Response
    Event: TypeAlias = SetParameters_Event

class SetParametersAtomically:
    Request: TypeAlias = SetParametersAtomically_Request
    Response: TypeAlias = SetParametersAtomically_Response
    Event: TypeAlias = SetParametersAtomically_Event

class SetParametersAtomically_Event:
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[SetParametersAtomically_Request]: ...
    @request.setter
    def request(self, value: Sequence[SetParametersAtomically_Request] | AbstractSet[SetParametersAtomically_Request]) -> None: ...
    @property
    def response(self) -> list[SetParametersAtomically_Response]: ...
    @response.setter
    def response(self, value: Sequence[SetParametersAtomically_Response] | AbstractSet[SetParametersAtomically_Response]) -> None: ...
    def __init__(
        self,
        *,
        info: service_msgs.msg.ServiceEventInfo = ...,
        request: Sequence[SetParametersAtomically_Request] | AbstractSet[SetParametersAtomically_Request] = ...,
        response: Sequence[SetParametersAtomically_Response] | AbstractSet[SetParametersAtomically_Response] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class SetParametersAtomically_Request:
    @property
    def parameters(self) -> list[rcl_interfaces.msg.Parameter]: ...
    @parameters.setter
    def parameters(self, value: Sequence[rcl_interfaces.msg.Parameter] | AbstractSet[rcl_interfaces.msg.Parameter]) -> None: ...
    def __init__(
        self,
        *,
        parameters: Sequence[rcl_interfaces.msg.Parameter] | AbstractSet[rcl_interfaces.msg.Parameter] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class SetParametersAtomically_Response:
    result: rcl_interfaces.msg.SetParametersResult
    def __init__(
        self,
        *,
        result: rcl_interfaces.msg.SetParametersResult = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class SetParameters_Event:
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[SetParameters_Request]: ...
    @request.setter
    def request(self, value: Sequence[SetParameters_Request] | AbstractSet[SetParameters_Request]) -> None: ...
    @property
    def response(self) -> list[SetParameters_Response]: ...
    @response.setter
    def response(self, value: Sequence[SetParameters_Response] | AbstractSet[SetParameters_Response]) -> None: ...
    def __init__(
        self,
        *,
        info: service_msgs.msg.ServiceEventInfo = ...,
        request: Sequence[SetParameters_Request] | AbstractSet[SetParameters_Request] = ...,
        response: Sequence[SetParameters_Response] | AbstractSet[SetParameters_Response] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class SetParameters_Request:
    @property
    def parameters(self) -> list[rcl_interfaces.msg.Parameter]: ...
    @parameters.setter
    def parameters(self, value: Sequence[rcl_interfaces.msg.Parameter] | AbstractSet[rcl_interfaces.msg.Parameter]) -> None: ...
    def __init__(
        self,
        *,
        parameters: Sequence[rcl_interfaces.msg.Parameter] | AbstractSet[rcl_interfaces.msg.Parameter] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class SetParameters_Response:
    @property
    def results(self) -> list[rcl_interfaces.msg.SetParametersResult]: ...
    @results.setter
    def results(self, value: Sequence[rcl_interfaces.msg.SetParametersResult] | AbstractSet[rcl_interfaces.msg.SetParametersResult]) -> None: ...
    def __init__(
        self,
        *,
        results: Sequence[rcl_interfaces.msg.SetParametersResult] | AbstractSet[rcl_interfaces.msg.SetParametersResult] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

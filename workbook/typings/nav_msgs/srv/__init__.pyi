# Made by `python -m workbook.authoring typings` from the installed message classes; do not edit.
import geometry_msgs.msg
import nav_msgs.msg
import service_msgs.msg
from collections.abc import Sequence, Set as AbstractSet
from typing import ClassVar
from typing import TypeAlias

class GetMap:
    Request: TypeAlias = GetMap_Request
    Response: TypeAlias = GetMap_Response
    Event: TypeAlias = GetMap_Event

class GetMap_Event:
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[GetMap_Request]: ...
    @request.setter
    def request(self, value: Sequence[GetMap_Request] | AbstractSet[GetMap_Request]) -> None: ...
    @property
    def response(self) -> list[GetMap_Response]: ...
    @response.setter
    def response(self, value: Sequence[GetMap_Response] | AbstractSet[GetMap_Response]) -> None: ...
    def __init__(
        self,
        *,
        info: service_msgs.msg.ServiceEventInfo = ...,
        request: Sequence[GetMap_Request] | AbstractSet[GetMap_Request] = ...,
        response: Sequence[GetMap_Response] | AbstractSet[GetMap_Response] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class GetMap_Request:
    def __init__(self, *, check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class GetMap_Response:
    map: nav_msgs.msg.OccupancyGrid
    def __init__(self, *, map: nav_msgs.msg.OccupancyGrid = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class GetPlan:
    Request: TypeAlias = GetPlan_Request
    Response: TypeAlias = GetPlan_Response
    Event: TypeAlias = GetPlan_Event

class GetPlan_Event:
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[GetPlan_Request]: ...
    @request.setter
    def request(self, value: Sequence[GetPlan_Request] | AbstractSet[GetPlan_Request]) -> None: ...
    @property
    def response(self) -> list[GetPlan_Response]: ...
    @response.setter
    def response(self, value: Sequence[GetPlan_Response] | AbstractSet[GetPlan_Response]) -> None: ...
    def __init__(
        self,
        *,
        info: service_msgs.msg.ServiceEventInfo = ...,
        request: Sequence[GetPlan_Request] | AbstractSet[GetPlan_Request] = ...,
        response: Sequence[GetPlan_Response] | AbstractSet[GetPlan_Response] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class GetPlan_Request:
    start: geometry_msgs.msg.PoseStamped
    goal: geometry_msgs.msg.PoseStamped
    tolerance: float
    def __init__(
        self,
        *,
        start: geometry_msgs.msg.PoseStamped = ...,
        goal: geometry_msgs.msg.PoseStamped = ...,
        tolerance: float = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class GetPlan_Response:
    plan: nav_msgs.msg.Path
    def __init__(self, *, plan: nav_msgs.msg.Path = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class LoadMap:
    Request: TypeAlias = LoadMap_Request
    Response: TypeAlias = LoadMap_Response
    Event: TypeAlias = LoadMap_Event

class LoadMap_Event:
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[LoadMap_Request]: ...
    @request.setter
    def request(self, value: Sequence[LoadMap_Request] | AbstractSet[LoadMap_Request]) -> None: ...
    @property
    def response(self) -> list[LoadMap_Response]: ...
    @response.setter
    def response(self, value: Sequence[LoadMap_Response] | AbstractSet[LoadMap_Response]) -> None: ...
    def __init__(
        self,
        *,
        info: service_msgs.msg.ServiceEventInfo = ...,
        request: Sequence[LoadMap_Request] | AbstractSet[LoadMap_Request] = ...,
        response: Sequence[LoadMap_Response] | AbstractSet[LoadMap_Response] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class LoadMap_Request:
    map_url: str
    def __init__(self, *, map_url: str = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class LoadMap_Response:
    RESULT_SUCCESS: ClassVar[int]
    RESULT_MAP_DOES_NOT_EXIST: ClassVar[int]
    RESULT_INVALID_MAP_DATA: ClassVar[int]
    RESULT_INVALID_MAP_METADATA: ClassVar[int]
    RESULT_UNDEFINED_FAILURE: ClassVar[int]
    map: nav_msgs.msg.OccupancyGrid
    result: int
    def __init__(
        self,
        *,
        map: nav_msgs.msg.OccupancyGrid = ...,
        result: int = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class SetMap:
    Request: TypeAlias = SetMap_Request
    Response: TypeAlias = SetMap_Response
    Event: TypeAlias = SetMap_Event

class SetMap_Event:
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[SetMap_Request]: ...
    @request.setter
    def request(self, value: Sequence[SetMap_Request] | AbstractSet[SetMap_Request]) -> None: ...
    @property
    def response(self) -> list[SetMap_Response]: ...
    @response.setter
    def response(self, value: Sequence[SetMap_Response] | AbstractSet[SetMap_Response]) -> None: ...
    def __init__(
        self,
        *,
        info: service_msgs.msg.ServiceEventInfo = ...,
        request: Sequence[SetMap_Request] | AbstractSet[SetMap_Request] = ...,
        response: Sequence[SetMap_Response] | AbstractSet[SetMap_Response] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class SetMap_Request:
    map: nav_msgs.msg.OccupancyGrid
    initial_pose: geometry_msgs.msg.PoseWithCovarianceStamped
    def __init__(
        self,
        *,
        map: nav_msgs.msg.OccupancyGrid = ...,
        initial_pose: geometry_msgs.msg.PoseWithCovarianceStamped = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class SetMap_Response:
    success: bool
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

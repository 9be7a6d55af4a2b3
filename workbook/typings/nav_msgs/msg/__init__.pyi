# Made by `python -m workbook.authoring typings` from the installed message classes; do not edit.
import builtin_interfaces.msg
import geometry_msgs.msg
import std_msgs.msg
from array import array
from collections.abc import Sequence, Set as AbstractSet

class Goals:
    header: std_msgs.msg.Header
    @property
    def goals(self) -> list[geometry_msgs.msg.PoseStamped]: ...
    @goals.setter
    def goals(self, value: Sequence[geometry_msgs.msg.PoseStamped] | AbstractSet[geometry_msgs.msg.PoseStamped]) -> None: ...
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        goals: Sequence[geometry_msgs.msg.PoseStamped] | AbstractSet[geometry_msgs.msg.PoseStamped] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class GridCells:
    header: std_msgs.msg.Header
    cell_width: float
    cell_height: float
    @property
    def cells(self) -> list[geometry_msgs.msg.Point]: ...
    @cells.setter
    def cells(self, value: Sequence[geometry_msgs.msg.Point] | AbstractSet[geometry_msgs.msg.Point]) -> None: ...
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        cell_width: float = ...,
        cell_height: float = ...,
        cells: Sequence[geometry_msgs.msg.Point] | AbstractSet[geometry_msgs.msg.Point] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class MapMetaData:
    map_load_time: builtin_interfaces.msg.Time
    resolution: float
    width: int
    height: int
    origin: geometry_msgs.msg.Pose
    def __init__(
        self,
        *,
        map_load_time: builtin_interfaces.msg.Time = ...,
        resolution: float = ...,
        width: int = ...,
        height: int = ...,
        origin: geometry_msgs.msg.Pose = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class OccupancyGrid:
    header: std_msgs.msg.Header
    info: MapMetaData
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Sequence[int] | AbstractSet[int]) -> None: ...
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        info: MapMetaData = ...,
        data: Sequence[int] | AbstractSet[int] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Odometry:
    header: std_msgs.msg.Header
    child_frame_id: str
    pose: geometry_msgs.msg.PoseWithCovariance
    twist: geometry_msgs.msg.TwistWithCovariance
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        child_frame_id: str = ...,
        pose: geometry_msgs.msg.PoseWithCovariance = ...,
        twist: geometry_msgs.msg.TwistWithCovariance = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Path:
    header: std_msgs.msg.Header
    @property
    def poses(self) -> list[geometry_msgs.msg.PoseStamped]: ...
    @poses.setter
    def poses(self, value: Sequence[geometry_msgs.msg.PoseStamped] | AbstractSet[geometry_msgs.msg.PoseStamped]) -> None: ...
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        poses: Sequence[geometry_msgs.msg.PoseStamped] | AbstractSet[geometry_msgs.msg.PoseStamped] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

# Made by `python -m workbook.authoring typings` from the installed message classes; do not edit.
import builtin_interfaces.msg
import geometry_msgs.msg
import sensor_msgs.msg
import std_msgs.msg
from array import array
from collections.abc import Sequence, Set as AbstractSet
from typing import ClassVar

class ImageMarker:
    CIRCLE: ClassVar[int]
    LINE_STRIP: ClassVar[int]
    LINE_LIST: ClassVar[int]
    POLYGON: ClassVar[int]
    POINTS: ClassVar[int]
    ADD: ClassVar[int]
    REMOVE: ClassVar[int]
    header: std_msgs.msg.Header
    ns: str
    id: int
    type: int
    action: int
    position: geometry_msgs.msg.Point
    scale: float
    outline_color: std_msgs.msg.ColorRGBA
    filled: int
    fill_color: std_msgs.msg.ColorRGBA
    lifetime: builtin_interfaces.msg.Duration
    @property
    def points(self) -> list[geometry_msgs.msg.Point]: ...
    @points.setter
    def points(self, value: Sequence[geometry_msgs.msg.Point] | AbstractSet[geometry_msgs.msg.Point]) -> None: ...
    @property
    def outline_colors(self) -> list[std_msgs.msg.ColorRGBA]: ...
    @outline_colors.setter
    def outline_colors(self, value: Sequence[std_msgs.msg.ColorRGBA] | AbstractSet[std_msgs.msg.ColorRGBA]) -> None: ...
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        ns: str = ...,
        id: int = ...,
        type: int = ...,
        action: int = ...,
        position: geometry_msgs.msg.Point = ...,
        scale: float = ...,
        outline_color: std_msgs.msg.ColorRGBA = ...,
        filled: int = ...,
        fill_color: std_msgs.msg.ColorRGBA = ...,
        lifetime: builtin_interfaces.msg.Duration = ...,
        points: Sequence[geometry_msgs.msg.Point] | AbstractSet[geometry_msgs.msg.Point] = ...,
        outline_colors: Sequence[std_msgs.msg.ColorRGBA] | AbstractSet[std_msgs.msg.ColorRGBA] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class InteractiveMarker:
    header: std_msgs.msg.Header
    pose: geometry_msgs.msg.Pose
    name: str
    description: str
    scale: float
    @property
    def menu_entries(self) -> list[MenuEntry]: ...
    @menu_entries.setter
    def menu_entries(self, value: Sequence[MenuEntry] | AbstractSet[MenuEntry]) -> None: ...
    @property
    def controls(self) -> list[InteractiveMarkerControl]: ...
    @controls.setter
    def controls(self, value: Sequence[InteractiveMarkerControl] | AbstractSet[InteractiveMarkerControl]) -> None: ...
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        pose: geometry_msgs.msg.Pose = ...,
        name: str = ...,
        description: str = ...,
        scale: float = ...,
        menu_entries: Sequence[MenuEntry] | AbstractSet[MenuEntry] = ...,
        controls: Sequence[InteractiveMarkerControl] | AbstractSet[InteractiveMarkerControl] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class InteractiveMarkerControl:
    INHERIT: ClassVar[int]
    FIXED: ClassVar[int]
    VIEW_FACING: ClassVar[int]
    NONE: ClassVar[int]
    MENU: ClassVar[int]
    BUTTON: ClassVar[int]
    MOVE_AXIS: ClassVar[int]
    MOVE_PLANE: ClassVar[int]
    ROTATE_AXIS: ClassVar[int]
    MOVE_ROTATE: ClassVar[int]
    MOVE_3D: ClassVar[int]
    ROTATE_3D: ClassVar[int]
    MOVE_ROTATE_3D: ClassVar[int]
    name: str
    orientation: geometry_msgs.msg.Quaternion
    orientation_mode: int
    interaction_mode: int
    always_visible: bool
    @property
    def markers(self) -> list[Marker]: ...
    @markers.setter
    def markers(self, value: Sequence[Marker] | AbstractSet[Marker]) -> None: ...
    independent_marker_orientation: bool
    description: str
    def __init__(
        self,
        *,
        name: str = ...,
        orientation: geometry_msgs.msg.Quaternion = ...,
        orientation_mode: int = ...,
        interaction_mode: int = ...,
        always_visible: bool = ...,
        markers: Sequence[Marker] | AbstractSet[Marker] = ...,
        independent_marker_orientation: bool = ...,
        description: str = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class InteractiveMarkerFeedback:
    KEEP_ALIVE: ClassVar[int]
    POSE_UPDATE: ClassVar[int]
    MENU_SELECT: ClassVar[int]
    BUTTON_CLICK: ClassVar[int]
    MOUSE_DOWN: ClassVar[int]
    MOUSE_UP: ClassVar[int]
    header: std_msgs.msg.Header
    client_id: str
    marker_name: str
    control_name: str
    event_type: int
    pose: geometry_msgs.msg.Pose
    menu_entry_id: int
    mouse_point: geometry_msgs.msg.Point
    mouse_point_valid: bool
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        client_id: str = ...,
        marker_name: str = ...,
        control_name: str = ...,
        event_type: int = ...,
        pose: geometry_msgs.msg.Pose = ...,
        menu_entry_id: int = ...,
        mouse_point: geometry_msgs.msg.Point = ...,
        mouse_point_valid: bool = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class InteractiveMarkerInit:
    server_id: str
    seq_num: int
    @property
    def markers(self) -> list[InteractiveMarker]: ...
    @markers.setter
    def markers(self, value: Sequence[InteractiveMarker] | AbstractSet[InteractiveMarker]) -> None: ...
    def __init__(
        self,
        *,
        server_id: str = ...,
        seq_num: int = ...,
        markers: Sequence[InteractiveMarker] | AbstractSet[InteractiveMarker] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class InteractiveMarkerPose:
    header: std_msgs.msg.Header
    pose: geometry_msgs.msg.Pose
    name: str
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        pose: geometry_msgs.msg.Pose = ...,
        name: str = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class InteractiveMarkerUpdate:
    KEEP_ALIVE: ClassVar[int]
    UPDATE: ClassVar[int]
    server_id: str
    seq_num: int
    type: int
    @property
    def markers(self) -> list[InteractiveMarker]: ...
    @markers.setter
    def markers(self, value: Sequence[InteractiveMarker] | AbstractSet[InteractiveMarker]) -> None: ...
    @property
    def poses(self) -> list[InteractiveMarkerPose]: ...
    @poses.setter
    def poses(self, value: Sequence[InteractiveMarkerPose] | AbstractSet[InteractiveMarkerPose]) -> None: ...
    @property
    def erases(self) -> list[str]: ...
    @erases.setter
    def erases(self, value: list[str] | tuple[str, ...] | AbstractSet[str]) -> None: ...
    def __init__(
        self,
        *,
        server_id: str = ...,
        seq_num: int = ...,
        type: int = ...,
        markers: Sequence[InteractiveMarker] | AbstractSet[InteractiveMarker] = ...,
        poses: Sequence[InteractiveMarkerPose] | AbstractSet[InteractiveMarkerPose] = ...,
        erases: list[str] | tuple[str, ...] | AbstractSet[str] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Marker:
    ARROW: ClassVar[int]
    CUBE: ClassVar[int]
    SPHERE: ClassVar[int]
    CYLINDER: ClassVar[int]
    LINE_STRIP: ClassVar[int]
    LINE_LIST: ClassVar[int]
    CUBE_LIST: ClassVar[int]
    SPHERE_LIST: ClassVar[int]
    POINTS: ClassVar[int]
    TEXT_VIEW_FACING: ClassVar[int]
    MESH_RESOURCE: ClassVar[int]
    TRIANGLE_LIST: ClassVar[int]
    ARROW_STRIP: ClassVar[int]
    ADD: ClassVar[int]
    MODIFY: ClassVar[int]
    DELETE: ClassVar[int]
    DELETEALL: ClassVar[int]
    header: std_msgs.msg.Header
    ns: str
    id: int
    type: int
    action: int
    pose: geometry_msgs.msg.Pose
    scale: geometry_msgs.msg.Vector3
    color: std_msgs.msg.ColorRGBA
    lifetime: builtin_interfaces.msg.Duration
    frame_locked: bool
    @property
    def points(self) -> list[geometry_msgs.msg.Point]: ...
    @points.setter
    def points(self, value: Sequence[geometry_msgs.msg.Point] | AbstractSet[geometry_msgs.msg.Point]) -> None: ...
    @property
    def colors(self) -> list[std_msgs.msg.ColorRGBA]: ...
    @colors.setter
    def colors(self, value: Sequence[std_msgs.msg.ColorRGBA] | AbstractSet[std_msgs.msg.ColorRGBA]) -> None: ...
    texture_resource: str
    texture: sensor_msgs.msg.CompressedImage
    @property
    def uv_coordinates(self) -> list[UVCoordinate]: ...
    @uv_coordinates.setter
    def uv_coordinates(self, value: Sequence[UVCoordinate] | AbstractSet[UVCoordinate]) -> None: ...
    text: str
    mesh_resource: str
    mesh_file: MeshFile
    mesh_use_embedded_materials: bool
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        ns: str = ...,
        id: int = ...,
        type: int = ...,
        action: int = ...,
        pose: geometry_msgs.msg.Pose = ...,
        scale: geometry_msgs.msg.Vector3 = ...,
        color: std_msgs.msg.ColorRGBA = ...,
        lifetime: builtin_interfaces.msg.Duration = ...,
        frame_locked: bool = ...,
        points: Sequence[geometry_msgs.msg.Point] | AbstractSet[geometry_msgs.msg.Point] = ...,
        colors: Sequence[std_msgs.msg.ColorRGBA] | AbstractSet[std_msgs.msg.ColorRGBA] = ...,
        texture_resource: str = ...,
        texture: sensor_msgs.msg.CompressedImage = ...,
        uv_coordinates: Sequence[UVCoordinate] | AbstractSet[UVCoordinate] = ...,
        text: str = ...,
        mesh_resource: str = ...,
        mesh_file: MeshFile = ...,
        mesh_use_embedded_materials: bool = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class MarkerArray:
    @property
    def markers(self) -> list[Marker]: ...
    @markers.setter
    def markers(self, value: Sequence[Marker] | AbstractSet[Marker]) -> None: ...
    def __init__(
        self,
        *,
        markers: Sequence[Marker] | AbstractSet[Marker] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class MenuEntry:
    FEEDBACK: ClassVar[int]
    ROSRUN: ClassVar[int]
    ROSLAUNCH: ClassVar[int]
    id: int
    parent_id: int
    title: str
    command: str
    command_type: int
    def __init__(
        self,
        *,
        id: int = ...,
        parent_id: int = ...,
        title: str = ...,
        command: str = ...,
        command_type: int = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class MeshFile:
    filename: str
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Sequence[int] | AbstractSet[int]) -> None: ...
    def __init__(
        self,
        *,
        filename: str = ...,
        data: Sequence[int] | AbstractSet[int] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class UVCoordinate:
    u: float
    v: float
    def __init__(self, *, u: float = ..., v: float = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

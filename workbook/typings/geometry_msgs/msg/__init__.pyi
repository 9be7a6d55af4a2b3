# Made by `python -m workbook.authoring typings` from the installed message classes; do not edit.
import numpy
import std_msgs.msg
from collections.abc import Sequence, Set as AbstractSet
from numpy.typing import NDArray

class Accel:
    linear: Vector3
    angular: Vector3
    def __init__(
        self,
        *,
        linear: Vector3 = ...,
        angular: Vector3 = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class AccelStamped:
    header: std_msgs.msg.Header
    accel: Accel
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        accel: Accel = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class AccelWithCovariance:
    accel: Accel
    @property
    def covariance(self) -> NDArray[numpy.float64]: ...
    @covariance.setter
    def covariance(self, value: NDArray[numpy.float64] | Sequence[float] | AbstractSet[float]) -> None: ...
    def __init__(
        self,
        *,
        accel: Accel = ...,
        covariance: NDArray[numpy.float64] | Sequence[float] | AbstractSet[float] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class AccelWithCovarianceStamped:
    header: std_msgs.msg.Header
    accel: AccelWithCovariance
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        accel: AccelWithCovariance = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Inertia:
    m: float
    com: Vector3
    ixx: float
    ixy: float
    ixz: float
    iyy: float
    iyz: float
    izz: float
    def __init__(
        self,
        *,
        m: float = ...,
        com: Vector3 = ...,
        ixx: float = ...,
        ixy: float = ...,
        ixz: float = ...,
        iyy: float = ...,
        iyz: float = ...,
        izz: float = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class InertiaStamped:
    header: std_msgs.msg.Header
    inertia: Inertia
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        inertia: Inertia = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Point:
    x: float
    y: float
    z: float
    def __init__(
        self,
        *,
        x: float = ...,
        y: float = ...,
        z: float = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Point32:
    x: float
    y: float
    z: float
    def __init__(
        self,
        *,
        x: float = ...,
        y: float = ...,
        z: float = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class PointStamped:
    header: std_msgs.msg.Header
    point: Point
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        point: Point = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Polygon:
    @property
    def points(self) -> list[Point32]: ...
    @points.setter
    def points(self, value: Sequence[Point32] | AbstractSet[Point32]) -> None: ...
    def __init__(
        self,
        *,
        points: Sequence[Point32] | AbstractSet[Point32] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class PolygonInstance:
    polygon: Polygon
    id: int
    def __init__(self, *, polygon: Polygon = ..., id: int = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class PolygonInstanceStamped:
    header: std_msgs.msg.Header
    polygon: PolygonInstance
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        polygon: PolygonInstance = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class PolygonStamped:
    header: std_msgs.msg.Header
    polygon: Polygon
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        polygon: Polygon = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Pose:
    position: Point
    orientation: Quaternion
    def __init__(
        self,
        *,
        position: Point = ...,
        orientation: Quaternion = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Pose2D:
    x: float
    y: float
    theta: float
    def __init__(
        self,
        *,
        x: float = ...,
        y: float = ...,
        theta: float = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class PoseArray:
    header: std_msgs.msg.Header
    @property
    def poses(self) -> list[Pose]: ...
    @poses.setter
    def poses(self, value: Sequence[Pose] | AbstractSet[Pose]) -> None: ...
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        poses: Sequence[Pose] | AbstractSet[Pose] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class PoseStamped:
    header: std_msgs.msg.Header
    pose: Pose
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        pose: Pose = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class PoseWithCovariance:
    pose: Pose
    @property
    def covariance(self) -> NDArray[numpy.float64]: ...
    @covariance.setter
    def covariance(self, value: NDArray[numpy.float64] | Sequence[float] | AbstractSet[float]) -> None: ...
    def __init__(
        self,
        *,
        pose: Pose = ...,
        covariance: NDArray[numpy.float64] | Sequence[float] | AbstractSet[float] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class PoseWithCovarianceStamped:
    header: std_msgs.msg.Header
    pose: PoseWithCovariance
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        pose: PoseWithCovariance = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Quaternion:
    x: float
    y: float
    z: float
    w: float
    def __init__(
        self,
        *,
        x: float = ...,
        y: float = ...,
        z: float = ...,
        w: float = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class QuaternionStamped:
    header: std_msgs.msg.Header
    quaternion: Quaternion
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        quaternion: Quaternion = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Transform:
    translation: Vector3
    rotation: Quaternion
    def __init__(
        self,
        *,
        translation: Vector3 = ...,
        rotation: Quaternion = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class TransformStamped:
    header: std_msgs.msg.Header
    child_frame_id: str
    transform: Transform
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        child_frame_id: str = ...,
        transform: Transform = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Twist:
    linear: Vector3
    angular: Vector3
    def __init__(
        self,
        *,
        linear: Vector3 = ...,
        angular: Vector3 = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class TwistStamped:
    header: std_msgs.msg.Header
    twist: Twist
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        twist: Twist = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class TwistWithCovariance:
    twist: Twist
    @property
    def covariance(self) -> NDArray[numpy.float64]: ...
    @covariance.setter
    def covariance(self, value: NDArray[numpy.float64] | Sequence[float] | AbstractSet[float]) -> None: ...
    def __init__(
        self,
        *,
        twist: Twist = ...,
        covariance: NDArray[numpy.float64] | Sequence[float] | AbstractSet[float] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class TwistWithCovarianceStamped:
    header: std_msgs.msg.Header
    twist: TwistWithCovariance
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        twist: TwistWithCovariance = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Vector3:
    x: float
    y: float
    z: float
    def __init__(
        self,
        *,
        x: float = ...,
        y: float = ...,
        z: float = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Vector3Stamped:
    header: std_msgs.msg.Header
    vector: Vector3
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        vector: Vector3 = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class VelocityStamped:
    header: std_msgs.msg.Header
    body_frame_id: str
    reference_frame_id: str
    velocity: Twist
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        body_frame_id: str = ...,
        reference_frame_id: str = ...,
        velocity: Twist = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Wrench:
    force: Vector3
    torque: Vector3
    def __init__(self, *, force: Vector3 = ..., torque: Vector3 = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class WrenchStamped:
    header: std_msgs.msg.Header
    wrench: Wrench
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        wrench: Wrench = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

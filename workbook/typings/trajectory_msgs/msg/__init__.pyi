# Made by `python -m workbook.authoring typings` from the installed message classes; do not edit.
import builtin_interfaces.msg
import geometry_msgs.msg
import std_msgs.msg
from array import array
from collections.abc import Sequence, Set as AbstractSet

class JointTrajectory:
    header: std_msgs.msg.Header
    @property
    def joint_names(self) -> list[str]: ...
    @joint_names.setter
    def joint_names(self, value: list[str] | tuple[str, ...] | AbstractSet[str]) -> None: ...
    @property
    def points(self) -> list[JointTrajectoryPoint]: ...
    @points.setter
    def points(self, value: Sequence[JointTrajectoryPoint] | AbstractSet[JointTrajectoryPoint]) -> None: ...
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        joint_names: list[str] | tuple[str, ...] | AbstractSet[str] = ...,
        points: Sequence[JointTrajectoryPoint] | AbstractSet[JointTrajectoryPoint] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class JointTrajectoryPoint:
    @property
    def positions(self) -> array[float]: ...
    @positions.setter
    def positions(self, value: Sequence[float] | AbstractSet[float]) -> None: ...
    @property
    def velocities(self) -> array[float]: ...
    @velocities.setter
    def velocities(self, value: Sequence[float] | AbstractSet[float]) -> None: ...
    @property
    def accelerations(self) -> array[float]: ...
    @accelerations.setter
    def accelerations(self, value: Sequence[float] | AbstractSet[float]) -> None: ...
    @property
    def effort(self) -> array[float]: ...
    @effort.setter
    def effort(self, value: Sequence[float] | AbstractSet[float]) -> None: ...
    time_from_start: builtin_interfaces.msg.Duration
    def __init__(
        self,
        *,
        positions: Sequence[float] | AbstractSet[float] = ...,
        velocities: Sequence[float] | AbstractSet[float] = ...,
        accelerations: Sequence[float] | AbstractSet[float] = ...,
        effort: Sequence[float] | AbstractSet[float] = ...,
        time_from_start: builtin_interfaces.msg.Duration = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class MultiDOFJointTrajectory:
    header: std_msgs.msg.Header
    @property
    def joint_names(self) -> list[str]: ...
    @joint_names.setter
    def joint_names(self, value: list[str] | tuple[str, ...] | AbstractSet[str]) -> None: ...
    @property
    def points(self) -> list[MultiDOFJointTrajectoryPoint]: ...
    @points.setter
    def points(self, value: Sequence[MultiDOFJointTrajectoryPoint] | AbstractSet[MultiDOFJointTrajectoryPoint]) -> None: ...
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        joint_names: list[str] | tuple[str, ...] | AbstractSet[str] = ...,
        points: Sequence[MultiDOFJointTrajectoryPoint] | AbstractSet[MultiDOFJointTrajectoryPoint] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class MultiDOFJointTrajectoryPoint:
    @property
    def transforms(self) -> list[geometry_msgs.msg.Transform]: ...
    @transforms.setter
    def transforms(self, value: Sequence[geometry_msgs.msg.Transform] | AbstractSet[geometry_msgs.msg.Transform]) -> None: ...
    @property
    def velocities(self) -> list[geometry_msgs.msg.Twist]: ...
    @velocities.setter
    def velocities(self, value: Sequence[geometry_msgs.msg.Twist] | AbstractSet[geometry_msgs.msg.Twist]) -> None: ...
    @property
    def accelerations(self) -> list[geometry_msgs.msg.Twist]: ...
    @accelerations.setter
    def accelerations(self, value: Sequence[geometry_msgs.msg.Twist] | AbstractSet[geometry_msgs.msg.Twist]) -> None: ...
    time_from_start: builtin_interfaces.msg.Duration
    def __init__(
        self,
        *,
        transforms: Sequence[geometry_msgs.msg.Transform] | AbstractSet[geometry_msgs.msg.Transform] = ...,
        velocities: Sequence[geometry_msgs.msg.Twist] | AbstractSet[geometry_msgs.msg.Twist] = ...,
        accelerations: Sequence[geometry_msgs.msg.Twist] | AbstractSet[geometry_msgs.msg.Twist] = ...,
        time_from_start: builtin_interfaces.msg.Duration = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

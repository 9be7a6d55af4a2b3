# Made by `python -m workbook.authoring typings` from the installed message classes; do not edit.
import builtin_interfaces.msg
import geometry_msgs.msg
import numpy
import std_msgs.msg
from array import array
from collections.abc import Sequence, Set as AbstractSet
from numpy.typing import NDArray
from typing import ClassVar

class BatteryState:
    POWER_SUPPLY_STATUS_UNKNOWN: ClassVar[int]
    POWER_SUPPLY_STATUS_CHARGING: ClassVar[int]
    POWER_SUPPLY_STATUS_DISCHARGING: ClassVar[int]
    POWER_SUPPLY_STATUS_NOT_CHARGING: ClassVar[int]
    POWER_SUPPLY_STATUS_FULL: ClassVar[int]
    POWER_SUPPLY_HEALTH_UNKNOWN: ClassVar[int]
    POWER_SUPPLY_HEALTH_GOOD: ClassVar[int]
    POWER_SUPPLY_HEALTH_OVERHEAT: ClassVar[int]
    POWER_SUPPLY_HEALTH_DEAD: ClassVar[int]
    POWER_SUPPLY_HEALTH_OVERVOLTAGE: ClassVar[int]
    POWER_SUPPLY_HEALTH_UNSPEC_FAILURE: ClassVar[int]
    POWER_SUPPLY_HEALTH_COLD: ClassVar[int]
    POWER_SUPPLY_HEALTH_WATCHDOG_TIMER_EXPIRE: ClassVar[int]
    POWER_SUPPLY_HEALTH_SAFETY_TIMER_EXPIRE: ClassVar[int]
    POWER_SUPPLY_TECHNOLOGY_UNKNOWN: ClassVar[int]
    POWER_SUPPLY_TECHNOLOGY_NIMH: ClassVar[int]
    POWER_SUPPLY_TECHNOLOGY_LION: ClassVar[int]
    POWER_SUPPLY_TECHNOLOGY_LIPO: ClassVar[int]
    POWER_SUPPLY_TECHNOLOGY_LIFE: ClassVar[int]
    POWER_SUPPLY_TECHNOLOGY_NICD: ClassVar[int]
    POWER_SUPPLY_TECHNOLOGY_LIMN: ClassVar[int]
    POWER_SUPPLY_TECHNOLOGY_TERNARY: ClassVar[int]
    POWER_SUPPLY_TECHNOLOGY_VRLA: ClassVar[int]
    header: std_msgs.msg.Header
    voltage: float
    temperature: float
    current: float
    charge: float
    capacity: float
    design_capacity: float
    percentage: float
    power_supply_status: int
    power_supply_health: int
    power_supply_technology: int
    present: bool
    @property
    def cell_voltage(self) -> array[float]: ...
    @cell_voltage.setter
    def cell_voltage(self, value: Sequence[float] | AbstractSet[float]) -> None: ...
    @property
    def cell_temperature(self) -> array[float]: ...
    @cell_temperature.setter
    def cell_temperature(self, value: Sequence[float] | AbstractSet[float]) -> None: ...
    location: str
    serial_number: str
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        voltage: float = ...,
        temperature: float = ...,
        current: float = ...,
        charge: float = ...,
        capacity: float = ...,
        design_capacity: float = ...,
        percentage: float = ...,
        power_supply_status: int = ...,
        power_supply_health: int = ...,
        power_supply_technology: int = ...,
        present: bool = ...,
        cell_voltage: Sequence[float] | AbstractSet[float] = ...,
        cell_temperature: Sequence[float] | AbstractSet[float] = ...,
        location: str = ...,
        serial_number: str = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class CameraInfo:
    header: std_msgs.msg.Header
    height: int
    width: int
    distortion_model: str
    @property
    def d(self) -> array[float]: ...
    @d.setter
    def d(self, value: Sequence[float] | AbstractSet[float]) -> None: ...
    @property
    def k(self) -> NDArray[numpy.float64]: ...
    @k.setter
    def k(self, value: NDArray[numpy.float64] | Sequence[float] | AbstractSet[float]) -> None: ...
    @property
    def r(self) -> NDArray[numpy.float64]: ...
    @r.setter
    def r(self, value: NDArray[numpy.float64] | Sequence[float] | AbstractSet[float]) -> None: ...
    @property
    def p(self) -> NDArray[numpy.float64]: ...
    @p.setter
    def p(self, value: NDArray[numpy.float64] | Sequence[float] | AbstractSet[float]) -> None: ...
    binning_x: int
    binning_y: int
    roi: RegionOfInterest
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        height: int = ...,
        width: int = ...,
        distortion_model: str = ...,
        d: Sequence[float] | AbstractSet[float] = ...,
        k: NDArray[numpy.float64] | Sequence[float] | AbstractSet[float] = ...,
        r: NDArray[numpy.float64] | Sequence[float] | AbstractSet[float] = ...,
        p: NDArray[numpy.float64] | Sequence[float] | AbstractSet[float] = ...,
        binning_x: int = ...,
        binning_y: int = ...,
        roi: RegionOfInterest = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class ChannelFloat32:
    name: str
    @property
    def values(self) -> array[float]: ...
    @values.setter
    def values(self, value: Sequence[float] | AbstractSet[float]) -> None: ...
    def __init__(
        self,
        *,
        name: str = ...,
        values: Sequence[float] | AbstractSet[float] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class CompressedImage:
    header: std_msgs.msg.Header
    format: str
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Sequence[int] | AbstractSet[int]) -> None: ...
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        format: str = ...,
        data: Sequence[int] | AbstractSet[int] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class FluidPressure:
    header: std_msgs.msg.Header
    fluid_pressure: float
    variance: float
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        fluid_pressure: float = ...,
        variance: float = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Illuminance:
    header: std_msgs.msg.Header
    illuminance: float
    variance: float
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        illuminance: float = ...,
        variance: float = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Image:
    header: std_msgs.msg.Header
    height: int
    width: int
    encoding: str
    is_bigendian: int
    step: int
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Sequence[int] | AbstractSet[int]) -> None: ...
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        height: int = ...,
        width: int = ...,
        encoding: str = ...,
        is_bigendian: int = ...,
        step: int = ...,
        data: Sequence[int] | AbstractSet[int] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Imu:
    header: std_msgs.msg.Header
    orientation: geometry_msgs.msg.Quaternion
    @property
    def orientation_covariance(self) -> NDArray[numpy.float64]: ...
    @orientation_covariance.setter
    def orientation_covariance(self, value: NDArray[numpy.float64] | Sequence[float] | AbstractSet[float]) -> None: ...
    angular_velocity: geometry_msgs.msg.Vector3
    @property
    def angular_velocity_covariance(self) -> NDArray[numpy.float64]: ...
    @angular_velocity_covariance.setter
    def angular_velocity_covariance(self, value: NDArray[numpy.float64] | Sequence[float] | AbstractSet[float]) -> None: ...
    linear_acceleration: geometry_msgs.msg.Vector3
    @property
    def linear_acceleration_covariance(self) -> NDArray[numpy.float64]: ...
    @linear_acceleration_covariance.setter
    def linear_acceleration_covariance(self, value: NDArray[numpy.float64] | Sequence[float] | AbstractSet[float]) -> None: ...
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        orientation: geometry_msgs.msg.Quaternion = ...,
        orientation_covariance: NDArray[numpy.float64] | Sequence[float] | AbstractSet[float] = ...,
        angular_velocity: geometry_msgs.msg.Vector3 = ...,
        angular_velocity_covariance: NDArray[numpy.float64] | Sequence[float] | AbstractSet[float] = ...,
        linear_acceleration: geometry_msgs.msg.Vector3 = ...,
        linear_acceleration_covariance: NDArray[numpy.float64] | Sequence[float] | AbstractSet[float] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class JointState:
    header: std_msgs.msg.Header
    @property
    def name(self) -> list[str]: ...
    @name.setter
    def name(self, value: list[str] | tuple[str, ...] | AbstractSet[str]) -> None: ...
    @property
    def position(self) -> array[float]: ...
    @position.setter
    def position(self, value: Sequence[float] | AbstractSet[float]) -> None: ...
    @property
    def velocity(self) -> array[float]: ...
    @velocity.setter
    def velocity(self, value: Sequence[float] | AbstractSet[float]) -> None: ...
    @property
    def effort(self) -> array[float]: ...
    @effort.setter
    def effort(self, value: Sequence[float] | AbstractSet[float]) -> None: ...
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        name: list[str] | tuple[str, ...] | AbstractSet[str] = ...,
        position: Sequence[float] | AbstractSet[float] = ...,
        velocity: Sequence[float] | AbstractSet[float] = ...,
        effort: Sequence[float] | AbstractSet[float] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Joy:
    header: std_msgs.msg.Header
    @property
    def axes(self) -> array[float]: ...
    @axes.setter
    def axes(self, value: Sequence[float] | AbstractSet[float]) -> None: ...
    @property
    def buttons(self) -> array[int]: ...
    @buttons.setter
    def buttons(self, value: Sequence[int] | AbstractSet[int]) -> None: ...
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        axes: Sequence[float] | AbstractSet[float] = ...,
        buttons: Sequence[int] | AbstractSet[int] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class JoyFeedback:
    TYPE_LED: ClassVar[int]
    TYPE_RUMBLE: ClassVar[int]
    TYPE_BUZZER: ClassVar[int]
    type: int
    id: int
    intensity: float
    def __init__(
        self,
        *,
        type: int = ...,
        id: int = ...,
        intensity: float = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class JoyFeedbackArray:
    @property
    def array(self) -> list[JoyFeedback]: ...
    @array.setter
    def array(self, value: Sequence[JoyFeedback] | AbstractSet[JoyFeedback]) -> None: ...
    def __init__(
        self,
        *,
        array: Sequence[JoyFeedback] | AbstractSet[JoyFeedback] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class LaserEcho:
    @property
    def echoes(self) -> array[float]: ...
    @echoes.setter
    def echoes(self, value: Sequence[float] | AbstractSet[float]) -> None: ...
    def __init__(
        self,
        *,
        echoes: Sequence[float] | AbstractSet[float] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class LaserScan:
    header: std_msgs.msg.Header
    angle_min: float
    angle_max: float
    angle_increment: float
    time_increment: float
    scan_time: float
    range_min: float
    range_max: float
    @property
    def ranges(self) -> array[float]: ...
    @ranges.setter
    def ranges(self, value: Sequence[float] | AbstractSet[float]) -> None: ...
    @property
    def intensities(self) -> array[float]: ...
    @intensities.setter
    def intensities(self, value: Sequence[float] | AbstractSet[float]) -> None: ...
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        angle_min: float = ...,
        angle_max: float = ...,
        angle_increment: float = ...,
        time_increment: float = ...,
        scan_time: float = ...,
        range_min: float = ...,
        range_max: float = ...,
        ranges: Sequence[float] | AbstractSet[float] = ...,
        intensities: Sequence[float] | AbstractSet[float] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class MagneticField:
    header: std_msgs.msg.Header
    magnetic_field: geometry_msgs.msg.Vector3
    @property
    def magnetic_field_covariance(self) -> NDArray[numpy.float64]: ...
    @magnetic_field_covariance.setter
    def magnetic_field_covariance(self, value: NDArray[numpy.float64] | Sequence[float] | AbstractSet[float]) -> None: ...
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        magnetic_field: geometry_msgs.msg.Vector3 = ...,
        magnetic_field_covariance: NDArray[numpy.float64] | Sequence[float] | AbstractSet[float] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class MultiDOFJointState:
    header: std_msgs.msg.Header
    @property
    def joint_names(self) -> list[str]: ...
    @joint_names.setter
    def joint_names(self, value: list[str] | tuple[str, ...] | AbstractSet[str]) -> None: ...
    @property
    def transforms(self) -> list[geometry_msgs.msg.Transform]: ...
    @transforms.setter
    def transforms(self, value: Sequence[geometry_msgs.msg.Transform] | AbstractSet[geometry_msgs.msg.Transform]) -> None: ...
    @property
    def twist(self) -> list[geometry_msgs.msg.Twist]: ...
    @twist.setter
    def twist(self, value: Sequence[geometry_msgs.msg.Twist] | AbstractSet[geometry_msgs.msg.Twist]) -> None: ...
    @property
    def wrench(self) -> list[geometry_msgs.msg.Wrench]: ...
    @wrench.setter
    def wrench(self, value: Sequence[geometry_msgs.msg.Wrench] | AbstractSet[geometry_msgs.msg.Wrench]) -> None: ...
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        joint_names: list[str] | tuple[str, ...] | AbstractSet[str] = ...,
        transforms: Sequence[geometry_msgs.msg.Transform] | AbstractSet[geometry_msgs.msg.Transform] = ...,
        twist: Sequence[geometry_msgs.msg.Twist] | AbstractSet[geometry_msgs.msg.Twist] = ...,
        wrench: Sequence[geometry_msgs.msg.Wrench] | AbstractSet[geometry_msgs.msg.Wrench] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class MultiEchoLaserScan:
    header: std_msgs.msg.Header
    angle_min: float
    angle_max: float
    angle_increment: float
    time_increment: float
    scan_time: float
    range_min: float
    range_max: float
    @property
    def ranges(self) -> list[LaserEcho]: ...
    @ranges.setter
    def ranges(self, value: Sequence[LaserEcho] | AbstractSet[LaserEcho]) -> None: ...
    @property
    def intensities(self) -> list[LaserEcho]: ...
    @intensities.setter
    def intensities(self, value: Sequence[LaserEcho] | AbstractSet[LaserEcho]) -> None: ...
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        angle_min: float = ...,
        angle_max: float = ...,
        angle_increment: float = ...,
        time_increment: float = ...,
        scan_time: float = ...,
        range_min: float = ...,
        range_max: float = ...,
        ranges: Sequence[LaserEcho] | AbstractSet[LaserEcho] = ...,
        intensities: Sequence[LaserEcho] | AbstractSet[LaserEcho] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class NavSatFix:
    COVARIANCE_TYPE_UNKNOWN: ClassVar[int]
    COVARIANCE_TYPE_APPROXIMATED: ClassVar[int]
    COVARIANCE_TYPE_DIAGONAL_KNOWN: ClassVar[int]
    COVARIANCE_TYPE_KNOWN: ClassVar[int]
    header: std_msgs.msg.Header
    status: NavSatStatus
    latitude: float
    longitude: float
    altitude: float
    @property
    def position_covariance(self) -> NDArray[numpy.float64]: ...
    @position_covariance.setter
    def position_covariance(self, value: NDArray[numpy.float64] | Sequence[float] | AbstractSet[float]) -> None: ...
    position_covariance_type: int
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        status: NavSatStatus = ...,
        latitude: float = ...,
        longitude: float = ...,
        altitude: float = ...,
        position_covariance: NDArray[numpy.float64] | Sequence[float] | AbstractSet[float] = ...,
        position_covariance_type: int = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class NavSatStatus:
    STATUS_UNKNOWN: ClassVar[int]
    STATUS_NO_FIX: ClassVar[int]
    STATUS_FIX: ClassVar[int]
    STATUS_SBAS_FIX: ClassVar[int]
    STATUS_GBAS_FIX: ClassVar[int]
    SERVICE_UNKNOWN: ClassVar[int]
    SERVICE_GPS: ClassVar[int]
    SERVICE_GLONASS: ClassVar[int]
    SERVICE_COMPASS: ClassVar[int]
    SERVICE_GALILEO: ClassVar[int]
    status: int
    service: int
    def __init__(self, *, status: int = ..., service: int = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class PointCloud:
    header: std_msgs.msg.Header
    @property
    def points(self) -> list[geometry_msgs.msg.Point32]: ...
    @points.setter
    def points(self, value: Sequence[geometry_msgs.msg.Point32] | AbstractSet[geometry_msgs.msg.Point32]) -> None: ...
    @property
    def channels(self) -> list[ChannelFloat32]: ...
    @channels.setter
    def channels(self, value: Sequence[ChannelFloat32] | AbstractSet[ChannelFloat32]) -> None: ...
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        points: Sequence[geometry_msgs.msg.Point32] | AbstractSet[geometry_msgs.msg.Point32] = ...,
        channels: Sequence[ChannelFloat32] | AbstractSet[ChannelFloat32] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class PointCloud2:
    header: std_msgs.msg.Header
    height: int
    width: int
    @property
    def fields(self) -> list[PointField]: ...
    @fields.setter
    def fields(self, value: Sequence[PointField] | AbstractSet[PointField]) -> None: ...
    is_bigendian: bool
    point_step: int
    row_step: int
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Sequence[int] | AbstractSet[int]) -> None: ...
    is_dense: bool
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        height: int = ...,
        width: int = ...,
        fields: Sequence[PointField] | AbstractSet[PointField] = ...,
        is_bigendian: bool = ...,
        point_step: int = ...,
        row_step: int = ...,
        data: Sequence[int] | AbstractSet[int] = ...,
        is_dense: bool = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class PointField:
    INT8: ClassVar[int]
    UINT8: ClassVar[int]
    INT16: ClassVar[int]
    UINT16: ClassVar[int]
    INT32: ClassVar[int]
    UINT32: ClassVar[int]
    FLOAT32: ClassVar[int]
    FLOAT64: ClassVar[int]
    name: str
    offset: int
    datatype: int
    count: int
    def __init__(
        self,
        *,
        name: str = ...,
        offset: int = ...,
        datatype: int = ...,
        count: int = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Range:
    ULTRASOUND: ClassVar[int]
    INFRARED: ClassVar[int]
    header: std_msgs.msg.Header
    radiation_type: int
    field_of_view: float
    min_range: float
    max_range: float
    range: float
    variance: float
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        radiation_type: int = ...,
        field_of_view: float = ...,
        min_range: float = ...,
        max_range: float = ...,
        range: float = ...,
        variance: float = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class RegionOfInterest:
    x_offset: int
    y_offset: int
    height: int
    width: int
    do_rectify: bool
    def __init__(
        self,
        *,
        x_offset: int = ...,
        y_offset: int = ...,
        height: int = ...,
        width: int = ...,
        do_rectify: bool = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class RelativeHumidity:
    header: std_msgs.msg.Header
    relative_humidity: float
    variance: float
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        relative_humidity: float = ...,
        variance: float = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Temperature:
    header: std_msgs.msg.Header
    temperature: float
    variance: float
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        temperature: float = ...,
        variance: float = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class TimeReference:
    header: std_msgs.msg.Header
    time_ref: builtin_interfaces.msg.Time
    source: str
    def __init__(
        self,
        *,
        header: std_msgs.msg.Header = ...,
        time_ref: builtin_interfaces.msg.Time = ...,
        source: str = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

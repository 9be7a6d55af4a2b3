# Made by `python -m workbook.authoring typings` from the installed message classes; do not edit.
import builtin_interfaces.msg
from array import array
from collections.abc import Sequence, Set as AbstractSet

class Bool:
    data: bool
    def __init__(self, *, data: bool = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Byte:
    data: bytes
    def __init__(self, *, data: bytes = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class ByteMultiArray:
    layout: MultiArrayLayout
    @property
    def data(self) -> list[bytes]: ...
    @data.setter
    def data(self, value: Sequence[bytes] | AbstractSet[bytes]) -> None: ...
    def __init__(
        self,
        *,
        layout: MultiArrayLayout = ...,
        data: Sequence[bytes] | AbstractSet[bytes] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Char:
    data: int
    def __init__(self, *, data: int = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class ColorRGBA:
    r: float
    g: float
    b: float
    a: float
    def __init__(
        self,
        *,
        r: float = ...,
        g: float = ...,
        b: float = ...,
        a: float = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Empty:
    def __init__(self, *, check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Float32:
    data: float
    def __init__(self, *, data: float = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Float32MultiArray:
    layout: MultiArrayLayout
    @property
    def data(self) -> array[float]: ...
    @data.setter
    def data(self, value: Sequence[float] | AbstractSet[float]) -> None: ...
    def __init__(
        self,
        *,
        layout: MultiArrayLayout = ...,
        data: Sequence[float] | AbstractSet[float] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Float64:
    data: float
    def __init__(self, *, data: float = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Float64MultiArray:
    layout: MultiArrayLayout
    @property
    def data(self) -> array[float]: ...
    @data.setter
    def data(self, value: Sequence[float] | AbstractSet[float]) -> None: ...
    def __init__(
        self,
        *,
        layout: MultiArrayLayout = ...,
        data: Sequence[float] | AbstractSet[float] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Header:
    stamp: builtin_interfaces.msg.Time
    frame_id: str
    def __init__(
        self,
        *,
        stamp: builtin_interfaces.msg.Time = ...,
        frame_id: str = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Int16:
    data: int
    def __init__(self, *, data: int = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Int16MultiArray:
    layout: MultiArrayLayout
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Sequence[int] | AbstractSet[int]) -> None: ...
    def __init__(
        self,
        *,
        layout: MultiArrayLayout = ...,
        data: Sequence[int] | AbstractSet[int] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Int32:
    data: int
    def __init__(self, *, data: int = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Int32MultiArray:
    layout: MultiArrayLayout
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Sequence[int] | AbstractSet[int]) -> None: ...
    def __init__(
        self,
        *,
        layout: MultiArrayLayout = ...,
        data: Sequence[int] | AbstractSet[int] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Int64:
    data: int
    def __init__(self, *, data: int = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Int64MultiArray:
    layout: MultiArrayLayout
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Sequence[int] | AbstractSet[int]) -> None: ...
    def __init__(
        self,
        *,
        layout: MultiArrayLayout = ...,
        data: Sequence[int] | AbstractSet[int] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Int8:
    data: int
    def __init__(self, *, data: int = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Int8MultiArray:
    layout: MultiArrayLayout
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Sequence[int] | AbstractSet[int]) -> None: ...
    def __init__(
        self,
        *,
        layout: MultiArrayLayout = ...,
        data: Sequence[int] | AbstractSet[int] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class MultiArrayDimension:
    label: str
    size: int
    stride: int
    def __init__(
        self,
        *,
        label: str = ...,
        size: int = ...,
        stride: int = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class MultiArrayLayout:
    @property
    def dim(self) -> list[MultiArrayDimension]: ...
    @dim.setter
    def dim(self, value: Sequence[MultiArrayDimension] | AbstractSet[MultiArrayDimension]) -> None: ...
    data_offset: int
    def __init__(
        self,
        *,
        dim: Sequence[MultiArrayDimension] | AbstractSet[MultiArrayDimension] = ...,
        data_offset: int = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class String:
    data: str
    def __init__(self, *, data: str = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class UInt16:
    data: int
    def __init__(self, *, data: int = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class UInt16MultiArray:
    layout: MultiArrayLayout
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Sequence[int] | AbstractSet[int]) -> None: ...
    def __init__(
        self,
        *,
        layout: MultiArrayLayout = ...,
        data: Sequence[int] | AbstractSet[int] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class UInt32:
    data: int
    def __init__(self, *, data: int = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class UInt32MultiArray:
    layout: MultiArrayLayout
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Sequence[int] | AbstractSet[int]) -> None: ...
    def __init__(
        self,
        *,
        layout: MultiArrayLayout = ...,
        data: Sequence[int] | AbstractSet[int] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class UInt64:
    data: int
    def __init__(self, *, data: int = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class UInt64MultiArray:
    layout: MultiArrayLayout
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Sequence[int] | AbstractSet[int]) -> None: ...
    def __init__(
        self,
        *,
        layout: MultiArrayLayout = ...,
        data: Sequence[int] | AbstractSet[int] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class UInt8:
    data: int
    def __init__(self, *, data: int = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class UInt8MultiArray:
    layout: MultiArrayLayout
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Sequence[int] | AbstractSet[int]) -> None: ...
    def __init__(
        self,
        *,
        layout: MultiArrayLayout = ...,
        data: Sequence[int] | AbstractSet[int] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

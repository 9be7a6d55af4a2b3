# Made by `python -m workbook.authoring typings` from the installed message classes; do not edit.
import builtin_interfaces.msg
from array import array
from collections.abc import Sequence, Set as AbstractSet
from typing import ClassVar

class FloatingPointRange:
    from_value: float
    to_value: float
    step: float
    def __init__(
        self,
        *,
        from_value: float = ...,
        to_value: float = ...,
        step: float = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class IntegerRange:
    from_value: int
    to_value: int
    step: int
    def __init__(
        self,
        *,
        from_value: int = ...,
        to_value: int = ...,
        step: int = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class ListParametersResult:
    @property
    def names(self) -> list[str]: ...
    @names.setter
    def names(self, value: list[str] | tuple[str, ...] | AbstractSet[str]) -> None: ...
    @property
    def prefixes(self) -> list[str]: ...
    @prefixes.setter
    def prefixes(self, value: list[str] | tuple[str, ...] | AbstractSet[str]) -> None: ...
    def __init__(
        self,
        *,
        names: list[str] | tuple[str, ...] | AbstractSet[str] = ...,
        prefixes: list[str] | tuple[str, ...] | AbstractSet[str] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Log:
    DEBUG: ClassVar[int]
    INFO: ClassVar[int]
    WARN: ClassVar[int]
    ERROR: ClassVar[int]
    FATAL: ClassVar[int]
    stamp: builtin_interfaces.msg.Time
    level: int
    name: str
    msg: str
    file: str
    function: str
    line: int
    def __init__(
        self,
        *,
        stamp: builtin_interfaces.msg.Time = ...,
        level: int = ...,
        name: str = ...,
        msg: str = ...,
        file: str = ...,
        function: str = ...,
        line: int = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class LoggerLevel:
    LOG_LEVEL_UNKNOWN: ClassVar[int]
    LOG_LEVEL_DEBUG: ClassVar[int]
    LOG_LEVEL_INFO: ClassVar[int]
    LOG_LEVEL_WARN: ClassVar[int]
    LOG_LEVEL_ERROR: ClassVar[int]
    LOG_LEVEL_FATAL: ClassVar[int]
    name: str
    level: int
    def __init__(self, *, name: str = ..., level: int = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Parameter:
    name: str
    value: ParameterValue
    def __init__(self, *, name: str = ..., value: ParameterValue = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class ParameterDescriptor:
    name: str
    type: int
    description: str
    additional_constraints: str
    read_only: bool
    dynamic_typing: bool
    @property
    def floating_point_range(self) -> list[FloatingPointRange]: ...
    @floating_point_range.setter
    def floating_point_range(self, value: Sequence[FloatingPointRange] | AbstractSet[FloatingPointRange]) -> None: ...
    @property
    def integer_range(self) -> list[IntegerRange]: ...
    @integer_range.setter
    def integer_range(self, value: Sequence[IntegerRange] | AbstractSet[IntegerRange]) -> None: ...
    def __init__(
        self,
        *,
        name: str = ...,
        type: int = ...,
        description: str = ...,
        additional_constraints: str = ...,
        read_only: bool = ...,
        dynamic_typing: bool = ...,
        floating_point_range: Sequence[FloatingPointRange] | AbstractSet[FloatingPointRange] = ...,
        integer_range: Sequence[IntegerRange] | AbstractSet[IntegerRange] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class ParameterEvent:
    stamp: builtin_interfaces.msg.Time
    node: str
    @property
    def new_parameters(self) -> list[Parameter]: ...
    @new_parameters.setter
    def new_parameters(self, value: Sequence[Parameter] | AbstractSet[Parameter]) -> None: ...
    @property
    def changed_parameters(self) -> list[Parameter]: ...
    @changed_parameters.setter
    def changed_parameters(self, value: Sequence[Parameter] | AbstractSet[Parameter]) -> None: ...
    @property
    def deleted_parameters(self) -> list[Parameter]: ...
    @deleted_parameters.setter
    def deleted_parameters(self, value: Sequence[Parameter] | AbstractSet[Parameter]) -> None: ...
    def __init__(
        self,
        *,
        stamp: builtin_interfaces.msg.Time = ...,
        node: str = ...,
        new_parameters: Sequence[Parameter] | AbstractSet[Parameter] = ...,
        changed_parameters: Sequence[Parameter] | AbstractSet[Parameter] = ...,
        deleted_parameters: Sequence[Parameter] | AbstractSet[Parameter] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class ParameterEventDescriptors:
    @property
    def new_parameters(self) -> list[ParameterDescriptor]: ...
    @new_parameters.setter
    def new_parameters(self, value: Sequence[ParameterDescriptor] | AbstractSet[ParameterDescriptor]) -> None: ...
    @property
    def changed_parameters(self) -> list[ParameterDescriptor]: ...
    @changed_parameters.setter
    def changed_parameters(self, value: Sequence[ParameterDescriptor] | AbstractSet[ParameterDescriptor]) -> None: ...
    @property
    def deleted_parameters(self) -> list[ParameterDescriptor]: ...
    @deleted_parameters.setter
    def deleted_parameters(self, value: Sequence[ParameterDescriptor] | AbstractSet[ParameterDescriptor]) -> None: ...
    def __init__(
        self,
        *,
        new_parameters: Sequence[ParameterDescriptor] | AbstractSet[ParameterDescriptor] = ...,
        changed_parameters: Sequence[ParameterDescriptor] | AbstractSet[ParameterDescriptor] = ...,
        deleted_parameters: Sequence[ParameterDescriptor] | AbstractSet[ParameterDescriptor] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class ParameterType:
    PARAMETER_NOT_SET: ClassVar[int]
    PARAMETER_BOOL: ClassVar[int]
    PARAMETER_INTEGER: ClassVar[int]
    PARAMETER_DOUBLE: ClassVar[int]
    PARAMETER_STRING: ClassVar[int]
    PARAMETER_BYTE_ARRAY: ClassVar[int]
    PARAMETER_BOOL_ARRAY: ClassVar[int]
    PARAMETER_INTEGER_ARRAY: ClassVar[int]
    PARAMETER_DOUBLE_ARRAY: ClassVar[int]
    PARAMETER_STRING_ARRAY: ClassVar[int]
    def __init__(self, *, check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class ParameterValue:
    type: int
    bool_value: bool
    integer_value: int
    double_value: float
    string_value: str
    @property
    def byte_array_value(self) -> list[bytes]: ...
    @byte_array_value.setter
    def byte_array_value(self, value: Sequence[bytes] | AbstractSet[bytes]) -> None: ...
    @property
    def bool_array_value(self) -> list[bool]: ...
    @bool_array_value.setter
    def bool_array_value(self, value: Sequence[bool] | AbstractSet[bool]) -> None: ...
    @property
    def integer_array_value(self) -> array[int]: ...
    @integer_array_value.setter
    def integer_array_value(self, value: Sequence[int] | AbstractSet[int]) -> None: ...
    @property
    def double_array_value(self) -> array[float]: ...
    @double_array_value.setter
    def double_array_value(self, value: Sequence[float] | AbstractSet[float]) -> None: ...
    @property
    def string_array_value(self) -> list[str]: ...
    @string_array_value.setter
    def string_array_value(self, value: list[str] | tuple[str, ...] | AbstractSet[str]) -> None: ...
    def __init__(
        self,
        *,
        type: int = ...,
        bool_value: bool = ...,
        integer_value: int = ...,
        double_value: float = ...,
        string_value: str = ...,
        byte_array_value: Sequence[bytes] | AbstractSet[bytes] = ...,
        bool_array_value: Sequence[bool] | AbstractSet[bool] = ...,
        integer_array_value: Sequence[int] | AbstractSet[int] = ...,
        double_array_value: Sequence[float] | AbstractSet[float] = ...,
        string_array_value: list[str] | tuple[str, ...] | AbstractSet[str] = ...,
        check_fields: bool = ...,
    ) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class SetLoggerLevelsResult:
    successful: bool
    reason: str
    def __init__(self, *, successful: bool = ..., reason: str = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class SetParametersResult:
    successful: bool
    reason: str
    def __init__(self, *, successful: bool = ..., reason: str = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

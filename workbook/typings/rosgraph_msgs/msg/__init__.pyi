# Made by `python -m workbook.authoring typings` from the installed message classes; do not edit.
import builtin_interfaces.msg

class Clock:
    clock: builtin_interfaces.msg.Time
    def __init__(self, *, clock: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

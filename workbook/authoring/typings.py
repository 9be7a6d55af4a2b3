"""Generate the type stubs in `workbook/typings` from the installed message classes.

Message packages have no type hints, so a type checker treats every message as `Any`. A stub (`.pyi`) declares the types
of each message's fields. Stubs depend only on the message definitions, so they are the same on every machine.
"""

import importlib.util
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from workbook.typechecking.typecheck import TYPINGS

# The packages that lessons and exercises import, and the packages of nested messages.
PACKAGES = (
    "builtin_interfaces",
    "diagnostic_msgs",
    "geometry_msgs",
    "nav_msgs",
    "rcl_interfaces",
    "rosgraph_msgs",
    "sensor_msgs",
    "service_msgs",
    "std_msgs",
    "std_srvs",
    "trajectory_msgs",
    "visualization_msgs",
)
HEADER = "# Made by `python -m workbook.authoring typings` from the installed message classes; do not edit.\n"
LONGEST_LINE = 110
_NUMPY = {
    "float": "float32", "double": "float64", "int8": "int8", "uint8": "uint8", "int16": "int16", "uint16": "uint16",
    "int32": "int32", "uint32": "uint32", "int64": "int64", "uint64": "uint64",
}  # fmt: skip
_PLAIN = {"boolean": "bool", "octet": "bytes", "string": "str", "wstring": "str"} | {
    name: "float" if name in ("float", "double") else "int" for name in _NUMPY
}
_SEQUENCE = re.compile(r"sequence<(?P<item>[^,>]+)(?:, *\d+)?>")
_FIXED = re.compile(r"(?P<item>[^\[]+)\[\d+\]")
_BOUNDED_TEXT = re.compile(r"(w?string)<\d+>")
_FIELDS = "get_fields_and_field_types"


class _Module:
    """The stub of one module, such as std_msgs.msg."""

    def __init__(self, package: str, kind: str) -> None:
        self.package, self.kind = package, kind
        self.imports: set[str] = set()

    def text(self) -> str:
        """Return the text of the stub."""
        found = vars(importlib.import_module(f"{self.package}.{self.kind}"))
        classes = {name: one for name, one in sorted(found.items()) if isinstance(one, type)}
        blocks: list[str] = []
        for name, one in classes.items():
            if hasattr(one, _FIELDS):
                blocks.append(self._message(name, one))
            else:
                self.imports.add("from typing import TypeAlias")
                parts = [
                    f"    {part}: TypeAlias = {getattr(one, part).__name__}"
                    for part in ("Request", "Response", "Event")
                ]
                blocks.append("\n".join([f"class {name}:", *parts]))
        head = HEADER + "".join(f"{line}\n" for line in sorted(self.imports, key=_import_order))
        return "\n\n".join([head.rstrip("\n"), *blocks]) + "\n"

    def _message(self, name: str, one: Any) -> str:
        lines = [f"class {name}:"]
        for constant, value in getattr(type(one), f"_Metaclass_{name}__constants", {}).items():
            self.imports.add("from typing import ClassVar")
            lines.append(f"    {constant}: ClassVar[{type(value).__name__}]")
        given: list[str] = []
        for field, spelled in one.get_fields_and_field_types().items():
            held, taken = self._types(spelled)
            given.append(f"{field}: {taken} = ...")
            if held == taken:
                lines.append(f"    {field}: {held}")
                continue
            lines += [
                "    @property",
                f"    def {field}(self) -> {held}: ...",
                f"    @{field}.setter",
                f"    def {field}(self, value: {taken}) -> None: ...",
            ]
        given.append("check_fields: bool = ...")
        in_one = f"    def __init__(self, *, {', '.join(given)}) -> None: ..."
        in_many = [
            "    def __init__(",
            *(f"        {part}," for part in ("self", "*", *given)),
            "    ) -> None: ...",
        ]
        lines += [in_one] if len(in_one) <= LONGEST_LINE else in_many
        lines += ["    @classmethod", f"    def {_FIELDS}(cls) -> dict[str, str]: ..."]
        return "\n".join(lines)

    def _types(self, spelled: str) -> tuple[str, str]:
        """Return two types for a field: the type of its value when read, and the type that may be assigned."""
        sequence = _SEQUENCE.fullmatch(spelled)
        fixed = _FIXED.fullmatch(spelled)
        if sequence is None and fixed is None:
            item = self._item(spelled)
            return item, item
        name = (sequence or fixed)["item"]  # type: ignore[index]
        item = self._item(name)
        self.imports.add("from collections.abc import Sequence, Set as AbstractSet")
        taken = f"Sequence[{item}] | AbstractSet[{item}]"
        if name in _NUMPY and sequence is not None:
            self.imports.add("from array import array")
            return f"array[{item}]", taken
        if name in _NUMPY:
            self.imports |= {"import numpy", "from numpy.typing import NDArray"}
            held = f"NDArray[numpy.{_NUMPY[name]}]"
            return held, f"{held} | {taken}"
        if item == "str":  # a str is also a sequence of str, but no message accepts it as one
            taken = "list[str] | tuple[str, ...] | AbstractSet[str]"
        return f"list[{item}]", taken

    def _item(self, spelled: str) -> str:
        plain = _BOUNDED_TEXT.sub(r"\1", spelled)
        if plain in _PLAIN:
            return _PLAIN[plain]
        package, _, name = spelled.partition("/")
        kind = "srv" if re.search(r"_(Request|Response|Event)$", name) else "msg"
        if (package, kind) == (self.package, self.kind):
            return name
        self.imports.add(f"import {package}.{kind}")
        return f"{package}.{kind}.{name}"


def _import_order(line: str) -> tuple[bool, str]:
    return line.startswith("from "), line


def stubs() -> Iterator[tuple[str, str]]:
    """Yield each stub's path in `workbook/typings` and its text."""
    for package in PACKAGES:
        yield f"{package}/__init__.pyi", HEADER
        for kind in ("msg", "srv"):
            if importlib.util.find_spec(f"{package}.{kind}") is not None:
                yield f"{package}/{kind}/__init__.pyi", _Module(package, kind).text()


def write(folder: Path = TYPINGS) -> int:
    """Write all stubs and return their number."""
    count = 0
    for name, text in stubs():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        count += 1
    return count

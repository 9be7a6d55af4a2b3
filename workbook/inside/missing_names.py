"""Explain an exception about a missing name: where the name is set, where it belongs, or which names are similar.

The exception's message contains only names, but the exception itself and its frames refer to the object.
"""

import dis
import inspect
import pkgutil
import re
import sys
from collections.abc import Iterable, Iterator
from difflib import get_close_matches
from types import FrameType, FunctionType, TracebackType
from typing import Any

MOST_NAMES = 3
ALIKE, ALIKE_FOR_MODULES = 0.7, 0.8
"""The least similarity (from 0 to 1, see `difflib`) of a name that we suggest."""
_OF_THE_PROGRAM = ("__main__", "answer")
_RAISES_FOR_IT = "enum"
"""Up to Python 3.11, this module raises the exception if a program uses a name that an enum doesn't have."""
_NOT_IN_MODULE = re.compile(r"^cannot import name '(?P<name>\w+)' from '(?P<module>[\w.]+)'")
_NO_KEYWORD = re.compile(
    r"^(?P<kind>\w+)\.(?P<name>\w+)\(\) got an unexpected keyword argument '(?P<keyword>\w+)'"
)
_CLASSES = {
    "rclpy.node": ("Node",),
    "rclpy.publisher": ("Publisher",),
    "rclpy.timer": ("Timer", "Rate"),
    "rclpy.client": ("Client",),
    "rclpy.clock": ("Clock",),
    "rclpy.task": ("Future",),
    "rclpy.executors": ("Executor",),
    "rclpy.impl.rcutils_logger": ("RcutilsLogger",),
}


def note_of_name(error: BaseException) -> str:
    """Return a line that says where a missing name is or which names are similar, or "" if we don't find any."""
    try:
        frames = [step.tb_frame for step in _steps(error)]
        if not frames or frames[-1].f_globals.get("__name__") not in (*_OF_THE_PROGRAM, _RAISES_FOR_IT):
            return _of_node(frames) if isinstance(error, (AttributeError, TypeError)) else ""
        if isinstance(error, AttributeError):
            return _of_attribute(error.obj, error.name or "", [step.tb_lineno for step in _steps(error)][-1])
        if isinstance(error, TypeError):
            return _of_keyword(str(error))
        return _of_import(error) if isinstance(error, ImportError) else ""
    except Exception:
        return ""


def _steps(error: BaseException) -> Iterator[TracebackType]:
    step = error.__traceback__
    while step is not None:
        yield step
        step = step.tb_next


def _of_node(frames: list[FrameType]) -> str:
    """Return a line about the statement in the program that overwrote one of Node's own attributes and made rclpy fail.

    Return an empty string if there's no such statement.
    """
    kind = getattr(sys.modules.get("rclpy.node"), "Node", None)
    locals_of_rclpy = [
        one.f_locals for one in frames if one.f_globals.get("__name__", "").startswith("rclpy")
    ]
    given = (here.get(name) for here in locals_of_rclpy for name in ("self", "node"))
    node = next((one for one in given if kind is not None and isinstance(one, kind)), None)
    if node is None:
        return ""
    kept = {name for name, _ in _set_by(vars(kind)["__init__"]) if name.startswith("_")}
    found = ((line, name) for function in _own_functions(type(node)) for name, line in _set_by(function))
    return next(
        (f"Line {line} sets '{name}', which Node needs itself" for line, name in found if name in kept), ""
    )


def _of_attribute(owner: Any, name: str, failed: int) -> str:
    if owner is None or not name:
        return ""
    called = owner.__name__ if isinstance(owner, type) or inspect.ismodule(owner) else type(owner).__name__
    found = (set_by for function in _own_functions(type(owner)) for set_by in _set_by(function))
    line = next((line for set_name, line in found if set_name == name and line != failed), 0)
    if line:
        return f"Line {line} sets '{name}' of {called}"
    others = ", ".join(_others_with(owner, name))
    return f"'{name}' belongs to: {others}" if others else _alike(called, name, dir(owner), ALIKE)


def _of_keyword(text: str) -> str:
    asked = _NO_KEYWORD.match(text)
    home = next(
        (home for home, kinds in _CLASSES.items() if asked is not None and asked["kind"] in kinds), ""
    )
    if asked is None or not home:
        return ""
    names = list(
        inspect.signature(vars(getattr(sys.modules[home], asked["kind"]))[asked["name"]]).parameters
    )[1:]
    names = list(dict.fromkeys([*get_close_matches(asked["keyword"], names, MOST_NAMES), *names]))
    return f"The keywords of {asked['name']} are: {', '.join(names)}"


def _of_import(error: ImportError) -> str:
    asked = _NOT_IN_MODULE.match(str(error))
    if asked is not None:
        return _alike(asked["module"], asked["name"], dir(sys.modules[asked["module"]]), ALIKE)
    package, _, name = (error.name or "").rpartition(".")
    paths = list(sys.modules[package].__path__) if package else None
    found = (module.name for module in pkgutil.iter_modules(paths))
    return _alike(package or "Python", name, found, ALIKE_FOR_MODULES)


def _alike(owner: str, name: str, names: Iterable[str], share: float) -> str:
    public = [one for one in names if not one.startswith("_")]
    near = ", ".join(get_close_matches(name, public, MOST_NAMES, share))
    return f"Similar names of {owner} are: {near}" if near else ""


def _own_functions(kind: type) -> Iterator[FunctionType]:
    """Yield the methods of a class and of its base classes, as far as the program itself defines these classes."""
    for one in kind.__mro__:
        if one.__module__ in _OF_THE_PROGRAM:
            yield from (value for value in vars(one).values() if inspect.isfunction(value))


def _set_by(function: FunctionType) -> Iterator[tuple[str, int]]:
    """Yield the attributes that a function sets, with their line numbers."""
    for step in dis.get_instructions(function):
        if step.opname == "STORE_ATTR" and step.positions is not None:
            yield step.argval, step.positions.lineno or 0


def _others_with(owner: Any, name: str) -> Iterator[str]:
    """Yield the names of rclpy's classes that have this method, and "rclpy" if that module has a function of this name.

    If `owner` doesn't belong to rclpy, yield nothing.
    """
    module = owner.__name__ if inspect.ismodule(owner) else ""
    if not any(one.__module__.startswith("rclpy.") for one in type(owner).__mro__) and module != "rclpy":
        return
    if inspect.isfunction(getattr(sys.modules.get("rclpy"), name, None)):
        yield "rclpy"
    for home, kinds in _CLASSES.items():
        for kind in kinds:
            if inspect.isfunction(getattr(getattr(sys.modules.get(home), kind, None), name, None)):
                yield kind

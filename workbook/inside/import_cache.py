"""Import modules before a fork, and hide them until the forked program imports them itself."""

import builtins
import importlib.util
import inspect
import os
import sys
import types
import warnings
from collections.abc import Callable, Iterable
from importlib.machinery import ModuleSpec
from typing import Any

WARMED = (
    "rclpy.node",
    "rclpy.executors",
    "rclpy.qos",
    "rclpy.time_source",
    "rosgraph_msgs.msg",
    "std_msgs.msg",
    "std_srvs.srv",
    "numpy",  # imported with a program's first node, because messages with arrays need it
    "rosidl_generator_py",  # imported with a program's first type support, along with a grammar parser
)
TYPE_SUPPORT = (
    "builtin_interfaces",
    "rcl_interfaces",
    "rosgraph_msgs",
    "service_msgs",
    "std_msgs",
    "std_srvs",
    "type_description_interfaces",
)
"""The packages whose compiled part is loaded when the first node, publisher, subscription, or service is created."""
CHECKS = "ros_python_check_fields"


class ImportCache:
    """Keeps loaded modules outside of `sys.modules`. Importing a module adds it there, as if it had just been loaded.

    The modules that this module imports at its top level are added, too, so `sys.modules` has the same names as in a
    new Python interpreter.
    """

    def __init__(self) -> None:
        self._modules: dict[str, types.ModuleType] = {}
        self._imports: dict[str, dict[str, None]] = {}

    def fill(self, load: Callable[[], object]) -> None:
        """Call `load`, and hide all modules that it imports."""
        before = set(sys.modules)
        original = builtins.__import__

        def noted(
            name: str, globals: Any = None, locals: Any = None, fromlist: Any = None, level: int = 0
        ) -> types.ModuleType:
            module = original(name, globals, locals, fromlist, level)
            self._note(name, globals or {}, fromlist or (), level)
            return module

        builtins.__import__ = noted
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                load()
        finally:
            builtins.__import__ = original
        for name in sorted(set(sys.modules) - before, reverse=True):
            module = self._modules[name] = sys.modules.pop(name)
            parent, _, child = name.rpartition(".")
            holder = sys.modules.get(parent) or self._modules.get(parent)
            if holder is not None and getattr(holder, child, None) is module:
                delattr(holder, child)

    def _note(self, name: str, importer: dict[str, Any], fromlist: Iterable[str], level: int) -> None:
        who = importer.get("__name__")
        if who == "importlib._bootstrap":
            who = _compiled_module_being_loaded()
        if not isinstance(who, str):
            return
        base = importlib.util.resolve_name("." * level + name, importer["__package__"]) if level else name
        wanted = [base, *(f"{base}.{item}" for item in fromlist if f"{base}.{item}" in sys.modules)]
        self._imports.setdefault(who, {}).update(dict.fromkeys(wanted))

    def find_spec(self, name: str, path: object = None, target: object = None) -> ModuleSpec | None:
        """Return the spec of a cached module, or None for any other name. Part of the import protocol."""
        module = self._modules.get(name)
        if module is None:
            return None
        spec = ModuleSpec(name, self, is_package=hasattr(module, "__path__"))  # type: ignore[arg-type]
        spec.loader_state = module.__spec__
        return spec

    def create_module(self, spec: ModuleSpec) -> types.ModuleType:
        """Return the cached module instead of a new one. Part of the import protocol."""
        return self._modules[spec.name]

    def exec_module(self, module: types.ModuleType) -> None:
        """Restore the module's original spec, and then import the modules that the module imports at its top level.

        Part of the import protocol.
        """
        spec = module.__spec__
        assert spec is not None
        module.__spec__ = spec.loader_state
        del self._modules[spec.name]
        if hasattr(module, CHECKS):  # message modules read this environment variable when they're loaded
            setattr(module, CHECKS, os.environ.get("ROS_PYTHON_CHECK_FIELDS", ""))
        for name in self._imports.get(spec.name, ()):
            if name not in sys.modules and name in self._modules:
                importlib.import_module(name)


def _compiled_module_being_loaded() -> str | None:
    """Return the name of the compiled module that's being loaded, or None if there's none.

    We need it because a compiled module's imports appear to come from the import system itself.
    """
    frame: types.FrameType | None = sys._getframe()
    while frame is not None:
        spec = frame.f_locals.get("spec")
        if frame.f_globals.get("__name__") == "importlib._bootstrap" and isinstance(spec, ModuleSpec):
            return spec.name
        frame = frame.f_back
    return None


def import_what_answers_need() -> None:
    """Import rclpy, the modules that the first node loads, and the messages that most answers use.

    The middleware isn't imported, because a program may choose one (with RMW_IMPLEMENTATION) before it creates a
    context.
    """
    for name in WARMED:
        importlib.import_module(name)
    for package in TYPE_SUPPORT:
        importlib.import_module(f"{package}.{package}_s__rosidl_typesupport_c")
    _look_up_their_files()


def _look_up_their_files() -> None:
    """Make `inspect` cache the modules' file names, which it does when it searches for the module of an unknown file.

    rclpy uses `inspect` to find a logger's caller. Without the cache, a program's first log message would cause several
    thousand system calls.
    """
    inspect.getmodule(compile("", "nowhere", "exec"))

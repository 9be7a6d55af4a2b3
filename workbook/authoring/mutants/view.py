"""A program's syntax tree with the position and the parent of each node."""

from collections.abc import Iterator
from dataclasses import dataclass

import libcst as cst
from libcst.metadata import MetadataWrapper, ParentNodeProvider, PositionProvider

LEFT_ALONE = (cst.Annotation, cst.Import, cst.ImportFrom)
"""Nodes that operators skip: imports, and type hints, which only a type checker reads."""


@dataclass(frozen=True)
class Edit:
    """One change to a program: `new` replaces the node `old`. `operator` names the kind of change."""

    operator: str
    old: cst.CSTNode
    new: cst.CSTNode | cst.RemovalSentinel


class View:
    """The syntax tree of one program, with parents, lines, and scope names.

    Raises:
        libcst.ParserSyntaxError: the program isn't valid Python.
    """

    def __init__(self, program: str) -> None:
        wrapper = MetadataWrapper(cst.parse_module(program), unsafe_skip_copy=True)
        self.module = wrapper.module
        self._parents = wrapper.resolve(ParentNodeProvider)
        self._positions = wrapper.resolve(PositionProvider)

    def nodes(self) -> Iterator[cst.CSTNode]:
        """Yield all nodes from top to bottom, except docstrings, imports, and type hints."""
        yield from self._below(self.module)

    def _below(self, node: cst.CSTNode) -> Iterator[cst.CSTNode]:
        if isinstance(node, LEFT_ALONE) or is_bare_text(node):
            return
        yield node
        for child in node.children:
            yield from self._below(child)

    def parent(self, node: cst.CSTNode) -> cst.CSTNode | None:
        """Return the parent node, or None for the module."""
        return self._parents.get(node)

    def ancestors(self, node: cst.CSTNode) -> Iterator[cst.CSTNode]:
        """Yield the node itself and then its ancestors, innermost first."""
        one: cst.CSTNode | None = node
        while one is not None:
            yield one
            one = self.parent(one)

    def function(self, node: cst.CSTNode) -> cst.FunctionDef | None:
        """Return the innermost function that contains the node or is the node, or None if there is none."""
        return next((one for one in self.ancestors(node) if isinstance(one, cst.FunctionDef)), None)

    def scope(self, node: cst.CSTNode) -> str:
        """Return the qualified name of the innermost class or function around the node, such as "Robot.tick".

        At module level, return "".
        """
        names = [
            one.name.value for one in self.ancestors(node) if isinstance(one, (cst.FunctionDef, cst.ClassDef))
        ]
        return ".".join(reversed(names))

    def line(self, node: cst.CSTNode) -> int:
        """Return the node's first line, counted from 1."""
        return int(self._positions[node].start.line)

    def code(self, node: cst.CSTNode) -> str:
        """Return the source text of a node."""
        return self.module.code_for_node(node).strip()

    def edited(self, edit: Edit) -> str:
        """Return the program after an edit."""
        if isinstance(edit.new, cst.RemovalSentinel):
            changed: object = self.module.deep_remove(edit.old)
        else:
            changed = self.module.deep_replace(edit.old, edit.new)
        assert isinstance(changed, cst.Module)
        return changed.code


def is_bare_text(node: cst.CSTNode) -> bool:
    """Return whether a statement is only a string, such as a docstring."""
    return (
        isinstance(node, cst.SimpleStatementLine)
        and len(node.body) == 1
        and isinstance(node.body[0], cst.Expr)
        and isinstance(node.body[0].value, (cst.SimpleString, cst.ConcatenatedString))
    )


def called_name(call: cst.Call) -> str:
    """Return the last part of the called name, such as "spin" for `rclpy.spin(node)`, or "" if there is no name."""
    return last_name(call.func)


def last_name(node: cst.CSTNode) -> str:
    """Return the last part of a dotted name, or "" for anything else."""
    if isinstance(node, cst.Attribute):
        return node.attr.value
    return node.value if isinstance(node, cst.Name) else ""


def statements_of(function: cst.FunctionDef) -> list[cst.BaseStatement]:
    """Return a function's statements without its docstring, or an empty list if the function is written on one line."""
    if not isinstance(function.body, cst.IndentedBlock):
        return []
    return [one for one in function.body.body if not is_bare_text(one)]

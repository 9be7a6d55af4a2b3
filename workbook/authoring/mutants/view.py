"""A program as a syntax tree that knows where each node stands."""

from collections.abc import Iterator
from dataclasses import dataclass

import libcst as cst
from libcst.metadata import MetadataWrapper, ParentNodeProvider, PositionProvider

LEFT_ALONE = (cst.Annotation, cst.Import, cst.ImportFrom)
"""What no operator looks into: imports, and hints, which only a type checker reads."""


@dataclass(frozen=True)
class Edit:
    """One change of a program: the node `old` gives way to `new`. `operator` says what kind of change it is."""

    operator: str
    old: cst.CSTNode
    new: cst.CSTNode | cst.RemovalSentinel


class View:
    """The tree of one program, with parents, lines and names of scopes.

    Raises:
        libcst.ParserSyntaxError: the program is not Python.
    """

    def __init__(self, program: str) -> None:
        wrapper = MetadataWrapper(cst.parse_module(program), unsafe_skip_copy=True)
        self.module = wrapper.module
        self._parents = wrapper.resolve(ParentNodeProvider)
        self._positions = wrapper.resolve(PositionProvider)

    def nodes(self) -> Iterator[cst.CSTNode]:
        """All nodes from top to bottom, without docstrings, imports and hints."""
        yield from self._below(self.module)

    def _below(self, node: cst.CSTNode) -> Iterator[cst.CSTNode]:
        if isinstance(node, LEFT_ALONE) or is_bare_text(node):
            return
        yield node
        for child in node.children:
            yield from self._below(child)

    def parent(self, node: cst.CSTNode) -> cst.CSTNode | None:
        """The node that holds this one; None for the module."""
        return self._parents.get(node)

    def ancestors(self, node: cst.CSTNode) -> Iterator[cst.CSTNode]:
        """The node itself, and all that hold it, from the inside out."""
        one: cst.CSTNode | None = node
        while one is not None:
            yield one
            one = self.parent(one)

    def function(self, node: cst.CSTNode) -> cst.FunctionDef | None:
        """The innermost function that the node stands in, or that it is."""
        return next((one for one in self.ancestors(node) if isinstance(one, cst.FunctionDef)), None)

    def scope(self, node: cst.CSTNode) -> str:
        """The qualified name of the class or function that the node stands in, such as "Robot.tick"; "" at the top."""
        names = [
            one.name.value for one in self.ancestors(node) if isinstance(one, (cst.FunctionDef, cst.ClassDef))
        ]
        return ".".join(reversed(names))

    def line(self, node: cst.CSTNode) -> int:
        """The line that the node begins on."""
        return int(self._positions[node].start.line)

    def code(self, node: cst.CSTNode) -> str:
        """The source text of a node."""
        return self.module.code_for_node(node).strip()

    def edited(self, edit: Edit) -> str:
        """The program after an edit."""
        if isinstance(edit.new, cst.RemovalSentinel):
            changed: object = self.module.deep_remove(edit.old)
        else:
            changed = self.module.deep_replace(edit.old, edit.new)
        assert isinstance(changed, cst.Module)
        return changed.code


def is_bare_text(node: cst.CSTNode) -> bool:
    """Whether a statement is a text and nothing else: a docstring."""
    return (
        isinstance(node, cst.SimpleStatementLine)
        and len(node.body) == 1
        and isinstance(node.body[0], cst.Expr)
        and isinstance(node.body[0].value, (cst.SimpleString, cst.ConcatenatedString))
    )


def called_name(call: cst.Call) -> str:
    """The last part of the name that is called: "spin" of `rclpy.spin(node)`; "" if it has none."""
    return last_name(call.func)


def last_name(node: cst.CSTNode) -> str:
    """The last part of a dotted name; "" for anything else."""
    if isinstance(node, cst.Attribute):
        return node.attr.value
    return node.value if isinstance(node, cst.Name) else ""


def statements_of(function: cst.FunctionDef) -> list[cst.BaseStatement]:
    """The statements of a function without its docstring; empty for one that is written on one line."""
    if not isinstance(function.body, cst.IndentedBlock):
        return []
    return [one for one in function.body.body if not is_bare_text(one)]

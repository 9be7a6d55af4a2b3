"""Mutation operators that change literals: numbers, strings, and booleans."""

from collections.abc import Iterator

import libcst as cst

from workbook.authoring.mutants.view import Edit, View

LARGE = 10.0
"""For whole floats of at least this magnitude, adding or subtracting one is a small change, so we try both, too."""


def literal(value: object) -> cst.BaseExpression:
    """Return a value as a syntax node. Negative numbers get parentheses, so that they fit anywhere."""
    code = repr(value)
    return cst.parse_expression(f"({code})" if code.startswith("-") else code)


def numbers(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """Yield edits that change a number. An int is changed by one; a float is doubled, halved, or negated.

    A whole float also becomes an int and, if its magnitude is at least `LARGE`, is changed by one. Zero becomes 1.0 or
    -1.0.
    """
    if isinstance(node, cst.Integer):
        value = node.evaluated_value
        for other in (value + 1, value - 1):
            yield Edit("number", node, literal(other))
    elif isinstance(node, cst.Float):
        yield from _floats(node, node.evaluated_value)


def _floats(node: cst.Float, value: float) -> Iterator[Edit]:
    near = [1.0, -1.0] if value == 0.0 else [value * 2.0, value / 2.0]
    if value.is_integer() and abs(value) >= LARGE:
        near += [value + 1.0, value - 1.0]
    for other in near:
        yield Edit("number", node, literal(other))
    if value:
        yield Edit("sign", node, literal(-value))
    if value.is_integer():
        yield Edit("number-type", node, literal(int(value)))


def texts(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """Yield edits that lengthen or empty a string, replace one value of an f-string, or drop the value's format."""
    if isinstance(node, cst.SimpleString) and isinstance(node.evaluated_value, str):
        value = node.evaluated_value
        for other in (value + "x", "") if value else ("x",):
            yield Edit("text", node, literal(other))
    elif isinstance(node, cst.FormattedString):
        for part in node.parts:
            if isinstance(part, cst.FormattedStringExpression):
                yield Edit("text", part, cst.FormattedStringText("x"))
                if part.format_spec is not None:
                    yield Edit("text", part, part.with_changes(format_spec=None))


def booleans(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """Yield edits that flip `True` and `False`."""
    if isinstance(node, cst.Name) and node.value in ("True", "False"):
        yield Edit("boolean", node, cst.Name("False" if node.value == "True" else "True"))

"""Operators on statements: drop them, return early, shorten loops, and handle fewer exceptions."""

from collections.abc import Iterator

import libcst as cst

from workbook.authoring.mutants.view import Edit, View, is_bare_text, statements_of

PASS = cst.SimpleStatementLine([cst.Pass()])
RETURN = cst.SimpleStatementLine([cst.Return()])
DROPPED = (cst.Expr, cst.Assign, cst.AnnAssign, cst.AugAssign, cst.Raise, cst.Return, cst.Assert, cst.Del)
COMPOUND = (cst.If, cst.For, cst.While, cst.With)


def drops(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """Yield edits that drop a statement, an `else`, or a whole `if`, loop, or `with`."""
    if isinstance(node, cst.SimpleStatementLine):
        only = node.body[0] if len(node.body) == 1 else None
        is_hint = isinstance(only, cst.AnnAssign) and only.value is None
        if isinstance(only, DROPPED) and not is_hint and not is_bare_text(node):
            yield Edit("drop", node, PASS.with_changes(leading_lines=node.leading_lines))
    elif isinstance(node, COMPOUND):
        if not isinstance(view.parent(node), cst.If):  # `pass` can't replace an `elif`
            yield Edit("drop", node, PASS.with_changes(leading_lines=node.leading_lines))
        if isinstance(node, cst.If) and isinstance(node.orelse, cst.Else):
            yield Edit("drop", node.orelse, cst.RemoveFromParent())


def early_returns(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """Yield edits that insert a `return` before a statement of a function."""
    if not isinstance(node, cst.FunctionDef):
        return
    for statement in statements_of(node):
        if not _returns(statement):
            body = node.body.body
            at = next(index for index, one in enumerate(body) if one is statement)
            cut = [*body[:at], RETURN, *body[at:]]
            yield Edit("early-return", node, node.with_changes(body=node.body.with_changes(body=cut)))


def _returns(statement: cst.BaseStatement) -> bool:
    return isinstance(statement, cst.SimpleStatementLine) and isinstance(
        statement.body[0], (cst.Return, cst.Pass)
    )


def loops(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """Yield edits that limit a loop to the first item, skip the first or last item, or swap `break` and `continue`."""
    if isinstance(node, (cst.For, cst.CompFor)):
        for cut in ("[:1]", "[1:]", "[:-1]"):
            part = cst.parse_expression(f"list(x){cut}")
            assert isinstance(part, cst.Subscript) and isinstance(part.value, cst.Call)
            whole = part.value.with_changes(args=[cst.Arg(node.iter)])
            yield Edit("loop", node.iter, part.with_changes(value=whole))
    elif isinstance(node, cst.Break):
        yield Edit("loop", node, cst.Continue())
    elif isinstance(node, cst.Continue):
        yield Edit("loop", node, cst.Break())


def exceptions(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """Yield edits that make a handler reraise, drop one of several caught types, or drop a `finally`."""
    if isinstance(node, cst.ExceptHandler) and isinstance(node.body, cst.IndentedBlock):
        again = node.body.with_changes(body=[cst.SimpleStatementLine([cst.Raise()])])
        yield Edit("exception", node, node.with_changes(body=again))
        if isinstance(node.type, cst.Tuple) and len(node.type.elements) > 1:
            for left_out in node.type.elements:
                rest = [cst.Element(one.value) for one in node.type.elements if one is not left_out]
                yield Edit("exception", node.type, cst.Tuple(rest))
    elif isinstance(node, cst.Try) and node.finalbody is not None and node.handlers:
        yield Edit("exception", node.finalbody, cst.RemoveFromParent())

"""Operators on comparisons, conditions, and arithmetic."""

from collections.abc import Iterator

import libcst as cst

from workbook.authoring.mutants.view import Edit, View

TURNED: dict[type[cst.BaseCompOp], tuple[cst.BaseCompOp, ...]] = {
    cst.LessThan: (cst.LessThanEqual(), cst.GreaterThanEqual()),
    cst.LessThanEqual: (cst.LessThan(), cst.GreaterThan()),
    cst.GreaterThan: (cst.GreaterThanEqual(), cst.LessThanEqual()),
    cst.GreaterThanEqual: (cst.GreaterThan(), cst.LessThan()),
    cst.Equal: (cst.NotEqual(),),
    cst.NotEqual: (cst.Equal(),),
    cst.In: (cst.NotIn(),),
    cst.NotIn: (cst.In(),),
    cst.Is: (cst.IsNot(),),
    cst.IsNot: (cst.Is(),),
}
"""Replacements for each comparison operator: one with a shifted boundary, and the opposite."""
SWAPPED: dict[type[cst.BaseBinaryOp], cst.BaseBinaryOp] = {
    cst.Add: cst.Subtract(),
    cst.Subtract: cst.Add(),
    cst.Multiply: cst.Divide(),
    cst.Divide: cst.Multiply(),
    cst.FloorDivide: cst.Divide(),
    cst.Modulo: cst.FloorDivide(),
}
SWAPPED_IN_PLACE: dict[type[cst.BaseAugOp], cst.BaseAugOp] = {
    cst.AddAssign: cst.SubtractAssign(),
    cst.SubtractAssign: cst.AddAssign(),
    cst.MultiplyAssign: cst.DivideAssign(),
    cst.DivideAssign: cst.MultiplyAssign(),
}


def comparisons(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """Yield edits that change a comparison operator, or drop one half of a chain such as `0 <= x <= 100`."""
    if not isinstance(node, cst.Comparison):
        return
    for target in node.comparisons:
        for other in TURNED.get(type(target.operator), ()):
            yield Edit("compare", target, target.with_changes(operator=other))
    if len(node.comparisons) == 2:
        first, second = node.comparisons
        yield Edit("compare", node, node.with_changes(comparisons=[first]))
        yield Edit("compare", node, node.with_changes(left=first.comparator, comparisons=[second]))


def conditions(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """Yield edits that negate a condition or make it constant, or that negate or drop a comprehension's filter."""
    if isinstance(node, (cst.If, cst.While, cst.IfExp, cst.Assert)):
        test = node.test
        yield Edit("condition", test, negated(test))
        for always in ("True", "False"):
            yield Edit("condition", test, cst.Name(always))
    elif isinstance(node, cst.CompFor):
        for filtering in node.ifs:
            yield Edit("condition", filtering, cst.RemoveFromParent())
            yield Edit("condition", filtering.test, negated(filtering.test))


def negated(test: cst.BaseExpression) -> cst.BaseExpression:
    """Return `not (test)`, or the test's operand if the test already begins with `not`."""
    if isinstance(test, cst.UnaryOperation) and isinstance(test.operator, cst.Not):
        return test.expression
    return cst.UnaryOperation(cst.Not(), test.with_changes(lpar=[cst.LeftParen()], rpar=[cst.RightParen()]))


def connectives(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """Yield edits that swap `and` and `or`, keep only one operand, or drop a `not` or a minus sign."""
    if isinstance(node, cst.BooleanOperation):
        other = cst.Or() if isinstance(node.operator, cst.And) else cst.And()
        yield Edit("connective", node, node.with_changes(operator=other))
        yield Edit("connective", node, node.left)
        yield Edit("connective", node, node.right)
    elif isinstance(node, cst.UnaryOperation) and isinstance(node.operator, (cst.Not, cst.Minus)):
        yield Edit("connective", node, node.expression)


def arithmetic(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """Yield edits that replace an arithmetic operator, including the one in `+=`, or that turn `+=` into `=`."""
    if isinstance(node, cst.BinaryOperation) and type(node.operator) in SWAPPED:
        if not is_text(node.left) and not is_text(node.right):
            yield Edit("arithmetic", node, node.with_changes(operator=SWAPPED[type(node.operator)]))
    elif isinstance(node, cst.AugAssign):
        swapped = SWAPPED_IN_PLACE.get(type(node.operator))
        if swapped is not None:
            yield Edit("arithmetic", node, node.with_changes(operator=swapped))
        yield Edit("state", node, cst.Assign([cst.AssignTarget(node.target)], node.value))


def is_text(node: cst.CSTNode) -> bool:
    """Return whether an operand is a string literal. Strings have no arithmetic."""
    return isinstance(node, (cst.SimpleString, cst.FormattedString, cst.ConcatenatedString))

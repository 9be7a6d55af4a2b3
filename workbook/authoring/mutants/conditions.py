"""Operators on comparisons, conditions and arithmetic."""

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
"""For each comparison the near ones: its border moved, and its contrary."""
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
    """A comparison turned; one of the two of a chain such as `0 <= x <= 100` left out."""
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
    """A condition negated, always true or always false; the filter of a comprehension left out."""
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
    """`not (test)`; what stood behind a `not`, if it began with one."""
    if isinstance(test, cst.UnaryOperation) and isinstance(test.operator, cst.Not):
        return test.expression
    return cst.UnaryOperation(cst.Not(), test.with_changes(lpar=[cst.LeftParen()], rpar=[cst.RightParen()]))


def connectives(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """`or` for `and`, and one of the two sides left out; a `not` left out."""
    if isinstance(node, cst.BooleanOperation):
        other = cst.Or() if isinstance(node.operator, cst.And) else cst.And()
        yield Edit("connective", node, node.with_changes(operator=other))
        yield Edit("connective", node, node.left)
        yield Edit("connective", node, node.right)
    elif isinstance(node, cst.UnaryOperation) and isinstance(node.operator, (cst.Not, cst.Minus)):
        yield Edit("connective", node, node.expression)


def arithmetic(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """Plus for minus, times for divided by; in place, too; `=` for `+=`."""
    if isinstance(node, cst.BinaryOperation) and type(node.operator) in SWAPPED:
        if not is_text(node.left) and not is_text(node.right):
            yield Edit("arithmetic", node, node.with_changes(operator=SWAPPED[type(node.operator)]))
    elif isinstance(node, cst.AugAssign):
        swapped = SWAPPED_IN_PLACE.get(type(node.operator))
        if swapped is not None:
            yield Edit("arithmetic", node, node.with_changes(operator=swapped))
        yield Edit("state", node, cst.Assign([cst.AssignTarget(node.target)], node.value))


def is_text(node: cst.CSTNode) -> bool:
    """Whether an operand is a text, for which there is no arithmetic."""
    return isinstance(node, (cst.SimpleString, cst.FormattedString, cst.ConcatenatedString))

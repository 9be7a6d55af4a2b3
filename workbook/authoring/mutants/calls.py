"""Operators on calls: replace a function with a similar one, drop an argument, or swap two arguments."""

from collections.abc import Iterator, Sequence

import libcst as cst

from workbook.authoring.mutants.view import Edit, View, last_name

PAIRS = (
    ("max", "min"), ("any", "all"), ("sin", "cos"), ("floor", "ceil"), ("isfinite", "isnan"),
    ("append", "appendleft"), ("popleft", "pop"), ("monotonic", "time"), ("cancel", "reset"),
    ("call_async", "call"), ("spin", "spin_once"), ("set", "clear"), ("set_result", "cancel"), ("round", "int"),
    ("wait_for_service", "service_is_ready"), ("add_node", "remove_node"), ("radians", "degrees"),
    ("SingleThreadedExecutor", "MultiThreadedExecutor"),
    ("MutuallyExclusiveCallbackGroup", "ReentrantCallbackGroup"),
    ("RELIABLE", "BEST_EFFORT"), ("TRANSIENT_LOCAL", "VOLATILE"), ("KEEP_LAST", "KEEP_ALL"),
    ("Float32", "Float64"), ("Int32", "Int64"), ("Float32MultiArray", "Float64MultiArray"),
    ("nanoseconds", "seconds_nanoseconds"),
)  # fmt: skip
"""Names that are easily confused with each other, mostly from Python and rclpy."""
NEAR = {one: other for pair in PAIRS for one, other in (pair, pair[::-1])}
NOT_CALLED = ("RELIABLE", "BEST_EFFORT", "TRANSIENT_LOCAL", "VOLATILE", "KEEP_LAST", "KEEP_ALL")
MESSAGES = ("Float32", "Float64", "Int32", "Int64", "Float32MultiArray", "Float64MultiArray")


def near_calls(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """Yield edits that replace a function, class, or QoS policy with a similar one."""
    if isinstance(node, cst.Call):
        name = last_name(node.func)
        if name in NEAR and name not in MESSAGES:
            yield Edit("call", node.func, _renamed(node.func, NEAR[name]))
    elif isinstance(node, cst.Attribute) and node.attr.value in NOT_CALLED:
        yield Edit("call", node, _renamed(node, NEAR[node.attr.value]))


def _renamed(func: cst.BaseExpression, name: str) -> cst.BaseExpression:
    new = cst.Name(name)
    return func.with_changes(attr=new) if isinstance(func, cst.Attribute) else new


def unwrapped(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """Yield edits that replace a call with one of its arguments, if the call has only one or two positional ones.

    `float(x)` becomes `x`, and `max(0.0, x)` becomes `0.0` or `x`.
    """
    if not isinstance(node, cst.Call) or isinstance(view.parent(node), (cst.Expr, cst.Await, cst.WithItem)):
        return
    plain = [arg.value for arg in node.args if arg.keyword is None and not arg.star]
    if len(plain) == len(node.args) and 1 <= len(plain) <= 2:
        for value in plain:
            yield Edit("argument", node, value)


def fewer_arguments(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """Yield edits that drop a keyword argument."""
    if isinstance(node, cst.Call):
        for arg in node.args:
            if arg.keyword is not None:
                rest = [one for one in node.args if one is not arg]
                yield Edit("argument", node, node.with_changes(args=_listed(rest)))


def swapped_arguments(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """Yield edits that swap two neighboring positional arguments."""
    if not isinstance(node, cst.Call):
        return
    count = sum(arg.keyword is None and not arg.star for arg in node.args)
    for at in range(count - 1):
        args = [*node.args]
        args[at], args[at + 1] = args[at + 1], args[at]
        yield Edit("swap", node, node.with_changes(args=_listed(args)))


def _listed(args: Sequence[cst.Arg]) -> list[cst.Arg]:
    """Return the arguments separated by commas, for a call on one line."""
    comma = cst.Comma(whitespace_after=cst.SimpleWhitespace(" "))
    plain = cst.SimpleWhitespace("")
    return [
        arg.with_changes(
            comma=comma if number < len(args) - 1 else cst.MaybeSentinel.DEFAULT, whitespace_after_arg=plain
        )
        for number, arg in enumerate(args)
    ]

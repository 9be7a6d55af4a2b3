"""Use rules about the changed syntax node to recognize classes of mutants that instructors accept."""

from collections.abc import Iterator, Mapping

import libcst as cst

from workbook.authoring.mutants.view import Edit, View, called_name, last_name

CLASSES: Mapping[str, str] = {
    "log-text": "what the program prints or logs is not judged",
    "queue-depth": "the depth of a queue may be chosen",
    "node-name": "the name of the node may be chosen",
    "ending": "how the program ends is not judged",
    "main-guard": "a program is run as it is, or its main() is called",
    "init-arguments": "rclpy takes the arguments of the process if it is given none",
    "unused-default": "every call passes a value",
    "poll-time": "how long one poll of the executor waits may be chosen",
    "whole-number": "comparisons, calculations and timers treat 2 and 2.0 alike",
}
"""The reason why each class is accepted. A report's `judged_here` lists classes that its exercise doesn't accept."""
NEVER_JUDGED = ("log-text",)
"""Mutants of these classes are never run."""
LOGS = ("debug", "info", "warn", "warning", "error", "fatal", "exception")
MAKES_NODES = ("__init__", "Node", "create_node")
DEPTH_PLACE = {"create_publisher": 2, "create_lifecycle_publisher": 2, "create_subscription": 3}
"""Position of the queue depth among the arguments, counted from 0."""
ENDS = (
    "shutdown",
    "try_shutdown",
    "destroy_node",
    "destroy_timer",
    "destroy_publisher",
    "destroy_subscription",
)
RUNS = ("rclpy.ok()", "ok()")
"""Conditions of loops that run until the program is shut down."""
TAKES_SECONDS = ("create_timer", "sleep", "create_rate", "Duration")
POLLS = ("spin_once", "spin_until_future_complete")
COMPUTES = (cst.Comparison, cst.ComparisonTarget, cst.BinaryOperation, cst.UnaryOperation)
END_EXCEPTIONS = ("KeyboardInterrupt", "ExternalShutdownException", "SystemExit")


def classes_of(edit: Edit, view: View) -> Iterator[str]:
    """Yield the accepted classes that an edit belongs to."""
    node = edit.old
    around = list(view.ancestors(node))
    if _is_logging(node) or any(isinstance(one, cst.Call) and _logs(one) for one in around):
        yield "log-text"
    if any(_is_depth(inner, outer) for inner, outer in zip(around, around[1:], strict=False)):
        yield "queue-depth"
    if isinstance(node, cst.SimpleString) and _names_a_node(around):
        yield "node-name"
    if (
        _ends(node)
        or view.code(node) in RUNS
        or any(isinstance(one, cst.Finally) or _handles_the_end(one) for one in around)
    ):
        yield "ending"
    if any(isinstance(one, cst.If) and "__name__" in view.code(one.test) for one in around):
        yield "main-guard"
    if any(_is_init(one) for one in around):
        yield "init-arguments"
    if any(isinstance(one, cst.Param) and _is_unused_default(node, one, view) for one in around):
        yield "unused-default"
    if any(isinstance(one, cst.Arg) and _is_poll_time(one, view) for one in around) or _drops_poll_time(edit):
        yield "poll-time"
    if edit.operator == "number-type" and _only_computes(node, view):
        yield "whole-number"


def _is_logging(node: cst.CSTNode) -> bool:
    """Return whether the node is a statement that only prints or logs."""
    if not isinstance(node, cst.SimpleStatementLine) or not isinstance(node.body[0], cst.Expr):
        return False
    call = node.body[0].value
    return isinstance(call, cst.Call) and _logs(call)


def _logs(call: cst.Call) -> bool:
    if isinstance(call.func, cst.Name):
        return call.func.value == "print"
    if not isinstance(call.func, cst.Attribute) or call.func.attr.value not in LOGS:
        return False
    of = call.func.value
    return "log" in (called_name(of) if isinstance(of, cst.Call) else last_name(of)).lower()


def _is_depth(inner: cst.CSTNode, outer: cst.CSTNode) -> bool:
    """Return whether `inner` is the argument of the call `outer` that sets a queue depth."""
    if isinstance(inner, cst.Arg) and isinstance(outer, cst.Call):
        keyword = inner.keyword.value if inner.keyword is not None else None
        if keyword == "depth":
            return True
        place = DEPTH_PLACE.get(called_name(outer))
        at = next((number for number, one in enumerate(outer.args) if one is inner), None)
        is_number = isinstance(inner.value, cst.Integer)
        return is_number and place is not None and (keyword == "qos_profile" or at == place)
    return False


def _names_a_node(around: list[cst.CSTNode]) -> bool:
    return (
        len(around) > 2
        and isinstance(around[1], cst.Arg)
        and isinstance(around[2], cst.Call)
        and called_name(around[2]) in MAKES_NODES
        and around[2].args[0] is around[1]
    )


def _ends(node: cst.CSTNode) -> bool:
    """Return whether the node is a statement that only shuts down or destroys something."""
    if not isinstance(node, cst.SimpleStatementLine) or not isinstance(node.body[0], cst.Expr):
        return False
    call = node.body[0].value
    return isinstance(call, cst.Call) and called_name(call) in ENDS


def _handles_the_end(node: cst.CSTNode) -> bool:
    """Return whether the node is an exception handler for Ctrl-C or a shutdown."""
    if not isinstance(node, cst.ExceptHandler) or node.type is None:
        return False
    types = [one.value for one in node.type.elements] if isinstance(node.type, cst.Tuple) else [node.type]
    return any(last_name(one) in END_EXCEPTIONS for one in types)


def _is_init(node: cst.CSTNode) -> bool:
    return (
        isinstance(node, cst.Call)
        and isinstance(node.func, cst.Attribute)
        and node.func.attr.value == "init"
        and last_name(node.func.value) == "rclpy"
    )


def _only_computes(number: cst.CSTNode, view: View) -> bool:
    """Return whether a number is only compared, computed with, or used as a duration.

    Such a number never gets into a message unchanged, so its type doesn't matter.
    """
    parent = view.parent(number)
    call = view.parent(parent) if isinstance(parent, cst.Arg) else None
    return isinstance(parent, COMPUTES) or (isinstance(call, cst.Call) and called_name(call) in TAKES_SECONDS)


def _is_poll_time(arg: cst.Arg, view: View) -> bool:
    call = view.parent(arg)
    named = arg.keyword is not None and arg.keyword.value == "timeout_sec"
    return named and isinstance(call, cst.Call) and called_name(call) in POLLS


def _drops_poll_time(edit: Edit) -> bool:
    """Return whether an edit only removes a polling call's `timeout_sec`."""
    old, new = edit.old, edit.new
    if not isinstance(old, cst.Call) or not isinstance(new, cst.Call) or called_name(old) not in POLLS:
        return False
    names = [{one.keyword.value for one in call.args if one.keyword is not None} for call in (old, new)]
    return names[0] - names[1] == {"timeout_sec"}


def _is_unused_default(node: cst.CSTNode, param: cst.Param, view: View) -> bool:
    """Return whether the node is in a parameter's default that is never used, because every call passes a value."""
    function = view.function(param)
    if (
        function is None
        or param.default is None
        or not any(one is param.default for one in view.ancestors(node))
    ):
        return False
    name = function.name.value
    if name == "__init__":  # it is called through the class name
        holder = next((one for one in view.ancestors(function) if isinstance(one, cst.ClassDef)), None)
        name = holder.name.value if holder is not None else name
    params = [one.name.value for one in function.params.params if one.name.value != "self"]
    made = [one for one in view.nodes() if isinstance(one, cst.Call) and called_name(one) == name]
    return bool(made) and all(_passes(call, param.name.value, params) for call in made)


def _passes(call: cst.Call, name: str, params: list[str]) -> bool:
    if any(one.keyword is not None and one.keyword.value == name for one in call.args):
        return True
    count = sum(one.keyword is None and not one.star for one in call.args)
    return name in params and params.index(name) < count

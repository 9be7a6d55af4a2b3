"""Operators on state: keep state that a function shouldn't keep, or reset state that it should keep."""

from collections.abc import Iterator

import libcst as cst

from workbook.authoring.mutants.view import Edit, View, is_bare_text, statements_of

SEEN = "mutant_seen"
ONCE = (
    f"if {SEEN}:\n    return\n{SEEN}.append(1)\n",  # only the first call works
    f"if not {SEEN}:\n    {SEEN}.append(1)\n    return\n",  # the first call does nothing
    f"{SEEN}.append(1)\nif len({SEEN}) % 2 == 0:\n    return\n",  # every second call does nothing
    f"{SEEN}.append(1)\nif len({SEEN}) > 5:\n    return\n",  # only the first five calls work
)
NOT_TWICE = f"if {SEEN} == [repr({{name}})]:\n    return\n{SEEN}[:] = [repr({{name}})]\n"
NOT_AGAIN = f"if repr({{name}}) in {SEEN}:\n    return\n{SEEN}.append(repr({{name}}))\n"
ENTRY = ("main", "__init__", "__post_init__")


def forgetful_calls(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """Yield edits that make a function without a result do nothing in some of its calls.

    The edited function works only in the first call, in all calls but the first, in every second call, or in the first
    five. If it has a parameter, further edits skip a call whose first argument equals the previous call's or any
    earlier call's.
    """
    if not isinstance(node, cst.FunctionDef) or not _may_be_skipped(node):
        return
    lines = [*ONCE]
    names = [one.name.value for one in node.params.params if one.name.value != "self"]
    if names:
        lines += [NOT_TWICE.format(name=names[0]), NOT_AGAIN.format(name=names[0])]
    for code in lines:
        yield Edit("state", node, _remembering(node, code))


def _may_be_skipped(node: cst.FunctionDef) -> bool:
    params = node.params
    plain = (
        not params.kwonly_params and params.star_kwarg is None and not isinstance(params.star_arg, cst.Param)
    )
    return plain and bool(statements_of(node)) and node.name.value not in ENTRY and not gives_a_result(node)


def gives_a_result(function: cst.FunctionDef) -> bool:
    """Return whether a function returns or yields a value."""
    waiting: list[cst.CSTNode] = [function.body]
    while waiting:
        node = waiting.pop()
        if isinstance(node, cst.Yield) or (isinstance(node, cst.Return) and node.value is not None):
            return True
        if not isinstance(node, (cst.FunctionDef, cst.Lambda)):
            waiting += node.children
    return False


def _remembering(node: cst.FunctionDef, code: str) -> cst.FunctionDef:
    """Return the function with `code` at its beginning, and a mutable default argument that outlives each call."""
    hint = cst.Annotation(cst.parse_expression("list[object]"))
    seen = cst.Param(cst.Name(SEEN), hint, default=cst.parse_expression("[]"))
    params = node.params.with_changes(star_arg=cst.ParamStar(), kwonly_params=[seen])
    return _begun_with(node, code).with_changes(params=params)


def _begun_with(node: cst.FunctionDef, code: str) -> cst.FunctionDef:
    """Return the function with `code` before its first statement, but after its docstring."""
    body = node.body.body
    first = 1 if is_bare_text(body[0]) else 0
    new = [*body[:first], *cst.parse_module(code).body, *body[first:]]
    return node.with_changes(body=node.body.with_changes(body=new))


def lost_state(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """Yield edits that reset an attribute to its initial value at the beginning of each method that changes it."""
    if not isinstance(node, cst.FunctionDef) or node.name.value in ENTRY or not statements_of(node):
        return
    for name, value in _first_values(node, view).items():
        if _assigns(node, name):
            yield Edit("state", node, _begun_with(node, f"self.{name} = {value}\n"))


def _first_values(node: cst.FunctionDef, view: View) -> dict[str, str]:
    """Return the initial value of each attribute, as the source code that `__init__` of the node's class assigns."""
    found: dict[str, str] = {}
    inside = next((one for one in view.ancestors(node) if isinstance(one, cst.ClassDef)), None)
    for method in inside.body.body if inside is not None else ():
        if isinstance(method, cst.FunctionDef) and method.name.value == "__init__":
            for target, value in _assignments(method):
                found[target] = view.code(value)
    return found


def _assigns(node: cst.FunctionDef, name: str) -> bool:
    return any(target == name for target, _ in _assignments(node))


def _assignments(node: cst.CSTNode) -> Iterator[tuple[str, cst.BaseExpression]]:
    """Yield each attribute of `self` that is assigned inside a node, with the assigned value."""
    if isinstance(node, (cst.Assign, cst.AnnAssign, cst.AugAssign)) and node.value is not None:
        targets = [one.target for one in node.targets] if isinstance(node, cst.Assign) else [node.target]
        for target in targets:
            if isinstance(target, cst.Attribute) and isinstance(target.value, cst.Name):
                if target.value.value == "self":
                    yield target.attr.value, node.value
    for child in node.children:
        yield from _assignments(child)


def kept_results(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """Yield edits that make a function cache its results."""
    if not isinstance(node, cst.FunctionDef) or not gives_a_result(node) or node.asynchronous is not None:
        return
    if node.name.value not in ENTRY and not node.decorators:
        kept = cst.Decorator(cst.parse_expression('__import__("functools").cache'))
        yield Edit("state", node, node.with_changes(decorators=[kept]))


def missing_hints(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """Yield edits that drop a type hint or replace it with `object`, for exercises judged with a type checker."""
    if isinstance(node, cst.Param) and node.annotation is not None:
        yield Edit("hint", node, node.with_changes(annotation=None))
        yield Edit("hint", node.annotation.annotation, cst.Name("object"))
    elif isinstance(node, cst.FunctionDef) and node.returns is not None:
        yield Edit("hint", node, node.with_changes(returns=None))
        yield Edit("hint", node.returns.annotation, cst.Name("object"))

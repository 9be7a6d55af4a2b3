"""Operators on state: a callback that remembers what it should not, or forgets what it should remember."""

from collections.abc import Iterator

import libcst as cst

from workbook.authoring.mutants.view import Edit, View, is_bare_text, statements_of

SEEN = "mutant_seen"
ONCE = (
    f"if {SEEN}:\n    return\n{SEEN}.append(1)\n",  # the first time only
    f"if not {SEEN}:\n    {SEEN}.append(1)\n    return\n",  # not the first time
    f"{SEEN}.append(1)\nif len({SEEN}) % 2 == 0:\n    return\n",  # every second time
    f"{SEEN}.append(1)\nif len({SEEN}) > 5:\n    return\n",  # for a while
)
NOT_TWICE = f"if {SEEN} == [repr({{name}})]:\n    return\n{SEEN}[:] = [repr({{name}})]\n"
NOT_AGAIN = f"if repr({{name}}) in {SEEN}:\n    return\n{SEEN}.append(repr({{name}}))\n"
ENTRY = ("main", "__init__", "__post_init__")


def forgetful_calls(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """A function without a result that works the first time only, not the first time, every second time, or five times.

    One with a parameter also ignores an argument that is the same as the last one, or that it had before.
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
    """Whether a function returns or yields a value."""
    waiting: list[cst.CSTNode] = [function.body]
    while waiting:
        node = waiting.pop()
        if isinstance(node, cst.Yield) or (isinstance(node, cst.Return) and node.value is not None):
            return True
        if not isinstance(node, (cst.FunctionDef, cst.Lambda)):
            waiting += node.children
    return False


def _remembering(node: cst.FunctionDef, code: str) -> cst.FunctionDef:
    """The function with `code` at its begin, and a list that outlives its calls."""
    hint = cst.Annotation(cst.parse_expression("list[object]"))
    seen = cst.Param(cst.Name(SEEN), hint, default=cst.parse_expression("[]"))
    params = node.params.with_changes(star_arg=cst.ParamStar(), kwonly_params=[seen])
    return _begun_with(node, code).with_changes(params=params)


def _begun_with(node: cst.FunctionDef, code: str) -> cst.FunctionDef:
    """The function with `code` before its first statement."""
    body = node.body.body
    first = 1 if is_bare_text(body[0]) else 0
    new = [*body[:first], *cst.parse_module(code).body, *body[first:]]
    return node.with_changes(body=node.body.with_changes(body=new))


def lost_state(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """An attribute that another method changes is set back to its first value in each call of that method."""
    if not isinstance(node, cst.FunctionDef) or node.name.value in ENTRY or not statements_of(node):
        return
    for name, value in _first_values(node, view).items():
        if _assigns(node, name):
            yield Edit("state", node, _begun_with(node, f"self.{name} = {value}\n"))


def _first_values(node: cst.FunctionDef, view: View) -> dict[str, str]:
    """What `__init__` of the same class assigns to attributes, as source code."""
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
    """Each attribute of `self` that is assigned to below a node, with the value."""
    if isinstance(node, (cst.Assign, cst.AnnAssign, cst.AugAssign)) and node.value is not None:
        targets = [one.target for one in node.targets] if isinstance(node, cst.Assign) else [node.target]
        for target in targets:
            if isinstance(target, cst.Attribute) and isinstance(target.value, cst.Name):
                if target.value.value == "self":
                    yield target.attr.value, node.value
    for child in node.children:
        yield from _assignments(child)


def kept_results(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """A function with a result that is computed once and kept."""
    if not isinstance(node, cst.FunctionDef) or not gives_a_result(node) or node.asynchronous is not None:
        return
    if node.name.value not in ENTRY and not node.decorators:
        kept = cst.Decorator(cst.parse_expression('__import__("functools").cache'))
        yield Edit("state", node, node.with_changes(decorators=[kept]))


def missing_hints(node: cst.CSTNode, view: View) -> Iterator[Edit]:
    """A hint left out, or `object` in its place. For exercises that a type checker judges."""
    if isinstance(node, cst.Param) and node.annotation is not None:
        yield Edit("hint", node, node.with_changes(annotation=None))
        yield Edit("hint", node.annotation.annotation, cst.Name("object"))
    elif isinstance(node, cst.FunctionDef) and node.returns is not None:
        yield Edit("hint", node, node.with_changes(returns=None))
        yield Edit("hint", node.returns.annotation, cst.Name("object"))

"""The words of each cause, read from the source of a criteria file or a module of the vocabulary, without running it.

A cause id stands as a literal in the call that says the words: `failed("rate.too-fast", saw, expected, because, try)`,
or a local function or a table row that takes the id as well. `python -m tests.criteria.words_of` writes
`tests/criteria/words/*.toml` anew: one file per source file, one table per id.
"""

import ast
import json
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from workbook.criteria.verdict import CAUSE

ROOT = Path(__file__).resolve().parents[2]
WORDS = ROOT / "tests" / "criteria" / "words"
COMMAND = "python -m tests.criteria.words_of"
PARTS = {
    "failed": ("cause", "saw", "expected", "because", "try"),
    "partial": ("cause", "share", "saw", "expected", "because", "try"),
}
VERDICTS = tuple(PARTS)
NO_WORDS = ("cause", "share", "about_time", "recheck_fields", "pattern", "code", "part")
OTHER = "other words"
Function = ast.FunctionDef | ast.AsyncFunctionDef


def vocabulary() -> list[Path]:
    """The modules of the vocabulary."""
    folder = ROOT / "workbook" / "criteria" / "vocabulary"
    return [path for path in sorted(folder.glob("*.py")) if path.name != "__init__.py"]


def exercises() -> list[Path]:
    """The criteria files of the exercises."""
    return sorted((ROOT / "exercises" / "criteria").glob("*.py"))


@dataclass(frozen=True)
class Site:
    """A place in the source that names a cause: the id, the line, and the call that it stands in."""

    cause: str
    line: int
    call: ast.Call
    function: Function | None


class Source:
    """A parsed source file: where its causes are named, and what is said there."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._tree = ast.parse(path.read_text(encoding="utf-8"))
        self._function_of: dict[ast.AST, Function] = {}
        self._read: set[ast.AST] = set()
        self._fields = {
            node.name: [ast.unparse(one.target) for one in node.body if isinstance(one, ast.AnnAssign)]
            for node in self._tree.body
            if isinstance(node, ast.ClassDef)
        }
        for function in ast.walk(self._tree):
            if isinstance(function, Function):
                for node in ast.walk(function):
                    self._function_of[node] = function  # `walk` comes to inner functions last
        self.sites = tuple(self._sites())

    def verdicts(self) -> Iterator[tuple[int, ast.expr | None]]:
        """Line and first argument of each call of `failed` and `partial`."""
        for call in self._calls():
            if _called(call) in VERDICTS:
                yield call.lineno, next(iter(_first_or_cause(call)), None)

    def functions(self) -> Iterator[Function]:
        """All functions, the inner ones too."""
        return (node for node in ast.walk(self._tree) if isinstance(node, Function))

    def strings(self) -> Iterator[tuple[int, str]]:
        """Line and text of each string literal."""
        for node in ast.walk(self._tree):
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                yield node.lineno, node.value

    def words(self) -> dict[str, dict[str, list[str]]]:
        """For each cause: its parts, each with all texts that it may have. "{}" stands for what is put in."""
        found = {site.cause: self._parts(site) for site in sorted(self.sites, key=lambda one: one.cause)}
        other = self._other_texts()
        return {**found, OTHER: {"texts": other}} if other else found

    def _other_texts(self) -> list[str]:
        """What is said elsewhere: when a criterion is met, in titles, in words that are put in."""
        quiet = {
            id(part)
            for node in ast.walk(self._tree)
            if isinstance(node, ast.Raise)
            for part in ast.walk(node)
        }
        quiet |= {id(node.value) for node in ast.walk(self._tree) if isinstance(node, ast.Expr)}
        for node in ast.walk(self._tree):
            if isinstance(node, ast.JoinedStr):
                quiet |= {id(part) for part in node.values}
        texts = [
            text
            for node in ast.walk(self._tree)
            if isinstance(node, (ast.Constant, ast.JoinedStr))
            and node not in self._read
            and id(node) not in quiet
            for text in self._texts(node, self._function_of.get(node), {})
        ]
        return sorted({text for text in texts if " " in text.strip() and "\n" not in text})

    def _calls(self) -> Iterator[ast.Call]:
        return (node for node in ast.walk(self._tree) if isinstance(node, ast.Call))

    def _sites(self) -> Iterator[Site]:
        for call in self._calls():
            for value in _first_or_cause(call):
                if isinstance(value, ast.Constant) and is_cause(value.value):
                    yield Site(str(value.value), value.lineno, call, self._function_of.get(call))

    def _parts(self, site: Site) -> dict[str, list[str]]:
        inside = self._local(site)
        if inside is not None:
            return self._said(inside.verdict, inside.function, inside.given)
        return self._said(site.call, site.function, {})

    def _local(self, site: Site) -> "Local | None":
        """The local function that a site calls, which makes the verdict."""
        name = _called(site.call)
        function = next((one for one in self.functions() if one.name == name), None)
        if name in VERDICTS or function is None:
            return None
        verdict = next(
            (node for node in ast.walk(function) if isinstance(node, ast.Call) and _called(node) in VERDICTS),
            None,
        )
        if verdict is None:
            return None
        names = [one.arg for one in function.args.args]
        given = dict(zip(names, site.call.args, strict=False))
        given |= {one.arg: one.value for one in site.call.keywords if one.arg is not None}
        defaults = function.args.defaults
        given = dict(zip(names[len(names) - len(defaults) :], defaults, strict=True)) | given
        return Local(verdict, function, given)

    def _said(
        self, call: ast.Call, function: Function | None, given: Mapping[str, ast.expr]
    ) -> dict[str, list[str]]:
        """The texts of a call by the names of its arguments, or of the fields of the table row that it makes."""
        names = PARTS.get(_called(call)) or tuple(self._fields.get(_called(call), ()))
        said: dict[str, list[str]] = {}
        position = 0
        for value in call.args:
            if isinstance(value, ast.Starred):
                values = self._elements(value.value)
            else:
                values = [value]
            for one in values:
                name = names[position] if position < len(names) else f"words {position}"
                position += 1
                self._note(said, name, one, function, given)
        for keyword in call.keywords:
            if keyword.arg is not None:
                self._note(said, keyword.arg, keyword.value, function, given)
        return said

    def _note(
        self,
        said: dict[str, list[str]],
        name: str,
        value: ast.expr,
        function: Function | None,
        given: Mapping[str, ast.expr],
    ) -> None:
        texts = [text for text in self._texts(value, function, given) if text.strip("{} .,:;")]
        if name not in NO_WORDS and texts:
            said["try" if name == "try_this" else name] = list(dict.fromkeys(texts))

    def _elements(self, value: ast.expr) -> list[ast.expr]:
        """The elements of a tuple that a name stands for."""
        if isinstance(value, ast.Name):
            found = self._assigned(value.id, None)
            value = found[0] if found else value
        return value.elts if isinstance(value, ast.Tuple) else [value]

    def _assigned(self, name: str, function: Function | None) -> list[ast.expr]:
        """What is assigned to a name in a function and those around it, or else in the module."""
        while function is not None:
            found = [value for node in ast.walk(function) for value in _value_of(node, name)]
            if found:
                return found
            function = self._around(function)
        return [value for node in self._tree.body for value in _value_of(node, name)]

    def _around(self, function: Function) -> Function | None:
        around = [one for one in self.functions() if one is not function and function in ast.walk(one)]
        return around[-1] if around else None

    def _texts(
        self,
        value: ast.expr,
        function: Function | None,
        given: Mapping[str, ast.expr],
        around: frozenset[ast.expr] = frozenset(),
    ) -> list[str]:
        """All texts that an expression may stand for. `around`: the expressions that it is read for."""
        if value in around:
            return ["{}"]
        around |= {value}
        self._read.add(value)

        def texts(one: ast.expr) -> list[str]:
            return self._texts(one, function, given, around)

        match value:
            case ast.Constant(value=str(text)):
                return [text.replace("{", "{{").replace("}", "}}")]
            case ast.IfExp(body=body, orelse=other):
                return texts(body) + texts(other)
            case ast.BinOp(left=left, op=ast.Add(), right=right):
                return [one + more for one in texts(left) for more in texts(right)]
            case ast.BoolOp(values=several):
                return [text for one in several for text in texts(one)]
            case ast.JoinedStr(values=pieces):
                found = [""]
                for piece in pieces:
                    more = self._put_in(piece, texts)
                    found = [one + other for one in found for other in more]
                return found
            case ast.Name(id=name) if name in given:
                return self._texts(given[name], self._function_of.get(given[name]), {}, around)
            case ast.Name(id=name):
                return [text for one in self._assigned(name, function) for text in texts(one)] or ["{}"]
            case ast.Call(func=ast.Name(id="quoting_field_checks"), args=[_, suspicion]):
                return texts(suspicion)
            case ast.Call(func=ast.Name(id=name)):
                return self._returned(name, around)
        return ["{}"]

    def _put_in(self, piece: ast.expr, texts: Callable[[ast.expr], list[str]]) -> list[str]:
        """What may stand at one place of an f-string. What a function says there is among the other words."""
        if not isinstance(piece, ast.FormattedValue):
            return texts(piece)
        return ["{}"] if isinstance(piece.value, (ast.Call, ast.BinOp)) else texts(piece.value)

    def _returned(self, name: str, around: frozenset[ast.expr]) -> list[str]:
        """What a function of this file may return."""
        called = next((one for one in self.functions() if one.name == name), None)
        returns = [
            node.value
            for node in (() if called is None else ast.walk(called))
            if isinstance(node, ast.Return) and node.value is not None and self._function_of[node] is called
        ]
        return [text for one in returns for text in self._texts(one, called, {}, around)] or ["{}"]


@dataclass(frozen=True)
class Local:
    """A function that makes the verdict for the places that name a cause, and what one of them gives it."""

    verdict: ast.Call
    function: Function
    given: Mapping[str, ast.expr]


def is_cause(value: object) -> bool:
    return isinstance(value, str) and CAUSE.fullmatch(value) is not None


def _first_or_cause(call: ast.Call) -> list[ast.expr]:
    """The arguments of a call that may be a cause: the first, and the one of that name."""
    return [*call.args[:1], *(one.value for one in call.keywords if one.arg == "cause")]


def _called(call: ast.Call) -> str:
    if isinstance(call.func, ast.Attribute):
        return call.func.attr
    return call.func.id if isinstance(call.func, ast.Name) else ""


def _value_of(node: ast.AST, name: str) -> list[ast.expr]:
    """What a statement assigns to a name."""
    if not isinstance(node, ast.Assign):
        return []
    for target in node.targets:
        if isinstance(target, ast.Name) and target.id == name:
            return [node.value]
        if isinstance(target, ast.Tuple) and isinstance(node.value, ast.Tuple):
            pairs = zip(target.elts, node.value.elts, strict=True)
            return [value for one, value in pairs if isinstance(one, ast.Name) and one.id == name]
    return []


def as_toml(path: Path) -> str:
    """The words of a source file, as they are kept."""
    lines = [f"# The words of {path.relative_to(ROOT)}, by cause. Written by `{COMMAND}`."]
    for cause, parts in Source(path).words().items():
        lines += ["", f'["{cause}"]']
        for name, texts in parts.items():
            quoted = [json.dumps(text, ensure_ascii=False) for text in texts]
            key = f'"{name}"' if " " in name else name
            if len(quoted) == 1:
                lines.append(f"{key} = {quoted[0]}")
            else:
                lines += [f"{key} = [", *(f"    {text}," for text in quoted), "]"]
    return "\n".join(lines) + "\n"


def kept_in(path: Path) -> Path:
    """Where the words of a source file are kept."""
    return WORDS / f"{path.stem}.toml"


def with_words() -> list[Path]:
    """The source files that name causes."""
    return [path for path in (*vocabulary(), *exercises()) if Source(path).sites]


def main() -> None:
    """Write the words of all causes anew."""
    WORDS.mkdir(exist_ok=True)
    for old in WORDS.glob("*.toml"):
        old.unlink()
    for path in with_words():
        kept_in(path).write_text(as_toml(path), encoding="utf-8")


if __name__ == "__main__":
    main()

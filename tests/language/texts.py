"""Collect the passages that a person reads: pages, lessons, exercises, catalogs, and all words in the code."""

import ast
import inspect
import io
import re
import tokenize
import tomllib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGES = ("*.md", "exercises/*.md", "docs/*.md")
TASKS = ("solutions/*.py",)
LESSONS = ("notebooks/sources/*.py",)
MUSEUM = ("notebooks/sources/museum/*.toml", "notebooks/sources/planned.toml")
CATALOGS = ("exercises/criteria/*.toml", "workbook/criteria/vocabulary/*.toml")
CODE = (
    *("exercises/criteria/*.py", "exercises/drivers/*.py", "exercises/partners/*.py"),
    *("lesson_nodes/**/*.py", "workbook/**/*.py"),
)
EXPLAINED = ("workbook/**/*.py",)
"""The modules whose docstrings and comments are checked. Other modules are part of answers, recordings, or hashes."""
TEMPLATES = ("workbook/**/*.j2",)
NOT_READ = ("workbook/typings/", "workbook/authoring/skeletons/")

FEWEST_WORDS = 3
"""A string in code with fewer words is a name, a key, or a label."""
CODE_WORD = "Code"
"""Replaces a piece of code in a passage: one word, which may begin a sentence."""
VALUE_WORD = "5"
"""Replaces an inserted value in a passage."""


@dataclass(frozen=True)
class Passage:
    """A paragraph, a table cell, a list item, or a string: where it begins, and its words without code and markup."""

    path: str
    line: int
    text: str

    @property
    def where(self) -> str:
        """The place, in a form that editors can open."""
        return f"{self.path}:{self.line}"


def paths(patterns: Sequence[str]) -> list[Path]:
    """Return the files that match the patterns, sorted, except those without text for people."""
    found = {path for pattern in patterns for path in ROOT.glob(pattern)}
    return sorted(path for path in found if not name(path).startswith(NOT_READ))


def name(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


def page_passages(path: Path) -> Iterator[Passage]:
    """Yield the passages of a Markdown page."""
    yield from markdown(name(path), 1, path.read_text(encoding="utf-8").splitlines())


def script_passages(path: Path) -> Iterator[Passage]:
    """Yield the passages of a percent script: its header, its Markdown cells, and the comments in its code."""
    cell: list[str] = []
    begin, reads = 1, "header"
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if line.startswith("# %%"):
            yield from _cell(name(path), begin, cell, reads)
            cell, begin = [], number + 1
            reads = "text" if re.search(r"\[(markdown|hint|alternatives|explain)", line) else "code"
        else:
            cell.append(line)
    yield from _cell(name(path), begin, cell, reads)


def museum_passages(path: Path) -> Iterator[Passage]:
    """Yield the passages of a museum file: what goes wrong, and the terms."""
    text = path.read_text(encoding="utf-8")
    for entry in (
        one for several in tomllib.loads(text).values() if isinstance(several, list) for one in several
    ):
        for field, value in entry.items():
            if isinstance(value, str) and field not in ("cell", "shows"):
                at = text.find(value[:30])
                yield from markdown(name(path), text.count("\n", 0, at) + 1, value.splitlines())


def catalog_passages(path: Path) -> Iterator[Passage]:
    """Yield the texts of a catalog of causes, one per line. From `{count|is|are}`, the plural is used."""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if re.match(r"[a-z][a-z-]* = ", line):
            for text in tomllib.loads(line).values():
                text = re.sub(r"(?<!\{)\{[^{}|]*\|[^{}|]*\|([^{}]*)\}", r"\1", text)
                text = re.sub(r"(?<!\{)\{[^{}]*\}", VALUE_WORD, text)
                yield from (one for one in markdown(name(path), number, [text]) if is_prose(one.text))


def string_passages(path: Path) -> Iterator[Passage]:
    """Yield the strings of a module that contain words, except its docstrings."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    yield from _strings(name(path), 0, tree)


def comment_passages(path: Path) -> Iterator[Passage]:
    """Yield a module's docstrings and comments. Consecutive comment lines are one passage."""
    text = path.read_text(encoding="utf-8")
    for node in ast.walk(ast.parse(text)):
        if (
            isinstance(node, ast.Expr)
            and isinstance(node.value, ast.Constant)
            and isinstance(node.value.value, str)
        ):
            yield from markdown(name(path), node.lineno, inspect.cleandoc(node.value.value).splitlines())
    yield from _comments(name(path), text)


def _comments(path: str, text: str) -> Iterator[Passage]:
    gathered: list[str] = []
    begin = last = 0
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type != tokenize.COMMENT or not re.match(r"#:? (?!type:|noqa|fmt:|%%)", token.string):
            continue
        number, column = token.start
        alone = not token.line[:column].strip()
        if gathered and not (alone and number == last + 1):
            yield from _passage(path, begin, " ".join(gathered))
            gathered = []
        begin, last = (begin if gathered else number), (number if alone else 0)
        gathered.append(token.string.lstrip("#: ").strip())
    yield from _passage(path, begin, " ".join(gathered))


def template_passages(path: Path) -> Iterator[Passage]:
    """Yield the words of a template, without its tags. Each inserted value counts as one word."""
    text = re.sub(
        r"\{#.*?#\}|<(style|script)\b.*?</\1>", _only_lines, path.read_text(encoding="utf-8"), flags=re.DOTALL
    )
    text = re.sub(r"\{\{.*?\}\}", VALUE_WORD, text, flags=re.DOTALL)
    for number, line in enumerate(re.sub(r"\{%.*?%\}", _only_lines, text, flags=re.DOTALL).splitlines(), 1):
        for piece in re.split(r"</?(?:p|li|td|th|div|h\d|summary|title|button|span|dt|dd)\b[^>]*>", line):
            yield from (one for one in _passage(name(path), number, piece) if is_prose(one.text))


def _only_lines(found: re.Match[str]) -> str:
    return "\n" * found[0].count("\n")


def _strings(path: str, first: int, tree: ast.Module) -> Iterator[Passage]:
    """Yield the strings of code.

    A program inside a string is parsed as code. `first`: the number of lines before it.
    """
    silent = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
    silent |= {id(part) for node in ast.walk(tree) if isinstance(node, ast.JoinedStr) for part in node.values}
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in silent:
            text = node.value
        elif isinstance(node, ast.JoinedStr):
            text = "".join(_piece(piece) for piece in node.values)
        else:
            continue
        program = _program(text)
        if program:
            yield from _strings(path, first + node.lineno - 1, program)
        elif "\n" not in text or re.search(r"[a-z][.:,]? *\n", text):
            passages = markdown(path, first + node.lineno, text.splitlines())
            yield from (passage for passage in passages if is_prose(passage.text))


def _program(text: str) -> ast.Module | None:
    """Parse a multi-line text as a Python program; None if it isn't one."""
    if "\n" not in text.strip():
        return None
    try:
        return ast.parse(text)
    except (SyntaxError, ValueError):
        return None


def is_prose(text: str) -> bool:
    """Return whether a string contains words for a person, not a pattern, a path, or code."""
    words = re.findall(r"(?<![\w/.-])[A-Za-z][a-z']*(?![\w/=(])", text)
    return len(words) >= FEWEST_WORDS and not re.search(r"\\[\w.(]|\(\?|[{};<>=]{2}|^[.#@]\w+ {", text)


def markdown(path: str, first: int, lines: Sequence[str]) -> Iterator[Passage]:
    """Yield the passages of Markdown lines.

    A prediction's option and its explanation are two passages; its condition is code. `first`: the number of the first
    line.
    """
    gathered: list[str] = []
    begin, fenced, was_text = first, False, False
    for number, line in enumerate([*lines, ""], first):
        bare = line.strip()
        fence = bare.startswith("```")
        code = fence or fenced or bool(re.fullmatch(r"when `[^`]+`", bare))
        ends = code or not bare or bare.startswith("|")
        starts = bool(re.match(r"([-*>#✓✗]|\d+\.) ?|</?(details|summary)", bare)) and not bare.startswith(
            "**"
        )
        indented = line.startswith("    ") and not was_text
        if (ends or starts or indented) and gathered:
            yield from _passage(path, begin, " ".join(gathered))
            gathered = []
        fenced ^= fence
        was_text = bool(bare) and not code and not fenced and not indented
        if bare.startswith("|") and not fenced:
            for table_cell in re.split(r"(?<!\\)\|", _without_code(bare)):
                yield from _passage(path, number, table_cell)
        elif was_text and not ends:
            begin = begin if gathered else number
            gathered.append(bare)


def sentences(passage: Passage) -> list[str]:
    """Return a passage's sentences. A list after a colon counts as one sentence with the text before it."""
    begins = r"[\"'(]*(?:[A-Z0-9]|(?:rclpy|rcl|mypy)\b|[a-z]+_[a-z_]+\b|[\w/]+\.(?:md|py|toml)\b)"
    return [one for one in re.split(rf"(?<=[.!?])[\"')]* +(?={begins})", passage.text) if one]


def length(sentence: str) -> int:
    """Return how many words a sentence has. Code and values count as one word each."""
    return len(re.findall(r"[^\W_][\w'’/.-]*", sentence))


def _cell(path: str, begin: int, lines: list[str], reads: str) -> Iterator[Passage]:
    """Yield the passages of a cell of a percent script."""
    if reads == "text":
        yield from markdown(path, begin, [re.sub(r"^# ?", "", line) for line in lines])
        return
    for number, line in enumerate(lines, begin):
        if reads == "header":
            found = re.match(r"#   - (?P<text>.*)|# title: (?P<title>.*)", line)
        else:
            found = re.search(r"(?:^| )# (?:\| +)?(?!\[|%|type:|noqa)(?P<text>#? ?[A-Za-z].*)$", line)
        if found:
            yield from _passage(path, number, found["text"] or found[found.lastindex or 0] or "")


def _passage(path: str, line: int, text: str) -> Iterator[Passage]:
    text = re.sub(r"!?\[([^\]]*)\]\([^)\s]*\)", r"\1", text)  # of a link, only the words
    text = re.sub(r"\{\{[\w. %]+\}\}", "1", text)  # a value from the judge
    text = _without_code(text)
    text = re.sub(r"<[^>]+>|\*\*|(?<!\w)[*_](?=\w)|(?<=\w)[*_](?!\w)", "", text)
    text = re.sub(r"^(#+|[->✓✗]|\d+\.) +", "", text.strip())
    if re.search("[A-Za-z]", text):
        yield Passage(path, line, " ".join(text.split()))


def _without_code(text: str) -> str:
    return re.sub(r"(`+).+?\1|\$[^$]+\$|https?://[^\s)]+", CODE_WORD, text)


def _piece(node: ast.expr) -> str:
    return str(node.value) if isinstance(node, ast.Constant) else VALUE_WORD


def without_questions(passage: Passage) -> str:
    """Return a passage's sentences, except its questions."""
    return " ".join(sentence for sentence in sentences(passage) if not sentence.rstrip(')*_"').endswith("?"))

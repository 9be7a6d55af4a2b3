"""What a type checker says of a program, without running it.

mypy runs in a process of its own, behind a watchdog and under the settings of the bench alone. A program brings no
settings of its own: comments that silence mypy are taken out before it looks, and are reported, as is code that it
would not look at.
"""

import ast
import hashlib
import io
import json
import os
import re
import shutil
import signal
import sys
import tokenize
from collections.abc import Iterator, Mapping, Sequence
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path

from workbook.observing.mypy_runs import mypy_server
from workbook.observing.recording import Finding
from workbook.ros.environment import child_environment
from workbook.ros.scratch import remove_scratch, scratch_folder

TYPINGS = Path(__file__).resolve().parents[1] / "typings"
SETTINGS = TYPINGS / "mypy.ini"
# Without stubs: what mypy knows of rclpy and its messages as they are installed.
OURS = (f"--config-file={SETTINGS}",)
BARE = ("--config-file=", "--disable-error-code=import-untyped")
PROGRAM = "answer"
SILENCED, UNCHECKED, UNFINISHED, NOTE = "silenced", "unchecked", "unfinished", "note"
PROCESSOR_S = 30  # what counts: on a busy machine a minute may pass before mypy has had two seconds of it
PATIENCE_S = 300.0
MEMORY_BYTES = 2_500_000_000
# What most programs import, as far as mypy takes long to read it.
COMMON = (
    *(
        "asyncio",
        "dataclasses",
        "json",
        "random",
        "threading",
        "rclpy",
        "rclpy.action",
        "rclpy.event_handler",
    ),
    *("rclpy.lifecycle", "rclpy.node", "rclpy.executors", "rclpy.parameter", "rclpy.qos", "rclpy.signals"),
    *(
        f"{path.parent.name}.{path.name}"
        for path in sorted(TYPINGS.glob("*/*/"))
        if path.name in ("msg", "srv")
    ),
)

_IGNORE = re.compile(
    r"#\s*type:\s*ignore\b"
)  # at the beginning of a comment; elsewhere mypy does not heed it
_INLINE = re.compile(r"^# mypy: .*$", re.MULTILINE)
_BROKE_DOWN = ("INTERNAL ERROR", "MemoryError", "RecursionError")
_HIDING = ("TYPE_CHECKING", "MYPY")
_NOT_INSTALLED = "mypy is not installed in this environment: `make env` brings it up to date"

_cache: Path | None = None


class TypeCheckFailed(RuntimeError):
    """mypy could not do its work, and not because of the program. The message says why."""


def type_check(
    program: str,
    probes: Mapping[str, str] | None = None,
    *,
    settings: Sequence[str] = OURS,
    stubs: bool = True,
    notes: bool = False,
    processor_s: int = PROCESSOR_S,
) -> tuple[Finding, ...]:
    """What mypy says of `program`, by line, and of each of the `probes`: short programs that import it as `answer`.

    `settings`: arguments of mypy. `stubs`: whether it finds those of the course. With `notes`, its notes are there as
    well (code "note"), such as those of `reveal_type`. Raises TypeCheckFailed when mypy is not installed or fails over
    something that is not the program's.
    """
    if find_spec("mypy") is None:
        raise TypeCheckFailed(_NOT_INSTALLED)
    texts = {PROGRAM: without_silencers(program)}
    names = {PROGRAM: ""}
    for number, (name, text) in enumerate((probes or {}).items()):
        texts[f"probe_{number}"] = text
        names[f"probe_{number}"] = name
    cache = _own_cache(settings, stubs)
    folder = scratch_folder("types")
    try:
        for module, text in texts.items():
            (folder / f"{module}.py").write_text(text, encoding="utf-8")
        files = [f"{module}.py" for module in texts]
        found = _run_mypy(folder, files, settings, stubs, cache, notes, processor_s)
    finally:
        remove_scratch(folder)
    of_mypy = [Finding(names[module], line, code, message) for module, line, code, message in found]
    of_mypy.sort(key=lambda finding: (list(names.values()).index(finding.probe), finding.line))
    return (*sorted(evasions(program), key=lambda finding: finding.line), *of_mypy)


def _run_mypy(
    folder: Path,
    files: Sequence[str],
    settings: Sequence[str],
    stubs: bool,
    cache: Path,
    notes: bool = False,
    processor_s: int = PROCESSOR_S,
) -> list[tuple[str, int, str, str]]:
    """Run mypy over files of a folder: module, line, code and message of all that it says."""
    arguments = [
        *settings, "--output=json", "--no-error-summary", "--show-error-codes", "--explicit-package-bases",
        f"--cache-dir={cache}", *files,
    ]  # fmt: skip
    environ = child_environment(0, log_folder=folder)
    environ = {name: value for name, value in environ.items() if not name.startswith("MYPY")}
    if stubs:
        environ["MYPYPATH"] = str(TYPINGS)
    try:
        run = mypy_server.run(
            arguments, folder, environ, processor_s=processor_s, memory=MEMORY_BYTES, patience_s=PATIENCE_S
        )
    except TimeoutError:
        return [(PROGRAM, 0, UNFINISHED, f"mypy had not finished after {PATIENCE_S:.0f} s")]
    except OSError as error:
        raise TypeCheckFailed(f"mypy could not be started: {error}") from error
    if -run.code in (signal.SIGXCPU, signal.SIGKILL):
        words = f"mypy had not finished after {processor_s} s of processor time"
        return [(PROGRAM, 0, UNFINISHED, words)]
    found = list(_read(run.said, notes))
    strangers = [module for module, *_ in found if f"{module}.py" not in files]
    if strangers:
        raise TypeCheckFailed(f"mypy stumbled over {strangers[0]}, not over the program: {run.said.strip()}")
    if run.code not in (0, 1) and not found:
        if run.code < 0 or any(name in run.complaint for name in _BROKE_DOWN):
            return [(PROGRAM, 0, UNFINISHED, "mypy itself broke down over this program")]
        raise TypeCheckFailed(f"mypy ended with code {run.code}: {(run.complaint or run.said).strip()}")
    return found


def _read(said: str, notes: bool) -> Iterator[tuple[str, int, str, str]]:
    for line in said.splitlines():
        if not line.startswith("{"):
            continue
        item = json.loads(line)
        is_note = item["severity"] == "note"
        if is_note and not notes:
            continue
        file = item["file"]
        module = file.removesuffix(".py") if "/" not in file else file
        yield module, max(0, item["line"]), NOTE if is_note else item["code"] or "misc", item["message"]


def _own_cache(settings: Sequence[str], stubs: bool) -> Path:
    """mypy's cache of this process for these settings. It begins as a copy of what the environment keeps.

    Nobody else writes to it: what mypy concludes from one person's program must not reach another's check.
    """
    global _cache
    if _cache is None or not _cache.is_dir():
        _cache = scratch_folder("mypy")
    cache = _cache / _name_of(settings, stubs)
    if not cache.is_dir():
        learn(settings, stubs)
        try:
            shutil.copytree(kept_folder() / cache.name, cache)
        except OSError:  # nothing is kept here: mypy begins from nothing
            shutil.rmtree(cache, ignore_errors=True)
    return cache


def _name_of(settings: Sequence[str], stubs: bool) -> str:
    return hashlib.sha256("\n".join((*settings, str(stubs))).encode()).hexdigest()[:12]


def learn(settings: Sequence[str] = OURS, stubs: bool = True) -> None:
    """Let the environment keep what mypy knows, unless it does already or is not ours to write to.

    Whoever starts processes that cannot write to it does this before: otherwise each of them begins from nothing.
    Raises TypeCheckFailed.
    """
    if find_spec("mypy") is None:
        raise TypeCheckFailed(_NOT_INSTALLED)
    kept = kept_folder() / _name_of(settings, stubs)
    if not kept.is_dir():
        _learn(kept, settings, stubs)


def kept_folder() -> Path:
    """Where the environment keeps what mypy knows of rclpy and the messages, in a folder for each choice of settings.

    Its name changes with whatever is installed, and with the stubs of the course.
    """
    state = hashlib.sha256(version("mypy").encode())
    rclpy = find_spec("rclpy")
    installed = [Path(rclpy.origin)] if rclpy is not None and rclpy.origin is not None else []
    for path in [*installed, *sorted(TYPINGS.rglob("*.*"))]:
        state.update(f"{path} {path.stat().st_mtime_ns}".encode())
    return Path(sys.prefix, "share", "rclpy-workbook", "mypy", state.hexdigest()[:12])


def _learn(kept: Path, settings: Sequence[str], stubs: bool) -> None:
    """Let mypy read what most programs import, and keep what it learned: in an environment of ours to write to."""
    if sys.prefix == sys.base_prefix or not os.access(sys.prefix, os.W_OK):
        return
    folder = scratch_folder("types")
    try:
        (folder / "common.py").write_text("".join(f"import {name}\n" for name in COMMON), encoding="utf-8")
        cache = folder / "cache"
        if _run_mypy(folder, ["common.py"], settings, stubs, cache):
            return  # whatever it says will be said of the program itself, or is none of its business
        kept.parent.mkdir(parents=True, exist_ok=True)
        whole = kept.with_name(f"{folder.name}.part")
        shutil.copytree(cache, whole)
        try:
            whole.rename(kept)
        except OSError:  # another process was quicker
            shutil.rmtree(whole, ignore_errors=True)
        for outdated in kept.parents[1].iterdir():
            if outdated != kept.parent:
                shutil.rmtree(outdated, ignore_errors=True)
    except OSError:
        return
    finally:
        remove_scratch(folder)


# --- what keeps mypy from looking -----------------------------------------------------------------------------


def _comments(program: str) -> Iterator[tokenize.TokenInfo]:
    try:
        for token in tokenize.generate_tokens(io.StringIO(program).readline):
            if token.type == tokenize.COMMENT:
                yield token
    except (tokenize.TokenError, SyntaxError):
        return  # mypy will say that it cannot read the file


def without_silencers(program: str) -> str:
    """The program with every comment taken out that would silence mypy. Lines keep their numbers."""
    lines = program.splitlines(keepends=True)
    for token in _comments(program):
        if _IGNORE.match(token.string):
            row, column = token.start
            end = "\n" if lines[row - 1].endswith("\n") else ""
            lines[row - 1] = lines[row - 1][:column].rstrip() + end
    return _INLINE.sub("#", "".join(lines))


def evasions(program: str) -> Iterator[Finding]:
    """Everything in a program that keeps mypy from looking, as findings of the codes "silenced" and "unchecked"."""
    for token in _comments(program):
        if _IGNORE.match(token.string):
            yield Finding("", token.start[0], SILENCED, token.string.strip())
    for found in _INLINE.finditer(program):
        yield Finding("", program.count("\n", 0, found.start()) + 1, SILENCED, found[0].strip())
    try:
        tree = ast.parse(program)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return  # mypy will say that it cannot read the file
    for node in ast.walk(tree):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            for decorator in node.decorator_list:
                if _last_name(decorator) == "no_type_check":
                    yield Finding("", decorator.lineno, UNCHECKED, "@no_type_check")
        elif isinstance(node, ast.If) and (hidden := _hidden_code(node)) is not None:
            yield Finding("", hidden.lineno, UNCHECKED, "code that runs, and that mypy is told to skip")


def _last_name(node: ast.expr) -> str:
    if isinstance(node, ast.Attribute):
        return node.attr
    return node.id if isinstance(node, ast.Name) else ""


def _hidden_code(node: ast.If) -> ast.stmt | None:
    """The first statement of the branch that runs, but is not for the eyes of a type checker. Imports may be there."""
    names = {_last_name(part) for part in ast.walk(node.test) if isinstance(part, ast.expr)}
    if names.isdisjoint(_HIDING):
        return None
    turned = isinstance(node.test, ast.UnaryOp) and isinstance(node.test.op, ast.Not)
    runs = node.body if turned else node.orelse
    return next((one for one in runs if not isinstance(one, (ast.Import, ast.ImportFrom, ast.Pass))), None)

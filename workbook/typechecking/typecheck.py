"""Type-check a program without running it.

mypy runs in a separate process with a time limit and only the judge's settings. A program can't change those settings:
comments that silence mypy are removed and reported, and code that mypy would skip is reported, too.
"""

import hashlib
import json
import os
import secrets
import shutil
import signal
import sys
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path

from workbook.recording.recording import UNFINISHED, Finding
from workbook.ros.environment import child_environment
from workbook.ros.scratch import remove_scratch, scratch_folder
from workbook.typechecking.mypy_runs import MypyRun, mypy_server
from workbook.typechecking.silencers import evasions, without_silencers

TYPINGS = Path(__file__).resolve().parents[1] / "typings"
SETTINGS = TYPINGS / "mypy.ini"
# BARE is for checks without our stubs, in which mypy reads the installed rclpy and the installed messages
OURS = (f"--config-file={SETTINGS}",)
BARE = ("--config-file=", "--disable-error-code=import-untyped")
PROGRAM = "answer"
NOTE = "note"
PROCESSOR_S = 30  # CPU time, because on a busy machine, mypy may get only two seconds of it per minute
PATIENCE_S = 300.0
MEMORY_BYTES = 2_500_000_000
# Modules that many programs import and that mypy takes long to read.
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

_BROKE_DOWN = ("INTERNAL ERROR", "MemoryError", "RecursionError")
_NOT_INSTALLED = "mypy is not installed in this environment: `make env` brings it up to date"

_cache: Path | None = None


class TypeCheckFailed(RuntimeError):
    """Raised when mypy itself failed and the program isn't to blame. The message says why."""


@dataclass(frozen=True)
class MypyOptions:
    """The options for running mypy.

    `stubs`: whether to use the course's stubs. `notes`: whether mypy's notes count as findings. `processor_s`: the
    limit on CPU time, in seconds.
    """

    arguments: Sequence[str] = OURS
    stubs: bool = True
    notes: bool = False
    processor_s: int = PROCESSOR_S

    @property
    def cache_name(self) -> str:
        """The name of the cache folder for these options."""
        return hashlib.sha256("\n".join((*self.arguments, str(self.stubs))).encode()).hexdigest()[:12]


DEFAULT = MypyOptions()


def type_check(
    program: str, probes: Mapping[str, str] | None = None, options: MypyOptions = DEFAULT
) -> tuple[Finding, ...]:
    """Return the findings about `program`, and then those about each of the `probes`.

    Code that keeps mypy from checking the program comes first (see `evasions`). Each part is sorted by line. Probes are
    short programs that import the program as `answer`. mypy's notes, such as the output of `reveal_type`, have the code
    "note". Raise TypeCheckFailed if mypy isn't installed, or if it fails and the program isn't to blame.
    """
    if find_spec("mypy") is None:
        raise TypeCheckFailed(_NOT_INSTALLED)
    texts = {PROGRAM: without_silencers(program)}
    names = {PROGRAM: ""}
    for number, (name, text) in enumerate((probes or {}).items()):
        texts[f"probe_{number}"] = text
        names[f"probe_{number}"] = name
    cache = _own_cache(options)
    folder = scratch_folder("types")
    try:
        for module, text in texts.items():
            _write(folder / f"{module}.py", text)
        files = [f"{module}.py" for module in texts]
        found = _run_mypy(folder, files, cache, options)
    finally:
        remove_scratch(folder)
    of_mypy = [Finding(names[module], line, code, message) for module, line, code, message in found]
    of_mypy.sort(key=lambda finding: (list(names.values()).index(finding.probe), finding.line))
    return (*sorted(evasions(program), key=lambda finding: finding.line), *of_mypy)


def _write(file: Path, text: str) -> None:
    """Write a module with a random modification time.

    mypy assumes that a file is unchanged if its size and its modification time (in whole seconds) are the same as
    before (`validate_meta` in mypy/build.py). Two students' programs could easily have the same size and time.
    """
    file.write_text(text, encoding="utf-8")
    moment_s = secrets.randbelow(2**31)
    os.utime(file, (moment_s, moment_s))


def _run_mypy(
    folder: Path, files: Sequence[str], cache: Path, options: MypyOptions
) -> list[tuple[str, int, str, str]]:
    """Run mypy on files in a folder. Return each finding's module, line, code, and message."""
    arguments = [
        *options.arguments, "--output=json", "--no-error-summary", "--show-error-codes", "--explicit-package-bases",
        f"--cache-dir={cache}", *files,
    ]  # fmt: skip
    environ = child_environment(0, log_folder=folder)
    environ = {name: value for name, value in environ.items() if not name.startswith("MYPY")}
    if options.stubs:
        environ["MYPYPATH"] = str(TYPINGS)
    try:
        run = mypy_server.run(
            MypyRun(arguments, folder, environ, options.processor_s, MEMORY_BYTES, PATIENCE_S)
        )
    except TimeoutError:
        return [(PROGRAM, 0, UNFINISHED, f"mypy had not finished after {PATIENCE_S:.0f} s")]
    except OSError as error:
        raise TypeCheckFailed(f"mypy could not be started: {error}") from error
    if -run.code in (signal.SIGXCPU, signal.SIGKILL):
        words = f"mypy had not finished after {options.processor_s} s of processor time"
        return [(PROGRAM, 0, UNFINISHED, words)]
    found = list(_read(run.said, options.notes))
    other = [module for module, *_ in found if f"{module}.py" not in files]
    if other:
        raise TypeCheckFailed(f"mypy stumbled over {other[0]}, not over the program: {run.said.strip()}")
    if run.code not in (0, 1) and not found:
        if run.code < 0 or any(name in run.complaint for name in _BROKE_DOWN):
            return [(PROGRAM, 0, UNFINISHED, "mypy itself crashed on this program")]
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


def _own_cache(options: MypyOptions) -> Path:
    """Return this process's mypy cache for these options, created as a copy of the environment's cache.

    Other processes don't write to the copy, because mypy's conclusions from one student's program must not affect the
    check of another student's program.
    """
    global _cache
    if _cache is None or not _cache.is_dir():
        _cache = scratch_folder("mypy")
    cache = _cache / options.cache_name
    if not cache.is_dir():
        warm_cache(options)
        try:
            shutil.copytree(kept_folder() / cache.name, cache)
        except OSError:  # there is no cache to copy, so mypy starts without one
            shutil.rmtree(cache, ignore_errors=True)
    return cache


def warm_cache(options: MypyOptions = DEFAULT) -> None:
    """Fill the environment's mypy cache for these options. Do nothing if it exists or can't be written.

    The environment is the virtual environment in which mypy is installed. Call this function before you start processes
    that can't write to it. Otherwise, each of them fills its own cache. Raise TypeCheckFailed if mypy isn't installed
    or fails.
    """
    if find_spec("mypy") is None:
        raise TypeCheckFailed(_NOT_INSTALLED)
    kept = kept_folder() / options.cache_name
    if not kept.is_dir():
        _fill_cache(kept, options)


def kept_folder() -> Path:
    """Return the folder of the environment's mypy cache, which has a subfolder for each set of options.

    The cache covers rclpy and the messages. The folder's name changes with the installed mypy and rclpy, and with the
    course's stubs.
    """
    state = hashlib.sha256(version("mypy").encode())
    rclpy = find_spec("rclpy")
    installed = [Path(rclpy.origin)] if rclpy is not None and rclpy.origin is not None else []
    for path in [*installed, *sorted(TYPINGS.rglob("*.*"))]:
        state.update(f"{path} {path.stat().st_mtime_ns}".encode())
    return Path(sys.prefix, "share", "rclpy-workbook", "mypy", state.hexdigest()[:12])


def _fill_cache(kept: Path, options: MypyOptions) -> None:
    """Run mypy on `COMMON`, and store mypy's cache in `kept`. Do nothing outside a writable virtual environment."""
    if sys.prefix == sys.base_prefix or not os.access(sys.prefix, os.W_OK):
        return
    folder = scratch_folder("types")
    try:
        (folder / "common.py").write_text("".join(f"import {name}\n" for name in COMMON), encoding="utf-8")
        cache = folder / "cache"
        if _run_mypy(folder, ["common.py"], cache, replace(options, notes=False, processor_s=PROCESSOR_S)):
            return  # mypy will report the same problems for a program that they affect
        kept.parent.mkdir(parents=True, exist_ok=True)
        whole = kept.with_name(f"{folder.name}.part")
        shutil.copytree(cache, whole)
        try:
            whole.rename(kept)
        except OSError:  # another process has already created it
            shutil.rmtree(whole, ignore_errors=True)
        for outdated in kept.parents[1].iterdir():
            if outdated != kept.parent:
                shutil.rmtree(outdated, ignore_errors=True)
    except OSError:
        return
    finally:
        remove_scratch(folder)

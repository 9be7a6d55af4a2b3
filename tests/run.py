"""Run everything that `make test` proves, in order. pytest's own summary comes last.

`--all` is `make test-all`: every answer, every lesson in the browser, and everything else that is marked `whole`.
`python tests/run.py --only lint` (or style, types, notebooks, collection, pytest) runs one part. During the tests, the
load of the CPUs is written to `artifacts/processors.tsv`. With CI=true, a skipped test that `.ci/allowed_skips` does
not list is a failure.
"""

import argparse
import os
import signal
import subprocess
import sys
import threading
import time
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from fnmatch import fnmatch
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
ARTIFACTS = ROOT / "artifacts"
ALLOWED_SKIPS = ROOT / ".ci" / "allowed_skips"
# mypy checks each folder separately, so two folders may contain files of the same name.
TYPED_FOLDERS = (
    *("workbook", "deploy", "lesson_nodes", "solutions"),
    *("exercises/criteria", "exercises/drivers", "exercises/partners"),
)
# Lessons, browsers, and judges wait most of the time. With fewer workers, CPUs would be idle.
JOBS = str(min(8, 3 * len(os.sched_getaffinity(0))))
TESTS_LIMIT_S = 76 * 60.0
SUMMARY_LIMIT_S = 120.0
PROCESSORS = "processors.tsv"
LOOK_EVERY_S = 5.0


@dataclass(frozen=True)
class Step:
    """One command of the run.

    `quiet`: print its output only if it fails.
    """

    name: str
    group: str
    command: tuple[str, ...]
    report: Path | None = None
    quiet: bool = False


def steps(jobs: str = JOBS, *, whole: bool = False) -> list[Step]:
    """Return the steps, short ones first. pytest is last, because its summary is what people look for.

    `jobs`: the number of its workers.
    """
    from workbook.lab.health import chromium

    python = sys.executable
    found = [
        Step("ruff check", "style", (python, "-m", "ruff", "check", ".")),
        Step("ruff format", "style", (python, "-m", "ruff", "format", "--check", ".")),
    ]
    for folder in TYPED_FOLDERS:
        if any((ROOT / folder).rglob("*.py")):
            found.append(Step(f"mypy {folder}", "types", (python, "-m", "mypy", folder)))
    authoring = (python, "-m", "workbook.authoring")
    found.append(Step("notebooks match their text", "notebooks", (*authoring, "check")))
    # This runs next to mypy, which keeps only one CPU busy. pytest compiles the tests' files once, for all its workers.
    collect = (python, "-m", "pytest", "--collect-only", "-qq")
    found.append(Step("tests can be collected", "collection", collect, quiet=True))
    tested = ARTIFACTS / "pytest.xml"
    spread = ("-n", jobs)
    in_browser = "not outside_browser" if chromium() is not None else ""
    which = ("-m", in_browser if whole else "not whole")
    tests = (python, "-m", "pytest", *which, f"--junitxml={tested}")
    found.append(Step("pytest", "pytest", (*tests, *spread), tested))
    return found


def chosen(all_steps: Iterable[Step], only: str | None) -> list[Step]:
    """Return the steps of a group; `lint` means style and types."""
    groups = {"lint": ("style", "types")}.get(only or "", (only,))
    return [step for step in all_steps if only is None or step.group in groups]


def environment() -> dict[str, str]:
    """Return the environment for the steps.

    It has no variables of a sourced ROS, and this environment's programs come first on the PATH.
    """
    from workbook.ros.environment import is_leftover

    environ = {name: value for name, value in os.environ.items() if not is_leftover(name)}
    environ.pop("PYTHONDONTWRITEBYTECODE", None)
    environ["PATH"] = os.pathsep.join([str(Path(sys.executable).parent), environ.get("PATH", os.defpath)])
    environ.setdefault(
        "OPENBLAS_NUM_THREADS", "1"
    )  # there are hundreds of processes, and each would start a thread per CPU
    environ["MPLBACKEND"] = environ.get("MPLBACKEND", "agg")
    return environ


def missing_tools() -> list[str]:
    """Say which checks will be skipped because a tool is missing, in one sentence per tool."""
    from workbook.isolation.bubblewrap import sandbox_problem
    from workbook.lab.health import chromium

    said = []
    if chromium() is None:
        said.append("No Chromium: the tests in a real browser will be skipped (apt: chromium).")
    problem = sandbox_problem()
    if problem is not None:
        said.append(f"Sandbox tests will be skipped: {problem} (apt: bubblewrap).")
    return said


def skipped(report: Path) -> list[tuple[str, str]]:
    """Return the skipped tests of a JUnit report: name and reason. Expected failures don't count."""
    if not report.is_file():
        return []
    found = []
    for case in ElementTree.parse(report).iter("testcase"):
        skip = case.find("skipped")
        if skip is not None and skip.get("type") != "pytest.xfail":
            found.append((f"{case.get('classname')}::{case.get('name')}", skip.get("message") or "no reason"))
    return found


def unlisted(skips: Iterable[tuple[str, str]], patterns: Sequence[str]) -> list[tuple[str, str]]:
    """Return the skipped tests that no pattern in `.ci/allowed_skips` covers."""
    return [skip for skip in skips if not any(fnmatch(skip[0], pattern) for pattern in patterns)]


def allowed_patterns(text: str) -> list[str]:
    """Return the patterns, one per line. `#` begins a comment."""
    return [line for line in (raw.partition("#")[0].strip() for raw in text.splitlines()) if line]


def run(plan: Sequence[Step], say: Callable[[str], None]) -> list[str]:
    """Run all steps, even if some fail. Return one line for each failure.

    The groups run in parallel, and the steps of a group one after another, because mypy reuses its cache. The tests
    come last, after everything else has ended.
    """
    environ = environment()
    ARTIFACTS.mkdir(exist_ok=True)
    quick = [step for step in plan if step.report is None]

    def run_group(group: str) -> list[str]:
        return [line for step in quick if step.group == group for line in _run_quick(step, environ, say)]

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        groups = dict.fromkeys(step.group for step in quick)
        failed = [line for lines in pool.map(run_group, groups) for line in lines]
    for step in plan:
        if step.report is not None:
            step.report.unlink(missing_ok=True)
            say(f"── {step.name}")
            with BusyProcessors(ARTIFACTS / PROCESSORS) as processors:
                failed += _run_tests(step, environ, TESTS_LIMIT_S)
            say(f"   The CPUs were busy for {processors.share:.0%} of the time ({PROCESSORS}).")
    return failed


class BusyProcessors:
    """Write down every few seconds how busy the CPUs are. Use it as a context manager.

    CPUs that are idle while tests still wait show that a better order would save time.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._follow, daemon=True)
        self._seen = [(time.monotonic(), *busy_and_all())]

    @property
    def share(self) -> float:
        """The share of all CPUs that was busy from the beginning to the last measurement."""
        (_, busy, total), (_, busy_now, total_now) = self._seen[0], self._seen[-1]
        return (busy_now - busy) / max(1, total_now - total)

    def _follow(self) -> None:
        while not self._over.wait(LOOK_EVERY_S):
            self._look()

    def _look(self) -> None:
        (then, busy, total), now = self._seen[-1], (time.monotonic(), *busy_and_all())
        self._seen.append(now)
        with self._path.open("a", encoding="utf-8") as file:
            share = (now[1] - busy) / max(1, now[2] - total)
            print(f"{now[0] - self._seen[0][0]:.0f}\t{now[0] - then:.1f}\t{share:.2f}", file=file)

    def __enter__(self) -> "BusyProcessors":
        self._path.write_text("time (s)\tinterval (s)\tbusy\n", encoding="utf-8")
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._over.set()
        self._thread.join()
        self._look()


def busy_and_all() -> tuple[int, int]:
    """Return the CPU time since the machine started, in ticks: busy (for us or others), and total."""
    times = [
        int(word) for word in Path("/proc/stat").read_text(encoding="utf-8").split("\n", 1)[0].split()[1:9]
    ]
    idle = times[3] + times[4]  # idle, and waiting for a disk
    return sum(times) - idle, sum(times)


def _run_tests(step: Step, environ: dict[str, str], limit_s: float) -> list[str]:
    """Run the tests. After `limit_s`, interrupt them as Ctrl-C does, so that they still report their failures."""
    running = subprocess.Popen(step.command, cwd=ROOT, env=environ)
    try:
        code = running.wait(limit_s)
        return [f"{step.name} (exit {code})"] if code else []
    except subprocess.TimeoutExpired:
        running.send_signal(signal.SIGINT)
        try:
            running.wait(SUMMARY_LIMIT_S)
        except subprocess.TimeoutExpired:
            running.kill()
            running.wait()
        return [f"{step.name} (did not end within {limit_s:g} s)"]
    except BaseException:
        # Ctrl-C interrupts the tests as well. Wait, so that they can print their summary.
        running.wait()
        raise


def _run_quick(step: Step, environ: dict[str, str], say: Callable[[str], None]) -> list[str]:
    """Run a short step and print its output in one piece. Return a line if it failed."""
    started = time.monotonic()
    done = subprocess.run(
        step.command, cwd=ROOT, env=environ, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    how = "ok" if done.returncode == 0 else "FAILED"
    silent = not done.stdout.strip() or (step.quiet and done.returncode == 0)
    told = "" if silent else f"{done.stdout.rstrip()}\n"
    say(f"── {step.name}\n{told}   {how} ({time.monotonic() - started:.1f} s)")
    return [f"{step.name} (exit {done.returncode})"] if done.returncode else []


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the chosen steps. Return exit code 0 if all of them passed."""
    parser = argparse.ArgumentParser(description="Run the steps of `make test`.")
    parser.add_argument("--only", choices=("lint", "style", "types", "notebooks", "collection", "pytest"))
    parser.add_argument(
        "--jobs", type=int, default=int(JOBS), help="number of pytest workers (default: %(default)s)"
    )
    parser.add_argument(
        "--all", action="store_true", help="the whole run, including the tests marked `whole`"
    )
    options = parser.parse_args(arguments)
    # A shell script's background jobs ignore Ctrl-C. Every program that a test interrupts would inherit that.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    plan = chosen(steps(str(options.jobs), whole=options.all), options.only)
    lacking = missing_tools() if any(step.group == "pytest" for step in plan) else []
    for line in lacking:
        print(f"! {line}")

    def say(text: str) -> None:
        print(text, flush=True)

    failed = run(plan, say)
    if os.environ.get("CI", "").lower() in ("1", "true"):
        patterns = allowed_patterns(ALLOWED_SKIPS.read_text(encoding="utf-8"))
        reports = [step.report for step in plan if step.report is not None]
        skips = [skip for report in reports for skip in skipped(report)]
        failed += [
            f"skipped, but not listed in .ci/allowed_skips: {name} ({why})"
            for name, why in unlisted(skips, patterns)
        ]
    if failed:
        print("\nFailures:", *(f"  ✗ {line}" for line in failed), sep="\n", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

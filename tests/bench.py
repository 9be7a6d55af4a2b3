"""Measure how fast and how reliable judging is, and what a frame of the panel costs: `make bench`.

ARGS='--quick' makes a short run, and ARGS='--only check' runs one part.

Two parts take some ten minutes, so they run only on request. ARGS='--only fairness' grades right answers 500 times,
with more slots than CPUs and with other programs that keep every CPU busy. ARGS='--only class' has 40 students at a hub
(4 with --quick; it needs root and EXTRAS=hub).

Prints a table and writes artifacts/bench.json. Times are medians with their range. They depend on the machine's other
work, so each part prints the load average at its start.
"""

import argparse
import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ElementTree
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path

from workbook.authoring.tree import Tree
from workbook.authoring.wrong_answers import read_wrong_answer
from workbook.cli.grade_options import SLOTS_PER_CORE
from workbook.exercise.answers import Answer, read_answer
from workbook.exercise.definition import Exercise, load_exercise
from workbook.exercise.judgement import Judgement
from workbook.grading.judges import Job
from workbook.grading.single import best_isolation
from workbook.grading.slots.client import Slot
from workbook.grading.slots.scheduler import judge_all
from workbook.isolation.bubblewrap import sandbox_problem
from workbook.isolation.sandbox import SandboxTier
from workbook.isolation.tiers import Isolation
from workbook.programs.fork_client import ForkServer
from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.programs.tier import Tier
from workbook.recording.recording import Recording
from workbook.ros.domains import lease_domain
from workbook.ros.environment import child_environment
from workbook.watching.observer import Observer
from workbook.watching.watch import Watch

ROOT = Path(__file__).resolve().parents[1]
ARTIFACTS = ROOT / "artifacts"
STEM = "09_joint_positions"
SOLUTION = ROOT / "solutions" / f"{STEM}.py"
WRONG = ("eleven_values", "one_joint_moves", "status_at_half_hertz", "pairs", "wrong_name")
WRONG_RATE = "status_at_half_hertz"
NEVER_AT_REST = ("multi_threaded_executor", "spin_thread_and_rate")
"""Right answers with more than one thread."""
BARE_NODES = 10
CORES = len(os.sched_getaffinity(0))
BARE_NODE = (
    "import rclpy; rclpy.init(); node = rclpy.create_node('bare'); node.destroy_node(); rclpy.shutdown()"
)


@dataclass(frozen=True)
class Figure:
    """One line of the table. `holds` is None if there is no aim."""

    name: str
    measured: str
    spread: str = ""
    aim: str = ""
    holds: bool | None = None
    values: dict[str, float | int | list[float]] = field(default_factory=dict)


@dataclass(frozen=True)
class Size:
    """The number of repetitions for each measurement."""

    runs: int
    wall_runs: int
    repeats: int
    answers: int
    gradings: int
    students: int


FULL = Size(runs=9, wall_runs=3, repeats=200, answers=120, gradings=500, students=40)
QUICK = Size(runs=5, wall_runs=1, repeats=24, answers=40, gradings=32, students=4)


def of_times(name: str, times: Sequence[float], aim_s: float | None = None, unit: str = "s") -> Figure:
    """Make a figure from repeated measurements: the median and the range."""
    middle = statistics.median(times)
    return Figure(
        name,
        f"{middle:.2f} {unit}",
        f"{min(times):.2f} to {max(times):.2f}, n = {len(times)}",
        "" if aim_s is None else f"< {aim_s:g} {unit}",
        None if aim_s is None else middle < aim_s,
        {"median": round(middle, 4), "all": [round(one, 4) for one in times]},
    )


def timed(work: Callable[[], object]) -> float:
    """Return how many seconds `work` takes."""
    began = time.monotonic()
    work()
    return time.monotonic() - began


def cpu_of_children() -> float:
    """Return the CPU seconds of all ended child processes that we waited for, and of their children."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def machine_busy() -> tuple[float, float]:
    """Return the CPU seconds that the whole machine has worked since it started, and those it could have worked."""
    fields = [int(text) for text in Path("/proc/stat").read_text().split("\n", 1)[0].split()[1:9]]
    idle = fields[3] + fields[4]
    return sum(fields) - idle, sum(fields)


def bare_node(times: int) -> tuple[list[float], float]:
    """Start Python, import rclpy, create a node, and end.

    Return the seconds of each run, and the CPU seconds per run.
    """
    with lease_domain() as lease:
        environ = child_environment(lease.domain_id)
        before = cpu_of_children()
        spent = [
            timed(lambda: subprocess.run([sys.executable, "-P", "-c", BARE_NODE], env=environ, check=True))
            for _ in range(times)
        ]
        return spent, (cpu_of_children() - before) / times


def wrong_answer(name: str) -> Answer:
    """Read one of the wrong answers."""
    tree = Tree(ROOT)
    return read_wrong_answer(tree, tree.wrong_answers / STEM / f"{name}.py").answer


def right_answer(name: str) -> Answer:
    """Read one of the right answers."""
    return read_answer(ROOT / "tests" / "right_answers" / STEM / f"{name}.py", STEM)


def slot_start(times: int, isolation: Isolation) -> float:
    """Return the CPU seconds of a slot that starts and ends without judging anything."""
    before = cpu_of_children()
    for _ in range(times):
        with Slot(isolation):
            pass
    return (cpu_of_children() - before) / times


def empty_program(tier: Tier | None) -> float:
    """Return the seconds from the start to the end of a program that only imports rclpy."""
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "answer.py"
        program.write_text("import rclpy\n", encoding="utf-8")
        began = time.monotonic()
        with NodeProcess(ProgramSpec(program), 0, tier) as process:
            process.wait(60.0)
            return time.monotonic() - began


# --- the parts ---------------------------------------------------------------------------------------------


def check(size: Size, exercise: Exercise, answer: Answer) -> Iterator[Figure]:
    """Measure `workbook check` as a command, and the minimal ROS program for comparison."""

    def whole_command(file: Path, passes: bool) -> None:
        command = [str(Path(sys.executable).with_name("workbook")), "check", "joint_positions", str(file)]
        done = subprocess.run(command, capture_output=True, text=True)
        if (done.returncode == 0) != passes:
            raise SystemExit(
                f"bench: {file.stem} was not judged as it should be:\n{done.stdout}{done.stderr}"
            )

    whole_command(SOLUTION, True)
    times = [timed(lambda: whole_command(SOLUTION, True)) for _ in range(size.runs)]
    yield of_times("workbook check joint_positions, whole command", times, 1.4)
    with tempfile.TemporaryDirectory() as folder:
        wrong: list[float] = []
        for name in WRONG:
            file = Path(folder, f"{name}.py")
            file.write_text(wrong_answer(name).text, encoding="utf-8")
            wrong += [timed(lambda file=file: whole_command(file, False)) for _ in range(size.runs)]  # type: ignore[misc]
    yield of_times("  for a wrong rate, value, type, or name", wrong, 2.5)
    slow = statistics.quantiles(wrong, n=20)[-1]
    yield Figure("  95th percentile of these", f"{slow:.2f} s", "", "< 4 s", slow < 4.0, {"seconds": slow})
    bare, _ = bare_node(size.runs)
    yield of_times("  for comparison: Python, import rclpy, one node", bare)
    ratio = statistics.median(times) / statistics.median(bare)
    yield Figure(
        "  the command, in multiples of that time", f"{ratio:.1f} ×", values={"ratio": round(ratio, 2)}
    )


def warm(size: Size, exercise: Exercise, answer: Answer) -> Iterator[Figure]:
    """Measure %check in a notebook until the card shows. Then watch the same answer on the wall clock."""
    with Slot() as slot:
        right = cards(slot, answer, size.runs)
        wrong = cards(slot, wrong_answer(WRONG_RATE), size.runs)
        threads = [cards(slot, right_answer(name), size.runs) for name in NEVER_AT_REST]
    times = [seconds for seconds, recording in right if recording.clock == "simulated"]
    speeds = [one.watched_s / seconds for seconds, one in right if one.clock == "simulated"]
    if not times:
        raise SystemExit("bench: this machine is too busy for simulated time; every run used the wall clock")
    yield of_times("%check on a warm slot, until the card shows", times, 0.7)
    yield of_times("  for a wrong rate", [seconds for seconds, _ in wrong], 0.7)
    yield of_times(
        "  for right answers with several threads", [one for some in threads for one, _ in some], 2.0
    )
    with Observer() as observer, tempfile.TemporaryDirectory() as folder:
        program = Path(folder, f"{STEM}.py")
        program.write_text(answer.text, encoding="utf-8")

        def on_the_wall_clock() -> None:
            with Watch(observer, ProgramSpec(program), exercise.plan, "wall") as watch:
                watch.finish(watch.observe())

        wall = [timed(on_the_wall_clock) for _ in range(size.wall_runs)]
    yield of_times("  the same answer on the wall clock", wall)
    ratio = statistics.median(wall) / statistics.median(times)
    yield Figure("  speedup by simulated time", f"{ratio:.1f} ×", values={"ratio": round(ratio, 2)})
    yield of_times("simulated seconds per real second, program start included", speeds, unit="s/s")


def cards(slot: Slot, answer: Answer, times: int) -> list[tuple[float, Recording]]:
    """Judge an answer repeatedly, as `%check` does. Return the seconds until the card shows, and each recording."""
    found = []
    for run in range(times + 1):
        shown: list[float] = []

        def report(judgement: Judgement, shown: list[float] = shown) -> None:
            if not judgement.provisional:
                shown.append(time.monotonic())
                slot.cancel_soak()

        began = time.monotonic()
        judgement = slot.judge(STEM, answer, soak=True, report=report)
        if judgement.recording is None:
            raise SystemExit(f"bench: not judged: {judgement.reason}")
        if run:  # the first run fills the caches
            found.append(((shown or [time.monotonic()])[0] - began, judgement.recording))
    return found


def lost(judgement: Judgement) -> frozenset[str]:
    """Return the criteria that were judged and did not pass."""
    return frozenset(one.id for one in judgement.criteria if one.status in ("failed", "partial"))


def repeatability(size: Size, exercise: Exercise, answer: Answer) -> Iterator[Figure]:
    """Judge the same answers repeatedly, with more slots than CPUs."""
    tree = Tree(ROOT)
    wrong = {name: read_wrong_answer(tree, tree.wrong_answers / STEM / f"{name}.py") for name in WRONG}
    each = max(1, size.repeats // 20)
    jobs = [Job("solution", STEM, answer) for _ in range(size.repeats - each * len(wrong))]
    jobs += [Job(name, STEM, one.answer) for name, one in wrong.items() for _ in range(each)]
    slots = 4 * CORES
    flips: Counter[str] = Counter()
    on_the_wall = ours = 0
    busy, had = machine_busy()
    for job, judgement in judge_all(jobs, slots, soak=False):
        if judgement.status != "graded":
            ours += 1
            print(f"  not judged: {judgement.reason}", file=sys.stderr)
            continue
        should = frozenset[str]() if job.key == "solution" else wrong[job.key].header.loses
        if lost(judgement) != should:
            flips[job.key] += 1
            print(
                f"  flipped: {job.key} lost {', '.join(sorted(lost(judgement))) or 'nothing'}",
                file=sys.stderr,
            )
        recording = judgement.recording
        on_the_wall += job.key == "solution" and recording is not None and recording.clock == "wall"
    now_busy, now_had = machine_busy()
    share = (now_busy - busy) / max(now_had - had, 1)
    rights = sum(job.key == "solution" for job in jobs)
    yield Figure(
        f"verdict flips, {slots} slots on {CORES} CPUs",
        f"{sum(flips.values())} of {len(jobs)}",
        f"CPUs {share:.0%} busy",
        "0",
        not flips,
        {"flips": sum(flips.values()), "repeats": len(jobs), "busy": round(share, 3)},
    )
    yield Figure(
        "  solutions that needed the wall clock",
        f"{on_the_wall} of {rights}",
        values={"wall_clock": on_the_wall, "solutions": rights},
    )
    yield Figure(
        "  not judged (our fault)", f"{ours} of {len(jobs)}", "", "0", ours == 0, {"infra_errors": ours}
    )


@contextmanager
def every_processor_busy() -> Iterator[None]:
    """Keep every CPU busy: run one endless computation per CPU inside the `with` block."""
    burners = [subprocess.Popen([sys.executable, "-I", "-S", "-c", "while True: pass"]) for _ in range(CORES)]
    try:
        yield
    finally:
        for burner in burners:
            burner.kill()
            burner.wait()


def fairness(size: Size, exercise: Exercise, answer: Answer) -> Iterator[Figure]:
    """Grade right answers of many styles as `workbook grade` does, on a machine that is far too busy."""
    files = [SOLUTION, *sorted((ROOT / "tests" / "right_answers" / STEM).glob("*.py"))]
    answers = {file.stem: read_answer(file, STEM) for file in files}
    names = [files[number % len(files)].stem for number in range(size.gradings)]
    jobs = [Job(name, STEM, answers[name]) for name in names]
    slots = 8 * CORES
    isolation = best_isolation()
    full = inconclusive = ours = on_the_wall = 0
    busy, had = machine_busy()
    began = time.monotonic()
    with every_processor_busy():
        for number, (job, judgement) in enumerate(judge_all(jobs, slots, isolation=isolation), start=1):
            full += judgement.full_marks
            inconclusive += bool(judgement.inconclusive_reason)
            ours += judgement.status != "graded"
            recording = judgement.recording
            on_the_wall += recording is not None and recording.clock == "wall"
            if not judgement.full_marks:
                tell_unfair(number, job.key, judgement)
            if number % 50 == 0:
                print(f"  {full} of {number} with full marks", file=sys.stderr, flush=True)
    seconds = time.monotonic() - began
    now_busy, now_had = machine_busy()
    share = (now_busy - busy) / max(now_had - had, 1)
    yield Figure(
        f"full marks for right answers, {slots} slots, {CORES} busy CPUs",
        f"{full} of {len(jobs)}",
        f"{len(files)} answers, {isolation}, CPUs {share:.0%} busy",
        "all",
        full == len(jobs),
        {"full_marks": full, "gradings": len(jobs), "inconclusive": inconclusive, "infra_errors": ours},
    )
    yield Figure(
        "  answers per minute",
        f"{60 * len(jobs) / seconds:.0f}",
        f"{seconds:.0f} s",
        values={"per_minute": round(60 * len(jobs) / seconds, 1), "seconds": round(seconds, 1)},
    )
    yield Figure("  inconclusive on the first try", f"{inconclusive} of {len(jobs)}")
    yield Figure("  that needed the wall clock", f"{on_the_wall} of {len(jobs)}")


def tell_unfair(number: int, name: str, judgement: Judgement) -> None:
    """Print what a right answer lost, and keep its recording."""
    print(f"  {name}: {judgement.reason or ''} {judgement.inconclusive_reason}", file=sys.stderr)
    for one in judgement.criteria:
        if one.status in ("failed", "partial"):
            print(f"    {one.id}: saw {one.saw}; expected {one.expected}", file=sys.stderr, flush=True)
    if judgement.recording is not None:
        folder = ARTIFACTS / "unfair"
        folder.mkdir(parents=True, exist_ok=True)
        judgement.recording.save(folder / f"{number:04d}-{name}.json")


def sandboxing(size: Size, exercise: Exercise, answer: Answer) -> Iterator[Figure]:
    """Measure the cost of a sandbox: start the same program outside and inside, in turn."""
    problem = sandbox_problem()
    if problem is not None:
        yield Figure("sandboxing a program", "not measured", problem)
        return
    server = ForkServer()
    tiers = {"outside": None, "in a sandbox": SandboxTier(), "in a sandbox, forked": SandboxTier(server)}
    times: dict[str, list[float]] = {name: [] for name in tiers}
    try:
        for number in range(size.runs * 3 + 1):
            for name, tier in tiers.items():
                spent = empty_program(tier)
                if number:  # the first run of each fills the caches and starts the server
                    times[name].append(spent)
    finally:
        server.close()
    outside = statistics.median(times["outside"])
    for name, spent in times.items():
        added = (statistics.median(spent) - outside) * 1000
        yield Figure(
            f"a program that imports rclpy, {name}",
            f"{statistics.median(spent) * 1000:.0f} ms",
            f"{min(spent) * 1000:.0f} to {max(spent) * 1000:.0f}, n = {len(spent)}",
            "" if name == "outside" else "≤ 25 ms more",
            None if name == "outside" else added <= 25,
            {"median": round(statistics.median(spent), 4), "added": round(added / 1000, 4)},
        )


def throughput(size: Size, exercise: Exercise, answer: Answer) -> Iterator[Figure]:
    """Measure answers per minute with the default options, and the CPU time per answer in units of a bare node.

    The CPU time includes the judge's own. The machine's speed may vary, so bare nodes are measured before and after
    each run.
    """
    isolation = best_isolation()
    slot_cpu = slot_start(3, isolation)
    bare = [bare_node(BARE_NODES)[1]]
    yield Figure("CPU time to start a slot", f"{slot_cpu:.2f} s", values={"cpu_s": round(slot_cpu, 4)})
    slots = SLOTS_PER_CORE[exercise.source.clock] * CORES
    for word in ("plain", "soak"):
        number = size.answers
        before = cpu_of_children()
        began = time.monotonic()
        jobs = [Job(one, STEM, answer) for one in range(number)]
        passed = sum(
            judgement.full_marks
            for _, judgement in judge_all(jobs, slots, soak=word == "soak", isolation=isolation, fills=True)
        )
        per_minute = 60 * number / (time.monotonic() - began)
        cpu = (cpu_of_children() - before) / number
        bare.append(bare_node(BARE_NODES)[1])
        bare_cpu = statistics.fmean(bare[-2:])
        yield Figure(
            f"answers per minute, {word}, {slots} in parallel",
            f"{per_minute:.0f}",
            f"{passed} of {number} passed, {isolation}",
            "≥ 150",
            per_minute >= 150,
            {"per_minute": round(per_minute, 1), "passed": passed, "answers": number},
        )
        yield Figure(
            f"  CPU time per answer, {word}, in bare nodes",
            f"{cpu / bare_cpu:.1f} ×",
            f"{cpu:.2f} s, including the start of slots; {bare[-2]:.2f} and {bare[-1]:.2f} s",
            "≤ 2 ×",
            cpu <= 2 * bare_cpu,
            {"cpu_s": round(cpu, 4), "bare_cpu_s": round(bare_cpu, 4), "ratio": round(cpu / bare_cpu, 3)},
        )


def last_test_run(size: Size, exercise: Exercise, answer: Answer) -> Iterator[Figure]:
    """Report how long the last `make test` took. Its style and type checks (some ten seconds) aren't included."""
    report = ARTIFACTS / "pytest.xml"
    if not report.is_file():
        yield Figure("make test", "no report yet", "run `make test` first", "< 900 s")
        return
    suites = list(ElementTree.parse(report).iter("testsuite"))
    total = sum(float(suite.get("time", "0")) for suite in suites)
    when = f"pytest of {suites[0].get('timestamp', '?')[:16]}" if suites else ""
    yield Figure("make test", f"{total:.0f} s", when, "< 900 s", total < 900, {"seconds": round(total, 1)})


def lab_starts(size: Size, exercise: Exercise, answer: Answer) -> Iterator[Figure]:
    """Measure a later start of `make lab` until the home page shows, and then the first cell of the first lesson."""
    from lab_start import measured_starts, missing

    if missing() is not None:
        yield Figure("a later start of JupyterLab", "not measured", missing() or "")
        return
    starts, answers = measured_starts(size.wall_runs)
    yield of_times("a later start of JupyterLab, until the home page shows", starts, 5.0)
    yield of_times("  the first cell of lesson 00, until its first output", answers, 2.0)


def frames(size: Size, exercise: Exercise, answer: Answer) -> Iterator[Figure]:
    """Measure the script time per frame in the panel, for a moving and for a resting robot."""
    from playwright.sync_api import sync_playwright

    from tests.browser.stage_frames import MOST_SCRIPT_MS, VIEW, script_ms
    from workbook.lab.health import chromium

    path = chromium()
    if path is None:
        yield Figure("script time per frame", "not measured", "needs a Chromium")
        return
    with tempfile.TemporaryDirectory() as home, sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=path,
            args=["--no-sandbox", "--disable-dev-shm-usage"],
            env={"PATH": os.environ["PATH"], "HOME": home},
        )
        page = browser.new_page(viewport=VIEW, reduced_motion="no-preference")
        for name, spent in script_ms(page).items():
            mean = statistics.fmean(spent)
            yield Figure(
                f"script time per frame: {name}",
                f"{mean:.2f} ms",
                f"longest {max(spent):.1f} ms, {len(spent)} frames",
                f"< {MOST_SCRIPT_MS:g} ms",
                mean < MOST_SCRIPT_MS,
                {"mean": mean, "all": spent},
            )
        browser.close()


def class_server(size: Size, exercise: Exercise, answer: Answer) -> Iterator[Figure]:
    """Measure a class at a hub: memory per student, and the time to a card at ten checks per minute."""
    try:
        from tests.hub.measured_class import measure
    except ImportError:
        yield Figure("a class on one server", "not measured", "make env EXTRAS=hub")
        return
    if os.geteuid() != 0 or sandbox_problem() is not None:
        yield Figure("a class on one server", "not measured", "needs root and bubblewrap")
        return
    seen = measure(size.students, STEM, answer.text)
    yield of_times(f"{size.students} students: a server starts in", seen.starts)
    for name, megabytes in (
        ("logged in", seen.idle),
        ("reading", seen.reading),
        ("at most, checking", seen.checking),
    ):
        yield Figure(
            f"  memory of a student, {name}", f"{megabytes:.0f} MB", values={"megabytes": round(megabytes)}
        )
    yield Figure("  memory left at the worst moment", f"{seen.free:.0f} MB", values={"megabytes": seen.free})
    for way, checks in seen.checks.items():
        yield of_times(f"  %check until the card shows, {way}", checks.took)
        slow = statistics.quantiles(checks.took, n=20)[-1]
        aim = 5.0 if way.startswith("ten") else None
        yield Figure(
            "    95 of 100 cards show within",
            f"{slow:.1f} s",
            "",
            "" if aim is None else f"< {aim:g} s",
            None if aim is None else slow < aim,
            {"seconds": slow},
        )
        yield Figure(
            "    right answers without full marks",
            f"{checks.refused} of {size.students}",
            "",
            "0",
            not checks.refused,
        )


PARTS: dict[str, Callable[[Size, Exercise, Answer], Iterator[Figure]]] = {
    "check": check,
    "warm": warm,
    "repeatability": repeatability,
    "isolation": sandboxing,
    "throughput": throughput,
    "lab": lab_starts,
    "frames": frames,
    "tests": last_test_run,
    "fairness": fairness,
    "class": class_server,
}
ONLY_WHEN_ASKED = ("fairness", "class")


def line(figure: Figure) -> str:
    sign = {None: " ", True: "✓", False: "✗"}[figure.holds]
    return f"{sign} {figure.name:<66} {figure.measured:>14}  {figure.aim:<8}  {figure.spread}".rstrip()


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the chosen parts. Return exit code 0 if every aim is met."""
    parser = argparse.ArgumentParser(description="Run the measurements of `make bench`.")
    parser.add_argument("--quick", action="store_true", help="a shorter run")
    parser.add_argument("--repeats", type=int, help="how many answers to judge for the verdict flips")
    parser.add_argument(
        "--only", choices=tuple(PARTS), action="append", help="run only this part (may be repeated)"
    )
    parser.add_argument("--gradings", type=int, help="how many answers to grade for the fairness part")
    options = parser.parse_args(arguments)
    size = QUICK if options.quick else FULL
    if options.repeats is not None:
        size = replace(size, repeats=max(len(WRONG) + 1, options.repeats))
    if options.gradings is not None:
        size = replace(size, gradings=max(1, options.gradings))
    exercise = load_exercise(STEM, ROOT)
    answer = read_answer(SOLUTION, STEM)
    print(f"{CORES} CPUs, Python {sys.version.split()[0]}, exercise {STEM}\n")
    print(f"  {'figure':<66} {'measured':>14}  {'aim':<8}  spread")
    figures: list[Figure] = []
    loads: dict[str, float] = {}
    for name in options.only or [part for part in PARTS if part not in ONLY_WHEN_ASKED]:
        loads[name] = os.getloadavg()[0]
        print(f"── {name} (load average {loads[name]:.1f} on {CORES} CPUs)", flush=True)
        for figure in PARTS[name](size, exercise, answer):
            figures.append(figure)
            print(line(figure), flush=True)
    ARTIFACTS.mkdir(exist_ok=True)
    content = {"processors": CORES, "load_average": loads, "figures": [asdict(figure) for figure in figures]}
    (ARTIFACTS / "bench.json").write_text(
        json.dumps(content, indent=1, ensure_ascii=False) + "\n", encoding="utf-8"
    )
    missed = [figure.name.strip() for figure in figures if figure.holds is False]
    print("\nEvery aim is met." if not missed else "\nMissed: " + "; ".join(missed) + ".")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())

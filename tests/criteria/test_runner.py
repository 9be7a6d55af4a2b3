"""Run criteria over a recording: order, needs, hidden criteria, parts, and criteria that crash."""

import itertools
import signal
import threading
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

import pytest
from std_msgs.msg import Float32, String

from tests.criteria.by_hand import recorded
from workbook.criteria import (
    Criterion,
    Recording,
    Verdict,
    criterion,
    failed,
    partial,
    passed,
    topic,
    watching,
)
from workbook.criteria.budget import OutOfTime, within_budget
from workbook.criteria.criterion import criteria_in, plan_for, topics_in, watching_in
from workbook.criteria.runner import CriterionError, run_criteria
from workbook.recording import script

BAD = failed("test.eleven", "11 values", "12 values", "one too few", "count again", about_time=True)


def says(name: str, verdict: Verdict, points: float = 2, **options: object) -> Criterion:
    def judge(recording: Recording) -> Verdict:
        return verdict

    judge.__name__ = name
    make: Callable[..., Criterion] = criterion(points=points, title=name.title(), **options)  # type: ignore[arg-type]
    return make(judge)


def test_results_come_in_the_order_of_the_criteria_with_all_texts() -> None:
    results = run_criteria([says("second", BAD), says("first", passed("all there"))], recorded())
    assert [result.id for result in results] == ["second", "first"]
    lost, kept = results
    assert (lost.status, lost.points, lost.max_points) == ("failed", 0.0, 2)
    assert (lost.saw, lost.expected, lost.because, lost.try_this) == (
        "11 values",
        "12 values",
        "one too few",
        "count again",
    )
    assert lost.about_time
    assert (kept.status, kept.points, kept.saw) == ("passed", 2, "all there")


def test_what_needs_a_failed_criterion_is_skipped_and_says_which() -> None:
    root = says("topic_is_there", BAD)
    child = says("right_values", passed("fine"), needs=[root])
    grandchild = says("right_sum", passed("fine"), needs=[child])
    free = says("alive", passed("fine"))
    results = {result.id: result for result in run_criteria([root, child, grandchild, free], recorded())}
    assert [results[name].status for name in ("right_values", "right_sum", "alive")] == [
        "skipped",
        "skipped",
        "passed",
    ]
    assert results["right_values"].points == 0.0
    assert results["right_values"].max_points == 2
    assert "Topic_Is_There" in results["right_values"].saw
    assert "Right_Values" in results["right_sum"].saw


def test_a_part_does_not_satisfy_a_need() -> None:
    half = says("half", partial("test.half", 0.5, "6 of 12", "12", "half is missing", "add it"), points=3)
    results = run_criteria([half, says("next_one", passed("fine"), needs=[half])], recorded())
    assert (results[0].status, results[0].points, results[1].status) == ("partial", 1.5, "skipped")


def test_a_skipped_criterion_is_not_even_called() -> None:
    def never(recording: Recording) -> Verdict:
        raise AssertionError("called although its need does not hold")

    root = says("root", BAD)
    assert run_criteria([root, criterion(points=1, title="Never", needs=[root])(never)], recorded())[
        1
    ].status == ("skipped")


def test_hidden_criteria_are_judged_and_marked() -> None:
    [result] = run_criteria([says("secret", BAD, hidden=True)], recorded())
    assert result.hidden
    assert result.status == "failed"


def test_no_word_of_a_program_is_a_command() -> None:
    @criterion(points=1, title="It is quiet")
    def quiet(recording: Recording) -> Verdict:
        return failed("test.commands", "a\x1b[2Jb\u202ec\x07", "d\x9be", "f\x00g", "h\x1b]0;owned\x07i")

    [result] = run_criteria([quiet], recorded())
    assert (result.saw, result.expected, result.because, result.try_this) == ("abc", "de", "fg", "hi")


def test_a_criterion_that_ends_the_program_is_our_fault() -> None:
    @criterion(points=1, title="It leaves")
    def leaves(recording: Recording) -> Verdict:
        raise SystemExit(0)

    with pytest.raises(CriterionError, match="leaves"):
        run_criteria([leaves], recorded())


def test_a_criterion_that_crashes_is_our_fault() -> None:
    @criterion(points=1, title="Divides by zero")
    def broken(recording: Recording) -> Verdict:
        return passed(str(1 / 0))

    with pytest.raises(CriterionError, match=r"broken crashed: ZeroDivisionError"):
        run_criteria([broken], recorded())


@pytest.mark.parametrize("returned", [None, True, "passed"])
def test_a_criterion_that_returns_no_verdict_is_our_fault(returned: object) -> None:
    @criterion(points=1, title="Returns something else")
    def careless(recording: Recording) -> Verdict:
        return returned  # type: ignore[return-value]

    with pytest.raises(CriterionError, match="careless returned"):
        run_criteria([careless], recorded())


def test_points_and_titles_are_checked() -> None:
    with pytest.raises(ValueError, match="never negative"):
        criterion(points=-1, title="Minus")
    with pytest.raises(ValueError, match="title"):
        criterion(points=1, title="  ")
    assert says("free", passed(""), points=0).points == 0


class Module:
    """A criteria file, as an imported module."""

    battery = topic("/robot/battery", Float32, hz=0.5)
    status = topic("/robot/status", String, hz=2.0)
    no_rate = topic("/robot/name", String)
    one = says("one", BAD)
    two = says("two", BAD)
    how = watching(simulated_seconds=30.0, to_the_end=True)


def test_a_module_tells_its_criteria_topics_and_plan() -> None:
    module: object = Module
    assert [one.id for one in criteria_in(module)] == ["one", "two"]  # type: ignore[arg-type]
    plan = plan_for(topics_in(module), watching_in(module))  # type: ignore[arg-type]
    assert plan.topics == ("/robot/battery", "/robot/status", "/robot/name")
    assert plan.step_s == pytest.approx(0.05)
    assert plan.simulated_s == 30.0
    assert plan.paced == ("/robot/battery", "/robot/status")
    assert plan.wall_s == 8.5


def test_without_a_word_on_it_a_watch_covers_nine_of_the_longest_period() -> None:
    plan = plan_for((Module.battery,), watching())
    assert plan.simulated_s == 18.0
    assert not watching().to_the_end


def test_a_script_may_be_drawn_for_each_run() -> None:
    how = watching(script=lambda rng: [script.publish("/said", String, [(0.5, str(rng.random()))])])
    plan = plan_for((Module.battery,), how)
    one, other = how.drawn(plan, 1), how.drawn(plan, 2)
    assert one == how.drawn(plan, 1)
    assert one.script != other.script
    assert (one.seed, other.seed, plan.seed) == (1, 2, None)
    fixed = watching(script=[script.publish("/said", String, [(0.5, "so")])])
    assert fixed.drawn(plan_for((), fixed), 1) == plan_for((), fixed)


def takes_long(name: str, forever: Callable[[], object]) -> Criterion:
    def judge(recording: Recording) -> Verdict:
        while True:
            try:
                forever()
            except Exception:  # a criterion may do this for its own reasons
                pass

    judge.__name__ = name
    return criterion(points=1, title=name)(judge)


def test_a_criterion_that_runs_out_of_time_is_named() -> None:
    quick = says("quick", passed("fine"))
    with pytest.raises(CriterionError, match=r"the criterion slow ran out of time: .* have 0\.05 s"):
        run_criteria([quick, takes_long("slow", lambda: sum(range(1000)))], recorded(), budget_s=0.05)
    assert "criteria" not in {thread.name for thread in threading.enumerate()}


def test_a_criterion_runs_out_of_time_in_any_thread() -> None:
    with ThreadPoolExecutor(1) as pool:
        judged = pool.submit(run_criteria, [takes_long("slow", lambda: None)], recorded(), 0.05)
        assert isinstance(judged.exception(), CriterionError)
        assert pool.submit(lambda: sum(range(10_000))).result() == 49_995_000, "the thread is unharmed"


def test_the_budget_is_for_all_criteria_together() -> None:
    def takes(recording: Recording) -> Verdict:
        end = time.thread_time() + 0.1
        while time.thread_time() < end:
            pass
        return passed("done")

    many = [criterion(points=1, title="Takes 0.1 s")(takes) for _ in range(4)]
    with pytest.raises(CriterionError, match="takes ran out of time"):
        run_criteria(many, recorded(), budget_s=0.25)


def test_waiting_for_a_processor_uses_no_budget() -> None:
    assert within_budget(lambda: time.sleep(0.2) or "done", budget_s=0.1) == "done"


def test_work_that_only_waits_ends_as_well() -> None:
    never = threading.Event()
    with pytest.raises(OutOfTime):
        within_budget(lambda: [never.wait(0.01) for _ in itertools.count()], budget_s=5.0, patience_s=0.1)


def test_an_interrupted_check_leaves_no_criterion_at_work() -> None:
    main, worker = threading.get_ident(), []

    def works() -> None:
        worker.append(threading.current_thread())
        signal.pthread_kill(main, signal.SIGINT)
        while True:
            pass

    before = signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's background jobs ignore it
    try:
        with pytest.raises(KeyboardInterrupt):
            within_budget(works, budget_s=600.0)
    finally:
        signal.signal(signal.SIGINT, before)
    worker[0].join()

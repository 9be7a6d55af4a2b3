"""Exercise 12: for every draw, each kind of mistake gets its own cause. No program runs here."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from operator import itemgetter

import pytest

from tests.criteria.by_hand import every, on_topic, recorded
from tests.exercises.proofs import ROOT
from workbook.exercise.definition import load_exercise
from workbook.recording.recording import CallSeen
from workbook.recording.script import Serves

EXERCISE = load_exercise("12_services", ROOT)
CRITERIA = {one.id: one for one in EXERCISE.criteria}
TEXT = "std_msgs/msg/String"
SEEDS = 100
FIRST_CALL_S = 0.8
PROMPTLY_S = 0.002
GIVEN_UP_S = 0.99  # just before the next call
NO_ANSWER = "no answer"


@dataclass(frozen=True)
class Asked:
    """A call (s) and its response: when it came (s; None if it never did), the result, and the text."""

    at: float
    answered: float | None
    success: bool
    text: str

    @property
    def word(self) -> str:
        return "ok" if self.success else "faulty"


Report = tuple[float, str]
"""When (s) the program published which word."""
Reports = Callable[[list[Asked]], Sequence[Report]]


def asked(seed: int) -> list[Asked]:
    """Return the calls of a program that calls once a second, with their responses."""
    [part] = EXERCISE.drawn(seed).plan.script.parts
    assert isinstance(part, Serves)
    return [
        Asked(
            FIRST_CALL_S + n,
            None if reply.after is None else FIRST_CALL_S + n + reply.after,
            reply.value["success"],
            reply.value["message"],
        )
        for n, reply in enumerate(part.replies)
    ]


def call_seen(one: Asked) -> CallSeen:
    call = CallSeen("/robot/self_test", "program", one.at, one.at, {})
    response = {"success": one.success, "message": one.text}
    if one.answered is None:
        return call
    return replace(call, response=response, answered_t=one.answered, answered_wall=one.answered)


def cause_in(calls: list[Asked], said: Sequence[Report], criterion: str) -> str:
    """Return the cause that this criterion names; "" if it passes."""
    end = EXERCISE.plan.wall_s
    words = sorted(((at + PROMPTLY_S, word) for at, word in said if at < end), key=itemgetter(0))
    health = on_topic("/robot/health", TEXT, [at for at, _ in words], [word for _, word in words])
    heart = on_topic("/robot/heartbeat", TEXT, every(0.2, 62), ["alive"] * 62, window=(0.0, end))
    recording = replace(recorded(health, heart), calls=tuple(map(call_seen, calls)), watched_s=end)
    return CRITERIA[criterion](recording).cause


def causes_over_all_draws(wrong: Reports, criterion: str) -> set[str]:
    """Return the causes that this criterion names, over all draws; "" if it passes."""
    return {cause_in(calls, wrong(calls), criterion) for calls in map(asked, range(SEEDS))}


def reports(
    word: Callable[[Asked], str] = lambda one: one.word,
    after_s: float = 0.0,
    patience_s: float = GIVEN_UP_S,
    unanswered: str = NO_ANSWER,
) -> Reports:
    """Report each response `after_s` seconds after it arrives, and give a call up after `patience_s` seconds."""

    def program(calls: list[Asked]) -> list[Report]:
        return [
            (one.at + patience_s, unanswered)
            if one.answered is None or one.answered > one.at + patience_s
            else (one.answered + after_s, word(one))
            for one in calls
        ]

    return program


right = reports()


def answers_only(calls: list[Asked]) -> list[Report]:
    return [(one.answered, one.word) for one in calls if one.answered is not None]


def in_vain_only(calls: list[Asked]) -> list[Report]:
    return [(one.at + GIVEN_UP_S, NO_ANSWER) for one in calls if one.answered is None]


def changes_only(calls: list[Asked]) -> list[Report]:
    said = sorted(right(calls), key=itemgetter(0))
    return [one for one, last in zip(said, [(0.0, ""), *said], strict=False) if one[1] != last[1]]


def none_after_no_answer(calls: list[Asked]) -> list[Report]:
    said = sorted(right(calls), key=itemgetter(0))
    before = [(0.0, ""), *said]
    return [
        one for one, last in zip(said, before, strict=False) if last[1] != NO_ANSWER or one[1] == NO_ANSWER
    ]


def collected(calls: list[Asked]) -> list[Report]:
    """Report the responses every 3.5 s."""
    answers = [(3.5 * ((at + 0.2) // 3.5 + 1.0) - 0.2, word) for at, word in answers_only(calls)]
    return [*answers, *in_vain_only(calls)]


def in_the_order_of_the_calls(calls: list[Asked]) -> list[Report]:
    said: list[Report] = []
    for one in calls:
        at, word = (one.at + 2.0, NO_ANSWER) if one.answered is None else (one.answered, one.word)
        said.append((max([at, *(t for t, _ in said)]), word))
    return said


RESULTS_TOLD: dict[str, Reports] = {
    "": right,
    "always-the-same": reports(lambda one: "ok"),
    "always-faulty": reports(lambda one: "faulty"),
    "changes-only": changes_only,
    "none-after-no-answer": none_after_no_answer,
    "one-left-out": lambda calls: right(calls)[1:],
    "one-twice": lambda calls: [*right(calls), (right(calls)[0][0] + 0.01, "ok")],
    "without-an-answer": lambda calls: [*right(calls), (4.3, "ok")],
    "delayed": reports(after_s=1.2),
    "collected": collected,
    "no-answer-came": reports(unanswered="faulty"),
    "given-up-early": reports(patience_s=0.4),
    "waits-for-earlier-call": in_the_order_of_the_calls,
    "late": lambda calls: [(one.at + 1.0, word) for one, (_, word) in zip(calls, right(calls), strict=True)],
    "more-than-once": lambda calls: [
        one for (at, word) in right(calls) for one in ((at, word), (at + 0.5, word)) if word != NO_ANSWER
    ],
    "inverted": reports(lambda one: "faulty" if one.success else "ok"),
    "follows-the-text": reports(lambda one: "ok" if one.text.startswith("all") else "faulty"),
}


@pytest.mark.parametrize("cause", RESULTS_TOLD)
def test_a_wrong_result_is_told_in_each_draw(cause: str) -> None:
    assert causes_over_all_draws(RESULTS_TOLD[cause], "results_told") == {cause and f"results-told.{cause}"}


def test_a_result_of_something_else_is_told_in_each_draw() -> None:
    slow_is_ok = reports(lambda one: "ok" if one.answered - one.at > 0.5 else one.word)
    assert causes_over_all_draws(slow_is_ok, "results_told") == {"results-told.other-result"}


def first_one_only(calls: list[Asked]) -> list[Report]:
    return [*answers_only(calls), *in_vain_only(calls)[:1]]


def once_in_a_row(calls: list[Asked]) -> list[Report]:
    silent = [one.at for one in calls if one.answered is None]
    first_ones = [at for at, last in zip(silent, [0.0, *silent], strict=False) if at - last > 1.5]
    return [*answers_only(calls), *((at + GIVEN_UP_S, NO_ANSWER) for at in first_ones)]


def closed_by_another(calls: list[Asked]) -> list[Report]:
    answered = [one.answered for one in calls if one.answered is not None]
    silent = [one.at for one in calls if one.answered is None]
    kept = [at for at in silent if not any(at < end < at + 1.5 for end in answered)]
    return [*answers_only(calls), *((at + 1.5, NO_ANSWER) for at in kept)]


UNANSWERED_TOLD: dict[str, Reports] = {
    "": right,
    "never": answers_only,
    "first-only": first_one_only,
    "once-in-a-row": once_in_a_row,
    "forgotten": closed_by_another,
    "always-late": reports(patience_s=3.0),
    "always-early": reports(patience_s=0.74),
    "early": reports(patience_s=0.4),
    "besides-the-answer": lambda calls: [*answers_only(calls), *((one.at, NO_ANSWER) for one in calls)],
}


@pytest.mark.parametrize("cause", UNANSWERED_TOLD)
def test_what_is_said_of_a_call_without_an_answer_is_told_in_each_draw(cause: str) -> None:
    assert causes_over_all_draws(UNANSWERED_TOLD[cause], "unanswered_told") == {
        cause and f"unanswered-told.{cause}"
    }


def test_a_program_stopped_by_the_first_bad_answer_has_called_too_seldom_in_each_draw() -> None:
    for seed in range(SEEDS):
        calls = asked(seed)
        assert [one.success for one in calls].index(False) in (1, 2)
        assert next(n for n, one in enumerate(calls) if one.answered is None) == 3
        assert not calls[-1].success and calls[-1].answered == calls[-1].at


@pytest.mark.parametrize(("criterion", "share"), [("results_told", 0.9), ("unanswered_told", 0.5)])
def test_what_was_said_in_one_run_is_wrong_in_most_others(criterion: str, share: float) -> None:
    """In half of the draws, other calls get no response. In most draws, the responses differ, too."""
    tables = [right(asked(SEEDS + n)) for n in range(20)]
    for table in tables:
        lost = [bool(cause_in(asked(seed), table, criterion)) for seed in range(SEEDS)]
        assert sum(lost) >= share * SEEDS

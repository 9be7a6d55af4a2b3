"""Scripts that are drawn for each run: what stays the same in each draw, and what changes."""

from dataclasses import replace

import pytest

from tests.exercises.proofs import ROOT, SEEDS, STEMS
from workbook.exercise.answers import Answer
from workbook.exercise.definition import Exercise, load_exercise
from workbook.grading.slots.client import Slot
from workbook.recording.script import Part, Publishes, Script, Serves

DRAWN = tuple(stem for stem in STEMS if not isinstance(load_exercise(stem, ROOT).watching.script, Script))


def shape(part: Part) -> Part:
    """Return what a program may rely on: names, types, and QoS."""
    return replace(part, replies=()) if isinstance(part, Serves) else replace(part, lines=())


@pytest.fixture(params=DRAWN)
def exercise(request: pytest.FixtureRequest) -> Exercise:
    return load_exercise(request.param, ROOT)


def test_a_script_is_drawn_from_its_seed_alone(exercise: Exercise) -> None:
    once, again = ([exercise.drawn(seed).plan for seed in range(SEEDS)] for _ in range(2))
    assert repr(once) == repr(again)  # nan is not equal to itself
    assert len({repr(plan.script) for plan in once}) == SEEDS
    assert [plan.seed for plan in once] == [*range(SEEDS)]


def test_every_draw_has_the_same_topics_and_ends_in_time(exercise: Exercise) -> None:
    plan = exercise.plan
    watched_s = plan.simulated_s if exercise.source.clock == "simulated" else plan.wall_s
    for seed in range(SEEDS):
        script = exercise.drawn(seed).plan.script
        assert [*map(shape, script.parts)] == [*map(shape, plan.script.parts)]
        for part in script.parts:
            assert not isinstance(part, Publishes) or part.lines
            assert isinstance(part, Serves) or all(line.at < watched_s for line in part.lines)


def test_a_slot_draws_from_the_seed_that_it_is_given_and_else_from_another_each_time() -> None:
    exercise = load_exercise("04_subscriptions_and_callbacks", ROOT)
    answer = Answer(exercise.source.solution_code)
    with Slot() as slot:
        recordings = [
            slot.judge(exercise.stem, answer, soak=False, seed=seed).recording for seed in (7, None, None)
        ]
    assert len({one.seed for one in recordings if one is not None}) == 3
    for one in recordings:
        assert one is not None and one.seed is not None
        part = exercise.drawn(one.seed).plan.script.parts[0]
        assert isinstance(part, Publishes)
        said = [word.value for word in one.published if word.topic == part.topic]
        assert repr(said) == repr([dict(line.value) for line in part.lines])
    assert recordings[0] is not None and recordings[0].seed == 7

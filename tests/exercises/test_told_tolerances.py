"""The tolerances that a task tells are those that its criteria apply."""

import re
from typing import Any

import pytest

from workbook.criteria import things_seen
from workbook.criteria.criterion import Topic
from workbook.criteria.vocabulary import batteries
from workbook.criteria.vocabulary.rates import (
    INTERVAL_TOLERANCE,
    LONGEST_GAP_PERIODS,
    MEAN_TOLERANCE,
    RATE_TOLERANCE,
)
from workbook.exercise.course import course_folder
from workbook.exercise.definition import load_exercise

ROOT = course_folder()


def task(stem: str) -> str:
    """The text of a task, with white space folded."""
    lines = (ROOT / "solutions" / f"{stem}.py").read_text(encoding="utf-8").splitlines()
    return re.sub(
        r"\s+", " ", " ".join(line.removeprefix("#").strip() for line in lines if line.startswith("#"))
    )


def constants(stem: str) -> dict[str, Any]:
    """The constants of a criteria file."""
    return load_exercise(stem, ROOT).criteria[-1].judge.__globals__


def test_04_tells_when_a_reading_is_passed_on_at_once() -> None:
    applied, told = constants("04_subscriptions_and_callbacks"), task("04_subscriptions_and_callbacks")
    assert f"right away (within {applied['AT_ONCE_S']:g} s)" in told
    assert round(1.0 / (1.0 - applied["SHARE_AT_ONCE"])) == 10
    assert f"one good reading in ten may come later than {applied['AT_ONCE_S']:g} s" in told


def test_06_tells_how_exact_a_call_must_be() -> None:
    applied, told = constants("06_spinning"), task("06_spinning")
    first = f"{applied['ASKED_S'][applied['BURST']]:g} s"
    early, late, job = (f"{applied[name]:g} s" for name in ("EARLY_S", "LATE_S", "JOB_S"))
    assert f"after {first} when asked for {first}: at most {early} earlier, at most {late} later" in told
    assert f"at most one job ({job}) and {late}" in told
    assert f"it returns in time ({late}) from the quiet robot" in told


def test_06_tells_how_the_timers_must_tick_and_what_waiting_may_cost() -> None:
    applied, told = constants("06_spinning"), task("06_spinning")
    share, silence = applied["LEAST_SHARE"], applied["LONGEST_SILENCE_S"]
    assert f"{share:.0%}".replace("%", " %") in told and f"no silence over {silence:g} s" in told
    assert f"less than {applied['PROCESSOR_SHARE']:.0%}".replace("%", " %") in told
    assert f"less than {applied['SHARE_WITH_TIMERS']:.0%}".replace("%", " %") in told


def share(value: float) -> str:
    return f"{value:.0%}".replace("%", " %")


def test_12_tells_when_a_report_is_in_time() -> None:
    applied, told = constants("12_services"), task("12_services")
    patience, limit = f"{applied['MAY_TAKE_S']:g} s", f"{applied['GIVEN_UP_WITHIN_S']:g} s"
    assert f"when it comes, at most {applied['TOLD_WITHIN_S']:g} s later" in told
    assert f"no earlier than {patience} and no later than {limit} after the call" in told
    slack, longer = f"{applied['SLACK_S']:g} s", f"{applied['LONG_SLACK_S']:g} s"
    once = f"{applied['BELONGS_S'] - applied['TOLD_WITHIN_S']:g} s"
    assert f"be {slack} later than stated above, and one of them {once} later" in told
    assert f"A `no answer` may be {longer} later, or {slack} earlier" in told
    assert f"Where every `no answer` is early, {applied['NEARLY_S']:g} s is the limit" in told
    assert (
        f"some after {applied['SLOW']:g} s" in told
        and {12.5: "twelve and a half real seconds"}[applied["WATCH_S"]] in told
    )


def test_12_tells_what_once_a_second_and_five_hertz_mean() -> None:
    applied, told = constants("12_services"), task("12_services")
    period = (
        f"{applied['SHORTEST_PERIOD_S']:g} to {applied['LONGEST_PERIOD_S']:g} s from one call to the next"
    )
    pause = f"{applied['LONGEST_PAUSE_S']:g} s"
    assert f"{period}. At most one pause is over {applied['PAUSE_S']:g} s, and none reaches {pause}" in told
    assert f"each pause may be up to {pause}" in told and applied["PAUSES"] == 1
    assert f"at most one call for every {applied['SHORTEST_PERIOD_S']:g} s (rounded" in told
    assert f"{share(applied['LEAST_SHARE'])} to {share(applied['MOST_SHARE'])} of the beats" in told
    assert f"one every {applied['SHORTEST_BEAT_S']:g} to {applied['LONGEST_BEAT_S']:g} s" in told
    assert f"The last one comes at most {applied['STOPPED_S']:g} s before the end" in told
    assert f"While calls are open, {share(applied['LEAST_MEANWHILE'])} of the beats are enough" in told


def test_07_tells_how_long_it_watches() -> None:
    watched = load_exercise("07_typed_nodes", ROOT).plan.simulated_s
    assert f"It watches for {watched:g} s" in task("07_typed_nodes")


def test_13_tells_when_the_line_and_the_alarm_must_come() -> None:
    applied, told = constants("13_qos_and_discovery"), task("13_qos_and_discovery")
    assert {15.0: "for fifteen real seconds"}[applied["WATCH_S"]] in told
    assert f"At most {applied['AT_ONCE_S']:g} s after the start, the line must show" in told
    assert f"at most {applied['FOLLOWS_S']:g} s after the robot has published it" in told
    earliest, latest = f"{applied['NOT_BEFORE_S']:g} s", f"{applied['NOT_AFTER_S']:g} s"
    assert f"raised no earlier than {earliest} and no later than {latest} after the last beat" in told
    assert f"at most {applied['FALLS_WITHIN_S']:g} s after that" in told
    assert f"may be raised, and end, {applied['SLACK_S']:g} s later" in told
    assert f"{applied['SLOWEST_HZ']:g} to {applied['FASTEST_HZ']:g} Hz" in told
    assert f"one line every {applied['SHORTEST_S']:g} to {applied['LONGEST_S']:g} s" in told
    assert f"no silence over {applied['LONGEST_GAP_S']:g} s" in told


def test_14_tells_how_much_noise_and_delay_is_left_and_how_near_an_angle_must_be() -> None:
    applied, told = constants("14_arrays_and_filters"), task("14_arrays_and_filters")
    assert f"at most {share(applied['MOST_NOISE'])} of the noise is left" in told
    assert f"At each joint by itself, at most {share(applied['MOST_NOISE_OF_ONE'])} is left" in told
    assert f"the angles of all joints together are at most {applied['LONGEST_DELAY_S']:g} s behind" in told
    assert f"no single joint more than {applied['LONGEST_DELAY_OF_ONE_S']:g} s" in told
    starting = f"each of the first {applied['STARTING']} answers is within {applied['NEAR_RAD']:g} rad"
    assert told.count(f"{starting} of the joint") == 2
    assert f"within {applied['NEAR_RAD']:g} rad of the joint until the joints move" in told
    assert f"within {applied['FOLLOWS_RAD']:g} rad near the end of that movement" in told
    assert f"at least half of the answers come within {applied['TYPICALLY_S']:g} s of their message" in told
    assert f"differ by at most {applied['LEAST_CHANGE_RAD']:g} rad from those received" in told
    assert "*unchanged* are root mean squares" in told
    assert f"the mean error is more than {applied['LARGEST_NOISE_RAD']:g} rad" in told
    assert round(10 * applied["SHARE_AT_ONCE"]) == 9
    assert f"nine of ten within {applied['AT_ONCE_S']:g} s" in told


def test_14_tells_what_the_encoders_say() -> None:
    applied, told = constants("14_arrays_and_filters"), task("14_arrays_and_filters")
    noise, largest = f"{applied['NOISE_RAD']:g} rad", f"{applied['LARGEST_NOISE_RAD']:g} rad"
    assert f"standard deviation of {noise} and never exceeds {largest}" in told
    assert f"{1 / applied['PERIOD_S']:.0f} messages a second: names" in told
    assert f"publishes {len(applied['SAMPLES'])} messages" in told
    assert f"from 1 s ({applied['SETTLED']} messages) after a start or a change" in told
    stands_again = range(applied["STANDS"] + applied["MOVES"], applied["STILL_UNTIL"])
    assert all(place in stands_again for place in applied["NAN_AT"])


def test_14_measures_noise_in_the_standstills_that_it_tells() -> None:
    applied, told = constants("14_arrays_and_filters"), task("14_arrays_and_filters")
    assert "in the first standstill and after the first restart, at most" in told
    restart, settled = applied["RESTART"], applied["SETTLED"]
    assert set(applied["STEADY"]) == {
        *range(settled, applied["STANDS"]),
        *range(restart + settled, applied["RESTART_AGAIN"] - 4),  # answers just before a restart may be mixed
    }


def test_14_restarts_where_neither_nanosec_alone_nor_rising_stamps_show_it() -> None:
    applied = constants("14_arrays_and_filters")
    for start in (applied["RESTART"], applied["RESTART_AGAIN"]):
        before, after = (applied["SAMPLES"][start + n].stamp for n in (-1, 0))
        assert after < before and after[1] > before[1]


def test_14_has_a_stamp_for_each_message_and_a_number_of_messages_that_no_group_divides() -> None:
    samples = constants("14_arrays_and_filters")["SAMPLES"]
    assert len({sample.stamp for sample in samples}) == len(samples)
    assert all(len(samples) % size for size in range(2, len(samples)))


def test_02_tells_how_far_a_rate_may_be_off() -> None:
    told = task("02_nodes")
    assert f"A rate may be {RATE_TOLERANCE:.0%}".replace("%", " %") in told
    assert f"no gap may be longer than {LONGEST_GAP_PERIODS:g} periods" in told


def test_03_tells_how_exact_a_number_must_be_and_how_many_calls_there_are() -> None:
    applied, told = constants("03_publishers_and_messages"), task("03_publishers_and_messages")
    assert f"within {applied['TOLERANCE']:.5f}, each" in told and f"with {applied['COUNT']} values" in told


def test_01_tells_how_long_the_guard_is_watched_and_what_it_must_log() -> None:
    applied, told = constants("01_the_context"), task("01_the_context")
    watched, lines = f"{applied['WATCH_S']:g} s", f"{applied['LEAST_ROUNDS']} lines"
    assert f"for about {watched}. During this time, it has to log at least {lines}" in told


def test_05_tells_what_evenly_means() -> None:
    told = task("05_timers")
    assert "one period from one message to the next, and never more than one and a half" in told
    assert LONGEST_GAP_PERIODS == 1.5
    assert f"mean interval may differ from the period by {share(MEAN_TOLERANCE)}" in told
    assert "the median interval by a tenth" in told and INTERVAL_TOLERANCE == 0.1


def test_08_tells_how_far_below_full_the_first_charge_may_be() -> None:
    told = task("08_humanoid_status_publisher")
    assert (batteries.DROPS_BEFORE_THE_FIRST, batteries.DROPS_MISSED_ON_THE_WALL_CLOCK) == (1.5, 4.0)
    assert f"up to {batteries.ROUNDING:g} % plus one and a half of the largest steps below 100 %" in told
    assert f"{batteries.ROUNDING:g} % plus four steps are allowed" in told


@pytest.mark.parametrize("stem", ["08_humanoid_status_publisher", "09_joint_positions"])
def test_08_and_09_tell_how_far_a_rate_may_be_off(stem: str) -> None:
    topics = [one for one in constants(stem).values() if isinstance(one, Topic) and one.hz]
    assert topics
    for one in topics:
        low, high = one.hz * (1 - RATE_TOLERANCE), one.hz * (1 + RATE_TOLERANCE)
        gap = f"no gap over {LONGEST_GAP_PERIODS / one.hz:g} s"
        assert f"({low:g} to {high:g} Hz, {gap}" in task(stem), one


@pytest.mark.parametrize("stem", ["05_timers", "08_humanoid_status_publisher", "09_joint_positions"])
def test_how_long_a_program_is_watched_is_told(stem: str) -> None:
    watched = load_exercise(stem, ROOT).plan.simulated_s
    told = "one minute" if watched == 60.0 else f"{watched:g} s"
    assert f"for {told} of robot time" in task(stem)


def test_10_tells_how_the_heart_must_beat_and_how_exact_a_plan_must_be() -> None:
    applied, told = constants("10_slow_callbacks"), task("10_slow_callbacks")
    assert f"{share(applied['LEAST_SHARE'])} to {share(applied['MOST_SHARE'])} of the heartbeats" in told
    low, high = applied["TYPICALLY_S"]
    assert f"typically there are {low:g} to {high:g} s between two (the mean over five)" in told
    assert applied["AVERAGED"] == 5
    assert f"never more than {applied['LONGEST_SILENCE_S']:g} s without a heartbeat" in told
    exact = f"{applied['TOLERANCE_RAD']:f} rad"
    assert f"to {exact}, and comes {applied['SOONEST_S']:g} s after its request, or later" in told


def test_11_tells_how_soon_a_touch_must_be_reported_and_what_it_may_cost() -> None:
    applied, told = constants("11_polling_against_callbacks"), task("11_polling_against_callbacks")
    assert applied["ALONE_SHARE"] == 0.75
    assert f"three in four are reported within {applied['ALONE_MS']:g} ms" in told
    assert f"half within {applied['TOGETHER_MS']:g} ms" in told
    assert f"less than {share(applied['PROCESSOR_SHARE'])} of a processor" in told


def test_15_tells_how_wide_the_ball_is_and_shows_it_above_and_below_the_brick() -> None:
    applied, told = constants("15_camera"), task("15_camera")
    assert f"it publishes {applied['PICTURES']} images" in told
    pictures = applied["drawn"](0)
    seen = [
        {thing.label: thing for thing in things_seen(pictures.views[place].scene)}
        for place in pictures.with_ball
    ]
    assert f"at least {min(things['ball'].width for things in seen) // 1:.0f} pixels wide" in told
    assert {things["ball"].v < things["brick"].v for things in seen} == {True, False}
    assert {things["ball"].width < things["brick"].height for things in seen} == {True, False}


def test_16_tells_how_fresh_and_how_right_detections_must_be() -> None:
    applied, told = constants("16_ai_model"), task("16_ai_model")
    typically, mostly = f"{applied['TYPICALLY_S']:g} s", f"{applied['MOSTLY_S']:g} s"
    assert round(10 * applied["MOSTLY_SHARE"]) == 9
    assert (
        f"at least half of the messages come at most {typically} after their image, and nine of ten at most {mostly}"
        in told
    )
    assert f"at least {applied['LEAST_HZ']:g} images a second are answered" in told
    soonest, model = f"{applied['SOONEST_S']:g} s", f"{applied['MODEL_S']:g} s"
    assert (
        f"each message comes at least {soonest} after its image" in told
        and f"model, which takes {model}" in told
    )
    assert f"at least {share(applied['RIGHT_SHARE'])} of the messages have each toy" in told
    assert f"within {applied['WITHIN_PIXELS']:g} pixels" in told


def test_16_tells_how_the_heart_beats_and_what_a_fall_is() -> None:
    applied, told = constants("16_ai_model"), task("16_ai_model")
    shares = f"{share(applied['LEAST_BEATS'])} to {share(applied['MOST_BEATS'])} of ten a second"
    assert f"{shares}, never more than {applied['LONGEST_SILENCE_S']:g} s without one" in told
    assert "from the first one on" in told
    assert applied["TILTED_SAMPLES"] == 10
    assert f"ten samples in a row are tilted by more than {applied['TILT_DEG']:g}°" in told
    assert f"`error` comes at most {applied['FALL_WITHIN_S']:g} s after the tenth" in told
    assert f"It sends {applied['PICTURES']} images" in told
    blind = sum(end - begin for begin, end in applied["drawn"](0).events.glare_s)
    assert f"for {blind:.1f} s of that time, there's glare" in told

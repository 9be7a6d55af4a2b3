"""Exercise 16 on recordings made by hand: a good one, and causes that no wrong answer triggers."""

import random
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import Any

import pytest

from tests.criteria.by_hand import ended_by_itself, publisher, recorded
from workbook.criteria import Verdict
from workbook.exercise.course import course_folder
from workbook.exercise.definition import load_exercise
from workbook.recording.recording import Arrival, Published, Recording, SubscriberSeen, TopicRecording

CRITERIA = {one.id: one for one in load_exercise("16_ai_model", course_folder()).criteria}
NAMES: dict[str, Any] = CRITERIA["survives"].judge.__globals__
SEED = 1
"""The seed of a run in which the robot falls after the second glare."""
RUN = NAMES["drawn"](SEED)
SENT = [0.5 + place / 30 for place in range(NAMES["PICTURES"])]
FELT = [0.5 + number / 50 for number in range(len(RUN.samples))]
FALLEN = FELT[RUN.fall_sample]
GLARING = SENT[RUN.in_glare[0]]
LOG = "[ERROR] [desk_watcher]: The model gave up: glare: 97% of the picture is white"
DETECTIONS, STATUS = "/robot/detections", "/robot/status"
Message = tuple[float, Any]


def markers(place: int) -> dict[str, Any]:
    """Return markers for all toys of an image, with its stamp."""
    sec, nanosec = RUN.views[place].stamp
    header = {"stamp": {"sec": sec, "nanosec": nanosec}, "frame_id": ""}
    toys = RUN.toys[place]
    return {
        "markers": [
            {"header": header, "ns": toy.label, "pose": {"position": {"x": toy.u, "y": toy.v, "z": 0.0}}}
            for toy in toys
        ]
    }


def found(age: float = 0.21, until: float = 12.0) -> list[Message]:
    """Return a message every 0.2 s, with the toys of the image from `age` seconds before."""
    made = []
    for number in range(56):
        at = 1.0 + 0.2 * number
        place = round((at - age - 0.5) * 30)
        if at < until and 0 <= place < len(SENT) and place not in RUN.in_glare:
            made.append((at, markers(place)))
    return made


def beats(error_at: float | None = FALLEN + 0.1, until: float = 12.2, period: float = 0.1) -> list[Message]:
    """Return the status as a heartbeat."""
    times = [period * (n + 1) for n in range(round(until / period))]
    return [
        (at, {"data": "error" if error_at is not None and at >= error_at else "operational"}) for at in times
    ]


def on(name: str, kind: str, messages: Iterable[Message]) -> TopicRecording:
    arrivals = tuple(Arrival(at, at, value) for at, value in messages)
    return TopicRecording(name, (publisher(kind),), (), arrivals, (0.0, 12.2))


def recording(
    detections: Sequence[Message] | None = None, status: Sequence[Message] | None = None, log: str = LOG
) -> Recording:
    made = recorded(
        on(DETECTIONS, "visualization_msgs/msg/MarkerArray", found() if detections is None else detections),
        on(STATUS, "std_msgs/msg/String", beats() if status is None else status),
    )
    listeners = {
        name: TopicRecording(name, (), (SubscriberSeen("/desk_watcher", kind, "reliable", "volatile"),))
        for name, kind in (
            ("/camera/image", "sensor_msgs/msg/Image"),
            ("/robot/imu", "sensor_msgs/msg/Imu"),
        )
    }
    said = [Published("/camera/image", at, at, {}) for at in SENT] + [
        Published("/robot/imu", at, at, {}) for at in FELT
    ]
    return replace(
        made,
        topics={**made.topics, **listeners},
        published=tuple(sorted(said, key=lambda one: one.wall)),
        process=replace(made.process, log=log),
        seed=SEED,
    )


def judged(criterion: str, seen: Recording) -> Verdict:
    return CRITERIA[criterion](seen)


def test_a_good_recording_gets_full_marks() -> None:
    seen = recording()
    lost = {name: one(seen) for name, one in CRITERIA.items() if name != "program_runs" and not one(seen).ok}
    assert lost == {}


@pytest.mark.parametrize("age", [0.2, 0.24, 0.3])
def test_detections_of_any_age_that_is_told_are_fresh(age: float) -> None:
    assert judged("fresh", recording(found(age))).ok


def test_one_late_detection_in_ten_is_forgiven() -> None:
    late = [(at + (0.16 if number % 11 == 5 else 0.0), value) for number, (at, value) in enumerate(found())]
    seen = recording(sorted(late, key=lambda one: one[0]))
    assert judged("fresh", seen).ok and judged("stamps_kept", seen).ok


def empty() -> list[Message]:
    return [(at, {"markers": []}) for at, _ in found()]


CASES: list[tuple[str, str, Callable[[], Recording]]] = [
    ("heartbeat-kept.stops", "heartbeat_kept", lambda: recording(status=beats(until=5.0))),
    (
        "heartbeat-kept.held-up",
        "heartbeat_kept",
        lambda: recording(status=[one for one in beats() if not 4.0 < one[0] < 6.0]),
    ),
    ("detections-come.empty", "detections_come", lambda: recording(empty())),
    ("answers.too-few", "fresh", lambda: recording(found()[:2])),
    ("survives.not-seen", "survives", lambda: recording(found(until=GLARING - 0.5))),
    ("fall-reported.before", "fall_reported", lambda: recording(status=beats(error_at=1.0))),
    ("fall-reported.late", "fall_reported", lambda: recording(status=beats(error_at=FALLEN + 0.7))),
    ("fresh.some-guessed", "fresh", lambda: recording(hurried(4, 0.15))),
    ("fresh.rarely-after-the-fall", "fresh", lambda: recording(rare_from(FALLEN, 2))),
    (
        "survives.pauses",
        "survives",
        lambda: recording([one for one in found() if not 0.0 < one[0] - GLARING < 3.0]),
    ),
    ("survives.same-picture-again", "survives", lambda: recording(found(until=GLARING), log=40 * f"{LOG}\n")),
    (
        "survives.marker-without-a-toy",
        "survives",
        lambda: recording(
            sorted([*found(), (GLARING + 0.5, toyless(RUN.in_glare[5]))], key=lambda one: one[0])
        ),
    ),
    (
        "stamps-kept.some-without-stamp",
        "stamps_kept",
        lambda: recording([(at, stamped_once(value)) for at, value in found()]),
    ),
    (
        "stamps-kept.last-result-again",
        "stamps_kept",
        lambda: recording([(0.91 + place / 30, markers_of(place, place - 9)) for place in range(12, 60)]),
    ),
    (
        "stamps-kept.one-for-each-detection",
        "stamps_kept",
        lambda: recording([(at, {"markers": [one]}) for at, value in found() for one in value["markers"]]),
    ),
    ("stamps-kept.repeated", "stamps_kept", lambda: recording([one for one in found() for _ in range(2)])),
    ("right.labels", "right", lambda: recording([(at, all_bricks(value)) for at, value in found()])),
    ("right.something-else", "right", lambda: recording([(at, flipped(value)) for at, value in found()])),
]


def hurried(each: int, sooner: float) -> list[Message]:
    """Make one of every `each` messages arrive sooner."""
    return [
        (at - (sooner if number % each == 2 else 0.0), value) for number, (at, value) in enumerate(found())
    ]


def rare_from(moment: float, each: int) -> list[Message]:
    """From this moment on, keep only one of every `each` messages."""
    return [one for number, one in enumerate(found()) if one[0] < moment or number % each == 0]


def toyless(place: int) -> dict[str, Any]:
    """Return one marker without a label, for an image."""
    return {"markers": [{**markers(place)["markers"][0], "ns": ""}]}


def stamped_once(message: dict[str, Any]) -> dict[str, Any]:
    """Remove the stamp from all markers of a message except the first."""
    first, *others = message["markers"]
    nothing = {"stamp": {"sec": 0, "nanosec": 0}, "frame_id": ""}
    return {"markers": [first, *({**one, "header": nothing} for one in others)]}


def markers_of(stamped: int, shown: int) -> dict[str, Any]:
    """Return the toys of one image with the stamp of another."""
    header = markers(stamped)["markers"][0]["header"]
    return {"markers": [{**one, "header": header} for one in markers(shown)["markers"]]}


def all_bricks(message: dict[str, Any]) -> dict[str, Any]:
    """Label each marker of a message as a brick."""
    return {"markers": [{**one, "ns": "brick"} for one in message["markers"]]}


def flipped(message: dict[str, Any]) -> dict[str, Any]:
    """Turn the markers of a message upside down."""
    turned = []
    for one in message["markers"]:
        place = one["pose"]["position"]
        turned.append({**one, "pose": {"position": {**place, "y": 119.0 - place["y"]}}})
    return {"markers": turned}


@pytest.mark.parametrize(("cause", "criterion", "make"), CASES, ids=[case[0] for case in CASES])
def test_a_cause(cause: str, criterion: str, make: Callable[[], Recording]) -> None:
    verdict = judged(criterion, make())
    assert (verdict.status, verdict.cause) == ("failed", cause), verdict
    assert verdict.expected and verdict.because and verdict.try_this


@pytest.mark.parametrize("lag", [4, 6, 7])
@pytest.mark.parametrize("blur", [0.0, 1.5])
def test_the_header_of_a_later_picture_costs_the_point_for_stamps_alone(lag: int, blur: float) -> None:
    """The model takes 0.2 s, and the header comes from the image that is newest when the model returns."""
    dice = random.Random(lag)
    made = []
    for number in range(8, 52):
        shown = 6 * number
        if not {shown, shown + lag} & set(RUN.in_glare):
            message = markers_of(shown + lag, shown)
            for one in message["markers"]:
                one["pose"] = {
                    "position": {k: v + dice.gauss(0.0, blur) for k, v in one["pose"]["position"].items()}
                }
            made.append((SENT[shown] + lag / 30 + 0.01, message))
    seen = recording(made)
    verdict = judged("stamps_kept", seen)
    assert verdict.cause == "stamps-kept.later-picture", verdict
    others = {
        name: judged(name, seen).saw for name in ("fresh", "right", "survives") if not judged(name, seen).ok
    }
    assert others == {}


def test_without_stamps_freshness_is_not_judged() -> None:
    nothing = {"stamp": {"sec": 0, "nanosec": 0}, "frame_id": ""}
    made = [
        (at, {"markers": [{**one, "header": nothing} for one in value["markers"]]}) for at, value in found()
    ]
    seen = recording(made)
    assert judged("stamps_kept", seen).cause == "stamps-kept.no-stamp"
    assert {judged(name, seen).status for name in ("fresh", "right")} == {"skipped"}


def test_a_fall_that_waits_for_the_model_is_told_apart() -> None:
    """The status follows right after each message with detections, because one thread serves both."""
    after = [(at + 0.005, {"data": "error" if at > FALLEN + 0.7 else "operational"}) for at, _ in found()]
    seen = recording(status=after)
    assert judged("heartbeat_kept", seen).cause == "heartbeat-kept.waits-for-the-model"
    assert judged("fall_reported", seen).cause == "fall-reported.waits-for-the-model"


def test_a_program_that_ended_before_the_fall_is_not_blamed_for_it() -> None:
    seen = recording(status=beats(until=5.0))
    cut = tuple(one for one in seen.published if one.wall < 5.0)
    verdict = judged("fall_reported", replace(seen, published=cut, process=ended_by_itself()))
    assert verdict.cause == "fall-reported.ended-before"


def test_who_never_reached_the_glare_is_not_blamed_for_what_it_brings() -> None:
    """With a growing queue, the program is still answering images from the first seconds when the watch ends."""
    behind = [(1.0 + 0.2 * number, markers(number)) for number in range(55)]
    assert judged("survives", recording(behind, log="")).cause == "survives.not-seen"
    assert judged("fresh", recording(behind)).cause == "fresh.queue-grows"


def test_the_heartbeat_of_a_program_that_ended_counts_until_its_end() -> None:
    """On a busy machine, the judge notices the end late."""
    seen = recording(status=beats(until=4.0))
    ended = replace(seen, process=ended_by_itself(), wanted=(STATUS, DETECTIONS))
    cut = {**ended.topics, DETECTIONS: on(DETECTIONS, "visualization_msgs/msg/MarkerArray", found(until=3.9))}
    assert judged("heartbeat_kept", replace(ended, topics=cut)).ok


STANDS_AT, STANDS_S = 4.0, 0.9


def held_up(seen: Recording) -> Recording:
    """Delay everything after a moment, as if the whole machine had stood still once."""

    def late(at: float) -> float:
        return at if at < STANDS_AT else at + STANDS_S

    def moved(topic: TopicRecording) -> TopicRecording:
        arrivals = tuple(replace(one, t=late(one.t), wall=late(one.wall)) for one in topic.arrivals)
        return replace(topic, arrivals=arrivals, window=topic.window and (0.0, late(topic.window[1])))

    return replace(
        seen,
        topics={name: moved(topic) for name, topic in seen.topics.items()},
        published=tuple(replace(one, t=late(one.t), wall=late(one.wall)) for one in seen.published),
    )


def test_a_machine_that_stood_still_costs_a_right_answer_nothing() -> None:
    seen = held_up(recording())
    lost = {name: one(seen) for name, one in CRITERIA.items() if name != "program_runs" and not one(seen).ok}
    assert lost == {}


def test_a_program_that_stands_still_alone_loses() -> None:
    """Only the program stood still: the judge went on publishing."""
    still = held_up(recording())
    alone = replace(still, published=recording().published)
    assert judged("heartbeat_kept", alone).cause == "heartbeat-kept.held-up"


@pytest.mark.parametrize(("cause", "criterion", "make"), CASES, ids=[case[0] for case in CASES])
def test_a_machine_that_stood_still_hides_no_cause(
    cause: str, criterion: str, make: Callable[[], Recording]
) -> None:
    verdict = judged(criterion, held_up(make()))
    assert (verdict.status, verdict.cause) == ("failed", cause), verdict

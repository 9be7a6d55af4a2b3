"""What the robot on a card does, as pure functions of progress and recordings."""

import json
import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import pytest

from tests.exercises.stored_proofs import load, stored
from workbook.grading.slots.protocol import Progress
from workbook.magics.robot_on_card import EXCERPT_S, LARGEST_REPLAY, TICK_S, WatchedRobot, replay_of
from workbook.pictures.joints import CHEER, SQUAT
from workbook.recording.recording import (
    Arrival,
    CallSeen,
    Published,
    PublisherSeen,
    Recording,
    ServiceSeen,
    SubscriberSeen,
    TopicRecording,
)

TEXT, NUMBER, NUMBERS = (f"std_msgs/msg/{kind}" for kind in ("String", "Float32", "Float32MultiArray"))
SOLUTIONS = [path for path in stored() if path.name == "solution.json.xz"]


def said(
    name: str, kind: str, values: Sequence[object], period: float = 1.0, start: float = 0.0
) -> TopicRecording:
    arrivals = tuple(
        Arrival(start + period * at, 0.0, None if value is None else {"data": value})
        for at, value in enumerate(values)
    )
    publisher = PublisherSeen("/robot", kind, "reliable", "volatile", 0.0)
    return TopicRecording(name, publishers=(publisher,), arrivals=arrivals)


def recorded(*topics: TopicRecording, **more: Any) -> Recording:
    return Recording(clock="simulated", domain_id=1, topics={one.name: one for one in topics}, **more)


def replayed(recording: Recording, effect: str) -> list[tuple[int, object]]:
    events: Any = replay_of(recording)["events"]
    return [(moment, news[effect]) for moment, news in events if effect in news]


def test_the_heart_beats_as_it_was_written() -> None:
    beats = [0.5, 0.8, 2.0, 2.3]
    topic = said("/robot/heartbeat", TEXT, ["beat"] * len(beats))
    arrivals = tuple(replace(one, t=t) for one, t in zip(topic.arrivals, beats, strict=True))
    assert replayed(recorded(replace(topic, arrivals=arrivals)), "beat") == [
        (0, 1),
        (300, 1),
        (1500, 1),
        (1800, 1),
    ]


def test_poses_come_at_their_time_and_the_robot_takes_them_slowly_where_they_are_rare() -> None:
    poses = [list(CHEER), list(SQUAT)] * 2
    rare = recorded(said("/robot/joint_positions", NUMBERS, poses, period=2.0))
    assert replayed(rare, "pose") == list(zip((0, 2000, 4000, 6000), poses, strict=True))
    often = recorded(said("/robot/joint_positions", NUMBERS, poses, period=0.1))
    assert replay_of(often)["glide"] < replay_of(rare)["glide"]  # type: ignore[operator]


def test_of_many_messages_only_some_move_the_robot_and_the_replay_is_short() -> None:
    many = [[math.sin(at / 50 + joint) for joint in range(12)] for at in range(12_000)]
    replay: Any = replay_of(recorded(said("/robot/joint_positions", NUMBERS, many, period=0.005)))
    moments = [moment for moment, _ in replay["events"]]
    assert moments == sorted(moments) and moments[0] == 0
    assert moments[-1] <= 1000 * EXCERPT_S and len(moments) <= EXCERPT_S / TICK_S + 1
    assert len(json.dumps(replay)) < LARGEST_REPLAY


def test_the_replay_shows_where_most_happens_with_what_held_before() -> None:
    battery = said("/robot/battery", NUMBER, [50.0])
    status = said("/robot/status", TEXT, ["operational", "error"] * 2, start=30.0)
    replay: Any = replay_of(recorded(battery, status))
    start, news = replay["events"][0]
    assert (start, news["battery"], news["face"], news["awake"]) == (0, 50.0, "operational", True)
    assert replayed(recorded(battery, status), "face")[1] == (1000, "error")


def test_what_the_judge_sends_moves_the_robot_unless_the_program_moves_the_same_part() -> None:
    listens = SubscriberSeen("/robot", NUMBER, "reliable", "volatile")
    script = tuple(Published("/robot/battery", float(at), 0.0, {"data": 80.0 - at}) for at in range(3))
    alarm = said("/monitor/alarm", TEXT, ["low"])
    heard = TopicRecording("/robot/battery", subscribers=(listens,))
    assert [charge for _, charge in replayed(recorded(alarm, heard, published=script), "battery")] == [
        80.0,
        79.0,
        78.0,
    ]
    deaf = recorded(alarm, TopicRecording("/robot/battery"), published=script)
    assert replayed(deaf, "battery") == []
    own = said("/monitor/battery", NUMBER, [10.0])
    assert [charge for _, charge in replayed(recorded(own, heard, published=script), "battery")] == [10.0]


def test_the_robot_nods_or_shakes_its_head_at_a_response_and_thinks_of_a_plan() -> None:
    calls = tuple(
        CallSeen("/robot/self_test", "judge", t, 0.0, {}, {"success": t < 2.0}, answered_t=t + 0.5)
        for t in (1.0, 2.0)
    )
    unanswered = CallSeen("/robot/self_test", "judge", 3.0, 0.0, {})
    offered = (ServiceSeen("/robot/self_test", "std_srvs/srv/Trigger"),)
    recording = recorded(
        said("/robot/plan", NUMBER, [1.0, 2.0]), calls=(*calls, unanswered), services=offered
    )
    assert replayed(recording, "nod") == [(1500, 1)]
    assert replayed(recording, "shake") == [(2500, 1)]
    assert replayed(recording, "thought") == [(0, 1), (1000, 1)]


@pytest.mark.parametrize("value", [[1.0] * 11, ["NaN"] * 12, 7, "up", None, {"length": 9, "first": []}])
def test_the_robot_waves_where_nothing_would_move_it(value: object) -> None:
    replay: Any = replay_of(recorded(said("/robot/joint_positions", NUMBERS, [value])))
    assert len({str(news["pose"]) for _, news in replay["events"]}) > 10
    assert "waves" in replay["events"][0][1]["text"]


def test_plumbing_moves_nothing_and_fills_no_line() -> None:
    plumbing = said("/driver/heartbeat", TEXT, ["x" * 50] * 3)
    status = said("/robot/status", TEXT, ["operational"])
    assert replayed(recorded(plumbing, status), "beat") == []
    assert [words for _, words in replayed(recorded(plumbing, status), "words")] == ["status: operational"]


@pytest.mark.parametrize("path", SOLUTIONS, ids=lambda path: path.parent.name)
def test_every_solution_has_a_replay_that_fits_into_a_notebook(path: Any) -> None:
    replay: Any = replay_of(load(path)[1])
    assert replay["events"] and replay["events"][0][1]["awake"] is True
    assert len(json.dumps(replay, allow_nan=False)) < LARGEST_REPLAY


def test_while_it_is_watched_the_robot_follows_the_latest_messages() -> None:
    types = {"/robot/heartbeat": TEXT, "/robot/battery": NUMBER}
    latest = {"/robot/heartbeat": {"data": "beat"}, "/robot/battery": {"data": 62.5}}
    robot = WatchedRobot()
    assert robot.after(Progress(0, 0.1), 9.0)["news"].keys() == {"text"}  # type: ignore[attr-defined]
    first: Any = robot.after(
        Progress(0, 1.0, {"/robot/heartbeat": 1, "/robot/battery": 1}, latest, types), 10.0
    )
    assert (first["news"]["beat"], first["news"]["battery"], first["news"]["awake"]) == (1, 62.5, True)
    # There is no new heartbeat, so the heart doesn't beat again. Lasting values are sent each time, because only the
    # last news are kept.
    second: Any = robot.after(
        Progress(0, 6.0, {"/robot/heartbeat": 1, "/robot/battery": 4}, latest, types), 10.5
    )
    assert "beat" not in second["news"] and second["news"]["battery"] == 62.5

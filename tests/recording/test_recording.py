"""A recording survives being stored, whatever its messages contain. Damaged recordings are refused."""

import array
import copy
import hashlib
import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from std_msgs.msg import ByteMultiArray, Float32MultiArray, Float64MultiArray, String, UInt8MultiArray

from workbook.recording.recording import (
    Arrival,
    Finding,
    NodeSeen,
    ProcessRecord,
    PublisherSeen,
    Recording,
    Stretch,
    SubscriberSeen,
    TopicRecording,
)
from workbook.recording.type_names import type_name
from workbook.watching import values

GOLDEN = Path(__file__).resolve().parents[1] / "recordings" / "09_joint_positions"
FIELDS = ("data", "layout", "position", "first", "length", "sec")

moments = st.floats(0, 1e5)
scalars = st.one_of(st.none(), st.booleans(), st.integers(-(2**63), 2**64), st.floats(), st.text(max_size=20))
contents = st.recursive(
    scalars,
    lambda inner: st.lists(inner, max_size=5) | st.dictionaries(st.sampled_from(FIELDS), inner, max_size=4),
    max_leaves=12,
)
names = st.from_regex(r"/[a-z][a-z0-9_]{0,9}(/[a-z][a-z0-9_]{0,9})?", fullmatch=True)
publishers = st.builds(
    PublisherSeen, names, names, st.just("reliable"), st.just("volatile"), moments, st.none() | moments
)
subscribers = st.builds(SubscriberSeen, names, names, st.just("best_effort"), st.just("volatile"))
topics = st.builds(
    TopicRecording,
    names,
    st.lists(publishers, max_size=2).map(tuple),
    st.lists(subscribers, max_size=2).map(tuple),
    st.lists(st.builds(Arrival, moments, moments, contents), max_size=5).map(tuple),
    st.none() | st.tuples(moments, moments),
    st.integers(0, 9),
    st.integers(0, 9),
)
processes = st.builds(
    ProcessRecord,
    program=st.text(max_size=10),
    exit=st.none() | st.integers(0, 255),
    signal=st.sampled_from([None, "SIGKILL"]),
    ended_at=st.none() | moments,
    ended_by=st.sampled_from([None, "itself", "judge"]),
    watched_for=moments,
    limits_hit=st.sampled_from([(), ("output", "cpu")]),
    log=st.text(max_size=50),
    log_truncated=st.booleans(),
    domains_used=st.lists(st.integers(0, 232), max_size=2).map(tuple),
)
recordings = st.builds(
    Recording,
    clock=st.sampled_from(["simulated", "wall"]),
    domain_id=st.integers(1, 101),
    stretches=st.lists(st.builds(Stretch, moments, moments, moments), max_size=2).map(tuple),
    watched_s=moments,
    wall_s=moments,
    topics=st.lists(topics, max_size=3).map(lambda found: {topic.name: topic for topic in found}),
    nodes=st.lists(st.builds(NodeSeen, names, moments), max_size=2).map(tuple),
    process=processes,
    follows_clock=st.sampled_from([None, True, False]),
    step_s=st.none() | moments,
    notes=st.lists(st.text(max_size=10), max_size=2).map(tuple),
    findings=st.none()
    | st.lists(
        st.builds(
            Finding, st.text(max_size=10), st.integers(0, 99), st.text(max_size=5), st.text(max_size=20)
        ),
        max_size=2,
    ).map(tuple),
)


def same(one: Any, other: Any) -> bool:
    """Return whether two values are equal. NaN equals itself, but 1 equals neither 1.0 nor True."""
    if type(one) is not type(other):
        return False
    if isinstance(one, float):
        return one == other or (math.isnan(one) and math.isnan(other))
    if isinstance(one, dict):
        return one.keys() == other.keys() and all(same(one[key], other[key]) for key in one)
    if isinstance(one, (list, tuple)):
        return len(one) == len(other) and all(map(same, one, other))
    if hasattr(one, "__dataclass_fields__"):
        return all(same(getattr(one, name), getattr(other, name)) for name in one.__dataclass_fields__)
    return bool(one == other)


def holds(new: Any, old: Any) -> bool:
    """Return whether stored data includes all of an older version's data. A later version may have added fields."""
    if isinstance(old, dict):
        return isinstance(new, dict) and all(key in new and holds(new[key], old[key]) for key in old)
    if isinstance(old, list):
        return isinstance(new, list) and len(new) == len(old) and all(map(holds, new, old))
    return same(new, old)


@given(recordings)
@settings(max_examples=60)
def test_a_recording_survives_json(recording: Recording) -> None:
    text = json.dumps(recording.to_json(), allow_nan=False)
    assert same(Recording.from_json(json.loads(text)), recording)


@given(contents)
def test_json_has_no_nan_that_other_readers_refuse(content: Any) -> None:
    arrival = Arrival(0.0, 0.0, content)
    recording = Recording("wall", 1, topics={"/odd": TopicRecording("/odd", arrivals=(arrival,))})

    def no_constant(name: str) -> None:
        raise AssertionError(f"{name} is no JSON")

    json.loads(json.dumps(recording.to_json()), parse_constant=no_constant)


@pytest.mark.parametrize("path", sorted(GOLDEN.glob("*.json")), ids=lambda path: path.stem)
def test_stored_recordings_load_and_are_saved_alike(path: Path, tmp_path: Path) -> None:
    copied = tmp_path / "again.json"
    recording = Recording.load(path)
    recording.save(copied)
    assert same(Recording.load(copied), recording)
    assert holds(json.loads(copied.read_text()), json.loads(path.read_text()))


@pytest.mark.parametrize(
    "data",
    [None, [], "recording", 7, {}, {"format": 0}, {"format": 2}, {"format": 1}, {"format": "1"}],
    ids=repr,
)
def test_what_is_no_recording_is_refused(data: Any) -> None:
    with pytest.raises(ValueError, match=r"recording"):
        Recording.from_json(data)


def damages(data: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """Yield the place of every container and field in a stored recording, down to the first arrival."""
    found = [path] if path else []
    if path[-1:] == ("value",):
        return found
    if isinstance(data, dict):
        for key, item in data.items():
            found += damages(item, (*path, key))
    elif isinstance(data, list) and data:
        found += damages(data[0], (*path, 0))
    return found


DEFAULTS = {"last_seen", *ProcessRecord.__dataclass_fields__} - {"limits_hit", "domains_used"}
WHOLE = json.loads((GOLDEN / "wrong_name.json").read_text())


@pytest.mark.parametrize("path", [path for path in damages(WHOLE) if isinstance(path[-1], str)], ids=str)
def test_a_recording_with_a_missing_field_is_refused(path: tuple[Any, ...]) -> None:
    data = copy.deepcopy(WHOLE)
    inner = data
    for key in path[:-1]:
        inner = inner[key]
    del inner[path[-1]]
    may_be_missing = path[-1] in DEFAULTS or path[-2:-1] == ("topics",)
    if may_be_missing:
        assert isinstance(Recording.from_json(data), Recording)
    else:
        with pytest.raises(ValueError, match="recording"):
            Recording.from_json(data)


@pytest.mark.parametrize(
    ("path", "junk"),
    [
        (("topics",), []),
        (("topics",), None),
        (("process",), 7),
        (("process",), {"surprise": 1}),
        (("phases",), [{"speed": 1.0}]),
        (("nodes",), [["/humanoid", 0.1]]),
        (("topics", "/robot/battery"), None),
        (("topics", "/robot/battery", "arrivals"), [1, 2]),
        (("topics", "/robot/battery", "window"), []),
        (("topics", "/robot/battery", "window"), [1.0]),
        (("topics", "/robot/battery", "window"), 3.0),
        (("topics", "/robot/battery", "publishers"), [{"node": "/humanoid"}]),
        (("notes",), None),
    ],
    ids=str,
)
def test_a_recording_with_other_data_in_place_is_refused(path: tuple[str, ...], junk: Any) -> None:
    data = copy.deepcopy(WHOLE)
    inner = data
    for key in path[:-1]:
        inner = inner[key]
    inner[path[-1]] = junk
    with pytest.raises(ValueError, match="damaged"):
        Recording.from_json(data)


@pytest.mark.parametrize("text", ["", "{", "[]", "NaN", '{"format": 1', "\x00"])
def test_a_torn_file_is_refused(text: str, tmp_path: Path) -> None:
    path = tmp_path / "torn.json"
    path.write_text(text)
    with pytest.raises(ValueError, match=r"."):
        Recording.load(path)


def test_an_older_recording_knows_nothing_of_a_type_checker() -> None:
    assert "findings" not in WHOLE
    assert Recording.from_json(WHOLE).findings is None


def test_an_unseen_topic_is_an_empty_recording() -> None:
    recording = Recording.from_json(WHOLE)
    assert recording.topic("/nobody") == TopicRecording("/nobody")
    assert "/nobody" not in {topic.name for topic in recording.with_publishers()}


# --- messages as plain data -----------------------------------------------------------------------------------


def test_messages_become_plain_data() -> None:
    message = Float32MultiArray(data=[0.5, -1.0])
    assert values.plain(message)["data"] == [0.5, -1.0]
    assert values.plain(message)["layout"]["dim"] == []
    assert values.plain(UInt8MultiArray(data=bytes([1, 2])))["data"] == [1, 2]
    assert values.plain(String(data="grüß dich")) == {"data": "grüß dich"}


@pytest.mark.parametrize("count", [values.LONGEST_ARRAY, values.LONGEST_ARRAY + 1, 100_000])
def test_long_arrays_and_texts_are_cut_and_say_how_long_they_were(count: int) -> None:
    floats = array.array("d", [0.5] * count)
    for data, first, whole in (
        (values.plain(Float64MultiArray(data=floats)), values.FIRST_OF_ARRAY, floats.tobytes()),
        (values.plain(UInt8MultiArray(data=bytes(count))), values.FIRST_OF_ARRAY, bytes(count)),
        (values.plain(ByteMultiArray(data=[b"\x01"] * count)), values.FIRST_OF_ARRAY, None),
        (values.plain(String(data="ü" * count)), values.LONGEST_TEXT, b"\xc3\xbc" * count),
    ):
        kept = data["data"]
        if count <= values.LONGEST_ARRAY:
            assert len(kept) == count
            continue
        assert kept["length"] == count
        assert len(kept["first"]) == first
        assert kept.get("sha256") == (None if whole is None else hashlib.sha256(whole).hexdigest())
        assert values.bytes_kept(data) <= 8 * first + 200


def test_a_long_array_of_numpy_is_cut_alike() -> None:
    table = np.arange(10_000, dtype=np.float32).reshape(100, 100)
    kept = values.plain(table)
    assert kept["length"] == 10_000
    assert kept["first"] == list(map(float, range(values.FIRST_OF_ARRAY)))
    assert kept["sha256"] == hashlib.sha256(table.tobytes()).hexdigest()
    assert values.plain(table[:2]) == list(map(float, range(200)))


@pytest.mark.parametrize(
    "name",
    ["", "String", "std_msgs/msg", "std_msgs/srv/String", "os/msg/../path", "no_such/msg/Thing", "a/msg/b-c"],
)
def test_a_type_that_is_not_here_is_none(name: str) -> None:
    assert values.known_class(name) is None


def test_type_names_and_classes_belong_together() -> None:
    assert type_name(String) == "std_msgs/msg/String"
    assert values.known_class("std_msgs/msg/String") is String

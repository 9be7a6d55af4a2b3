"""The codec can read what it writes, names the place of invalid data, and keeps stored formats unchanged."""

import json
import math
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from typing import Any, ClassVar, Literal

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.recording.test_recording import recordings, same
from workbook.recording.codec import (
    ALWAYS_STORED,
    NOT_STORED,
    STORED_IF_SET,
    UNKNOWN_FIELDS,
    Malformed,
    decode,
    encode,
    stored_as,
)
from workbook.recording.recording import Recording


@dataclass(frozen=True)
class Wheel:
    name: str
    turns: float
    ok: bool = True


@dataclass(frozen=True)
class Robot:
    kind: Literal["biped", "rover"]
    wheels: tuple[Wheel, ...]
    pose: tuple[float, float] | None
    by_name: Mapping[str, Wheel]
    value: Any
    count: int = 0
    from_: str = field(default="", metadata=stored_as("from"))
    always: int = field(default=1, metadata=ALWAYS_STORED)
    secret: str = field(default="s", metadata=NOT_STORED)


@dataclass(frozen=True)
class Kept:
    name: str
    unknown: Mapping[str, Any] = field(default_factory=dict, metadata=UNKNOWN_FIELDS)


@dataclass(frozen=True)
class Keeping:
    name: str
    inner: tuple[Kept, ...] = ()
    unknown: Mapping[str, Any] = field(default_factory=dict, metadata=UNKNOWN_FIELDS)


@dataclass(frozen=True)
class Ignoring:
    name: str
    ignores_unknown_fields: ClassVar[bool] = True


DATA: dict[str, Any] = {
    "kind": "rover",
    "wheels": [{"name": "left", "turns": 1.5, "ok": True}],
    "pose": [0.0, 1],
    "by_name": {"left": {"name": "left", "turns": 2, "ok": False}},
    "value": {"data": [1, {"float": "nan"}]},
    "count": 3,
    "from": "far",
    "always": 2,
}


def test_what_is_written_is_read() -> None:
    robot = decode(Robot, DATA)
    assert robot.wheels == (Wheel("left", 1.5),)
    assert robot.pose == (0.0, 1)
    assert math.isnan(robot.value["data"][1])
    assert robot.from_ == "far"
    assert robot.secret == "s"
    assert json.dumps(encode(robot)) == json.dumps(DATA)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"kind": "boat"}, "kind: 'boat' is not 'biped' or 'rover'"),
        ({"wheels": {}}, "wheels: {} is not a list"),
        ({"wheels": [1]}, "wheels[0]: 1 is not an object (Wheel)"),
        ({"wheels": [{"name": "left", "turns": "2"}]}, "wheels[0].turns: '2' is not a finite number"),
        ({"wheels": [{"name": "left", "turns": True}]}, "wheels[0].turns: True is not a finite number"),
        ({"wheels": [{"name": "left", "turns": math.inf}]}, "wheels[0].turns: inf is not a finite number"),
        ({"wheels": [{"name": "left"}]}, "wheels[0].turns: it is missing"),
        ({"wheels": [{"name": "l", "turns": 1.0, "size": 3}]}, "wheels[0].size: Wheel has no such field"),
        ({"pose": [1.0]}, "pose: it holds 1 values and not 2"),
        ({"pose": [1.0, None]}, "pose[1]: None is not a finite number"),
        ({"by_name": {"x": None}}, "by_name['x']: None is not an object (Wheel)"),
        ({"count": 1.0}, "count: 1.0 is not a whole number"),
        ({"count": True}, "count: True is not a whole number"),
        ({"from": "\ud83d"}, "from: '\\ud83d' holds half a character"),
        ({"always": None}, "always: None is not a whole number"),
    ],
)
def test_what_does_not_fit_is_named_by_its_place(change: dict[str, Any], said: str) -> None:
    with pytest.raises(Malformed) as caught:
        decode(Robot, {**DATA, **change})
    assert str(caught.value) == said


@pytest.mark.parametrize(
    ("name", "may_be_missing"),
    [("count", True), ("from", True), ("always", False), ("kind", False), ("pose", False)],
)
def test_what_an_older_version_did_not_write_gets_its_default(name: str, may_be_missing: bool) -> None:
    data = {key: item for key, item in DATA.items() if key != name}
    if may_be_missing:
        assert isinstance(decode(Robot, data), Robot)
    else:
        with pytest.raises(Malformed, match=f"^{name}: it is missing$"):
            decode(Robot, data)


def test_unknown_fields_are_kept_dropped_or_refused_as_the_class_says() -> None:
    data = {"name": "a", "inner": [{"name": "b", "new": {"x": [1]}}], "newer": None}
    kept = decode(Keeping, data)
    assert kept.inner[0].unknown == {"new": {"x": [1]}}
    assert encode(kept) == data
    assert decode(Ignoring, {"name": "a", "new": 1}) == Ignoring("a")
    with pytest.raises(Malformed, match="secret: Robot has no such field"):
        decode(Robot, {**DATA, "secret": "told"})


def test_what_json_cannot_hold_is_not_written() -> None:
    with pytest.raises(Malformed, match=r"^turns: nan is not a finite number$"):
        encode(Wheel("left", math.nan))
    with pytest.raises(Malformed, match="value: b'x' cannot be stored"):
        encode(decode(Robot, DATA | {"value": 1}).__class__("rover", (), None, {}, b"x"))


def as_before(value: Any) -> Any:
    """Return what recordings contained before there was a codec: every field of every object in order."""
    if isinstance(value, float) and not math.isfinite(value):
        return {"float": str(value)}
    if isinstance(value, (str, int, float, bool)) or value is None:
        return value
    if isinstance(value, Mapping):
        return {str(key): as_before(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [as_before(item) for item in value]
    return {
        one.metadata.get("stored as", one.name): as_before(getattr(value, one.name))
        for one in fields(value)
        if one.name != "format" and (one.metadata != STORED_IF_SET or getattr(value, one.name))
    }


@given(recordings)
def test_recordings_are_written_byte_for_byte_as_before(recording: Recording) -> None:
    before = {"format": 1, **as_before(recording)}
    assert json.dumps(recording.to_json()) == json.dumps(before)


@given(recordings, st.data())
def test_data_changed_anywhere_is_refused_or_read(recording: Recording, data: st.DataObject) -> None:
    stored = json.loads(json.dumps(recording.to_json()))
    place = stored
    while isinstance(place, (dict, list)) and place:
        key = data.draw(st.sampled_from(sorted(place) if isinstance(place, dict) else range(len(place))))
        if data.draw(st.booleans()):
            place[key] = data.draw(st.sampled_from([None, 7, -1.5, "x", [], {}, True, [[]], {"a": 1}]))
            break
        place = place[key]
    try:
        read = Recording.from_json(stored)
    except ValueError:
        return
    assert same(Recording.from_json(read.to_json()), read)


def test_a_field_that_is_stored_if_set_is_left_out_while_it_is_empty() -> None:
    @dataclass(frozen=True)
    class Seldom:
        often: str = ""
        problem: str = field(default="", metadata=STORED_IF_SET)

    for one, data in ((Seldom(), {"often": ""}), (Seldom("", "none"), {"often": "", "problem": "none"})):
        assert encode(one) == data
        assert decode(Seldom, data) == one

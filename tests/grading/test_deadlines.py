"""Deadlines: they name their zone, some students get extensions, and corrected times take effect right away."""

import csv
from datetime import UTC, datetime
from pathlib import Path

import pytest

from workbook.cli.main import main
from workbook.grading.deadlines import (
    about_unknown,
    in_words,
    parse_deadline,
    read_extensions,
    same_name,
    zone_named,
)
from workbook.grading.roster import BadOption

STEM = "09_joint_positions"
BERLIN = zone_named("Europe/Berlin")


@pytest.mark.parametrize(
    ("text", "utc"),
    [
        ("2026-05-31T23:59", "2026-05-31 21:59:00"),
        ("2026-05-31 23:59", "2026-05-31 21:59:00"),
        ("2026-05-31", "2026-05-31 21:59:59"),
        ("2026-05-31T23:59Z", "2026-05-31 23:59:00"),
        ("2026-05-31T23:59-05:00", "2026-06-01 04:59:00"),
        ("2026-01-31T23:59", "2026-01-31 22:59:00"),
        ("2026-10-25T02:30", "2026-10-25 01:30:00"),  # this time occurs twice; the later one counts
    ],
)
def test_a_deadline_without_a_zone_is_read_in_the_one_that_was_named(text: str, utc: str) -> None:
    moment = parse_deadline(text, BERLIN)
    assert moment is not None
    assert f"{moment.astimezone(UTC):%Y-%m-%d %H:%M:%S}" == utc
    assert f"{utc} UTC" in in_words(moment)


def test_without_a_name_the_machines_zone_counts(monkeypatch: pytest.MonkeyPatch) -> None:
    import time

    with monkeypatch.context() as patch:
        patch.setenv("TZ", "America/New_York")
        time.tzset()
        moment = parse_deadline("2026-05-31T23:59", None)
        assert moment is not None
        assert in_words(moment) == "2026-05-31 23:59:00 (UTC-04:00), which is 2026-06-01 03:59:00 UTC"
    time.tzset()


@pytest.mark.parametrize("text", ["", "tomorrow", "31.05.2026", "2026-02-30"])
def test_what_is_no_date_is_none(text: str) -> None:
    assert parse_deadline(text, None) is None


def test_a_zone_that_does_not_exist_is_refused() -> None:
    for name in ("Berlin", "../etc/passwd", ""):
        with pytest.raises(BadOption, match="no such time zone"):
            zone_named(name)


@pytest.mark.parametrize(
    "text",
    [
        "student,deadline\nada,2026-06-07T23:59\nbob,2026-06-08\n",
        "\ufeffStudent;Deadline\r\nada;2026-06-07T23:59\r\nbob;2026-06-08\r\n",
        "ada\t2026-06-07T23:59\n\nbob\t2026-06-08",
        "ada,2026-06-07T23:59,flu\nbob,2026-06-08,\nada,2026-06-07T23:59\n",
    ],
)
def test_extensions_are_read_in_each_form_of_a_spreadsheet(tmp_path: Path, text: str) -> None:
    path = tmp_path / "extensions.csv"
    path.write_text(text, encoding="utf-8", newline="")
    found = read_extensions(path, UTC)
    assert found == {
        "ada": datetime(2026, 6, 7, 23, 59, tzinfo=UTC),
        "bob": datetime(2026, 6, 8, 23, 59, 59, tzinfo=UTC),
    }


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "holds no line"),
        ("student,deadline\n", "holds no line"),
        ("ada\n", "line 1: a line is"),
        ("student,deadline\nada,soon\n", "line 2: 'soon' is no deadline"),
        ("ada,2026-06-07\nada,2026-06-08\n", "line 2: an earlier line gives ada another deadline"),
    ],
)
def test_extensions_that_cannot_be_used_are_refused_with_the_line(
    tmp_path: Path, text: str, words: str
) -> None:
    path = tmp_path / "extensions.csv"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(BadOption, match=words):
        read_extensions(path, UTC)


def test_names_that_look_alike_are_one_and_unknown_ones_are_told_with_the_nearest() -> None:
    composed, decomposed = "Zoë", "Zoe\u0308"
    assert same_name(composed) == same_name(decomposed)
    assert about_unknown([composed], [decomposed]) == ""
    assert about_unknown(["s1043"], ["s1042"]) == (
        "1 extension is for students who handed in nothing: s1043 (did you mean s1042?)"
    )


def hand_in(folder: Path, student: str, stamp: str | None) -> None:
    place = folder / student
    place.mkdir(parents=True, exist_ok=True)
    (place / "a.py").write_text("raise SystemExit(0)\n")
    if stamp is not None:
        (place / "timestamp.txt").write_text(stamp)


def scores(out: Path, exercise: str = STEM) -> dict[str, str]:
    with (out / "grades.csv").open(encoding="utf-8-sig", newline="") as file:
        return {row["student"]: row["score"] for row in csv.DictReader(file)}


def test_an_extension_and_a_corrected_time_count_without_judging_again(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """An answer with 0 points can't lose any, so a manual change first gives it some."""
    folder, out = tmp_path / "ans", tmp_path / "out"
    hand_in(folder, "late", "2026-06-02T10:00:00Z")
    hand_in(folder, "excused", "2026-06-02T10:00:00Z")
    hand_in(folder, "lost", "handed in at noon")
    hand_in(folder, "never", None)
    command = ["grade", str(folder), "--exercise", STEM, "--out", str(out), "--isolation", "limits"]
    assert main(command) == 0, capsys.readouterr()
    override = tmp_path / "override.csv"
    override.write_text(
        "".join(f"{name},{STEM},total,10,seen,me\n" for name in ("late", "excused", "lost", "never"))
    )
    extensions = tmp_path / "extensions.csv"
    extensions.write_text("excused,2026-06-03\nexcuse,2026-06-03\n")
    command += ["--deadline", "2026-05-31T23:59", "--timezone", "Europe/Berlin", "--late-per-day", "0.1"]
    assert main([*command, "--override", str(override)]) == 0, capsys.readouterr()
    told = capsys.readouterr().out
    assert scores(out) == {"late": "8", "excused": "8", "lost": "10", "never": "10"}
    assert "Deadline: 2026-05-31 23:59:00 (UTC+02:00), which is 2026-05-31 21:59:00 UTC." in told
    assert "cannot be read: 1 of 4 (lost)" in told
    assert "no timestamp.txt with a time: 1 of 4 (never)" in told

    hand_in(folder, "late", "2026-05-30T08:00:00Z")
    assert main([*command, "--extensions", str(extensions)]) == 0, capsys.readouterr()
    told = capsys.readouterr().out
    assert scores(out) == {"late": "10", "excused": "10", "lost": "10", "never": "10"}
    assert "0 judged in" in told
    assert "Deadline of excused: 2026-06-03 23:59:59" in told
    assert "excuse (did you mean excused?)" in told


@pytest.mark.parametrize(
    "option", [["--extensions", "e.csv"], ["--timezone", "UTC"], ["--late-per-day", "0.1"]]
)
def test_no_option_of_a_deadline_is_without_effect(
    option: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["grade", str(tmp_path), "--exercise", STEM, "--out", str(tmp_path / "out"), *option]) == 2
    assert f"{option[0]} needs --deadline" in capsys.readouterr().err

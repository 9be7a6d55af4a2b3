"""Predictions: chosen with a button or a letter, and revealed only after the run."""

import json
from collections.abc import Iterator
from pathlib import Path

import pytest
from IPython.core.formatters import DisplayFormatter

from workbook.lesson import activity, front_end, prediction_views, predictions
from workbook.lesson.prediction import Option, Prediction
from workbook.lesson.prediction_views import Noted, PredictionOutcome
from workbook.lesson.predictions import UNATTENDED, choose, predict, reveal
from workbook.lesson.progress import load_progress
from workbook.lesson.sealed_predictions import FOLDER, all_predictions, seal, unseal

STEM = "05_timers"
WHY = {"a": "Nothing waits for `spin`.", "b": "Each of them waits.", "c": "One is lost on the way."}
QUEUE = Prediction(
    "the-queue",
    (
        Option("a", "None arrives", WHY["a"], "arrived == 0"),
        Option("b", "Each `Float32` arrives", WHY["b"], "arrived == 5"),
        Option("c", "Four arrive", WHY["c"], "arrived == 4"),
    ),
    "b",
)
TASTE = Prediction("taste", (Option("a", "x", "y"), Option("b", "x", "y"), Option("c", "x", "y")), "c")


class Place:
    """The current output, and what has replaced it."""

    def __init__(self, what: object) -> None:
        self.shows = what

    def update(self, what: object) -> None:
        self.shows = what


class Screen:
    """All outputs that the cells have displayed, in order."""

    def __init__(self) -> None:
        self.places: list[Place] = []

    def display(self, what: object, display_id: bool = False, raw: bool = False) -> Place:
        self.places.append(Place(what))
        return self.places[-1]

    @property
    def last(self) -> object:
        return self.places[-1].shows


@pytest.fixture
def screen(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Screen]:
    """Provide a lesson in a kernel that has just started, with the two predictions above."""
    sealed = tmp_path / "sealed"
    sealed.mkdir()
    (sealed / f"{STEM}.txt").write_text(seal([QUEUE, TASTE]), encoding="utf-8")
    monkeypatch.setenv(FOLDER, str(sealed))
    monkeypatch.setenv("WORKBOOK_ANSWERS", str(tmp_path / "answers"))
    monkeypatch.setenv("JPY_SESSION_NAME", f"/home/ada/work/notebooks/{STEM}.ipynb")
    monkeypatch.delenv(UNATTENDED, raising=False)
    found = Screen()
    monkeypatch.setattr(prediction_views, "display", found.display)
    monkeypatch.setattr(activity, "_pace", activity.StudyPace())
    start_kernel(monkeypatch)
    yield found
    predictions._known.cache_clear()


def start_kernel(monkeypatch: pytest.MonkeyPatch) -> None:
    """Forget everything that only the process remembers."""
    monkeypatch.setattr(predictions, "_chosen", {})
    monkeypatch.setattr(predictions, "_closed", {})
    monkeypatch.setattr(predictions, "_waiting", {})
    predictions._known.cache_clear()


def spoils(text: str) -> bool:
    return (
        any(why.replace("`", "") in text.replace("`", "") for why in WHY.values()) or "outcome is b" in text
    )


def test_own_choice_outcome_and_reasons_of_all_options_are_shown(screen: Screen) -> None:
    predict("the-queue", "c")
    reveal("the-queue", arrived=5)
    shown = repr(screen.last)
    assert shown.splitlines() == [
        "You predicted c. The outcome is b.",
        "  ✗ a  None arrives",
        "       Nothing waits for spin.",
        "  ✓ b  Each Float32 arrives (what happened)",
        "       Each of them waits.",
        "  ✗ c  Four arrive (your prediction)",
        "       One is lost on the way.",
    ]
    assert isinstance(screen.last, PredictionOutcome)
    page = screen.last._repr_html_()
    assert "<code>Float32</code>" in page
    assert all(word in page for word in ("your prediction", "what happened", "✓ b", "✗ a"))


def test_a_right_prediction_is_said_to_be_one(screen: Screen) -> None:
    predict("the-queue", "b")
    reveal("the-queue", arrived=5)
    assert repr(screen.last).startswith("You predicted b. The outcome is b. Well done.")


def test_the_run_decides_and_says_when_it_came_out_otherwise(screen: Screen) -> None:
    predict("the-queue", "c")
    reveal("the-queue", arrived=4)
    said = repr(screen.last).splitlines()
    assert said[0] == (
        "You predicted c. This run had an unusual outcome: c. The usual outcome is b. Well done."
    )
    assert "  ✗ b  Each Float32 arrives (what usually happens)" in said
    assert "  ✓ c  Four arrive (your prediction) (what happened)" in said
    reveal("the-queue", arrived=3)
    assert "This run fits none of the options (arrived = 3). The usual outcome is b." in repr(screen.last)


def test_without_conditions_it_is_what_happens_as_a_rule(screen: Screen) -> None:
    predict("taste", "a")
    reveal("taste")
    assert repr(screen.last).startswith("You predicted a. The outcome is c.")


def test_nothing_is_revealed_before_the_choice_and_then_it_is(screen: Screen) -> None:
    reveal("the-queue", arrived=5)
    assert "Your prediction comes first" in repr(screen.last)
    assert not spoils(repr(screen.last))
    assert choose(QUEUE, "a").words == "Your prediction: a. The outcome is shown below the cell that you ran."
    assert repr(screen.last).startswith("You predicted a. The outcome is b.")
    assert choose(QUEUE, "b").letter == "a", "seen is seen"


@pytest.mark.parametrize("choice", ["b", "B", "b)", " b) Each arrives", "(b)", "**b**"])
def test_the_first_letter_of_a_choice_counts(
    screen: Screen, capsys: pytest.CaptureFixture[str], choice: str
) -> None:
    predict("the-queue", choice)
    assert capsys.readouterr().out == "Your prediction: b. You can change it until you see the outcome.\n"
    assert load_progress(STEM).predictions == {"the-queue": "b"}


@pytest.mark.parametrize("choice", ["z", "", "...", "7", "d"])
def test_an_unknown_choice_is_refused_and_the_one_before_stays(
    screen: Screen, capsys: pytest.CaptureFixture[str], choice: str
) -> None:
    predict("the-queue", "a")
    predict("the-queue", choice)
    assert capsys.readouterr().out.endswith("isn't one of the options. Choose a, b or c.\n")
    assert load_progress(STEM).predictions == {"the-queue": "a"}


def test_a_choice_may_be_changed_until_the_run_and_is_locked_after_it(
    screen: Screen, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    predict("the-queue", "a")
    predict("the-queue", "c")
    reveal("the-queue", arrived=5)
    predict("the-queue", "b")
    locked = "Your prediction was c. You've seen the outcome, so you can't change it anymore.\n"
    assert capsys.readouterr().out.endswith(locked)
    start_kernel(monkeypatch)
    predict("the-queue", "b")
    assert capsys.readouterr().out == locked
    reveal("the-queue", arrived=5)
    assert repr(screen.last).startswith("You predicted c.")
    progress = load_progress(STEM)
    assert (progress.predictions, progress.outcomes_seen) == ({"the-queue": "c"}, ["the-queue"])
    assert (progress.best, progress.tries) == (0.0, 0), "a prediction costs no points"


def test_a_button_for_each_option_chooses_it_and_says_so(screen: Screen) -> None:
    predict("the-queue")
    data = screen.last
    assert isinstance(data, dict)
    assert data["text/plain"] == 'Choose a, b or c, with a button or by hand: predict("the-queue", "…")'
    assert data[prediction_views.WIDGET]["model_id"]
    *buttons, status = prediction_views._buttons(QUEUE, data["text/plain"], None, choose).children
    assert [one.description for one in buttons] == [
        "○ a) None arrives",
        "○ b) Each Float32 arrives",
        "○ c) Four arrive",
    ]
    assert not spoils(status.value + "".join(one.description for one in buttons))
    buttons[2].click()
    assert [one.description[0] for one in buttons] == ["○", "○", "●"]
    assert 'role="status"' in status.value and "Your prediction: c." in status.value
    assert load_progress(STEM).predictions == {"the-queue": "c"}
    reveal("the-queue", arrived=5)
    buttons[1].click()
    assert [one.description[0] for one in buttons] == ["○", "○", "●"]
    assert "change it anymore" in status.value


def test_without_widgets_the_question_is_text(
    screen: Screen, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(__import__("sys").modules, "ipywidgets", None)
    predict("the-queue")
    assert capsys.readouterr().out.startswith("Choose a, b or c")
    assert screen.places == []


def test_when_notebooks_are_built_the_text_is_the_same_every_time_and_nothing_is_noted(
    screen: Screen, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    monkeypatch.setenv(UNATTENDED, "1")
    monkeypatch.setenv("JPY_SESSION_NAME", "")
    for _ in range(2):
        predict("the-queue")
        reveal("the-queue", arrived=5)
    first, second = (repr(place.shows) for place in screen.places)
    assert first == second
    assert first.startswith("The outcome is b.\n")
    assert capsys.readouterr().out.count("Choose a, b or c") == 2
    assert not (tmp_path / "answers").exists()


def test_a_name_that_there_is_not_is_said(screen: Screen, capsys: pytest.CaptureFixture[str]) -> None:
    predict("the-kew", "a")
    reveal("the-kew")
    assert capsys.readouterr().out == "There is no prediction called 'the-kew'.\n" * 2


def test_what_is_sealed_cannot_be_read_by_chance_and_damage_is_noticed(
    screen: Screen, tmp_path: Path
) -> None:
    text = seal([QUEUE, TASTE])
    assert unseal(text) == (QUEUE, TASTE)
    assert not spoils(text) and "arrived" not in text
    with pytest.raises(ValueError, match=r"."):
        unseal(text[:150])
    (tmp_path / "sealed" / "06_spinning.txt").write_text("cut off", encoding="utf-8")
    assert list(all_predictions()) == ["the-queue", "taste"]


def test_the_outcome_is_text_and_page_for_a_notebook() -> None:
    bundle, _ = DisplayFormatter().format(PredictionOutcome(QUEUE, "b", None, {}))
    assert {"text/plain", "text/html"} <= set(bundle)
    json.dumps(bundle)


def test_every_prediction_of_the_course_can_be_chosen_with_buttons() -> None:
    """The automatic runs of the lessons in JupyterLab never use the buttons."""
    asked = all_predictions()
    assert len(asked) > 10
    for prediction in asked.values():
        box = prediction_views._buttons(prediction, "Choose.", None, lambda _, letter: Noted(letter, "noted"))
        *buttons, status = box.children
        assert len(buttons) == len(prediction.options)
        buttons[-1].click()
        assert buttons[-1].description.startswith(f"● {prediction.options[-1].letter}) ")
        assert "noted" in status.value


class Shell:
    """JupyterLab with its buttons: the data sent with the running cell, and the contents of the reply."""

    def __init__(self, **prediction: str) -> None:
        self.prediction = prediction
        self.said: list[dict[str, object]] = []
        self.payload_manager = self

    def get_parent(self) -> dict[str, object]:
        return {"metadata": {"workbook": {"robot": True, "prediction": self.prediction}}}

    def write_payload(self, payload: dict[str, object], single: bool) -> None:
        assert payload.pop("source") == front_end.PREDICTION_PAYLOAD and not single
        self.said.append(payload)


def run_with_buttons(monkeypatch: pytest.MonkeyPatch, **prediction: str) -> Shell:
    shell = Shell(**prediction)
    monkeypatch.setattr(front_end, "get_ipython", lambda: shell)
    return shell


def test_where_the_front_end_draws_the_buttons_the_cell_shows_nothing(
    screen: Screen, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    shell = run_with_buttons(monkeypatch, name="the-queue")
    predict("the-queue")
    assert shell.said == [{"name": "the-queue", "choice": None, "words": "", "outcome": None}]
    assert screen.places == [] and capsys.readouterr().out == ""
    shell = run_with_buttons(monkeypatch, name="another")
    predict("the-queue")
    assert len(screen.places) == 1, "this cell has no buttons for it"


def test_a_click_is_noted_and_the_outcome_comes_with_the_run_and_no_earlier(
    screen: Screen, monkeypatch: pytest.MonkeyPatch
) -> None:
    shell = run_with_buttons(monkeypatch, name="the-queue", choice="c")
    predict("the-queue")
    words = "Your prediction: c. You can change it until you see the outcome."
    assert shell.said == [{"name": "the-queue", "choice": "c", "words": words, "outcome": None}]
    assert load_progress(STEM).predictions == {"the-queue": "c"}
    shell = run_with_buttons(monkeypatch)
    reveal("the-queue", arrived=4)
    assert shell.said == [
        {"name": "the-queue", "choice": "c", "words": "Your prediction: c.", "outcome": "c"}
    ], "what happened in this run, although it's unusual"
    shell = run_with_buttons(monkeypatch, name="the-queue", choice="a")
    predict("the-queue")
    assert (shell.said[0]["choice"], shell.said[0]["outcome"]) == ("c", "c")
    start_kernel(monkeypatch)
    predict("the-queue")
    assert (shell.said[1]["choice"], shell.said[1]["outcome"]) == ("c", "b")


def test_a_click_after_the_run_tells_the_outcome_right_away(
    screen: Screen, monkeypatch: pytest.MonkeyPatch
) -> None:
    shell = run_with_buttons(monkeypatch)
    reveal("the-queue", arrived=5)
    assert shell.said == []
    shell = run_with_buttons(monkeypatch, name="the-queue", choice="a")
    predict("the-queue")
    assert (shell.said[0]["choice"], shell.said[0]["outcome"]) == ("a", "b")


def test_a_click_is_no_cell_that_somebody_read(screen: Screen, monkeypatch: pytest.MonkeyPatch) -> None:
    class Result:
        class info:
            cell_id = "asks"

    run_with_buttons(monkeypatch, name="the-queue", choice="a")
    activity.note_cell(Result, sent=100.0)
    run_with_buttons(monkeypatch, name="the-queue")
    Result.info.cell_id = "next"
    activity.note_cell(Result, sent=101.0)
    assert load_progress(STEM).read == ["next"], "the click just before doesn't make it a Run All"


def test_the_reasons_of_options_that_matter_less_are_folded(screen: Screen) -> None:
    predict("the-queue", "c")
    reveal("the-queue", arrived=5)
    assert isinstance(screen.last, PredictionOutcome)
    page = screen.last._repr_html_()
    assert page.count("<details>") == 1
    assert (
        WHY["a"].replace("`spin`", "<code>spin</code>") in page.split("<details>")[1].split("</details>")[0]
    )
    assert "<details>" not in PredictionOutcome(QUEUE, "b", None, {})._repr_html_(), "nobody predicted"

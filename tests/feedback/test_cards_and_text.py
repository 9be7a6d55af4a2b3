"""Feedback as card and text: complete, safe in any notebook, readable in both themes, the same in every run."""

import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path

import pytest
from markupsafe import escape

from workbook.criteria.runner import CriterionResult
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import Judgement, judge_recording, judgement_as_provisional
from workbook.exercise.museum import Exhibit
from workbook.feedback.card import Card, Extras, as_html
from workbook.feedback.colors import COLORS, TEXT, TINTS
from workbook.feedback.markdown import as_markdown
from workbook.feedback.moment import Film, Moment
from workbook.feedback.review import review_prompt
from workbook.feedback.text import as_text
from workbook.feedback.wording import clock_line, first_to_mend, worst_first
from workbook.recording.recording import Recording
from workbook.templating import breakable

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
EVIL = "</pre><script>alert('owned')</script><img src=x onerror=alert(1)> & \"quoted\""


def judged(name: str) -> Judgement:
    recording = Recording.load(ROOT / "tests" / "recordings" / STEM / f"{name}.json")
    return judge_recording(load_exercise(STEM, ROOT), "0" * 64, recording)


def not_judged() -> Judgement:
    return Judgement(STEM, "0" * 64, "infra_error", "the slot ended with code -9", (), None)


def with_hidden() -> Judgement:
    judgement = judged("solution")
    first, *rest = judgement.criteria
    secret = replace(
        first, id="secret", title="Secret title", status="failed", saw="secret sight", hidden=True
    )
    return replace(judgement, criteria=(*rest, replace(secret, max_points=1.0)))


def in_part() -> Judgement:
    judgement = judged("solution")
    last = replace(
        judgement.criteria[-1],
        status="partial",
        points=0.5,
        saw="alive for a while",
        expected="alive",
        because="it tires",
        try_this="spin",
    )
    return replace(judgement, criteria=(*judgement.criteria[:-1], last))


def evil() -> Judgement:
    judgement = judged("eleven_values")
    assert judgement.recording is not None
    process = replace(judgement.recording.process, log=EVIL)
    criteria = tuple(
        replace(one, title=EVIL, saw=EVIL, expected=EVIL, because=EVIL, try_this=EVIL)
        for one in judgement.criteria
    )
    return replace(judgement, criteria=criteria, recording=replace(judgement.recording, process=process))


JUDGEMENTS = {
    "full marks": judged("solution"),
    "failed": judged("eleven_values"),
    "skipped": judged("wrong_name"),
    "starter": judged("starter"),
    "crashed": judged("raises_at_once"),
    "wall clock": judged("period_for_frequency"),
    "provisional": judgement_as_provisional(judged("period_for_frequency")),
    "in part": in_part(),
    "hidden": with_hidden(),
    "not judged": not_judged(),
    "evil": evil(),
}
every_judgement = pytest.mark.parametrize("judgement", JUDGEMENTS.values(), ids=JUDGEMENTS.keys())


class Reader(HTMLParser):
    """Parses a card as a browser does: its tags, their attributes, its text. A name that may wrap stays whole."""

    VOID = ("br", "img", "hr", "input", "wbr")

    def __init__(self, html: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.tags: set[str] = set()
        self.attributes: list[tuple[str, str]] = []
        self.texts: list[str] = []
        self.last = ""
        self.feed(html)
        self.close()
        assert not self.open, f"never closed: {self.open}"

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.add(tag)
        self.last = tag
        self.attributes += [(name, value or "") for name, value in attrs]
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag
        self.last = ""

    def handle_data(self, data: str) -> None:
        if self.last == "wbr":
            self.texts[-1] += data
        else:
            self.texts.append(data)

    @property
    def text(self) -> str:
        return " ".join(self.texts)


def card_of(judgement: Judgement) -> Card:
    return Card(judgement, Extras(file="answers/09_joint_positions.py", review="Please review", hints_left=2))


# --- the card -------------------------------------------------------------------------------------------


def test_long_names_wrap_only_after_a_slash_or_an_underscore() -> None:
    assert breakable("on /robot/joint_positions") == "on /robot/<wbr>joint_<wbr>positions"
    assert breakable("/robot/battery, __init__") == "/robot/battery, __init__", "short ones stay whole"
    assert breakable("'/robot/battery'.") == "&#39;/robot/battery&#39;.", "an escaped character counts once"
    assert breakable("a\0" * 10 + "/b_c") == breakable("a" * 10 + "/b_c"), "the mark can't be inserted"
    assert breakable("<i>/robot/joint_positions") == "&lt;i&gt;/robot/<wbr>joint_<wbr>positions"


@every_judgement
def test_a_card_is_whole_and_plain_html(judgement: Judgement) -> None:
    reader = Reader(card_of(judgement)._repr_html_())
    assert reader.tags <= set(
        "style div p b i table thead tbody tr th td progress details summary pre code small img br wbr".split()
    )
    assert not [
        name for name, _ in reader.attributes if name.startswith("on") or name in ("class", "id", "href")
    ]


@every_judgement
def test_a_card_takes_its_colors_from_the_palette_and_text_its_color_from_the_theme(
    judgement: Judgement,
) -> None:
    styles = [value for name, value in Reader(card_of(judgement)._repr_html_()).attributes if name == "style"]
    declared = [one.partition(":") for style in styles for one in style.split(";") if one]
    assert {value for name, _, value in declared if name == "color"} <= set(TEXT.values())
    assert {value for name, _, value in declared if name == "background-color"} <= set(TINTS.values())
    assert not [style for style in styles if re.search(r"background(?!-color)", style)]
    shapes = {color for style in styles for color in re.findall(r"#[0-9a-f]{3,8}\b", style)}
    assert shapes <= set(COLORS.values())


@every_judgement
def test_what_failed_stands_first_and_tinted_and_then_what_waits_for_it(judgement: Judgement) -> None:
    html = as_html(judgement)
    shown = [one.status for one in worst_first(judgement)]
    assert shown == sorted(shown, key=("failed partial skipped passed".split()).index) or "partial" in shown
    rows = re.findall(r"<tr>\s*<td.*?</tr>", html.partition("<thead>")[2], re.DOTALL)[: len(shown)]
    assert [any(tint in row for tint in TINTS.values()) for row in rows] == [
        status in ("failed", "partial") for status in shown
    ]
    first = first_to_mend(judgement)
    assert first is None or str(escape(first.title)) in rows[0].replace("<wbr>", "")


@pytest.mark.parametrize("has_rates", [True, False])
def test_the_key_of_a_timeline_names_what_is_in_the_picture(has_rates: bool) -> None:
    html = as_html(judged("period_for_frequency"), Extras(timeline=b"png", has_rates=has_rates))
    assert "received messages" in html
    assert ("when a message was due" in html) is has_rates


@every_judgement
def test_a_card_loads_nothing_from_anywhere(judgement: Judgement) -> None:
    html = as_html(judgement, Extras(timeline=b"png", timeline_text="arrivals"))
    assert not [
        value for name, value in Reader(html).attributes if name == "src" and not value.startswith("data:")
    ]
    assert "http" not in html.replace("http://www", "")
    assert "url(" not in html


def test_nothing_of_a_program_or_a_criterion_is_markup() -> None:
    extras = Extras(file=EVIL, review=EVIL, timeline=b"", timeline_text=EVIL, hints_left=1)
    for judgement in (
        evil(),
        replace(evil(), criteria=tuple(replace(c, status="passed") for c in evil().criteria)),
    ):
        html = as_html(judgement, extras)
        reader = Reader(html)
        assert "script" not in reader.tags
        assert EVIL in "".join(reader.texts)
        assert "<script" not in html
        assert "onerror" not in {name for name, _ in reader.attributes}
        assert {value for name, value in reader.attributes if name == "alt"} == {EVIL}
    broken = replace(not_judged(), reason=EVIL)
    assert "<script" not in as_html(broken)


def test_full_marks() -> None:
    reader = Reader(card_of(judged("solution"))._repr_html_())
    assert "✓ Full marks: 10 of 10 points." in reader.text
    assert "answers/09_joint_positions.py" in reader.text
    assert "Please review" in reader.text
    assert "Start with this criterion" not in reader.text
    assert "%hint" not in reader.text
    assert reader.text.count("✓ passes") == 8


def test_a_failed_card_says_what_to_mend_first_and_why() -> None:
    reader = Reader(card_of(judged("eleven_values"))._repr_html_())
    assert "Start with this criterion: Every message has exactly 12 values" in reader.text
    for words in (
        "every message has 11 values",
        "exactly 12 values",
        "Likely cause",
        "Try",
        "✗ not yet",
        "%hint",
    ):
        assert words in reader.text
    assert "Hand in" not in reader.text
    assert "Please review" not in reader.text
    no_hint = Reader(as_html(judged("eleven_values"), Extras(hints_left=0))).text
    assert "%hint" not in no_hint


def test_what_waits_says_so_instead_of_a_red_line() -> None:
    text = Reader(card_of(judged("wrong_name"))._repr_html_()).text
    assert text.count("– not judged") == text.count("because this has not passed yet") == 4
    assert text.count("✗ not yet") == 1
    assert "/robot/joint_angles" in text


def test_a_sign_and_a_word_stand_beside_each_color() -> None:
    words = {"passed": "✓ passes", "failed": "✗ not yet", "skipped": "– not judged", "partial": "◐ in part"}
    for judgement in (judged("wrong_name"), in_part()):
        text = Reader(as_html(judgement)).text
        for result in judgement.criteria:
            if result.max_points:
                assert words[result.status] in text


def test_a_provisional_card_says_that_it_is() -> None:
    html = as_html(JUDGEMENTS["provisional"])
    assert "Provisional" in html
    assert "wall clock decides" in html
    assert "Provisional" not in as_html(judged("period_for_frequency"))
    full = judgement_as_provisional(judged("solution"))
    assert "Hand in this file" not in card_of(full)._repr_html_()


def test_a_fault_of_ours_is_no_mark() -> None:
    html = as_html(not_judged())
    assert "Not judged: the slot ended with code -9" in html
    assert "of 10" not in html


def test_hidden_criteria_are_counted_and_not_shown() -> None:
    judgement = with_hidden()
    for text in (as_html(judgement), as_text(judgement), repr(Card(judgement))):
        assert "Secret" not in text
        assert "secret" not in text
    assert "one more criterion that this check does not show" in as_text(judgement)
    assert "one more criterion" in as_html(judgement)
    assert "more criteri" not in as_text(judged("solution"))


def test_a_program_that_never_ran_shows_neither_points_of_none_nor_seconds_of_none() -> None:
    judgement = judged("raises_at_once")
    for text in (Reader(as_html(judgement)).text, as_text(judgement), as_markdown(judgement)):
        assert not re.search(r"\b0( of |/)0\b|\b0(\.0)? (real )?s(econds)?\b", text)
        assert "ended before there was anything to watch" in text.replace("&#46;", ".")
    recording = judgement.recording
    assert recording is not None
    running = replace(recording, process=replace(recording.process, ended_by=None))
    assert clock_line(replace(judgement, recording=running)) == "There was nothing to watch."
    assert "needed" in Reader(as_html(judgement)).text
    assert "<progress" not in as_html(not_judged())


def test_a_card_of_a_gradebook_promises_no_other_try() -> None:
    doubtful = replace(judged("period_for_frequency"), inconclusive_reason="this machine was busy")
    assert "another try decides" in as_html(doubtful)
    assert "another try decides" not in as_html(doubtful, Extras(is_graded=True))
    assert "another try decides" not in as_markdown(doubtful)


def test_the_picture_has_a_text() -> None:
    attributes = Reader(
        as_html(judged("period_for_frequency"), Extras(timeline=b"\x89PNG", timeline_text="28 messages"))
    ).attributes
    assert ("alt", "28 messages") in attributes
    assert ("src", "data:image/png;base64,iVBORw==") in attributes


# --- the text -------------------------------------------------------------------------------------------


@every_judgement
def test_the_plain_text_of_a_card_is_the_same_in_every_run(judgement: Judgement) -> None:
    """nbval compares it, so it contains no times or measured numbers."""
    line = repr(Card(judgement))
    assert "\n" not in line
    recording = judgement.recording
    if recording is not None:
        slower = replace(recording, wall_s=99.0, process=replace(recording.process, watched_for=99.0))
        assert repr(Card(replace(judgement, recording=slower))) == line
    assert not re.search(r"\d+\.\d+ s\b", line)


def test_the_plain_text_of_some_cards() -> None:
    assert repr(Card(judged("solution"))) == "Full marks: 10 of 10 points."
    assert repr(Card(judged("eleven_values"))) == (
        "9 of 10 points. Start with this criterion: Every message has exactly 12 values."
    )
    assert repr(Card(not_judged())) == "Not judged: the slot ended with code -9"


@every_judgement
def test_a_terminal_gets_no_escapes_unless_it_wants_colors(judgement: Judgement) -> None:
    plain = as_text(judgement)
    assert "\x1b" not in plain
    assert re.sub(r"\x1b\[\d+m", "", as_text(judgement, color=True)) == plain


def test_the_text_shows_each_criterion_and_the_first_to_mend_in_full() -> None:
    text = as_text(judged("wrong_name"))
    assert text.startswith("09_joint_positions: 3 of 10 points.\n")
    for label in ("saw ", "expected ", "because ", "try "):
        assert len(re.findall(rf"^ +{label}", text, re.MULTILINE)) == 1, label
    assert "✗   0/2  /robot/joint_positions carries Float32MultiArray" in text
    assert "–   0/1  Every message has exactly 12 values" in text
    assert "✓   1/1  /robot/status is unchanged" in text
    assert max(map(len, text.splitlines())) <= 120


def test_the_text_ends_with_the_log_of_a_crash() -> None:
    text = as_text(judged("raises_at_once"))
    assert "line 8: NameError: name 'Float32MultiArray' is not defined" in text
    assert "Last lines of your program's log:" in text
    assert text.rstrip().endswith("NameError: name 'Float32MultiArray' is not defined")
    assert "Last lines" not in as_text(judged("wrong_name"))


def test_each_result_says_which_clock_was_used() -> None:
    assert "14 s of robot time" in as_text(judged("solution"))
    assert "s in real time" in as_text(judged("period_for_frequency"))
    lived = replace(judged("solution"), watched_real_life=True)
    assert "in real time" in as_text(lived)


def test_parts_of_points_are_shown() -> None:
    text = as_text(in_part())
    assert text.startswith("09_joint_positions: 9.5 of 10 points.")
    assert "◐ 0.5/1" in text


def test_a_condition_without_points_is_shown_only_when_it_fails() -> None:
    assert "Your program runs" not in as_text(judged("wrong_name"))
    assert "✗        Your program runs and its node is in the graph" in as_text(judged("raises_at_once"))


# --- the review -----------------------------------------------------------------------------------------


def test_the_review_prompt_holds_task_answer_and_what_was_seen() -> None:
    source = load_exercise(STEM, ROOT).source
    judgement = with_hidden()
    prompt = review_prompt(source, "print('my answer')\n\n", judgement)
    assert "print('my answer')\n```" in prompt
    assert "The joint positions" in prompt
    seen: list[CriterionResult] = [one for one in judgement.criteria if not one.hidden]
    assert all(one.saw in prompt for one in seen)
    assert "secret" not in prompt.lower()


@pytest.mark.parametrize("name", ["eleven_values", "period_for_frequency", "raises_at_once"])
def test_before_full_marks_the_prompt_asks_for_help_and_gives_nothing_away(name: str) -> None:
    source = load_exercise(STEM, ROOT).source
    judgement = judged(name)
    prompt = review_prompt(source, "print('my answer')\n", judgement)
    assert "do not write the program" in prompt and "already behaves as asked" not in prompt
    first = first_to_mend(judgement)
    assert first is not None and first.saw in prompt and first.expected in prompt
    assert first.because not in prompt and first.try_this not in prompt
    given = set(source.starter_code.splitlines()) | set("\n".join(source.story).splitlines())
    secret = [
        line for line in source.solution_code.splitlines() if len(line.strip()) > 3 and line not in given
    ]
    assert secret and not [line for line in secret if line.strip() in prompt]


def test_a_known_error_leads_to_the_museum_and_the_lesson() -> None:
    exhibit = Exhibit(
        "01_the_context", (21,), "init <twice>", "must only be called once", "init-twice", "x", "y"
    )
    judgement = judged("eleven_values")
    page = as_html(judgement, Extras(exhibit=exhibit))
    assert 'href="../notebooks/error_museum.md"' in page
    assert 'href="../notebooks/01_the_context.ipynb"' in page
    assert "init &lt;twice&gt;" in page
    assert "error_museum.md, lesson 01_the_context" in " ".join(as_text(judgement, exhibit=exhibit).split())


# --- the judged version, and the celebration of full marks ----------------------------------------------------------


def test_nothing_is_praised_that_is_not_on_the_screen() -> None:
    extras = Extras(file="answers/09.py", version_line="This card judges the version you ran at 14:03.")
    known = as_html(judged("solution"), extras)
    assert "version you ran at 14:03" in known
    assert "Full marks" in known and "Hand in this file" in known
    other = Card(judged("solution"), replace(extras, is_on_screen=False, review="Please review"))
    page = other._repr_html_()
    assert repr(other) == "10 of 10 points, for a version that is not on your screen."
    for praise in ("Full marks", "Hand in this file", "Please review", "✓ 10 of 10"):
        assert praise not in page
    assert "8 of 10 points." in as_html(judged("period_for_frequency"), replace(extras, is_on_screen=False))


def test_full_marks_are_a_moment() -> None:
    film = Film(b"film", b"still", "Your robot moves.")
    moment = Moment("You gained 10 points.", "10 · Slow <callbacks>", "../notebooks/10_slow.ipynb", film)
    page = as_html(judged("solution"), Extras(moment=moment))
    assert "You gained 10 points." in page
    link = re.search(r'<a href="../notebooks/10_slow.ipynb" [^>]*>(.*?)</a>', page)
    assert link and link[1] == "Next: 10 · Slow &lt;callbacks&gt; &rarr;"
    handing_in = as_html(judged("solution"), Extras(file="answers/09.py", moment=moment))
    assert handing_in.index("Hand in this file") < handing_in.index("Next: 10")
    assert 'alt="Your robot moves."' in page
    assert "data:image/webp;base64,ZmlsbQ==" in page
    assert "prefers-reduced-motion" in page
    without_film = as_html(judged("solution"), Extras(moment=replace(moment, film=None)))
    assert "You gained" in without_film and "image/webp" not in without_film
    assert "workbook-figure" not in page + without_film
    replaying = replace(moment, film=Film(b"", b"still", "Your robot."), replays=True)
    page = as_html(judged("solution"), Extras(moment=replaying))
    assert '<div class="workbook-figure"' in page and "data:image/png;base64,c3RpbGw=" in page
    assert "image/webp" not in page
    assert "You gained" not in as_html(judgement_as_provisional(judged("solution")), Extras(moment=moment))


def test_the_card_says_that_a_better_version_is_kept() -> None:
    page = as_html(judged("eleven_values"), Extras(better_line="Your best version is kept."))
    assert "Your best version is kept." in page and "<code>%restore 09</code>" in page
    assert "%restore" not in as_html(judged("eleven_values"))

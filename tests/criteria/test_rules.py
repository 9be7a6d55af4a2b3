"""A table of rules gives the first cause that fits, in the catalog's words. Invalid tables are refused on import."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest

from workbook.criteria.rules import CatalogError, Words, otherwise, placeholders
from workbook.criteria.verdict import Verdict, failed
from workbook.recording.recording import ProcessRecord, Recording

CATALOG = """
[texts]
each = "Judge each of the {sent} on its own."

[in-order]
saw = "{lost} of {sent} {lost|is|are} missing, the first at {at} s"
expected = "each one"

[in-order.late]
because = "The callback sleeps."
try = "{texts.each}"

[in-order.changed]
saw = "{others:n} other {others|value|values}: {others}"
because = "Something rounds {share:.1f} of them. A dict is {{}}."
try = "Publish them unchanged."

[in-order.by-error]

[error.init-twice]
because = "{what} was initialized twice."
try = "Do it once."
"""


@dataclass(frozen=True)
class Facts:
    lost: int = 1
    sent: int = 137_000
    at: float = 1e-7
    share: float = 0.25
    others: tuple[float, ...] = (137.0, 1e6, 0.1)


@pytest.fixture
def words(tmp_path: Path) -> Callable[[str], Words]:
    def written(catalog: str) -> Words:
        (tmp_path / "07_x.toml").write_text(catalog, encoding="utf-8")
        return Words(str(tmp_path / "07_x.py"))

    return written


def test_the_first_rule_that_fits_gives_the_cause_and_its_words(words: Callable[[str], Words]) -> None:
    table = words(CATALOG).rules(
        Facts,
        "in-order",
        ("late", lambda facts: facts.lost == 1),
        ("changed", otherwise),
        about_time=["late"],
    )
    late, changed = table.verdict(Facts()), table.verdict(Facts(lost=2))
    assert (late.cause, late.about_time, changed.cause, changed.about_time) == (
        "in-order.late",
        True,
        "in-order.changed",
        False,
    )
    assert late.saw == "1 of 137000 is missing, the first at 0.0000001 s"
    assert (late.expected, late.try_this) == ("each one", "Judge each of the 137000 on its own.")
    assert changed.saw == "3 other values: 137, 1000000 and 0.1"
    assert changed.because == "Something rounds 0.2 of them. A dict is {}."


def test_where_no_rule_fits_there_is_no_verdict(words: Callable[[str], Words]) -> None:
    table = words(CATALOG).rules(Facts, "in-order", ("late", lambda facts: facts.lost == 1))
    assert table.first(Facts(lost=2)) is None
    with pytest.raises(LookupError, match=r"no rule fits.*in-order\.late"):
        table.verdict(Facts(lost=2))


@dataclass(frozen=True)
class Recorded(Facts):
    """Facts that include their recording."""

    log: str = ""

    @property
    def recording(self) -> Recording:
        return Recording("simulated", 1, process=ProcessRecord(log=self.log))


def by_log(recording: Recording, saw: str, expected: str) -> Verdict | None:
    log = recording.process.log
    return failed("error.in-log", saw, expected, log, "Read it.") if log else None


def test_a_rule_may_leave_the_cause_to_the_vocabulary(words: Callable[[str], Words]) -> None:
    table = words(CATALOG).rules(
        Recorded, "in-order", ("late", lambda facts: facts.lost == 0), ("by-error", otherwise, by_log)
    )
    found = table.verdict(Recorded(at=2.0, log="It broke."))
    assert (found.cause, found.because) == ("error.in-log", "It broke.")
    assert (found.saw, found.expected) == ("1 of 137000 is missing, the first at 2 s", "each one")
    assert table.verdict(Recorded(lost=0, log="It broke.")).cause == "in-order.late"


def test_a_cause_counts_unless_the_vocabulary_finds_another(words: Callable[[str], Words]) -> None:
    table = words(CATALOG).rules(Recorded, "in-order", ("late", otherwise, by_log), about_time=True)
    own, found = table.verdict(Recorded()), table.verdict(Recorded(log="It broke."))
    assert (own.cause, own.about_time, found.cause) == ("in-order.late", True, "error.in-log")
    assert own.saw == found.saw


def test_where_the_vocabulary_finds_nothing_the_next_rule_is_tried(words: Callable[[str], Words]) -> None:
    table = words(CATALOG).rules(Recorded, "in-order", ("by-error", otherwise, by_log), ("late", otherwise))
    assert table.verdict(Recorded()).cause == "in-order.late"


def test_the_vocabulary_needs_a_recording(words: Callable[[str], Words]) -> None:
    with pytest.raises(CatalogError, match=r"in-order\.by-error: the facts have no recording"):
        words(CATALOG).rules(Facts, "in-order", ("by-error", otherwise, by_log))


def test_a_table_may_have_a_condition_of_its_own(words: Callable[[str], Words]) -> None:
    table = words(CATALOG).rules(Facts, "in-order", ("late", otherwise), when=lambda facts: facts.lost)
    assert table.first(Facts(lost=0)) is None
    assert table.verdict(Facts(lost=1)).cause == "in-order.late"


def test_a_share_makes_a_partial_verdict(words: Callable[[str], Words]) -> None:
    verdict = words(CATALOG).cause("in-order.late", Facts, share=0.5).verdict(Facts())
    assert (verdict.status, verdict.share) == ("partial", 0.5)


def test_keyword_arguments_fill_words_as_well_and_decide_about_time(words: Callable[[str], Words]) -> None:
    cause = words(CATALOG).cause("in-order.late", ("lost", "sent", "at"), about_time=True)
    verdict = cause.verdict(lost=3, sent=["a", "b"], at="7", about_time=False)
    assert (verdict.saw, verdict.about_time) == ("3 of a and b are missing, the first at 7 s", False)


def test_what_was_seen_goes_with_a_cause_that_the_vocabulary_finds(words: Callable[[str], Words]) -> None:
    saw, expected = words(CATALOG).seen("in-order.by-error", Facts)(Facts(at=2.0))
    assert (saw, expected) == ("1 of 137000 is missing, the first at 2 s", "each one")


def test_a_reason_goes_with_what_others_have_seen(words: Callable[[str], Words]) -> None:
    reason = words(CATALOG).reason("error.init-twice", ["what"])
    assert (reason.id, reason(what="ROS")) == (
        "error.init-twice",
        ("ROS was initialized twice.", "Do it once."),
    )
    with pytest.raises(CatalogError, match="nothing is called"):
        words(CATALOG).reason("error.init-twice")
    with pytest.raises(CatalogError, match="see expected and saw"):
        words(CATALOG).reason("in-order.late", Facts)


@pytest.mark.parametrize(
    ("cause", "given", "message"),
    [
        ("in-order.unknown", Facts, "in-order.unknown has no words"),
        ("elsewhere.late", Facts, "elsewhere.late has no words"),
        ("in-order.late", ("lost", "sent"), "late, saw: nothing is called {at} here"),
        ("in-order.by-error", Facts, "see because and try"),
    ],
)
def test_a_cause_that_does_not_fit_its_words_is_refused(
    words: Callable[[str], Words], cause: str, given: type | tuple[str, ...], message: str
) -> None:
    with pytest.raises(CatalogError, match=r"07_x\.toml") as error:
        words(CATALOG).cause(cause, given)
    assert message in str(error.value)


def test_a_part_that_nothing_shows_is_refused(words: Callable[[str], Words]) -> None:
    with pytest.raises(CatalogError, match="hint"):
        words(CATALOG + '\n[in-order.odd]\nhint = "x"\n').cause("in-order.odd", Facts)


@pytest.mark.parametrize(("lost", "told"), [(1, "once"), (2, "twice"), (3, "3 times"), (["a", "b"], "twice")])
def test_times_are_once_twice_or_a_number(
    lost: int | list[str], told: str, words: Callable[[str], Words]
) -> None:
    catalog = CATALOG.replace("{lost} of {sent} {lost|is|are} missing", "{lost:times} missing")
    cause = words(catalog).cause("in-order.late", ("lost", "sent", "at"))
    assert cause.verdict(lost=lost, sent=[], at="7").saw == f"{told} missing, the first at 7 s"


def test_a_constant_of_the_module_is_filled_in(tmp_path: Path) -> None:
    path = tmp_path / "07_x.toml"
    path.write_text(
        """
        [late.one]
        saw = "one after {lost} s"
        expected = "within {LIMIT_S} s, {SHARE:.0%} of them"
        because = "A dict is {{LIMIT_S}}."
        try = "Hurry."
        """,
        encoding="utf-8",
    )
    found = Words(str(path), {"LIMIT_S": 2.0, "SHARE": 0.8}).cause("late.one", Facts).verdict(Facts(lost=3))
    assert (found.saw, found.expected, found.because) == (
        "one after 3 s",
        "within 2 s, 80% of them",
        "A dict is {LIMIT_S}.",
    )
    with pytest.raises(CatalogError, match="no constant LIMIT_S"):
        Words(str(path)).cause("late.one", Facts)


def test_words_that_no_cause_uses_are_refused(words: Callable[[str], Words]) -> None:
    catalog = words(CATALOG)
    catalog.rules(Facts, "in-order", ("late", otherwise), ("changed", otherwise))
    with pytest.raises(CatalogError, match=r"error\.init-twice and in-order\.by-error"):
        catalog.refuse_leftovers()
    catalog.seen("in-order.by-error", Facts)
    catalog.reason("error.init-twice", ["what"])
    catalog.refuse_leftovers()


def test_facts_may_be_attributes_that_init_sets(words: Callable[[str], Words]) -> None:
    class Losses:
        def __init__(self, sent: int) -> None:
            self.sent = sent

    class Late(Losses):
        def __init__(self, lost: int, at: float) -> None:
            super().__init__(10)
            self.lost, self.at = lost, at

    verdict = words(CATALOG).cause("in-order.late", Late).verdict(Late(2, 0.5))
    assert verdict.saw == "2 of 10 are missing, the first at 0.5 s"
    with pytest.raises(CatalogError, match="nothing is called"):
        words(CATALOG).cause("in-order.late", Losses)


def test_placeholders_are_found_by_the_name_they_begin_with() -> None:
    assert placeholders("{a} {b.c} {d[0]!r} {e|is|are} {f:.1f} {{g}}") == {"a", "b", "d", "e", "f"}

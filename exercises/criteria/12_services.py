"""Judge exercise 12 by the program's calls, its reports on the responses, and its heartbeat in the meantime."""

import math
import random
import statistics
from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

from std_msgs.msg import String
from std_srvs.srv import Trigger

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, program_runs, topic, watching

WORDS = see.Words(__file__, globals())
SERVICE = "/robot/self_test"
HEALTH = topic("/robot/health", String)
HEARTBEAT = topic("/robot/heartbeat", String, hz=5.0)
RESULTS = {True: "ok", False: "faulty"}
NO_ANSWER = "no answer"
KNOWN = (*RESULTS.values(), NO_ANSWER)
AT_ONCE, SLOW, NEVER = 0.0, 0.7, None  # the delay of a call's response (s)
ALL_WELL = "all joints move"
FELT = {True: "warm", False: "stiff"}
JOINTS = ("left knee", "right knee", "left elbow", "right elbow", "left hip", "neck")
WATCH_S = 12.5


def drawn(rng: random.Random) -> list[see.Part]:
    """Draw the replies to twelve calls, in order. The last reply also applies to all later calls.

    The first three replies are "ok", either of the two results, and a slow "faulty", so that a result comes twice in a
    row. None of these three replies is immediate after a slow reply, or slow after a slow "faulty". After that, four
    calls get no response, two of them in a row. After each of the other two calls, the next response comes immediately,
    so that a report that waits for the earlier call is late twice. After the two calls in a row, the next response is
    slow, so that no response comes between the times at which the program gives up on these two calls.
    """
    after_three = [[NEVER, AT_ONCE], [NEVER, AT_ONCE, SLOW], [NEVER, NEVER, SLOW]]
    rng.shuffle(after_three)
    delay, success = rng.choice(((AT_ONCE, True), (AT_ONCE, False), (SLOW, True)))
    delays = [AT_ONCE, delay, SLOW, *(one for some in after_three for one in some), AT_ONCE]
    successes = [True, success, False, *(rng.random() < 0.5 for _ in delays[3:-1]), False]
    at_once = [place for place, one in enumerate(delays[:-1]) if one == AT_ONCE and place > 2]
    successes[rng.choice(at_once)] = False
    plain = [False, True, False, *(rng.random() < 0.5 for _ in delays[3:])]
    # The string is meant for people. Only a plain string agrees with the result.
    texts = [
        ALL_WELL if success is is_plain else f"the {rng.choice(JOINTS)} is {FELT[success]}"
        for success, is_plain in zip(successes, plain, strict=True)
    ]
    answers = [{"success": success, "message": text} for success, text in zip(successes, texts, strict=True)]
    return [see.serves(SERVICE, Trigger, [*zip(answers, delays, strict=True)])]


WATCH = watching(wall_seconds=WATCH_S, script=drawn)

LEAST_CALLS = 4  # the fourth call is the first one that may get no response
SHORTEST_PERIOD_S, LONGEST_PERIOD_S = 0.9, 1.1
LONGEST_PAUSE_S = 2.5  # after a call without a response
PAUSE_S, PAUSES = 1.4, 1  # after other calls: the longest usual pause, and how many longer ones we accept
TOLD_WITHIN_S, BELONGS_S = 0.8, 1.6  # a later report counts as the report of another response
LATER_ONCE_S = BELONGS_S - TOLD_WITHIN_S
MAY_TAKE_S, GIVEN_UP_WITHIN_S = 0.8, 2.0
MAY_COME_UNTIL_S = MAY_TAKE_S + 0.05
GIVEN_UP_AT_ONCE_S = 1.3  # with the next request, or shortly after it
SLACK_S = 0.1  # for a busy machine
NEARLY_S = 0.03  # the same if the program gives up on each call too early
LONG_SLACK_S = 0.3  # the same if a period and a time limit add up
SOONEST_S, LATEST_S = MAY_TAKE_S - SLACK_S, GIVEN_UP_WITHIN_S + LONG_SLACK_S  # for giving up
LATE_ONES = 2  # the number of calls given up equally late that show a pattern
MOST, A_LOT = 2000, 200  # the most calls and reports that are judged, and that are compared one by one
MOSTLY = 0.7
AT_ONCE_S = 0.05  # a call that follows another call or response so soon came along with it, or because of it
WAITED_IN_VAIN_S = 0.3  # so long after the response, a callback that still waits for the result waits in vain
LEAST_SHARE, MOST_SHARE, LEAST_MEANWHILE = 0.9, 1.1, 0.6  # of the heartbeats due: in all, and during calls
LEAST_DUE = 1.0  # fewer due heartbeats don't show anything
SHORTEST_BEAT_S, LONGEST_BEAT_S, STOPPED_S, EDGE_S = 0.18, 0.22, 0.9, 0.05
FEW_CALLS = 2  # fewer calls after the last heartbeat don't show that the rest of the program goes on
EARLY_S = 0.1  # a message from before the watch waited until it began, for an unknown time
FIRST_SECONDS_S = 2.5  # until then, the program may give up on a call from before the watch


class Report(NamedTuple):
    """A word on /robot/health, and its arrival time (s)."""

    t: float
    word: str


def within(reports: Sequence[Report], low: float, high: float) -> Sequence[Report]:
    """Return the reports from `low` to `high` (s). The reports must be sorted."""
    first = bisect_left(reports, low, key=lambda report: report.t)
    return reports[first : bisect_right(reports, high, key=lambda report: report.t)]


def grouped(times: Sequence[float]) -> list[tuple[int, float]]:
    """Group sorted times (s) that follow each other immediately. Return each group's size and first time."""
    starts = [n for n, t in enumerate(times) if n == 0 or t - times[n - 1] >= AT_ONCE_S]
    return [(end - start, times[start]) for start, end in pairwise([*starts, len(times)])]


class Call:
    """One call by the program. Times are in s. `at`: the time of the response, or infinity if there was none."""

    def __init__(self, seen: see.CallSeen, next_t: float, end: float) -> None:
        self.t, self.next_t, self.pause_s = seen.t, next_t, next_t - seen.t
        self.at = math.inf if seen.answered_t is None else seen.answered_t
        self.took_s = self.at - self.t
        self.was_slow = SLOW / 2 < self.took_s < math.inf
        self.success = bool(seen.response and seen.response["success"])
        self.word = RESULTS[self.success]
        self.text = str((seen.response or {}).get("message", ""))
        self.word_of_text = RESULTS[self.text == ALL_WELL]
        last = end - TOLD_WITHIN_S - LONG_SLACK_S  # a report may be missing at the edges of the watch
        self.may_be_missing = self.t < EARLY_S or self.took_s > MAY_COME_UNTIL_S or self.at > last
        self.near: Sequence[Report] = ()  # the reported results that may belong to its response
        self.gave_up: Sequence[Report] = ()  # each "no answer" that came in spite of a response

    @property
    def own(self) -> list[Report]:
        return [report for report in self.near if report.word == self.word]

    def about_it(self, reports: Sequence[Report]) -> Sequence[Report]:
        """Return the reports that may be about this call if it didn't get a response."""
        return within(reports, self.t + SOONEST_S, self.t + LATEST_S)


class Run:
    """The program's calls and reports. The attributes are the facts for the feedback."""

    def __init__(self, recording: Recording) -> None:
        self.recording, self.end = recording, recording.watched_s
        seen = [one for one in see.calls_of(recording, SERVICE) if one.by == "program"][:MOST]
        next_ts = [*(one.t for one in seen[1:]), self.end]
        self.calls = [Call(one, t, self.end) for one, t in zip(seen, next_ts, strict=False)]
        self.how_many = "only one call" if len(self.calls) == 1 else f"{len(self.calls)} calls"
        self.last = self.calls[-1:]
        self.unanswered = [call for call in self.calls if call.at == math.inf]
        self.responses = sorted((one for one in self.calls if one.at < math.inf), key=lambda one: one.at)
        arrivals = sorted(recording.topic(HEALTH.name).arrivals, key=lambda arrival: arrival.t)
        self.reports = [
            Report(one.t, word) for one in arrivals for word in KNOWN if one.value == {"data": word}
        ]
        self.results = [report for report in self.reports if report.word != NO_ANSWER][:MOST]
        self.no_answers = [report for report in self.reports if report.word == NO_ANSWER][:MOST]

        self.ignored, left = list[Call](), self.no_answers.copy()
        may_come_later = [call for call in self.unanswered if call.t >= self.end - LATEST_S]
        for call in self.unanswered[: len(self.unanswered) - len(may_come_later)]:
            own = call.about_it(left)
            if own:
                left.remove(own[0])
            else:
                self.ignored.append(call)
        self.given_up = [call for call in self.unanswered if call not in self.ignored]
        until = min((call.t + SOONEST_S for call in may_come_later), default=math.inf)
        self.stray = [report for report in left if report.t < until]
        for call in self.responses:
            call.near = within(self.results, call.at - EARLY_S, call.at + TOLD_WITHIN_S + SLACK_S)
            call.gave_up = within(self.stray, call.t, call.t + LATEST_S)

    def is_excused(self, call: Call) -> bool:
        """Return whether the program gave up on a slow response when that was almost allowed.

        On a very busy machine, even a correct program may give up then.
        """
        given_up = within(self.stray, call.t + SOONEST_S, call.t + GIVEN_UP_AT_ONCE_S)
        return call.was_slow and bool(given_up) and not call.own

    def paired(self, edge_s: float = 0.0) -> list[tuple[Call, Report]] | None:
        """Pair responses and reports.

        Return None if that's impossible. Responses in the last `edge_s` s may lack a report.
        """
        last = self.end - TOLD_WITHIN_S - LONG_SLACK_S
        return see.pair_in_order(
            self.responses,
            self.results,
            belongs=lambda call, one: one.word == call.word and -EARLY_S <= one.t - call.at <= BELONGS_S,
            may_be_missing=lambda call: call.may_be_missing or call.at > self.end - edge_s,
            may_be_extra=lambda one: not EARLY_S <= one.t <= last,
            excusable=self.is_excused,
        )


class Ending(Run):
    """The last call, and all events from then to the end of the watch."""

    def __init__(self, recording: Recording) -> None:
        super().__init__(recording)
        self.verdict = see.alive_at_end(recording)
        self.longest_open_s = max((self.end - call.t for call in self.unanswered), default=0.0)
        self.since_response_s = max((self.end - call.at for call in self.last), default=0.0)
        self.reported = any(report.t >= call.at for call in self.last for report in self.reports)
        ends = [topic.arrivals[-1].t for topic in recording.with_publishers() if topic.arrivals]
        self.is_alive = max(ends, default=0.0) > self.end - 1.0  # a message came in the last second


class Pauses(Run):
    """The pauses between the calls. The call before a pause represents that pause."""

    def __init__(self, recording: Recording) -> None:
        super().__init__(recording)
        self.timed = calls = [call for call in self.calls if call.t >= EARLY_S] or self.calls
        self.longest = max(calls, key=lambda call: call.pause_s)
        self.lasts = self.longest.next_t >= self.end - EDGE_S
        self.gave_up = within(self.no_answers, self.longest.t - EARLY_S, self.longest.t + 1.0)
        self.long = [c for c in calls if c.pause_s > (PAUSE_S if c.at < math.inf else LONGEST_PAUSE_S)]
        between = calls[:-1] or calls
        self.shortest = min(between, key=lambda call: call.pause_s)
        self.shortest_ms = 1000.0 * self.shortest.pause_s
        self.typical_s = statistics.median(call.pause_s for call in between)
        self.pace = f"typically {self.typical_s:.2g} s from one call to the next"
        if self.typical_s <= LONGEST_PERIOD_S and self.long:
            self.pace = f"{len(self.long)} pauses of {min(c.pause_s for c in self.long):.1f} s or longer"
        sizes = [size for size, _ in grouped([call.t for call in calls])]
        size = statistics.mode(sizes)
        self.together = size if sizes.count(size) > MOSTLY * len(sizes) else 1
        self.short = [call for call in between if call.pause_s < SHORTEST_PERIOD_S]
        self.after_responses = sum(0.0 <= call.next_t - call.at < AT_ONCE_S for call in self.short)
        alike = [call for call in between if abs(call.pause_s - self.typical_s) < 0.1 * self.typical_s]
        self.is_even = len(alike) > MOSTLY * len(between)
        self.is_paused = self.longest.pause_s > LONGEST_PAUSE_S
        self.is_often = self.typical_s < SHORTEST_PERIOD_S
        self.is_seldom = not self.is_often and (self.typical_s > LONGEST_PERIOD_S or len(self.long) > PAUSES)
        self.has_extra = len(calls) - 1 > round((calls[-1].t - calls[0].t) / SHORTEST_PERIOD_S)


class Heart(Run):
    """The heartbeat, over the whole watch and while calls wait for a response."""

    def __init__(self, recording: Recording) -> None:
        super().__init__(recording)
        self.beats = beats = see.beats(recording, HEARTBEAT)
        every = f"typically a beat every {beats.typical_s:.2g} s"
        self.period = "only one beat" if beats.count == 1 else every
        self.has_stopped = self.end - beats.last_s > max(STOPPED_S, 1.5 * beats.typical_s)
        self.later_calls = sum(call.t > beats.last_s + EDGE_S for call in self.calls)
        spans = [
            (call.t + EDGE_S, (call.at if call.at < math.inf else call.t + MAY_COME_UNTIL_S) - EDGE_S)
            for call in self.calls
            if EARLY_S <= call.t < self.end - 1.0 and call.took_s > SLOW / 2
        ]
        counts, self.due = beats.within(spans), beats.due_within(spans)
        self.came, begins = sum(counts), [begin for begin, _ in spans]
        silent = [begin for begin, count in zip(begins, counts, strict=True) if not count]
        self.silent_call_s = [*silent, *begins, 0.0][0] - EDGE_S
        self.stops_meanwhile = self.due > LEAST_DUE and self.came < LEAST_MEANWHILE * self.due


class Results(Run):
    """The responses, and the reports on them. If there are very many, only the first ones are compared one by one."""

    def __init__(self, recording: Recording) -> None:
        super().__init__(recording)
        self.pairs = self.paired()
        self.told = (self.paired(BELONGS_S + EDGE_S) if self.pairs is None else self.pairs) or []
        delays = [(call, report.t - call.at) for call, report in self.told]
        self.late = [(call, delay) for call, delay in delays if delay > TOLD_WITHIN_S + SLACK_S]

        responses, results = self.responses[:A_LOT], self.results[:A_LOT]
        self.expected = [call for call in responses if not call.may_be_missing]
        self.missing = [call for call in self.expected if not call.own]
        self.are_slow = [call.was_slow for call in self.missing]

        self.together = [(size, t) for size, t in grouped([report.t for report in results]) if size > 1]
        most = 2 * sum(size for size, _ in self.together) >= len(results) <= len(responses)
        one_by_one = len(grouped([call.at for call in responses])) == len(responses)
        self.collected = len(self.together) > 1 and most and one_by_one
        last = max(results, default=Report(math.inf, ""))
        self.stops = [last for call in self.missing[:1] if last.t < call.at and not call.gave_up]

        untold = [call for call in responses if not call.own]  # a "no answer" may be about another such call
        self.early = [
            (call, one.t - call.t)
            for call in self.expected
            for one in within(self.stray, call.t, call.at)
            if not any(other.about_it([one]) for other in untold if other is not call)
        ]

        # the same result twice in a row
        same = [(last, call) for last, call in pairwise(responses) if last.word == call.word]
        self.repeated = [(last, call) for last, call in same if call in self.missing and not call.gave_up]
        in_a_row = [(a, b) for a, b in same if not any(a.t < call.t < b.t for call in self.unanswered)]
        self.changes_only = 0 < len(self.repeated) == len(self.missing) and not (
            any(call.near for call in self.missing) or any(call.own for _, call in in_a_row)
        )

        # the first response after a "no answer"
        befores = [0.0, *(call.at for call in responses)]
        first = [c for t, c in zip(befores, responses, strict=False) if within(self.no_answers, t, c.at)]
        skipped = [call for call in first if not call.may_be_missing]
        gave_up = any(call.gave_up for call in skipped)
        self.skips_first = self.missing == skipped and len(self.missing) > 1 and not gave_up

        # each response uses up one report that states its result
        self.belonging = {report for call in responses for report in call.own}
        left, all_told = list(results), True
        for call in responses:
            own = [report for report in call.own if report in left]
            all_told = all_told and bool(own or call.may_be_missing)
            if own:
                left.remove(own[0])
        self.extra = left if all_told else []
        instead = [(call, one) for call in self.unanswered for one in call.about_it(left)]
        self.instead = [] if self.no_answers or len(left) > len(self.unanswered) else instead

        # the first result near each response
        self.nearest = [call.near[0].word for call in self.expected if call.near]
        all_near = len(self.nearest) == len(self.expected)
        self.wrong = [call for call in self.expected if all_near and call.near[0].word != call.word]
        # both words must be wrong somewhere, because one alone may fit the strings by chance
        two_ways = len({call.near[0].word for call in self.wrong}) == 2
        self.follows_text = two_ways and all(c.near[0].word == c.word_of_text for c in self.expected)
        since_wrong = [self.nearest[self.nearest.index(call.near[0].word) :] for call in self.wrong[:1]]
        self.stays = any(len(set(words)) == 1 for words in since_wrong)

    def late_at(self, moments: Sequence[float], within_s: float) -> bool:
        """Return whether each late report came within `within_s` s of one of the times `moments` (s)."""
        return all(any(abs(call.at + delay - t) <= within_s for t in moments) for call, delay in self.late)

    @property
    def published(self) -> str:
        """A clause that states whether "no answer" was published in place of the first missing response's word."""
        call = self.missing[0]
        return f'your node published "{NO_ANSWER}"' if call.gave_up else f'"{call.word}" was not published'

    @property
    def left_out(self) -> bool:
        """Whether the first missing report is the only one of its kind (on a slow or a fast response).

        If that response was slow, no other report at all may be missing, and another slow response must be reported. If
        it was fast, reports on slow responses may be missing, too.
        """
        told = any(call.was_slow and call.own for call in self.expected)
        return told and len(self.missing) == 1 if self.are_slow[0] else all(self.are_slow[1:])


class GivenUp(Run):
    """The calls without a response, and the time at which the program gave up on each."""

    def __init__(self, recording: Recording) -> None:
        super().__init__(recording)
        self.first = first = [*self.ignored, *self.calls][0]
        self.previous = self.calls[max(self.calls.index(first) - 1, 0)]
        self.after_s = min((one.t - first.t for one in self.stray if one.t > first.t), default=math.inf)
        times = [one.t for one in self.no_answers if one.t > FIRST_SECONDS_S]
        late = [t - call.t for call, t in zip(self.unanswered, times, strict=False)]
        alike = len(late) >= LATE_ONES and max(late) - min(late) <= LONG_SLACK_S
        self.each_late_s = min(late) if alike else 0.0
        told = [(call, call.about_it(self.no_answers)) for call in self.unanswered]
        self.waits = [reports[0].t - call.t for call, reports in told if reports]
        self.longest_wait_s = max(self.waits, default=0.0)
        patience = min(self.waits, default=0.0)
        was_kept = any(self.answered_meanwhile(call, patience) for call in self.given_up)
        forgotten = self.answered_meanwhile(first, patience - SLACK_S) if self.given_up else []
        self.forgotten = [] if was_kept else forgotten
        alarms = [one for one in self.stray if one.t > FIRST_SECONDS_S]
        excused = len(alarms) == 1 and any(map(self.is_excused, self.responses))
        self.alarms = [] if excused else alarms
        self.open_then = [call for one in self.alarms for call in self.responses if call.t < one.t < call.at]
        self.alarm_s = [one.t - call.t for call in self.open_then[:1] for one in self.alarms[:1]]

    def answered_meanwhile(self, call: Call, within_s: float) -> list[float]:
        """Return the times (s) of the responses to other calls, within `within_s` s after this call."""
        return [one.at for one in self.responses if call.t < one.at < call.t + within_s]


WHY_NONE = WORDS.rules(
    Ending,
    "alive-at-end",
    ("result-of-none", lambda f: f.longest_open_s > MAY_TAKE_S),
    ("waited-in-vain", lambda f: f.since_response_s > WAITED_IN_VAIN_S),
    ("result-too-early", see.otherwise),
)
FEW = WORDS.rules(
    Ending,
    "calls-arrive",
    ("ended", lambda f: f.recording.process.ended_by == "itself"),
    ("few", see.otherwise, see.failed_by_error),
    ("too-few", lambda f: f.last[0].at == math.inf or f.last[0].pause_s <= LONGEST_PAUSE_S),
    ("stops", lambda f: f.reported and f.is_alive and len(f.calls) > 1),
    ("asks-no-more", lambda f: f.is_alive),
    ("lost-its-executor", lambda f: f.reported),
    ("deadlock", see.otherwise),
    about_time=["too-few"],
)
WHY_SELDOM = WORDS.rules(
    Pauses,
    "asks-every-second",
    ("long-pause", lambda f: f.is_paused, see.failed_by_error),
    ("stops-at-a-later-one", lambda f: f.is_paused and f.longest in f.unanswered[1:] and f.lasts),
    ("waits-for-unanswered", lambda f: f.is_paused and f.longest in f.unanswered),
    ("stops-after-no-answer", lambda f: f.is_paused and f.gave_up),
    ("stops", lambda f: f.is_paused and f.lasts),
    ("pause", lambda f: f.is_paused),
    ("waits-in-callback", lambda f: f.is_seldom and Heart(f.recording).stops_meanwhile),
    ("waits-for-answer", lambda f: f.is_seldom and f.long and all(call.was_slow for call in f.long)),
    ("too-seldom", lambda f: f.is_seldom),
    about_time=True,
)
WHY_OFTEN = WORDS.rules(
    Pauses,
    "asks-every-second",
    ("several-at-once", lambda f: f.is_often and f.together > 1),
    ("asks-after-an-answer", lambda f: f.is_often and f.after_responses > MOSTLY * len(f.short)),
    ("short-period", lambda f: f.is_often and f.is_even and f.typical_s > 1.5 * HEARTBEAT.period),
    ("too-often", lambda f: f.is_often),
    ("calls-between", lambda f: f.has_extra),
)
WHY_LATE = WORDS.rules(
    Results,
    "results-told",
    ("waits-for-earlier-call", lambda f: f.late_at([one.t for one in f.no_answers], EARLY_S)),
    ("delayed", lambda f: not f.late_at([call.t for call in f.calls], SLACK_S)),
    ("late", see.otherwise),
    when=lambda f: len(f.late) > 1,
    about_time=True,
)
TOO_MANY = ("more-than-once", lambda f: len(f.results) > len(f.responses) + 1)
WHY_MANY = WORDS.rules(
    Results,
    "results-told",
    TOO_MANY,
    ("other-order", see.otherwise),
    when=lambda f: max(len(f.calls), len(f.results)) > A_LOT,
)
WHY_WRONG = WORDS.rules(
    Results,
    "results-told",
    ("collected", lambda f: f.collected),
    ("given-up-early", lambda f: f.early),
    ("last", lambda f: f.stops, see.failed_by_error),
    ("stops", lambda f: f.stops),
    ("changes-only", lambda f: f.changes_only),
    ("none-after-no-answer", lambda f: f.skips_first),
    ("no-answer-came", lambda f: f.instead),
    ("without-an-answer", lambda f: f.extra and f.belonging.isdisjoint(f.extra)),
    ("one-twice", lambda f: len(f.extra) == 1),
    TOO_MANY,
    ("inverted", lambda f: len(set(f.nearest)) == 2 and len(f.wrong) == len(f.nearest)),
    ("always-faulty", lambda f: f.wrong and set(f.nearest) == {RESULTS[False]}),
    ("always-the-same", lambda f: f.wrong and len(set(f.nearest)) == 1),
    ("follows-the-text", lambda f: f.follows_text),
    ("stays", lambda f: f.stays),
    ("other-order", lambda f: not f.missing),
    ("other-result", lambda f: f.missing[0].near),
    ("one-left-out", lambda f: f.left_out and not f.missing[0].gave_up),
    ("not-told", see.otherwise, see.failed_by_error),
    ("waits-in-callback", lambda f: Heart(f.recording).stops_meanwhile),
    ("slow-dropped", lambda f: f.are_slow[0] and (all(f.are_slow) or not f.missing[0].gave_up)),
    ("not-taken-in", see.otherwise),
    about_time=["collected", "given-up-early", "waits-in-callback", "slow-dropped", "not-taken-in"],
)
WHY_IGNORED = WORDS.rules(
    GivenUp,
    "unanswered-told",
    ("early", lambda f: f.after_s < SOONEST_S),
    ("always-late", lambda f: f.each_late_s > GIVEN_UP_WITHIN_S),
    ("late", lambda f: f.after_s < 2 * GIVEN_UP_WITHIN_S),
    ("once-in-a-row", lambda f: f.previous in f.given_up and len(f.given_up) > 1),
    ("forgotten", lambda f: f.forgotten),
    ("first-only", lambda f: f.unanswered[0] in f.given_up),
    ("never", see.otherwise),
    when=lambda f: f.ignored,
    about_time=["always-late", "late"],
)
FALSE_ALARM = WORDS.rules(
    GivenUp,
    "unanswered-told",
    ("always-early", lambda f: len(f.waits) > 1 and f.longest_wait_s < MAY_TAKE_S - NEARLY_S),
    ("still-open", lambda f: 0 < len(f.alarms) <= len(f.open_then)),
    ("twice", lambda f: any(call.t < one.t for call in f.given_up for one in f.alarms[:1])),
    ("besides-the-answer", lambda f: f.alarms and f.paired() is not None),
    ("was-answered", lambda f: f.alarms),
    about_time=["always-early", "still-open", "besides-the-answer", "was-answered"],
)
WHY_UNSTEADY = WORDS.rules(
    Heart,
    "heartbeat-steady",
    ("in-bursts", lambda f: f.beats.burst > 1),
    ("last", lambda f: f.has_stopped, see.failed_by_error),
    ("stops", lambda f: f.has_stopped and f.later_calls < FEW_CALLS),
    ("stops-alone", lambda f: f.has_stopped),
    ("stops-during-a-call", lambda f: f.stops_meanwhile),
    ("other-period", lambda f: not SHORTEST_BEAT_S <= f.beats.typical_s <= LONGEST_BEAT_S),
    ("too-many", lambda f: f.beats.share > MOST_SHARE),
    ("too-few", lambda f: f.beats.share < LEAST_SHARE),
    about_time=["stops", "stops-during-a-call", "other-period", "too-few"],
)


@criterion(points=1, title="The program is still running at the end", needs=[program_runs])
def alive_at_end(recording: Recording) -> Verdict:
    verdict = see.alive_at_end(recording)
    reads_none = "'NoneType' object has no attribute 'success'" in verdict.saw
    return WHY_NONE.verdict(Ending(recording)) if reads_none else verdict


@criterion(points=1, title="/robot/self_test is called again and again", needs=[program_runs])
def calls_arrive(recording: Recording) -> Verdict:
    first = see.calls_service(recording, SERVICE, "std_srvs/srv/Trigger")
    if not first.ok:
        return first
    facts = Ending(recording)
    if len(facts.calls) >= LEAST_CALLS:
        return see.passed(facts.how_many)
    return FEW.verdict(facts)


@criterion(
    points=1,
    title="It calls once a second, and continues after a call without a response",
    needs=[calls_arrive, alive_at_end],
)
def asks_every_second(recording: Recording) -> Verdict:
    facts = Pauses(recording)
    well = see.passed(f"{len(facts.timed)} calls, typically {facts.typical_s:.1f} s apart")
    return WHY_SELDOM.first(facts) or WHY_OFTEN.first(facts) or well


@criterion(points=1, title="/robot/health carries String, and only the three words", needs=[program_runs])
def health_topic(recording: Recording) -> Verdict:
    exists = see.publishes(recording, HEALTH)
    if not exists.ok or not recording.topic(HEALTH.name).arrivals:
        return exists
    return see.one_of(recording, HEALTH, set(KNOWN))


@criterion(
    points=2,
    title="Each response is reported correctly, on time, and only once",
    needs=[calls_arrive, health_topic],
)
def results_told(recording: Recording) -> Verdict:
    facts = Results(recording)
    if facts.pairs is not None and len(facts.late) <= 1:
        return see.passed(f"{len(facts.told)} responses reported")
    return WHY_LATE.first(facts) or WHY_MANY.first(facts) or WHY_WRONG.verdict(facts)


@criterion(
    points=2,
    title='"no answer" is reported on time, and only for calls that got no response',
    needs=[calls_arrive, health_topic, alive_at_end],
)
def unanswered_told(recording: Recording) -> Verdict:
    facts = GivenUp(recording)
    well = see.passed(f'"{NO_ANSWER}" for each call without a response, and no false alarm')
    return WHY_IGNORED.first(facts) or FALSE_ALARM.first(facts) or well


@criterion(
    points=2,
    title="The heartbeat is published at 5 Hz, no matter what happens to a call",
    needs=[alive_at_end],
)
def heartbeat_steady(recording: Recording) -> Verdict:
    exists = see.publishes(recording, HEARTBEAT)
    missing = see.no_message(recording, HEARTBEAT) if exists.ok else exists
    facts = Heart(recording)
    well = see.passed(f"{facts.beats.count} beats, typically one every {facts.beats.typical_s:.1f} s")
    return missing or WHY_UNSTEADY.first(facts) or well

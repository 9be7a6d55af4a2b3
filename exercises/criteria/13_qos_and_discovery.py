"""How exercise 13 is judged: a robot that has spoken before the dashboard starts, and whose heart is silent twice."""

import random
from collections.abc import Sequence
from dataclasses import replace
from itertools import accumulate, cycle, pairwise, product

from std_msgs.msg import Bool, String

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, program_runs, topic, watching

LINE = topic("/dashboard/line", String, hz=2.0)
ALARM = topic("/dashboard/alarm", Bool)

WATCH_S = 15.0
BEAT_S, LINE_S = 0.25, 0.5
STATUS = see.publish("/robot/status", String, [], qos="latched")
HEART = see.publish("/robot/heartbeat", String, [], qos="best_effort", deadline=2 * BEAT_S)


def drawn(rng: random.Random) -> list[see.Part]:
    """Draw a robot that has spoken before the start. Its heart is silent twice, and one beat is late: a hiccup.

    A program that looks at the clock five times a second looks at different moments of the two silences. After the
    second one, there is time to end an alarm.
    """
    while True:
        moments = drawn_beats(rng)
        silences = silences_between(moments)
        (first, _), (second, ended) = silences
        if ended > WATCH_S - 1.8 or abs((second - first) % 0.2 - 0.1) > EARLY_S:
            continue
        changes = drawn_changes(rng, silences)
        if out_of_step([*(at for at, _ in changes[1:]), WATCH_S]):
            break
    beats = [(at, f"beat {n + 1}") for n, at in enumerate(moments) if at < WATCH_S - 0.1]
    return [
        replace(STATUS, lines=see.publish(STATUS.topic, String, changes).lines),
        replace(HEART, lines=see.publish(HEART.topic, String, beats).lines),
    ]


def drawn_beats(rng: random.Random) -> list[float]:
    """Draw when the heart beats (s): in three groups with silences between them, and a hiccup in one of the first two.

    The first group lasts for more than a second, also until a hiccup.
    """
    counts = [rng.randint(6, 18), rng.randint(4, 8), 30]
    hiccup = rng.choice((rng.randint(5, counts[0] - 1), counts[0] + rng.randint(1, counts[1] - 1)))
    pauses = {hiccup: rng.choice((0.85, 0.9))}
    pauses |= {sum(counts[:group]): rng.choice((3.7, 3.75, 3.8)) for group in (1, 2)}
    return [*accumulate(pauses.get(n, BEAT_S) if n else 0.0 for n in range(sum(counts)))]


def drawn_changes(rng: random.Random, silences: Sequence[tuple[float, float]]) -> list[tuple[float, str]]:
    """Draw the status from before the start, and its changes (s), more than a program that counts to five will follow.

    When an alarm is due, the status is "operational" in the first silence and "error" in the second one, and stays so
    until the alarm is late. Then it changes before the silence ends. When the alarm has to end, it is "error" the first
    time, and changes only when the end is late; the second time it is "operational". In the second silence it changes
    so often that a watchdog that takes a status for a beat raises no alarm.
    """
    (began, ended), (again, at_last) = silences
    changes = [
        began + rng.uniform(0.6, 0.9),
        ended - rng.uniform(0.2, 0.3),
        ended + rng.uniform(1.8, 1.9),
        again + rng.uniform(1.55, 1.65),
        again + rng.uniform(3.26, 3.3),
    ]
    words = ["error", "operational"]
    before, after, latest = changes[0] - LASTS_S, at_last + 1.8, WATCH_S - LASTS_S - 0.05
    if before > 1.6 and rng.random() < 0.7:
        changes.insert(0, rng.uniform(1.6, before))
        words.reverse()
    if after < latest and rng.random() < 0.5:
        changes.append(rng.uniform(after, latest))
    return list(zip([see.BEFORE_START, *changes], cycle(words), strict=False))


def out_of_step(moments: Sequence[float]) -> bool:
    """Check that two lasting statuses come at such moments (s) that a line which follows late misses one of them."""
    lasting = [at for at, end in pairwise(moments) if end - at > LASTS_S]
    return any(0.2 < (one - other) % LINE_S < 0.3 for one, other in product(lasting, lasting))


WATCH = watching(wall_seconds=WATCH_S, script=drawn)

UNKNOWN = "unknown"
WORDS = ("operational", "error", UNKNOWN)
AT_ONCE_S = 1.0  # what was said before must be on the line by then
FOLLOWS_S = 0.8
NOT_BEFORE_S, NOT_AFTER_S, SLACK_S = 1.0, 3.0, 0.2
FALLS_WITHIN_S = 1.5
EARLY_S = 0.02  # a True that was measured so much too early is no false alarm
SILENCE_S = 2.0  # a pause between beats that is longer is a silence of the script
SLOWEST_HZ, FASTEST_HZ, LONGEST_GAP_S = 1.8, 2.2, 1.25
SHORTEST_S, LONGEST_S = 0.45, 0.55
LASTS_S = FOLLOWS_S + LONGEST_S  # so long a status must be on a line
NEAR_S = 0.7  # from the last line to the True that a silence of the line goes with


@criterion(points=0, title="It runs until the judge stops watching", needs=[program_runs])
def runs_on(recording: Recording) -> Verdict:
    return see.alive_at_end(recording)


@criterion(points=1, title="/dashboard/line carries String", needs=[program_runs])
def line_topic(recording: Recording) -> Verdict:
    return see.publishes(recording, LINE)


@criterion(points=1, title="The line comes at 2 Hz, and never stops", needs=[line_topic, runs_on])
@see.needs_messages(LINE)
def line_rate(recording: Recording) -> Verdict:
    seen = see.topic_pace(recording, LINE)
    typical = seen.typical_interval or 0.0
    even = SHORTEST_S <= typical <= LONGEST_S and seen.gap.seconds <= LONGEST_GAP_S
    if seen.hz is not None and SLOWEST_HZ <= seen.hz <= FASTEST_HZ and even:
        return see.passed(f"{seen.hz:.1f} Hz over {seen.count} lines")
    silent = why_silent(recording) or also_with_each_beat(recording)
    if silent is not None:
        return silent
    usual = see.rate(recording, LINE)
    if not usual.ok:
        return replace(usual, expected=TWO_HERTZ)
    return see.failed(
        "line-rate.uneven",
        f"{seen.count} lines, {seen.hz or 0.0:.2g} Hz, typically {typical:.2g} s apart",
        TWO_HERTZ,
        "The period is slightly wrong, or a loop sleeps for a full period in addition to its work.",
        "2 Hz is a period of 0.5 s: create_timer(0.5, self.publish_line).",
        about_time=True,
    )


@criterion(
    points=2, title="It shows right away the status from before it started", needs=[line_topic, runs_on]
)
def status_at_once(recording: Recording) -> Verdict:
    hears = see.hears(recording, STATUS)
    if not hears.ok:
        return hears
    _, until, first = statuses(recording)[0]
    lines = lines_between(recording, AT_ONCE_S, until)
    if not lines:
        return see.failed(
            "status-at-once.no-line",
            f"no line between {AT_ONCE_S:.1f} s and {until:.1f} s",
            f'"{first}" on every line, from {AT_ONCE_S:g} s on',
            "No line arrived at all in that time, so the problem is the line, not the status.",
            "First, find out why the line isn't published at 2 Hz.",
        )
    wrong = next(((t, text) for t, text in lines if named(text) != [first]), None)
    if wrong is not None:
        return why_not_at_once(
            recording, first, f'"{wrong[1]}" on {LINE.name} {wrong[0]:.1f} s after the start'
        )
    if all_requests(recording, "durability", "volatile"):
        return guessed(f'"{first}" on the line, but only a volatile subscription to {STATUS.topic}')
    return see.passed(f'"{first}" on each of {len(lines)} lines')


@criterion(points=1, title="The line follows when the status changes", needs=[status_at_once])
def status_follows(recording: Recording) -> Verdict:
    changes = statuses(recording)[1:]
    followed = 0
    for begin, end, word in changes:
        lines = lines_between(recording, begin + FOLLOWS_S, end)
        shown = lines_between(recording, begin + FOLLOWS_S - LONGEST_S, begin + FOLLOWS_S)[-1:]
        judged = [*shown, *lines] if end - begin > FOLLOWS_S else []
        wrong = next((text for _, text in judged if named(text) != [word]), None)
        if wrong is not None and word in named(wrong):
            return two_words("status-follows.two-words", f'"{wrong}" on {LINE.name}', f'"{word}" on the line')
        if wrong is not None:
            return why_not_followed(recording, followed, (begin, end, word), wrong)
        followed += bool(lines)  # whether the line comes at all, `line_rate` judges
    if changes and not followed:
        return see.failed(
            "status-follows.no-line",
            f"no line more than {FOLLOWS_S} s after a change of the status",
            "the new status on the line",
            "No line arrived at all in that time, so the problem is the line, not the status.",
            "First, find out why the line isn't published at 2 Hz.",
        )
    return see.passed(f"the line showed {followed} of {len(changes)} new statuses, and never a wrong one")


@criterion(points=1, title="It receives the heartbeat", needs=[program_runs])
def hears_heartbeat(recording: Recording) -> Verdict:
    return see.hears(recording, HEART)


@criterion(points=0, title="/dashboard/alarm carries Bool", needs=[program_runs])
def alarm_topic(recording: Recording) -> Verdict:
    return see.publishes(recording, ALARM)


@criterion(points=1, title="The alarm is kept for late subscriptions", needs=[alarm_topic])
def alarm_kept(recording: Recording) -> Verdict:
    return see.kept_for_latecomers(recording, ALARM)


@criterion(
    points=1, title="The alarm is raised within 3 s of silence", needs=[alarm_topic, hears_heartbeat, runs_on]
)
def alarm_raised(recording: Recording) -> Verdict:
    took = []
    for number, (began, ended) in enumerate(silences(recording)):
        if recording.simulated_s < began + NOT_AFTER_S + SLACK_S:
            continue
        raised = [t - began for t, on in alarms(recording, began, ended) if on]
        was_on = [on for _, on in alarms(recording, 0.0, began)][-1:] == [True]
        if number > 0 and not raised and was_on:
            continue  # it is on since the silence before: that it does not end, `alarm_falls` judges
        if not raised or raised[0] > NOT_AFTER_S + SLACK_S:
            return why_not_raised(recording, number, began, ended, raised)
        took.append(f"{raised[0]:.1f} s")
    return see.passed(f"raised {see.listing(took)} after the last beat")


@criterion(points=1, title="The alarm isn't raised too early", needs=[alarm_topic, hears_heartbeat, runs_on])
def no_false_alarm(recording: Recording) -> Verdict:
    calm_from = AT_ONCE_S
    for began, ended in silences(recording):
        early = [
            (t, before)
            for t, on in alarms(recording, calm_from, began + NOT_BEFORE_S - EARLY_S)
            for before in [last_beat(recording, t)]
            if on and t - before < NOT_BEFORE_S - EARLY_S  # on a busy machine, a hiccup may last too long
        ]
        if early:
            return why_false_alarm(*early[0], first_alarm(recording, early[0][0]))
        # The alarm of this silence may last until it is taken back: whether it is, `alarm_falls` judges.
        taken_back = [t for t, on in alarms(recording, ended, recording.simulated_s) if not on]
        calm_from = taken_back[0] if taken_back else recording.simulated_s
    return see.passed("no alarm while the heartbeat arrives, nor in the first second of silence")


@criterion(points=1, title="The alarm ends when the heart beats again", needs=[alarm_raised, no_false_alarm])
def alarm_falls(recording: Recording) -> Verdict:
    for number, (began, ended) in enumerate(silences(recording)):
        during = alarms(recording, began, min(ended, recording.simulated_s))
        raised = next((t for t, on in during if on), None)
        fell = next((t for t, on in during if raised is not None and t > raised and not on), None)
        if fell is not None:
            return why_fell_in_silence(fell - began, just_after_a_status(recording, fell))
        if ended + FALLS_WITHIN_S + SLACK_S > recording.simulated_s:
            continue
        fell = next((t for t, on in alarms(recording, ended, recording.simulated_s) if not on), None)
        if fell is None or fell - ended > FALLS_WITHIN_S + SLACK_S:
            if fell is not None and just_after_a_status(recording, fell):
                return why_waits_for_a_status(fell - ended)
            return why_not_taken_back(number, None if fell is None else fell - ended)
    return see.passed("ended when the heartbeat returned")


# --- what was said, and when --------------------------------------------------------------------------------

TWO_HERTZ = (
    f"2 Hz, always: {SLOWEST_HZ} to {FASTEST_HZ} Hz, typically one line every {SHORTEST_S} to {LONGEST_S} s, "
    f"no silence over {LONGEST_GAP_S} s"
)


def named(text: str) -> list[str]:
    """The words for a status that a line names."""
    return [word for word in WORDS if word in text.lower()]


def lines_between(recording: Recording, begin: float, end: float) -> list[tuple[float, str]]:
    """The lines that came between two moments (s), and when."""
    heard = recording.topic(LINE.name).arrivals
    return [(one.t, str(one.value.get("data"))[:60]) for one in heard if begin <= one.t < end]


def statuses(recording: Recording) -> list[tuple[float, float, str]]:
    """From when to when (s) each status held, and its word; the first one from the begin of the watch on."""
    said = [(max(0.0, one.t), str(one.value["data"])) for one in see.published(recording, STATUS.topic)]
    ends = [*(t for t, _ in said[1:]), recording.simulated_s]
    return [(begin, end, word) for (begin, word), end in zip(said, ends, strict=True)]


def beat_times(recording: Recording) -> list[float]:
    """When the heart beat (s)."""
    return [one.t for one in see.published(recording, HEART.topic)]


def last_beat(recording: Recording, t: float) -> float:
    """When the heart had last beaten at a moment (s); 0 if it had not."""
    return max((beat for beat in beat_times(recording) if beat <= t), default=0.0)


def silences(recording: Recording) -> list[tuple[float, float]]:
    """The last beat before each long silence and the first one after it (s); the end of the watch if there is none."""
    return silences_between([*beat_times(recording), recording.simulated_s])


def silences_between(moments: Sequence[float]) -> list[tuple[float, float]]:
    """Find from when to when (s) no beat comes for long."""
    return [(last, first) for last, first in pairwise(moments) if first - last > SILENCE_S]


def alarms(recording: Recording, begin: float, end: float) -> list[tuple[float, bool]]:
    """What /dashboard/alarm said between two moments (s)."""
    heard = recording.topic(ALARM.name).arrivals
    return [(one.t, bool(one.value.get("data"))) for one in heard if begin <= one.t < end]


def line_gaps(recording: Recording) -> list[tuple[float, float]]:
    """The long silences of the line, from when to when (s)."""
    start, end = recording.topic(LINE.name).window or (0.0, recording.simulated_s)
    times = [start, *(one.t for one in recording.topic(LINE.name).arrivals), end]
    return [(last, following) for last, following in pairwise(times) if following - last > LONGEST_GAP_S]


def lines_with_a_status(recording: Recording) -> int:
    """How many lines came, if each came just when the robot had said its status; otherwise 0."""
    times = [one.t for one in recording.topic(LINE.name).arrivals if one.t >= AT_ONCE_S]
    begins = [begin for begin, _, _ in statuses(recording)]
    return len(times) if all(any(0.0 <= t - begin <= BEAT_S for begin in begins) for t in times) else 0


def all_requests(recording: Recording, policy: str, value: str) -> bool:
    """Whether every subscription to the status requests this value of a policy."""
    asked = [one for one in recording.topic(STATUS.topic).subscribers if one.type == STATUS.type]
    return all(getattr(one, policy) == value for one in asked)


def just_after_a_status(recording: Recording, t: float) -> bool:
    """Whether the robot had said a new status in the moment before."""
    return any(0.0 <= t - begin <= BEAT_S - EARLY_S for begin, _, _ in statuses(recording)[1:])


def first_alarm(recording: Recording, before: float) -> float | None:
    """How long (s) the heart had been silent when the alarm was first raised, in a silence that ended before (s)."""
    for began, ended in silences(recording):
        raised = [t - began for t, on in alarms(recording, began, ended) if on]
        if raised and ended <= before:
            return raised[0]
    return None


def raised_in_time(recording: Recording, number: int) -> float | None:
    """After how long (s) a silence other than this one had its alarm, if that was in time."""
    for place, (began, ended) in enumerate(silences(recording)):
        raised = [t - began for t, on in alarms(recording, began, ended) if on]
        if place != number and raised and raised[0] <= NOT_AFTER_S + SLACK_S:
            return raised[0]
    return None


def status_ended_an_alarm(recording: Recording) -> float | None:
    """When (s) an alarm ended in a silence of the heart, just when the status changed; None if none did."""
    for began, ended in silences(recording):
        during = alarms(recording, began, ended)
        raised = next((t for t, on in during if on), recording.simulated_s)
        for t, on in during:
            if t > raised and not on and just_after_a_status(recording, t):
                return t
    return None


def alarms_with_the_status(recording: Recording) -> int:
    """How many times the alarm changed, if each time right after the status had changed likewise; otherwise 0."""
    heard = alarms(recording, AT_ONCE_S, recording.simulated_s)
    changes = [(t, on) for (_, before), (t, on) in pairwise([(0.0, None), *heard]) if on != before]
    likewise = any(
        all(
            any(
                0.0 <= t - begin <= 2 * EARLY_S + BEAT_S and on == (word == meant)
                for begin, _, word in statuses(recording)
            )
            for t, on in changes
        )
        for meant in WORDS
    )
    return len(changes) if likewise and len(changes) > 1 else 0


# --- the line -----------------------------------------------------------------------------------------------


def why_silent(recording: Recording) -> Verdict | None:
    """Why the line stops, where each of its silences begins with the alarm, or with the silence of the heart."""
    with_a_status = lines_with_a_status(recording)
    if with_a_status:
        return see.failed(
            "line-rate.only-with-a-status",
            f"{see.count(with_a_status, 'line')} in {recording.simulated_s:.1f} s, each just after the robot published "
            "its status",
            TWO_HERTZ,
            "Your node publishes the line in the status callback, which runs only when the status changes.",
            "Store the status in self, and publish the line from a timer: create_timer(0.5, self.publish_line).",
        )
    gaps = line_gaps(recording)
    times = see.listing([f"from {begin:.1f} s to {end:.1f} s" for begin, end in gaps])
    blamed = see.failed_by_error(recording, f"no line {times}", TWO_HERTZ) if gaps else None
    if blamed is not None:
        return blamed
    raised = [t for t, on in alarms(recording, 0.0, recording.simulated_s) if on]
    if gaps and all(any(-EARLY_S <= t - last <= NEAR_S for t in raised) for last, _ in gaps):
        return see.failed(
            "line-rate.stops-with-the-alarm",
            f"no line {times}, just when the alarm was raised",
            TWO_HERTZ,
            "The code that handles the silence also blocks the line: it waits or sleeps in a callback. Or no line "
            "is published during an alarm.",
            "Let every callback return right away, and publish the line on every tick of its timer, with or "
            "without an alarm.",
        )
    if gaps and all(any(abs(last - began) <= BEAT_S for began, _ in silences(recording)) for last, _ in gaps):
        return see.failed(
            "line-rate.stops-with-the-heart",
            f"no line {times}, exactly while there was no heartbeat",
            TWO_HERTZ,
            "Your node publishes the line in the heartbeat callback, which doesn't run during a silence.",
            "Publish the line from its own timer: create_timer(0.5, self.publish_line).",
        )
    return None


def also_with_each_beat(recording: Recording) -> Verdict | None:
    """Whether a line comes with nearly every beat, beside those that come without one; None if not."""
    beats = beat_times(recording)
    lines = [one.t for one in recording.topic(LINE.name).arrivals]
    with_a_beat = [beat for beat in beats if any(0.0 <= t - beat <= 2 * EARLY_S for t in lines)]
    others = [t for t in lines if not any(0.0 <= t - beat <= 2 * EARLY_S for beat in beats)]
    if len(with_a_beat) < 0.8 * len(beats) or len(others) < SLOWEST_HZ * recording.simulated_s / 2:
        return None
    return see.failed(
        "line-rate.also-with-each-beat",
        f"{len(lines)} lines in {recording.simulated_s:.1f} s. A line arrived right after {len(with_a_beat)} of "
        f"{len(beats)} beats, and {len(others)} lines arrived at other times",
        TWO_HERTZ,
        "Two places publish the line: a timer and the heartbeat callback.",
        "Publish the line only from the timer. In the callback, just store the data that the timer needs.",
    )


def two_words(cause: str, seen: str, expected: str) -> Verdict:
    """The line names the right status, and another one, too."""
    return see.failed(
        cause,
        seen,
        expected,
        "The line contains the right status, but also another of the three words. So a reader can't tell which one "
        "is right.",
        f"Put exactly one of {', '.join(WORDS)} on the line.",
    )


def guessed(seen: str) -> Verdict:
    """The line is right, and nothing in the program can know it."""
    return see.failed(
        "status-at-once.guessed",
        seen,
        "a subscription that requests earlier messages: reliable and transient local",
        "A volatile subscription receives no earlier messages. So your program made up the word on the line.",
        "Request earlier messages with QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL), and start "
        "with unknown.",
    )


def why_not_at_once(recording: Recording, first: str, seen: str) -> Verdict:
    """Why a line does not name the status from before the program started."""
    expected = f'"{first}" on every line, from {AT_ONCE_S:g} s on'
    if first in seen.lower():
        return two_words("status-at-once.two-words", seen, expected)
    if all_requests(recording, "durability", "volatile"):
        return see.failed(
            "status-at-once.volatile",
            seen,
            expected,
            "Your subscription to /robot/status is volatile, so it requests only new messages. But the robot "
            "published its status earlier, and publishes again only when the status changes.",
            "Request earlier messages with QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL).",
        )
    if all_requests(recording, "reliability", "best_effort"):
        return see.failed(
            "status-at-once.best-effort",
            seen,
            expected,
            "Your subscription to /robot/status is transient local, but best effort. But earlier messages are "
            "delivered only to reliable subscriptions.",
            "Leave reliability out of this QoSProfile: the default is reliable.",
        )
    return why_not_on_the_line(seen, expected)


def why_not_on_the_line(seen: str, expected: str) -> Verdict:
    """Why the line does not name a status that the program must have heard."""
    if not named(seen):
        return see.failed(
            "status-at-once.no-word",
            seen,
            expected,
            f"The line contains none of the words {', '.join(WORDS)}.",
            "Put message.data into the line unchanged.",
        )
    return see.failed(
        "status-at-once.not-kept",
        seen,
        expected,
        "Your subscription requests the right QoS, so the message arrives. But the line doesn't use it, or is "
        "published only when a message arrives.",
        "In the callback, store message.data in self. Publish it on every tick of a timer.",
        about_time=True,
    )


def why_not_followed(
    recording: Recording, followed: int, change: tuple[float, float, str], wrong: str
) -> Verdict:
    """Why the line does not name the new status after a change; `followed`: how many changes it has followed."""
    begin, _, word = change
    expected = f'"{word}" on the line at most {FOLLOWS_S} s after the robot has published it'
    saw = (
        f'"{wrong}" still on the line {FOLLOWS_S} s or more after the robot had published "{word}" at '
        f"{begin:.1f} s"
    )
    if UNKNOWN in named(wrong):
        return see.failed(
            "status-follows.unknown-again",
            saw,
            expected,
            "The robot's status is known, but the line claims that it isn't. A silent heartbeat doesn't change the "
            "robot's last status.",
            f"Show {UNKNOWN} only before the first status. The alarm reports the silence.",
        )
    if not named(wrong):
        return see.failed(
            "status-follows.no-word",
            saw,
            expected,
            f"The line contains none of the words {', '.join(WORDS)}. So it doesn't show the status.",
            "Put message.data into every line, no matter what else is on the line.",
        )
    return why_followed_late(recording, followed, change, saw)


def why_followed_late(
    recording: Recording, followed: int, change: tuple[float, float, str], saw: str
) -> Verdict:
    """The line names an old status after a `change`, for a while or for good."""
    begin, end, word = change
    expected = f'"{word}" on the line at most {FOLLOWS_S} s after the robot has published it'
    if any(word in named(text) for _, text in lines_between(recording, begin + FOLLOWS_S, end + AT_ONCE_S)):
        return see.failed(
            "status-follows.late",
            saw,
            expected,
            "The line shows the new status, but late or not always. The status comes from a queue of older "
            "messages, or the line also depends on something else.",
            "Let the callback store every message in self, and build each line only from the stored message.",
            about_time=True,
        )
    if not followed and any(
        word in named(text) for _, text in lines_between(recording, end, recording.simulated_s)
    ):
        return see.failed(
            "status-follows.only-sometimes",
            f'{saw}. The line showed "{word}" only after later changes',
            expected,
            "The line does change, but something else decides when: the heartbeat, the alarm, or a number of "
            "messages.",
            "Store each message when it arrives, and build each line only from that: self.last_status = "
            "message.data.",
        )
    return why_followed_no_more(followed, saw, expected)


def why_followed_no_more(followed: int, saw: str, expected: str) -> Verdict:
    """Why the line stays with an old status; `followed`: how many changes it has followed."""
    if followed:
        return see.failed(
            "status-follows.not-always",
            f"{saw}; before that, the line had followed {see.count(followed, 'change')}",
            expected,
            "The line follows some changes but not others. Perhaps a repeated status is skipped, one status is "
            "never replaced, or the program stops handling messages after some time.",
            "When a message arrives, do only this: self.last_status = message.data.",
        )
    return see.failed(
        "status-follows.never",
        saw,
        expected,
        "The line shows only the first status. It's read once at the start, or later messages don't replace it. Or "
        "a callback never returns, so the next message isn't handled.",
        "Let the subscription's callback store every message in self. Never wait or sleep in a callback.",
        about_time=True,
    )


# --- the alarm ----------------------------------------------------------------------------------------------


def why_not_raised(
    recording: Recording, number: int, began: float, ended: float, raised: Sequence[float]
) -> Verdict:
    """Why there was no alarm in time in a silence; `number` counts the silences from 0."""
    expected = f"True on {ALARM.name} at most {NOT_AFTER_S:g} s after the last beat"
    with_status = alarms_with_the_status(recording)
    if with_status:
        return see.failed(
            "alarm-raised.with-the-status",
            f"the alarm changed {with_status} times, each time just when the status changed",
            expected,
            "The alarm follows the status instead of the heartbeat's silence.",
            "Store time.monotonic() at each beat, and let a timer compare it with the current time.",
        )
    in_time = raised_in_time(recording, number)
    if raised and in_time is not None and just_after_a_status(recording, began + raised[0]):
        return see.failed(
            "alarm-raised.waits-for-a-status",
            f"True only {raised[0]:.1f} s after the last beat, just when the status had changed. In another "
            f"silence, it was published after {in_time:.1f} s",
            expected,
            "The alarm also depends on the status: your node doesn't raise it while the status is one of the two "
            "words.",
            "Only compare the current time with the time of the last beat, whatever the status is.",
        )
    if raised:
        return see.failed(
            "alarm-raised.late",
            f"True only {raised[0]:.1f} s after the last beat",
            expected,
            "The time limit is too long, or the timer that checks it fires too rarely. The limit and the timer's "
            "period add up.",
            "Use 2 s as the limit, and check it at least twice per second.",
            about_time=True,
        )
    if number > 0:
        return why_not_raised_again(recording, began, ended, expected)
    return why_never_raised(recording, began, ended, expected)


def why_not_raised_again(recording: Recording, began: float, ended: float, expected: str) -> Verdict:
    """Why there was no alarm in a silence after the first one."""
    nothing = f"no True on {ALARM.name} in {ended - began:.1f} s of silence"
    by_status = status_ended_an_alarm(recording)
    if by_status is not None:
        return see.failed(
            "alarm-raised.status-counts",
            f"{nothing} that began at {began:.1f} s and in which the status changed. In the first silence, the "
            f"alarm ended at {by_status:.1f} s, just when the status changed",
            expected,
            "Your node counts a status as a beat: it restarts the silence measurement and ends the alarm.",
            "Store the time of the last beat only in the heartbeat callback.",
        )
    return see.failed(
        "alarm-raised.first-only",
        f"{nothing} that began at {began:.1f} s; in the first silence, the alarm was raised",
        expected,
        "The alarm works only once: a flag is set and never cleared, or a timer is canceled and never reset. Or "
        "your node counts a new status as a beat.",
        "When the heartbeat returns, reset everything to its state before the alarm.",
    )


def why_never_raised(recording: Recording, began: float, ended: float, expected: str) -> Verdict:
    """Why there was no alarm in the first silence, or only something else than an alarm."""
    nothing = f"no True on {ALARM.name} in {ended - began:.1f} s of silence"
    said = [at for at, _ in alarms(recording, began + NOT_BEFORE_S, ended)]
    back = any(on for _, on in alarms(recording, ended, ended + FALLS_WITHIN_S))
    if said and back:
        return see.failed(
            "alarm-raised.inverted",
            f"False {said[0] - began:.1f} s after the last beat, and True when the heartbeat returned",
            expected,
            "The alarm is inverted: it's True while the heartbeat arrives.",
            "Publish True when the silence exceeds the limit, and False when a beat arrives.",
        )
    if back:
        return see.failed(
            "alarm-raised.with-the-next-beat",
            f"nothing in {ended - began:.1f} s of silence, and True when the heartbeat returned",
            expected,
            "Your node checks the time in the heartbeat callback, but that doesn't run during a silence.",
            "Check the time in a timer, or use the event for a missed deadline. Neither needs a message.",
            about_time=True,
        )
    return why_nothing_noticed(nothing, expected, said[0] - began if said else None)


def why_nothing_noticed(nothing: str, expected: str, said_after: float | None) -> Verdict:
    """Why there was no True in or after the first silence; `said_after`: when False came, after the last beat."""
    if said_after is not None:
        return see.failed(
            "alarm-raised.false-instead",
            f"{nothing}; False was published {said_after:.1f} s after the last beat",
            expected,
            "Your program publishes False during the silence. The limit is too long, it's checked too rarely, or "
            "data isn't a bool. The Ubuntu packages send Bool(data=1) as False.",
            "Publish the result of a comparison: Bool(data=silent_for > LIMIT), with a limit of 2 s. Check it at "
            "least twice per second.",
        )
    return see.failed(
        "alarm-raised.never",
        nothing,
        expected,
        "None of your code runs during the silence: there's no timer that checks the time, and no event for a "
        "missed deadline. Or the limit is too long.",
        "Store time.monotonic() at each beat, and let a timer compare it with the current time.",
        about_time=True,
    )


def why_false_alarm(at: float, last_beat: float, first: float | None) -> Verdict:
    """Why the alarm was raised at a moment (s) so soon after the last beat; `first`: after how long the first was."""
    after = at - last_beat
    expected = f"no alarm until the heartbeat has been silent for {NOT_BEFORE_S:g} s"
    if after <= 1.5 * BEAT_S:
        return see.failed(
            "no-false-alarm.while-beating",
            f"True on {ALARM.name} at {at:.1f} s, only {after:.2f} s after a beat",
            expected,
            f"A beat arrives every {BEAT_S} s. With a limit close to that, every short delay raises an alarm. Or "
            "the alarm depends on something other than the last beat: the status, the time since the start, or a "
            "sum of several pauses.",
            "Use 2 s as the limit, and measure from the last beat.",
            about_time=True,
        )
    if first is not None and first >= NOT_BEFORE_S:
        return see.failed(
            "no-false-alarm.later-one-early",
            f"True on {ALARM.name} {after:.2f} s after the last beat. The first alarm was raised after {first:.1f} s",
            expected,
            "Something remains from the first silence: a counter or a flag that isn't cleared, or a changed limit. "
            "Or the program checks the time rarely, with a limit that's too short.",
            "When the heartbeat returns, reset everything to its state before the alarm. Use 2 s as the limit.",
            about_time=True,
        )
    return see.failed(
        "no-false-alarm.early",
        f"True on {ALARM.name} {after:.2f} s after the last beat",
        expected,
        f"The limit is too short. A beat arrives every {BEAT_S} s, and sometimes one is late. If the dashboard "
        "raises an alarm for that, people soon ignore it.",
        "Use 2 s as the limit, and measure from the last beat.",
        about_time=True,
    )


def why_fell_in_silence(after: float, with_a_status: bool) -> Verdict:
    """The alarm ended although the heart was still silent, so long (s) after the last beat."""
    if with_a_status:
        return see.failed(
            "alarm-falls.with-the-status",
            f"False on {ALARM.name} {after:.1f} s after the last beat, during the silence. The status had just "
            "changed",
            "an alarm that lasts until the heartbeat returns",
            "A new status ends the alarm as if it were a beat.",
            "End the alarm only in the heartbeat callback.",
        )
    return see.failed(
        "alarm-falls.in-silence",
        f"False on {ALARM.name} {after:.1f} s after the last beat, during the silence",
        "an alarm that lasts until the heartbeat returns",
        "Something other than a beat ends the alarm. It ends by itself after a while, or it depends on something "
        "else.",
        "End the alarm only in the heartbeat callback.",
    )


def why_waits_for_a_status(after: float) -> Verdict:
    """The alarm went on for so long (s) after the heart beat again, until the status changed."""
    return see.failed(
        "alarm-falls.waits-for-a-status",
        f"False only {after:.1f} s after the heartbeat returned, just when the status had changed",
        f"False on {ALARM.name} within {FALLS_WITHIN_S:g} s after the heartbeat returns",
        "The end of the alarm also depends on the status: the alarm continues while the status is one of the two "
        "words.",
        "End the alarm with the next beat, whatever the status is.",
    )


def why_not_taken_back(number: int, after: float | None) -> Verdict:
    """The alarm goes on for so long (s) after silence `number` (from 0), or for ever."""
    expected = f"False on {ALARM.name} within {FALLS_WITHIN_S:g} s after the heartbeat returns"
    if after is not None:
        return see.failed(
            "alarm-falls.late",
            f"False only {after:.1f} s after the heartbeat returned",
            expected,
            "The first beat ends the silence, but your program waits for more beats, or checks too rarely.",
            "End the alarm with the first beat, or check at least twice per second.",
            about_time=True,
        )
    if number > 0:
        return see.failed(
            "alarm-falls.first-only",
            "the first alarm ended when the heartbeat returned, but a later one did not",
            expected,
            "The code that ends the alarm works only once: a flag is never cleared, or a timer is canceled and "
            "never reset.",
            "When the heartbeat returns, reset everything to its state before the alarm.",
        )
    return see.failed(
        "alarm-falls.never",
        "no False after the heartbeat returned",
        expected,
        "The event for a missed deadline doesn't report the return of messages, and a timer that only raises the "
        "alarm doesn't end it. Or a loop that waits for the next beat keeps that beat from being handled, or your "
        "program waits for too many beats.",
        "End the alarm in the heartbeat callback, or publish silent > LIMIT on every tick, whether it's True or "
        "False.",
    )

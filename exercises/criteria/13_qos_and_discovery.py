"""How exercise 13 is judged: a robot that has spoken before the dashboard starts, and whose heart then falls silent."""

from itertools import pairwise

from std_msgs.msg import Bool, String

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, topic, watching

LINE = topic("/dashboard/line", String, hz=2.0)
ALARM = topic("/dashboard/alarm", Bool)

FIRST, THEN, THEN_AT_S = "operational", "error", 4.0
SILENT_FROM_S, BEATS_AGAIN_S, WATCH_S, BEAT_S = 2.0, 5.75, 8.0, 0.25
BEAT_TIMES = [
    n * BEAT_S for n in range(int(WATCH_S / BEAT_S)) if not SILENT_FROM_S < n * BEAT_S < BEATS_AGAIN_S
]

STATUS = see.says("/robot/status", String, [(see.BEFORE_START, FIRST), (THEN_AT_S, THEN)], qos="latched")
HEART = see.says(
    "/robot/heartbeat",
    String,
    [(t, f"beat {n + 1}") for n, t in enumerate(BEAT_TIMES)],
    qos="best_effort",
    deadline=2 * BEAT_S,
)
WATCH = watching(wall_seconds=WATCH_S, script=[STATUS, HEART])

WORDS = (FIRST, THEN, "unknown")
AT_ONCE_S = 1.0  # what was said before must be on the line by then
NOT_BEFORE_S, NOT_AFTER_S, SLACK_S = 1.0, 3.0, 0.5
FALLS_WITHIN_S = 1.5
SILENCE_S = 2.0  # a pause between beats that is longer is the silence of the script
SLOWEST_HZ, FASTEST_HZ, LONGEST_GAP_S = 1.4, 2.8, 1.6


def wrong_line(recording: Recording, begin: float, end: float, word: str) -> tuple[float, str] | None:
    """The first line between two moments (s) that does not name `word`, or names another status, too."""
    for arrival in recording.topic(LINE.name).arrivals:
        text = str(arrival.value["data"]).lower()
        if begin <= arrival.t < end and [one for one in WORDS if one in text] != [word]:
            return arrival.t, str(arrival.value["data"])[:60]
    return None


def changes_at(recording: Recording) -> float:
    """When the status changed; the end of the watch if it never came so far."""
    return next((one.t for one in see.said(recording, STATUS.topic) if one.t > 0.0), recording.robot_s)


def silence(recording: Recording) -> tuple[float, float]:
    """The last beat before the silence and the first one after it (s); the end of the watch where they are missing."""
    beats = [one.t for one in see.said(recording, HEART.topic)]
    for last, first in pairwise(beats):
        if last >= SILENT_FROM_S - BEAT_S and first - last > SILENCE_S:
            return last, first
    return beats[-1] if beats else recording.robot_s, recording.robot_s


def alarms(recording: Recording, begin: float, end: float) -> list[tuple[float, bool]]:
    """What /dashboard/alarm said between two moments (s)."""
    heard = recording.topic(ALARM.name).arrivals
    return [(one.t, bool(one.value["data"])) for one in heard if begin <= one.t < end]


def two_words(seen: str, expected: str) -> Verdict:
    """The line names the right status, and another one, too."""
    return see.failed(
        seen,
        expected,
        "The line names the right status and another one of the three words, too. Nobody can tell which one holds.",
        f"Let exactly one of {', '.join(WORDS)} stand on the line.",
    )


def why_not_at_once(recording: Recording, seen: str) -> Verdict:
    """Why a line does not name what was said before the program started."""
    expected = f'"{FIRST}" on every line, from {AT_ONCE_S:g} s on'
    if FIRST in seen.lower():
        return two_words(seen, expected)
    asked = [one for one in recording.topic(STATUS.topic).subscribers if one.type == STATUS.type]
    if all(one.durability == "volatile" for one in asked):
        return see.failed(
            seen,
            expected,
            "Your subscription to /robot/status is volatile: it asks only for what is said from now on. The robot "
            "spoke before, and it will speak again only when its status changes.",
            "Ask for it: QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL).",
        )
    if all(one.reliability == "best_effort" for one in asked):
        return see.failed(
            seen,
            expected,
            "Your subscription to /robot/status is transient local, but best effort. What was said before is handed "
            "over to reliable subscriptions only.",
            "Leave reliability out of this QoSProfile: the default is reliable.",
        )
    return see.failed(
        seen,
        expected,
        "Your subscription asks for the right thing. So the message comes, and the line is not made from it, or it is "
        "published only in the moment when the message comes.",
        "Keep message.data in self in the callback, and publish that on every tick of a timer.",
        about_time=True,
    )


@criterion(points=0, title="Your program runs and its node is on the graph")
def program_runs(recording: Recording) -> Verdict:
    return see.program_runs(recording)


@criterion(points=0, title="It runs until the end of the watch", needs=[program_runs])
def runs_on(recording: Recording) -> Verdict:
    return see.alive_at_end(recording)


@criterion(points=1, title="/dashboard/line carries String", needs=[program_runs])
def line_topic(recording: Recording) -> Verdict:
    return see.publishes(recording, LINE)


@criterion(points=1, title="The line comes at 2 Hz, and never stops", needs=[line_topic, runs_on])
def line_rate(recording: Recording) -> Verdict:
    nothing = see.no_message(recording, LINE)
    if nothing is not None:
        return nothing
    seen = see.topic_pace(recording, LINE)
    if seen.hz is not None and SLOWEST_HZ <= seen.hz <= FASTEST_HZ and seen.gap.seconds <= LONGEST_GAP_S:
        return see.passed(f"{seen.hz:.1f} Hz over {seen.count} lines")
    return see.rate(recording, LINE)


@criterion(points=2, title="It knows at once what was said before it started", needs=[line_topic, runs_on])
def status_at_once(recording: Recording) -> Verdict:
    hears = see.hears(recording, STATUS)
    if not hears.ok:
        return hears
    until = changes_at(recording)
    lines = [one for one in recording.topic(LINE.name).arrivals if AT_ONCE_S <= one.t < until]
    if not lines:
        return why_not_at_once(recording, f"no line between {AT_ONCE_S:.1f} s and {until:.1f} s")
    wrong = wrong_line(recording, AT_ONCE_S, until, FIRST)
    if wrong is not None:
        return why_not_at_once(recording, f'"{wrong[1]}" on {LINE.name} {wrong[0]:.1f} s after the start')
    return see.passed(f'"{FIRST}" on each of {len(lines)} lines')


@criterion(points=1, title="The line follows when the status changes", needs=[status_at_once])
def status_follows(recording: Recording) -> Verdict:
    since = changes_at(recording) + AT_ONCE_S
    lines = [one for one in recording.topic(LINE.name).arrivals if one.t >= since]
    wrong = wrong_line(recording, since, recording.robot_s, THEN)
    if lines and wrong is None:
        return see.passed(f'"{THEN}" on each of {len(lines)} lines after the change')
    if wrong is not None and THEN in wrong[1].lower():
        return two_words(f'"{wrong[1]}" on {LINE.name}', f'"{THEN}" on the line')
    saw = f'still "{wrong[1]}"' if wrong is not None else "no line"
    return see.failed(
        f'{saw} a second after the robot had said "{THEN}"',
        f'"{THEN}" on the line',
        "The status is read once at the start, or a callback that does not return keeps the next message out.",
        "Subscribe, and let the callback put every message into self. Never wait or sleep in a callback.",
        about_time=True,
    )


@criterion(points=1, title="It hears the heartbeat", needs=[program_runs])
def hears_heartbeat(recording: Recording) -> Verdict:
    return see.hears(recording, HEART)


@criterion(points=0, title="/dashboard/alarm carries Bool", needs=[program_runs])
def alarm_topic(recording: Recording) -> Verdict:
    return see.publishes(recording, ALARM)


@criterion(points=1, title="The alarm is kept for those who come later", needs=[alarm_topic])
def alarm_kept(recording: Recording) -> Verdict:
    return see.kept_for_latecomers(recording, ALARM)


@criterion(
    points=1, title="The alarm is raised within 3 s of silence", needs=[alarm_topic, hears_heartbeat, runs_on]
)
def alarm_raised(recording: Recording) -> Verdict:
    began, ended = silence(recording)
    raised = [t - began for t, on in alarms(recording, began, ended) if on]
    if raised and raised[0] <= NOT_AFTER_S + SLACK_S:
        return see.passed(f"raised {raised[0]:.1f} s after the last beat")
    expected = f"True on {ALARM.name} at most {NOT_AFTER_S:g} s after the last beat"
    later = [t - ended for t, on in alarms(recording, ended, ended + FALLS_WITHIN_S) if on]
    if raised:
        return see.failed(
            f"True only {raised[0]:.1f} s after the last beat",
            expected,
            "The limit is too long, or the timer that looks at the clock ticks too seldom: both add up.",
            "Take 2 s as the limit and look at least twice a second.",
            about_time=True,
        )
    if later:
        return see.failed(
            f"nothing in {ended - began:.1f} s of silence, and True when the heart beat again",
            expected,
            "You look at the clock in the callback of the heartbeat. In a silence nobody calls it.",
            "Look at the clock in a timer, or use the event of a missed deadline: both come without a message.",
            about_time=True,
        )
    return see.failed(
        f"no True on {ALARM.name} in {ended - began:.1f} s of silence",
        expected,
        "Nothing calls your code in the silence: there is no timer that looks at the clock and no event of a missed "
        "deadline. Or the limit is too long; or what you send is no bool, and stock ROS sends Bool(data=1) as False.",
        "Note time.monotonic() at each beat, and let a timer compare it with the clock.",
        about_time=True,
    )


@criterion(points=1, title="No alarm before it is due", needs=[alarm_topic, hears_heartbeat, runs_on])
def no_false_alarm(recording: Recording) -> Verdict:
    began, _ = silence(recording)
    early = [t for t, on in alarms(recording, AT_ONCE_S, began + NOT_BEFORE_S) if on]
    if not early:
        return see.passed("no alarm while the heart beats")
    when = "while the heart was beating" if early[0] <= began else f"{early[0] - began:.1f} s after a beat"
    return see.failed(
        f"True on {ALARM.name} {when}",
        f"no alarm until the heart has been silent for {NOT_BEFORE_S:g} s",
        "One beat comes every 0.25 s, and a busy machine holds one up now and then. A limit close to that cries wolf, "
        "and soon nobody listens. Or the alarm is on from the start and never taken back.",
        "Take 2 s as the limit, and count from the last beat.",
        about_time=True,
    )


@criterion(points=1, title="The alarm ends when the heart beats again", needs=[alarm_raised, no_false_alarm])
def alarm_falls(recording: Recording) -> Verdict:
    _, ended = silence(recording)
    after = alarms(recording, ended, recording.robot_s + SLACK_S)
    in_time = [t - ended for t, on in after if not on and t - ended <= FALLS_WITHIN_S]
    again = [t - ended for t, on in after if on and t - ended > FALLS_WITHIN_S]
    if in_time and not again:
        return see.passed(f"taken back {in_time[0]:.1f} s after the first beat")
    saw = "no False" if not in_time else f"True again, {again[0]:.1f} s"
    return see.failed(
        f"{saw} after the heart beat again",
        f"False on {ALARM.name} within {FALLS_WITHIN_S:g} s, and no True after that",
        "The event of a missed deadline does not say when the messages are back; nor does a timer that only ever "
        "raises the alarm. Or a loop that waits for the next beat keeps this very beat from being handled.",
        "Take the alarm back in the callback of the heartbeat, or publish silent > LIMIT on every tick, true or false.",
        about_time=True,
    )

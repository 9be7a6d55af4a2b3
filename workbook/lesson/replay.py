"""Show a report: its recording's judgment, the messages on a time axis, and the doctor's findings."""

from dataclasses import dataclass

from workbook.criteria.budget import within_budget
from workbook.exercise.definition import Exercise
from workbook.exercise.judgement import Judgement, judge_recording
from workbook.feedback.card import Extras, as_html
from workbook.feedback.timeline import judged_timeline
from workbook.grading.pages import TEXT_COLORS
from workbook.lesson.help_report import HelpReport
from workbook.recording.plain_text import without_commands
from workbook.recording.recording import Recording
from workbook.templating import as_markup, render

DRAWING_BUDGET_S = 20.0
"""The limit on the CPU time (s) for the timeline, because drawing a malicious recording could take forever."""


@dataclass(frozen=True)
class ReportReplay:
    """A report, judged on this machine. `judgement` and `timeline` are None if the report has no recording."""

    report: HelpReport
    judgement: Judgement | None
    timeline: bytes | None
    timeline_text: str

    def notes(self) -> list[str]:
        """Return sentences about the report: the versions that made it, and whether its recording is current."""
        made = self.report.made_by
        said = [f"Made by workbook {made.workbook}, rclpy {made.rclpy}, Python {made.python}."]
        if self.judgement is None:
            said.append("There is no recording: the answer was not checked yet.")
        elif not self.report.is_of_this_answer:
            said.append("The recording shows an earlier version of this answer.")
        return [without_commands(one).replace("\n", " ") for one in said]

    def happened(self) -> list[str]:
        """Summarize the recording as lines: the topics with their messages, and then the end of the program."""
        if self.judgement is None or self.judgement.recording is None:
            return []
        recording = self.judgement.recording
        lines = [_about_topic(recording, name) for name in sorted(recording.topics)]
        ended = recording.process
        how = f"exit code {ended.exit}" if ended.signal is None else f"signal {ended.signal}"
        by = {"itself": "by itself", "judge": "when the judge ended it", None: "not seen"}[ended.ended_by]
        lines += [f"end of the program: {by}, {how}", self.timeline_text]
        return [without_commands(one).replace("\n", " ") for one in lines if one]


def _about_topic(recording: Recording, name: str) -> str:
    topic = recording.topic(name)
    types = ", ".join(topic.types) or "no publisher"
    if not topic.arrivals:
        return f"{name} ({types}): no message"
    first, last = topic.arrivals[0].t, topic.arrivals[-1].t
    return f"{name} ({types}): {len(topic.arrivals)} messages, from {first:.2f} s to {last:.2f} s"


def replay(report: HelpReport, exercise: Exercise) -> ReportReplay:
    """Judge the report's recording by this course's criteria, without running any code from the report."""
    recording = report.recording
    if recording is None:
        return ReportReplay(report, None, None, "")
    judgement = judge_recording(exercise, "", recording)
    try:
        picture, words = within_budget(lambda: judged_timeline(exercise, recording), DRAWING_BUDGET_S)
    except Exception:  # a forged recording may contain any numbers
        return ReportReplay(report, judgement, None, "The timeline of this recording cannot be drawn.")
    return ReportReplay(report, judgement, picture, words)


def replay_page(shown: ReportReplay, exercise: Exercise) -> str:
    """Render the replay as a single HTML file without scripts or external resources."""
    card = ""
    if shown.judgement is not None:
        extras = Extras(timeline=shown.timeline, timeline_text=shown.timeline_text, is_graded=True)
        card = as_markup(as_html(shown.judgement, extras))
    return render(
        "lesson/replay",
        title=f"{exercise.source.title}: a report",
        text_colors=TEXT_COLORS,
        notes=shown.notes(),
        card=card,
        happened=shown.happened(),
        doctor=shown.report.doctor,
        answer=shown.report.answer,
    )

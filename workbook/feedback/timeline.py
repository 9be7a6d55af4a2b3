"""The picture on a card: when messages were expected and when they came."""

from workbook.exercise.definition import Exercise
from workbook.observing.recording import Recording
from workbook.pictures import timeline


def judged_timeline(exercise: Exercise, recording: Recording) -> tuple[bytes, str]:
    """A timeline of the judged topics as PNG bytes, and the same in words."""
    periods = {name: period for name, period in exercise.periods.items() if recording.topic(name).publishers}
    return timeline.timeline(recording, periods=periods), timeline.describe(recording, periods)

"""The picture on a card: when messages were expected and when they came."""

from workbook.exercise.definition import Exercise
from workbook.recording.recording import Recording


def judged_timeline(exercise: Exercise, recording: Recording) -> tuple[bytes, str]:
    """A timeline of the judged topics as PNG bytes, and the same in words."""
    # Matplotlib takes half a second to import: too long for a grader that draws nothing yet, and may never.
    from workbook.pictures import timeline

    periods = {name: period for name, period in exercise.periods.items() if recording.topic(name).publishers}
    return timeline.timeline(recording, periods=periods), timeline.describe(recording, periods)

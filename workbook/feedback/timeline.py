"""Draw a card's figure, which shows when messages were expected and when they arrived."""

from workbook.exercise.definition import Exercise
from workbook.feedback.colors import ON_LIGHT
from workbook.recording.recording import Recording


def judged_timeline(exercise: Exercise, recording: Recording) -> tuple[bytes, str]:
    """Return a timeline of the judged topics as PNG bytes, and its description in words."""
    # Importing Matplotlib takes half a second: too long for grading, which may never draw anything.
    from workbook.pictures import timeline

    periods = {name: period for name, period in exercise.periods.items() if recording.topic(name).publishers}
    ink = ON_LIGHT["skipped"]  # a dark background inverts the image
    return timeline.timeline(recording, periods=periods, ink=ink), timeline.describe(recording, periods)

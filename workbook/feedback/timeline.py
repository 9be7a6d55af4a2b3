"""Draw a card's timeline, a figure that shows when messages were expected and when they arrived."""

from workbook.exercise.definition import Exercise
from workbook.feedback.colors import ON_LIGHT
from workbook.recording.recording import Recording


def judged_timeline(exercise: Exercise, recording: Recording) -> tuple[bytes, str]:
    """Return a timeline of the topics with judged rates as PNG bytes, and its description in words."""
    # Importing Matplotlib takes half a second, which is too long for grading, because it may never draw anything.
    from workbook.pictures import timeline

    periods = {name: period for name, period in exercise.periods.items() if recording.topic(name).publishers}
    ink = ON_LIGHT["skipped"]  # a dark background inverts the image
    return timeline.timeline(recording, periods=periods, ink=ink), timeline.describe(recording, periods)

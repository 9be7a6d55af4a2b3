"""Measure a program's CPU use."""

from workbook.recording.recording import Recording


def processor_share(
    recording: Recording, begin: float | None = None, end: float | None = None
) -> float | None:
    """Return the average fraction of one processor (1.0: all of it) that the program used between two wall times (s).

    The result is None if the recording has fewer than two samples in that span.
    """
    samples = [
        (wall, used)
        for wall, used in recording.process.processor
        if (begin is None or wall >= begin) and (end is None or wall <= end)
    ]
    if len(samples) < 2 or samples[-1][0] <= samples[0][0]:
        return None
    return (samples[-1][1] - samples[0][1]) / (samples[-1][0] - samples[0][0])

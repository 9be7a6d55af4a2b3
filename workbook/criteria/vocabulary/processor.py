"""Measures the processor time that a program uses."""

from workbook.recording.recording import Recording


def processor_share(
    recording: Recording, begin: float | None = None, end: float | None = None
) -> float | None:
    """Share of one processor (1.0: all of it) that the program used between two moments of wall time (s).

    None when the recording holds fewer than two samples from then.
    """
    samples = [
        (wall, used)
        for wall, used in recording.process.processor
        if (begin is None or wall >= begin) and (end is None or wall <= end)
    ]
    if len(samples) < 2 or samples[-1][0] <= samples[0][0]:
        return None
    return (samples[-1][1] - samples[0][1]) / (samples[-1][0] - samples[0][0])

"""Remove from a recording the pauses in which the machine kept the judge itself from running."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise

from workbook.recording.recording import Arrival, Recording


def without_standstills(recording: Recording, period_s: float, longest_s: float) -> Recording:
    """Return the recording without the pauses in which the judge couldn't publish its messages.

    The cause of such a pause most likely held up the program, too, so the program's messages weren't as late as they
    look. `period_s`: the script's period (s). `longest_s`: the longest time (s) between two of the script's messages
    that isn't such a pause.
    """

    def moments(sent: Sequence[float]) -> Callable[[float], float]:
        """Return a function that subtracts all earlier pauses from a time (s). `sent`: the publication times (s)."""
        still = [(a, b - a - period_s) for a, b in pairwise(sorted(sent)) if b - a > longest_s]
        return lambda at: at - sum(min(max(at - begin, 0.0), lasted) for begin, lasted in still)

    on_wall = moments([one.wall for one in recording.published])
    on_simulated = moments([one.t for one in recording.published])

    def moved(one: Arrival) -> Arrival:
        sent = None if one.sent is None else on_wall(one.sent)
        return replace(one, t=on_simulated(one.t), wall=on_wall(one.wall), sent=sent)

    topics = {
        name: replace(
            one,
            arrivals=tuple(map(moved, one.arrivals)),
            window=one.window and (on_simulated(one.window[0]), on_simulated(one.window[1])),
        )
        for name, one in recording.topics.items()
    }
    published = [replace(one, t=on_simulated(one.t), wall=on_wall(one.wall)) for one in recording.published]
    return replace(recording, topics=topics, published=tuple(published))

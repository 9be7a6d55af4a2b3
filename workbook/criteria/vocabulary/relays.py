"""Compare a program's outputs with its inputs, to find outputs that are missing, repeated, late, or out of order."""

from collections import Counter
from collections.abc import Hashable, Sequence
from statistics import median
from typing import Generic, TypeVar

Item = TypeVar("Item", bound=Hashable)


class Relay(Generic[Item]):
    """A comparison of a program's outputs with its inputs.

    An *item* is a reading, a request, or an index in the script.

    `sent`: all items, in order. `came`: the item of each output, in order. An item is missing if it came less often
    than it was sent, and repeated if it came more often.
    """

    def __init__(self, sent: Sequence[Item], came: Sequence[Item]) -> None:
        self.sent, self.came = [*sent], [*came]
        due, times = Counter(self.sent), Counter(self.came)
        self.answered = [one for one in due if one in times]
        self.missing = [one for one in due if times[one] < due[one]]
        self.repeated = [
            (one, n) for one, n in times.items() if n > due[one] > 0
        ]  # each with its number of outputs
        self.strange = [one for one in self.came if one not in due]  # never sent
        # the first output with the wrong item: its number (from 1), its item, and the item that was due
        pairs = enumerate(zip(self.came, self.sent, strict=False), 1)
        self.misplaced = next(((n, one, other) for n, (one, other) in pairs if one != other), None)

    @property
    def rest_is_missing(self) -> bool:
        """Whether the outputs were cut off: an item is missing, and all items after it are missing, too."""
        order = list(dict.fromkeys(self.sent))
        return bool(self.missing) and self.missing == order[-len(self.missing) :]

    @property
    def stops(self) -> bool:
        """Whether items are missing at the end, and all earlier items came in order and without repetition."""
        return bool(self.missing) and self.came == self.sent[: len(self.came)]


class Waits:
    """The times (s) for which inputs waited for their outputs, in the order of the inputs.

    An output is late if the wait was longer than `at_once_s`.
    """

    def __init__(self, seconds: Sequence[float], at_once_s: float) -> None:
        self.seconds = [*seconds]
        self.late = [one for one in seconds if one > at_once_s]
        tenth = max(len(seconds) // 10, 1)
        # the median of all waits, of the first tenth, and of the last tenth; 0 if there are no waits
        self.typical_s, self.first_s, self.last_s = (
            median(some or [0.0]) for some in (seconds, seconds[:tenth], seconds[-tenth:])
        )

    def are_late(self, share: float) -> bool:
        """Return whether the fraction of outputs that were on time is below `share`.

        Choose a `share` below 1, because a busy machine may have delayed some of the outputs.
        """
        return len(self.late) > (1.0 - share) * len(self.seconds)

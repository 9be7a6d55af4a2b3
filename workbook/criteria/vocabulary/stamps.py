"""Read the timestamps in message headers, which show which input an output belongs to."""

from typing import Any, NamedTuple


class Stamp(NamedTuple):
    """A timestamp in seconds and nanoseconds, as in `builtin_interfaces/Time`. `_asdict()` returns the fields."""

    sec: int
    nanosec: int

    @classmethod
    def at(cls, seconds: float) -> "Stamp":
        """Return the timestamp for a time in seconds."""
        return cls(*divmod(round(seconds * 1e9), 10**9))

    @classmethod
    def of(cls, message: Any) -> "Stamp":
        """Return the timestamp in a message's header. `message` is a mapping of the message's fields."""
        stamp = message["header"]["stamp"]
        return cls(stamp["sec"], stamp["nanosec"])

    @property
    def seconds(self) -> float:
        """The timestamp in seconds."""
        return self.sec + self.nanosec / 1e9

"""Read the timestamps in headers, which identify the input that an output belongs to."""

from typing import Any, NamedTuple


class Stamp(NamedTuple):
    """A timestamp in seconds and nanoseconds, like `builtin_interfaces/Time`. `_asdict()` returns its fields."""

    sec: int
    nanosec: int

    @classmethod
    def at(cls, seconds: float) -> "Stamp":
        """Make the timestamp for a moment (s)."""
        return cls(*divmod(round(seconds * 1e9), 10**9))

    @classmethod
    def of(cls, message: Any) -> "Stamp":
        """Read the timestamp in a message's header."""
        stamp = message["header"]["stamp"]
        return cls(stamp["sec"], stamp["nanosec"])

    @property
    def seconds(self) -> float:
        """The timestamp in seconds."""
        return self.sec + self.nanosec / 1e9

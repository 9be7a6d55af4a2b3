"""How much of what others publish is kept: so many messages and bytes, for one topic or for several together."""


class MessageQuota:
    """Room for messages. Once one does not fit, nothing more is kept, so that what is there has no gap."""

    def __init__(self, most_bytes: int, most_messages: int) -> None:
        self.most_bytes = most_bytes
        self._most_messages = most_messages
        self.clear()

    def clear(self) -> None:
        """All of it is free again."""
        self._bytes = self.most_bytes
        self._messages = self._most_messages
        self.is_short_of_bytes = self._is_full = False

    def take(self, size: int, messages: int = 1) -> bool:
        """Take `size` bytes and so many messages. Returns False when they are not there any more."""
        if not self._is_full:
            self.is_short_of_bytes = size > self._bytes
            self._is_full = self.is_short_of_bytes or messages > self._messages
        if not self._is_full:
            self._bytes -= size
            self._messages -= messages
        return not self._is_full

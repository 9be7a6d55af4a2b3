"""Limit the kept messages of other programs by number and bytes, for one topic or for several together."""


class MessageQuota:
    """A quota for kept messages.

    Once a message doesn't fit, no later message is kept, so that the kept ones have no gap.
    """

    def __init__(self, most_bytes: int, most_messages: int) -> None:
        self.most_bytes = most_bytes
        self._most_messages = most_messages
        self.clear()

    def clear(self) -> None:
        """Reset the quota."""
        self._bytes = self.most_bytes
        self._messages = self._most_messages
        self.is_short_of_bytes = self._is_full = False

    def take(self, size: int, messages: int = 1) -> bool:
        """Use up `size` bytes and a number of messages. Return False if the quota is exhausted."""
        if not self._is_full:
            self.is_short_of_bytes = size > self._bytes
            self._is_full = self.is_short_of_bytes or messages > self._messages
        if not self._is_full:
            self._bytes -= size
            self._messages -= messages
        return not self._is_full

"""Limit the number and total size of the messages that we keep, for one topic or for several topics together."""


class MessageQuota:
    """A quota for the messages that we keep.

    Once a message doesn't fit, no later message is kept either, so the kept messages have no gaps.
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
        """Take `size` bytes and a number of messages from the quota.

        Return False if they don't fit, or if any earlier ones didn't fit.
        """
        if not self._is_full:
            self.is_short_of_bytes = size > self._bytes
            self._is_full = self.is_short_of_bytes or messages > self._messages
        if not self._is_full:
            self._bytes -= size
            self._messages -= messages
        return not self._is_full

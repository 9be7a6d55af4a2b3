"""What processes that fork others on request have in common: how requests come in, and how they are answered."""

import json
import os
import select
import socket
from collections.abc import Callable, Iterable, Iterator
from typing import Any

REQUEST_BYTES = 100_000
DESCRIPTORS = 4

Request = tuple[dict[str, Any], list[int]]
"""What is asked for, and the descriptors that came with it. The first one is for the answer."""


def requests(
    channel: socket.socket, ended: int | None = None, look_after_ended: Callable[[], None] = lambda: None
) -> Iterator[Request]:
    """Yield one request after another until the other end of the channel is closed.

    `ended` can be read when a child has ended; then `look_after_ended` is called. Whoever uses a request has to close
    its descriptors.
    """
    while True:
        if ended is not None:
            ready, _, _ = select.select([channel.fileno(), ended], [], [])
            if ended in ready:
                os.read(ended, 1000)
                look_after_ended()
            if channel.fileno() not in ready:
                continue
        try:
            data, descriptors, _, _ = socket.recv_fds(channel, REQUEST_BYTES, DESCRIPTORS)
        except ConnectionError:
            return
        if not data:
            return
        yield json.loads(data), descriptors


def report(status: int, text: str) -> bool:
    """Write `text` to the process that made a request. Returns False when that process is gone."""
    try:
        os.write(status, text.encode())
    except OSError:
        return False
    return True


def close_all(descriptors: Iterable[int]) -> None:
    """Close descriptors."""
    for descriptor in descriptors:
        os.close(descriptor)

"""Receive requests and report results in processes that fork other processes on request."""

import json
import os
import select
import socket
from collections.abc import Callable, Iterable, Iterator
from typing import Any

REQUEST_BYTES = 100_000
DESCRIPTORS = 4

Request = tuple[dict[str, Any], list[int]]
"""A request's content and the descriptors that came with it. The first descriptor is for the reply."""


def requests(
    channel: socket.socket, ended: int | None = None, look_after_ended: Callable[[], None] = lambda: None
) -> Iterator[Request]:
    """Yield one request after another until the other end of the channel is closed.

    `ended`: a descriptor that becomes readable when a child exits, or None. Each time it becomes readable,
    `look_after_ended` is called. The caller must close each request's descriptors.
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
    """Write `text` to the descriptor `status`. Return False if the process that made the request is gone."""
    try:
        os.write(status, text.encode())
    except OSError:
        return False
    return True


def close_all(descriptors: Iterable[int]) -> None:
    """Close these descriptors."""
    for descriptor in descriptors:
        os.close(descriptor)

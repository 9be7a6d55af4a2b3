"""Connect to a farm's dask.distributed scheduler, and fetch the workers' replies."""

import asyncio
import json
import logging
import re
import time
from typing import Any

from workbook.exercise.serialization import no_constant
from workbook.grading.judges import NoJudges

CONNECT_S = 10.0
FETCH_S = 30.0
LOOK_EVERY_S = 1.0
LARGEST_REPLY = 300_000_000
"""The maximum length of a reply, in characters. It's large because a recording may contain thousands of messages."""
_ADDRESS = re.compile(r"(tcp|tls)://(\[[0-9A-Fa-f:.]+\]|[\w.-]+):\d{1,5}")


def check_address(address: str) -> None:
    """Raise NoJudges if a scheduler's address is invalid."""
    if not _ADDRESS.fullmatch(address):
        raise NoJudges(f"--farm {address}: write it as tcp://host:8786, as the scheduler prints it")


def connect(address: str) -> Any:
    """Connect to the scheduler, and return the client. Raises NoJudges if that fails."""
    try:
        from distributed import Client, Security
    except ImportError as error:
        raise NoJudges(
            f"--farm needs the package dask.distributed ({error}). Install it here and on the machines of the farm: "
            "make env EXTRAS=farm"
        ) from error
    for name in [*logging.root.manager.loggerDict]:
        if name.split(".")[0] in ("distributed", "tornado"):  # for developers; we report what matters
            logging.getLogger(name).setLevel(logging.CRITICAL + 1)
    try:
        security = Security()
        if address.startswith("tls:") and security.get_connection_args("client").get("ssl_context") is None:
            raise NoJudges("--farm tls://... needs certificates: see 'A farm' in exercises/README.md")
        client = Client(
            address,
            security=security,
            timeout=CONNECT_S,
            name="workbook-grade",
            set_as_default=False,
            direct_to_workers=False,
        )
        client.loop.asyncio_loop.set_exception_handler(quiet_about_lost_waits)
        return client
    except NoJudges:
        raise
    except Exception as error:
        raise NoJudges(
            f"no scheduler answers at {address} within {CONNECT_S:.0f} s ({in_words(error)}). Start one in the "
            "course's folder, .venv/bin/dask scheduler, and look at the firewall between you and it"
        ) from error


def quiet_about_lost_waits(loop: asyncio.AbstractEventLoop, context: dict[str, Any]) -> None:
    """Ignore an event loop's exceptions from canceled waits for lost replies. Handle all other exceptions as usual.

    If a worker is lost while we're fetching its reply, the `distributed` library waits for the reply again. When we
    give up and cancel the reply, that wait fails with AllExit, and our code can't catch this exception.
    """
    if type(context.get("exception")).__name__ != "AllExit":
        loop.default_exception_handler(context)


def _fetch(future: Any) -> object:
    """Fetch the reply of a finished task.

    Raises RuntimeError if the worker is known to be lost or if fetching takes longer than FETCH_S seconds.
    """

    async def fetched() -> object:
        return await future.client.gather(future, asynchronous=True)

    deadline = time.monotonic() + FETCH_S
    reply = asyncio.run_coroutine_threadsafe(fetched(), future.client.loop.asyncio_loop)
    while True:
        try:
            return reply.result(timeout=LOOK_EVERY_S)
        except TimeoutError:
            if future.status != "finished" or time.monotonic() > deadline:
                reply.cancel()
                raise RuntimeError("the worker was lost before it could return the judgment") from None


def text_of(future: Any) -> str:
    """Return a worker's reply, which is a string. Raises RuntimeError if there's no valid reply."""
    if future.status != "finished":
        error = future.exception(timeout=FETCH_S) if future.status == "error" else None
        raise RuntimeError(in_words(error) if error is not None else f"the work was {future.status}")
    text = _fetch(future)
    if not isinstance(text, str) or len(text) > LARGEST_REPLY:
        raise RuntimeError("the reply is not text, or far too much of it")
    return text


def reply_in(text: str) -> dict[str, Any]:
    """Parse a reply. Raises ValueError if it isn't valid JSON or has none of the known keys."""
    reply = json.loads(text, parse_constant=no_constant)
    if not isinstance(reply, dict) or not reply.keys() & {"judgement", "refused", "fault", "elsewhere"}:
        raise ValueError("the reply is damaged")
    return reply


def in_words(error: BaseException) -> str:
    """Return the first line of an error's message, or the error's type if the message is empty."""
    first = "".join(one for one in str(error).strip().split("\n")[0][:200] if one.isprintable())
    return first or type(error).__name__

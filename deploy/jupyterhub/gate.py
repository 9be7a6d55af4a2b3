"""Start a command in its own network namespace, and forward two TCP ports: in to its server, and out to the hub.

    python -I -S gate.py --server PORT --hub PORT [--processes N] [--join FILE ...] -- COMMAND ...

The namespace contains only a loopback interface, so no DDS packet gets out, and only the hub's port can be reached from
inside. A socket belongs to the namespace of the thread that created it, so one thread enters the namespace and creates
sockets there. The command ends with this process, which must run as root. The process never inspects the bytes that it
forwards.
"""

import argparse
import asyncio
import ctypes
import fcntl
import os
import resource
import signal
import socket
import struct
import subprocess
import sys
import threading
from collections.abc import Awaitable, Callable
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from functools import partial
from typing import IO

LOOPBACK = "127.0.0.1"
CLONE_NEWNET = 0x40000000
SIOCSIFFLAGS = 0x8914
IFF_UP = 0x1
CHUNK_BYTES = 1 << 16
LONGEST_OUTPUT = 1 << 20
"""How many bytes of a server's output reach the hub's log. With more, a student could fill the disk."""

Connect = Callable[[], Awaitable[socket.socket]]


def enter_network() -> None:
    """Move this thread into a new network namespace, and bring loopback up. Raise OSError if that fails."""
    libc = ctypes.CDLL(None, use_errno=True)
    if libc.unshare(CLONE_NEWNET) != 0:
        raise OSError(ctypes.get_errno(), "no network of its own")
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:
        fcntl.ioctl(any_socket, SIOCSIFFLAGS, struct.pack("16sh14x", b"lo", IFF_UP))


async def copy(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
    """Forward all bytes, and then the end of the stream."""
    try:
        while data := await reader.read(CHUNK_BYTES):
            writer.write(data)
            await writer.drain()
        writer.write_eof()
    except OSError:
        writer.close()


async def listen(listener: socket.socket, connect: Connect) -> None:
    """Accept connections on `listener`, and forward each to a new connection from `connect`."""

    async def serve(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        try:
            far_reader, far_writer = await asyncio.open_connection(sock=await connect())
            await asyncio.gather(copy(reader, far_writer), copy(far_reader, writer))
            far_writer.close()
        except OSError:  # the server isn't listening yet
            pass
        finally:
            writer.close()

    await asyncio.start_server(serve, sock=listener)


def copy_output(source: IO[bytes]) -> None:
    """Copy the beginning of the server's output to ours, and discard the rest."""
    left = LONGEST_OUTPUT
    while data := os.read(source.fileno(), CHUNK_BYTES):
        with suppress(OSError):  # the hub that read our output has ended
            os.write(1, data[:left])
        left -= len(data[:left])


async def run(server: int, hub: int, command: list[str]) -> int:
    """Run the command inside the namespace, with both ports forwarded. Return its exit code."""
    loop = asyncio.get_running_loop()
    inside = ThreadPoolExecutor(1, initializer=enter_network)

    async def connected(made: socket.socket, port: int) -> socket.socket:
        made.setblocking(False)
        await loop.sock_connect(made, (LOOPBACK, port))
        return made

    async def to_server() -> socket.socket:
        return await connected(await loop.run_in_executor(inside, socket.socket), server)

    async def to_hub() -> socket.socket:
        return await connected(socket.socket(), hub)

    def listener(port: int) -> socket.socket:
        return socket.create_server((LOOPBACK, port))

    await listen(listener(server), to_server)
    await listen(await loop.run_in_executor(inside, listener, hub), to_hub)
    popen = partial(subprocess.Popen, command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    started = await loop.run_in_executor(inside, popen)
    assert started.stdout is not None
    threading.Thread(target=copy_output, args=[started.stdout], daemon=True).start()
    return await loop.run_in_executor(None, started.wait)


def main() -> int:
    """Parse the command line, apply the limits, and run the command."""
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.SIG_DFL)  # the kernel ends the command with this process
    parser = argparse.ArgumentParser()
    parser.add_argument("--server", type=int, required=True)
    parser.add_argument("--hub", type=int, required=True)
    parser.add_argument("--processes", type=int)
    parser.add_argument("--join", action="append", default=[])
    parser.add_argument("command", nargs="+")
    asked = parser.parse_args()
    for group in asked.join:
        with open(group, "w") as file:
            file.write(str(os.getpid()))
    if asked.processes is not None:
        resource.setrlimit(resource.RLIMIT_NPROC, (asked.processes, asked.processes))
    return asyncio.run(run(asked.server, asked.hub, asked.command))


if __name__ == "__main__":
    sys.exit(main())

"""Define the limits on the resources that an answer may use.

Messages take the values from here, so they match the limits that are enforced.
"""

from dataclasses import dataclass

MB = 1_000_000
WRITABLE_MIB = 64
"""The size (MiB) of each folder that a sandboxed program may write to."""

FLOOD_MESSAGES, FLOOD_S = 500, 1.0
"""A topic counts as flooded if this many messages arrive within this time (simulated time, in seconds).

The busiest correct answer sends 25 messages in that time.
"""


@dataclass(frozen=True)
class Limits:
    """The limits of a program, in bytes, counts, or seconds of CPU time. None means no limit.

    Some limits apply to a program and its child processes together: `processes`, `threads`, `memory`, `kernel`,
    `descriptors`, `watches`, `files`, `sockets`, `queued`, and `stored`. The other limits apply to each process.

    `processes` also counts threads where the kernel enforces that limit. `signals` counts pending timers and signals.
    `kernel` is the memory, in bytes, that the kernel allocates for the program. `watches` counts the entries of the
    program's epoll instances. `files` applies to each folder that the program may write to. `queued` counts unread
    bytes in the program's sockets. `stored` counts the bytes that the program writes to file systems that it shares
    with others. `output` limits the printed output, in bytes.
    """

    memory: int | None = None
    file_size: int | None = None
    open_files: int | None = None
    cpu: int | None = None
    core: int | None = None
    signals: int | None = None
    processes: int | None = None
    threads: int | None = None
    kernel: int | None = None
    descriptors: int | None = None
    watches: int | None = None
    files: int | None = None
    sockets: int | None = None
    queued: int | None = None
    stored: int | None = None
    output: int = 50 * MB


THREADS_PER_CORE = 4
"""The number of threads per processor that a program's libraries may start.

PyTorch, OpenCV, and OpenBLAS each start one thread per processor.
"""
ENDED_PROCESSES = 256
"""The number of zombies that a program may have. A zombie still has a process ID, but uses hardly any memory."""
ADDRESSES_PER_THREAD = 72 * MB
"""The address space, in bytes, that a thread reserves for its stack and its part of the heap. It's rarely used."""
NO_LIMITS = Limits()
"""The limits for students' own programs, which are limited only in their printed output."""
ANSWER_LIMITS = Limits(
    memory=2500 * MB,
    file_size=100 * MB,
    open_files=512,
    cpu=60,
    core=1,  # too small for a core file; 0 wouldn't keep the kernel from piping core files to a program
    signals=1000,
    processes=64,  # a node takes about 16
    threads=1500,  # some machines have only 32,768 IDs for all threads
    kernel=100
    * MB,  # 64 processes take 35 MB; an epoll instance takes 0.2 kB for each descriptor that it watches
    descriptors=4000,  # a node takes about 25
    watches=4000,  # a node has about ten; a user gets some 100,000 for each GB of the machine's memory
    files=20_000,
    sockets=256,  # a node takes about ten, and the messages in all sockets share one limit of the machine
    queued=32 * MB,
    stored=200 * MB,  # the size of a sandbox's folders together
)
"""The limits of a graded answer."""

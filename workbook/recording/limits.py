"""Define the resources that an answer may use. Code that enforces the limits and messages use the same values."""

from dataclasses import dataclass

MB = 1_000_000
WRITABLE_MIB = 64
"""The size (MiB) of each folder that a sandboxed program may write to."""

FLOOD_MESSAGES, FLOOD_S = 500, 1.0
"""A topic is flooded if this many messages arrive within this time (seconds of simulated time).

The busiest correct answer sends 25 messages in that time.
"""


@dataclass(frozen=True)
class Limits:
    """The limits of a program, as bytes, counts, and seconds of CPU time. If a value is None, there is no limit.

    Some limits apply to a program and its child processes together: `processes`, `threads`, `memory`, `kernel`,
    `descriptors`, `watches`, `files`, `sockets`, `queued`, and `stored`. The others apply to each process. `processes`
    also counts threads where the kernel enforces that limit, and `signals` counts pending timers and signals. `kernel`
    is memory that the kernel allocates for the program. `watches` counts the entries of the program's epoll instances.
    `files` applies to each folder that the program may write to. `queued` counts unread bytes in the program's sockets.
    `stored` counts bytes that the program writes to shared file systems. `output` limits the printed output (bytes).
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
"""How many threads per processor a program may need: PyTorch, OpenCV, and OpenBLAS each start one per processor."""
ENDED_PROCESSES = 256
"""How many zombies may wait for their parent. An ended process keeps its process ID, but uses hardly any memory."""
ADDRESSES_PER_THREAD = 72 * MB
"""Address space (bytes) that a thread reserves for its stack and its part of the heap, but hardly ever uses."""
NO_LIMITS = Limits()
"""The reader's own programs have no limits, except on their printed output."""
ANSWER_LIMITS = Limits(
    memory=2500 * MB,
    file_size=100 * MB,
    open_files=512,
    cpu=60,
    core=1,  # too small for a core file; with 0, a kernel that pipes core files to a program would still do so
    signals=1000,
    processes=64,  # a node takes about 16
    threads=1500,  # some machines have only 32,768 IDs for all threads
    kernel=100
    * MB,  # 64 processes take 35 MB; an epoll instance takes 0.2 kB for each descriptor that it watches
    descriptors=4000,  # a node takes about 25
    watches=4000,  # a node has about ten; a user gets some 100,000 for each GB of the machine's memory
    files=20_000,
    sockets=256,  # a node takes about ten, and sockets' queued messages share one limit of the machine
    queued=32 * MB,
    stored=200 * MB,  # the size of a sandbox's folders together
)
"""The limits of a graded answer."""

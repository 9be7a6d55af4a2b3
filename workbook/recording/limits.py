"""What one answer may use of a machine: the values that are enforced and that messages are formatted from."""

from dataclasses import dataclass

MB = 1_000_000
WRITABLE_MIB = 64
"""Room in each folder that a program in a sandbox may write to."""

FLOOD_MESSAGES, FLOOD_S = 500, 1.0
"""So many messages of a topic within so long (s of simulated time) are a flood. The busiest right answer sends 25."""


@dataclass(frozen=True)
class Limits:
    """Limits of one program: bytes, numbers, and seconds of processor time. None: no limit.

    `processes`, `threads`, `memory`, `kernel`, `descriptors`, `watches`, `files`, `sockets`, `queued` and `stored` hold
    for a program and all that it has started, the others for each process. `processes` counts threads as well where the
    kernel enforces it, and `signals` counts timers and signals that wait. `kernel` is memory that the kernel keeps for
    the program, `watches` is what its epoll instances wait for, `files` is for each folder that it may write to,
    `queued` is what its sockets hold that nobody has read, `stored` what it writes to files where no file system of its
    own bounds them, and `output` is what it may print.
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
"""Libraries such as PyTorch, OpenCV and OpenBLAS start a thread for each processor, each for itself."""
ENDED_PROCESSES = 256
"""So many processes may have ended without a parent that has asked how: each takes a number, and hardly any memory."""
ADDRESSES_PER_THREAD = 72 * MB
"""Address space that a thread reserves for its stack and its part of the heap, of which it uses hardly any."""
NO_LIMITS = Limits()
"""What a program of the reader may use: as much as it wants, but for what it prints."""
ANSWER_LIMITS = Limits(
    memory=2500 * MB,
    file_size=100 * MB,
    open_files=512,
    cpu=60,
    core=1,  # no core file fits into one byte; with 0, a kernel that hands them to a program would do so all the same
    signals=1000,
    processes=64,  # a node takes about 16
    threads=1500,  # of 32,768 numbers that some machines have for all of them
    kernel=100
    * MB,  # 64 processes take 35; an epoll instance takes 0.2 kB for each descriptor that it watches
    descriptors=4000,  # a node takes about 25
    watches=4000,  # a node has about ten; all users of a machine have some 100,000 for each GB of its memory
    files=20_000,
    sockets=256,  # a node takes about ten, and all that wait for messages share one figure of the machine
    queued=32 * MB,
    stored=200 * MB,  # as much as the folders in a sandbox hold
)
"""What an answer may use that is graded."""

"""Read information from /proc: about processes, threads, sockets, users, and processors.

If a process has exited, a function returns an empty result, zero, or None, or it raises OSError, as its docstring says.
"""

import os
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress

_PAGE_BYTES = os.sysconf("SC_PAGE_SIZE")
_TICK_S = 1.0 / os.sysconf("SC_CLK_TCK")
_IDLE, _STEAL = slice(3, 5), 7  # columns of /proc/stat
READ_BYTES = 65_536
PROC_STAT = "/proc/stat"
UDP_TABLES = ("/proc/net/udp", "/proc/net/udp6")
UNIX_SOCKETS = "/proc/net/unix"
SOCKET_TOTALS = "/proc/net/sockstat"
OWN_GROUPS = "/proc/self/cgroup"
OWN_MOUNTS = "/proc/self/mountinfo"
OWN_OOM_SCORE = "/proc/self/oom_score_adj"
QUEUE_TABLES = (*UDP_TABLES, "/proc/net/tcp", "/proc/net/tcp6")


def read(path: str) -> bytes:
    """Read a small file in /proc. Raises OSError if the file's process has exited.

    This function is called many times per second. A file object would make twice as many system calls, and a `Path`
    even more.
    """
    descriptor = os.open(path, os.O_RDONLY | os.O_CLOEXEC)
    try:
        content = os.read(descriptor, READ_BYTES)
        while more := os.read(descriptor, READ_BYTES):
            content += more
        return content
    finally:
        os.close(descriptor)


def _read_if_there(path: str) -> bytes:
    try:
        return read(path)
    except OSError:
        return b""


def _number_after(name: bytes, path: str) -> int:
    lines = _read_if_there(path).splitlines()
    return next((int(line.split()[1]) for line in lines if line.startswith(name)), 0)


def read_text(path: str) -> str:
    """Read a text file of any size. Raises OSError if it can't be read."""
    with open(path, encoding="utf-8", errors="replace") as file:
        return file.read()


# --- processes ------------------------------------------------------------------------------------------------


def pids() -> list[int]:
    """Return the IDs of all processes that are visible to this process."""
    return [int(entry) for entry in os.listdir("/proc") if entry.isdigit()]


def tasks(pid: int) -> list[str]:
    """Return the IDs of a process's threads, or an empty list if the process has exited."""
    with suppress(OSError):
        return os.listdir(f"/proc/{pid}/task")
    return []


def children(pid: int) -> list[int]:
    """Return the child processes that `pid` has started or adopted, or an empty list if `pid` has exited."""
    found: list[int] = []
    for task in tasks(pid):
        with suppress(OSError):
            found += map(int, read(f"/proc/{pid}/task/{task}/children").split())
    return found


def process_tree(pid: int) -> list[int]:
    """Return `pid` and all its descendants."""
    tree = {pid: None}
    waiting = [pid]
    while waiting:
        born = [child for child in children(waiting.pop()) if child not in tree]
        tree.update(dict.fromkeys(born))
        waiting += born
    return [*tree]


def command_line(pid: int) -> bytes:
    """Return a process's command line, with a zero byte after each part, or b"" if the process has exited."""
    return _read_if_there(f"/proc/{pid}/cmdline")


def environment(pid: int) -> list[bytes]:
    """Return a process's original environment (`NAME=VALUE`).

    The list is empty if the process has exited or if we may not read its environment.
    """
    content = _read_if_there(f"/proc/{pid}/environ")
    return content.split(b"\0") if content else []


def status(pid: int | str = "self") -> dict[str, str]:
    """Return the fields of /proc/PID/status by name. Raises OSError if the process has exited."""
    lines = read(f"/proc/{pid}/status").decode(errors="replace").splitlines()
    fields = (line.partition(":") for line in lines)
    return {name: value.strip() for name, _, value in fields}


def stat_fields(pid: int | str = "self") -> list[bytes]:
    """Return the fields of /proc/PID/stat, beginning with the third one, the state (see proc(5)).

    Raises OSError if the process has exited.
    """
    return read(f"/proc/{pid}/stat").rsplit(b")", 1)[1].split()


def owner(pid: int) -> int | None:
    """Return a process's user ID, or None if the process has exited."""
    with suppress(OSError):
        return os.stat(f"/proc/{pid}").st_uid
    return None


def running_users() -> list[tuple[int, int]]:
    """Return the process ID and the real user ID of every running process. Zombies are left out."""
    found = []
    for pid in pids():
        try:
            fields = status(pid)
        except OSError:
            continue
        if fields["State"].split()[0] not in "ZX":
            found.append((pid, int(fields["Uid"].split()[0])))
    return found


# --- what processes use ---------------------------------------------------------------------------------------


def processor_seconds(group: Iterable[int]) -> float | None:
    """Return the CPU time, in seconds, that these processes have used, or None if all of them have exited."""
    used = []
    for pid in group:
        with suppress(OSError):
            used.append(sum(map(int, stat_fields(pid)[11:13])))
    return sum(used) * _TICK_S if used else None


def run_queue_s(pid: int) -> float:
    """Return the time, in seconds, that a process's first thread has waited for a processor.

    Return zero if the process has exited.
    """
    return ran_and_waited_s(pid)[1]


def ran_and_waited_s(pid: int) -> tuple[float, float]:
    """Return the times, in seconds, that a process's first thread has run and has waited for a processor.

    Return zeros if the process has exited.
    """
    # https://docs.kernel.org/scheduler/sched-stats.html
    try:
        ran, waited, *_ = map(int, read(f"/proc/{pid}/schedstat").split())
    except (OSError, ValueError):
        return 0.0, 0.0
    return ran / 1e9, waited / 1e9


def resident_bytes(pid: int) -> int:
    """Return a process's resident memory in bytes, including shared memory, or zero if the process has exited."""
    try:
        return int(read(f"/proc/{pid}/statm").split()[1]) * _PAGE_BYTES
    except (OSError, IndexError):
        return 0


def written_bytes(pid: int) -> int:
    """Return the number of bytes that a process and its reaped children have written with system calls.

    Return zero if the process has exited. Source: proc_pid_io(5), `wchar`.
    """
    return _number_after(b"wchar:", f"/proc/{pid}/io")


def proportional_bytes(pid: int) -> int:
    """Return a process's proportional set size (PSS) in bytes, or zero if the process has exited. This call is slow."""
    return 1024 * _number_after(b"Pss:", f"/proc/{pid}/smaps_rollup")


def memory_bytes(group: Sequence[int], worth_counting: int) -> int:
    """Return the memory, in bytes, that these processes use together.

    Memory that the processes share, such as after a fork, counts only once. But the exact number is slow to compute. If
    an upper bound is at most `worth_counting` bytes, return that upper bound instead.
    """
    rough = sum(map(resident_bytes, group))
    return rough if rough <= worth_counting else sum(map(proportional_bytes, group))


def available_memory_bytes() -> int:
    """Return the number of bytes of memory that programs can still use without swapping.

    Return zero if that's unknown. See proc_meminfo(5).
    """
    return 1024 * _number_after(b"MemAvailable:", "/proc/meminfo")


def own_groups(table: str = OWN_GROUPS) -> list[tuple[str, str, str]]:
    """Return each cgroup hierarchy's number and controllers, and this process's path in it.

    Return an empty list if there are no hierarchies.
    """
    try:
        rows = [line.split(":", 2) for line in read_text(table).splitlines()]
    except OSError:
        return []
    return [(number, controllers, path) for number, controllers, path in rows]


def mounted(kind: str, table: str = OWN_MOUNTS) -> list[tuple[str, str, list[str]]]:
    """Return the root, mount point, and options of each mounted file system of this kind.

    Return an empty list if that's unknown.
    """
    try:
        rows = [line.split() for line in read_text(table).splitlines()]
    except OSError:
        return []
    found = [(row, row.index("-")) for row in rows if "-" in row]
    return [(row[3], row[4], row[after + 3].split(",")) for row, after in found if row[after + 1] == kind]


def mount_usage(pid: int, folder: str) -> os.statvfs_result:
    """Return the size and use of the file system that a process sees at `folder`.

    Raises OSError if the process has exited.
    """
    return os.statvfs(f"/proc/{pid}/root{folder}")


# --- threads --------------------------------------------------------------------------------------------------


def thread_name(task: str) -> bytes:
    """Return the name of this process's thread `task`. Raises OSError if the thread has finished."""
    return read(f"/proc/self/task/{task}/comm")


def how_many_threads(pid: int) -> int:
    """Return the number of threads in a process, or zero if the process has exited.

    This is ten times faster than listing the threads.
    """
    with suppress(OSError):
        return os.stat(f"/proc/{pid}/task").st_nlink - 2
    return 0


def thread_folder(pid: int | str, task: str) -> str:
    """Return the folder in /proc that contains a thread's files, such as `stat`, `schedstat`, and `syscall`."""
    return f"/proc/{pid}/task/{task}"


def is_at_work(stat_fd: int) -> bool:
    """Return whether a thread is running, waiting for a processor, or waiting for a disk.

    `stat_fd`: the descriptor of the thread's file `stat`.
    """
    line = _peek(stat_fd)
    after_name = line.rfind(b")") + 2
    return line[after_name : after_name + 1] in (b"R", b"D")


def times_scheduled(schedstat_fd: int) -> bytes:
    """Return the content of a thread's file `schedstat`, which changes each time the thread gets a processor.

    `schedstat_fd`: the file's descriptor.
    """
    return _peek(schedstat_fd)


def times_main_thread_ran(pid: int) -> int | None:
    """Return the number of times that a process's first thread has got a processor.

    Return None if the process has exited or if the kernel doesn't report the number.
    """
    try:
        return int(read(f"{thread_folder(pid, str(pid))}/schedstat").split()[2])
    except (OSError, IndexError):
        return None


def system_call(syscall_fd: int) -> bytes:
    """Return the number and arguments of the system call that a thread is in.

    The result is empty if the kernel doesn't report the call. `syscall_fd`: the descriptor of the thread's file
    `syscall`.
    """
    return _peek(syscall_fd)


def _peek(fd: int) -> bytes:
    """Return the content of a small open file, or b"" if the file's thread has finished."""
    try:
        return os.pread(fd, 512, 0)
    except OSError:
        return b""


# --- sockets --------------------------------------------------------------------------------------------------


def _sockets(pid: int) -> set[str]:
    try:
        links = [os.readlink(f"/proc/{pid}/fd/{fd}") for fd in os.listdir(f"/proc/{pid}/fd")]
    except OSError:
        return set()
    return {link[8:-1] for link in links if link.startswith("socket:[")}


def _udp_sockets(tables: Iterable[str]) -> Iterator[tuple[int, str]]:
    """Yield the local port and inode of each UDP socket."""
    for table in tables:
        try:
            lines = read_text(table).splitlines()[1:]
        except OSError:
            continue
        for line in lines:
            fields = line.split()
            yield int(fields[1].rsplit(":", 1)[1], 16), fields[9]


def udp_ports_in_use(tables: Iterable[str] = UDP_TABLES) -> set[int]:
    """Return the local UDP ports that any process on this machine has bound."""
    return {port for port, _ in _udp_sockets(tables)}


def udp_ports_of(group: Iterable[int]) -> set[int]:
    """Return the local ports of the IPv4 UDP sockets that these processes have open."""
    inodes: set[str] = set()
    for pid in group:
        inodes |= _sockets(pid)
    return {port for port, inode in _udp_sockets(UDP_TABLES[:1]) if inode in inodes}


def sockets_open(group: Iterable[int]) -> int:
    """Return the number of sockets that these processes have open. A socket that they share counts once."""
    return len(set().union(*map(_sockets, group)))


def sockets_of_network(totals: str = SOCKET_TOTALS) -> int:
    """Return the number of open sockets in this process's network namespace, or zero if that's unknown."""
    try:
        return int(read_text(totals).split()[2])  # sockets: used N
    except (OSError, ValueError, IndexError):
        return 0


def queued_bytes(worth_counting: int, totals: str = SOCKET_TOTALS) -> int:
    """Return the number of unread bytes in the UDP and TCP sockets of this process's network namespace.

    The kernel has a total for all of the machine's network namespaces, which is fast to read. If that total is at most
    `worth_counting` bytes, return zero. Otherwise, add up the bytes in this namespace's sockets.
    """
    try:
        lines = [line.split() for line in read_text(totals).splitlines()]
        pages = sum(int(words[words.index("mem") + 1]) for words in lines if "mem" in words)
        if pages * _PAGE_BYTES <= worth_counting:
            return 0
        queues = [line.split()[4] for table in QUEUE_TABLES for line in read_text(table).splitlines()[1:]]
        return sum(int(part, 16) for queue in queues for part in queue.split(":"))
    except (OSError, ValueError, IndexError):
        return 0


def unix_socket_names(table: str = UNIX_SOCKETS) -> set[str]:
    """Return the names of this machine's Unix sockets. The names of abstract sockets begin with @."""
    try:
        rows = [line.split(maxsplit=7) for line in read_text(table).split("\n")[1:]]
        return {row[7] for row in rows if len(row) == 8}  # some sockets have no name
    except OSError:
        return set()


# --- the machine ----------------------------------------------------------------------------------------------


def processor_times_s(stat: str | os.PathLike[str] = PROC_STAT) -> dict[str, list[float]]:
    """Return each processor's times (s), and their sums as "cpu", in the columns of proc_stat(5).

    Return {} if `stat` can't be read.
    """
    rows = [line.split() for line in _read_if_there(os.fspath(stat)).decode(errors="replace").splitlines()]
    rows = [words for words in rows if words and words[0].startswith("cpu") and "".join(words[1:]).isdigit()]
    return {name: [int(ticks) * _TICK_S for ticks in columns] for name, *columns in rows}


def stolen_s(stat: str | os.PathLike[str] = PROC_STAT) -> dict[str, float]:
    """Return each processor's steal time since the machine started, in seconds.

    Return {} if `stat` can't be read.
    """
    each = {name: times for name, times in processor_times_s(stat).items() if name != "cpu"}
    return {name: times[_STEAL] for name, times in each.items() if len(times) > _STEAL}


def idle_and_all_s(stat: str | os.PathLike[str] = PROC_STAT) -> tuple[float, float]:
    """Return the processors' idle time and their total time since the machine started, in seconds.

    Return zeros if these times are unknown.
    """
    times = processor_times_s(stat).get("cpu", [])
    return sum(times[_IDLE]), sum(times[: _STEAL + 1])


def knows_ids(first: int, count: int) -> bool:
    """Return whether the `count` IDs starting at `first` exist in this container, both as user IDs and as group IDs."""
    for table in ("/proc/self/uid_map", "/proc/self/gid_map"):
        try:
            rows = [[int(number) for number in line.split()] for line in read_text(table).splitlines()]
        except OSError:
            return False
        if not any(begin <= first and first + count <= begin + size for begin, _, size in rows):
            return False
    return True


def system_v_ipc(table: str) -> list[dict[str, str]]:
    """Return the rows of /proc/sysvipc/TABLE, each keyed by column name. `table` is "shm", "sem", or "msg".

    Return an empty list if the kernel has no such table.
    """
    try:
        head, *lines = read_text(f"/proc/sysvipc/{table}").splitlines()
    except (OSError, ValueError):
        return []
    return [dict(zip(head.split(), line.split(), strict=False)) for line in lines]


def mapped_libraries(name: str, table: str = "/proc/self/maps") -> set[str]:
    """Return the paths of the files that are mapped into this process and whose names begin with `name`.

    The paths may contain spaces.
    """
    paths = (line.split(maxsplit=5)[-1] for line in read_text(table).splitlines())
    return {path for path in paths if path.rpartition("/")[2].startswith(name) and "/" in path}


def own_environment_range() -> tuple[int, int]:
    """Return the start and end address of this process's environment: env_start and env_end in proc(5)."""
    begin, end = stat_fields()[47:49]
    return int(begin), int(end)

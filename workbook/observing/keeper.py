"""Runs a command and outlives it, to end all that is left below: `python -I -S keeper.py PARENT COMMAND...`

When the command ends, or when the process PARENT does, however suddenly. A box of bubblewrap ends with its owner too,
but only from a certain moment of its start on: until then a killed grader would leave it behind for ever.

Needs nothing of the workbook but the files beside it.
"""

import ctypes
import importlib
import os
import resource
import signal
import sys
from pathlib import Path

if __name__ == "__main__":  # started by its path, without the workbook
    sys.path.insert(0, str(Path(__file__).resolve().parents[2]))
orphans = importlib.import_module("workbook.observing.orphans")

PR_SET_PDEATHSIG = 1
HEARD = {signal.SIGTERM, signal.SIGCHLD, signal.SIGINT}
"""An interrupt is the command's to obey; the keeper goes when that has gone."""


def keep(parent: int, command: list[str]) -> int:
    """Run `command` until it ends or `parent` does. Returns its exit code as `os.waitstatus_to_exitcode` tells it."""
    signal.pthread_sigmask(signal.SIG_BLOCK, HEARD)
    orphans.adopt_orphans()
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGTERM)
    if os.getppid() != parent:
        return -signal.SIGKILL
    child = os.posix_spawn(command[0], command, os.environ, setsigmask=())
    code = -signal.SIGKILL
    while signal.sigwait(HEARD) != signal.SIGTERM:
        ended, status = os.waitpid(child, os.WNOHANG)
        if ended:
            code = os.waitstatus_to_exitcode(status)
            break
    try:
        orphans.sweep_orphans()
    except orphans.StillThere as error:
        print(error, file=sys.stderr, flush=True)
    return code


def end_alike(code: int) -> None:
    """End this process as the command ended: with its exit code, or by its signal."""
    if code < 0:
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        signal.pthread_sigmask(signal.SIG_UNBLOCK, HEARD)
        if -code not in (signal.SIGKILL, signal.SIGSTOP):
            signal.signal(-code, signal.SIG_DFL)
        os.kill(os.getpid(), -code)
    os._exit(code)


if __name__ == "__main__":
    end_alike(keep(int(sys.argv[1]), sys.argv[2:]))

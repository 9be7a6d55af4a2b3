"""Runs a command and outlives it, to end all that is left below.

    python -I -S run.py subreaper PARENT COMMAND...

When the command ends, or when the process PARENT does, however suddenly. A sandbox of bubblewrap ends with its owner
too, but only from a certain moment of its start on: until then a killed grader would leave it behind for ever.
"""

import os
import resource
import signal
import sys

from workbook.inside.libc import set_parent_death_signal
from workbook.inside.orphans import StillThere, adopt_orphans, sweep_orphans

HEARD = {signal.SIGTERM, signal.SIGCHLD, signal.SIGINT}
"""An interrupt is the command's to obey; this process goes when that has gone."""


def run_and_reap(parent: int, command: list[str]) -> int:
    """Run `command` until it ends or `parent` does. Returns its exit code as `os.waitstatus_to_exitcode` tells it."""
    signal.pthread_sigmask(signal.SIG_BLOCK, HEARD)
    adopt_orphans()
    set_parent_death_signal(signal.SIGTERM)
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
        sweep_orphans()
    except StillThere as error:
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


def main(arguments: list[str]) -> None:
    """Run the command and end as it ended, with the arguments above."""
    parent, *command = arguments
    end_alike(run_and_reap(int(parent), command))

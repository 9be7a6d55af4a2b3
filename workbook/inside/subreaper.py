"""Run a command, and then kill all its leftover processes.

    python -I -S run.py subreaper PARENT COMMAND...

This process kills them when the command or the process PARENT exits, even if PARENT is killed. The command is usually a
bubblewrap sandbox, which is removed by itself when its owner exits. But if the owner is killed while the sandbox is
starting, only this process keeps the sandbox from staying forever.
"""

import os
import resource
import signal
import sys

from workbook.inside.libc import set_parent_death_signal
from workbook.inside.orphans import StillThere, adopt_orphans, sweep_orphans

HEARD = {signal.SIGTERM, signal.SIGCHLD, signal.SIGINT}
"""The signals that this process waits for.

It ignores SIGINT, because the command handles that signal. This process exits after the command does.
"""


def run_and_reap(parent: int, command: list[str]) -> int:
    """Run `command` until it or the process `parent` exits, and kill all leftover processes.

    Return the command's exit code as `os.waitstatus_to_exitcode` does, or -9 if `parent` exited first.
    """
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
    """Exit as the command did: with the same exit code, or through the same signal if the code is negative."""
    if code < 0:
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        signal.pthread_sigmask(signal.SIG_UNBLOCK, HEARD)
        if -code not in (signal.SIGKILL, signal.SIGSTOP):
            signal.signal(-code, signal.SIG_DFL)
        os.kill(os.getpid(), -code)
    os._exit(code)


def main(arguments: list[str]) -> None:
    """Run the command from the arguments that the module's docstring describes, and exit as the command does."""
    parent, *command = arguments
    end_alike(run_and_reap(int(parent), command))

"""Ctrl-C works in the same way, whether a terminal or a grading slot that ignores it started the program."""

import signal
from pathlib import Path

from tests.programs.support import wait_until, write
from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.ros.domains import lease_domain

WAITS = """\
import time

try:
    print("ready", flush=True)
    time.sleep(30)
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""


def test_a_parent_that_ignores_ctrl_c_does_not_take_it_from_the_program(tmp_path: Path) -> None:
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        with (
            lease_domain() as lease,
            NodeProcess(ProgramSpec(write(tmp_path, WAITS)), lease.domain_id) as process,
        ):
            wait_until(lambda: "ready" in process.log.text())
            process.stop()
            ended = process.record()
    finally:
        signal.signal(signal.SIGINT, before)
    assert "interrupted" in ended.end_log
    assert (ended.exit, ended.signal) == (0, None)

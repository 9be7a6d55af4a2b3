"""A driver's key for signatures is gone before the answer is imported: from memory, arguments, and descriptors."""

import os
import secrets
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.programs.support import wait_until
from workbook.programs import unconfined
from workbook.programs.fork_client import OwnServer
from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.ros.domains import lease_domain

KEY = secrets.token_bytes(32)
KNOWN = "found in memory, so the search works"
ANSWER = f"""\
import os
KNOWN = {KNOWN!r} * (os.getpid() > 0)
print("read", os.read(0, 100), flush=True)
"""
DRIVER = """\
import answer
import time
print(globals()["sign"]("/driver/report", "done"), flush=True)
time.sleep(600)
"""


@pytest.fixture(params=["fresh", "forked"])
def program(
    request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> Iterator[NodeProcess]:
    """Start an answer with a driver, and wait until both have run to their last line."""
    files = [tmp_path / name for name in ("answer.py", "driver.py")]
    for file, text in zip(files, (ANSWER, DRIVER), strict=True):
        file.write_text(text)
    server = OwnServer()
    if request.param == "forked":
        server.keep()
    monkeypatch.setattr(unconfined, "own_server", server)
    with lease_domain() as lease:
        spec = ProgramSpec(files[0], driver=files[1], driver_key=KEY)
        with NodeProcess(spec, lease.domain_id) as process:
            wait_until(lambda: process.log.text().endswith(" done\n"))
            yield process
    server.close()


def is_in_memory(pid: int, wanted: bytes) -> bool:
    """Return whether these bytes are anywhere in a process's writable memory."""
    with open(f"/proc/{pid}/maps") as maps, open(f"/proc/{pid}/mem", "rb", buffering=0) as memory:
        for line in maps:
            span, rights, *_ = line.split()
            begin, end = (int(one, 16) for one in span.split("-"))
            if rights.startswith("rw") and not line.rstrip().endswith("[vvar]"):
                memory.seek(begin)
                data = b""
                while begin + len(data) < end and (more := memory.read(end - begin - len(data))):
                    data += more
                if wanted in data:
                    return True
    return False


def test_the_key_is_gone_before_the_answer_is_imported(program: NodeProcess) -> None:
    try:
        there = is_in_memory(program.pid, KNOWN.encode())
    except PermissionError:
        pytest.skip("this system lets no process read another one's memory")
    assert there
    assert not is_in_memory(program.pid, KEY) and not is_in_memory(program.pid, KEY.hex().encode())
    for name in ("cmdline", "environ"):
        text = Path(f"/proc/{program.pid}/{name}").read_bytes()
        assert KEY not in text and KEY.hex().encode() not in text
    assert os.readlink(f"/proc/{program.pid}/fd/0") == os.devnull
    assert "read b''\n" in program.log.text()


def test_what_it_signs_is_what_the_record_can_check(program: NodeProcess) -> None:
    assert program.record().driver_key == KEY.hex()
    number, signature, text = program.log.text().splitlines()[-1].split(" ", 2)
    assert (number, text, len(signature)) == ("1", "done", 32)

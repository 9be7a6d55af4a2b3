"""Run two programs under separate user ids, without Landlock: `python -m tests.hostile.uid_alone RUN`.

The first is a right answer. The second tries to attack it, and leaves files and processes behind. The observations are
printed as JSON.
"""

import json
import sys
import time
from pathlib import Path

from workbook.isolation.uid import UidTier, UserProgram
from workbook.isolation.user_ids import Ids, lease_ids, processes_of
from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.ros.domains import lease_domain
from workbook.ros.scratch import scratch_folder

ROOT = Path(__file__).resolve().parents[2]
PATIENCE_S = 60.0
INTRUDER = """
import json, os, signal, subprocess, sys, time
run, pid, *places = sys.argv[1:]
def works(attempt):
    try:
        attempt()
    except OSError:
        return False
    return True
found = {"signals the neighbor": works(lambda: os.kill(int(pid), 0)),
         "signals the judge": works(lambda: os.kill(os.getppid(), 0)),
         "reads its environment": works(lambda: open(f"/proc/{pid}/environ").read()),
         "sees its files": works(lambda: os.listdir(f"/proc/{pid}/fd"))}
for place in places:
    found[f"lists {place}"] = works(lambda: os.listdir(place))
    found[f"writes into {place}"] = works(lambda: open(f"{place}/x", "w"))
own = os.path.dirname(__file__)
found["changes its folder"] = works(lambda: os.chmod(own, 0o777)) or works(lambda: open(f"{own}/x", "w"))
left = [f"/tmp/left_{run}", f"/dev/shm/left_{run}", f"/var/tmp/left_{run}"]
for place in left:
    open(place, "w").close()
os.makedirs(f"/tmp/folder_left_{run}/deep")
os.symlink("/etc", f"/tmp/folder_left_{run}/deep/link")
for _ in range(5):
    subprocess.Popen(["sleep", "600"], start_new_session=True, env={})
print("found:", json.dumps(found), flush=True)
time.sleep(600)
"""


def udp_addresses(user: int) -> list[str]:
    """Return the local addresses of a user's UDP sockets, in the kernel's format."""
    rows = [
        line.split()
        for table in ("udp", "udp6")
        for line in Path(f"/proc/net/{table}").read_text().splitlines()[1:]
    ]
    return [row[1].split(":")[0] for row in rows if int(row[7]) == user]


def wait_for(process: NodeProcess, text: str) -> str:
    deadline = time.monotonic() + PATIENCE_S
    while text not in process.record().log:
        if not process.is_running() or time.monotonic() > deadline:
            raise TimeoutError(process.record().log)
        time.sleep(0.02)
    return process.record().log


def tier_of(ids: Ids) -> UidTier:
    return UidTier(ids, hides_files=False, sweeps_orphans=False)


def main() -> None:
    neighbor, intruder = lease_ids(), lease_ids()
    folder = scratch_folder("intruder")
    program = folder / "intruder.py"
    program.write_text(INTRUDER)
    run = sys.argv[1]
    with lease_domain() as lease:
        answer = ROOT / "solutions" / "09_joint_positions.py"
        first = NodeProcess(ProgramSpec(answer), lease.domain_id, tier_of(neighbor))
        wait_for(first, "Status: operational")
        addresses = udp_addresses(neighbor.user)
        confinement = first.confinement
        assert isinstance(confinement, UserProgram)
        places = [str(confinement.scratch), str(confinement.files), str(folder)]
        spec = ProgramSpec(program, [run, str(first.pid), *places])
        second = NodeProcess(spec, lease.domain_id, tier_of(intruder))
        log = wait_for(second, "found: ")
        sleeping = len(processes_of(intruder.user))
        second.stop(patience_s=0.1)
        told = {
            "found": json.loads(log.split("found: ")[1].splitlines()[0]),
            "addresses": addresses,
            "sleeping": sleeping,
            "left": processes_of(intruder.user),
            "files left": [
                str(path)
                for place in ("/tmp", "/dev/shm", "/var/tmp")
                for path in Path(place).glob("*")
                if run in path.name
            ],
            "neighbor runs": first.is_running() and confinement.scratch.is_dir(),
        }
        first.stop()
        told["neighbor left"] = processes_of(neighbor.user)
    print(json.dumps(told))


if __name__ == "__main__":
    main()

"""The tiers below the sandbox.

Right answers keep their points, hostile ones gain nothing, and the known gaps are documented.
"""

import json
import os
import re
import shutil
import socket
import stat
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import pytest

from tests.programs.support import is_gone, wait_until
from workbook.cli.main import main
from workbook.exercise.definition import load_exercise
from workbook.grading import tier_check
from workbook.inside.landlock import ABI_OF_SIGNALS, landlock_abi
from workbook.inside.proc import running_users
from workbook.inside.sweeper import act_as, is_ours
from workbook.inside.syscall_filter import knows_this_machine
from workbook.isolation import tiers
from workbook.isolation.bubblewrap import sandbox_problem
from workbook.isolation.host_files import closed_folder, interpreter_folders
from workbook.isolation.tiers import BEST_FIRST, Isolation, covers, leaves_open, refuses
from workbook.isolation.user_ids import Ids, NoIds, lease_ids
from workbook.recording.limits import ANSWER_LIMITS
from workbook.watching.tier_self_test import problem_in

pytestmark = [pytest.mark.slow, pytest.mark.whole]
ROOT = Path(__file__).resolve().parents[2]
ANSWERS = Path(__file__).parent / "answers"
STEM = "09_joint_positions"
SLOTS = 2
IS_ROOT = os.geteuid() == 0
WEAKER: tuple[Isolation, ...] = ("uid", "landlock", "limits")
SAYS_USER = "import os\nprint('user', os.getuid(), flush=True)\n"

GOES_ON = {  # none of these attempts succeeds, so each program is just a right answer
    "reads others": """
import glob, os
places = ["@@SECRET@@"]
for folder in glob.glob("/tmp/rclpy-workbook-*"):
    if not os.path.samefile(folder, os.path.dirname(__file__)) and not os.path.samefile(folder, os.getcwd()):
        places += [folder, *glob.glob(folder + "/*")]
for place in places:
    try:
        os.listdir(place) if os.path.isdir(place) else open(place).close()
    except OSError:
        continue
    raise SystemExit(f"{place} can be read")
""",
    "changes its folder": """
import os
folder = os.path.dirname(__file__)
for attempt in (
    lambda: open(__file__, "a"),
    lambda: open(os.path.join(folder, "more.py"), "w"),
    lambda: os.unlink(__file__),
    lambda: os.rename(folder, folder + "x"),
):
    try:
        attempt()
    except OSError:
        continue
    raise SystemExit("the folder of the answer can be changed")
""",
}
KILLS_THE_GRADER = """
import os, signal
def parent_of(pid):
    with open(f"/proc/{pid}/stat") as file:
        return int(file.read().rsplit(")", 1)[1].split()[1])
grader = [os.getppid()]
try:
    grader.append(parent_of(os.getppid()))
except OSError:
    pass
for pid in grader:
    try:
        os.kill(pid, signal.SIGKILL)
    except PermissionError:
        continue
    raise SystemExit("the grader can be killed")
"""
HINDERS_THE_GRADER = """
import os, resource
grader = os.getppid()
attempts = [
    lambda: resource.prlimit(grader, resource.RLIMIT_CPU, (0, 0)),
    lambda: resource.prlimit(grader, resource.RLIMIT_NOFILE, (3, 3)),
    lambda: os.setpriority(os.PRIO_PROCESS, grader, 19),
    lambda: os.setpriority(os.PRIO_PGRP, os.getpgid(grader), 19),
]
if os.getuid() < 60600:
    attempts.append(lambda: os.setpriority(os.PRIO_USER, 0, 19))
for number, attempt in enumerate(attempts):
    try:
        attempt()
    except OSError:
        continue
    raise SystemExit(f"attempt {number}: the grader can be hindered")
resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
os.sched_setaffinity(0, os.sched_getaffinity(0))
os.nice(1)
"""
LEFT_BEHIND = '''
import os, sys
if os.fork() == 0:
    os.setsid()
    if os.fork() == 0:
        daemon = """
import os, rclpy
print("user", os.getuid(), flush=True)
from std_msgs.msg import Float32MultiArray
rclpy.init()
node = rclpy.create_node("left_behind_@@RUN@@")
publisher = node.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
node.create_timer(2.0, lambda: publisher.publish(Float32MultiArray(data=[0.0] * 12)))
rclpy.spin(node)
"""
        clean = {name: os.environ[name] for name in os.environ if not name.startswith("WORKBOOK")}
        os.execve(sys.executable, [sys.executable, "-c", daemon], clean)
    os._exit(0)
'''
BOMB = (ANSWERS / "forks_without_end.py").read_text(encoding="utf-8")
COMES_BACK = (ANSWERS / "daemons_that_come_back.py").read_text(encoding="utf-8")
CANNOT_BE_CAUGHT = """
import os, signal
if os.getuid() < 60600:
    raise SystemExit("this is no user of its own")
if os.fork() == 0:
    os.setsid()
    while True:
        try:
            os.kill(-1, signal.SIGKILL)
        except OSError:
            pass
        if os.fork():
            os._exit(0)
"""
LITTERS = """
import ctypes, os, tempfile
for place in ("/tmp", "/var/tmp", "/dev/shm", "/run/lock", os.getcwd()):
    try:
        open(os.path.join(place, "left_by_@@RUN@@"), "w").close()
        os.mkdir(os.path.join(place, "folder_left_by_@@RUN@@"))
    except OSError:
        pass
ctypes.CDLL(None).shmget(0, 4096, 0o1600)
for _ in range(1500):
    os.mkdir("deep")
    os.chdir("deep")
os.chdir(os.environ["HOME"])
os.chmod("deep", 0)
raise SystemExit(0)
"""
STORES = """
import os, time
names = [os.path.join("@@PLACE@@" or os.getcwd(), f"stored_by_@@RUN@@_{number}") for number in range(4)]
for name in names:
    place = os.open(name, os.O_CREAT | os.O_RDWR, 0o600)
    os.posix_fallocate(place, 0, 90_000_000)
    os.close(place)
print("stored", flush=True)
time.sleep(120)
"""
LEAVES_TEMPORARY_FILES = """
import tempfile
print("temporary:", tempfile.mkdtemp(prefix="left_by_@@RUN@@_"), flush=True)
raise SystemExit(0)
"""
TRIES_WHAT_IS_OPEN = """
import json, os, signal, socket
def works(attempt):
    try:
        attempt()
    except OSError:
        return False
    return True
datagram = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
works(lambda: os.chmod("@@OWN@@", 0o600))
print("open:", json.dumps({
    "read": works(lambda: open("@@SECRET@@").close()),
    "kill": works(lambda: os.kill(@@SLEEPER@@, signal.SIGTERM)),
    "network": works(lambda: datagram.sendto(b"@@RUN@@", ("127.0.0.1", @@PORT@@))),
    "disk": os.statvfs(os.getcwd()).f_bavail * os.statvfs(os.getcwd()).f_frsize > 200_000_000,
}), flush=True)
"""
WORDS_FOR = {
    "read": " read",
    "chmod": "change",
    "kill": "your processes",
    "network": "the network",
    "disk": "the disk",
}


def as_every_user() -> list[str]:
    """Return the command prefix that lets every user run this Python, even if only root may (it is in /root)."""
    needed = {*interpreter_folders(), Path(sys.prefix), Path(sys.executable), ROOT}
    needed |= {place.resolve() for place in needed}
    folders = {folder for place in needed for folder in place.parents}
    closed = [folder for folder in sorted(folders) if not folder.stat().st_mode & stat.S_IXOTH]
    if not IS_ROOT or not closed or shutil.which("bwrap") is None:
        return []
    command = ["bwrap", "--dev-bind", "/", "/", "--cap-add", "ALL", "--die-with-parent"]
    done: list[Path] = []
    for folder in closed:
        if not any(one in folder.parents for one in done):
            command += ["--tmpfs", str(folder)]
            done.append(folder)
    covered = [place for place in sorted(needed) if any(folder in place.parents for folder in done)]
    for place in [one for one in covered if not any(other in one.parents for other in covered)]:
        for folder in reversed(place.parents):
            if any(one in folder.parents for one in done):
                command += ["--perms", "0755", "--dir", str(folder)]
        command += ["--bind", str(place), str(place)]
    return [*command, "--"]


def ids_can_be_leased() -> bool:
    """Return whether programs can run under separate user ids here."""
    return IS_ROOT and (bool(as_every_user()) or closed_folder() is None)


@dataclass(frozen=True)
class Account:
    """The user who runs the grader: another user id, or the user who runs the tests. Includes a folder of that user.

    `around`: the command's prefix.
    """

    user: int | None
    folder: Path
    around: tuple[str, ...] = ()

    def start(self, command: list[str]) -> "subprocess.Popen[str]":
        environ = {**os.environ, "HOME": str(self.folder), "PYTHONDONTWRITEBYTECODE": "1"}
        environ.pop("XDG_CACHE_HOME", None)
        user: list[str] = []
        if self.user is not None:
            user = ["setpriv", "--reuid", str(self.user), "--regid", str(self.user), "--clear-groups"]
        pipe = subprocess.PIPE
        return subprocess.Popen(
            [*self.around, *as_every_user(), *user, *command],
            stdin=pipe,
            stdout=pipe,
            stderr=pipe,
            text=True,
            env=environ,
            cwd=ROOT,
        )

    def run(self, command: list[str], text: str = "") -> "subprocess.CompletedProcess[str]":
        with self.start(command) as process:
            said, errors = process.communicate(text)
        return subprocess.CompletedProcess(command, process.returncode, said, errors)


@pytest.fixture(scope="module")
def ordinary() -> Iterator[Account]:
    """Provide an ordinary user. If root runs the tests, create one."""
    ids = lease_ids() if IS_ROOT else None
    folder = Path(tempfile.mkdtemp(prefix="tiers-"))
    folder.chmod(0o755)
    try:
        if ids is not None:
            os.chown(folder, ids.user, ids.user)
        yield Account(None if ids is None else ids.user, folder)
    finally:
        if ids is not None:
            ids.sweep()  # files of the grader itself as this user, such as the shared memory of its tracing
            ids.release()
        shutil.rmtree(folder, ignore_errors=True)


@pytest.fixture(scope="module")
def owner() -> Iterator[Account]:
    """Provide the user who runs the tests."""
    folder = Path(tempfile.mkdtemp(prefix="tiers-"))
    folder.chmod(0o755)
    yield Account(None, folder)
    shutil.rmtree(folder, ignore_errors=True)


@dataclass(frozen=True)
class Aftermath:
    """The result of all answers in one tier, and what they left. `problem`: why the tier doesn't work here."""

    tier: Isolation
    problem: str | None
    judgements: dict[str, dict[str, Any]]
    users: set[int]
    left: list[str]
    heard: bool
    slept_on: bool
    modes_changed: bool


def answers_for(tier: Isolation, solution: str) -> dict[str, str]:
    """Return the answers by name, without those that a tier doesn't claim to stop."""
    right = ROOT / "tests" / "right_answers" / STEM
    texts = {
        "right": solution,
        "two processes": (right / "two_processes.py").read_text(),
        "remapped": (right / "remapped_and_more_topics.py").read_text(),
        "left behind": LEFT_BEHIND,
        "bomb": BOMB,
        "comes back": COMES_BACK,
        "litters": LITTERS,
        "stores": STORES.replace("@@PLACE@@", ""),
        "leaves temporary files": LEAVES_TEMPORARY_FILES,
        "open": TRIES_WHAT_IS_OPEN,
        "right afterwards": solution,
    }
    if tier != "limits":
        texts |= {name: text + solution for name, text in GOES_ON.items()}
        if landlock_abi() >= ABI_OF_SIGNALS or tier == "uid":
            texts["kills the grader"] = KILLS_THE_GRADER + solution
        if tier == "uid" or knows_this_machine():
            texts["hinders the grader"] = HINDERS_THE_GRADER + solution
    else:
        del texts["litters"]
    if tier == "uid":
        texts["cannot be caught"] = CANNOT_BE_CAUGHT
        texts["stores in memory"] = STORES.replace("@@PLACE@@", "/dev/shm")
    return {name: SAYS_USER + text for name, text in texts.items()}


def processes_that(said: str) -> list[str]:
    found = []
    for entry in os.listdir("/proc"):
        if entry.isdigit():
            try:
                command = (
                    Path(f"/proc/{entry}/cmdline").read_bytes().replace(b"\0", b" ").decode(errors="replace")
                )
            except OSError:
                continue
            if said in command and not is_gone(int(entry)):
                found.append(command)
    return found


def what_is_left(run: str, users: set[int], grader: int | None) -> list[str]:
    """Return the processes and files of these users, and everything whose name contains the name of this run."""
    left = [f"process {pid} of {user}" for pid, user in running_users() if user in users]
    left += processes_that(f"left_behind_{run}")
    for folder in ("/tmp", "/var/tmp", "/dev/shm", "/run/lock"):
        for path in Path(folder).glob("*"):
            try:
                owner = path.lstat().st_uid
            except OSError:
                continue
            is_ours = path.name.startswith(
                ("tiers-", "lttng-ust-wait-")
            )  # the grader's own files, if the grader runs as this user
            if (owner in users and not (is_ours and owner == grader)) or run in path.name:
                left.append(str(path))
    table = Path("/proc/sysvipc/shm")
    rows = [line.split() for line in table.read_text().splitlines()] if table.exists() else []
    return left + [f"shared memory {row[1]}" for row in rows[1:] if int(row[7]) in users]


def judge_all_in(tier: Isolation, account: Account) -> Aftermath:
    run = f"{os.getpid()}_{tier}"
    secret, own = account.folder / "another_answer.py", account.folder / "own"
    for path in (secret, own):
        path.write_text("secret = 1\n")
        path.chmod(0o644)
        if account.user is not None:
            os.chown(path, account.user, account.user)
    solution = load_exercise(STEM, ROOT).source.solution_code
    sleeper = (
        subprocess.Popen(["sleep", "600"], user=account.user)
        if account.user
        else subprocess.Popen(["sleep", "600"])
    )
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as listener:
        listener.bind(("127.0.0.1", 0))
        listener.setblocking(False)
        marks = {
            "@@SECRET@@": secret,
            "@@OWN@@": own,
            "@@RUN@@": run,
            "@@SLEEPER@@": sleeper.pid,
            "@@PORT@@": listener.getsockname()[1],
        }
        texts = answers_for(tier, solution)
        for mark, value in marks.items():
            texts = {name: text.replace(mark, str(value)) for name, text in texts.items()}
        try:
            done = account.run(
                [sys.executable, "-m", "tests.hostile.tier_run", tier, str(SLOTS)], json.dumps(texts)
            )
        finally:
            slept_on = sleeper.poll() is None
            sleeper.kill()
            sleeper.wait()
        try:
            heard = listener.recv(100) == run.encode()
        except BlockingIOError:
            heard = False
    assert done.returncode == 0, done.stderr
    told = json.loads(done.stdout)
    logs = "".join(one["log"] for one in told["judgements"].values())
    users = {int(number) for number in re.findall(r"^user (\d+)$", logs, re.MULTILINE)}
    if account.user is None:
        users.discard(os.getuid())
    else:
        users.add(account.user)
    return Aftermath(
        tier,
        told["problem"],
        told["judgements"],
        users,
        what_is_left(run, users, account.user),
        heard,
        slept_on,
        own.stat().st_mode & 0o777 != 0o644,
    )


@pytest.fixture(scope="module", params=WEAKER)
def aftermath(request: pytest.FixtureRequest, ordinary: Account, owner: Account) -> Aftermath:
    tier: Isolation = request.param
    return judge_all_in(tier, owner if tier == "uid" else ordinary)


def works_here(aftermath: Aftermath) -> bool:
    """Return whether the tier works on this machine. If not, check that the tier's message gives the reason."""
    if aftermath.problem is None:
        return True
    reasons = {
        "uid": "only root|other users may not enter|too few user ids",
        "landlock": "has no Landlock",
        "limits": "no reason is good enough",
    }
    assert re.search(reasons[aftermath.tier], aftermath.problem), aftermath.problem
    return False


def explained(aftermath: Aftermath, name: str) -> str:
    one = aftermath.judgements[name]
    return f"{one['status']} {one['score']} {one['limits']}\n{one['said']}\n{one['log'][-1500:]}"


def test_root_and_the_ordinary_user_have_a_tier_that_isolates(aftermath: Aftermath) -> None:
    if aftermath.tier == "uid" and ids_can_be_leased():
        assert aftermath.problem is None
    if aftermath.tier == "landlock" and landlock_abi():
        assert aftermath.problem is None
    assert works_here(aftermath) or aftermath.judgements == {}


@pytest.mark.parametrize(
    "name",
    [
        "right",
        "two processes",
        "remapped",
        "right afterwards",
        "reads others",
        "changes its folder",
        "kills the grader",
        "hinders the grader",
    ],
)
def test_a_right_answer_gets_full_marks_and_does_nothing_else(name: str, aftermath: Aftermath) -> None:
    if not works_here(aftermath) or name not in aftermath.judgements:
        return
    assert aftermath.judgements[name]["score"] == 10, explained(aftermath, name)


@pytest.mark.parametrize(
    "name",
    [
        "left behind",
        "comes back",
        "cannot be caught",
        "bomb",
        "litters",
        "stores",
        "stores in memory",
        "leaves temporary files",
        "open",
    ],
)
def test_a_hostile_answer_gets_nothing(name: str, aftermath: Aftermath) -> None:
    if not works_here(aftermath) or name not in aftermath.judgements:
        return
    one = aftermath.judgements[name]
    assert (one["status"], one["score"]) == ("graded", 0), explained(aftermath, name)
    if name == "bomb":
        assert one["limits"] == ["processes"], explained(aftermath, name)
        assert f"ran more than {ANSWER_LIMITS.processes} processes" in one["said"]
    if name.startswith("stores"):
        assert one["limits"] == ["disk"], explained(aftermath, name)


def test_everything_that_was_asked_was_judged(aftermath: Aftermath) -> None:
    if works_here(aftermath):
        assert set(aftermath.judgements) == set(answers_for(aftermath.tier, ""))


def test_nothing_is_left(aftermath: Aftermath) -> None:
    if works_here(aftermath):
        assert aftermath.users or not IS_ROOT, "no answer said as whom it ran"
        assert aftermath.left == []


def test_what_is_open_is_said_and_nothing_else(aftermath: Aftermath) -> None:
    if not works_here(aftermath):
        return
    told = re.search(r"^open: (.*)$", aftermath.judgements["open"]["log"], re.MULTILINE)
    assert told is not None, explained(aftermath, "open")
    found = {**json.loads(told[1]), "chmod": aftermath.modes_changed}
    assert found["network"] == aftermath.heard
    assert found["kill"] != aftermath.slept_on
    sentence = leaves_open(aftermath.tier)
    assert {name: word in sentence for name, word in WORDS_FOR.items()} == found, sentence


def test_answers_run_as_users_that_have_no_account(aftermath: Aftermath) -> None:
    if aftermath.tier == "uid" and works_here(aftermath):
        assert aftermath.users and all(map(is_ours, aftermath.users))


@pytest.mark.parametrize("tier", WEAKER)
def test_a_killed_grader_takes_along_even_what_hides_from_it(
    tier: Isolation, ordinary: Account, owner: Account
) -> None:
    account = owner if tier == "uid" else ordinary
    sleep = f"600.{os.getpid():07d}{WEAKER.index(tier)}"
    hand_in = account.folder / "joint_positions_s2.py"
    hand_in.write_text(
        "import subprocess, time\n"
        f"subprocess.Popen(['sleep', '{sleep}'], start_new_session=True, env={{}})\n"
        "time.sleep(600)\n"
    )
    hand_in.chmod(0o644)
    command = [
        "grade",
        str(hand_in),
        "--out",
        str(account.folder / "killed"),
        "--isolation",
        tier,
        "--slots",
        "1",
    ]
    with account.start([sys.executable, "-m", "workbook.cli.main", *command]) as grader:
        wait_until(lambda: processes_that(sleep) or grader.poll() is not None)
        if grader.poll() is not None:
            assert tier == "uid" and not ids_can_be_leased()
            return
        grader.kill()
    wait_until(lambda: not processes_that(sleep))


# --- the shared network of answers --------------------------------------------------------------------------------

TAKES_AND_SPEAKS_ON_ALL_DOMAINS = """
import socket, threading, time
import rclpy
from std_msgs.msg import Float32MultiArray, String
held = []
for domain in range(1, 102):
    one = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
    try:
        one.bind(chr(0) + f"rclpy-workbook/domain/{domain}")
    except OSError:
        continue
    held.append(one)
print("took", len(held), flush=True)
def domains():
    with open("/proc/self/net/udp") as table:
        ports = [int(line.split()[1].split(":")[1], 16) for line in table.readlines()[1:]]
    return {(port - 7400) // 250 for port in ports if 7400 <= port < 7400 + 250 * 102}
own = domains()
speakers = {}
ends = time.monotonic() + 60
while time.monotonic() < ends:
    for domain in domains() - own - speakers.keys():
        context = rclpy.Context()
        rclpy.init(context=context, domain_id=domain)
        node = rclpy.create_node("stranger", context=context)
        speakers[domain] = (node.create_publisher(Float32MultiArray, "/robot/joint_positions", 10),
                            node.create_publisher(String, "/robot/status", 10))
        print("speaks on", domain, flush=True)
    for numbers, words in speakers.values():
        numbers.publish(Float32MultiArray(data=[7.0]))
        words.publish(String(data="not me"))
    time.sleep(0.05)
"""
OWN_NETWORK = (
    "bwrap",
    "--dev-bind",
    "/",
    "/",
    "--unshare-net",
    "--cap-add",
    "ALL",
    "--die-with-parent",
    "--",
)


@pytest.mark.sandbox
@pytest.mark.parametrize("tier", ["uid", "landlock"])
def test_no_answer_takes_or_disturbs_the_domain_of_another(
    tier: Isolation, ordinary: Account, owner: Account
) -> None:
    """This uses a separate network, so that no other test is disturbed."""
    problem = sandbox_problem()
    if problem is not None:
        pytest.skip(f"no network of its own: {problem}")
    account = replace(owner if tier == "uid" else ordinary, around=OWN_NETWORK)
    solution = load_exercise(STEM, ROOT).source.solution_code
    texts = {"stranger": TAKES_AND_SPEAKS_ON_ALL_DOMAINS, "right": solution, "right, too": solution}
    done = account.run([sys.executable, "-m", "tests.hostile.tier_run", tier, "3"], json.dumps(texts))
    assert done.returncode == 0, done.stderr
    told = json.loads(done.stdout)
    if told["problem"] is not None:
        assert tier == "landlock" or not ids_can_be_leased(), told["problem"]
        return
    found = {name: (one["status"], one["score"]) for name, one in told["judgements"].items()}
    right = ("graded", 10)
    assert found == {"stranger": ("graded", 0), "right": right, "right, too": right}, told
    said = told["judgements"]["stranger"]["log"]
    assert re.search(r"^took (9|10)\d$", said, re.MULTILINE) and "speaks on" not in said, said


# --- a separate user id without Landlock ----------------------------------------------------------------------------


def test_user_ids_alone_keep_answers_apart_and_traffic_on_this_machine(owner: Account) -> None:
    if not ids_can_be_leased():
        assert tier_check.tier_problem("uid") is not None
        return
    run = f"alone_{os.getpid()}"
    done = owner.run([sys.executable, "-m", "tests.hostile.uid_alone", run])
    assert done.returncode == 0, done.stderr
    told = json.loads(done.stdout)
    assert not any(told["found"].values()), told["found"]
    assert len(told["found"]) == 11
    assert len(told["addresses"]) >= 2
    assert set(told["addresses"]) == {"0100007F"}, "127.0.0.1 and nothing else"
    assert told["sleeping"] == 6
    assert (told["left"], told["files left"], told["neighbor left"]) == ([], [], [])
    assert told["neighbor runs"], "the neighbor was not touched"


@pytest.mark.parametrize(("user", "own"), [(0, 0), (0, 60_601), (60_600, 0), (1000, 1001), (60_600, 65_534)])
def test_the_sweeper_acts_for_no_other_user(user: int, own: int) -> None:
    before = os.getresuid()
    with pytest.raises(PermissionError, match="not ids that programs are run under"):
        act_as(user, own)
    assert os.getresuid() == before


def test_two_leases_have_no_id_in_common() -> None:
    if not IS_ROOT:
        with pytest.raises(NoIds, match="only root"):
            lease_ids()
        return
    leases = [lease_ids() for _ in range(20)]
    ids = [number for lease in leases for number in (lease.user, lease.sweeper)]
    assert len(set(ids)) == 40
    assert all(map(is_ours, ids))
    for lease in leases:
        lease.release()


# --- messages about tiers -------------------------------------------------------------------------------------------

HARMLESS = {
    "reads a file of the judge": False,
    "changes its own file": False,
    "writes next to its own file": False,
    "signals the judge": False,
    "connects to this machine": False,
    "has capabilities": False,
    "can gain capabilities": False,
    "user": [60_600, 60_600, 60_600],
    "groups": [60_600, 60_600, 60_600],
}


@pytest.mark.parametrize("tier", BEST_FIRST)
def test_a_self_test_names_what_a_program_could_do(tier: Isolation) -> None:
    assert problem_in(tier, HARMLESS, None) is None
    for name in refuses(tier):
        problem = problem_in(tier, {**HARMLESS, name: True}, None)
        assert problem is not None
        assert name in problem
    assert bool(refuses(tier)) == (tier != "limits")


def test_a_self_test_sees_another_user_and_a_group_too_many() -> None:
    ids = Ids(60_600)
    assert problem_in("uid", HARMLESS, ids) is None
    for name, value in (("user", [0, 60_600, 60_600]), ("groups", [60_600, 60_600, 60_600, 0])):
        assert "and not as 60600 alone" in str(problem_in("uid", {**HARMLESS, name: value}, ids))


@pytest.mark.parametrize("abi", [0, 1, 4, 6, 7])
def test_an_older_kernel_leaves_more_open_and_that_is_said(abi: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tiers, "landlock_abi", lambda: abi)
    assert ("every user of this machine may read" in leaves_open("uid")) == (abi == 0)
    assert ("TCP is closed" in leaves_open("uid")) == (abi >= 4)
    if abi:
        assert ("your processes" in leaves_open("landlock")) == (abi < 6)
        assert ("lets no signal out" in covers("landlock")) == (abi >= 6)
    else:
        tier_check.tier_problem.cache_clear()
        assert "has no Landlock" in str(tier_check.tier_problem("landlock"))
        tier_check.tier_problem.cache_clear()


@pytest.fixture
def answer(tmp_path: Path) -> Path:
    path = tmp_path / "joint_positions_s1.py"
    path.write_text("speed = = 3\n")
    return path


def test_auto_refuses_what_is_below_the_sandbox_and_names_the_best_that_works(
    answer: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    problems = {"sandbox": "bubblewrap is not installed", "uid": "only root can"}
    monkeypatch.setattr(tier_check, "tier_problem", problems.get)
    assert main(["grade", str(answer), "--out", str(answer.parent / "out")]) == 2
    said = capsys.readouterr().err
    assert "bubblewrap is not installed" in said
    assert "--isolation landlock" in said
    assert leaves_open("landlock") in said
    assert not (answer.parent / "out").exists()


def test_a_tier_that_was_named_and_does_not_work_is_refused(
    answer: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(tier_check, "tier_problem", lambda tier: f"no {tier} today")
    for tier in BEST_FIRST[1:]:
        assert main(["grade", str(answer), "--out", str(answer.parent / "out"), "--isolation", tier]) == 2
        assert f"--isolation {tier} does not work on this machine: no {tier} today" in capsys.readouterr().err


@pytest.mark.parametrize("tier", WEAKER)
def test_a_tier_that_was_accepted_is_in_every_line(
    tier: Isolation, answer: Path, ordinary: Account, owner: Account
) -> None:
    account = owner if tier == "uid" else ordinary
    hand_in = Path(shutil.copy(answer, account.folder))
    hand_in.chmod(0o644)
    out = account.folder / f"out_{tier}"
    command = [
        "grade",
        str(hand_in),
        "--out",
        str(out),
        "--isolation",
        tier,
        "--slots",
        "1",
        "--format",
        "html",
    ]
    done = account.run([sys.executable, "-m", "workbook.cli.main", *command])
    if done.returncode == 2:
        assert f"--isolation {tier} does not work on this machine: " in done.stderr
        assert tier == "uid" and not ids_can_be_leased()
        return
    assert done.returncode == 0, done.stderr
    assert f"Isolation: {tier}: {covers(tier)}. {leaves_open(tier)}" in done.stderr
    [line] = (out / "results.jsonl").read_text().splitlines()
    assert json.loads(line)["isolation"] == tier
    pages = [path.read_text() for path in (out / "pages").glob("*.html")]
    assert len(pages) == 2
    assert any(f"Isolation: {tier} (1)" in page for page in pages)
    assert any(f"isolation: {tier}" in page for page in pages)

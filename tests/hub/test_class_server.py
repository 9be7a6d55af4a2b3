"""Four simulated students at a real JupyterHub, each with a server and a kernel:

what they can do, and what they can't.
"""

import importlib.util
import json
import os
import shutil
from collections.abc import Iterator
from pathlib import Path

import psutil
import pytest

from deploy.jupyterhub import disks
from tests.hub.class_server import INSTRUCTOR, ClassServer, at_once, class_server, wait_until
from tests.hub.simulated_student import Ran, SimulatedStudent

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
NAMES = ("ada", "ben", "cleo", "dan")
MISSING = [
    reason
    for reason, is_missing in (
        (
            "the extra hub is not installed (make env EXTRAS=hub)",
            importlib.util.find_spec("jupyterhub") is None,
        ),
        ("a hub that gives each student a network of their own needs root", os.geteuid() != 0),
        ("bubblewrap is not installed (apt install bubblewrap)", shutil.which("bwrap") is None),
    )
    if is_missing
]
pytestmark = [
    pytest.mark.slow,
    pytest.mark.whole,
    pytest.mark.skipif(bool(MISSING), reason="; ".join(MISSING)),
]


@pytest.fixture(scope="module")
def hub(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ClassServer]:
    folder = tmp_path_factory.mktemp("hub") / "class"
    options = (
        "--ClassSpawner.poll_interval=2",
        "--ClassSpawner.mem_limit=1000M",
        *([] if disks.missing() else ["--ClassSpawner.disk_limit=100M"]),
    )
    with class_server(folder, *options) as server:
        yield server


@pytest.fixture(scope="module")
def students(hub: ClassServer) -> list[SimulatedStudent]:
    found = [hub.student(name) for name in NAMES]
    at_once(SimulatedStudent.start_server, found)
    return found


@pytest.fixture(scope="module")
def kernels(students: list[SimulatedStudent]) -> dict[str, str]:
    return dict(zip(NAMES, at_once(SimulatedStudent.start_kernel, students), strict=True))


def answer_cell(program: str) -> str:
    return f"%%answer {STEM}\n{program}"


def right_answer() -> str:
    from workbook.exercise.definition import load_exercise

    return load_exercise(STEM, ROOT).source.solution_code


def test_each_student_runs_lesson_09_and_checks_answers(
    students: list[SimulatedStudent], kernels: dict[str, str]
) -> None:
    wrong_file = ROOT / "tests/wrong_answers" / STEM / "wrong_name.py"

    def work(student: SimulatedStudent) -> tuple[list[Ran], Ran, Ran, Ran]:
        cells = [
            cell["source"]
            for cell in student.notebook(f"notebooks/{STEM}.ipynb")["cells"]
            if cell["cell_type"] == "code"
        ][:9]
        with student.connected(kernels[student.name]) as kernel:
            lesson = [kernel.run(cell) for cell in cells]
            kernel.run(answer_cell(wrong_file.read_text()))
            wrong = kernel.run("%check")
            kernel.run(answer_cell(right_answer()))
            started = kernel.run("%start")
            kernel.run("%stop")
            return lesson, wrong, started, kernel.run("%check")

    for lesson, wrong, started, right in at_once(work, students):
        assert [ran.error for ran in lesson if ran.error] == []
        assert "started /joint_position_publisher" in lesson[0].text
        assert "10 of 10" not in wrong.shown and " of 10 points" in wrong.shown, wrong
        assert "is in the graph" in started.text, started
        assert "Full marks: 10 of 10 points" in right.shown, right


# --- students are isolated from each other ---------------------------------------------------------------------


SAME_DOMAIN = """
import subprocess, sys, textwrap, time
program = textwrap.dedent('''
    import os, sys, time
    os.environ |= {"ROS_DOMAIN_ID": "42", "ROS_AUTOMATIC_DISCOVERY_RANGE": "SUBNET"}
    os.environ.pop("FASTRTPS_DEFAULT_PROFILES_FILE", None)
    os.environ.pop("FASTDDS_DEFAULT_PROFILES_FILE", None)
    import rclpy
    from std_msgs.msg import String
    rclpy.init()
    node = rclpy.create_node("talker")
    heard = set()
    node.create_subscription(String, "/names", lambda message: heard.add(message.data), 10)
    publisher = node.create_publisher(String, "/names", 10)
    node.create_timer(0.1, lambda: publisher.publish(String(data=sys.argv[1])))
    end = time.time() + float(sys.argv[2])
    while time.time() < end:
        rclpy.spin_once(node, timeout_sec=0.1)
    print(*sorted(heard))
''')
names = [f"{NAME}-first", f"{NAME}-second"]
both = [subprocess.Popen([sys.executable, "-c", program, name, "15"], stdout=subprocess.PIPE, text=True)
        for name in names]
print(*(one.communicate()[0].strip() for one in both), sep=" | ")
"""


def test_no_student_receives_messages_of_another_one_on_the_same_domain(
    students: list[SimulatedStudent], kernels: dict[str, str]
) -> None:
    def work(student: SimulatedStudent) -> Ran:
        with student.connected(kernels[student.name]) as kernel:
            return kernel.run(f"NAME = {student.name!r}\n{SAME_DOMAIN}")

    for student, ran in zip(students, at_once(work, students), strict=True):
        both = f"{student.name}-first {student.name}-second"
        assert ran.text.strip() == f"{both} | {both}"


LOOK_AROUND = """
import json, os, socket
from pathlib import Path
tokens = {text for path in Path("/proc").glob("[0-9]*/environ") if os.access(path, os.R_OK)
          for text in path.read_text(errors="replace").split(chr(0)) if text.startswith("JUPYTERHUB_API_TOKEN=")}
readable = []
for folder in FORBIDDEN:
    try:
        readable += [folder, *os.listdir(folder)]
    except OSError:
        pass
listening = []
for port in PORTS:
    try:
        with socket.create_connection(("127.0.0.1", port), 1) as connection:
            if connection.getsockname() != connection.getpeername():  # TCP may connect a free port to itself
                listening.append(port)
    except OSError:
        pass
users = sorted({path.stat().st_uid for path in Path("/proc").glob("[0-9]*")})
print(json.dumps({"tokens": len(tokens), "readable": readable, "listening": listening, "users": users,
                  "home": os.listdir("/home"), "links": [name for _, name in socket.if_nameindex()]}))
"""


def test_no_student_sees_files_processes_or_tokens_of_another_one(
    hub: ClassServer, students: list[SimulatedStudent], kernels: dict[str, str]
) -> None:
    forbidden = [
        str(hub.folder),
        *(str(hub.folder / part) for part in ("hub", "students", "hand_ins", "published")),
    ]
    servers = [
        int(word.partition("=")[2]) for gate in hub.gates() for word in gate.cmdline() if "--server=" in word
    ]
    assert len(servers) == len(NAMES)
    for student in students:
        own, others = hub.user_id(student.name), [name for name in NAMES if name != student.name]
        ports = [hub.port, hub.port + 1, hub.port + 2, *servers]
        with student.connected(kernels[student.name]) as kernel:
            ran = kernel.run(f"FORBIDDEN, PORTS = {forbidden!r}, {ports!r}\n{LOOK_AROUND}")
        seen = json.loads(ran.text)
        assert seen["tokens"] == 1
        assert seen["readable"] == []
        assert seen["users"] == [0, own]  # process 0 is bubblewrap's
        assert seen["home"] == [student.name]
        assert seen["links"] == ["lo"]
        assert len(seen["listening"]) == 2  # the hub's API, and this student's server
        assert hub.port + 1 in seen["listening"]
        for other in others:
            assert student.get(f"/user/{other}/api/contents/answers").status_code == 403
            assert student.get(f"/hub/api/users/{other}").status_code in (403, 404)


def others_still_work(students: list[SimulatedStudent], kernels: dict[str, str], name: str) -> None:
    for student in students:
        if student.name != name:
            with student.connected(kernels[student.name]) as kernel:
                assert kernel.run("print(6 * 7)").text == "42\n"


def in_kernel(student: SimulatedStudent, kernels: dict[str, str], code: str) -> str:
    with student.connected(kernels[student.name]) as kernel:
        ran = kernel.run(code)
    assert not ran.error, ran
    return ran.text


def test_a_student_who_uses_up_memory_harms_nobody_else(
    students: list[SimulatedStudent], kernels: dict[str, str]
) -> None:
    fill = "import subprocess, sys\nprint(subprocess.run([sys.executable, '-c', 'b\"x\" * (3 << 30)']).returncode)"
    assert in_kernel(students[2], kernels, fill) == "-9\n"
    others_still_work(students, kernels, students[2].name)
    assert in_kernel(students[2], kernels, "print('here')") == "here\n"


def test_if_the_machine_runs_out_of_memory_kernels_end_before_servers_and_the_hub(
    hub: ClassServer, students: list[SimulatedStudent], kernels: dict[str, str]
) -> None:
    look = "print(*(open(f'/proc/{pid}/oom_score_adj').read().strip() for pid in ('self', os.getppid())))"
    assert in_kernel(students[0], kernels, f"import os; {look}") == "600 300\n"
    assert {Path(f"/proc/{gate.pid}/oom_score_adj").read_text() for gate in hub.gates()} == {"0\n"}


def test_a_student_who_starts_too_many_processes_harms_nobody_else(
    students: list[SimulatedStudent], kernels: dict[str, str]
) -> None:
    fork = """
import subprocess
started = []
try:
    while len(started) < 3000:
        started.append(subprocess.Popen(["sleep", "600"]))
    print("no limit")
except OSError as error:
    print(type(error).__name__, 300 < len(started) < 1000)
"""
    assert in_kernel(students[3], kernels, fork) == "BlockingIOError True\n"
    others_still_work(students, kernels, students[3].name)
    in_kernel(students[3], kernels, "for one in started: one.kill(), one.wait()")


def test_temporary_files_are_limited(students: list[SimulatedStudent], kernels: dict[str, str]) -> None:
    fill = """
for folder in ("/tmp", "/dev/shm"):
    try:
        with open(f"{folder}/full", "wb") as file:
            for _ in range(1000):
                file.write(bytes(1 << 20))
        print("no limit")
    except OSError as error:
        print(error.strerror)
    os.remove(f"{folder}/full")
"""
    assert in_kernel(students[0], kernels, "import os" + fill) == "No space left on device\n" * 2


FILL_DISK = """
import os
for folder in (".", os.path.expanduser("~"), "../answers"):
    try:
        with open(f"{folder}/full", "wb", buffering=0) as file:
            for _ in range(100_000):
                file.write(bytes(4096))
        print("no limit")
    except OSError as error:
        print(error.strerror)
"""


@pytest.mark.skipif(disks.missing() is not None, reason="this machine has no loop devices")
def test_a_student_with_a_full_disk_harms_nobody_else_and_can_delete_files(
    hub: ClassServer, students: list[SimulatedStudent], kernels: dict[str, str]
) -> None:
    eve = hub.student("eve")
    eve.start_server()
    path = f"/user/eve/api/contents/exercises/{STEM}.ipynb"
    model = eve.get(path).json()
    kernel = {"eve": eve.start_kernel()}
    assert in_kernel(eve, kernel, FILL_DISK) == "No space left on device\n" * 3
    larger = {**model["content"], "metadata": {**model["content"]["metadata"], "more": "." * 100_000}}
    refused = eve.send("PUT", path, {**model, "content": larger})
    assert refused.status_code == 500 and "disk is full" in refused.json()["message"], refused.text
    assert eve.get(path).json()["content"]["cells"] == model["content"]["cells"]  # the saved file is intact

    others = f"/user/{NAMES[0]}/api/contents/exercises/{STEM}.ipynb"
    students[0].send("PUT", others, {**model, "content": larger}).raise_for_status()
    assert "Saved as answers/" in in_kernel(students[0], kernels, answer_cell("# a new answer"))

    eve.stop_server()
    eve.start_server()
    kernel = {"eve": eve.start_kernel()}
    in_kernel(eve, kernel, "import os; os.remove('full'); os.remove('../answers/full')")
    eve.send("PUT", path, {**model, "content": larger}).raise_for_status()
    assert "Saved as answers/" in in_kernel(eve, kernel, answer_cell(right_answer()))
    eve.stop_server()


def test_a_student_whose_output_is_endless_doesnt_fill_the_hubs_log(hub: ClassServer) -> None:
    gus = hub.student("gus")
    gus.start_server()
    before = hub.log.stat().st_size
    shout = """
import os
from pathlib import Path
own = {os.readlink(link): int(link.name) for link in Path("/proc/self/fd").iterdir() if link.is_symlink()}
print(os.write(own[os.readlink(f"/proc/{os.getppid()}/fd/1")], bytes(16 << 20)))
"""
    assert in_kernel(gus, {"gus": gus.start_kernel()}, shout) == f"{16 << 20}\n"
    gus.stop_server()
    assert hub.log.stat().st_size - before < 2 << 20


def test_a_damaged_disk_is_reported_and_left_as_it_is(hub: ClassServer) -> None:
    image = hub.folder / "disks/hal.ext4"
    image.write_bytes(b"not a file system" * 1000)
    page = hub.student("hal").get("/hub/spawn/hal")
    assert "Your disk can&#39;t be opened." in page.text, page.text
    assert f"`e2fsck -p {image}` failed" in hub.log.read_text()
    assert image.read_bytes() == b"not a file system" * 1000
    image.unlink()


# --- the course and its teachers -------------------------------------------------------------------------------


def test_the_course_is_read_only(students: list[SimulatedStudent], kernels: dict[str, str]) -> None:
    code = f"""
import os
print([path for path in ({str(ROOT)!r}, {str(ROOT / "workbook")!r}, {str(ROOT / "exercises/criteria")!r}, os.sys.prefix)
       if os.access(path, os.W_OK)])
"""
    assert in_kernel(students[0], kernels, code) == "[]\n"


def test_an_instructor_grades_all_and_a_student_gets_their_own_page(
    hub: ClassServer, students: list[SimulatedStudent], kernels: dict[str, str]
) -> None:
    in_kernel(students[0], kernels, answer_cell(right_answer()))
    instructor = hub.student(INSTRUCTOR)
    instructor.start_server()
    late = hub.student("ivy")
    late.start_server()
    in_kernel(late, {"ivy": late.start_kernel()}, answer_cell(right_answer()))
    late.stop_server()
    with instructor.connected(instructor.start_kernel("")) as kernel:
        graded = kernel.run(f"""
import subprocess
for command in ("workbook grade --exercise 09 hand_ins --out grades --format html --slots 1",
                "python -m deploy.jupyterhub.publish grades published"):
    done = subprocess.run(command, shell=True, capture_output=True, text=True, cwd={str(ROOT / "work")!r})
    print(done.stdout[-3000:], done.stderr[-3000:])
""")
    assert "published" in graded.text, graded
    assert instructor.get(f"/user/{INSTRUCTOR}/api/contents/hand_ins/ivy/{STEM}.py").ok
    page = students[0].get(f"/user/{students[0].name}/api/contents/feedback/{STEM}.html")
    assert page.ok, (page.text[:1000], graded)
    assert "10 of 10" in page.json()["content"]
    written = in_kernel(students[0], kernels, "import os; print(os.access('../feedback', os.W_OK))")
    assert written == "False\n"
    instructor.stop_server()


# --- restarts and ends -----------------------------------------------------------------------------------------


def test_a_restart_of_the_hub_leaves_kernels_running(
    hub: ClassServer, students: list[SimulatedStudent], kernels: dict[str, str]
) -> None:
    before = {name: sorted(hub.processes(name)) for name in NAMES}
    for student in students:
        in_kernel(student, kernels, f"kept = {student.name!r}")
    hub.stop()
    hub.start()
    assert all(hub.seen(hub.folder / "students" / name / "work/notebooks").is_dir() for name in NAMES)
    for name in NAMES:
        student = hub.student(name)
        student.start_server()
        assert in_kernel(student, kernels, "print(kept)") == f"{name}\n"
        assert sorted(hub.processes(name)) == before[name]


def test_work_outlives_the_server_and_an_update_of_the_course(hub: ClassServer) -> None:
    student = hub.student(NAMES[1])
    student.start_server()
    path = f"/user/{student.name}/api/contents/exercises/{STEM}.ipynb"
    model = student.get(path).json()
    model["content"]["cells"][0]["source"] = "Ben's own notes"
    student.send("PUT", path, model).raise_for_status()
    lesson = f"notebooks/{STEM}.ipynb"
    student.send(
        "DELETE", f"/user/{student.name}/api/contents/{lesson}"
    ).raise_for_status()  # as if it were new
    student.stop_server()
    student.start_server()
    assert student.get(path).json()["content"]["cells"][0]["source"] == "Ben's own notes"
    work = hub.seen(hub.folder / "students" / student.name / "work")
    assert (work / lesson).stat().st_uid == hub.user_id(student.name)


def test_a_killed_gate_takes_its_server_along_and_another_one_starts(hub: ClassServer) -> None:
    student = hub.student(NAMES[2])
    student.start_server()
    student.start_kernel()
    [gate] = [one for one in hub.gates() if hub.user_id(NAMES[2]) in below(one)]
    gate.kill()
    wait_until(lambda: not hub.processes(student.name), "processes of a killed server are left")
    wait_until(lambda: not student.has_server, "the hub does not notice")
    wait_until(
        lambda: not [one for one in hub.groups() if one.name.endswith(student.name)], "cgroups are left"
    )
    student.start_server()


def below(gate: psutil.Process) -> set[int]:
    return {one.uids().real for one in gate.children(recursive=True)}


def test_nothing_is_left_when_all_have_gone(hub: ClassServer) -> None:
    for name in (*NAMES, INSTRUCTOR):
        student = hub.student(name)
        if student.has_server:
            student.stop_server()
    hub.stop()
    wait_until(lambda: not hub.left(), "something is left")


def test_an_instructor_reads_hand_ins_of_students_whose_disks_were_not_mounted(hub: ClassServer) -> None:
    hub.stop()
    hub.start()
    student, instructor = hub.student("jan"), hub.student(INSTRUCTOR)
    student.start_server()
    in_kernel(student, {"jan": student.start_kernel()}, answer_cell(right_answer()))
    student.stop_server()
    hub.stop()
    wait_until(lambda: not hub.left(), "something is left")
    hub.start()
    instructor.start_server()
    assert instructor.get(f"/user/{INSTRUCTOR}/api/contents/hand_ins/jan/{STEM}.py").ok
    instructor.stop_server()

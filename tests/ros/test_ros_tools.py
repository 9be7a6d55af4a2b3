"""Query a known graph: nodes of this kernel and of another process."""

import io
import os
import pty
import re
import signal
import subprocess
import sys
import time

import pytest

from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.ros.domains import lease_domain
from workbook.ros.environment import child_environment, profile_with_default_times
from workbook.ros.notebook_registry import OpenNotebook, announce, open_notebooks, withdraw
from workbook.ros.topic_monitor import rate_of

# Each publisher here publishes ten times per second. On a busy machine, fewer messages get through, or many at the same
# time.
MOST_PER_SECOND = 40
ROBOT = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32MultiArray, String
from std_srvs.srv import Trigger
rclpy.init()
node = Node('status', namespace='/robot')
words = node.create_publisher(String, 'status', 10)
joints = node.create_publisher(Float32MultiArray, 'joints', rclpy.qos.qos_profile_sensor_data)
node.create_service(Trigger, 'stand_up', lambda request, response: response)
def say():
    words.publish(String(data='operational'))
    joints.publish(Float32MultiArray(data=[0.0, 0.5]))
node.create_timer(0.1, say)
print('up', flush=True)
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    pass
rclpy.try_shutdown()
"""
LISTENER = """
from std_msgs.msg import Float32MultiArray
init()
from workbook.ros import graph, join_line, node_info, node_list, topic_echo, topic_hz, topic_info, topic_list
talker = fresh(Talker, 0.1)
talker.create_subscription(Float32MultiArray, '/robot/joints', lambda msg: None, 10)
"""
TOPICS = """\
topic          type                             publishers  subscribers
/chatter       std_msgs/msg/String              1           1
/robot/joints  std_msgs/msg/Float32MultiArray   1           1
/robot/status  std_msgs/msg/String              1           0
"""


@pytest.fixture
def robot(start_script):
    process = start_script(ROBOT)
    assert process.stdout.readline() == "up\n"
    return process


@pytest.fixture
def kernel(open_kernel, domain):
    return open_kernel(domain=f"domain_id={domain}")


def squeeze(text):
    return [re.sub(r"  +", "  ", line).rstrip() for line in text.splitlines()]


def test_the_first_look_sees_everybody_in_both_processes(kernel, robot):
    outcome = kernel.good(LISTENER + "print(node_list())")
    assert outcome.text == "/robot/status\n/talker\n"


def test_a_look_without_init_sees_others(kernel, robot):
    outcome = kernel.good("from workbook.ros import node_list\nprint(node_list(), rclpy.ok())")
    assert outcome.text == "/robot/status False\n"


def test_topics_and_nodes(kernel, robot):
    kernel.good(LISTENER)
    assert squeeze(kernel.good("print(topic_list())").text) == squeeze(TOPICS)
    assert kernel.good("topic_list(types=False)").result == "topic\n/chatter\n/robot/joints\n/robot/status"
    assert squeeze(kernel.good("print(node_info('robot/status'))").text) == [
        "does  name  type",
        "publishes  /robot/joints  std_msgs/msg/Float32MultiArray",
        "publishes  /robot/status  std_msgs/msg/String",
        "serves  /robot/stand_up  std_srvs/srv/Trigger",
    ]
    missing = kernel.run("node_info('robot/statsu')")
    assert missing.error == "NotFound"
    assert "Did you mean /robot/status?" in missing.message
    assert "/rosout" in kernel.good("print(topic_list(hidden=True))").text


def test_topic_info_tells_who_cannot_hear_whom(kernel, robot):
    kernel.good(LISTENER)
    lines = squeeze(kernel.good("print(topic_info('/robot/joints'))").text)
    assert lines == [
        "role  node  type  reliability  durability  deadline",
        "publishes  /robot/status  std_msgs/msg/Float32MultiArray  best effort  volatile  none",
        "subscribes  /talker  std_msgs/msg/Float32MultiArray  reliable  volatile  none",
        "",
        "✗ /talker does not hear /robot/status: it asks for reliable and gets best effort.",
    ]
    assert kernel.good("print(topic_info('chatter').problems)").text == "()\n"


def test_the_graph_is_plain_data_and_a_table(kernel, robot):
    kernel.good(LISTENER)
    outcome = kernel.good(
        "g = graph()\nprint(g.nodes)\nprint(g.topics['/robot/status'])\nfor edge in g.edges: print(*edge)\n"
        "print(g._repr_html_().count('<tr>'))\nprint(*g.broken[0][:3])"
    )
    assert outcome.text.splitlines() == [
        "('/robot/status', '/talker')",
        "('std_msgs/msg/String',)",
        "/robot/status publishes /robot/joints",
        "/robot/status publishes /robot/status",
        "/talker publishes /chatter",
        "/talker subscribes /chatter",
        "/talker subscribes /robot/joints",
        "4",
        "/robot/joints /robot/status /talker",
    ]
    html = kernel.good("print(topic_list()._repr_html_() == topic_list()._repr_html_())")
    assert html.text == "True\n"


def test_twins_are_counted(kernel):
    outcome = kernel.good(
        LISTENER + "a = Node('twin')\nb = Node('twin')\nprint(node_list())\nprint(len(node_list()))"
    )
    assert outcome.text.endswith("/talker\n/twin  (2 nodes with this name)\n3\n")


def test_echo_and_rate_of_own_and_other_nodes(kernel, robot):
    kernel.good(LISTENER)
    assert kernel.good("print(topic_echo('/robot/joints', 1, nodes=[]))").text == (
        "layout:\n  dim: []\n  data_offset: 0\ndata: [0.0, 0.5]\n"
    )
    heard = kernel.good("print(topic_echo('chatter', 2))").text
    warning, _, messages = heard.partition("\n")
    assert "New publisher discovered on topic '/robot/joints', offering incompatible QoS" in warning
    assert messages == "data: tick 1\n---\ndata: tick 2\n"
    for topic in ("/robot/status", "/chatter"):
        outcome = kernel.good(f"rate = topic_hz('{topic}', 1.0)\nprint(rate.count, rate.mean_hz)")
        count, mean_hz = map(float, outcome.text.split())
        assert 2 <= count <= MOST_PER_SECOND and 1 < mean_hz < MOST_PER_SECOND
    silent = kernel.run("topic_echo('/robot/statuss', timeout=0.5)")
    assert silent.error == "NotFound"
    assert "Did you mean /robot/status?" in silent.message
    assert kernel.good("print(talker.executor, rclpy.ok(), node_list(hidden=True))").text.startswith(
        "None True"
    )
    assert "probe" not in kernel.good("print(node_list(hidden=True))").text


def test_the_rate_is_that_of_the_arrivals():
    rate = rate_of("/robot/status", [10.0, 10.1, 10.2, 10.4, 10.5], 1.0)
    assert (rate.count, rate.mean_hz) == (5, pytest.approx(8.0))
    assert (rate.shortest_gap, rate.longest_gap) == (pytest.approx(0.1), pytest.approx(0.2))
    assert rate.spread == pytest.approx(0.0433, abs=0.0001)
    assert rate_of("/robot/status", [10.0], 1.0).mean_hz is None


def test_a_look_is_quick(kernel, robot):
    kernel.good(LISTENER + "node_list()")
    outcome = kernel.good(
        "times = []\nfor _ in range(5):\n    start = time.perf_counter()\n    graph()\n"
        "    times.append(time.perf_counter() - start)\nprint(sorted(times)[2])"
    )
    assert float(outcome.text) < 2.0  # all programs here have responded before


def command(*arguments, **environ):
    ours = {name: value for name, value in os.environ.items() if name != "ROS_DOMAIN_ID"} | environ
    return [sys.executable, "-m", "workbook.cli.main", *arguments], ours


def workbook(*arguments, **environ):
    line, ours = command(*arguments, **environ)
    return subprocess.run(line, env=ours, capture_output=True, text=True, timeout=60)


def test_the_terminal_sees_nodes_and_topics(robot, domain):
    on = f"--domain={domain}"
    assert workbook("node", "list", on).stdout == "/robot/status\n"
    assert "stand_up" in workbook("node", "info", "/robot/status", on).stdout
    assert [line.split()[0] for line in workbook("topic", "list", on).stdout.splitlines()] == [
        "topic",
        "/robot/joints",
        "/robot/status",
    ]
    assert "best effort" in workbook("topic", "info", "robot/joints", on).stdout
    assert "→ /robot/joints →" in workbook("graph", on).stdout
    assert (
        workbook("topic", "echo", "/robot/status", "--count=2", on).stdout == "data: operational\n---\n" * 2
    )
    rate = workbook("topic", "hz", "/robot/status", "--seconds=2", on)
    *each_second, _header, summary = rate.stdout.splitlines()
    assert 1 < float(summary.split()[0]) < MOST_PER_SECOND
    assert len(each_second) >= 2 and " Hz, from " in each_second[-1]
    missing = workbook("topic", "echo", "/robot/battery", "--timeout=0.5", on)
    assert missing.returncode == 1
    told = " ".join(missing.stderr.split())
    assert "No node publishes /robot/battery. Topics with a publisher: /robot/joints, /robot/status." in told
    assert told.endswith(
        "Waiting for a publisher. Press Ctrl-C to stop. Still no node publishes /robot/battery."
    )


PLAIN = """
import rclpy
from rclpy.node import Node
rclpy.init()
try:
    rclpy.spin(Node("player_%d"))
except KeyboardInterrupt:
    pass
rclpy.try_shutdown()
"""


@pytest.fixture
def plain_programs(tmp_path, domain):
    """Start three programs that announce themselves every three seconds, as programs without our profile do."""
    programs = []
    for number in range(3):
        file = tmp_path / f"player_{number}.py"
        file.write_text(PLAIN % number)
        spec = ProgramSpec(file)
        programs.append(NodeProcess(spec, domain, write_profile=profile_with_default_times))
    yield programs
    for program in programs:
        program.stop()


def until_all_are_seen(domain):
    """Wait until the three programs are visible."""
    end = time.monotonic() + 60
    while len(workbook("node", "list", f"--domain={domain}").stdout.split()) < 3:
        assert time.monotonic() < end


@pytest.mark.whole
def test_every_look_waits_for_programs_that_announce_themselves_rarely(plain_programs, domain):
    """A query may wait for three seconds: by then, all have responded, and none is reported as missing."""
    until_all_are_seen(domain)
    for _ in range(6):
        done = workbook("node", "list", f"--domain={domain}")
        assert (done.stdout, done.stderr) == ("/player_0\n/player_1\n/player_2\n", "")


def test_nobody_waits_for_a_program_that_is_stopped_and_it_is_named(plain_programs, domain):
    until_all_are_seen(domain)
    stopped = plain_programs[1].pid
    os.kill(stopped, signal.SIGSTOP)
    try:
        done = workbook("node", "list", f"--domain={domain}")
    finally:
        os.kill(stopped, signal.SIGCONT)
    assert done.stdout == "/player_0\n/player_2\n"
    assert f"is stopped, so its nodes may be missing (process {stopped})" in done.stderr


def test_a_misspelled_topic_is_told_at_once_and_awaited(robot, domain, start_script):
    line, ours = command("topic", "echo", "/robot/statu", "--count=1", f"--domain={domain}")
    process = subprocess.Popen(line, env=ours, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    told = process.stderr.readline()
    assert told.startswith("No node publishes /robot/statu. Did you mean /robot/status?")
    start_script(ROBOT.replace("'status', 10", "'statu', 10"))
    assert process.stdout.read() == "data: operational\n---\n"
    assert process.wait(20) == 0
    process.stdout.close()
    process.stderr.close()


def test_an_interrupted_measurement_is_told(robot, domain):
    line, ours = command("topic", "hz", "/robot/status", "--seconds=600", f"--domain={domain}")
    process = subprocess.Popen(line, env=ours, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    while " Hz, from " not in process.stdout.readline():
        assert process.poll() is None
    process.send_signal(2)
    rest, errors = process.communicate(timeout=20)
    assert process.returncode == 130, errors
    assert float(rest.splitlines()[-1].split()[0]) > 1 and "Traceback" not in errors


HELD = ROBOT.replace("rclpy.init(", "rclpy.init(args=['--ros-args', '-p', 'use_sim_time:=true'], ")


@pytest.mark.parametrize(
    "arguments", [("hz", "/robot/status", "--seconds=1"), ("echo", "/robot/status", "--timeout=3")]
)
def test_a_topic_whose_node_waits_for_the_clock_is_told(arguments, start_script, domain):
    assert start_script(HELD).stdout.readline() == "up\n"
    seen = workbook("topic", *arguments, f"--domain={domain}")
    told = " ".join((seen.stderr + seen.stdout).split())
    assert told.count("/robot/status uses simulated time (use_sim_time), but no node publishes /clock.") == 1
    assert "no message" in told.lower()


def test_an_endless_echo_ends_cleanly_on_interrupt(robot, domain):
    line, ours = command("topic", "echo", "/robot/status", f"--domain={domain}")
    process = subprocess.Popen(line, env=ours, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "data: operational\n"
    process.send_signal(2)
    _, errors = process.communicate(timeout=20)
    assert process.returncode == 130, errors
    assert "Traceback" not in errors


def test_a_terminal_joins_the_open_notebook(open_kernel):
    kernel = open_kernel("08 status & more")
    kernel.good("init(); talker = fresh(Talker)")
    label = [notebook for notebook in open_notebooks() if notebook.pid == kernel.pid]
    domain = int(kernel.good("import os; print(os.environ['ROS_DOMAIN_ID'])").text)
    assert label == [OpenNotebook("08 status & more", domain, kernel.pid)]
    seen = workbook("node", "list", ROS_DOMAIN_ID=str(domain))
    assert seen.stdout == "/talker\n"
    assert "No notebook" not in seen.stderr
    kernel.close()
    assert not [notebook for notebook in open_notebooks() if notebook.pid == kernel.pid]


@pytest.fixture
def two_notebooks(monkeypatch):
    from workbook.cli import graph

    shown = [OpenNotebook("05_timers", 7, 1), OpenNotebook("08_status", 23, 2)]

    def choose(asked, environment, number=2, nodes=(0, 0)):
        count = dict(zip((7, 23), nodes, strict=True)).__getitem__
        return graph.choose_domain(asked, shown[:number], environment, count)

    return choose


def test_which_domain_a_terminal_looks_at(two_notebooks, capsys, monkeypatch):
    from workbook.cli.graph import NoChoice

    assert two_notebooks(5, "23") == 5
    assert two_notebooks(None, "44", number=1) == 7
    assert two_notebooks(None, "23") == 23
    assert capsys.readouterr().err == ""
    assert two_notebooks(None, "44", number=0) == 44
    assert two_notebooks(None, None, number=0) == 0
    assert "No notebook is open" in capsys.readouterr().err
    monkeypatch.setattr("sys.stdin", io.StringIO())
    with pytest.raises(NoChoice, match="--domain"):
        two_notebooks(None, None)
    assert "08_status (domain 23, no nodes)" in capsys.readouterr().err


def test_the_only_notebook_with_nodes_is_taken_and_named(two_notebooks, capsys, monkeypatch):
    from workbook.cli.graph import NoChoice

    monkeypatch.setattr("sys.stdin", io.StringIO())
    assert two_notebooks(None, None, nodes=(0, 1)) == 23
    assert capsys.readouterr().err == "Looking at 08_status (domain 23), the only open notebook with nodes.\n"
    with pytest.raises(NoChoice):
        two_notebooks(None, None, nodes=(2, 1))
    said = capsys.readouterr().err
    assert "05_timers (domain 7, 2 nodes)" in said
    assert "08_status (domain 23, 1 node)" in said


def test_nodes_of_a_domain_are_counted(robot, domain):
    with lease_domain() as other:
        code = (
            "from workbook.cli.graph import nodes_on\n"
            f"print(nodes_on({domain}), nodes_on({other.domain_id}), nodes_on({domain}))"
        )
        done = subprocess.run(
            [sys.executable, "-c", code], env=child_environment(domain), capture_output=True, text=True
        )
    assert done.stdout == "1 0 1\n", done.stderr


def test_a_person_is_asked_which_notebook_is_meant(two_notebooks, capsys, monkeypatch):
    ours, theirs = pty.openpty()
    os.write(ours, b"nine\n2\n")
    monkeypatch.setattr("sys.stdin", os.fdopen(theirs))
    assert two_notebooks(None, None) == 23
    os.close(ours)


def test_an_announcement_survives_odd_names_and_ends_when_withdrawn():
    announce(99, "my notebook / with @ everything " + "x" * 200)
    mine = [notebook for notebook in open_notebooks() if notebook.pid == os.getpid()]
    assert [notebook.domain_id for notebook in mine] == [99]
    assert mine[0].label.startswith("my notebook / with @ everything x")
    withdraw()
    assert not [notebook for notebook in open_notebooks() if notebook.pid == os.getpid()]


def test_the_join_line_makes_a_stock_ros_process_see_the_notebook(open_kernel):
    kernel = open_kernel()
    line = kernel.good(
        "from workbook.ros import join_line\ninit(); talker = fresh(Talker)\nprint(join_line())"
    ).text
    settings = dict(word.split("=") for word in line.removeprefix("export ").split())
    stock = child_environment(int(settings["ROS_DOMAIN_ID"]))
    del stock["FASTRTPS_DEFAULT_PROFILES_FILE"]
    code = (
        "import rclpy, sys, time\nfrom std_msgs.msg import String\nrclpy.init()\nnode = rclpy.create_node('real_ros')\n"
        "heard = []\nnode.create_subscription(String, '/chatter', heard.append, 10)\nend = time.monotonic() + 20\n"
        "alone = lambda: 'talker' not in node.get_node_names()\n"
        "while (alone() or not heard) and time.monotonic() < end: rclpy.spin_once(node, timeout_sec=0.1)\n"
        "print(heard[0].data.split()[0], sorted(node.get_node_names()))\nnode.destroy_node()\nrclpy.shutdown()\n"
    )
    process = subprocess.Popen(
        [sys.executable, "-c", code],
        env=stock | settings,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    kernel.good(
        "others = lambda: 'real_ros' in talker.get_node_names()\nawait run(talker, seconds=20, until=others)"
    )
    kernel.good("await run(talker, seconds=20, until=lambda: not others())")
    output, errors = process.communicate(timeout=30)
    assert output == "tick ['real_ros', 'talker']\n", errors

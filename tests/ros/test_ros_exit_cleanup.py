"""How processes end that used ROS and didn't clean up."""

from pathlib import Path

import pytest

START = """
from workbook.ros import init, fresh, run, spin_for
import asyncio, threading, time, rclpy
from rclpy.node import Node
from rclpy.executors import SingleThreadedExecutor, MultiThreadedExecutor
from std_msgs.msg import String
init()
node = fresh(Node, 'forgetful')
node.create_timer(0.01, lambda: None)
publisher = node.create_publisher(String, 'chatter', 10)
"""
SPIN_IN_A_THREAD = """
executor.add_node(node)
threading.Thread(target=executor.spin, daemon={daemon}).start()
time.sleep(0.2)
"""
SINGLE = "executor = SingleThreadedExecutor()"
SCRIPTS = {
    "nothing shut down": "spin_for(node, seconds=0.1)",
    "await": "asyncio.run(run(node, seconds=0.1))",
    "thread": SINGLE + SPIN_IN_A_THREAD.format(daemon=False),
    "daemon thread": SINGLE + SPIN_IN_A_THREAD.format(daemon=True),
    "many threads": "executor = MultiThreadedExecutor(4)" + SPIN_IN_A_THREAD.format(daemon=False),
    "global executor in a thread": """
threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()
time.sleep(0.2)
""",
    "rate in a thread": """
executor, rate = SingleThreadedExecutor(), node.create_rate(5)
def work():
    while rclpy.ok():
        try:
            rate.sleep()
        except Exception:
            return
threading.Thread(target=work).start()
"""
    + SPIN_IN_A_THREAD.format(daemon=True),
    "a second context": """
other = rclpy.Context()
rclpy.init(context=other)
node = Node('late', context=other)
executor = SingleThreadedExecutor(context=other)
"""
    + SPIN_IN_A_THREAD.format(daemon=False),
    "shut down by itself": "spin_for(node, seconds=0.1); node.destroy_node(); rclpy.shutdown()",
}


@pytest.mark.parametrize("code", SCRIPTS.values(), ids=SCRIPTS)
def test_a_script_that_forgets_to_shut_down_ends_with_zero(start_script, code):
    process = start_script(START + code)
    output, errors = process.communicate(timeout=30)
    assert process.returncode == 0, errors
    assert "Traceback" not in errors
    assert "terminate" not in errors
    assert output == ""


def test_what_was_written_into_a_file_that_nobody_closed_is_in_it(start_script, tmp_path):
    path = tmp_path / "log.csv"
    code = f"node.log = open({str(path)!r}, 'w'); node.itself = node; node.log.write('0.1, 85.5')"
    process = start_script(START + code)
    _, errors = process.communicate(timeout=30)
    assert process.returncode == 0, errors
    assert path.read_text() == "0.1, 85.5"


IN_A_KERNEL = {
    "await": "await run(talker, seconds=0.2)",
    "daemon thread": "node = talker\n" + SCRIPTS["daemon thread"],
}


@pytest.mark.parametrize("code", IN_A_KERNEL.values(), ids=IN_A_KERNEL)
def test_a_kernel_ends_with_zero_and_leaves_nothing(open_kernel, code):
    kernel = open_kernel()
    threads = "import threading\nprint(sorted(thread.name for thread in threading.enumerate()))"
    at_start = kernel.good(threads).text
    kernel.good("from rclpy.executors import SingleThreadedExecutor")
    kernel.good("import threading\ninit(); talker = fresh(Talker)\n" + code)
    if "Thread" not in code:
        assert kernel.good(threads).text == at_start
    # It can't leave behind memory that it doesn't map. /dev/shm itself is shared with other processes.
    mapped = Path(f"/proc/{kernel.pid}/maps").read_text()
    assert "/dev/shm/fast" not in mapped
    assert "/dev/shm/sem.fast" not in mapped
    children = Path(f"/proc/{kernel.pid}/task/{kernel.pid}/children").read_text()
    assert children == ""
    assert kernel.close() == 0

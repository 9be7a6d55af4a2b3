"""Nodes inside a notebook: created repeatedly, interrupted, and failing."""

import pytest


@pytest.fixture
def kernel(used_kernel):
    return used_kernel


def test_running_a_node_cell_again_leaves_one_node_and_no_warning(kernel):
    kernel.good("init()")
    cell = "talker = fresh(Talker)\nkept = globals().setdefault('kept', [])\nkept.append(talker)\ntalker"
    for _ in range(3):
        outcome = kernel.good(cell)
        assert "already registered" not in outcome.text + outcome.stderr
    names = kernel.good("print(talker.get_node_names(), talker.count_publishers('/chatter'), len(kept))")
    assert names.text == "['talker'] 1 3\n"


def test_a_factory_and_a_failing_constructor_leave_no_twins(kernel):
    kernel.good(
        "init()\n"
        "def pair(period):\n"
        "    return Talker(period), Node('listener', namespace='/arm')\n"
        "class Broken(Node):\n"
        "    def __init__(self):\n"
        "        super().__init__('broken')\n"
        "        raise ValueError('no motor')\n"
    )
    for _ in range(2):
        kernel.good(
            "a, b = fresh(pair, 0.1)\npairs = globals().setdefault('pairs', [])\npairs.append((a, b))"
        )
        failed = kernel.run("fresh(Broken)")
        assert (failed.error, failed.message) == ("ValueError", "no motor")
    names = kernel.good("print(sorted(a.get_node_names_and_namespaces()))")
    assert names.text == "[('listener', '/arm'), ('talker', '/')]\n"


def test_fresh_renames_a_node_whose_class_takes_no_name(kernel):
    kernel.good(
        "init()\nleft = fresh(Talker, name='left', namespace='/arm')\nright = fresh(Talker, name='right')"
    )
    names = kernel.good("print(sorted(left.get_node_names_and_namespaces()))")
    assert names.text == "[('left', '/arm'), ('right', '/')]\n"


def test_init_and_shutdown_can_be_repeated_and_stock_init_behaves_as_stock(kernel):
    kernel.good("init(); init(); talker = fresh(Talker)")
    twice = kernel.run("rclpy.init()")
    assert (twice.error, twice.message) == ("RuntimeError", "Context.init() must only be called once")
    kernel.good("await run(talker, until=lambda: talker.heard)")
    kernel.good("shutdown(); shutdown()")
    stale = kernel.run("await run(talker)")
    assert stale.error == "RuntimeError"
    assert "shut down" in stale.message
    kernel.good("rclpy.init()\ntalker = fresh(Talker)\nawait run(talker, until=lambda: talker.heard)")
    kernel.good("rclpy.shutdown()")
    kernel.good("init()\ntalker = fresh(Talker)\nspin_for(talker, seconds=5, until=lambda: talker.heard)")


def test_run_stops_exactly_when_the_condition_holds(kernel):
    kernel.good("init(); talker = fresh(Talker, 0.01)")
    for count in (3, 7, 20):
        outcome = kernel.good(
            f"await run(talker, until=lambda: len(talker.heard) >= {count})\nprint(len(talker.heard))"
        )
        assert outcome.text == f"{count}\n"
    outcome = kernel.run("await run(talker, seconds=0.2, until=lambda: False)")
    assert outcome.error == "TimeoutError"
    assert "0.2 s" in outcome.message


def test_a_condition_that_was_true_once_has_become_true(kernel):
    """As when a slider moves while the last frame is drawn: its cell would continue, but it has ended."""
    kernel.good(
        "init(); talker = fresh(Talker, 0.01)\n"
        "asked = []\n"
        "def third_time():\n"
        "    asked.append(1)\n"
        "    return len(asked) == 3\n"
        "await run(talker, until=third_time)\n"
        "asked.clear()\n"
        "spin_for(talker, seconds=60, until=third_time)"
    )


def test_run_returns_the_result_of_a_future(kernel):
    kernel.good(
        "from std_srvs.srv import Trigger\n"
        "init()\n"
        "node = fresh(Node, 'robot')\n"
        "def answer(request, response):\n"
        "    response.success, response.message = True, 'ready'\n"
        "    return response\n"
        "node.create_service(Trigger, 'stand_up', answer)\n"
        "client = node.create_client(Trigger, 'stand_up')\n"
    )
    outcome = kernel.good(
        "reply = await run(node, until=client.call_async(Trigger.Request()))\nprint(reply.message)"
    )
    assert outcome.text == "ready\n"


def test_run_refuses_what_is_no_node_with_a_helpful_word(kernel):
    kernel.good("init(); talker = fresh(Talker)")
    assert "fresh(Talker)" in kernel.run("await run(Talker)").message
    assert "expected a node, got int" in kernel.run("await run([talker, 3])").message
    kernel.good("talker.destroy_node()")
    assert "was destroyed" in kernel.run("await run(talker)").message
    kernel.good("talker = fresh(Talker)\nother = fresh(Node, 'other')")
    assert "already" in kernel.run("await asyncio.gather(run(talker), run([other, talker]))").message


@pytest.mark.parametrize("call", ["await run(node)", "spin_for(node, seconds=5)"])
def test_an_exception_in_a_callback_surfaces_plainly_and_the_kernel_stays_usable(kernel, call):
    kernel.good(
        "init()\n"
        "class Robot(Node):\n"
        "    def __init__(self):\n"
        "        super().__init__('robot')\n"
        "        self.create_timer(0.05, self.on_tick)\n"
        "    def on_tick(self):\n"
        "        return 1 / 0\n"
        "node = fresh(Robot)"
    )
    outcome = kernel.run(call)
    assert outcome.error == "ZeroDivisionError"
    assert "on_tick" in outcome.traceback
    assert "executors.py" not in outcome.traceback
    assert "workbook/ros" not in outcome.traceback
    kernel.good("talker = fresh(Talker)\nawait run(talker, until=lambda: talker.heard)")
    assert kernel.good("print(node.executor, talker.executor)").text == "None None\n"


CELLS_TO_INTERRUPT = {
    "idle await": "node = fresh(Node, 'idle'); go(); await run(node, seconds=None)",
    "busy await": "talker = fresh(Talker, 0.01); go(); await run(talker, seconds=50)",
    "with a picture": "talker = fresh(Talker, 0.01); go()\n"
    "await live(talker, each_frame=lambda: asyncio.sleep(0.01), seconds=50)",
    "endless callback": "node = fresh(Node, 'stuck')\ndef stuck():\n    go()\n    while True: pass\n"
    "node.create_timer(0.01, stuck); await run(node, seconds=50)",
    "blocking": "node = fresh(Node, 'idle'); go(); spin_for(node, seconds=50)",
    "stock spin of an idle node": "node = fresh(Node, 'idle'); go(); rclpy.spin(node)",
    "stock spin_once of an idle node": "node = fresh(Node, 'idle'); go(); rclpy.spin_once(node)",
    "stock init and spin in one cell": "shutdown(); rclpy.init(); node = Node('idle'); go()\n"
    "rclpy.spin(node)",
    "stock threads": "from rclpy.executors import MultiThreadedExecutor\n"
    "node = fresh(Node, 'idle'); many = MultiThreadedExecutor(2); many.add_node(node); go(); many.spin()",
}


@pytest.mark.parametrize("cell", CELLS_TO_INTERRUPT.values(), ids=CELLS_TO_INTERRUPT)
def test_interrupt_ends_the_cell_and_leaves_the_kernel_usable(open_kernel, cell):
    kernel = open_kernel()
    kernel.good("init()")
    request = kernel.start(cell)
    kernel.wait_for_text(request, "go")
    kernel.interrupt()
    outcome = kernel.finish(request, limit=10)
    assert outcome.error in {"Stopped", "StoppedInBetween", "KeyboardInterrupt"}
    if "stuck" in cell:
        assert "It was busy in stuck(), line " in outcome.traceback
    kernel.good(
        "assert rclpy.ok()\ntalker = fresh(Talker)\nawait run(talker, until=lambda: len(talker.heard) > 2)"
    )
    kernel.good("rclpy.spin_once(talker, timeout_sec=1.0)")
    assert kernel.close() == 0


INTERRUPTED = """
init()
import signal
from std_msgs.msg import String
talker = fresh(Talker, 0.02)
class Made:
    original, number = String.__init__, 0
def made(self, **fields):
    Made.original(self, **fields)
    Made.number += not fields
    if Made.number == 3 and not fields:
        signal.raise_signal(signal.SIGINT)
String.__init__ = made
"""
"""The interrupt comes while the third message is being created for a callback."""


@pytest.mark.parametrize(
    ("cell", "ends_with"),
    [
        ("await run(talker, seconds=50)", "Stopped"),
        ("spin_for(talker, seconds=50)", "StoppedInBetween"),
        ("rclpy.spin(talker)", "KeyboardInterrupt"),
    ],
)
def test_an_interrupt_while_a_message_is_made_ends_the_cell_and_not_the_node(open_kernel, cell, ends_with):
    kernel = open_kernel()
    kernel.good(INTERRUPTED)
    assert kernel.run(cell).error == ends_with
    heard = int(kernel.good("print(len(talker.heard))").text)
    assert heard in (2, 3)
    kernel.good(f"await run(talker, until=lambda: len(talker.heard) > {heard + 3})")
    assert kernel.close() == 0


AT_EACH_CALL = """
init()
import inspect, signal, sys, threading
LIBRARY_CALL = compile('''
def call(*arguments):
    if once and sys._getframe(1).f_code.co_name in callers:
        once.clear()
        signal.raise_signal(signal.SIGINT)
    return original(*arguments)
''', threading.__file__, 'exec')
ticks = []
node = fresh(Node, "robot")
node.create_timer(0.02, lambda: ticks.append(1))
def interrupt_in(owner, name, caller):
    place = dict(once=[1], callers=[caller], original=getattr(owner, name), sys=sys, signal=signal)
    exec(LIBRARY_CALL, place)
    setattr(owner, name, place["call"])
"""
"""The interrupt comes in Python's standard library, which rclpy calls just before a callback."""
PLACES = (
    "inspect, 'iscoroutine', '__call__'",
    "threading.Condition, '__enter__', '__enter__'",
    "threading.Condition, '__exit__', '__enter__'",
)


def test_an_interrupt_between_two_callbacks_locks_nothing(kernel):
    kernel.good(AT_EACH_CALL)
    for place in PLACES:
        outcome = kernel.run(f"interrupt_in({place}); spin_for(node, seconds=50)")
        assert outcome.error == "StoppedInBetween"
        kernel.good("ticks.clear(); spin_for(node, seconds=20, until=lambda: len(ticks) > 3)")


def test_a_callback_that_waits_in_pythons_library_can_be_stopped(kernel):
    kernel.good("init(); import queue; never = queue.Queue(); node = fresh(Node, 'robot')")
    waits = "node.create_timer(0.01, lambda: (go(), never.get())); await run(node, seconds=50)"
    request = kernel.start(waits)
    kernel.wait_for_text(request, "go")
    kernel.interrupt()
    assert kernel.finish(request, limit=10).error == "Stopped"


def test_other_tasks_and_pictures_go_on_while_nodes_run(kernel):
    kernel.good("init(); talker = fresh(Talker, 0.02)")
    outcome = kernel.good(
        "frames, beats = [], []\n"
        "async def beat():\n"
        "    while True:\n"
        "        beats.append(time.monotonic())\n"
        "        await asyncio.sleep(0.05)\n"
        "task = asyncio.create_task(beat())\n"
        "await live(talker, each_frame=lambda: frames.append(len(talker.heard)), seconds=1.0, fps=20)\n"
        "task.cancel()\n"
        "print(len(frames), len(beats), frames[-1] == len(talker.heard))"
    )
    frames, beats, last = outcome.text.split()
    assert 3 <= int(frames) <= 22
    assert 3 <= int(beats) <= 21
    assert last == "True"


def test_pictures_slower_than_their_rate_leave_room_for_messages(kernel):
    # Each frame takes twice as long as its rate allows, as on a slow or busy machine.
    heard = kernel.good(
        "init()\n"
        "talker = fresh(Talker, 0.02)\n"
        "await run(talker, until=lambda: talker.heard)\n"
        "before = len(talker.heard)\n"
        "await live(talker, each_frame=lambda: time.sleep(0.1), seconds=2.0, fps=20)\n"
        "print(len(talker.heard) - before >= 10)"
    )
    assert heard.text == "True\n"


def test_a_coroutine_callback_that_waits_at_the_end_does_not_lock_its_group(kernel):
    kernel.good(
        "from rclpy.task import Future\n"
        "init()\n"
        "node = fresh(Node, 'patient')\n"
        "never, calls = Future(), []\n"
        "async def wait():\n"
        "    calls.append(1)\n"
        "    await never\n"
        "node.create_timer(0.02, wait)\n"
    )
    for count in (1, 2):
        outcome = kernel.good("await run(node, seconds=0.3)\nprint(len(calls))")
        assert outcome.text == f"{count}\n"


def test_a_node_goes_back_to_its_own_executor(kernel):
    outcome = kernel.good(
        "from rclpy.executors import SingleThreadedExecutor\n"
        "init(); talker = fresh(Talker); own = SingleThreadedExecutor(); own.add_node(talker)\n"
        "await run(talker, until=lambda: talker.heard)\n"
        "print(talker.executor is own, own.get_nodes() == [talker])"
    )
    assert outcome.text == "True True\n"


def test_two_open_notebooks_do_not_hear_each_other(open_kernel):
    first, second = open_kernel("one"), open_kernel("two")
    for kernel, name in ((first, "one"), (second, "two")):
        kernel.good(f"init(); talker = fresh(Talker, 0.02, name='{name}')")
    requests = [kernel.start("await run(talker, seconds=1.5)") for kernel in (first, second)]
    for kernel, request in zip((first, second), requests, strict=True):
        assert kernel.finish(request).error is None
    for kernel, name in ((first, "one"), (second, "two")):
        names = kernel.good("print(talker.get_node_names(), talker.count_publishers('/chatter'))")
        assert names.text == f"['{name}'] 1\n"
        assert kernel.good("print(len(talker.heard) > 5)").text == "True\n"
        assert kernel.good("print(len(set(talker.heard)) == len(talker.heard))").text == "True\n"

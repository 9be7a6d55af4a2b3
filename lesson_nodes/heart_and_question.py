"""A heartbeat and a question in one node: does the heart go on while the question waits for its answer?

Run it with ``python -m lesson_nodes.heart_and_question --ros-args -p way:=await -p group:=own`` and end it with Ctrl-C.
Some ways hang for good; such a process has to be killed.
"""

import math
import threading
import time
from typing import Any

import rclpy
from rclpy.callback_groups import CallbackGroup, MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.context import Context
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.signals import SignalHandlerOptions
from rclpy.task import Future
from std_msgs.msg import String
from std_srvs.srv import Trigger

SERVICE = "/robot/self_test"
WAYS = ("call", "call_timeout", "await", "spin_until", "done_callback")
GROUPS = ("default", "own", "reentrant")
SERVERS = ("elsewhere", "same node")
BEAT_PERIOD_S = 0.1
ASK_PERIOD_S = 0.5
TIMEOUT_S = 0.4
PATIENCE_S = 20.0


class SelfTest(Node):
    """Answers the self-test: all is well.

    Services:
        /robot/self_test (std_srvs/Trigger).
    """

    def __init__(self, context: Context, takes_s: float) -> None:
        super().__init__("self_test", context=context, use_global_arguments=False)
        self.takes_s = takes_s
        self.create_service(Trigger, SERVICE, self.on_call)

    def on_call(self, request: Trigger.Request, response: Trigger.Response) -> Trigger.Response:
        """Take the time that it takes, and answer."""
        time.sleep(self.takes_s)
        response.success = True
        return response


class HeartAndQuestion(Node):
    """Beats ten times a second, and asks for a self-test twice a second.

    Topics:
        /robot/heartbeat (std_msgs/String), 10 Hz.
        /robot/asked (std_msgs/String): when a question goes out.
        /robot/answered (std_msgs/String): when the callback has its answer.

    Calls:
        /robot/self_test (std_srvs/Trigger).

    Parameters:
        way (str): How it asks, one of WAYS.
        group (str): The callback group of the client. "default": that of all the rest. "own": another one. "reentrant":
            client and question share one that lets all of them in.
        server (str): "elsewhere", or "same node": in the group of the question.
        server_takes_s (float): How long the answer takes, in seconds.
        threads (int): Threads of the executor.

    Raises:
        ValueError: A parameter is none of these.
    """

    def __init__(self) -> None:
        super().__init__("heart_and_question")
        way = self._chosen("way", WAYS)
        group = self._chosen("group", GROUPS)
        self.server = self._chosen("server", SERVERS)
        self.threads: int = self.declare_parameter("threads", 1).value
        self.takes_s: float = self.declare_parameter("server_takes_s", 0.0).value
        if not 0.0 <= self.takes_s < math.inf:
            raise ValueError(f"An answer takes 0 s or longer, not {self.takes_s}.")
        groups: dict[str, CallbackGroup] = {
            "default": self.default_callback_group,
            "own": MutuallyExclusiveCallbackGroup(),
            "reentrant": ReentrantCallbackGroup(),
        }
        question_group = groups["reentrant" if group == "reentrant" else "default"]
        self.heart = self.create_publisher(String, "/robot/heartbeat", 10)
        self.asked = self.create_publisher(String, "/robot/asked", 10)
        self.answered = self.create_publisher(String, "/robot/answered", 10)
        self.self_test = self.create_client(Trigger, SERVICE, callback_group=groups[group])
        self.create_timer(BEAT_PERIOD_S, self.beat)
        self.create_timer(ASK_PERIOD_S, getattr(self, f"ask_by_{way}"), callback_group=question_group)
        if self.server == "same node":
            self.create_service(Trigger, SERVICE, self.on_call, callback_group=question_group)

    def _chosen(self, name: str, allowed: tuple[str, ...]) -> str:
        word: str = self.declare_parameter(name, allowed[0]).value
        if word not in allowed:
            raise ValueError(f"{name} is one of {', '.join(allowed)}, not {word!r}.")
        return word

    def beat(self) -> None:
        """Say that this node lives."""
        self.heart.publish(String(data="beat"))

    def note(self, response: Any) -> None:
        """Say that the answer is there, if it is one."""
        if response is not None:
            self.answered.publish(String(data="answer"))

    def ask_by_call(self) -> None:
        """Wait for the answer, for as long as it takes."""
        self.asked.publish(String(data="question"))
        response = self.self_test.call(Trigger.Request())
        self.note(response)

    def ask_by_call_timeout(self) -> None:
        """Wait for the answer, for 0.4 s."""
        self.asked.publish(String(data="question"))
        response = self.self_test.call(Trigger.Request(), timeout_sec=TIMEOUT_S)
        self.note(response)

    async def ask_by_await(self) -> None:
        """Leave the thread to others until the answer is there."""
        self.asked.publish(String(data="question"))
        response = await self.self_test.call_async(Trigger.Request())
        self.note(response)

    def ask_by_spin_until(self) -> None:
        """Spin the node from inside the callback, for 0.4 s."""
        self.asked.publish(String(data="question"))
        future = self.self_test.call_async(Trigger.Request())
        rclpy.spin_until_future_complete(self, future, timeout_sec=TIMEOUT_S)
        self.note(future.result())

    def ask_by_done_callback(self) -> None:
        """Do not wait: leave a note what to do with the answer, and return."""
        self.asked.publish(String(data="question"))
        future = self.self_test.call_async(Trigger.Request())
        future.add_done_callback(self.on_answer)

    def on_answer(self, future: Future) -> None:
        """Called by the executor when the answer is there."""
        self.note(future.result())

    def on_call(self, request: Trigger.Request, response: Trigger.Response) -> Trigger.Response:
        """The self-test, where this node offers it itself."""
        time.sleep(self.takes_s)
        response.success = True
        return response


class Elsewhere:
    """A server that shares nothing with the node that asks: another context, executor and thread."""

    def __init__(self, takes_s: float) -> None:
        self.context = Context()
        rclpy.init(context=self.context, signal_handler_options=SignalHandlerOptions.NO)
        self.node = SelfTest(self.context, takes_s)
        self.executor = SingleThreadedExecutor(context=self.context)
        self.executor.add_node(self.node)
        self.thread = threading.Thread(target=self._serve, daemon=True)
        self.thread.start()

    def _serve(self) -> None:
        try:
            self.executor.spin()
        except ExternalShutdownException:
            pass

    def close(self) -> None:
        """End the server and its thread."""
        self.executor.shutdown()
        rclpy.try_shutdown(context=self.context)  # Ctrl-C may have shut it down already
        self.thread.join()


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or a request to end, then leave with exit code 0 if nothing hangs."""
    rclpy.init(args=args)
    node = HeartAndQuestion()
    elsewhere = Elsewhere(node.takes_s) if node.server == "elsewhere" else None
    try:
        node.self_test.wait_for_service(timeout_sec=PATIENCE_S)
        if node.threads == 1:
            rclpy.spin(node)
        else:
            executor = MultiThreadedExecutor(node.threads)
            executor.add_node(node)
            executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        if elsewhere is not None:
            elsewhere.close()
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()

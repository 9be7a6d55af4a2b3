"""Run a heartbeat and a service client in one node. Does the heartbeat continue while a request is open?

Run it with ``python -m lesson_nodes.heart_and_question --ros-args -p way:=await -p group:=own`` and end it with Ctrl-C.
Some of the ways to wait hang forever, and then the process has to be killed.
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
    """Responds to each self-test request: all is well.

    Services:
        /robot/self_test (std_srvs/Trigger).
    """

    def __init__(self, context: Context, takes_s: float) -> None:
        super().__init__("self_test", context=context, use_global_arguments=False)
        self.takes_s = takes_s
        self.create_service(Trigger, SERVICE, self.on_call)

    def on_call(self, request: Trigger.Request, response: Trigger.Response) -> Trigger.Response:
        """Sleep for the response time, then respond."""
        time.sleep(self.takes_s)
        response.success = True
        return response


class HeartAndQuestion(Node):
    """Publishes ten heartbeats a second, and requests a self-test twice a second.

    Topics:
        /robot/heartbeat (std_msgs/String), 10 Hz.
        /robot/asked (std_msgs/String): published right before each request.
        /robot/answered (std_msgs/String): published when the node has a response.

    Calls:
        /robot/self_test (std_srvs/Trigger).

    Parameters:
        way (str): How the node waits for the response, one of WAYS.
        group (str): The client's callback group. "default": the node's default group. "own": a separate group.
            "reentrant": a reentrant group that also contains the timer that sends the requests.
        server (str): "elsewhere": in another context, or "same node": in the group of the requesting timer.
        server_takes_s (float): How long the response takes, in seconds.
        threads (int): Number of executor threads.

    Raises:
        ValueError: A parameter's value is invalid.
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
        """Publish a heartbeat."""
        self.heart.publish(String(data="beat"))

    def note(self, response: Any) -> None:
        """Report that a response has arrived, unless it's None."""
        if response is not None:
            self.answered.publish(String(data="answer"))

    def ask_by_call(self) -> None:
        """Send a request, and block until the response arrives."""
        self.asked.publish(String(data="question"))
        response = self.self_test.call(Trigger.Request())
        self.note(response)

    def ask_by_call_timeout(self) -> None:
        """Send a request, and block until the response arrives, for at most 0.4 s."""
        self.asked.publish(String(data="question"))
        response = self.self_test.call(Trigger.Request(), timeout_sec=TIMEOUT_S)
        self.note(response)

    async def ask_by_await(self) -> None:
        """Send a request, and free the thread for other callbacks until the response arrives."""
        self.asked.publish(String(data="question"))
        response = await self.self_test.call_async(Trigger.Request())
        self.note(response)

    def ask_by_spin_until(self) -> None:
        """Send a request, and spin the node from inside the callback, for at most 0.4 s."""
        self.asked.publish(String(data="question"))
        future = self.self_test.call_async(Trigger.Request())
        rclpy.spin_until_future_complete(self, future, timeout_sec=TIMEOUT_S)
        self.note(future.result())

    def ask_by_done_callback(self) -> None:
        """Send a request, register a callback for the response, and return without waiting."""
        self.asked.publish(String(data="question"))
        future = self.self_test.call_async(Trigger.Request())
        future.add_done_callback(self.on_answer)

    def on_answer(self, future: Future) -> None:
        """Report the response. The executor calls this method when the response has arrived."""
        self.note(future.result())

    def on_call(self, request: Trigger.Request, response: Trigger.Response) -> Trigger.Response:
        """Respond to a self-test request, if this node offers the service itself."""
        time.sleep(self.takes_s)
        response.success = True
        return response


class Elsewhere:
    """Runs the server separately from the client's node: in another context, executor, and thread."""

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
        """Stop the server and its thread."""
        self.executor.shutdown()
        rclpy.try_shutdown(context=self.context)  # Ctrl-C may have shut it down already
        self.thread.join()


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0, unless a call hangs."""
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

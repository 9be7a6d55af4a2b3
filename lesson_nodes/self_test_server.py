"""Simulate a robot that tests itself on request: it offers the service /robot/self_test.

Run it with ``python -m lesson_nodes.self_test_server`` and end it with Ctrl-C.
"""

import math

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.task import Future
from std_srvs.srv import Trigger

PATTERN = "ok"
SLOW_S = 0.7
ANSWERS = ("ok", "faulty", "slow", "never")


class SelfTestServer(Node):
    """Responds to self-test requests: right away, late, or not at all.

    Services:
        /robot/self_test (std_srvs/Trigger): whether all joints move as they should.

    Parameters:
        pattern (str): The responses to successive calls, separated by commas: "ok", "faulty", "slow" (ok, but late), or
            "never". After the last word, the pattern starts over.
        slow_s (float): How long a slow response takes, in seconds.

    Raises:
        ValueError: The pattern contains another word, or `slow_s` is not a positive number.
    """

    def __init__(self) -> None:
        super().__init__("self_test_server")
        pattern = self.declare_parameter("pattern", PATTERN).value
        self.slow_s = self.declare_parameter("slow_s", SLOW_S).value
        self.pattern = [word.strip() for word in pattern.split(",")]
        for word in self.pattern:
            if word not in ANSWERS:
                raise ValueError(f"A call is answered with one of {', '.join(ANSWERS)}, not {word!r}.")
        if not 0.0 < self.slow_s < math.inf:
            raise ValueError(f"A slow answer takes some time, for example 0.7 s, not {self.slow_s}.")
        self.calls = 0
        # Reentrant, so that further calls are handled while a slow one is still waiting.
        self.group = ReentrantCallbackGroup()
        # rclpy accepts a coroutine here, but its type hints don't.
        self.create_service(Trigger, "/robot/self_test", self.on_call, callback_group=self.group)  # type: ignore[misc]
        self.get_logger().info("Self-test server started")

    async def on_call(self, request: Trigger.Request, response: Trigger.Response) -> Trigger.Response:
        """Respond as the pattern says. This is a coroutine, so other callbacks run while it waits."""
        word = self.pattern[self.calls % len(self.pattern)]
        self.calls += 1
        if word == "slow":
            await self.passed(self.slow_s)
        elif word == "never":
            await Future()
        response.success = word != "faulty"
        response.message = "all joints move" if response.success else "the left knee is stiff"
        return response

    def passed(self, seconds: float) -> Future:
        """Return a future that completes after this time."""
        future = Future()

        def ring() -> None:
            self.destroy_timer(timer)
            future.set_result(None)

        timer = self.create_timer(seconds, ring, callback_group=self.group)
        return future


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(SelfTestServer())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()

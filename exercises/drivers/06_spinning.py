"""Calls `pump` of an answer, each time that somebody says so on /driver/go, and announces begin and end of each call.

    /driver/go (std_msgs/String), heard: "1 robot 1.5" means that call 1 is pump(robot, 1.5). An order may come again.
    /driver/pump (std_msgs/String), said: "begin 1", then "end 1 1.501" (it took 1.501 s) or "raised 1 TypeError: ...";
        "missing" if the answer has no such function. The last one is said again and again until something new happens.

What the robots do, they tell with the number of the call in which they did it, 0 between the calls. So it does not
matter when a message arrives on a busy machine. The driver speaks from a context of its own: it can still tell what
happened when an answer shuts ROS down.
"""

import time
import traceback
from collections.abc import Iterable
from time import monotonic

import answer
import rclpy
from rclpy.context import Context
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.publisher import Publisher
from std_msgs.msg import Int32, Int32MultiArray, String

HEARTBEAT_PERIOD_S = 0.1
LOOK_PERIOD_S = 0.5
JOB_S = 0.4
REPEAT_S = 0.1
PATIENCE_S = 1.0


class Teller(Node):
    """A node that tells what it does, and in which call of pump.

    Attributes:
        call: The number of the call that runs now; 0 if none does.
    """

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.call = 0

    def tell(self, publisher: Publisher, number: int) -> None:
        """Publish the number of the call and another number."""
        publisher.publish(Int32MultiArray(data=[self.call, number]))


class Robot(Teller):
    """A robot with two timers that listens to words, and to jobs of 0.4 s.

    Topics:
        /robot/heartbeat (std_msgs/Int32MultiArray), 10 Hz, and /robot/look, 2 Hz: the call; how many there were.
        /robot/heard: the call; each number from /robot/words (std_msgs/Int32).
        /robot/job_begun: the call; each number from /robot/jobs (std_msgs/Int32).
    """

    def __init__(self) -> None:
        super().__init__("robot")
        self.heartbeats = 0
        self.looks = 0
        self.heartbeat_publisher = self.create_publisher(Int32MultiArray, "/robot/heartbeat", 100)
        self.look_publisher = self.create_publisher(Int32MultiArray, "/robot/look", 100)
        self.heard_publisher = self.create_publisher(Int32MultiArray, "/robot/heard", 100)
        self.job_publisher = self.create_publisher(Int32MultiArray, "/robot/job_begun", 100)
        self.create_timer(HEARTBEAT_PERIOD_S, self.beat)
        self.create_timer(LOOK_PERIOD_S, self.look_around)
        self.create_subscription(Int32, "/robot/words", self.hear, 100)
        self.create_subscription(Int32, "/robot/jobs", self.work, 100)

    def beat(self) -> None:
        """Tell that the robot lives."""
        self.heartbeats += 1
        self.tell(self.heartbeat_publisher, self.heartbeats)

    def look_around(self) -> None:
        """Tell that the robot has looked around."""
        self.looks += 1
        self.tell(self.look_publisher, self.looks)

    def hear(self, word: Int32) -> None:
        """Repeat a word."""
        self.tell(self.heard_publisher, word.data)

    def work(self, job: Int32) -> None:
        """Do a job that takes its time."""
        self.tell(self.job_publisher, job.data)
        time.sleep(JOB_S)


class QuietRobot(Teller):
    """A robot without timers: as long as nobody talks to it, it has nothing to do.

    Topics:
        /quiet/heard (std_msgs/Int32MultiArray): the call; each number from /quiet/words (std_msgs/Int32).
    """

    def __init__(self) -> None:
        super().__init__("quiet_robot")
        self.heard_publisher = self.create_publisher(Int32MultiArray, "/quiet/heard", 100)
        self.create_subscription(Int32, "/quiet/words", self.hear, 100)

    def hear(self, word: Int32) -> None:
        """Repeat a word."""
        self.tell(self.heard_publisher, word.data)


class Driver(Node):
    """Hears what is to be pumped, and says what came of it.

    Attributes:
        orders: What was ordered, by the number of the call.
    """

    def __init__(self, context: Context) -> None:
        super().__init__("driver", context=context)
        self.orders: dict[int, str] = {}
        self.latest = ""
        self.publisher: Publisher | None = None
        self.create_subscription(String, "/driver/go", self.take_order, 100)

    def wait_for_speakers(self, robots: Iterable[Node]) -> None:
        """Wait until somebody is there to speak to all that listen, but not for long; then announce that we are there.

        Who hears our first word may speak at once, and what is said before both ends know each other is lost.
        """
        ears = [ear for node in (self, *robots) for ear in node.subscriptions]
        end = monotonic() + PATIENCE_S
        while monotonic() < end and not all(ear.get_publisher_count() for ear in ears):
            time.sleep(0.01)
        self.publisher = self.create_publisher(String, "/driver/pump", 100)

    def take_order(self, message: String) -> None:
        """Note an order; one that is known already changes nothing."""
        number, _, order = message.data.partition(" ")
        self.orders.setdefault(int(number), order)

    def say(self, text: str) -> None:
        """Announce something on /driver/pump."""
        self.latest = text
        self.say_again()

    def say_again(self) -> None:
        """Announce the latest once more: on a busy machine a message may get lost until the next one comes."""
        if self.latest and self.publisher is not None:
            self.publisher.publish(String(data=self.latest))

    def carry_out(self, call: int, node: Teller, seconds: float) -> None:
        """Call `pump` once."""
        if not callable(getattr(answer, "pump", None)):
            self.say("missing")
            return
        self.say(f"begin {call}")
        node.call = call
        begin = monotonic()
        try:
            answer.pump(node, seconds)
        except Exception as error:
            traceback.print_exc()
            news = f"raised {call} {type(error).__name__}: {error}"
        else:
            news = f"end {call} {monotonic() - begin:.3f}"
        node.call = 0
        self.say(news)


def main() -> None:
    """Carry out orders until Ctrl-C."""
    context = Context()
    rclpy.init(context=context)
    if not rclpy.ok():
        rclpy.init()
    driver = Driver(context)
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(driver)
    robots = {robot.get_name(): robot for robot in (Robot(), QuietRobot())}
    driver.wait_for_speakers(robots.values())
    done: set[int] = set()
    try:
        while True:
            executor.spin_once(timeout_sec=REPEAT_S)
            driver.say_again()
            for call in sorted(driver.orders.keys() - done):
                name, seconds = driver.orders[call].split()
                driver.carry_out(call, robots[name], float(seconds))
                done.add(call)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()
        rclpy.try_shutdown(context=context)


if __name__ == "__main__":
    main()

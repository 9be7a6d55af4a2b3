# ---
# exercise: 09_joint_positions
# title: The joint positions
# minutes: 25
# difficulty: 2
# kind: program
# clock: simulated
# objectives:
#   - adding a third topic to a working node without disturbing the other two
#   - converting a rate in hertz to a timer period
#   - filling the array field of a Float32MultiArray message
#   - simulating a sensor whose readings (angles in radians) change over time
# out_of_scope:
#   - reading real encoders or commanding motors
#   - named joints (JointState) and URDF, which come in a later lesson
#   - how the program ends (lesson 01 judges that) and how the code is written
# ---
# %% [markdown]
# # Exercise 09 · The joint positions
#
# Your humanoid already reports its status (*operational*) and its battery charge (97 %). But the operator can't see how
# the robot's body moves. The operator's screen shows a figure of the robot with twelve joints, and that figure stays
# frozen, because no node publishes the joint angles. Add a third topic to the status publisher so that the figure moves
# along with the robot.
#
# **About 25 minutes · difficulty 2 of 5 · 10 points.** This exercise builds on lesson [09](../notebooks/09_joint_positions.ipynb). The
# starter code below contains the status publisher from lesson [08](../notebooks/08_humanoid_status_publisher.ipynb).
#
# ## What to build
#
# | topic | type | rate | content |
# |---|---|---|---|
# | `/robot/joint_positions` (new) | `Float32MultiArray` | 0.5 Hz | 12 angles in rad, each within ±π, that change over time |
# | `/robot/status` (unchanged) | `String` | 1 Hz | `operational` while the battery has charge, `error` once it's empty |
# | `/robot/battery` (unchanged) | `Float32` | 0.5 Hz | the charge in percent, from 0 to 100, which falls over time and never rises |
#
# The screen expects the twelve angles in this order:
#
# - neck, waist
# - left shoulder, left elbow, right shoulder, right elbow
# - left hip, left knee, left ankle
# - right hip, right knee, right ankle
#
# The message types are all in `std_msgs.msg`. How the simulated joints move is up to you. For example, they can follow
# a sine wave or a random walk, or make the robot wave. At least two of the angles must change from one message to the
# next. There's one exception: up to a quarter of the messages may repeat the previous message's angles, for example
# when a movement reverses.
#
# ## What is judged
#
# Your program runs in its own process for {{plan.simulated_s}} s of simulated time. The judge checks only the messages
# that your program publishes.
#
# | points | criterion |
# |---:|---|
# | 2 | `/robot/joint_positions` exists and carries `Float32MultiArray` messages |
# | 1 | every message has exactly 12 values |
# | 1 | every value is a finite number within ±π rad |
# | 1 | at least two joint angles change from one message to the next |
# | 2 | the joint positions are published at a steady 0.5 Hz (0.4 to 0.6 Hz, no gap over 3 s) |
# | 1 | `/robot/status` works as before (0.8 to 1.2 Hz, no gap over 1.5 s; the status matches the battery charge) |
# | 1 | `/robot/battery` works as before (0.4 to 0.6 Hz, no gap over 3 s; the charge falls) |
# | 1 | the program is still running at the end of the run |
#
# Your program must get as far as creating a publisher. If it doesn't, the feedback explains why, and none of the
# criteria above is judged. You may structure the program any way you like: with one node or several, and with any
# executor.
#
# **Not judged:**
#
# - motors, real encoders, URDF, other topics
# - the order of the angles (the screen depends on it, but the judge doesn't check it)
# - the battery's initial charge, and how fast the battery drains. (It's fine if the battery isn't empty by the end of
#   the run.)
# - how your program ends on Ctrl-C
# %% [answer]
"""Simulate a humanoid robot that publishes its status, its battery charge, and the angles of its twelve joints."""

import math
import random

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

# [solution]
from std_msgs.msg import Float32, Float32MultiArray, String

# [starter]
# | from std_msgs.msg import Float32, String  # TODO 1: import the message type with an array of floats
# |
# [end]
STATUS_PERIOD_S = 1.0
BATTERY_PERIOD_S = 2.0
DRAIN_PERCENT = (0.1, 0.5)
# [solution]
JOINT_PERIOD_S = 2.0  # 0.5 Hz: one message every two seconds
JOINT_COUNT = 12
SWING_RAD = 0.4
SWING_PERIOD_S = 9.0  # not 2.0, because then every message would contain the same pose
# [end]


class HumanoidStatusPublisher(Node):
    """Publishes the robot's status, its battery charge, and its joint angles.

    Topics:
        /robot/status (std_msgs/String), 1 Hz: "operational", or "error" once the battery is empty.
        /robot/battery (std_msgs/Float32), 0.5 Hz: charge in percent, from 100.0 down to 0.0.
        /robot/joint_positions (std_msgs/Float32MultiArray), 0.5 Hz: 12 angles in radians.
    """

    def __init__(self) -> None:
        super().__init__("humanoid_status_publisher")
        self.battery_level = 100.0
        self.status_publisher = self.create_publisher(String, "/robot/status", 10)
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
        # [solution]
        self.joint_publisher = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        # [starter]
        # | # TODO 2: create the publisher for /robot/joint_positions
        # [end]
        self.status_timer = self.create_timer(STATUS_PERIOD_S, self.publish_status)
        self.battery_timer = self.create_timer(BATTERY_PERIOD_S, self.publish_battery)
        # [solution]
        self.joint_timer = self.create_timer(JOINT_PERIOD_S, self.publish_joint_positions)
        # [starter]
        # | # TODO 3: create a timer for 0.5 Hz. What's the period in seconds?
        # [end]
        self.get_logger().info("Humanoid status publisher started")

    def publish_status(self) -> None:
        """Publish whether the robot can work."""
        message = String(data="operational" if self.battery_level > 0.0 else "error")
        self.status_publisher.publish(message)
        self.get_logger().info(f"Status: {message.data}")

    def publish_battery(self) -> None:
        """Drain the simulated battery a little, but never below 0 %, and publish its charge."""
        self.battery_level = max(0.0, self.battery_level - random.uniform(*DRAIN_PERCENT))
        self.battery_publisher.publish(Float32(data=self.battery_level))
        self.get_logger().info(f"Battery: {self.battery_level:.1f} %")

    # [solution]
    def joint_angles(self) -> list[float]:
        """Simulate the joints: each one swings around zero, a little later than the previous joint.

        The angles depend on the node's clock, not on a count of messages. So a faster timer doesn't speed up
        the robot, but publishes the same movement in finer steps.

        Returns:
            12 angles in radians, each within ±0.4.
        """
        seconds = self.get_clock().now().nanoseconds / 1e9
        return [
            SWING_RAD * math.sin(2.0 * math.pi * (seconds / SWING_PERIOD_S - joint / JOINT_COUNT))
            for joint in range(JOINT_COUNT)
        ]

    def publish_joint_positions(self) -> None:
        """Publish the current joint angles."""
        message = Float32MultiArray(data=self.joint_angles())
        self.joint_publisher.publish(message)
        self.get_logger().info(f"Joints: {', '.join(f'{angle:.2f}' for angle in message.data)} rad")

    # [starter]
    # | # TODO 4: write the method that the new timer calls. It creates a message, puts 12 angles
    # | #         in radians (let them move!) into the data field, and publishes the message.
    # |
    # [end]

def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(HumanoidStatusPublisher())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
# %% [markdown]
# ## Three questions to think about
#
# Lesson [09](../notebooks/09_joint_positions.ipynb) answers all three with measurements. Write down your own answers
# before you look.
#
# 1. Should the joint positions be published more or less often than the battery level? Why?
# 2. What would another node do with these angles, and how would it receive them?
# 3. What happens if you publish them at 100 Hz instead of 0.5 Hz?
# %% [live]
# from workbook.lesson import watch_robot
#
# %start
# await watch_robot(seconds=8)

# %% [hint]
# The battery topic already has everything that you need: a publisher, a timer, and a method that fills a message. Find
# these three places in the code. What has to be different for the joints? Be careful with the timer: it takes a period,
# but the task specifies a rate.
#
# How topics work: [About topics](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Topics.html)
# %% [hint]
# - Import `Float32MultiArray` from `std_msgs.msg`. Its field `data` takes a list of floats.
# - `self.create_publisher(type, name, 10)`: write the name with its leading slash, `/robot/joint_positions`.
# - `self.create_timer(period, method)`: the period in seconds is 1 divided by the rate. Pass the method without `()`.
# - A list of twelve values: `[... for joint in range(12)]`. `math.sin` stays between −1 and 1, well within ±π. Its
#   argument must change over time, so use a counter or the time in seconds: `self.get_clock().now().nanoseconds / 1e9`.
#
# The node's methods are listed in the [rclpy documentation](https://docs.ros.org/en/jazzy/p/rclpy).
# %% [hint]
# The body of the new method, with gaps:
#
# ```python
# def publish_joint_positions(self) -> None:
#     seconds = self.get_clock().now().nanoseconds / 1e9
#     message = Float32MultiArray()
#     message.data = [___ * math.sin(0.7 * seconds + joint) for joint in range(___)]
#     self.___.publish(message)
# ```
#
# In `__init__`, two lines make it run: one creates the publisher that you use here, and the other creates a timer with
# this method. You also need the import at the top.
#
# The same steps for a String: [Writing a simple publisher and
# subscriber](https://docs.ros.org/en/jazzy/Tutorials/Beginner-Client-Libraries/Writing-A-Simple-Py-Publisher-And-Subscriber.html)
# %% [alternatives]
# ## Other good ways
#
# - **One timer instead of three.** A single 1 Hz timer with a counter publishes the status on every tick, and the
#   battery and joints on every second tick. The program has fewer parts, and the battery and joints are always
#   published together. But now all rates depend on each other: for joints at 0.7 Hz, you'd have to rewrite the program.
# - **A counter instead of the clock.** `self.step += 1` with `math.sin(0.6 * self.step)` is simpler. It also produces
#   the same numbers in every run, which is good for tests. But at 100 Hz, this robot would move two hundred times as
#   fast.
# - **Composition instead of a subclass.** A class that doesn't inherit from `Node` holds
#   `node = rclpy.create_node("humanoid_status_publisher")`. Your attributes then can't collide with `Node`'s attributes,
#   and you can test the simulation without ROS. But most code that you'll read uses a subclass.
# - **NumPy.** `np.sin(...)` computes all joints in one call. Convert the array to plain floats with `.tolist()`. This
#   is a good habit: a `np.float32` in a plain `Float32` message is silently sent as 0.0, or crashes the program with
#   the Ubuntu packages.
# - **`array.array("f", ...)`.** rclpy converts `data` to this type anyway, and subscribers receive it. For twelve
#   numbers, there's no noticeable difference. For a million, it's more than a hundred times faster than a list.
# - **`sensor_msgs/msg/JointState`.** Real robots use this type. `Float32MultiArray` doesn't state which number belongs
#   to which joint, its unit, or when it was measured, so both sides must agree on that elsewhere. For that reason, the
#   plain types in `std_msgs` have been deprecated since ROS 2 Foxy: fine for learning, but not for a lasting design.
#   `JointState` has names, positions, velocities, and a time stamp. A later lesson switches to it.

# ---
# exercise: 02_nodes
# title: Eyes in the back of its head
# minutes: 20
# difficulty: 2
# kind: program
# clock: simulated
# objectives:
#   - putting a node into a namespace
#   - creating two differently named nodes from the same class, without editing the class
#   - checking the graph for missing and unwanted nodes
# out_of_scope:
#   - the images' content, and real cameras
#   - launch files, and remapping single topics
#   - how spin and executors work (lesson 06); the given main() takes care of both
# ---
# %% [markdown]
# # Exercise 02 · Eyes in the back of its head
#
# Your humanoid sees only the area in front of it. So when people walk up from behind, they startle it, or it startles
# them. That's why it's getting a second camera, in the back of its head. The second camera is the same model as the
# first, and the manufacturer's driver always calls its node `camera`. There's no point in editing the driver, because
# the next update would overwrite your changes. Even so, the two nodes need different names, and each name must show
# which robot the node belongs to.
#
# **About 20 minutes · difficulty 2 of 5 · 10 points.** This exercise builds on lesson
# [02](../notebooks/02_nodes.ipynb).
#
# ## What to build
#
# Write one program that creates two nodes from the class `CameraDriver`:
#
# | node | publishes images (2 Hz) on | publishes fault reports (1 Hz) on |
# |---|---|---|
# | `/robot/camera` | `/robot/camera/frame` | `/robot/faults` |
# | `/robot/rear_camera` | `/robot/rear_camera/frame` | `/robot/faults` |
#
# The driver's topic names are private (`~/frame`) or relative (`faults`). So ROS expands the private name with the
# node's namespace and name, and the relative name with the namespace alone. Both cameras publish their reports on the
# same topic, so each report begins with its camera's name, as in `rear_camera: none`. Write all of your code in
# `make_cameras`. The class and `main` need no changes.
#
# ## What is judged
#
# Your program runs in its own process, and the judge inspects the graph and the topics from another process. Each rate
# may be up to {{rates.RATE_TOLERANCE %}} higher or lower than specified, and no gap between consecutive messages may be
# longer than {{rates.LONGEST_GAP_PERIODS}} periods.
#
# | points | criterion |
# |---:|---|
# | 1 | `/robot/camera` appears in the graph exactly once |
# | 2 | `/robot/rear_camera` appears in the graph exactly once |
# | 1 | the front camera's images arrive at 2 Hz |
# | 2 | the rear camera's images arrive at 2 Hz |
# | 1 | each camera's fault reports arrive on `/robot/faults` once a second |
# | 2 | there are no other nodes in the graph: no duplicates, no third node, and no node outside `/robot` |
# | 1 | the program is still running at the end |
#
# **Not judged:** launch files, the images' content, how your program ends, and the driver's code. The judge checks only
# the driver's behavior, not whether you changed or copied its code.
# %% [answer]
"""Run two cameras on one robot, front and rear, with the same driver."""

from typing import Any

import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String


class CameraDriver(Node):
    """Simulates the manufacturer's driver, version 3.1. The next update will replace this class.

    `settings` are passed to Node unchanged. Examples are namespace and cli_args.
    """

    def __init__(self, **settings: Any) -> None:
        super().__init__("camera", **settings)
        self.frames = 0
        self.frame_publisher = self.create_publisher(String, "~/frame", 10)
        self.fault_publisher = self.create_publisher(String, "faults", 10)
        self.create_timer(0.5, self.take_picture)
        self.create_timer(1.0, self.report_faults)

    def take_picture(self) -> None:
        """Publish the next image's number."""
        self.frames += 1
        self.frame_publisher.publish(String(data=f"picture {self.frames}"))

    def report_faults(self) -> None:
        """Report this camera's faults."""
        self.fault_publisher.publish(String(data=f"{self.get_name()}: none"))


def make_cameras() -> list[Node]:
    """Create /robot/camera and /robot/rear_camera."""
    # [solution]
    front = CameraDriver(namespace="/robot")
    rear = CameraDriver(namespace="/robot", cli_args=["--ros-args", "-r", "__node:=rear_camera"])
    return [front, rear]
    # [starter]
    # | front = CameraDriver()  # TODO 1: put it into the namespace /robot
    # | # TODO 2: create a second camera there, remapped to the name rear_camera
    # | return [front]
    # [end]


def main(args: list[str] | None = None) -> None:
    """Run the cameras until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    executor = SingleThreadedExecutor()
    for camera in make_cameras():
        executor.add_node(camera)
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
# %% [live]
# %start
# from workbook.ros import node_list
#
# node_list()
# %% [hint]
# This exercise asks two questions. How does a node get its namespace? And how do you rename a node if you can't change
# the line that contains its name? Lesson 02 answers both in its third experiment. After `%start`, check your work with
# `node_list()`.
# %% [hint]
# - `CameraDriver(...)` passes all of its keyword arguments to `Node`, which accepts `namespace=` and `cli_args=`.
# - `cli_args` is a list of the words that you would type in a terminal: first `"--ros-args"`, then `"-r"`, then the
#   remapping rule.
# - The remapping rule for a node's name is `__node:=new_name`, with two underscores, `:=`, and no spaces. The new name has no
#   slash, because `namespace=` sets everything before the name.
# - Put every node that you create into the returned list. Otherwise, no executor spins it.
#
# [Passing arguments to nodes](https://docs.ros.org/en/jazzy/How-To-Guides/Node-arguments.html)
# %% [hint]
# ```python
# front = CameraDriver(namespace=___)
# rear = CameraDriver(namespace=___, cli_args=["--ros-args", ___, "__node:=___"])
# return [front, ___]
# ```
# %% [alternatives]
# ## Other good ways
#
# - **Remap the namespace as well:** `cli_args=["--ros-args", "-r", "__ns:=/robot", "-r", "__node:=rear_camera"]`. This
#   is useful if a class accepts `cli_args` but no namespace. Here, `namespace=` is shorter.
# - **Set the namespace for the whole program:** `rclpy.init(args=["--ros-args", "-r", "__ns:=/robot"])`, or the same
#   arguments in the terminal or the launch file. With the namespace in the terminal or the launch file, the code
#   doesn't contain the robot's name, which is best on a real robot. But arguments passed to `init` replace the
#   command-line arguments, so put `sys.argv` before them.
# - **Two processes, one camera each.** This is the usual way in ROS: start the driver twice, each time with different
#   `--ros-args`. If one process crashes, the other continues. The price is a second process, and each takes about 60
#   MB.
# - **A context per camera,** each with its own arguments. Use this for classes that accept only a context.
# - **A subclass that calls `super().__init__(...)` with different settings.** This works, and the subclass can have a
#   descriptive name. But it can't change the word "camera", either, so it still needs `cli_args`.
# - **Copy the class and edit the copy.** This works until the next update. After that, one camera runs an old version
#   of the driver.

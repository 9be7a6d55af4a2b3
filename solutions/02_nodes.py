# ---
# exercise: 02_nodes
# title: An eye in the back of the head
# minutes: 20
# difficulty: 2
# kind: program
# clock: simulated
# objectives:
#   - put a node into a namespace
#   - run one class twice under two names, without editing it
#   - see on the graph which nodes are there and which should not be
# out_of_scope:
#   - what is in the pictures, and real cameras
#   - launch files, and remapping single topics
#   - how spin and executors work (lesson 06); the program does this for you
# ---
# %% [markdown]
# # Exercise 02 · An eye in the back of the head
#
# Your humanoid looks ahead. People walk up from behind and frighten it, or it frightens them. So it gets a second
# camera, in the back of its head. It is the same model, and the manufacturer's driver always calls its node `camera`.
# You may not edit the driver: the next update would overwrite your change. But the two nodes must not have duplicate
# names, and their names must show that they belong to this robot.
#
# **About 20 minutes · difficulty 2 of 5 · 10 points.** You need lesson
# [02](../notebooks/02_nodes.ipynb).
#
# ## What to build
#
# Two nodes from the class `CameraDriver`, in one program:
#
# | node | its pictures, 2 Hz | its fault reports, 1 Hz |
# |---|---|---|
# | `/robot/camera` | `/robot/camera/frame` | `/robot/faults` |
# | `/robot/rear_camera` | `/robot/rear_camera/frame` | `/robot/faults` |
#
# All these names follow from the names of the two nodes, because the driver uses private and relative names. Both
# cameras report on one topic, so each report begins with the name of its camera: `rear_camera: none`. Change
# `make_cameras`. Do not change the class; `main` needs no change either.
#
# ## What is judged
#
# Your program runs as its own process. Another process reads the graph and the topics. A rate may be 20 % higher or
# lower than asked, and no gap may be longer than 1.5 periods.
#
# | points | criterion |
# |---:|---|
# | 1 | `/robot/camera` is on the graph, once |
# | 2 | `/robot/rear_camera` is on the graph, once |
# | 1 | pictures of the front camera come at 2 Hz |
# | 2 | pictures of the rear camera come at 2 Hz |
# | 1 | both report on `/robot/faults`, each once a second |
# | 2 | no other node is there: no duplicate, no third node, none outside of `/robot` |
# | 1 | the program is still running when the judge stops watching |
#
# **Not part of it:** what is in the pictures, launch files, and how your program ends.
# %% [answer]
"""Two cameras on one robot, in front and in the back, with one driver."""

from typing import Any

import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String


class CameraDriver(Node):
    """The driver of the manufacturer, version 3.1. Please do not edit: updates replace this class.

    `settings` go to the Node as they are: namespace, cli_args and so on.
    """

    def __init__(self, **settings: Any) -> None:
        super().__init__("camera", **settings)
        self.frames = 0
        self.frame_publisher = self.create_publisher(String, "~/frame", 10)
        self.fault_publisher = self.create_publisher(String, "faults", 10)
        self.create_timer(0.5, self.take_picture)
        self.create_timer(1.0, self.report_faults)

    def take_picture(self) -> None:
        """Publish the next picture."""
        self.frames += 1
        self.frame_publisher.publish(String(data=f"picture {self.frames}"))

    def report_faults(self) -> None:
        """Say what is wrong with this camera."""
        self.fault_publisher.publish(String(data=f"{self.get_name()}: none"))


def make_cameras() -> list[Node]:
    """Make /robot/camera and /robot/rear_camera."""
    # [solution]
    front = CameraDriver(namespace="/robot")
    rear = CameraDriver(namespace="/robot", cli_args=["--ros-args", "-r", "__node:=rear_camera"])
    return [front, rear]
    # [starter]
    # | front = CameraDriver()  # TODO 1: put it into the namespace /robot
    # | # TODO 2: make a second one there, remapped to the name rear_camera
    # | return [front]
    # [end]


def main(args: list[str] | None = None) -> None:
    """Let the cameras work until Ctrl-C."""
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
# There are two questions. Where does a node get its namespace from? And how do you give a node another name if you
# cannot change the line with its name? Lesson 02 does both in its third experiment. Check your work with `node_list()`
# after `%start`.
# %% [hint]
# - `CameraDriver(...)` passes all its keyword arguments to `Node`. `Node` knows `namespace=` and `cli_args=`.
# - `cli_args` is what you would type in a terminal, as a list of words: first `"--ros-args"`, then `"-r"`, then the
#   rule.
# - The rule for the name of a node is `__node:=new_name`, with two underscores, `:=` and no spaces. The new name has no
#   slash; the folder is set by the namespace.
# - Return every node that you create in the list; otherwise nothing spins it.
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
# - **Remap the folder as well:** `cli_args=["--ros-args", "-r", "__ns:=/robot", "-r", "__node:=rear_camera"]`. This is
#   useful when a class takes `cli_args` but no namespace. Here `namespace=` is shorter.
# - **The namespace for the whole program:** `rclpy.init(args=["--ros-args", "-r", "__ns:=/robot"])`, or the same in the
#   terminal or the launch file. This is best on a real robot, because the code then does not contain the robot's name.
#   But arguments given to `init` replace those of the command line; put `sys.argv` before them.
# - **Two processes, one camera each.** This is the usual way in ROS: start the driver twice, each time with its own
#   `--ros-args`. If one crashes, the other continues. It costs one more process. Each takes about 60 MB.
# - **A context per camera,** each with its own arguments. This is for classes that take only a context.
# - **A subclass that calls `super().__init__(...)` with other settings.** This is fine, and the subclass can have a
#   clear name. But it cannot change the word "camera" either, so it still needs `cli_args`.
# - **Copy the class and edit the copy.** This works until the next update. Then one camera uses an old version.

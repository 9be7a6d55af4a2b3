# ---
# exercise: 02_nodes
# title: An eye in the back of the head
# minutes: 20
# difficulty: 2
# kind: program
# clock: simulated
# objectives:
#   - give a node its place in a namespace
#   - run one class twice under two names, without editing it
#   - tell from the outside, by the graph, who is there and who should not be
# out_of_scope:
#   - what is in the pictures, and real cameras
#   - launch files, and remapping single topics
#   - how spin and executors work (lesson 06), which the program does for you
# ---
# %% [markdown]
# # Exercise 02 · An eye in the back of the head
#
# Your humanoid looks ahead. People keep walking up from behind and frighten it, or it frightens them. So it gets a second
# camera, in the back of its head. It is of the same make, and the manufacturer's driver calls itself `camera`, always.
# You may not edit it: the next update would wipe out your change. Yet the two must not be twins, and they belong to
# this robot, not to the whole building.
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
# All these names follow from the two names of the nodes, because the driver uses private and relative names. Both cameras
# report on one topic, so each report begins with the name of its camera: `rear_camera: none`. Change
# `make_cameras`. The class stays as it is, and `main` need not change either.
#
# ## What is judged
#
# Your program runs as a process of its own. Another process looks at the graph and listens. A rate may be 20 % higher or
# lower than asked, and no gap may be longer than 1.5 periods.
#
# | points | criterion |
# |---:|---|
# | 1 | `/robot/camera` is on the graph, once |
# | 2 | `/robot/rear_camera` is on the graph, once |
# | 1 | pictures of the front camera come at 2 Hz |
# | 2 | pictures of the rear camera come at 2 Hz |
# | 1 | both report on `/robot/faults`, each once a second |
# | 2 | nobody else is there: no twin, no third node, none outside of `/robot` |
# | 1 | the program is still running at the end of the watch |
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
# Two questions, one after the other. Where does a node get its folder from? And how do you give a node another name if
# you cannot get at the line in which its name is written? Lesson 02 does both in its third experiment. Look at your work
# with `node_list()` after `%start`.
# %% [hint]
# - `CameraDriver(...)` hands all that you give it by name on to `Node`. `Node` knows `namespace=` and `cli_args=`.
# - `cli_args` is what you would type in a terminal, as a list of words. It begins with `"--ros-args"`, then `"-r"` and the
#   rule, each a word of its own.
# - The rule for the name of a node is `__node:=new_name`, with two underscores, `:=` and no spaces. The new name has no slash;
#   the folder is the namespace.
# - Whatever you make must be in the list that you return, or nobody lets it work.
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
# - **Remap the folder as well:** `cli_args=["--ros-args", "-r", "__ns:=/robot", "-r", "__node:=rear_camera"]`. Handy when a class takes
#   `cli_args` but no namespace. Here `namespace=` is shorter.
# - **The namespace for the whole program:** `rclpy.init(args=["--ros-args", "-r", "__ns:=/robot"])`, or the same in the terminal or the
#   launch file. Best on a real robot, because the code then does not know how the robot is called. But words given
#   to `init` replace those of the command line; put `sys.argv` in front of them.
# - **Two processes, one camera each.** The usual way in ROS: start the driver twice, each time with its own
#   `--ros-args`. If one crashes, the other one goes on. It costs one more process, some 60 MB each.
# - **A context per camera,** each with its own arguments. For classes that take nothing but a context.
# - **A subclass that calls `super().__init__(...)` with other settings.** Fine, and it has a name that can be explained.
#   It cannot change the word "camera" either, so it needs `cli_args` all the same.
# - **Copy the class and edit the copy.** It works until the next update. Then one eye is a version behind.

# ---
# exercise: 01_the_context
# title: A guard that shuts down cleanly
# minutes: 20
# difficulty: 2
# kind: program
# clock: wall
# objectives:
#   - initializing ROS once and keeping a node running until Ctrl-C
#   - cleaning up after Ctrl-C, when the context is already shut down
#   - ending a program with exit code 0 and without a traceback
#   - removing your node from the graph, so that it doesn't linger as a ghost
# out_of_scope:
#   - SIGTERM and signals other than the one that Ctrl-C sends (this rclpy loses some of them)
#   - topics, and what the guard does on its rounds
#   - a last message on a topic, which needs other signal handlers
# ---
# %% [markdown]
# # Exercise 01 · A guard that shuts down cleanly
#
# The museum's night guard is a robot, and its program is complete except for `main()`. Every morning at six, the day
# shift stops the program with Ctrl-C. One morning last week, Ctrl-C froze the robot mid-step, with both arms in the air
# and a crash report on its screen. And on Tuesday, the graph still listed a guard whose program had long since ended.
# Write a `main()` that shuts the guard down properly at the end of the night.
#
# **About 20 minutes · difficulty 2 of 5 · 10 points.** This exercise builds on lesson
# [01](../notebooks/01_the_context.ipynb).
#
# ## What to build
#
# | when | what happens |
# |---|---|
# | at the start | exactly one node is in the graph: `/night_guard` |
# | all night | the guard makes its rounds and logs each one, until the program is stopped |
# | on Ctrl-C | the program calls `park()`, which prints `arms parked` |
# | after that | the program exits on its own, with exit code 0 and no traceback, and its node disappears from the graph |
#
# The class `NightGuard` is given. `park()` doesn't use ROS, so you may call it after the context is shut down. Don't
# call it before Ctrl-C, because a guard with folded arms can't guard anything.
#
# ## What is judged
#
# Your program runs in its own process for about {{WATCH_S}} s. During this time, it must log at least {{LEAST_ROUNDS}}
# lines, including one in the final {{LONGEST_SILENCE_S}} s. Then the judge sends it SIGINT, the same signal as
# Ctrl-C.
#
# | points | criterion |
# |---:|---|
# | 1 | the program keeps running until Ctrl-C |
# | 1 | the guard makes its rounds |
# | 1 | `/night_guard` appears in the graph exactly once |
# | 2 | the arms are parked after Ctrl-C, and not before |
# | 3 | Ctrl-C ends the program with exit code 0 and no traceback |
# | 2 | after Ctrl-C, the program's node disappears from the graph |
#
# **Not judged:** SIGTERM, topics, the wording of the messages that the guard logs on its rounds, and how many times it
# parks its arms.
# %% [answer]
"""Simulate a guard that walks through the museum at night, and parks its arms when the night is over."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

ROUND_S = 0.5


class NightGuard(Node):
    """Logs each round that it has walked."""

    def __init__(self) -> None:
        super().__init__("night_guard")
        self.rounds = 0
        self.create_timer(ROUND_S, self.walk_round)
        self.get_logger().info("on duty")

    def walk_round(self) -> None:
        """Walk one round."""
        self.rounds += 1
        self.get_logger().info(f"round {self.rounds}: all quiet")

    def park(self) -> None:
        """Fold the arms, so that the motors can be switched off. This doesn't use ROS."""
        print("arms parked", flush=True)


def main(args: list[str] | None = None) -> None:
    """Run the guard until Ctrl-C, park its arms, and exit with code 0."""
    rclpy.init(args=args)
    guard = NightGuard()
    # [solution]
    try:
        rclpy.spin(guard)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass  # this is how a night ends
    finally:
        guard.park()
        guard.destroy_node()
        rclpy.try_shutdown()
    # [starter]
    # | # TODO 1: On Ctrl-C, spin raises KeyboardInterrupt; on SIGTERM, ExternalShutdownException. Catch both.
    # | rclpy.spin(guard)
    # | # TODO 2: park the arms, no matter how spin ended
    # | # TODO 3: remove the node from the graph, and shut the context down if it's still valid
    # [end]


if __name__ == "__main__":
    main()
# %% [hint]
# Run the starter with `%start`, stop it with `%stop`, and read its output from the bottom up. Which line of `main()`
# did Python reach last? Code that must always run belongs in a block that Python always reaches.
#
# The Python tutorial shows such a block in [its chapter on
# errors](https://docs.python.org/3/tutorial/errors.html#defining-clean-up-actions).
# %% [hint]
# - On Ctrl-C, `rclpy.spin(guard)` doesn't return. It raises `KeyboardInterrupt`. On SIGTERM, it raises
#   `ExternalShutdownException` from `rclpy.executors`. A single `except` clause can catch both: `except (A, B):`. (If
#   another thread shuts the context down, `rclpy.spin` may also simply return.)
# - Code in `finally` runs after the `except` block. It also runs after any other exception.
# - On Ctrl-C, rclpy shuts the context down on its own, at about the same time as Python raises the exception. After
#   that, `rclpy.shutdown()` would raise an exception, but `rclpy.try_shutdown()` doesn't.
# - Let `main()` return. If you call `os._exit()` or press Ctrl-C a second time, a ghost of the node stays in the graph.
# %% [hint]
# ```python
# rclpy.init(args=args)
# guard = NightGuard()
# try:
#     rclpy.spin(guard)
# except (___, ___):
#     pass
# finally:
#     guard.___()
#     guard.destroy_node()
#     rclpy.___()
# ```
# %% [alternatives]
# ## Other good ways
#
# - **`if rclpy.ok(): rclpy.shutdown()`** instead of `rclpy.try_shutdown()`. This states the intention more clearly. But
#   the context may be shut down between the check and the call, and on Ctrl-C, one of rclpy's threads does just that.
#   `try_shutdown()` has the same gap inside. In both versions, the gap very rarely matters.
# - **`contextlib.suppress(KeyboardInterrupt, ExternalShutdownException)`** around the call to `spin`. This is two lines
#   shorter, and a good choice if the `except` block would be empty. But if the cleanup code simply follows the `with`
#   block, any other exception skips it.
# - **Parking in `destroy_node`.** Override the method in the class, park there, and call `super().destroy_node()`. Then
#   users of your class can't forget to park. But readers of `main()` no longer see that the arms will move.
# - **`SignalHandlerOptions.NO`.** The context stays valid after Ctrl-C, so the guard could still publish "parked". You
#   need this option if the last action uses ROS. But then something has to wake `spin` up, such as the timer in this
#   program. Also, SIGTERM ends the program immediately.
# - **Only `except KeyboardInterrupt`.** This gets full credit here. But on SIGTERM, the program would park the arms and
#   then end with a traceback. Catching the second exception takes only half a line.

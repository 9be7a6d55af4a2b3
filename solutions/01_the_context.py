# ---
# exercise: 01_the_context
# title: A guard that shuts down cleanly
# minutes: 20
# difficulty: 2
# kind: program
# clock: wall
# objectives:
#   - initialize ROS once and keep a node running until it is told to end
#   - clean up after Ctrl-C, although the context is already shut down
#   - end a program with exit code 0 and without a traceback
#   - remove your node from the graph, so that no ghost of it stays
# out_of_scope:
#   - SIGTERM and signals other than the one that Ctrl-C sends (this rclpy loses some of them)
#   - topics, and what the guard does on its rounds
#   - a last message on a topic, which needs other signal handlers
# ---
# %% [markdown]
# # Exercise 01 · A guard that shuts down cleanly
#
# The night guard of the museum is finished, except for its `main()`. At six in the morning the day shift presses
# Ctrl-C. Last week the robot then froze in the middle of a step, with both arms in the air, and its screen showed a
# crash report. On Tuesday the graph still showed a guard that had ended long before. Write a `main()` that ends the
# night properly.
#
# **About 20 minutes · difficulty 2 of 5 · 10 points.** You need lesson
# [01](../notebooks/01_the_context.ipynb).
#
# ## What to build
#
# | when | what happens |
# |---|---|
# | at the start | one node, `/night_guard`, is on the graph, and no other node |
# | all night | it walks its rounds and logs each of them, until it is stopped |
# | on Ctrl-C | `park()` is called, which logs `arms parked` |
# | then | the program ends by itself: exit code 0, no traceback, no node left |
#
# The class `NightGuard` is given. `park()` needs no ROS, so you may call it after the context is shut down. Do not call
# it before the night is over: a guard with folded arms cannot guard anything.
#
# ## What is judged
#
# Your program runs as its own process for about 4 s. In this time it has to log at least 4 lines, the last of them in
# the last 1.5 s. Then it gets the signal that Ctrl-C sends.
#
# | points | criterion |
# |---:|---|
# | 1 | the program runs until it is told to end |
# | 1 | the guard walks its rounds |
# | 1 | `/night_guard` is on the graph, once |
# | 2 | the arms are parked after Ctrl-C, and not before |
# | 3 | Ctrl-C ends it with exit code 0 and no traceback |
# | 2 | its node is gone from the graph |
#
# **Not part of it:** SIGTERM, topics, what the guard says on its rounds, and whether it parks more than once.
# %% [answer]
"""A guard that walks through the museum at night, and parks its arms when the night is over."""

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
        """Fold the arms, so that the motors can be switched off. Needs no ROS."""
        print("arms parked", flush=True)


def main(args: list[str] | None = None) -> None:
    """Run the guard until Ctrl-C, park its arms, and leave with exit code 0."""
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
    # | # TODO 1: Ctrl-C makes spin raise KeyboardInterrupt, SIGTERM ExternalShutdownException. Catch both.
    # | rclpy.spin(guard)
    # | # TODO 2: park the arms, however the spin ended
    # | # TODO 3: take the node off the graph, and shut the context down if it is still up
    # [end]


if __name__ == "__main__":
    main()
# %% [hint]
# Run the starter with `%start`, then `%stop`, and read what it prints from the bottom up. Which line of `main()` did
# Python reach last? A line that must always run needs a place that Python always reaches.
#
# The Python tutorial shows that place in [its chapter on
# errors](https://docs.python.org/3/tutorial/errors.html#defining-clean-up-actions).
# %% [hint]
# - `rclpy.spin(guard)` does not return on Ctrl-C. It raises `KeyboardInterrupt`. On SIGTERM it raises
#   `ExternalShutdownException`, from `rclpy.executors`. One `except` catches both: `except (A, B):`. (If another thread
#   shuts the context down, `rclpy.spin` may also simply return.)
# - Code in `finally` runs after the `except`, and also after any other error.
# - On Ctrl-C rclpy shuts the context down by itself, at about the same time as the exception is raised. After that,
#   `rclpy.shutdown()` would raise an error; `rclpy.try_shutdown()` does not.
# - Let `main()` return. `os._exit()` and a second Ctrl-C leave a ghost of the node on the graph.
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
# - **`if rclpy.ok(): rclpy.shutdown()`** instead of `rclpy.try_shutdown()`. This shows more clearly what is meant.
#   Something else may shut the context down between the check and the call, and on Ctrl-C a thread of rclpy does just
#   that. `try_shutdown()` has the same gap inside. In both, it very rarely matters.
# - **`contextlib.suppress(KeyboardInterrupt, ExternalShutdownException)`** around the spin. This is two lines shorter,
#   and good if there is nothing to do in the `except`. The clean-up code then simply follows, so other errors skip it.
# - **Parking in `destroy_node`.** Override it in the class, park there and call `super().destroy_node()`. A user of
#   your class cannot forget it. But a reader of `main()` no longer sees that the arms will move.
# - **`SignalHandlerOptions.NO`.** The context stays up after Ctrl-C, so the guard could still publish "parked". You
#   need this when the last action uses ROS. Then something, such as this timer, must wake up the spin, and SIGTERM ends
#   the program at once.
# - **Only `except KeyboardInterrupt`.** Full marks here. But on SIGTERM the program would end with a traceback, after
#   its arms were parked. Catching the second exception takes only half a line.

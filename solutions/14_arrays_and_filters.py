# ---
# exercise: 14_arrays_and_filters
# title: Twelve steady joints
# minutes: 35
# difficulty: 3
# kind: program
# clock: simulated
# objectives:
#   - converting the angles of a JointState to an array and back
#   - filtering twelve joints at the same time, message by message, with state that persists from one callback to the next
#   - choosing a filter based on how much noise it leaves and how much delay it adds
#   - keeping NaN out of a filter, and resetting the filter when its source restarts
# out_of_scope:
#   - velocities and efforts
#   - lost messages, and stamps at irregular intervals
#   - how the program ends (lesson 01 judges that)
# ---
# %% [markdown]
# # Exercise 14 · Twelve steady joints
#
# The humanoid is standing still, but its hands are trembling. The motors are fine, but the joint encoders are noisy,
# and the controller reacts to every bit of that noise. Put a filter between the encoders and the controller. But a
# filter also uses past measurements, so its output usually lags behind the joint. With too much delay, the robot falls
# over. So you need both: less noise and little delay.
#
# **About 35 minutes · difficulty 3 of 5 · 10 points.** This exercise builds on lesson
# [14](../notebooks/14_arrays_and_filters.ipynb).
#
# ## An example
#
# Here are five messages. The table shows the angle of just one joint. If your node used a moving average over the last
# three messages, it would publish the angles in the third column.
#
# | stamp | angle received (rad) | angle published (rad) | why |
# |---:|---:|---:|---|
# | 40.00 s | 0.94 | 0.940 | the first message: assume that the joint has always been at this angle |
# | 40.05 s | 0.97 | 0.950 | the mean of 0.94, 0.94, and 0.97 |
# | 40.10 s | NaN | 0.960 | the mean of 0.94, 0.97, and 0.97: the last good angle, 0.97, replaces the NaN |
# | 40.15 s | 0.93 | 0.957 | the mean of 0.97, 0.97, and 0.93 |
# | 0.75 s | 0.14 | 0.140 | this stamp is earlier than the previous one, because the encoder board was restarted: reset the filter's state |
#
# This filter isn't good enough, because it leaves about 58 % of the noise. Yours must do better, and it must filter
# twelve joints at the same time.
#
# ## What to build
#
# Write one program that spins until it's interrupted with Ctrl-C.
#
# | topic | type | your node | content |
# |---|---|---|---|
# | `/encoders/joint_states` | `JointState` | subscribes | 20 messages a second, with the names and noisy angles of 12 joints |
# | `/robot/joint_states` | `JointState` | publishes | one message with the filtered angles for each message received |
#
# In this exercise, an *answer* is the message that your node publishes in response to a message that it received.
# `JointState` is in `sensor_msgs.msg`. Its `position` field holds the angles in rad; `velocity` and `effort` are empty.
# The judge's publisher offers reliable, volatile QoS with a queue depth of 100. The starter code's subscription, with a
# queue depth of 50, is compatible with that.
#
# Your node:
#
# - answers every message exactly once, right away, and in order of arrival
# - copies the header's stamp and the names from the message that it answers
# - reduces the noise
# - keeps the delay small
# - publishes angles close to the joints' actual angles, starting with the first message
# - replaces NaNs, so that every published angle is a finite number
# - resets the filter's state after each restart of the encoder board
#
# **Each joint** is either at rest or moving at a constant speed of 0.4 or 0.5 rad/s. The joints start and stop
# abruptly.
#
# **The noise** has a standard deviation of {{NOISE_RAD}} rad and never exceeds {{LARGEST_NOISE_RAD}} rad.
#
# **NaNs.** In some messages, one, several, or all of the angles are NaN. At most three messages in a row contain NaNs.
# NaNs occur only while the joints are at rest, and never in the judge's first message or in the first message after a
# restart.
#
# **The restart.** A stamp is the time of the measurement, in seconds since the encoder board was switched on. When an
# engineer switches the board off and on again, the stamps start over near zero. So you can recognize a restart by a
# stamp that's *earlier* than the previous one. While the board is off, someone turns the joints by hand. Before the
# first restart, each joint is turned by 0.2 to 0.8 rad; before the second, by 0.22 to 0.24 rad. So after a restart,
# your filter's old state is useless.
#
# ## What is judged
#
# Your program runs in its own process. The judge publishes {{MESSAGES}} messages. During the run, the joints rest,
# move, rest again (this time with some NaNs), and move back. Then the board is restarted, and two seconds later, it's
# restarted again. The judge waits for each answer and measures how long the answer takes in real time. It compares the
# angles in your answers with the true ones.
#
# | points | criterion |
# |---:|---|
# | 1 | your node subscribes to `/encoders/joint_states`, with the type `JointState` |
# | 1 | `/robot/joint_states` carries `JointState` messages |
# | 1 | each answer has the stamp and the names of the message that it answers, and an angle for each joint |
# | 2 | every message is answered exactly once, right away, and in order |
# | 1 | at most {{MOST_NOISE %}} of the noise is left |
# | 1 | the published angles lag at most {{LONGEST_DELAY_S}} s behind the joints |
# | 1 | the first published angles are close to the joints' actual angles |
# | 1 | your node notices each restart and resets the filter's state |
# | 1 | NaNs don't corrupt the published angles |
#
# The last five criteria count only if the node actually filters the angles. The judge checks this while the joints are
# at rest. If the published angles are the same as the received ones, or far from the true ones, only the first four
# criteria count. You may use any filter, in NumPy, SciPy, or plain Python. You may structure your program any way you
# like, for example with one filter object for all joints or with one for each. There's one exception:
# `rclpy.experimental.EventsExecutor` doesn't work in this rclpy build, because its `spin()` never runs a callback.
#
# **Not judged:** velocities, efforts, the header's frame, lost messages, irregular stamps, and how your program ends on
# Ctrl-C.
#
# **Tolerances**
#
# | requirement or term | limit |
# |---|---|
# | answered right away | at least half of the answers are published within {{TYPICALLY_S}} s of their message, and at least nine out of ten within {{AT_ONCE_S}} s |
# | names and angles | each answer has 12 names and 12 angles |
# | noise | in the first period at rest, and after the first restart, at most {{MOST_NOISE %}} of the noise is left, measured across all joints. For any single joint, at most {{MOST_NOISE_OF_ONE %}} is left |
# | delay | in each movement, the published angles lag by at most {{LONGEST_DELAY_S}} s, measured across all joints. For any single joint, they lag by at most {{LONGEST_DELAY_OF_ONE_S}} s |
# | first angles | in each of the first {{STARTING}} answers, every angle is within {{NEAR_RAD}} rad of the joint's true angle |
# | after a restart | in each of the first {{STARTING}} answers after it, every angle is within {{NEAR_RAD}} rad of the joint's true angle |
# | NaNs | from the first NaN until the first restart, every angle is a finite number. Until the joints start to move back, every angle is within {{NEAR_RAD}} rad of the joint's true angle. Near the end of that movement, every angle is within {{FOLLOWS_RAD}} rad |
# | overshoot | overshoot is treated like any other error. But angles that run ahead of their joint don't count as delayed, no matter how far ahead they are |
# | the same as the received ones | for every joint, the published angles differ from the received ones by at most {{LEAST_CHANGE_RAD}} rad |
# | far from the true ones | at least one joint has a mean error of more than {{LARGEST_NOISE_RAD}} rad |
#
# The noise, and the difference between published and received angles, are measured as root mean squares. The judge
# ignores noise and delay for 1 s ({{SETTLED}} messages) after the first message and after each restart. It also ignores
# them for 1 s after the joints start or stop moving. The reason is that a filter needs that long to settle.
# %% [answer]
"""Filter noisy joint angles: publish them with less noise and little delay."""

import numpy as np
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

# [solution]
from scipy.signal import butter, sosfilt, sosfilt_zi

# [end]
from sensor_msgs.msg import JointState

# [solution]
RATE_HZ = 20.0
CUTOFF_HZ = 1.5  # slower motion passes; faster noise is reduced
FILTER = butter(2, CUTOFF_HZ, fs=RATE_HZ, output="sos")
AT_REST = sosfilt_zi(FILTER)  # the filter's state after a long time with the constant input 1.0
# [end]


class JointFilter(Node):
    """Reduces the noise in all joint angles.

    Subscriptions:
        /encoders/joint_states (sensor_msgs/JointState): angles in radians, as the encoders measure them.

    Topics:
        /robot/joint_states (sensor_msgs/JointState): the same angles with less noise, one answer to each message.
    """

    def __init__(self) -> None:
        super().__init__("joint_filter")
        self.last_stamp = (0, 0)
        # [solution]
        self.memory: np.ndarray | None = None
        self.last_good = np.zeros(0)
        # [starter]
        # | # TODO 1: which state must the node keep from one callback to the next?
        # [end]
        self.publisher = self.create_publisher(JointState, "/robot/joint_states", 50)
        self.create_subscription(JointState, "/encoders/joint_states", self.on_joints, 50)

    def on_joints(self, message: JointState) -> None:
        """Filter the angles of one message, and publish them right away."""
        angles = np.array(message.position)
        stamp = (message.header.stamp.sec, message.header.stamp.nanosec)
        # [solution]
        if self.memory is None or stamp < self.last_stamp:  # the first message, or the first after a restart
            self.memory = AT_REST[:, :, np.newaxis] * angles
            self.last_good = angles
        angles = np.where(np.isfinite(angles), angles, self.last_good)
        self.last_good = angles
        filtered, self.memory = sosfilt(FILTER, angles[np.newaxis], axis=0, zi=self.memory)
        message.position = filtered[0].tolist()
        # [starter]
        # | # TODO 2: is this the first message, or the first one after a restart? Then reset the state
        # | # TODO 3: replace each NaN with something sensible
        # | # TODO 4: filter the angles
        # | message.position = angles.tolist()
        # [end]
        self.last_stamp = stamp
        self.publisher.publish(message)


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(JointFilter())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
# %% [live]
# from lesson_nodes.joint_scope import JointScope
# from workbook.lesson import fresh, init, run
# from workbook.pictures.figures import figure, show
#
# %start
# init()
# scope = fresh(JointScope)  # records the left elbow, before and after your filter
# await run(scope, seconds=10, until=lambda: len(scope.measured) >= 120)
# print("measured:", len(scope.measured), "filtered:", len(scope.filtered))
# fig, axes = figure(6.4, 2.6)
# for label, pairs in (("measured", scope.measured), ("filtered", scope.filtered)):
#     axes.plot([t for t, _ in pairs], [angle for _, angle in pairs], label=label)
# axes.set(xlabel="stamp (s)", ylabel="left elbow (rad)")
# axes.legend()
# show(fig, "the left elbow's angle: as measured, and as published by your filter")
# %% [hint]
# Begin without a filter: the starter code publishes each message unchanged, and `%check` lists the criteria that fail.
# Then answer three questions. How many past messages can the filter use with a delay of at most 0.27 s? Where does the
# node keep the filter's state between two callbacks? And what does that state contain after a NaN, and after a restart?
#
# Introduction to NumPy: [NumPy for absolute beginners](https://numpy.org/doc/stable/user/absolute_beginners.html)
# %% [hint]
# - `np.array(message.position)` is an array of 12 angles; `.tolist()` turns it back into a list.
# - A moving average over N messages leaves `1/sqrt(N)` of the noise and lags `(N - 1) / 2` messages behind. With 0.05 s
#   between messages, which values of N are within the limits?
# - `np.where(np.isfinite(angles), angles, last_good)` replaces each NaN with the last good angle.
# - Store a stamp as a pair, `(sec, nanosec)`. You can compare two such pairs with `<`.
# - At the first message, and again after a restart, fill the state as if the joints had always been at that message's
#   angles.
#
# A filter that returns its state: [scipy.signal.sosfilt](https://docs.scipy.org/doc/scipy/reference/generated/scipy.signal.sosfilt.html)
# %% [hint]
# A moving average with gaps:
#
# ```python
# self.window = deque(maxlen=___)  # in __init__; from collections import deque
#
# if not self.window or stamp < self.last_stamp:
#     self.window.extend([angles] * ___)  # as if the joints had always been here
# angles = np.where(np.isfinite(angles), angles, self.window[___])
# self.window.append(___)
# message.position = np.mean(self.window, axis=___).tolist()
# ```
#
# More filters: [scipy.signal](https://docs.scipy.org/doc/scipy/reference/signal.html)
# %% [alternatives]
# ## Other good ways
#
# - **A moving average** over 5 to 11 messages needs only NumPy, and its state is easy to understand: the last messages.
#   A NaN leaves the average after N messages, but a filter with feedback keeps the NaN forever.
# - **Exponential smoothing**, `y += 0.3 * (x - y)`, is one line and stores one number per joint. For the same delay, it
#   leaves a little more noise.
# - **A filter for each joint**, in a dictionary by name. This also works if messages contain other joints, or the same
#   joints in another order. But it makes twelve calls instead of one: fine for twelve joints, but not for ten thousand.
# - **A new message instead of the received one.** `JointState(header=message.header, name=message.name,
#   position=...)` leaves the received message unchanged. Here, no other code uses that message, so changing it does no
#   harm.
# - **A straight line through the last 19 messages** (Savitzky–Golay, `savgol_coeffs(19, 1, pos=18, use="dot")`),
#   evaluated at its end. It has no delay while the joints move evenly. The price is overshoot when they stop or turn
#   around.
# - **A Kalman filter** models the encoder's noise and the joint's motion, so it needs less delay for the same noise
#   reduction. Use one if you have a model of the motion.

# ---
# exercise: 14_arrays_and_filters
# title: Twelve steady joints
# minutes: 35
# difficulty: 3
# kind: program
# clock: simulated
# objectives:
#   - turn the angles of a JointState into an array and back
#   - filter twelve joints at once, message by message, with a memory that lives from callback to callback
#   - choose a filter by noise and by delay
#   - keep a NaN out of a filter, and begin anew when the source has restarted
# out_of_scope:
#   - velocities and efforts
#   - messages that get lost on their way, and stamps at irregular intervals
#   - how the program ends (lesson 01 judges that)
# ---
# %% [markdown]
# # Exercise 14 · Twelve steady joints
#
# The humanoid stands still, and its hands tremble. The motors are fine. The encoders in the joints are noisy, and the
# controller answers every bit of noise. Put a filter between the two. But a filter looks back, so it is usually a
# little late. If a robot learns too late where its joints are, it falls over. You need both: less noise, and not much
# delay.
#
# **About 35 minutes · difficulty 3 of 5 · 10 points.** You need lesson
# [14](../notebooks/14_arrays_and_filters.ipynb).
#
# ## What to build
#
# One program that is spun until Ctrl-C ends it.
#
# | topic | type | your node | content |
# |---|---|---|---|
# | `/encoders/joint_states` | `JointState` | subscribes | 20 messages a second: names and noisy angles of 12 joints |
# | `/robot/joint_states` | `JointState` | publishes | for each message one answer, with the filtered angles |
#
# `JointState` is in `sensor_msgs.msg`. Its field `position` holds the angles in rad. `velocity` and `effort` are empty.
#
# | your node | so that |
# |---|---|
# | answers every message once, at once, in the order of the messages | at least half of the answers come within 0.15 s of their message, and nine of ten within 0.5 s |
# | keeps the header's stamp and the names of the message that it answers | each answer has 12 names and 12 angles |
# | takes out noise | in the first standstill and after the first restart, at most 55 % of the noise is left, and at no single joint more than 80 %. Noise is a root mean square here, and the 55 % are for all joints together |
# | is not late | in each movement, the angles of all joints together are at most 0.27 s behind, and no single joint more than 0.32 s |
# | begins where the joints are | each of the first 8 answers is within 0.1 rad of the joint |
# | survives NaN | from the first NaN until the first restart, each angle is a finite number. It is within 0.1 rad of the joint as long as the joints stand still, and within 0.3 rad when they have moved on |
# | notices each restart | after a restart, each of the first 8 answers is within 0.1 rad of the joint |
#
# The noise has a standard deviation of 0.02 rad and never exceeds 0.05 rad. Now and then an encoder gives NaN: one,
# several or all of them, in up to three messages in a row. It does so only while the joints stand still, and never in
# the first message after a start.
#
# **The restart.** The stamp says how long the board of the encoders had been switched on when it measured. When an
# engineer switches it off and on again, its stamps begin again near zero, so a stamp is *earlier* than the previous
# one. Meanwhile the joints were turned by hand: once some far and some only a little, once all of them only a little.
# What your filter remembers is then worth nothing.
#
# ## What is judged
#
# Your program runs as a process of its own. The judge publishes 199 messages: the joints stand, move, stand again (with
# NaN), and move back. Then the board is restarted, and two seconds later once more. The judge waits for each answer, and also looks at the real time that an answer takes. It knows where the joints really are, and compares.
#
# | points | criterion |
# |---:|---|
# | 1 | it subscribes to `/encoders/joint_states`, with the type `JointState` |
# | 1 | `/robot/joint_states` carries `JointState` |
# | 1 | each answer has the stamp, the names and an angle for each joint |
# | 2 | every message is answered once, at once, in order |
# | 1 | at most 55 % of the noise is left |
# | 1 | the angles are at most 0.27 s behind |
# | 1 | it begins where the joints are |
# | 1 | it notices the restart, and begins anew |
# | 1 | a NaN does no harm |
#
# The last five are judged only if the node really filters: an answer that publishes the angles unchanged is judged by
# the first four only. The judge decides this while the joints stand still, where it also measures the noise. The angles
# count as unchanged if, at every joint, they differ by at most 0.005 rad (root mean square) from what came. An answer
# whose angles at a joint are on average more than 0.05 rad off is judged by the first four only, too. Noise and delay
# are measured a second (20 messages) after a start or a change, when a filter has settled. Any filter will do, and any
# shape of program: NumPy, SciPy or plain Python, one class or one for each joint. One executor does not work in this
# build of rclpy: `rclpy.experimental.EventsExecutor` never calls back in `spin()`.
#
# **Not part of it:** velocities, efforts, the frame of the header, lost messages, stamps at irregular intervals, and
# how your program ends on Ctrl-C.
# %% [answer]
"""Listens to noisy encoders, and publishes the angles of all joints with less noise and little delay."""

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
CUTOFF_HZ = 1.5  # movements slower than this pass, noise faster than this does not
FILTER = butter(2, CUTOFF_HZ, fs=RATE_HZ, output="sos")
AT_REST = sosfilt_zi(FILTER)  # the memory of the filter after a long time at 1.0
# [end]


class JointFilter(Node):
    """Takes the noise out of the angles of all joints.

    Subscriptions:
        /encoders/joint_states (sensor_msgs/JointState): angles in radians, as the encoders measure them.

    Topics:
        /robot/joint_states (sensor_msgs/JointState): the same angles with less noise, one answer for each message.
    """

    def __init__(self) -> None:
        super().__init__("joint_filter")
        self.last_stamp = (0, 0)
        # [solution]
        self.memory: np.ndarray | None = None
        self.last_good = np.zeros(0)
        # [starter]
        # | # TODO 1: what must the node remember from one callback to the next?
        # [end]
        self.publisher = self.create_publisher(JointState, "/robot/joint_states", 50)
        self.create_subscription(JointState, "/encoders/joint_states", self.on_joints, 50)

    def on_joints(self, message: JointState) -> None:
        """Filter the angles of one message, and publish them at once."""
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
        # | # TODO 2: is this the first message, or the first one after a restart? Then begin anew
        # | # TODO 3: replace each NaN with something sensible
        # | # TODO 4: filter the angles
        # | message.position = angles.tolist()
        # [end]
        self.last_stamp = stamp
        self.publisher.publish(message)


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or a request to end, then leave with exit code 0."""
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
# from lesson_nodes import noisy_joints
# from lesson_nodes.joint_scope import JointScope
# from workbook.lesson import fresh, init, run, start, stop
# from workbook.pictures.figures import figure, show
#
# %start
# start(noisy_joints)
# init()
# scope = fresh(JointScope)  # writes down the left elbow, before and after your filter
# await run(scope, seconds=10, until=lambda: len(scope.measured) >= 120)
# stop(noisy_joints)
# print("measured:", len(scope.measured), "filtered:", len(scope.filtered))
# fig, axes = figure(6.4, 2.6)
# for label, pairs in (("measured", scope.measured), ("filtered", scope.filtered)):
#     axes.plot([t for t, _ in pairs], [angle for _, angle in pairs], label=label)
# axes.set(xlabel="stamp (s)", ylabel="left elbow (rad)")
# axes.legend()
# show(fig, "the angle of the left elbow as it was measured, and as your filter publishes it")
# %% [hint]
# Begin without a filter: the starter answers each message as it came, and `%check` shows what is missing. Then ask
# three things. How many messages may the filter look back, if it may be 0.27 s behind? Where does the node keep the
# memory of the filter between two callbacks? And what is in there after a NaN, and after a restart?
#
# Where NumPy comes in: [NumPy for absolute beginners](https://numpy.org/doc/stable/user/absolute_beginners.html)
# %% [hint]
# - `np.array(message.position)` is an array of 12 angles; `.tolist()` turns it back.
# - A moving average of N messages leaves `1/sqrt(N)` of the noise and is `(N - 1) / 2` messages behind. With 0.05 s
#   between two messages, which N fit?
# - `np.where(np.isfinite(angles), angles, last_good)` takes the last good angle where there is a NaN.
# - A stamp as a pair, `(sec, nanosec)`, can be compared with `<`.
# - At a start, fill the memory as if the joints had always been where the first message says.
#
# Filters with a memory: [scipy.signal.sosfilt](https://docs.scipy.org/doc/scipy/reference/generated/scipy.signal.sosfilt.html)
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
# How the other filters look: [scipy.signal](https://docs.scipy.org/doc/scipy/reference/signal.html)
# %% [alternatives]
# ## Other good ways
#
# - **A moving average** of 5 to 11 messages needs NumPy only, and its memory is easy to understand: the last messages.
#   A NaN leaves the average by itself after N messages; a filter with feedback keeps it forever.
# - **Exponential smoothing**, `y += 0.3 * (x - y)`, is one line and remembers one number per joint. For the same delay
#   it lets a little more noise through.
# - **A filter for each joint**, in a dictionary by name. This also works where messages hold other joints, or the
#   joints in another order. Twelve calls instead of one: fine for twelve, not for ten thousand.
# - **A new message instead of the one that came.** `JointState(header=message.header, name=message.name,
#   position=...)` does not change what you were given. Here nobody else has it, so changing it does no harm.
# - **A straight line through the last 19 messages** (Savitzky–Golay, `savgol_coeffs(19, 1, pos=18, use="dot")`),
#   evaluated at its end. It is not behind at all while the joints move evenly. The price: it overshoots when they stop
#   or turn around.
# - **A Kalman filter** knows how noisy the encoder is and how the joint can move, and so needs less delay for the same
#   noise. Worth it when there is a model of the movement.

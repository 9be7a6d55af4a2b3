# %% [markdown]
# # 14 · Arrays and filters
#
# Sensors are noisy. How much noise can you remove from a measurement, and what does that cost? In this lesson, a node
# uses NumPy and SciPy to filter every message that it receives.
#
# - **Minutes:** 45
# - **You need:** lessons [03](03_publishers_and_messages.ipynb), [04](04_subscriptions_and_callbacks.ipynb) and
#   [09](09_joint_positions.ipynb)
# - **You will be able to:**
#   - turn a message into an array and back
#   - run a filter inside a callback
#   - trade off noise against delay
#   - choose a filter to suppress a vibration
# - **Not covered:** images (lesson 15), Kalman filters, messages at irregular intervals

# %% [markdown]
# Look at the robot. It waves slowly, but its encoders, the sensors in the joints, are noisy. That's why the robot in
# the drawing trembles.

# %%
from lesson_nodes import noisy_joints
from workbook.lesson import start, stop, watch_robot

print("started", start(noisy_joints, noise_rad=0.12))
await watch_robot(seconds=5, ease=0.1)
stop()

# %% [markdown]
# The node publishes a `JointState` twenty times a second. The `name` field holds twelve names, and the `position` field
# holds twelve angles in radians. To do arithmetic on the angles, you need two conversions. `np.array(message.position)`
# copies the angles into an array. `.tolist()` turns an array back into a list, which the field accepts. Here's a
# message with three joints:

# %%
import numpy as np
from sensor_msgs.msg import JointState

message = JointState(name=["neck", "waist", "knee"], position=[0.1, 0.2, 0.6])
angles = np.array(message.position)

doubled = JointState(name=message.name)
doubled.position = (2 * angles).tolist()
print("angles: ", angles, "on average", angles.mean())
print("doubled:", doubled.position)

# %% [markdown]
# **Your turn.** How far is each angle from the average of all three? With NumPy, you don't need a loop.

# %% id="your-difference"
from workbook.lesson import yours

difference = ...  # TODO: an array, from angles and angles.mean()

yours(difference, [-0.2, -0.1, 0.3], "Subtract the mean from the whole array.")

# %% [markdown]
# A **filter** computes a less noisy value from the current measurement and earlier ones. A callback gets one message at
# a time, and its local variables disappear when it returns. So the filter needs **state** that outlives the callback.
# We store it in an attribute. This filter's state is the last few measurements:

# %%
from collections import deque


class MovingAverage:
    """The mean of the last measurements."""

    def __init__(self, length: int) -> None:
        self.last = deque(maxlen=length)

    def step(self, value: float) -> float:
        self.last.append(value)
        return float(np.mean(self.last))


average = MovingAverage(3)
print([round(average.step(value), 2) for value in (0.9, 0.9, 0.9, 0.3, 0.3, 0.3)])

# %% [markdown] prediction="longer-average"
# ## Predict
#
# To measure noise and delay separately, we feed a filter two signals. The first is pure noise: how much of it remains?
# The second is a ramp that rises by 1 with each message: how far does the result lag behind?
#
# Suppose we average 16 messages instead of 4. How do noise and delay change?
#
# - **a** Half the noise remains, and the delay is five times as long.
#   when `noise_ratio > 0.4 and delay_ratio > 4.5`
#   ✓ Four times as many messages halve the noise. The delay grows from 1.5 to 7.5 messages.
# - **b** A quarter of the noise remains, and the delay is four times as long.
#   when `noise_ratio < 0.4 and delay_ratio > 3.0 and delay_ratio < 4.5`
#   ✗ Noise falls with the square root of the number of messages, and the square root of 4 is 2. The average lags as far
#   behind as the midpoint of its messages. That's (4 − 1)/2 = 1.5 and (16 − 1)/2 = 7.5 messages, so the delay is five
#   times as long.
# - **c** A quarter of the noise remains, and the delay doesn't change, because a mean takes hardly any time to compute.
#   when `noise_ratio < 0.4 and delay_ratio < 3.0`
#   ✗ The delay isn't computing time. An average of old and new values describes the moment halfway between the oldest
#   and the newest value.

# %%
from workbook.lesson import predict, reveal

predict("longer-average")

# %% [markdown]
# ## Run it

# %% id="noise-and-delay"
noise = np.random.default_rng(14).normal(size=4000)


def noise_left(one):
    """How much of the noise is left (%)."""
    return 100 * np.std([one.step(value) for value in noise][100:])


def delay(one):
    """How many messages the result is behind, on a ramp."""
    return 300 - [one.step(value) for value in range(301)][-1]


for length in (4, 16):
    left, late = noise_left(MovingAverage(length)), delay(MovingAverage(length))
    print(f"average of {length:>2}: {left:.0f} % of the noise, {late} messages behind")
noise_ratio = float(noise_left(MovingAverage(16)) / noise_left(MovingAverage(4)))
delay_ratio = delay(MovingAverage(16)) / delay(MovingAverage(4))
reveal("longer-average", noise_ratio=noise_ratio, delay_ratio=delay_ratio)

# %% [markdown]
# ## Look inside
#
# Independent errors partly cancel out, but more messages bring diminishing returns: an average of N messages leaves
# 1/√N of the noise. The delay grows faster, roughly in proportion to N. The mean of N messages describes the moment
# halfway between the oldest and the newest, so it's (N − 1)/2 messages behind. This delay isn't caused by slow code:
# part of each result comes from earlier measurements, and those describe the past.
#
# Try it. The next figure shows one elbow's angle over five seconds. We simulate this angle so that every run gets the
# same noise. Drag the slider while the cell runs.

# %%
from lesson_nodes.joint_position_publisher import JOINTS, waving
from lesson_nodes.noisy_joints import NOISE_RAD, WAVES_PER_SECOND

from workbook.lesson import slide
from workbook.pictures.figures import figure, render, show
from workbook.pictures.palette import AMBER, BLUE, GREEN, GREY

RATE_HZ = 20.0
ELBOW = JOINTS.index("left_elbow")
times = np.arange(100) / RATE_HZ
truth = np.array([waving(t, WAVES_PER_SECOND)[ELBOW] for t in times])
measured = truth + np.random.default_rng(5).normal(0.0, NOISE_RAD, size=100)


def draw(length):
    """The elbow with an average of so many messages."""
    average = MovingAverage(length)
    filtered = [average.step(value) for value in measured]
    left, late_s = noise_left(MovingAverage(length)), (length - 1) / 2 / RATE_HZ
    fig, axes = figure(7.2, 2.8)
    axes.plot(times, measured, ".", color=GREY)
    axes.plot(times, truth, "--", color=GREEN)
    axes.plot(times, filtered, color=BLUE)
    for words, color, height in (
        ("• measured", GREY, 0.92),
        ("- - where the elbow is", GREEN, 0.78),
        ("— filtered", BLUE, 0.64),
    ):
        axes.text(3.4, height, words, color=color)
    axes.set(xlabel="time (s)", ylabel="left elbow (rad)", xlim=(0, 5))
    axes.set_title(
        f"Average of {length}: {left:.0f} % of the noise left, {late_s:.2f} s late"
    )
    return render(fig)


await slide(
    "length",
    9,
    draw,
    between=(1, 30),
    describe="noisy dots around a slow dashed wave, and the average: calm, and to the "
    "right of the wave",
)

# %% [markdown]
# **Your turn.** A controller accepts angles that are at most 0.3 s late. At 20 messages a second, how many messages can
# your moving average span? Check your number with the slider.

# %% id="your-length"
longest = ...  # TODO: a whole number, from (N - 1) / 2 messages of 1 / 20 s each

yours(longest, 13, "(N - 1) / 2 must be 0.3 * 20 messages.")

# %% [markdown]
# ### A filter inside a callback
#
# Now let's filter the left elbow's angle live, as the messages arrive. The thread that runs the callbacks also draws
# the plot, and drawing delays the callbacks. So `run` calls `draw_live` only four times a second.
#
# [the same without helpers: init, fresh, run]

# %%
from rclpy.node import Node

from workbook.lesson import about, fresh, init, run
from workbook.pictures.live import LiveFigure

init()
ENCODERS = "/encoders/joint_states"


class ElbowFilter(Node):
    """Filters the left elbow, message by message."""

    def __init__(self) -> None:
        super().__init__("elbow_filter")
        self.filter = MovingAverage(9)
        self.stamps, self.measured, self.filtered = [], [], []
        self.create_subscription(JointState, ENCODERS, self.on_joints, 50)

    def on_joints(self, message: JointState) -> None:
        stamp = message.header.stamp
        self.stamps.append(stamp.sec + stamp.nanosec / 1e9)
        self.measured.append(message.position[ELBOW])
        self.filtered.append(self.filter.step(message.position[ELBOW]))


start(noisy_joints)
elbow = fresh(ElbowFilter)
live = LiveFigure("the left elbow, live: noisy dots, and the average of nine, calmer")


def draw_live():
    fig, axes = figure(7.2, 2.4)
    axes.plot(elbow.stamps[-60:], elbow.measured[-60:], ".", color=GREY)
    axes.plot(elbow.stamps[-60:], elbow.filtered[-60:], color=BLUE)
    axes.set(xlabel="stamp (s)", ylabel="left elbow (rad)")
    axes.set_title("The average of nine (blue) is calmer than the measured dots")
    live.show(render(fig))


await run(
    elbow,
    seconds=60,
    until=lambda: len(elbow.stamps) >= 100,
    each_frame=draw_live,
    fps=4,
)
live.finish()
stop()

# %% id="calmer"
for name, seen in (("measured", elbow.measured), ("filtered", elbow.filtered)):
    jump = np.sqrt(np.mean(np.square(np.diff(seen))))
    print(name, "from message to message:", about(jump, "rad", between=(0.005, 0.1)))
print("messages without a result:", len(elbow.measured) - len(elbow.filtered))

# %% [markdown]
# ### The Butterworth filter
#
# The **Butterworth** filter lets slow motion through and attenuates motion above its cutoff frequency. It computes each
# result from earlier results as well as from measurements.
#
# In `butter(2, ...)`, 2 is the **order**. A higher order separates slow and fast motion more sharply, but adds delay.
# SciPy splits a filter into *second-order sections*, `sos`, to keep rounding errors small. A filter of order 2 has one
# section. Along with the result, `sosfilt` returns the filter's state, two numbers per section. We pass that state to
# the next call as `zi`.

# %%
from scipy.signal import butter, sosfilt, sosfilt_zi


class Butterworth:
    """Passes movements slower than the cutoff frequency, and holds back faster ones."""

    def __init__(self, cutoff_hz: float) -> None:
        self.sos = butter(2, cutoff_hz, fs=RATE_HZ, output="sos")
        self.memory = None

    def step(self, value: float) -> float:
        if self.memory is None:  # as if the joint had always been here
            self.memory = sosfilt_zi(self.sos) * value
        filtered, self.memory = sosfilt(self.sos, [value], zi=self.memory)
        return float(filtered[0])


def both(kind, settings):
    """For each setting of a filter: delay (s), and how much noise is left (%)."""
    return [(delay(kind(n)) / RATE_HZ, noise_left(kind(n))) for n in settings]


averages = both(MovingAverage, (2, 4, 6, 9, 12, 16))
butterworths = both(Butterworth, (4.0, 2.0, 1.5, 1.0, 0.8, 0.6))

fig, axes = figure(6.8, 3.2)
axes.plot(*zip(*averages, strict=True), "o-", color=BLUE)
axes.plot(*zip(*butterworths, strict=True), "s--", color=AMBER)
for words, place, beside, color in (
    ("average of 2", averages[0], (10, 4), BLUE),
    ("average of 9", averages[3], (-78, -16), BLUE),
    ("average of 16", averages[-1], (-40, -22), BLUE),
    ("Butterworth, 4 Hz", butterworths[0], (10, 8), AMBER),
    ("Butterworth, 1 Hz", butterworths[3], (-6, 12), AMBER),
    ("Butterworth, 0.6 Hz", butterworths[-1], (-44, 12), AMBER),
):
    axes.annotate(words, place, beside, textcoords="offset points", color=color)
axes.set(xlabel="delay (s)", ylabel="noise left (%)", xlim=(0, 0.44), ylim=(0, 80))
axes.set_title("Less noise costs delay, with either filter")
show(fig, "noise against delay: both filters fall from little delay to little noise")

# %% [markdown]
# The ideal filter would be in the lower left corner of the figure, with little noise and little delay. Neither filter
# comes close. So **start from the delay that the robot can tolerate.** A balance controller can't use an angle that's
# 0.3 s old, but a display can.
#
# At the same delay, the Butterworth filter always leaves at least as much noise as the moving average. So why use it?
# Our noise is an equal mixture of all frequencies, but many disturbances on a robot have a single frequency.

# %% [markdown] prediction="vibrating-motor"
# ## Change it
#
# ### Experiment 1: a vibrating motor
#
# A motor makes the elbow vibrate 5.6 times a second, with an amplitude of 0.05 rad. We try two filters with a delay of
# about 0.2 s: an average of 9 messages, and a Butterworth filter with a 1 Hz cutoff. How much of the vibration does
# each filter leave?
#
# - **a** The average leaves less, as it did with noise.
#   when `average_left < 0.5 * butterworth_left`
#   ✗ Noise is a mixture of all frequencies. At a single frequency, the other filter can be better.
# - **b** Both leave about the same, because they have the same delay.
#   when `average_left >= 0.5 * butterworth_left and average_left <= 2 * butterworth_left`
#   ✗ The delay tells you how a filter affects slow motion. It tells you little about a fast vibration.
# - **c** Butterworth leaves much less.
#   when `average_left > 2 * butterworth_left`
#   ✓ The farther a vibration is above the cutoff, the less of it the Butterworth filter leaves. The average removes a
#   vibration only if nine messages span a whole number of its cycles, and here, they don't.

# %%
predict("vibrating-motor")

# %% id="vibrating-motor"
def vibration_left(one, hz):
    """How much of a vibration at this frequency is left (%)."""
    values = np.sin(2 * np.pi * hz * np.arange(400) / RATE_HZ)
    left = [one.step(value) for value in values]
    return float(100 * np.std(left[200:]) / np.std(values[200:]))


average_left = vibration_left(MovingAverage(9), 5.6)
butterworth_left = vibration_left(Butterworth(1.0), 5.6)
print(f"average of 9:      {average_left:.0f} % of the vibration left")
print(f"Butterworth, 1 Hz: {butterworth_left:.0f} %")
reveal(
    "vibrating-motor", average_left=average_left, butterworth_left=butterworth_left
)

# %%
hertz = np.linspace(0.1, 9.9, 99)
fig, axes = figure(6.8, 2.8)
axes.plot(hertz, [vibration_left(MovingAverage(9), hz) for hz in hertz], color=BLUE)
axes.plot(
    hertz, [vibration_left(Butterworth(1.0), hz) for hz in hertz], "--", color=AMBER
)
axes.annotate("average of 9", (5.6, 17), color=BLUE, ha="center")
axes.annotate("Butterworth, 1 Hz", (1.5, 52), color=AMBER)
axes.set(xlabel="frequency of the vibration (Hz)", ylabel="left (%)", ylim=(0, 105))
axes.set_title("The average lets some fast vibrations pass, Butterworth doesn't")
show(
    fig,
    "what is left at each frequency: the average of nine falls to zero at 2.2 Hz and "
    "rises again several times; Butterworth falls once and stays low",
)

# %% [markdown]
# At 2.2 Hz and its multiples, nine messages span a whole number of cycles, so the average removes these vibrations
# completely. If you know a disturbance's exact frequency, and it never changes, an average of the right length is best.
# But a motor's speed varies, so for this vibration, the Butterworth filter is the better choice.

# %% [markdown] prediction="message-fifty-again"
# ### Experiment 2: a filter without delay
#
# SciPy also has `sosfiltfilt`. It runs the Butterworth filter forward and then backward, so the two delays cancel.
# Suppose we have 60 messages and compute the result for message 50. Later, we have 100 messages and compute that result
# again. What do we get?
#
# - **a** The same result, because message 50 hasn't changed.
#   when `difference < 1e-12`
#   ✗ That would be true for a filter that uses only earlier messages, such as `sosfilt`. But the backward pass of
#   `sosfiltfilt` starts at the newest message.
# - **b** A different result, because it depends on later messages.
#   when `difference >= 1e-12`
#   ✓ The backward pass starts at the newest message, so each new message changes earlier results.
# - **c** An error, because `sosfiltfilt` needs all messages since the robot started.
#   ✗ `sosfiltfilt` accepts any sequence of messages that is long enough.

# %%
predict("message-fifty-again")

# %% id="looks-ahead"
from scipy.signal import sosfiltfilt

sos = butter(2, 1.0, fs=RATE_HZ, output="sos")
ramp = np.arange(200.0)


def forward(values):
    """All values, from the first to the last."""
    return sosfilt(sos, values, zi=sosfilt_zi(sos) * values[0])[0]


def forward_and_back(values):
    """All values, from the first to the last, and then backward."""
    return sosfiltfilt(sos, values)


for one in (forward, forward_and_back):
    early, late = one(measured[:60])[50], one(measured)[50]
    behind = abs(ramp[100] - one(ramp)[100])
    print(f"{one.__name__}: message 50 is {early:.3f}, later {late:.3f}; ", end="")
    print(f"{behind:.1f} messages behind on a ramp")
reveal("message-fifty-again", difference=float(abs(early - late)))

# %% [markdown]
# `sosfiltfilt` and the older `filtfilt` avoid the delay by **using later values**. A callback doesn't have those values
# yet. So use these functions only on recordings: to plot a smooth curve, or to compare your live filter with an ideal
# result.
#
# **Savitzky–Golay** filters look ahead, too. They fit a polynomial to a window of messages, and usually return the
# polynomial's value in the *middle* of the window. The window below spans 19 messages. With `pos=18`, the index of the
# last one, you get the value at the window's *end* instead, which needs no later messages. We test both versions,
# middle and end, with a ramp, noise, and a step from 0 to 1.

# %% id="line-through-the-last"
from scipy.signal import savgol_coeffs


class Line(MovingAverage):
    """A straight line through the last 19 measurements, read at one place of it."""

    def __init__(self, place: int) -> None:
        super().__init__(19)
        self.weights = savgol_coeffs(19, polyorder=1, pos=place, use="dot")

    def step(self, value: float) -> float:
        if not self.last:
            self.last.extend([value] * 19)
        self.last.append(value)
        return float(self.weights @ np.array(self.last))


for where, place in (("middle", 9), ("end", 18)):
    line = Line(place)
    after_step = [line.step(value) for value in [0.0] * 19 + [1.0] * 25]
    print(
        f"{where + ':':<7} {abs(delay(Line(place))):.1f} messages behind, "
        f"{noise_left(Line(place)):.0f} % of the noise left, "
        f"after the step at most {max(after_step):.1f}"
    )

# %% [markdown]
# In a callback, the middle of the window is nine messages old, so that version does have a delay. The value at the end
# follows a ramp without delay. The price is **overshoot**: if the joint stops or reverses, the result continues in the
# old direction for a while.

# %% [markdown]
# ## When it goes wrong
#
# **The state is lost.** This is the most common mistake: the callback creates a new filter for each message.

# %% id="memory-lost"
forgetful = np.array([Butterworth(1.0).step(value) for value in measured])
print(f"largest change of a measurement: {abs(forgetful - measured).max():.3f} rad")

# %% [markdown]
# There's no error, but nothing is filtered. Create the filter in `__init__`, and keep it in an attribute.
#
# **NaN stays in the filter.** An encoder reports NaN once, in message 10 of 40. Which results are NaN?

# %% id="nan-stays"
import math

with_nan = [0.5] * 40
with_nan[10] = math.nan
filters = {"average of 5": MovingAverage(5), "Butterworth": Butterworth(1.0)}
for name, one in filters.items():
    results = [one.step(value) for value in with_nan]
    number = sum(map(math.isnan, results))
    print(f"{name}: {number} results are NaN, and the last one is {results[-1]:.1f}")

# %% [markdown]
# The NaN drops out of this moving average after five messages, because each mean depends only on the messages in the
# window. A filter with feedback computes each result from earlier results, so one NaN makes all later results NaN. Such
# a filter is called **IIR**, *infinite impulse response*: each input affects all later results. A moving average that's
# computed from a running sum has feedback, too. For each message, it adds the newest value to the sum and subtracts the
# oldest, and NaN − NaN is NaN.
#
# So check each value *before* it reaches a filter, and replace each NaN with the last good value.
#
# **Your turn.** Write the line that replaces each NaN. `np.isfinite(angles)` returns an array that holds `True` for
# each finite number and `False` for any other value, such as NaN. `np.where(condition, a, b)` takes values from `a`
# where the condition is true, and from `b` elsewhere.

# %% id="your-last-good"
angles, last_good = np.array([0.3, math.nan, -0.2]), np.array([0.1, 0.7, -0.1])

cleaned = ...  # TODO: angles, but with the last good value in place of NaN

yours(cleaned, [0.3, 0.7, -0.2], "np.where(np.isfinite(angles), angles, last_good)")

# %% [markdown]
# **The filter needs time to settle.** Here, the state starts at zero, but the joint is at 0.9 rad:

# %% id="swings-in"
from_zero = Butterworth(1.0)
from_zero.memory = np.zeros((1, 2))
first = [from_zero.step(0.9) for _ in range(12)]
print("begun with zeros:      ", [round(value, 1) for value in first])
print("begun where the joint is:", round(Butterworth(1.0).step(0.9), 1))

# %% [markdown]
# For half a second, the filter reports a movement that never happened. So start from `sosfilt_zi(sos) * value`, the
# state of a filter whose input has been `value` for a long time. The same thing happens when a sensor restarts after
# its joint has moved, because the filter still has its old state. Reset the state after a restart.

# %% [markdown]
# ## From a worked example to your own
#
# **Worked example.** This node filters all twelve joints together. The state is a `deque` of arrays. With `axis=0`,
# `np.mean` averages each joint's angle over the stored messages.


# %%
class JointAverage(Node):
    """Publishes the mean of the last five messages, for all joints."""

    def __init__(self) -> None:
        super().__init__("joint_average")
        self.last = deque(maxlen=5)
        self.publisher = self.create_publisher(JointState, "/robot/joint_states", 50)
        self.create_subscription(JointState, ENCODERS, self.on_joints, 50)

    def on_joints(self, message: JointState) -> None:
        self.last.append(np.array(message.position))
        answer = JointState(header=message.header, name=message.name)
        answer.position = np.mean(self.last, axis=0).tolist()
        self.publisher.publish(answer)


from lesson_nodes.joint_scope import JointScope

start(noisy_joints)
average, scope = fresh(JointAverage), fresh(JointScope)
await run(average, scope, seconds=60, until=lambda: len(scope.filtered) >= 40)
stop()
stamps = {stamp for stamp, _ in scope.measured}
# Two topics: the newest answer may be here before the measurement that it was made of.
kept = sum(stamp in stamps for stamp, _ in scope.filtered[10:30])
print("answers with the stamp of a measurement:", kept, "of 20")

# %% [markdown]
# **Twelve joints and `sosfilt`.** With `axis=0`, `sosfilt` filters along the time axis, so one call handles all twelve
# joints. The array `memory` holds a separate state for each joint.

# %% id="twelve-states"
at_rest = sosfilt_zi(sos)  # 1 section, 2 numbers
angles = np.linspace(-1.0, 1.0, 12)
memory = at_rest[:, :, np.newaxis] * angles  # 1 section, 2 numbers, 12 joints
filtered, memory = sosfilt(sos, angles[np.newaxis], axis=0, zi=memory)
print("state of one joint:", at_rest.shape, "and of twelve:", memory.shape)
print(f"first results differ by {abs(filtered[0] - angles).max():.1f} rad")

# %% [markdown]
# **Fill in the blanks.** Exponential smoothing stores its last result. With each message, the result moves a fixed
# fraction of the way toward the new measurement. Replace each `...` with your code. With `PART = 0.25`, the result
# should be 3.0 messages behind, with about 38 % of the noise left.

# %%
PART = ...  # TODO: between 0 (very calm, very late) and 1 (no filter), such as 0.25


class Smoothing:
    """Exponential smoothing."""

    def __init__(self) -> None:
        self.result = None

    def step(self, value: float) -> float:
        if self.result is None:
            self.result = value  # begin where the joint is
        self.result += ...  # TODO: PART of the way from self.result to value
        return self.result


seen = ... if PART is ... else (delay(Smoothing()), round(noise_left(Smoothing())))
yours(seen, (3.0, 38), "self.result += PART * (value - self.result), and PART = 0.25")

# %% [markdown]
# **Your own.** In the [exercise](../exercises/14_arrays_and_filters.ipynb), you write the filter node for twelve
# joints, with limits on noise and delay. It must survive NaN and an encoder restart.

# %% [markdown]
# ## Check yourself
#
# **1. A fan shakes a joint at 6 to 8 Hz. You get 20 messages a second, and the result may be at most 0.2 s late. Which filter do you choose?**
#
# <details><summary>a) An average of 9, because it leaves the least noise</summary>
#
# ✗ That's true for noise, which contains all frequencies. Between 6 and 8 Hz, the average leaves up to 15 % of a
# vibration.
#
# </details>
# <details><summary>b) Butterworth with a cutoff at 1 Hz</summary>
#
# ✓ It adds about as much delay as the average of 9, but leaves 2 % or less of these vibrations.
#
# </details>
# <details><summary>c) <code>sosfiltfilt</code> in the callback, because it has no delay</summary>
#
# ✗ It uses later messages, which a callback doesn't have yet.
#
# </details>
#
# **2. Messages arrive at 50 Hz, and your filter may be at most 0.1 s late. How many messages can a moving average span?**
#
# <details><summary>a) 5</summary>
#
# ✗ Five messages span 0.1 s, but their mean is only (5 − 1)/2 = 2 messages behind, or 0.04 s.
#
# </details>
# <details><summary>b) 11</summary>
#
# ✓ (11 − 1)/2 = 5 messages, and 5 · 0.02 s = 0.1 s.
#
# </details>
# <details><summary>c) 50</summary>
#
# ✗ The average would be 24.5 messages behind, nearly half a second.
#
# </details>
#
# **3. After one NaN, all results of your Butterworth filter are NaN. What fixes this?**
#
# <details><summary>a) <code>np.nan_to_num</code> after the filter</summary>
#
# ✗ The NaN stays in the filter's state, so every later result is NaN. If you only replace those results, you publish
# zeros forever.
#
# </details>
# <details><summary>b) A lower cutoff frequency</summary>
#
# ✗ NaN times anything is NaN, whatever the cutoff frequency.
#
# </details>
# <details><summary>c) Replacing each NaN with the last good value, before the filter</summary>
#
# ✓ Then NaN never reaches the state.
#
# </details>
#
# **4. Why does `filtfilt` have no delay?**
#
# <details><summary>a) For each result, it also uses later values</summary>
#
# ✓ A callback doesn't have these values yet, so use `filtfilt` only for recordings.
#
# </details>
# <details><summary>b) It's written in C</summary>
#
# ✗ The delay has nothing to do with computing speed.
#
# </details>
# <details><summary>c) It filters less</summary>
#
# ✗ It filters twice, so it leaves even less noise.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Write down your own answer first. Then copy the prompt into an AI assistant, or discuss it with a colleague.
#
# ```text
# I'm programming a robot with ROS 2 Jazzy in Python (rclpy). My humanoid's hands
# tremble because its joint encoders, which I read at 100 Hz, are noisy. I want to
# filter the angles in a Python node before the balance controller gets them. Which
# filter would you use, how do I choose its parameters, and what can go wrong? Make sure
# that every rclpy function you use exists in Jazzy.
# ```
#
# <details><summary>What a good answer covers</summary>
#
# Before recommending a filter, a good answer asks how much delay the controller tolerates. It compares simple filters
# (a moving average or exponential smoothing) with a low-order Butterworth filter, in terms of noise *and* delay. It
# keeps the filter's state in the node and doesn't suggest `filtfilt`. It initializes the state with the first
# measurement, keeps NaN out, and copies the stamp and the joint names from each message to its result. It resets the
# state when the source restarts. Finally, it asks whether you can reduce the noise at the source.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Watch for these two suggestions. We tested both in this course's environment, and neither works in a callback.
#
# - **Call `filtfilt` in the callback:** It runs over the samples backward as well as forward, so it needs samples that
#   haven't arrived yet. Its result for the newest message changes when the next one arrives.
# - **Call `savgol_filter` on the last samples, because it has no delay:** It centers a window on each sample. The
#   newest samples have no full window around them, so it evaluates the polynomial fitted to the last full window
#   instead. As a result, the values for the newest samples change when the next message arrives.
#
# </details>

# %% [markdown]
# ## Take away
#
# - `np.array(message.position)` copies the angles into an array, and `.tolist()` turns an array back into a list.
# - A filter in a callback needs state that outlives the callback. Initialize that state with the first measurement.
# - An average of N messages leaves 1/√N of the noise and is (N − 1)/2 messages behind. Choose the delay first.
# - Far above its cutoff, a Butterworth filter usually suppresses a vibration better than an average with the same
#   delay.
# - `filtfilt` avoids the delay by using later values, so it's only for recordings.
#
# **Before:** [13 · QoS and discovery](13_qos_and_discovery.ipynb)
#
# **Deeper:** [14 · Deeper: views, copies, and cost](14_arrays_and_filters_deeper.ipynb)
#
# **Next:** [15 · A camera](15_camera.ipynb)
#
# **More:** [SciPy: signal processing](https://docs.scipy.org/doc/scipy/tutorial/signal.html) and
# [about interfaces](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Interfaces.html).

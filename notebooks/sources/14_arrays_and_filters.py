# %% [markdown]
# # 14 · Arrays and filters
#
# Sensors are noisy. Python has good tools against noise, NumPy and SciPy, and a node can use them on every message.
#
# - **Minutes:** 45
# - **You need:** lessons [03](03_publishers_and_messages.ipynb), [04](04_subscriptions_and_callbacks.ipynb) and
#   [09](09_joint_positions.ipynb)
# - **You will be able to:**
#   - turn a message into an array and back
#   - say which of the two a write changes
#   - run a filter inside a callback
#   - weigh noise against delay
# - **Left out:** images (lesson 15), Kalman filters, messages that come at irregular intervals

# %% [markdown]
# How much noise can you take out of a measurement, and what do you pay for it? Look at the robot. It waves slowly, but
# its encoders, the sensors in the joints, are noisy.

# %%
from lesson_nodes import noisy_joints
from workbook.lesson import start, stop, watch_robot

print("started", start(noisy_joints, noise_rad=0.12))
await watch_robot(seconds=5, ease=0.1)
stop()

# %% [markdown]
# The node publishes a `JointState` twenty times a second. Its field `name` holds twelve names, and `position` holds
# twelve angles in radians. In a callback you want to compute with these angles, so you make an array of them.

# %% [markdown] prediction="array-of-a-message"
# ## Predict
#
# ```python
# message = JointState(position=[0.1, 0.2, 0.3])
# angles = np.asarray(message.position)
# angles[0] = 9.0
# print(message.position[0])
# ```
#
# What does the last line print?
#
# - **a** `0.1`: the array is a copy.
#   when `first < 1.0`
#   ✗ `np.array` would copy. `np.asarray` takes the memory that is there, if it can.
# - **b** Nothing: NumPy raises an error, because messages are read-only.
#   ✗ Fields of a message can be written to, by their name and through an array that shares their memory.
# - **c** `9.0`: array and message share their memory.
#   when `first > 1.0`
#   ✓ The array looks at the memory of the message, so each shows what was written into the other.

# %%
from workbook.lesson import predict, reveal

predict("array-of-a-message")

# %% [markdown]
# ## Run it

# %% id="view-or-copy"
import numpy as np
from sensor_msgs.msg import JointState

message = JointState(position=[0.1, 0.2, 0.3])
angles = np.asarray(message.position)
angles[0] = 9.0
print("after a write through np.asarray:", message.position[0])

others = np.array(message.position)
others[1] = 9.0
print("after a write through np.array:  ", message.position[1])
reveal("array-of-a-message", first=message.position[0])

# %% [markdown]
# ## Look inside
#
# `np.asarray` made a **view**: an array that has no memory of its own and looks at that of the message. `np.array` made
# a **copy**. A view costs almost nothing, but whatever you write into it, you write into the message.
#
# So take `np.asarray` to read, and `np.array` as soon as you write. Who sees a change that you make? Two subscriptions
# in one process hear the same topic. The first callback writes through a view:

# %% id="own-object"
from rclpy.node import Node
from workbook.lesson import fresh, init, run

init()
ENCODERS = "/encoders/joint_states"


class TwoReaders(Node):
    """Two subscriptions for one topic. The first writes into what it gets."""

    def __init__(self) -> None:
        super().__init__("two_readers")
        self.got = {"writer": [], "reader": []}
        self.create_subscription(JointState, ENCODERS, self.write, 50)
        self.create_subscription(JointState, ENCODERS, self.read, 50)

    def write(self, message: JointState) -> None:
        np.asarray(message.position)[:] = 9.0
        self.got["writer"].append(message)

    def read(self, message: JointState) -> None:
        self.got["reader"].append(message)


start(noisy_joints)
two = fresh(TwoReaders)
await run(two, seconds=60, until=lambda: min(map(len, two.got.values())) >= 5)
stop()
first = [message.position[0] == 9.0 for message in two.got["writer"]]
second = [message.position[0] == 9.0 for message in two.got["reader"]]
print("the first callback reads 9.0: ", all(first))
print("the second callback reads 9.0:", any(second))

# %% [markdown]
# rclpy makes a new Python object for **each subscription**. Other callbacks and other nodes do not see your change.
# Only code that gets *this* object from you sees it: a list that keeps it, a method that takes it, a publisher that
# sends it.
#
# rclpy keeps a field of numbers whose **length may vary** in an `array.array` from Python's standard library. There the
# numbers lie side by side, without a Python object for each: so the view works. A field of **fixed length** is a NumPy
# array already. The type of the field decides the **dtype**, the type of the numbers in the array.

# %% id="dtypes"
from sensor_msgs.msg import Imu, LaserScan
from std_msgs.msg import Float32MultiArray

scan = LaserScan(ranges=[0.1, float("inf"), 2.5])
for name, field in {
    "JointState.position": JointState(position=[0.1]).position,
    "Float32MultiArray.data": Float32MultiArray(data=[0.1]).data,
    "LaserScan.ranges": scan.ranges,
    "Imu.orientation_covariance": Imu().orientation_covariance,
}.items():
    array_of_it = np.asarray(field)
    print(f"{name:<27} {type(field).__name__:<8} {array_of_it.dtype}  {array_of_it[0]}")

ranges = np.asarray(scan.ranges)
print("nearest obstacle:", ranges[np.isfinite(ranges)].min(), "m")

# %% [markdown]
# `Float32MultiArray` and `LaserScan` hold 32-bit numbers, so 0.1 comes back rounded. A laser scanner says `inf` where it
# sees nothing.
#
# And back? A field of fixed length takes an array of NumPy. A field of variable length refuses it while **field checks**
# are on, as in these notebooks. A node that you start with `ros2 run` has them off, and accepts it. Two ways always work:
# `.tolist()`, and an `array.array` made from the bytes of the array.

# %% id="and-back"
import array

angles = np.array([0.1, 0.2, 0.3])
message.position = angles.tolist()
print("by a list: ", message.position)
message.position = array.array("d", angles.tobytes())
print("by bytes:  ", message.position)

# %% [markdown]
# What does this cost? We measure each way for twelve angles, for a laser scan of 10,000 values, and for a million
# values. That is about one image of a camera. "One by one" touches every number in Python, "in one piece" does not.

# %% tags=["nbval-ignore-output"]
from timeit import repeat


def cost_us(work, times):
    """The shortest of five measurements (µs)."""
    return 1e6 * min(repeat(work, number=times, repeat=5)) / times


def costs(size):
    """What each way costs (µs), for an array of so many values."""
    values = np.linspace(0.0, 1.0, size, dtype=np.float32)
    message = Float32MultiArray()

    def in_one_by_one():
        message.data = values.tolist()

    def in_one_piece():
        message.data = array.array("f", values.tobytes())

    ways = {
        "in, one by one": in_one_by_one,
        "in, in one piece": in_one_piece,
        "out, one by one": lambda: [float(value) for value in message.data],
        "out, in one piece": lambda: np.asarray(message.data),
    }
    times = max(1, 20_000 // size)
    return {way: cost_us(work, times) for way, work in ways.items()}


cost = {size: costs(size) for size in (12, 10_000, 1_000_000)}
for size, of in cost.items():
    print(f"{size:>9} values:", {way: f"{us:.1f} µs" for way, us in of.items()})

# %% id="cost-ratios"
few, many = cost[12], cost[1_000_000]
for way in ("out", "in"):
    slow, quick = f"{way}, one by one", f"{way}, in one piece"
    print(f"{way}, a million values, one by one:")
    print("   over 10 times the cost of one piece: ", many[slow] > 10 * many[quick])
    print("   over 1000 times the cost of 12 values:", many[slow] > 1000 * few[slow])
view = "out, in one piece"
cheap = many[view] < 50 * few[view]
print("the view of a million values costs less than 50 times that of 12:", cheap)

# %% [markdown]
# For twelve joints, write what reads best: `.tolist()`. For images and scans, avoid every loop over single numbers.
#
# ### A filter inside a callback
#
# A **filter** computes a quieter value from this measurement and earlier ones. A callback gets one message at a time
# and forgets everything when it returns. So the filter needs a **memory** that outlives the callback: an attribute.
#
# Here are two filters for one number. The moving average remembers the last measurements. The **Butterworth** filter
# lets slow movements pass, and holds back what is faster than its cutoff frequency. It feeds its own results back.
#
# In `butter(2, ...)`, 2 is the **order**. A higher order separates slow from fast more sharply, but delays the result
# more. SciPy splits a filter into *second-order sections*, `sos`, because rounding errors stay small that way. Order
# 2 is one section. `sosfilt` hands us its memory `zi`, two numbers for each section, and we give it back in the next
# call.

# %%
from collections import deque

from scipy.signal import butter, sosfilt, sosfilt_zi

RATE_HZ = 20.0


class MovingAverage:
    """The mean of the last measurements."""

    def __init__(self, length: int) -> None:
        self.last = deque(maxlen=length)

    def step(self, value: float) -> float:
        self.last.append(value)
        return float(np.mean(self.last))


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


# %% [markdown]
# Now on the live topic. The node below filters the left elbow of each message, at once, with both. The plot is live, and
# does not slow the node: callbacks only store numbers, and `each_frame` draws four times a second *between* callbacks.

# %%
from lesson_nodes.joint_position_publisher import JOINTS
from workbook.pictures.figures import figure, render, show
from workbook.pictures.live import LiveFigure

ELBOW = JOINTS.index("left_elbow")


class ElbowFilter(Node):
    """Filters the left elbow in two ways, message by message."""

    def __init__(self) -> None:
        super().__init__("elbow_filter")
        self.filters = {"average": MovingAverage(9), "Butterworth": Butterworth(1.0)}
        self.seen = {"measured": [], "average": [], "Butterworth": []}
        self.stamps = []
        self.create_subscription(JointState, ENCODERS, self.on_joints, 50)

    def on_joints(self, message: JointState) -> None:
        angle = message.position[ELBOW]
        stamp = message.header.stamp
        self.stamps.append(stamp.sec + stamp.nanosec / 1e9)
        self.seen["measured"].append(angle)
        for name, one in self.filters.items():
            self.seen[name].append(one.step(angle))


start(noisy_joints)
elbow = fresh(ElbowFilter)
live = LiveFigure(
    "the left elbow, live: noisy dots, and the average of nine as a calm line"
)


def draw():
    fig, axes = figure(7.2, 2.4)
    axes.plot(elbow.stamps[-60:], elbow.seen["measured"][-60:], ".", color="#787878")
    axes.plot(elbow.stamps[-60:], elbow.seen["average"][-60:], color="#2f78d0")
    axes.set(xlabel="stamp (s)", ylabel="left elbow (rad)")
    axes.set_title("The average of nine is calmer than the measured dots")
    live.show(render(fig))


await run(
    elbow, seconds=60, until=lambda: len(elbow.stamps) >= 140, each_frame=draw, fps=4
)
live.finish()
stop()

# %% id="calmer"
jumps = {name: np.std(np.diff(seen)) for name, seen in elbow.seen.items()}
for name in elbow.filters:
    halved = jumps[name] < 0.5 * jumps["measured"]
    print(f"{name}: jumps from message to message halved, or better: {halved}")
lengths = {len(seen) for seen in elbow.seen.values()}
print("one result for each message:", lengths == {len(elbow.stamps)})

# %%
from lesson_nodes.joint_position_publisher import waving
from lesson_nodes.noisy_joints import WAVES_PER_SECOND

truth = [waving(t, WAVES_PER_SECOND)[ELBOW] for t in elbow.stamps]
fig, axes = figure(7.2, 3.2)
for name, look, color in (
    ("measured", ".", "#787878"),
    ("average", "-", "#2f78d0"),
    ("Butterworth", "-", "#b06a00"),
):
    axes.plot(elbow.stamps, elbow.seen[name], look, color=color, label=name)
axes.plot(elbow.stamps, truth, "--", color="#208a3c", label="where the elbow is")
axes.set(xlabel="stamp (s)", ylabel="left elbow (rad)")
axes.set_title("Both filters are calm, and both are late")
fig.legend(loc="outside right upper")
show(fig, "noisy dots around a slow wave; both filtered curves are smooth, and late")

# %% [markdown]
# Both curves are calmer than the dots, and both lie to the right of the dashed line: they are **late**. This is no
# fault of the code. Each result is made of earlier measurements, so it is about the past.

# %% [markdown] prediction="longer-average"
# ## Change it
#
# ### Experiment 1: a longer average
#
# To see noise and delay apart, we feed a filter two signals. Pure noise: how much of it is left? And a ramp that rises
# by 1 with each message: how far is the result behind?
#
# We go from an average of 4 messages to one of 16. What happens?
#
# - **a** Half of the noise, and five times the delay.
#   when `noise_ratio > 0.4 and delay_ratio > 4.5`
#   ✓ Four times as many messages leave half of the noise. The delay grows from 1.5 to 7.5 messages.
# - **b** A quarter of the noise, and four times the delay.
#   when `noise_ratio < 0.4 and delay_ratio > 3.0 and delay_ratio < 4.5`
#   ✗ Noise goes down with the square root of the number of messages, and the root of 4 is 2. The delay is that of the
#   middle message: (4 − 1)/2 = 1.5 and (16 − 1)/2 = 7.5, five times as much.
# - **c** A quarter of the noise, and the same delay: computing a mean takes no time.
#   when `noise_ratio < 0.4 and delay_ratio < 3.0`
#   ✗ The delay does not come from computing. A mean of old and new values shows how things were halfway
#   between the oldest and the newest.

# %%
predict("longer-average")

# %% id="noise-and-delay"
noise = np.random.default_rng(14).normal(size=4000)


def noise_left(one):
    """Which part of the noise is left."""
    return np.std([one.step(value) for value in noise][100:])


def delay(one):
    """How many messages the result is behind, on a ramp."""
    return 300 - [one.step(value) for value in range(301)][-1]


for length in (4, 16):
    print(f"average of {length:>2}: {delay(MovingAverage(length)):.1f} messages behind")
noise_ratio = float(noise_left(MovingAverage(16)) / noise_left(MovingAverage(4)))
print(f"16 instead of 4 leaves {noise_ratio:.1f} times the noise")
delay_ratio = delay(MovingAverage(16)) / delay(MovingAverage(4))
reveal("longer-average", noise_ratio=noise_ratio, delay_ratio=delay_ratio)

# %% [markdown]
# The noise of independent measurements averages out slowly: N of them leave 1/√N. The delay grows with N itself: an
# average of N is (N − 1)/2 messages behind. Here is the same measurement for many filters.


# %%
def both(kind, settings):
    """For each setting of a filter: delay (s), and what is left of the noise (%)."""
    return [(delay(kind(n)) / RATE_HZ, 100 * noise_left(kind(n))) for n in settings]


averages = both(MovingAverage, (2, 4, 6, 9, 12, 16))
butterworths = both(Butterworth, (4.0, 2.0, 1.5, 1.0, 0.8, 0.6))

fig, axes = figure(6.4, 3.2)
axes.plot(*zip(*averages, strict=True), "o-", color="#2f78d0")
axes.plot(*zip(*butterworths, strict=True), "s--", color="#b06a00")
for words, place, beside in (
    ("average of 2", averages[0], (10, 4)),
    ("average of 16", averages[-1], (-40, -22)),
    ("Butterworth, 4 Hz", butterworths[0], (14, 0)),
    ("Butterworth, 0.6 Hz", butterworths[-1], (-50, 14)),
):
    axes.annotate(words, place, beside, textcoords="offset points")
axes.set(xlabel="delay (s)", ylabel="noise left (%)", xlim=(0, 0.44), ylim=(0, 80))
axes.set_title("Less noise costs delay, with both filters")
show(fig, "noise against delay: both filters fall from little delay to little noise")

# %% [markdown]
# Neither filter gets into the lower left corner. **Choose by what the robot can afford.** A balance controller cannot use
# an angle that is 0.3 s old. A display can.
#
# Is there a filter without delay? A **Savitzky–Golay** filter fits a straight line to the last messages, and returns
# the value at the end of that line. Here is such a filter over 19 messages, applied to noise, to a ramp, and to a step
# from 0 to 1.

# %% id="line-through-the-last"
from scipy.signal import savgol_coeffs

weights = savgol_coeffs(19, polyorder=1, pos=18, use="dot")


class Line(MovingAverage):
    """A straight line through the last 19 measurements, and its end."""

    def step(self, value: float) -> float:
        if not self.last:
            self.last.extend([value] * 19)
        self.last.append(value)
        return float(weights @ np.array(self.last))


step = Line(19)
after_step = [step.step(value) for value in [0.0] * 19 + [1.0] * 25]
print(
    f"{abs(delay(Line(19))):.1f} messages behind on a ramp, "
    f"{100 * noise_left(Line(19)):.0f} % of the noise left"
)
print(f"after a step to 1.0 it says up to {max(after_step):.1f}")

# %% [markdown]
# The price is **overshoot**: when the joint stops or turns around, the line goes on for a while.

# %% [markdown] prediction="message-fifty-again"
# ### Experiment 2: a filter without delay
#
# SciPy also has `sosfiltfilt`. It runs the Butterworth filter forward and then backward, so the two delays cancel.
# Suppose we hold 60 messages and let it compute the result for message 50. Later we hold 100 messages, and ask for
# message 50 again.
#
# - **a** Message 50 gets the same result, because it has not changed.
#   when `difference < 1e-12`
#   ✗ That holds for a filter that looks back only, such as `sosfilt`. The way back begins at the newest message.
# - **b** Message 50 gets another result, because it depends on messages that come later.
#   when `difference >= 1e-12`
#   ✓ On its way back the filter begins with the newest message, so each new one changes what came before.
# - **c** It fails: `sosfiltfilt` needs all messages of the robot's life.
#   ✗ It takes any stretch of messages that is long enough, and filters that.

# %%
predict("message-fifty-again")

# %% id="looks-ahead"
from scipy.signal import sosfiltfilt

sos = butter(2, 1.0, fs=RATE_HZ, output="sos")
measured = np.array(elbow.seen["measured"][:100])


def forward(values):
    """All values, from the first to the last."""
    return sosfilt(sos, values, zi=sosfilt_zi(sos) * values[0])[0]


def forward_and_back(values):
    """All values, from the first to the last, and then backward."""
    return sosfiltfilt(sos, values)


for one in (forward, forward_and_back):
    early, late = one(measured[:60])[50], one(measured)[50]
    same = abs(early - late) < 1e-12
    print(f"{one.__name__}: the same result for message 50: {same}")
reveal("message-fifty-again", difference=float(abs(early - late)))

# %% id="looks-ahead-on-a-ramp"
ramp = np.arange(200.0)
for one in (forward, forward_and_back):
    behind = ramp[100] - one(ramp)[100]
    print(f"{one.__name__}: {abs(behind):.1f} messages behind on a ramp")

# %% [markdown]
# `sosfiltfilt`, and its older sister `filtfilt`, avoid the delay by **looking ahead**. In a callback the future is
# not there yet. Use them for recordings: to draw a clean curve, or to compare your live filter with the best that was
# possible.

# %% [markdown]
# ## When it goes wrong
#
# **The memory is lost.** The most common fault: the filter is made inside the callback, anew for each message.

# %% id="memory-lost"
forgetful = [Butterworth(1.0).step(value) for value in measured]
print("the result is the measurement itself:", np.allclose(forgetful, measured))

# %% [markdown]
# No error, and nothing is filtered. Make the filter in `__init__`, and keep it in an attribute.
#
# **NaN that never leaves.** An encoder says NaN once, in message 10 of 40. In which results is it?

# %% id="nan-stays"
import math

with_nan = [0.5] * 40
with_nan[10] = math.nan
filters = {"average of 5": MovingAverage(5), "Butterworth": Butterworth(1.0)}
for name, one in filters.items():
    results = [one.step(value) for value in with_nan]
    number, last = sum(map(math.isnan, results)), math.isnan(results[-1])
    print(f"{name}: {number} results are NaN, the last one too: {last}")

# %% [markdown]
# NaN leaves this moving average after five messages, because each mean is computed anew from the window. A filter with
# feedback computes each result from earlier results, and whatever is computed from NaN is NaN. Such a filter is called
# **IIR**, *infinite impulse response*: what came in once has an effect forever. A moving average can have feedback, too.
# This one saves work with a running sum: it adds the newest value and subtracts the oldest.

# %% id="running-sum"
window, total, results = deque([0.5] * 5), 5 * 0.5, []
for value in with_nan:
    window.append(value)
    total += value - window.popleft()
    results.append(total / 5)
print(
    f"running sum: {sum(map(math.isnan, results))} results are NaN, "
    f"the last one too: {math.isnan(results[-1])}"
)

# %% [markdown]
# NaN − NaN is NaN, so it stays in the sum. *Before* any filter, check each value with `np.isfinite`, and replace each
# NaN with the last good value.
#
# **The filter needs time to settle.** The memory begins with zeros, and the joint stands at 0.9 rad:

# %% id="swings-in"
from_zero = Butterworth(1.0)
from_zero.memory = np.zeros((1, 2))
first = [from_zero.step(0.9) for _ in range(12)]
print("begun with zeros:      ", [round(value, 1) for value in first])
print("begun where the joint is:", round(Butterworth(1.0).step(0.9), 1))

# %% [markdown]
# For half a second the filter reports a movement that never happened. `sosfilt_zi(sos) * value` is the memory of a
# filter whose input has been `value` for a long time. The same fault comes back when a source restarts somewhere else:
# then what the filter remembers is wrong, and you have to begin anew.
#
# **An array for whole numbers.** The dtype of an array is fixed when it is made:

# %% id="int-array"
angles = np.zeros(3, dtype=int)
angles[:] = [0.9, 1.7, -0.4]
print(angles)

# %% [markdown]
# NumPy drops the fraction of each angle, without an error or a warning. `np.zeros(3)` makes an array of `float64`.
#
# **A message with a view cannot grow.** As long as a view looks at its memory, an `array.array` keeps its size:

# %% id="buffer-error" tags=["raises-exception"]
message = JointState(position=[0.1, 0.2, 0.3])
view = np.asarray(message.position)
message.position.append(0.4)

# %% [markdown]
# Assign a new list instead of using `append`, or make a copy with `np.array`.

# %% [markdown]
# ## From a worked example to your own
#
# **Worked.** All twelve joints at once: the memory is a list of arrays, and the mean is taken over time, `axis=0`.


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
print("stamps kept:", all(stamp in stamps for stamp, _ in scope.filtered[10:30]))

# %% [markdown]
# **Twelve joints and `sosfilt`.** One call filters all twelve over time, `axis=0`. The memory has one state for each
# joint.

# %% id="twelve-states"
at_rest = sosfilt_zi(sos)  # 1 section, 2 numbers
angles = np.linspace(-1.0, 1.0, 12)
memory = at_rest[:, :, np.newaxis] * angles  # 1 section, 2 numbers, 12 joints
filtered, memory = sosfilt(sos, angles[np.newaxis], axis=0, zi=memory)
print("memory of one joint:", at_rest.shape, "and of twelve:", memory.shape)
print("begun where the joints are:", np.allclose(filtered[0], angles))

# %% [markdown]
# **Faded.** Exponential smoothing remembers its last result. With each message, the result moves a fixed part of the way
# toward what is measured. The lines with `...` are yours. With `PART = 0.25`, it should be 3.0 messages behind and leave
# about 38 % of the noise.

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


if PART is ...:
    print("Fill in the part and the step, then run this cell again.")
else:
    print(f"{delay(Smoothing()):.1f} messages behind")
    print(f"{100 * noise_left(Smoothing()):.0f} % of the noise left")

# %% [markdown]
# **Your own.** In the [exercise](../exercises/14_arrays_and_filters.ipynb) you write the filter node for twelve joints,
# within bounds for noise and for delay. It survives NaN and a restart of the encoders.

# %% [markdown]
# ## Check yourself
#
# **1. A callback does `angles = np.asarray(message.position)` and then `angles *= 180 / np.pi`. What else changes?**
#
# <details><summary>a) Nothing, <code>angles</code> is a new array</summary>
#
# ✗ `np.asarray` makes a view. The message now holds degrees, for all code that uses this object.
#
# </details>
# <details><summary>b) The message itself</summary>
#
# ✓ View and message share their memory. `angles = np.asarray(...) * 180 / np.pi` makes a new array.
#
# </details>
# <details><summary>c) The messages that other programs receive</summary>
#
# ✗ Each subscription gets an object of its own, in other programs and in this one.
#
# </details>
#
# **2. At 50 Hz, a filter may be at most 0.1 s late. How many messages may a moving average span?**
#
# <details><summary>a) 5</summary>
#
# ✗ That is 0.1 s of messages, but their mean is only (5 − 1)/2 = 2 messages behind, 0.04 s.
#
# </details>
# <details><summary>b) 11</summary>
#
# ✓ (11 − 1)/2 = 5 messages, and 5 · 0.02 s = 0.1 s.
#
# </details>
# <details><summary>c) 50</summary>
#
# ✗ It would be 24.5 messages behind, nearly half a second.
#
# </details>
#
# **3. After one NaN, all results of your Butterworth filter are NaN. What helps?**
#
# <details><summary>a) <code>np.nan_to_num</code> after the filter</summary>
#
# ✗ The NaN sits in the memory of the filter. If you replace it only after the filter, you publish zeros forever.
#
# </details>
# <details><summary>b) A lower cutoff frequency</summary>
#
# ✗ NaN times anything is NaN, at every frequency.
#
# </details>
# <details><summary>c) To put the last good value in its place, before the filter</summary>
#
# ✓ Then NaN never reaches the memory.
#
# </details>
#
# **4. Why is `filtfilt` not late?**
#
# <details><summary>a) It uses values that come after the one that it computes</summary>
#
# ✓ So it belongs to recordings. In a callback these values have not come yet.
#
# </details>
# <details><summary>b) It is written in C</summary>
#
# ✗ The delay has nothing to do with the speed of computing.
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
# Copy the prompt for an AI assistant, or discuss it with a colleague. State your own view first.
#
# ```text
# I program a robot with ROS 2 Jazzy in Python (rclpy). My humanoid's hands tremble
# because the joint encoders are noisy, at 100 Hz. I want to filter the angles in a
# Python node before the balance controller gets them. Which filter would you take, how
# do I choose its parameters, and what can go wrong? Name only functions that exist in
# rclpy for Jazzy.
# ```
#
# <details><summary>What a good answer contains</summary>
#
# It asks how much delay the controller can stand, before it names a filter. It compares a moving average or exponential
# smoothing with a low-order Butterworth filter, by noise *and* delay. It keeps the memory of the filter in the node, and
# does not propose `filtfilt`. It begins with the first measurement, keeps NaN out, keeps stamps and names, and begins
# anew when the source restarts. And it asks whether the noise can be taken out at its source.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Two claims you may meet. Both are wrong: each was tried with the rclpy of this course.
#
# - **Call `filtfilt` in the callback:** It runs over the samples backward as well, so it needs those that have not
#   arrived. Its last value changes with the next message.
# - **`np.asarray(msg.position)` is a copy that you may write into:** It is a view: the message changes, too. `np.array`
#   copies.
#
# </details>

# %% [markdown]
# ## Take away
#
# - `np.asarray` looks at the memory of the message, `np.array` copies it; write only into copies.
# - For twelve values take what reads best; for a million, nothing that touches them one by one.
# - A filter in a callback needs a memory that outlives the callback, begun at the first measurement.
# - An average of N leaves 1/√N of the noise and is (N − 1)/2 messages late; Butterworth pays a similar price.
# - `filtfilt` avoids the delay by looking ahead, so it is for recordings only.
#
# **Before:** [13 · QoS and discovery](13_qos_and_discovery.ipynb)
#
# **Next:** [15 · A camera](15_camera.ipynb)
#
# **More:** [SciPy: signal processing](https://docs.scipy.org/doc/scipy/tutorial/signal.html) and
# [about interfaces](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Interfaces.html).

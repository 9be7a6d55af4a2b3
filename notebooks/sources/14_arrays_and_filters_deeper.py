# %% [markdown]
# # 14 · Deeper: views, copies, and cost
#
# A camera image holds almost a million numbers. How do they get from a message into an array without being copied, and
# what happens if you write to that array?
#
# - **Minutes:** 15
# - **You need:** lesson [14](14_arrays_and_filters.ipynb)
# - **You will be able to:**
#   - predict whether writing to an array changes the message
#   - choose a conversion based on its cost
# - **Not covered:** how C++ nodes share memory

# %% [markdown]
# This notebook is optional: later lessons don't depend on it.

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
# - **a** `0.1`, because the array is a copy.
#   when `first < 1.0`
#   ✗ `np.array` would copy the values. `np.asarray` uses the message's memory if possible.
# - **b** Nothing, because NumPy raises an error: messages are read-only.
#   ✗ Message fields are writable, both by name and through an array that shares their memory.
# - **c** `9.0`, because the array and the message share memory.
#   when `first > 1.0`
#   ✓ The array is a view of the message's memory, so a value written to either one appears in the other.

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
# `np.asarray` created a **view**: an array that uses the message's memory instead of its own. `np.array` created a
# **copy**. A view costs almost nothing, but writing to a view changes the message.
#
# So use `np.asarray` if you only read, and `np.array` if you also write. Which other code does such a write affect? In
# this example, a node subscribes twice to the same topic. The first callback writes through a view:

# %% id="own-object"
from rclpy.node import Node
from lesson_nodes import noisy_joints
from workbook.lesson import fresh, init, run, start, stop

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
for name, messages in two.got.items():
    changed = sum(message.position[0] == 9.0 for message in messages[:5])
    print(f"{name}: the first angle is 9.0 in {changed} of 5 messages")

# %% [markdown]
# For each message, rclpy creates a separate Python object **per subscription**. So your change doesn't affect other
# callbacks or nodes. The change appears only where *this* object goes: to a list that stores it, a method that receives
# it, or a publisher that sends it.
#
# In a **variable-length** field, rclpy stores numbers in an `array.array` from Python's standard library. Such an array
# keeps its numbers next to each other in memory, without a Python object for each. That's why a view works. A
# **fixed-length** field is already a NumPy array. The field's type determines the **dtype**, the type of the array's
# numbers.

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
# `Float32MultiArray` and `LaserScan` hold 32-bit numbers, so 0.1 comes back rounded. A laser scanner reports `inf` in
# directions where it detects nothing.
#
# How do you put an array back into a message? A fixed-length field accepts a NumPy array. A variable-length field
# accepts one in the constructor: `JointState(position=angles)`. But the assignment `message.position = angles` raises
# an error if **field checks** are on, as in these notebooks. In a node that you start with `ros2 run`, they're off. Two
# conversions always work: `.tolist()`, and an `array.array` created from the array's bytes.

# %% id="and-back"
import array

angles = np.array([0.1, 0.2, 0.3])
message.position = angles.tolist()
print("by a list: ", message.position)
message.position = array.array("d", angles.tobytes())
print("by bytes:  ", message.position)
print("constructor:", JointState(position=angles).position)

# %% [markdown]
# What does each conversion cost? We time each one for twelve angles, a laser scan of 10,000 values, and a million
# values, roughly the size of a camera image. In the output, "in" means into a message, and "out" means out of one. "One
# by one" creates a Python object for each number, but "in one piece" doesn't. Field checks are off here, as they are
# with `ros2 run`. With field checks on, "in, one by one" takes several times as long.

# %% tags=["nbval-ignore-output"]
from timeit import repeat


def cost_us(work, times):
    """The shortest of five measurements (µs)."""
    return 1e6 * min(repeat(work, number=times, repeat=5)) / times


def costs(size):
    """What each way costs (µs), for an array of so many values."""
    values = np.linspace(0.0, 1.0, size, dtype=np.float32)
    message = Float32MultiArray(check_fields=False)

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
from workbook.lesson import about

few, many = cost[12], cost[1_000_000]
print("a million values, one by one instead of in one piece:")
for way, usual in (("in", (15, 5_000)), ("out", (5_000, 2e7))):
    ratio = many[f"{way}, one by one"] / many[f"{way}, in one piece"]
    print(f"   {way}:", about(ratio, "times the cost", between=usual))
ratio = many["out, in one piece"] / few["out, in one piece"]
print("a view of a million values instead of 12:")
print("   out:", about(ratio, "times the cost", between=(0.1, 50)))

# %%
from workbook.pictures.figures import figure, show
from workbook.pictures.palette import AMBER, BLUE

LOOKS = {"one by one": AMBER, "in one piece": BLUE}
sizes = list(cost)
fig, axes = figure(6.8, 3.0)
for way in cost[12]:
    direction, how = way.split(", ", 1)
    line = "-" if direction == "out" else "--"
    spent = [cost[size][way] for size in sizes]
    axes.loglog(sizes, spent, line, marker="o", color=LOOKS[how])
    axes.annotate(way, (1.2 * sizes[-1], spent[-1]), color=LOOKS[how], va="center")
    if how == "one by one":  # both lines end in the same place
        axes.texts[-1].set_y((2.4 if direction == "in" else 0.6) * spent[-1])
axes.set(xlabel="values", ylabel="cost (µs)", xlim=(8, 4e7), ylim=(0.1, 2e6))
axes.set_title("Only the view costs the same for any number of values")
show(
    fig,
    "cost against the number of values: a view stays at a microsecond, bytes rise "
    "slowly, and both ways that handle single values rise steeply",
)

# %% [markdown]
# For twelve joints, write the most readable code: `.tolist()`. For images and scans, don't loop over individual
# numbers.
#
# **Your turn.** This scan has 10,000 distances. Write an expression that counts the distances below 1 m, without a
# loop.

# %% id="your-near"
from workbook.lesson import yours

scan = LaserScan(ranges=np.linspace(0.5, 10.0, 10_000))

near = ...  # TODO: a number, from np.asarray(scan.ranges)

yours(near, 527, "np.count_nonzero(np.asarray(scan.ranges) < 1.0)")

# %% [markdown]
# ### Two faults with arrays
#
# **An integer array.** An array's dtype is fixed when you create the array:

# %% id="int-array"
angles = np.zeros(3, dtype=int)
angles[:] = [0.9, 1.7, -0.4]
print(angles)

# %% [markdown]
# NumPy truncates each angle to a whole number, without an error or a warning. Use `np.zeros(3)`, which creates a
# `float64` array.
#
# **Appending to a field while a view of it exists.** An `array.array` can't change its size while a view is using its
# memory:

# %% id="buffer-error" tags=["raises-exception"]
message = JointState(position=[0.1, 0.2, 0.3])
view = np.asarray(message.position)
message.position.append(0.4)

# %% [markdown]
# Assign a new list instead of using `append`. Or use `np.array` to make a copy instead of a view.

# %% [markdown]
# ## Take away
#
# - `np.asarray` uses the message's memory, and `np.array` copies it. Write only to copies.
# - Each subscription gets a separate message object, so your changes don't affect other callbacks.
# - A variable-length field accepts an array in the constructor. But the assignment `message.position = angles` fails
#   while field checks are on, so use `.tolist()` or an `array.array`.
# - For twelve values, use the most readable conversion. Don't handle a million values one by one.
#
# **Before:** [14 · Arrays and filters](14_arrays_and_filters.ipynb)
#
# **Next:** [15 · A camera](15_camera.ipynb)
#
# **More:** [NumPy: copies and views](https://numpy.org/doc/stable/user/basics.copies.html) and
# [about interfaces](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Interfaces.html).

# %% [markdown]
# # 03 · Deeper: queues, pictures and messages with meaning
#
# A camera robot publishes pictures in bursts. Its publisher has a queue, and most programs copy the depth of that queue
# from an example. What does this number do?
#
# - **Minutes:** 15
# - **You need:** lesson [03](03_publishers_and_messages.ipynb)
# - **You will be able to:**
#   - say what the depth of a publisher's queue does
#   - read and fill a picture
#   - choose message types that other people understand
# - **Left out:** the subscription's queue (lesson 04), other settings of quality of service (lesson 13)

# %% [markdown]
# Everything here is optional. Later lessons do not depend on it.

# %% [markdown] prediction="a-burst-of-pictures"
# ## Predict
#
# The last argument of `create_publisher` is the **depth** of the publisher's queue: how many messages it keeps, in case it
# has to send them again. A camera in *another process* publishes 20 pictures of 640 × 480 pixels (0.9 MB each) as fast as it can. It asks for
# reliable delivery, which is the default. Its publisher has depth 1. The subscription has depth 100, so it has room for
# all. How many pictures arrive?
#
# - **a** All 20: reliable delivery sends again what gets lost.
#   when `arrived == 20`
#   ✗ It sends again only what the publisher still has. With depth 1, each new picture takes the place of the one before.
# - **b** 10, the default depth.
#   ✗ There is no default depth in rclpy. The number in the program counts, and here it is 1.
# - **c** Only some of them.
#   when `arrived < 20`
#   ✓ The program publishes faster than the pictures travel. With depth 1 a picture that is not delivered yet is gone
#   when the next one comes.

# %%
from workbook.lesson import predict, reveal

predict("a-burst-of-pictures")

# %% [markdown]
# ## Run it
#
# The camera is [lesson_nodes/burst_camera.py](../lesson_nodes/burst_camera.py). It starts its burst half a second after it
# has found a subscription. We try three depths, three bursts each, and then tiny pictures of 1 kB.

# %% tags=["nbval-ignore-output"]
import numpy as np
from lesson_nodes import burst_camera
from rclpy.node import Node
from sensor_msgs.msg import Image
from workbook.lesson import fresh, init, spin_for, start, stop

init()


class Ear(Node):
    """Keeps the numbers of the pictures that arrive."""

    def __init__(self):
        super().__init__("ear")
        self.numbers = []
        self.create_subscription(
            Image, "/camera/burst", lambda image: self.numbers.append(image.width), 100
        )


def arrived(depth, size_bytes):
    """How many of 20 pictures arrive."""
    ear = fresh(Ear)
    start(burst_camera, depth=depth, size_bytes=size_bytes)
    spin_for(ear, seconds=10, until=lambda: 20 in ear.numbers)  # they end with 20
    spin_for(ear, seconds=1)
    stop()
    ear.destroy_node()
    return len(ear.numbers)


counts = {
    (depth, size): [arrived(depth, size) for _ in range(3)]
    for depth, size in ((1, 921_600), (10, 921_600), (100, 921_600), (1, 1_000))
}
for (depth, size), bursts in counts.items():
    print(f"depth {depth:>3}, {size / 1000:>3.0f} kB: {bursts} of 20")
reveal("a-burst-of-pictures", arrived=min(counts[1, 921_600]))

# %%
print("depth   1, 0.9 MB: some pictures are lost: ", min(counts[1, 921_600]) < 20)
print(
    "depth 100, 0.9 MB: all arrive:             ", counts[100, 921_600] == [20, 20, 20]
)
print("depth   1,   1 kB: all arrive:             ", counts[1, 1_000] == [20, 20, 20])

# %% [markdown]
# Only the *publisher's* depth changed. `publish` returns before a large picture is delivered. What does not fit into the
# publisher's queue any more cannot be sent again, and no error is raised on either side.
#
# | what you publish | depth of the publisher |
# |---|---|
# | a state, such as a pose or a camera picture, of which only the newest counts | 1 to 10 |
# | a burst in which each message counts, such as the parts of a map | at least the length of the burst |
#
# In one process, or with small messages, the publisher's depth hardly matters: they are delivered before the next one
# comes. That is why tests on a desk look fine. These notebooks use only the loopback network, while Fast DDS by
# default also uses shared memory. We measured both, with pictures of 300 kB and of 900 kB, three bursts each. Every
# time, pictures were lost at depths 1 and 10, and none at 100.

# %% [markdown]
# ## Look inside

# %% [markdown]
# ### A message that is a picture
#
# An `Image` has a header, some numbers that say how to read the picture, and then all its pixels in one long array. This
# camera has 16 times 12 pixels.

# %%
from lesson_nodes import tiny_camera
from workbook.lesson import record
from workbook.pictures.figures import figure, show

CAMERA = "/robot/camera"
film = [
    arrival.value
    for arrival in record(tiny_camera, {CAMERA: 0.5}, seconds=4).topic(CAMERA).arrivals
]

image = film[0]
print("fields:", ", ".join(image))
print(f"{image['width']} times {image['height']} pixels, encoding {image['encoding']}")
print(
    "numbers in data:",
    len(image["data"]),
    "which is 16 · 12 · 3:",
    len(image["data"]) == 16 * 12 * 3,
)
print("the first pixel, red, green and blue:", image["data"][:3])

# %%
fig, frames = figure(6.4, 1.9, columns=3)
for axes, number in zip(frames, (1, 3, 5), strict=True):
    image = film[number]
    pixels = np.array(image["data"], dtype=np.uint8).reshape(
        image["height"], image["width"], 3
    )
    axes.imshow(pixels, interpolation="nearest")
    axes.set(title=f"message {number + 1}", xticks=[], yticks=[])
    axes.grid(False)
show(
    fig,
    "three pictures of the tiny camera: a red ball rolls over the floor, from left "
    "to right",
)

# %% [markdown]
# 576 numbers in a row, and `width`, `height` and `encoding` say what they mean. If one of these is wrong, no other program
# can read the picture.

# %% [markdown]
# ### Messages with meaning
#
# `Float32` says nothing about unit, time or owner. `sensor_msgs` has types that do. They are filled like every other
# message, field by field:

# %% id="with-meaning"
import math

from sensor_msgs.msg import BatteryState, JointState
from std_msgs.msg import Float32

state = BatteryState()
state.header.frame_id = "back_battery"
state.percentage = 0.8  # a share, from 0 to 1: the definition says so
state.voltage = 47.9
state.power_supply_status = BatteryState.POWER_SUPPLY_STATUS_DISCHARGING
state.present = True
state.header.stamp = fresh(Node, "reporter").get_clock().now().to_msg()
for field in ("current", "temperature", "charge", "capacity", "design_capacity"):
    setattr(state, field, math.nan)  # not measured: the definition says how to say so

joints = JointState()
joints.name = ["left_shoulder", "left_elbow"]
joints.position = [0.3, -1.1]  # rad

print("Float32 has:     ", ", ".join(Float32.get_fields_and_field_types()))
print(
    "BatteryState has:",
    ", ".join(list(BatteryState.get_fields_and_field_types())[:8]),
    "and more",
)
print("JointState has:  ", ", ".join(JointState.get_fields_and_field_types()))

# %% [markdown]
# A time stamp, names, and units that are written down. For "not known", set `nan` *yourself*: these fields, too,
# begin with 0.0. Dashboards and loggers of other people understand such a message without asking you.

# %% [markdown]
# ### Where 0.0 comes from
#
# In lesson 03 an `int` in a float field arrived as 0.0. This build reads eight bytes of the object, at the place where a
# Python float keeps its value. You can read the same bytes.

# %%
import ctypes


def eight_bytes_of(thing):
    """The number that stands where a Python float keeps its value."""
    return ctypes.c_double.from_address(id(thing) + object.__basicsize__).value


print("in 80.0:", eight_bytes_of(80.0))
print(
    "in 80, something above zero and below 1e-300:", 0.0 < eight_bytes_of(80) < 1e-300
)
print("which in 32 bits is", ctypes.c_float(eight_bytes_of(80)).value)

# %% [markdown]
# `np.float64` is a kind of Python float, so it has its bytes in the same place. `np.float32` is not.

# %%
print("np.float64 is a float:", isinstance(np.float64(80), float))
print("np.float32 is a float:", isinstance(np.float32(80), float))

# %% [markdown]
# ## Take away
#
# - The publisher's depth counts in a burst of large messages: what is pushed out of its queue cannot be sent again.
# - A picture is one long array. `width`, `height` and `encoding` say how to read it.
# - For real interfaces use types with meaning, such as `BatteryState` and `JointState`, and say `nan` for "not known".
#
# **Before:** [03 · Publishers and messages](03_publishers_and_messages.ipynb)
#
# **Next:** [04 · Subscriptions and callbacks](04_subscriptions_and_callbacks.ipynb)
#
# **More:** [Interfaces](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Interfaces.html), and
# [quality of service](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Quality-of-Service-Settings.html).

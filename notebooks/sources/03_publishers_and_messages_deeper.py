# %% [markdown]
# # 03 · Deeper: queues, images, and richer message types
#
# A robot's camera publishes images in bursts. Its publisher has a queue, and most programmers copy that queue's depth
# from an example. What effect does the depth have?
#
# - **Minutes:** 20
# - **You need:** lesson [03](03_publishers_and_messages.ipynb)
# - **You will be able to:**
#   - explain the effect of a publisher's queue depth
#   - find a pixel in an `Image` message
#   - choose message types that other people understand
# - **Not covered:** the subscription's queue (lesson 04), other quality-of-service settings (lesson 13)

# %% [markdown]
# This whole notebook is optional: later lessons don't depend on it.

# %% [markdown] prediction="a-burst-of-pictures"
# ## Predict
#
# The last argument of `create_publisher` is the **depth** of the publisher's queue. It's the number of messages that
# the publisher keeps in case it has to send them again. A camera in *another process* publishes 20 images of 640 × 480
# pixels (0.9 MB each) as fast as it can. It offers reliable delivery, which is the default. Its publisher has a queue
# depth of 1. The subscription has a queue depth of 100, so all 20 images fit into its queue. How many images arrive?
#
# - **a** All 20: reliable delivery sends lost images again.
#   when `arrived == 20`
#   ✗ The publisher can send an image again only while it still keeps that image. With depth 1, each new image replaces
#   the previous one.
# - **b** 10, the default depth.
#   ✗ rclpy has no default depth. The program must choose one, and this program chose 1.
# - **c** Only some of them.
#   when `arrived < 20`
#   ✓ The program publishes faster than the images travel. With depth 1, each new image replaces the previous one, even
#   if that one hasn't been delivered yet.

# %%
from workbook.lesson import predict, reveal

predict("a-burst-of-pictures")

# %% [markdown]
# ## Run it
#
# The camera is [lesson_nodes/burst_camera.py](../lesson_nodes/burst_camera.py). Every half second, it checks for a
# subscription, and once it finds one, it starts its burst. We try three depths, and then depth 1 again with tiny images
# of 1 kB. For each setting, we run three bursts and print how many images arrived in the worst one.
#
# [the same without helpers: init, fresh, start, spin_for, record]

# %% id="bursts"
import numpy as np
from lesson_nodes import burst_camera
from rclpy.node import Node
from sensor_msgs.msg import Image
from workbook.lesson import about, fresh, init, spin_for, start, stop

init()


class Ear(Node):
    """Keeps the numbers of the images that arrive."""

    def __init__(self):
        super().__init__("ear")
        self.numbers = []
        self.create_subscription(
            Image, "/camera/burst", lambda image: self.numbers.append(image.width), 100
        )


def arrived(depth, size_bytes):
    """How many of 20 images arrive."""
    ear = fresh(Ear)
    start(burst_camera, depth=depth, size_bytes=size_bytes)
    spin_for(ear, seconds=10, until=lambda: 20 in ear.numbers)  # they end with 20
    spin_for(ear, seconds=1)
    stop()
    ear.destroy_node()
    return len(ear.numbers)


fewest = {
    (depth, size): min(arrived(depth, size) for _ in range(3))
    for depth, size in ((1, 921_600), (10, 921_600), (100, 921_600), (1, 1_000))
}
one, ten, hundred, tiny = fewest.values()
print("depth 1, 900 kB:", about(one, between=(0, 19)), "of 20")
print("depth 10, 900 kB:", about(ten, between=(0, 20)), "of 20")
print("depth 100, 900 kB:", hundred, "of 20")
print("depth 1, 1 kB:", tiny, "of 20")
reveal("a-burst-of-pictures", arrived=one)

# %% [markdown]
# Only the *publisher's* depth changed between the runs with large images. `publish` returns before a large image has
# been delivered. Once newer images have pushed that image out of the publisher's queue, it can't be sent again, and
# neither side raises an error.
#
# | kind of message | publisher's queue depth |
# |---|---|
# | states, such as poses or camera images: only the newest message is useful | 1 to 10 |
# | bursts, such as the parts of a map: every message counts | at least the number of messages in the burst |
#
# With small messages, the publisher's depth hardly matters, because each message is usually on its way before the next
# one is published. That's why you don't notice the problem in tests with small messages.
#
# These notebooks use only the loopback network interface. By default, however, Fast DDS, the DDS implementation in this
# build, also uses shared memory. We measured both transports, each with three bursts of 300 kB images and three bursts
# of 900 kB images. In every measurement, images were lost at depths 1 and 10, but none were lost at depth 100.

# %% [markdown]
# ## Look inside

# %% [markdown]
# ### Image messages
#
# An `Image` message has a header, a few fields that describe the layout of the pixels, and one long array of pixel
# data. The next cell records the messages of a tiny camera. Its images are only 16 pixels wide and 12 pixels high.

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
print(f"numbers in data: {len(image['data'])} (16 · 12 · 3 = {16 * 12 * 3})")
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
fig.suptitle("Each message moves the ball to the right")
show(
    fig,
    "three images of the tiny camera: a red ball rolls over the floor, from left "
    "to right",
)

# %% [markdown]
# The data is just a sequence of 576 numbers, and `width`, `height`, and `encoding` define their meaning. If one of
# these fields is wrong, other programs can't interpret the image correctly.
#
# **Your turn.** The rows follow one another, starting at the top. Each pixel takes up three numbers. Where in `data`
# does the pixel at row 5, column 3 begin? Rows and columns are counted from 0.

# %% id="your-pixel"
from workbook.lesson import yours

begin = ...  # TODO: compute it from image["width"]

yours(begin, 249, "(5 * image['width'] + 3) * 3")

# %% [markdown]
# ### Richer message types
#
# A `Float32` message doesn't specify a unit, a time, or a source. `sensor_msgs` has types that do. You fill in messages
# of these types field by field, as usual:

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
# These messages have timestamps and names, and their definitions specify the units. As in `Float32`, the numeric fields
# of these types are 0.0 until you set them, so set unknown values to `nan` *yourself*. Other people's dashboards and
# loggers can then interpret your messages.

# %% [markdown]
# ### Where 0.0 comes from
#
# In lesson 03, an `int` in a float field arrived as 0.0. That's because this course's build of ROS 2 doesn't convert
# the `int`. It just reads eight bytes of the object, at the position where a Python float stores its value. The next
# cell reads those eight bytes.

# %%
import ctypes


def eight_bytes_of(thing):
    """The number that stands where a Python float keeps its value."""
    return ctypes.c_double.from_address(id(thing) + object.__basicsize__).value


print("in 80.0:", eight_bytes_of(80.0))
zeros = -math.log10(eight_bytes_of(80))
zeros = about(zeros, "zeros", between=(320, 325), digits=3)
print("in 80: a fraction with", zeros, "after the point")
print("which in 32 bits is", ctypes.c_float(eight_bytes_of(80)).value)

# %% [markdown]
# `np.float64` is a subclass of Python's `float`, so it stores its value at the same position. `np.float32` isn't, as
# the two types' base classes show:

# %%
for number in (np.float64(80), np.float32(80)):
    print(*[base.__name__ for base in type(number).__mro__], sep=" < ")

# %% [markdown]
# ### Lines from other programs
#
# A lot of the code on the web is for ROS 1, for C++, or for a full ROS 2 installation. And in your own code, you may
# misspell a name. Each of the following lines looks right, but with this course's installation, it raises an exception.
# The last line shows what happens if an `async` callback awaits `asyncio.sleep`. It fails because rclpy runs the
# coroutine itself, rather than in an asyncio event loop. We run the lines in a separate thread, because this notebook's
# main thread runs asyncio.

# %% id="lines-of-others"
import asyncio
from concurrent.futures import ThreadPoolExecutor
from importlib import import_module

import rclpy
from rclpy.qos import QoSProfile
from std_msgs.msg import String

learner = fresh(Node, "learner")
LINES = {
    "queue_size=10": lambda: learner.create_publisher(String, "/word", queue_size=10),
    "a word for the QoS": lambda: learner.create_publisher(String, "/word", "reliable"),
    "a word for a policy": lambda: QoSProfile(depth=1, durability="volatile"),
    "a number to log": lambda: learner.get_logger().info(80.0),
    "a misspelled name": lambda: learner.create_publsher(String, "/word", 10),
    "rclpy.Rate": lambda: rclpy.Rate(10),
    "rclpy.Node": lambda: rclpy.Node("listener"),
    "cv_bridge": lambda: import_module("cv_bridge"),
    "asyncio.sleep": lambda: asyncio.sleep(0.1).send(None),
}
with ThreadPoolExecutor(1) as thread:
    for line, attempt in LINES.items():
        error = thread.submit(attempt).exception()
        print(f"{line}: {type(error).__name__}: {error}".splitlines()[0])

# %% [markdown]
# Only some of these error messages tell you what to write instead. The third one is empty: rclpy asserts that the
# policy is a member of the right enum, but the `assert` statement has no message. The [error museum](error_museum.md),
# this course's collection of common errors, has a fix for each error.

# %% [markdown]
# ## Take away
#
# - The publisher's depth matters in a burst of large messages: an image that has been pushed out of the queue can't
#   be sent again.
# - An image's pixels are one long array. `width`, `height`, and `encoding` define how to read it.
# - Before you copy a line, find out which ROS version and language it was written for. ROS 1 and C++ use different
#   names and keywords.
# - For real interfaces, use types with self-explanatory fields, such as `BatteryState` and `JointState`. Use `nan` for
#   unknown values.
#
# **Before:** [03 · Publishers and messages](03_publishers_and_messages.ipynb)
#
# **Next:** [04 · Subscriptions and callbacks](04_subscriptions_and_callbacks.ipynb)
#
# **More:** [Interfaces](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Interfaces.html) and [quality of
# service](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Quality-of-Service-Settings.html)

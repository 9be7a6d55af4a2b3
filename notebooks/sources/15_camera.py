# %% [markdown]
# # 15 · A camera
#
# A camera sends a million numbers, thirty times a second. A robot that wants to look at a ball needs two numbers:
# how far to the left or right, and how far up or down.
#
# - **Minutes:** 40
# - **You need:** lessons [13](13_qos_and_discovery.ipynb) and [14](14_arrays_and_filters.ipynb)
# - **You will be able to:**
#   - find a ball in an `Image` with OpenCV
#   - turn its pixel into a direction
#   - let the head follow
# - **Left out:** lenses and calibration, two cameras and depth, neural networks (lesson 16)

# %% [markdown]
# How does a robot get from pixels to a direction? Here is what ours sees. The joint angles of lesson 09 tell where
# its hands are. A ball rolls over the desk, two bricks lie on it, and clouds pass by the window.

# %%
from lesson_nodes import head_camera
from lesson_nodes.ball_scope import BallScope
from workbook.lesson import fresh, init, run, start, stop
from workbook.lesson.films import alone, beside, show_film

init()
print("started", start(head_camera, width=320))
scope = fresh(BallScope)
await run(scope, seconds=60, until=lambda: len(scope.film) >= 36)
stop()
shots = [alone(picture) for picture in scope.film]
show_film(
    shots,
    "an orange ball rolls to and fro between gray hands and bricks, "
    "while the light changes",
    6,
)

# %% [markdown]
# Each picture is a message of type `sensor_msgs/Image`. Here are its fields. This camera adds 32 bytes to each row,
# as some real ones do.

# %% id="fields"
images = []


def keep(image):
    images.append(image)


from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import CompressedImage, Image

start(head_camera, padding=32)
watcher = fresh(Node, "watcher")
watcher.create_subscription(Image, "/camera/image", keep, qos_profile_sensor_data)
await run(watcher, seconds=30, until=lambda: len(images) >= 20)
stop()
image = images[-1]
print(f"{image.width} columns, {image.height} rows, encoding {image.encoding}")
print(
    f"step: {image.step} bytes in a row; 3 * width = {3 * image.width}; "
    f"big-endian: {image.is_bigendian}"
)
print(f"data: {len(image.data)} bytes")

# %% [markdown]
# | field | what it says |
# |---|---|
# | `encoding` | what a pixel is made of: `rgb8` is red, green, blue, a byte each; `bgr8` is the same backward; `mono8` is gray |
# | `step` | how many bytes a row takes, padding included |
# | `is_bigendian` | which byte of a larger number comes first; only for pixels of 16 bits and more, such as `mono16` |
# | `header.stamp` | when the picture was taken |
#
# `data` is an `array.array` of bytes, so an array of NumPy can be a view of it, as in lesson 14. First make one row
# of bytes for each row of the picture, then cut off the padding, then group three bytes into a pixel.

# %% id="to-pixels"
import numpy as np


def to_pixels(image):
    """A view of an rgb8 or bgr8 image, shape (height, width, 3): nothing is copied."""
    rows = np.frombuffer(image.data, np.uint8).reshape(image.height, image.step)
    return rows[:, : 3 * image.width].reshape(image.height, image.width, 3)


pixels = to_pixels(image)
shared = np.shares_memory(pixels, np.frombuffer(image.data, np.uint8))
print(pixels.shape, pixels.dtype, "shares its memory:", shared)

# %% [markdown] prediction="read-as-bgr8"
# ## Predict
#
# The ball is orange: much red, some green, little blue. The picture is `rgb8`. A program takes it for `bgr8`, as
# functions of OpenCV do by default. What does it see?
#
# - **a** A green ball.
#   when `green > red and green > blue`
#   ✗ Green stands in the middle in both orders, so it stays what it is.
# - **b** A blue ball.
#   when `blue > red and blue > green`
#   ✓ The first byte is taken for blue, and the first byte is the strong red.
# - **c** An error: the encoding does not fit.
#   ✗ Bytes have no color. Nobody checks the field `encoding` for you.

# %%
from workbook.lesson import predict, reveal

predict("read-as-bgr8")

# %% [markdown]
# ## Run it

# %%
import cv2

hsv = cv2.cvtColor(pixels, cv2.COLOR_RGB2HSV)
ball_mask = cv2.inRange(hsv, (4, 150, 60), (22, 255, 255)) > 0
first, second, third = map(float, pixels[ball_mask].mean(axis=0))
reveal("read-as-bgr8", red=third, green=second, blue=first)

# %% id="bgr-for-rgb"
print("read as rgb8: more red than blue:", first > third)
print("read as bgr8: more blue than red:", third < first)

# %% [markdown]
# ## Look inside
#
# So look at `encoding` in every callback, and choose the conversion by it. OpenCV works on NumPy arrays. For colors, the
# best space is **HSV**. *Hue* is the color on a circle, in OpenCV from 0 to 180. *Saturation* is how strong it is, and
# *value* how bright. When a cloud passes, value changes, and hue hardly does.
#
# Convert to HSV. A **threshold** keeps what is orange. Draw **contours** around what is left, and take the one that is
# round: it fills three quarters of the smallest circle around it. Its center is the mean of many pixels, so it is known
# to a fraction of a pixel.


# %%
def orange_of(pixels):
    """A mask: 255 where a pixel is orange."""
    hsv = cv2.cvtColor(pixels, cv2.COLOR_RGB2HSV)
    # From and to: hue, saturation, value.
    mask = cv2.inRange(hsv, (4, 130, 35), (22, 255, 255))
    return cv2.medianBlur(mask, 3)  # without isolated pixels


def find_ball(pixels):
    """Column and row of the middle of the ball; None if there is none."""
    mask = orange_of(pixels)
    outlines, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    for outline in sorted(outlines, key=cv2.contourArea, reverse=True):
        _, radius = cv2.minEnclosingCircle(outline)
        if radius > 3 and cv2.contourArea(outline) > 0.75 * np.pi * radius**2:
            # m00 is the area, m10 and m01 are sums of columns and rows over it.
            sums = cv2.moments(outline)
            return sums["m10"] / sums["m00"], sums["m01"] / sums["m00"]
    return None


# %% [markdown]
# Is it true that hue hardly changes? Here are the orange things in the darkest and in the brightest picture of the film.

# %% id="hue-stays"
by_light = sorted(scope.film, key=np.mean)
dark, bright = (
    np.median(cv2.cvtColor(one, cv2.COLOR_RGB2HSV)[orange_of(one) > 0], axis=0)
    for one in (by_light[0], by_light[-1])
)
print("value: darker by a fifth or more:", dark[2] <= 0.8 * bright[2])
print("hue: differs by 2 of 180 or less:", abs(dark[0] - bright[0]) <= 2)

# %%
from workbook.pictures.figures import figure, show

column, row = find_ball(pixels)
small = cv2.resize(pixels, (160, 120), interpolation=cv2.INTER_AREA)
fig, axes = figure(8.0, 2.4, columns=3)
titles = ("what the camera sees", "what is orange", "orange and round: the ball")
for axis, drawn, title in zip(
    axes, (small, orange_of(small), small), titles, strict=True
):
    axis.imshow(drawn, cmap="gray", interpolation="nearest")
    axis.set_title(title)
    axis.set(xticks=[], yticks=[])
    axis.grid(False)
axes[2].plot(column / 4, row / 4, "+", color="white", markersize=18, markeredgewidth=2)
show(
    fig,
    "three pictures: the desk; white spots on black where ball and bricks are; "
    "a cross in the middle of the ball",
)

# %% [markdown]
# **From pixel to direction.** In the **pinhole model**, all light goes through one point. The *focal length* is the
# distance from that point to the picture, in pixels: 560 for this camera. A pixel that is `x` pixels to the right of the
# middle and `y` pixels below it looks in the direction (`x`, `y`, 560). Divided by its length, this is a vector of
# length 1.
#
# ROS fixes the axes of a camera ([REP 103](https://www.ros.org/reps/rep-0103.html), *optical* frames): x to the right,
# y down, z forward.

# %% id="pinhole"
import math

FOCAL, MIDDLE = 560.0, (319.5, 239.5)


def direction(column, row):
    """Where a pixel looks: x to the right, y down, z forward, length 1."""
    x, y = (column - MIDDLE[0]) / FOCAL, (row - MIDDLE[1]) / FOCAL
    length = math.sqrt(x * x + y * y + 1.0)
    return x / length, y / length, 1.0 / length


print("the middle:", direction(*MIDDLE))
for column in (0, 639):
    x, _, z = direction(column, 239.5)
    angle = math.degrees(math.atan2(x, z))
    side = "left" if angle < 0 else "right"
    print(f"column {column}: {abs(angle):.1f}° to the {side}")

# %% [markdown]
# ### The head follows
#
# Now close the loop. For each picture, the node finds the ball and turns the neck a part of the way. The camera hears
# the new angle and turns. The next picture shows how much is still missing. Watch: the ball rolls, and stays near the
# middle. The drawing is flat, so the robot on the right tilts its head instead of turning it.

# %%
from std_msgs.msg import Float32MultiArray

from lesson_nodes.head_camera import AT_REST

PART = 0.25  # of the way that is missing, for each picture


class HeadFollower(Node):
    """Turns the neck so that the ball is in the middle."""

    def __init__(self, qos) -> None:
        super().__init__("head_follower")
        self.joints, self.off, self.film = list(AT_REST), [], []
        self.publisher = self.create_publisher(
            Float32MultiArray, "/robot/joint_positions", 10
        )
        self.create_subscription(Image, "/camera/image", self.on_image, qos)

    def on_image(self, image: Image) -> None:
        pixels = to_pixels(image)
        ball = find_ball(pixels)
        if ball is None:
            return
        if len(self.off) % 5 == 0:  # for the film below
            self.film.append((cv2.resize(pixels, (320, 240)), [*self.joints]))
        x, _, z = direction(*ball)
        self.off.append(abs(ball[0] - MIDDLE[0]))  # pixels from the middle
        # The neck turns to the left; x points to the right.
        neck = self.joints[0] - PART * math.atan2(x, z)
        self.joints[0] = min(max(neck, -0.6), 0.6)
        self.publisher.publish(Float32MultiArray(data=self.joints))


# %% [markdown]
# First with a queue depth of 1, and nothing else. How many pictures arrive?

# %% id="reliable-hears-nothing"
start(head_camera)
deaf = fresh(HeadFollower, 1)
await run(deaf, seconds=3)
stop()
print("pictures of the follower:", len(deaf.off))

# %% [markdown]
# None, and rclpy logs a warning. The camera publishes with **sensor-data QoS**, which is best effort: a lost picture is
# not sent again, because the next one is better anyway. A depth of `1` alone asks for *reliable*, and as in lesson 13
# that does not match.

# %%
start(head_camera)
follower = fresh(HeadFollower, qos_profile_sensor_data)
await run(follower, seconds=90, until=lambda: len(follower.film) >= 40)
stop()
shots = []
for small, joints in follower.film:
    cv2.line(small, (160, 0), (160, 239), (255, 255, 255), 1)
    shots.append(beside(small, joints))
show_film(
    shots,
    "left: the desk moves past, and the ball stays near the white line; "
    "right: the robot's head tilts",
    6,
)

# %% id="follows"
settled = follower.off[len(follower.off) // 3 :]
print("pictures with a ball: more than 20:", len(follower.off) > 20)
near = np.median(settled) < 80
print("later, the ball is typically less than 80 pixels beside the middle:", near)

# %% [markdown] prediction="how-much-smaller"
# ## Change it
#
# ### Experiment 1: raw or compressed
#
# A raw picture of 640 by 480 pixels has 921,600 bytes; thirty of them a second are 28 MB. `CompressedImage` carries
# JPEG. With quality 80, how many times smaller is it?
#
# - **a** More than 8 times.
#   when `smaller > 8`
#   ✓ JPEG drops what eyes hardly see. It pays with the time to encode and decode, and with small errors in each color.
# - **b** 2 to 8 times.
#   when `smaller <= 8 and smaller >= 2`
#   ✗ JPEG makes it far smaller than that. Lossless compression, such as PNG, has to keep the noise, too.
# - **c** It stays about the same, because of the noise.
#   when `smaller < 2`
#   ✗ JPEG does not keep the noise as it is. That is why it gets so small.

# %%
predict("how-much-smaller")

# %%
import time

sizes, ages = {"raw": [], "jpeg": []}, {"raw": [], "jpeg": []}


def age_of(message):
    """How long ago a picture was taken (s)."""
    stamp = message.header.stamp
    return time.time() - stamp.sec - stamp.nanosec / 1e9


def on_raw(message):
    to_pixels(message)
    sizes["raw"].append(len(message.data))
    ages["raw"].append(age_of(message))


def on_jpeg(message):
    cv2.imdecode(np.frombuffer(message.data, np.uint8), cv2.IMREAD_COLOR)
    sizes["jpeg"].append(len(message.data))
    ages["jpeg"].append(age_of(message))


start(head_camera, jpeg_quality=80)
scale = fresh(Node, "scale")
scale.create_subscription(Image, "/camera/image", on_raw, qos_profile_sensor_data)
scale.create_subscription(
    CompressedImage, "/camera/image/compressed", on_jpeg, qos_profile_sensor_data
)
await run(scale, seconds=60, until=lambda: min(map(len, sizes.values())) >= 40)
stop()
smaller = float(np.mean(sizes["raw"]) / np.mean(sizes["jpeg"]))
reveal("how-much-smaller", smaller=smaller)

# %% id="raw-and-jpeg" tags=["nbval-ignore-output"]
for kind in sizes:
    rate = 30 * np.mean(sizes[kind]) / 1e6
    age_ms = 1000 * np.median(ages[kind])
    measured = f"{rate:5.1f} MB/s at 30 Hz, {age_ms:.0f} ms old"
    print(f"{kind:>5}: {measured} when it can be used")

# %% id="how-much-smaller-it-is"
print("raw: 28 MB/s:", round(30 * np.mean(sizes["raw"]) / 1e6) == 28)
png = cv2.imencode(".png", pixels)[1]
print("PNG, without loss: less than 4 times smaller:", pixels.size < 4 * png.size)

# %% [markdown]
# On one machine, raw pictures are fine. Over Wi-Fi, 28 MB a second are 220 Mbit/s, more than many networks carry. JPEG
# fits into all of them.

# %% [markdown] prediction="slow-beside-quick"
# ### Experiment 2: a slow program beside a quick one
#
# Two programs listen to the camera. The first is the detector of lesson 16: it needs 0.2 s for each picture, six times
# too long, and its queue holds 30. The second is a viewer that needs next to no time. What does the slow program do to
# the quick one?
#
# - **a** The camera waits for the slow one: both get about five pictures a second.
#   when `rate < 0.5 * rate_alone`
#   ✗ `publish` does not wait for a callback. The camera does not even know that one is slow.
# - **b** The quick one gets its pictures, and they get as old as those of the slow one.
#   when `rate >= 0.5 * rate_alone and age >= 0.5 * slow_age`
#   ✗ Pictures get old in a queue, and each subscription has a queue of its own. That of the viewer is empty.
# - **c** Nothing that you would see.
#   when `rate >= 0.5 * rate_alone and age < 0.5 * slow_age`
#   ✓ Each subscription has a queue of its own. Only the slow program works on old pictures.

# %%
predict("slow-beside-quick")

# %% id="slow-beside-quick"
from lesson_nodes import toy_detector
from lesson_nodes.toy_scope import ToyScope


async def quick_view(*others, until):
    """The ages (s) of a quick viewer's pictures, and how many it gets in a second."""
    ages, arrivals = [], []

    def view(image):
        ages.append(age_of(image))
        arrivals.append(time.monotonic())

    viewer = fresh(Node, "viewer")
    viewer.create_subscription(Image, "/camera/image", view, qos_profile_sensor_data)
    await run(viewer, *others, seconds=60, until=lambda: until(ages))
    viewer.destroy_node()
    return np.median(ages), (len(ages) - 1) / (arrivals[-1] - arrivals[0])


start(head_camera, width=160)
_, rate_alone = await quick_view(until=lambda ages: len(ages) >= 60)
start(toy_detector, depth=30)
slow = fresh(ToyScope)
age, rate = await quick_view(slow, until=lambda ages: len(slow.ages) >= 20)
stop()
slow_age = slow.ages[-1]
print("a picture of the slow one is older than 0.5 s:", slow_age > 0.5)
print("a picture of the quick one is half as old or older:", age >= 0.5 * slow_age)
print("the quick one gets half as many pictures or fewer:", rate <= 0.5 * rate_alone)
reveal(
    "slow-beside-quick", rate=rate, rate_alone=rate_alone, age=age, slow_age=slow_age
)

# %% [markdown]
# That is why nobody warns you. Viewer, camera and network look fine. Only the slow program acts on pictures that are a
# second old. For cameras, keep the queue short.
#
# *Reliable* on both sides changes nothing here. DDS confirms a picture when it enters the queue, not when your callback
# has handled it, so nothing is sent again. We measured it: the network carries as many bytes as with best effort.

# %% [markdown]
# ## When it goes wrong
#
# **`step` ignored.** The rows have 32 bytes of padding. A program that takes `3 * width` for the length of a row shifts
# each row a little more.

# %% id="step-ignored"
skewed = np.frombuffer(image.data, np.uint8)[: image.height * image.width * 3]
skewed = skewed.reshape(image.height, image.width, 3)
print("with step, the ball is found:   ", find_ball(pixels) is not None)
print("without step, the ball is found:", find_ball(skewed) is not None)

# %% [markdown]
# **A view of a buffer that is used again.** Some drivers write each picture into the same memory. A view that you keep
# shows the newest picture, and no longer the one that you looked at. rclpy makes a new message for each picture.

# %% id="buffer-used-again"
buffer = np.zeros((2, 2, 3), np.uint8)  # the memory of a driver
kept_view, kept_copy = buffer[:], buffer.copy()
buffer[:] = 200  # the next picture arrives
print("the view says", kept_view[0, 0, 0], "and the copy", kept_copy[0, 0, 0])

# %% [markdown]
# Copy what you keep: `pixels.copy()`. And **`imshow` in a callback** does not belong in a node. It draws in the
# thread that runs your callbacks. And servers and robots have the `headless` build of OpenCV, in which `imshow` only
# raises an error.

# %% id="imshow" tags=["raises-exception"]
cv2.imshow("camera", pixels)

# %% [markdown]
# ## From a worked example to your own
#
# **Worked.** In which direction is the ball in our picture, and how far would the neck have to turn?

# %% id="worked"
x, y, z = direction(*find_ball(pixels))
print("a vector of length 1:", round(math.sqrt(x * x + y * y + z * z), 6) == 1)
little = abs(math.degrees(math.atan2(x, z))) < 30
print("the neck would have to turn:", little, "(by less than 30°)")

# %% [markdown]
# **Faded.** Convert a picture by its encoding. The lines with `...` are yours.

# %%
# TODO: a dictionary from encoding to constant,
# such as {"rgb8": cv2.COLOR_RGB2HSV, "bgr8": ...}.
CODES = ...


def to_hsv(image):
    """HSV pixels of an rgb8 or bgr8 image; None for other encodings."""
    if image.encoding not in CODES:
        return None
    return cv2.cvtColor(to_pixels(image), CODES[image.encoding])


if CODES is ...:
    print("Fill in the codes, then run this cell again.")
else:
    print("the shape of the HSV pixels:", to_hsv(image).shape)

# %% [markdown]
# **Your own.** In the [exercise](../exercises/15_camera.ipynb) you write the tracker: it says where the ball is, or
# that there is none.

# %% [markdown]
# ## Check yourself
#
# **1. `width` is 640, `encoding` is `rgb8`, `step` is 2048. Where does row 2 begin, the third one?**
#
# <details><summary>a) At byte 3840</summary>
#
# ✗ That is 2 · 3 · 640. It leaves out the padding.
#
# </details>
# <details><summary>b) At byte 4096</summary>
#
# ✓ 2 · `step`.
#
# </details>
# <details><summary>c) At byte 1280</summary>
#
# ✗ That is 2 · 640, as if a pixel were a single byte.
#
# </details>
#
# **2. Why not look for the ball by brightness?**
#
# <details><summary>a) It changes with the light, and other things are bright as well</summary>
#
# ✓ Hue hardly changes when a cloud passes.
#
# </details>
# <details><summary>b) Brightness needs 16 bits</summary>
#
# ✗ A byte is enough for brightness.
#
# </details>
# <details><summary>c) Cameras do not measure brightness</summary>
#
# ✗ Brightness is all that they measure, through red, green and blue filters.
#
# </details>
#
# **3. Your viewer shows what happened a second ago. What helps?**
#
# <details><summary>a) A longer queue</summary>
#
# ✗ Then it shows what happened two seconds ago.
#
# </details>
# <details><summary>b) Reliable QoS</summary>
#
# ✗ It sends again what was lost. Your pictures are not lost: they wait in your queue.
#
# </details>
# <details><summary>c) A queue of one picture</summary>
#
# ✓ The viewer then always gets the newest picture.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Copy the prompt for an AI assistant, or discuss it with a colleague. State your own view first.
#
# ```text
# I program a robot with ROS 2 Jazzy in Python (rclpy). My robot should keep its eyes on
# an orange ball. I get sensor_msgs/Image at 30 Hz in an rclpy node, Jazzy. How do I
# find the ball in changing light, and how do I turn its pixel into an angle for the
# neck? Name only functions that exist in rclpy for Jazzy.
# ```
#
# <details><summary>What a good answer contains</summary>
#
# It asks for `encoding` and `step`, or uses a converter that obeys them. It subscribes with sensor-data QoS and a short
# queue. It finds the ball by hue and outline, not by brightness. It uses the focal length of `CameraInfo`, and says in
# which axes the direction is. It copies the stamp of the picture, and says what happens when there is no ball. It turns
# the neck a part of the way for each picture.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Two claims you may meet. Both are wrong: each was tried with the rclpy of this course.
#
# - **`from cv_bridge import CvBridge`:** It comes with a ROS installation, but not with the packages of this course.
#   `np.frombuffer` does the same in one line.
# - **`np.array(msg.data).reshape(height, width, 3)`:** It ignores `step` and `encoding`. With padded rows it raises an
#   error; with `bgr8` it swaps red and blue.
#
# </details>

# %% [markdown]
# ## Take away
#
# - `encoding` says what the bytes mean, `step` where a row begins; nobody checks them for you.
# - Sensor-data QoS and a short queue: the newest picture is the best one.
# - Hue hardly changes with the light; the center of many pixels is known to a fraction of a pixel.
# - From pixels to a direction: subtract the middle, divide by the focal length, give it the length 1.
# - A loop that goes a part of the way with each picture follows a ball, without knowing how far away it is.
#
# **Before:** [14 · Arrays and filters](14_arrays_and_filters.ipynb)
#
# **Next:** [16 · An AI model in a node](16_ai_model.ipynb)
#
# **More:** [sensor_msgs/Image](https://docs.ros.org/en/jazzy/p/sensor_msgs/msg/Image.html) and
# [OpenCV in Python](https://docs.opencv.org/4.x/d6/d00/tutorial_py_root.html).

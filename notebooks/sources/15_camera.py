# %% [markdown]
# # 15 · A camera
#
# A 640 × 480 color camera sends almost a million bytes per image, thirty times a second. To look at a ball, a robot
# needs just two angles: one horizontal and one vertical. How do you get from pixels to those angles, and how does the
# head use them to follow the ball?
#
# - **Minutes:** 45
# - **You need:** lessons [13](13_qos_and_discovery.ipynb) and [14](14_arrays_and_filters.ipynb)
# - **You will be able to:**
#   - turn an `Image` message into a NumPy array
#   - find a ball by its color and shape
#   - turn a pixel into a direction
#   - make the head follow the ball
# - **Not covered:** lens distortion and calibration, depth, neural networks (lesson 16)
#
# Here's the view from the robot's head. An orange ball rolls across a desk, two orange bricks lie behind it, and
# passing clouds change the light. The hands at the bottom are the robot's own. This camera is simulated, and its node
# draws the hands using the positions published on `/robot/joint_positions` (lesson 09).

# %%
from lesson_nodes import head_camera
from lesson_nodes.ball_scope import BallScope
from workbook.lesson import fresh, init, run, start, stop
from workbook.lesson.films import alone, show_film

init()
print("started", start(head_camera, width=320))
scope = fresh(BallScope)
await run(scope, seconds=50, until=lambda: len(scope.film) >= 36)
stop()
show_film(
    [alone(image) for image in scope.film],
    "an orange ball rolls left and right between gray hands and orange bricks while "
    "the light changes",
    6,
)

# %% [markdown]
# Each frame of the clip above arrived as a `sensor_msgs/Image` message. Let's print one message's fields. To get the
# same numbers in every run, we freeze the camera: it publishes frame 20 over and over. This camera also pads each row
# with 32 unused bytes, as some real cameras do.

# %% id="fields"
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Image

images = []


def keep(image):
    images.append(image)


start(head_camera, frozen=20, padding=32)
watcher = fresh(Node, "watcher")
watcher.create_subscription(Image, "/camera/image", keep, qos_profile_sensor_data)
await run(watcher, seconds=30, until=lambda: images)
stop()
image = images[-1]
used = 3 * image.width
print(f"{image.width} × {image.height} pixels, encoding {image.encoding}")
print(
    f"step: {image.step} bytes per row "
    f"({used} of pixels, {image.step - used} of padding)"
)
print(f"data: {len(image.data)} bytes")

# %% [markdown]
# <details><summary>How to do this without the helper functions</summary>
#
# `start(head_camera, frozen=20)` runs `python -m lesson_nodes.head_camera --ros-args -p frozen:=20` in a separate
# process, and `stop` ends that process as Ctrl-C would. `fresh` destroys the node that an earlier run of the cell
# created, and then creates a new one. In plain rclpy, the rest of the cell is:
#
# ```python
# rclpy.init()
# watcher = Node("watcher")
# watcher.create_subscription(Image, "/camera/image", keep, qos_profile_sensor_data)
# while not images:
#     rclpy.spin_once(watcher, timeout_sec=0.1)
# watcher.destroy_node()
# rclpy.try_shutdown()
# ```
#
# Like this loop, `run` spins until its condition holds, but it keeps the notebook's buttons working and gives up after
# `seconds`.
#
# </details>
#
# | field | meaning |
# |---|---|
# | `encoding` | the layout of a pixel: `rgb8` is one byte each of red, green, and blue; `bgr8` reverses that order; `mono8` is one byte of gray |
# | `step` | the length of a row in bytes, including padding |
# | `is_bigendian` | the byte order of values wider than one byte, as in `mono16` |
# | `header.stamp` | when the image was taken |
#
# `data` is one flat array of bytes:

# %%
from workbook.pictures import camera_figures as drawn
from workbook.pictures.figures import show

show(
    drawn.row_memory(image.width, image.step),
    "two rows in memory: bytes R, G, B for each pixel, then padding; a bracket marks "
    "the pixels of a row, a longer one its step",
)

# %% [markdown]
# To index `data` by row and column, reshape it into rows of `step` bytes. Then cut off the padding.
#
# **Your turn.** The first step is done for you. Write the slice that keeps only the pixel bytes.

# %% id="your-slice"
import numpy as np

from workbook.lesson import yours

rows = np.frombuffer(image.data, np.uint8).reshape(image.height, image.step)
without_padding = rows[:, ...]  # TODO: replace the ...

yours(
    without_padding.shape,
    (480, 1920),
    "Replace the ... with a slice that ends after 3 * image.width bytes.",
)

# %% [markdown]
# Here is the whole conversion. The last step groups the bytes into pixels of three bytes each. The result is a
# **view**: an array that uses the message's memory, so nothing is copied.

# %% id="to-pixels"
def to_pixels(image):
    """A view of an rgb8 or bgr8 image, shape (height, width, 3)."""
    rows = np.frombuffer(image.data, np.uint8).reshape(image.height, image.step)
    return rows[:, : 3 * image.width].reshape(image.height, image.width, 3)


pixels = to_pixels(image)
shared = np.shares_memory(pixels, np.frombuffer(image.data, np.uint8))
copied = "a view: nothing copied" if shared else "a copy"
print(f"shape {pixels.shape}, dtype {pixels.dtype}, {copied}")

# %% [markdown] prediction="read-as-bgr8"
# ## Predict
#
# The ball is orange: a lot of red, some green, and very little blue. Suppose your code interprets the `rgb8` image as
# `bgr8`, the order that OpenCV's `imread` and `imshow` use. What color does the ball appear to be?
#
# - **a** Green.
#   when `green > red and green > blue`
#   ✗ Green is the middle byte in both orders, so it doesn't change.
# - **b** Blue.
#   when `blue > red and blue > green`
#   ✓ The first byte of each pixel holds the large red value, and code that expects `bgr8` reads that byte as blue.
# - **c** None: the code raises an error, because the encodings differ.
#   ✗ NumPy and OpenCV get only the bytes. Neither of them reads the message's `encoding` field.

# %%
from workbook.lesson import predict, reveal

predict("read-as-bgr8")

# %% [markdown]
# ## Run it
#
# We compute the average color of the ball's pixels and interpret it both ways, as `rgb8` and as `bgr8`.

# %% id="bgr-for-rgb"
import cv2

hsv = cv2.cvtColor(pixels, cv2.COLOR_RGB2HSV)
colored = cv2.inRange(hsv, (4, 130, 35), (22, 255, 255))[150:280, 120:240] > 0
crop = pixels[150:280, 120:240]
first, second, third = (float(mean) for mean in crop[colored].mean(axis=0))
print(f"interpreted as rgb8: red {first:.0f}, green {second:.0f}, blue {third:.0f}")
print(f"interpreted as bgr8: red {third:.0f}, green {second:.0f}, blue {first:.0f}")
show(
    drawn.side_by_side(
        [crop, crop[..., ::-1]], ["rgb8 read as rgb8", "rgb8 read as bgr8"]
    ),
    "two views of the ball: orange in the left one, blue in the right one",
)
reveal("read-as-bgr8", red=third, green=second, blue=first)

# %% [markdown]
# There's no exception and no warning. Your code is just wrong, thirty times a second. So check `encoding` in every
# image callback, and choose the conversion that matches it.

# %% [markdown]
# ## Look inside
#
# ### Find the ball
#
# Which pixels are orange? RGB values don't tell you directly, because a passing cloud changes all three of them.
# **HSV** separates color from brightness. *Hue* is the position on the color wheel, *saturation* is how vivid the color
# is, and *value* is how bright it is.

# %%
show(
    drawn.hue_wheel(4, 22),
    "a color wheel with the numbers 0 to 179; a frame marks the slice of orange hues, "
    "4 to 22",
)

# %% [markdown]
# For `uint8` images, OpenCV divides the hue angle by two so that it fits into one byte: 0 to 179 instead of 0° to 359°.
# Let's compare the orange pixels in a dark frame and in a bright one.

# %% id="hue-stays"
from lesson_nodes.head_camera import frame


def orange_of(pixels):
    """A mask: 255 where a pixel is orange, 0 elsewhere."""
    hsv = cv2.cvtColor(pixels, cv2.COLOR_RGB2HSV)
    # Lower and upper limits: hue, saturation, value.
    mask = cv2.inRange(hsv, (4, 130, 35), (22, 255, 255))
    return cv2.medianBlur(mask, 3)  # removes isolated pixels


for light, number in (("dark", 175), ("bright", 75)):
    one = frame(number)
    orange = cv2.cvtColor(one, cv2.COLOR_RGB2HSV)[orange_of(one) > 0]
    hue, saturation, value = np.median(orange, axis=0)
    print(
        f"{light + ' frame:':<14}hue {hue:.0f}, saturation {saturation:.0f}, "
        f"value {value:.0f}"
    )

# %% [markdown]
# In the dark frame, the value is more than a third lower, but the hue differs by only 1. So a **threshold** on hue and
# saturation, plus a low minimum for value, finds the orange pixels in dark and bright frames alike.

# %%
show(
    drawn.side_by_side(
        [pixels, orange_of(pixels)],
        ["The image", "Ball and bricks are orange"],
    ),
    "left: the desk with the ball and two bricks; right: three white spots on black, "
    "where they are",
)

# %% [markdown]
# The bricks are orange, too, but they aren't round. So we outline each orange blob with a **contour** and fit the
# smallest circle around it. If the blob's area is more than 75% of the circle's, the blob counts as round.

# %% id="find-ball"
def blobs_of(mask):
    """For each blob: its center, the smallest circle around it, and its share of it."""
    outlines, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    blobs = []
    for outline in sorted(outlines, key=cv2.contourArea, reverse=True):
        around, radius = cv2.minEnclosingCircle(outline)
        if radius > 3:
            # m00 is the area; m10 and m01 are sums of columns and rows over it.
            sums = cv2.moments(outline)
            center = sums["m10"] / sums["m00"], sums["m01"] / sums["m00"]
            blobs.append((center, (*around, radius), sums["m00"] / (np.pi * radius**2)))
    return blobs


def find_ball(pixels):
    """Column and row of the ball's center; None if no orange blob is round."""
    for center, _, filled in blobs_of(orange_of(pixels)):
        if filled > 0.75:
            return center
    return None


for (column, row), _, filled in blobs_of(orange_of(pixels)):
    verdict = "so it's the ball" if filled > 0.75 else "not round"
    place = f"column {column:.0f}, row {row:.0f}"
    print(f"blob at {place}: {filled:.0%} of its circle, {verdict}")

rings = [
    drawn.Ring(*circle, f"{filled:.0%}", filled > 0.75)
    for _, circle, filled in blobs_of(orange_of(pixels))
]
show(
    drawn.side_by_side(
        [pixels], ["Only the ball fills its circle"], rings=rings, height=3.4
    ),
    "the desk with a circle around each orange thing: the ball fills most of its "
    "circle, the bricks less than half",
)

# %% [markdown]
# `find_ball` returns the ball's center. The center is an average over many pixels, so it's accurate to a fraction of a
# pixel. If no blob is round, the function returns `None`. Plan for that: sooner or later, someone will pick up the
# ball.
#
# ### From a pixel to a direction
#
# The **pinhole model** treats the camera as a box with a tiny hole in the front. Light travels in a straight line from
# the ball, through the hole, onto the image plane inside. The *focal length* is the distance from the hole to that
# plane, measured in pixel widths: 560 px for this camera.

# %%
show(
    drawn.pinhole_above(560, 140),
    "the camera from above: a ray from the ball through the hole meets the image plane "
    "x pixels from its center; focal length and x give the angle",
)

# %% [markdown]
# So a pixel that's `x` columns to the right of the center and `y` rows below it corresponds to the direction (`x`, `y`,
# 560). Divide that vector by its length to get a unit vector: a direction of length 1. Its components follow the ROS
# axis convention for cameras ([REP 103](https://www.ros.org/reps/rep-0103.html), *optical* frames): x points right, y
# down, and z forward.

# %% id="pinhole"
import math

FOCAL, CENTER = 560.0, (319.5, 239.5)


def direction(column, row):
    """The direction of a pixel: x right, y down, z forward, length 1."""
    x, y = column - CENTER[0], row - CENTER[1]
    length = math.sqrt(x * x + y * y + FOCAL * FOCAL)
    return x / length, y / length, FOCAL / length


def angles(column, row):
    """The direction of a pixel in words."""
    x, y, z = direction(column, row)
    right, down = math.degrees(math.atan2(x, z)), math.degrees(math.atan2(y, z))
    return (
        f"{abs(right):.1f}° {'left' if right < 0 else 'right'}, "
        f"{abs(down):.1f}° {'up' if down < 0 else 'down'}"
    )


print("center of the image:", angles(*CENTER))
print("left edge: ", angles(0, 239.5))
print("right edge:", angles(639, 239.5))
print("ball:      ", angles(*find_ball(pixels)))

# %% [markdown]
# These angles are relative to the camera's axis. The axis points 29° down, so "2.8° up" is still far below the horizon.
#
# ### Close the loop
#
# Now connect the camera to the neck with a new node. For each image, this node finds the ball, computes the ball's
# angle, and turns the neck by a quarter of that angle. The next image shows the remaining error, and the node corrects
# a quarter of that, too. This is a **feedback loop**. The fraction that the node corrects each time, here a quarter, is
# the loop's **gain**.

# %%
from workbook.pictures.graph import draw

names = ["/head_camera", "/head_follower"], ["/camera/image", "/robot/joint_positions"]
edges = [
    ("/head_camera", "/camera/image"),
    ("/camera/image", "/head_follower"),
    ("/head_follower", "/robot/joint_positions"),
    ("/robot/joint_positions", "/head_camera"),
]
show(
    draw(*names, edges),
    "a loop: the camera publishes images, the follower publishes joint positions, and "
    "the camera turns by them",
)

# %% [markdown]
# **Your turn.** Write the expression that computes the neck's next angle. The neck's angle is positive to the left, but
# the ball's angle is positive to the right.

# %% id="your-turn-of-the-neck"
GAIN = 0.25


def turned(neck, ball_angle):
    """The neck's next angle (rad): a quarter of the error is corrected."""
    return ...  # TODO: from neck, GAIN, and ball_angle


yours(turned(0.0, 0.2), -0.05, "A ball on the right makes the neck's angle smaller.")

# %% [markdown]
# The callback of the `HeadFollower` node uses this formula, and it records each error in pixels. First, we create the
# node's subscription with just a queue depth of 1 instead of a QoS profile.

# %% id="reliable-gets-nothing"
from std_msgs.msg import Float32MultiArray

from lesson_nodes.head_camera import AT_REST, pinhole
from workbook.lesson.films import with_head


class HeadFollower(Node):
    """Turns the neck toward the ball."""

    def __init__(self, qos, gain=0.25) -> None:
        super().__init__("head_follower")
        self.gain, self.joints = gain, list(AT_REST)
        self.errors_px, self.lost, self.film = [], 0, []
        self.publisher = self.create_publisher(
            Float32MultiArray, "/robot/joint_positions", 10
        )
        self.create_subscription(Image, "/camera/image", self.on_image, qos)

    def on_image(self, image: Image) -> None:
        pixels = to_pixels(image)
        ball = find_ball(pixels)
        if (len(self.errors_px) + self.lost) % 5 == 0:  # for the film below
            small = cv2.resize(pixels, (320, 240))
            self.film.append(with_head(small, self.joints[0], ball, pinhole(640)))
        if ball is None:
            self.lost += 1
        else:
            x, _, z = direction(*ball)
            self.errors_px.append(abs(ball[0] - CENTER[0]))
            neck = self.joints[0] - self.gain * math.atan2(x, z)
            self.joints[0] = min(max(neck, -0.6), 0.6)  # the neck's limits
        self.publisher.publish(Float32MultiArray(data=self.joints))


start(head_camera)
follower = fresh(HeadFollower, 1)
await run(follower, seconds=3)
stop()
print("images received in 3 s:", len(follower.errors_px) + follower.lost)

# %% [markdown]
# No images arrive, and rclpy logs a warning. The camera offers **best effort**: a lost image isn't sent again, because
# the next one is due in 33 ms anyway. A subscription that you create with just a queue depth requests *reliable*
# delivery, so its QoS is incompatible with the camera's (lesson 13). Use `qos_profile_sensor_data` instead, which
# requests best effort.
#
# From here on, the camera takes each image only after the neck has responded to the previous one. Otherwise, on a busy
# computer, some images would arrive late, and the results would vary.

# %% id="follow"
from workbook.lesson import about


def in_degrees(error_px):
    return math.degrees(math.atan(error_px / FOCAL))


async def follow(follower):
    """Run a follower for 150 images: median error (px), share without a ball."""
    start(head_camera, waits=True)
    await run(
        follower,
        seconds=50,
        until=lambda: len(follower.errors_px) + follower.lost >= 150,
    )
    stop()
    follower.settled = follower.errors_px[len(follower.errors_px) // 3 :]
    return float(np.median(follower.settled)), follower.lost / 150


follower = fresh(HeadFollower, qos_profile_sensor_data)
error_before_px, _ = await follow(follower)
print(
    f"ball off center: typically {about(error_before_px, 'px', between=(10, 45))} "
    f"({about(in_degrees(error_before_px), '°', between=(1, 5))}), "
    f"at most {about(max(follower.settled), 'px', between=(15, 120))}"
)
show_film(
    follower.film,
    "left: the desk moves past, and the ball stays near the white center line; right: "
    "seen from above, the head turns with the ball",
    6,
)

# %% [markdown]
# Without the loop, the ball would wander up to 250 px from the center. With the loop, the ball stays close to the
# center, even though the node doesn't know the ball's distance. The node doesn't compute the neck's exact turn, either:
# it uses the ball's angle in the image. Because the camera is tilted, centering a ball that appears 14.2° to the left
# takes a turn of 15.7°. Later corrections make up the difference.

# %% [markdown] prediction="smaller-gain"
# ## Change it
#
# ### Experiment 1: a smaller gain
#
# The gain was 0.25. With 0.05, the node corrects only a twentieth of the error per image. How far from the center is
# the ball now?
#
# - **a** About as far as before: thirty corrections a second add up.
#   when `lost_share < 0.5 and error_px < 1.5 * error_before_px`
#   ✗ They add up, but the ball keeps rolling in the meantime. For the same error, each correction is only a fifth as
#   large, so the head lags farther behind.
# - **b** It leaves the image: the head can't keep up.
#   when `lost_share >= 0.5`
#   ✗ The farther the head lags, the larger each correction gets. Once the corrections match the ball's speed, the lag
#   stops growing.
# - **c** Noticeably farther, but it stays in the image.
#   when `error_px >= 1.5 * error_before_px and lost_share < 0.5`
#   ✓ The head falls behind until the correction per image, a twentieth of the error, equals the ball's motion per
#   image.

# %%
predict("smaller-gain")

# %% id="smaller-gain"
follower = fresh(HeadFollower, qos_profile_sensor_data, gain=0.05)
error_px, lost_share = await follow(follower)
for gain, px in ((0.25, error_before_px), (0.05, error_px)):
    off = about(px, "px", between=(10, 180))
    print(f"gain {gain:.2f}: ball typically {off} off center")
reveal(
    "smaller-gain",
    error_px=error_px,
    error_before_px=error_before_px,
    lost_share=lost_share,
)

# %% [markdown] prediction="large-gain-old-images"
# ### Experiment 2: a large gain and old images
#
# With a larger gain, the head follows more closely, so why not correct the whole error each time?
#
# Images are never quite fresh, because exposure, transfer, and detection take time. We hold each image back for 0.1 s
# (three frames) and set the gain to 1.0. How does the head move?
#
# - **a** It swings back and forth past the ball.
#   when `error_px >= 2 * error_before_px`
#   ✓ Each turn is based on an image that doesn't show the last three turns yet. So the node corrects the same error
#   several times, and the head overshoots.
# - **b** It follows the ball closely, 0.1 s behind.
#   when `error_px < 2 * error_before_px and error_px > 0.5 * error_before_px`
#   ✗ A delay in a feedback loop doesn't just shift the motion in time. The node keeps reacting to errors that it has
#   already corrected.
# - **c** It keeps the ball exactly in the center.
#   when `error_px <= 0.5 * error_before_px`
#   ✗ With fresh images, it nearly would. These are 0.1 s old, so they show an error that's out of date.

# %%
predict("large-gain-old-images")

# %% id="large-gain"
from collections import deque


class LateFollower(HeadFollower):
    """A HeadFollower that gets each image three images later."""

    waiting = None

    def on_image(self, image: Image) -> None:
        self.waiting = self.waiting or deque()
        self.waiting.append(image)
        if len(self.waiting) > 3:
            super().on_image(self.waiting.popleft())


follower = fresh(LateFollower, qos_profile_sensor_data, gain=1.0)
error_px, _ = await follow(follower)
show_film(
    follower.film,
    "left: the ball jumps from side to side; right: seen from above, the line of sight "
    "swings past the ball, back and forth",
    6,
)
reveal("large-gain-old-images", error_px=error_px, error_before_px=error_before_px)

# %% [markdown]
# Which is to blame, the gain or the old images? Let's change one at a time.

# %%
late = fresh(LateFollower, qos_profile_sensor_data, gain=0.25)
error_small_gain_px, _ = await follow(late)

# %% id="gain-and-delay"
eager = fresh(HeadFollower, qos_profile_sensor_data, gain=1.0)
error_fresh_px, _ = await follow(eager)
for name, off in {
    "gain 1.00, 0.1 s older: ": about(error_px, "px", between=(40, 320)),
    "gain 0.25, 0.1 s older: ": about(error_small_gain_px, "px", between=(10, 60)),
    "gain 1.00, fresh images:": about(error_fresh_px, "px", between=(1, 25)),
}.items():
    print(name, off, "off center")

# %% [markdown]
# The loop is like a shower that reacts ten seconds late: you turn the knob too far, then too far back. A smaller gain
# helps, and so do fresher images. With `QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)`, only the
# newest image waits in the queue.

# %% [markdown]
# ## When it goes wrong
#
# **Ignoring `step`.** This code assumes rows of `3 * width` bytes. But each row is really 32 bytes longer, so the error
# grows by 32 bytes with every row.

# %% id="step-ignored"
skewed = np.frombuffer(image.data, np.uint8)[: image.height * image.width * 3]
skewed = skewed.reshape(image.height, image.width, 3)
for name, read in (("using step:   ", pixels), ("ignoring step:", skewed)):
    ball = find_ball(read)
    if ball is None:
        print(name, "no ball found")
    else:
        print(name, f"ball at column {ball[0]:.0f}, row {ball[1]:.0f}")
show(
    drawn.side_by_side([pixels, skewed], ["Using step", "Ignoring step"]),
    "left: the desk; right: the same bytes as slanted stripes in wrong colors",
)

# %% [markdown]
# The image dissolves into stripes. To fix this, reshape to `(height, step)` first, as `to_pixels` does.
#
# **Calling `cv2.imshow` in a callback.** Displaying an image holds up the thread that runs your callbacks. It also
# needs an OpenCV build with GUI support. Ubuntu's `python3-opencv` is such a build, but PyPI's
# `opencv-python-headless`, which this course installs, isn't.

# %% id="imshow" tags=["raises-exception"]
cv2.imshow("camera", pixels)

# %% [markdown]
# Publish an annotated image instead, and view it in another program.

# %% [markdown]
# ## From a worked example to your own
#
# **Worked example.** When you publish a direction, copy the header of the image that it came from. The header contains
# the stamp, so subscribers know *when* the ball was there.

# %% id="worked"
from geometry_msgs.msg import Vector3Stamped

message = Vector3Stamped(header=image.header)
vector = message.vector
vector.x, vector.y, vector.z = direction(*find_ball(pixels))
stamp, taken = message.header.stamp, image.header.stamp
apart = stamp.sec - taken.sec + (stamp.nanosec - taken.nanosec) / 1e9
print(f"direction ({vector.x:.2f}, {vector.y:.2f}, {vector.z:.2f})")
print(f"axes: {message.header.frame_id}, {apart:.1f} s from the image's stamp")

# %% [markdown]
# **Fill in the blanks.** Convert an image to HSV according to its encoding. Write the dictionary of conversion codes.

# %% id="your-codes"
# TODO: from encoding to constant, such as {"rgb8": cv2.COLOR_RGB2HSV, "bgr8": ...}.
CODES = ...


def ball_hue(pixels, encoding):
    """The typical hue of the ball's pixels."""
    hsv = cv2.cvtColor(pixels, CODES[encoding])
    return float(np.median(hsv[150:280, 120:240][colored][:, 0]))


if CODES is ... or ... in CODES.values():
    yours(..., None)
else:
    both = [ball_hue(pixels, "rgb8"), ball_hue(pixels[..., ::-1].copy(), "bgr8")]
    yours(both, [14.0, 14.0], "The hue must be the same in both orders.")

# %% [markdown]
# **Your own.** In the [exercise](../exercises/15_camera.ipynb), you write the node between the camera and the neck. For
# each image, it publishes the ball's direction or reports that there's no ball.

# %% [markdown]
# ## Check yourself
#
# **1. An `rgb8` image has `width` 640 and `step` 2048. Where does its third row begin?**
#
# <details><summary>a) At byte 3840</summary>
#
# ✗ That's 2 · 3 · 640. It leaves out the padding.
#
# </details>
# <details><summary>b) At byte 4096</summary>
#
# ✓ Two rows come first, and each takes `step` bytes: 2 · 2048.
#
# </details>
# <details><summary>c) At byte 1280</summary>
#
# ✗ That's 2 · 640, as if each pixel were a single byte.
#
# </details>
#
# **2. Why does `find_ball` use hue rather than brightness?**
#
# <details><summary>a) Brightness changes with the light, and other objects are bright, too</summary>
#
# ✓ Hue hardly changes when a cloud passes.
#
# </details>
# <details><summary>b) Brightness would need 16 bits per pixel</summary>
#
# ✗ One byte is plenty. In our HSV images, *value* is one byte.
#
# </details>
# <details><summary>c) Cameras don't measure brightness</summary>
#
# ✗ Brightness is all that they measure, through red, green, and blue filters. Color comes from comparing the three.
#
# </details>
#
# **3. The ball is at column 459.5, the center is at column 319.5, and the focal length is 560 px. Where is the ball?**
#
# <details><summary>a) 14° left</summary>
#
# ✗ Columns are numbered from left to right, so a larger column number is farther to the right.
#
# </details>
# <details><summary>b) 13° right, because the ball is 44% of the way to the edge, and the edge is at 29.7°</summary>
#
# ✗ The angle isn't proportional to the distance from the center. Its tangent is.
#
# </details>
# <details><summary>c) 14° right</summary>
#
# ✓ (459.5 − 319.5) / 560 is 0.25, and the arctangent of 0.25 is 14.0°.
#
# </details>
#
# **4. Your robot's head swings back and forth past the ball. What reduces the swinging?**
#
# <details><summary>a) A larger gain</summary>
#
# ✗ The head would overshoot even farther.
#
# </details>
# <details><summary>b) Fresher images, or a smaller gain</summary>
#
# ✓ With fresher images, the node corrects the same error fewer times. A smaller gain corrects less of it each time.
#
# </details>
# <details><summary>c) Reliable QoS</summary>
#
# ✗ It resends lost images. Yours aren't lost; they're late.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Write down your own answer first. Then copy the prompt into an AI assistant, or discuss it with a colleague.
#
# ```text
# I'm programming a robot with ROS 2 Jazzy in Python (rclpy). My robot should keep its
# eyes on an orange ball. An rclpy node receives sensor_msgs/Image messages at 30 Hz. How
# do I find the ball in changing light, and how do I convert its pixel position into an
# angle for the neck? Make sure that every rclpy function you use exists in Jazzy.
# ```
#
# <details><summary>What a good answer covers</summary>
#
# The code handles `encoding` and `step`, or uses a converter that does. It subscribes with sensor-data QoS and a short
# queue. It finds the ball by hue and shape rather than brightness, and takes the focal length from `CameraInfo`. It
# copies the image's stamp, and corrects only part of the error with each image. A good answer also says what to publish
# when there's no ball, and which way x, y, and z point. It mentions that a delay can make the head swing.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Watch for these two suggestions. We tested both in this course's environment, and both failed.
#
# - **`from cv_bridge import CvBridge`:** cv_bridge is a separate ROS package, and this course doesn't install it. If
#   it's installed on your system, use it: it handles encodings and byte order. `np.frombuffer` alone handles neither,
#   and our `to_pixels` handles only `step`.
# - **`np.array(msg.data).reshape(height, width, 3)`:** This ignores `step` and `encoding`. With padded rows, it raises
#   an error. With `bgr8`, it returns an array in which red and blue are swapped.
#
# </details>

# %% [markdown]
# ## Take away
#
# - `encoding` defines the layout of a pixel, and `step` is the length of a row in bytes. OpenCV reads neither, so your
#   code has to.
# - Threshold the hue, not the brightness, and use the shape to reject other orange objects.
# - From pixel to direction: subtract the center, use the focal length as z, and divide the vector by its length.
# - A feedback loop corrects part of the error with each image. It doesn't need the ball's distance, but it does need
#   fresh images.
# - Cameras often publish with best-effort reliability. Request best effort, too, with a depth of 1 if only the newest
#   image matters.
#
# **Before:** [14 · Arrays and filters](14_arrays_and_filters.ipynb)
#
# **Deeper:** [15 · Deeper: bytes and queues](15_camera_deeper.ipynb)
#
# **Next:** [16 · An AI model in a node](16_ai_model.ipynb)
#
# **More:** [sensor_msgs/Image](https://docs.ros.org/en/jazzy/p/sensor_msgs/msg/Image.html) and
# [OpenCV in Python](https://docs.opencv.org/4.x/d6/d00/tutorial_py_root.html).

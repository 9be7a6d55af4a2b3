# ---
# exercise: 15_camera
# title: Eyes on the ball
# minutes: 45
# difficulty: 4
# kind: program
# clock: wall
# objectives:
#   - turning an Image's bytes into pixels, whatever its encoding and step
#   - finding a ball by its color and shape in changing light
#   - turning a pixel into a direction, and publishing it with the image's stamp
#   - reporting that there's no ball, and rejecting unreadable images
# out_of_scope:
#   - how far away the ball is, and where it will be next
#   - lens distortion (`CameraInfo` describes it)
#   - a ball that is partly hidden
#   - how the program ends (lesson 01 judges that)
# ---
# %% [markdown]
# # Exercise 15 · Eyes on the ball
#
# A ball is rolling across the desk, and the robot is supposed to keep its eyes on it. The camera works and publishes
# {{RATE_HZ}} images a second, but the node between the camera and the neck is missing. You'll write that node: it finds
# the ball in each image and publishes the ball's direction. If the node reported a ball that wasn't there, the robot
# would reach into empty space. So when there's no ball, the node must report "no ball".
#
# **About 45 minutes · difficulty 4 of 5 · 10 points.** This exercise builds on lesson [15](../notebooks/15_camera.ipynb).
#
# ## What to build
#
# Write one program that spins until it's interrupted with Ctrl-C.
#
# | topic | type | your node | content |
# |---|---|---|---|
# | `/camera/image` | `Image` | subscribes | {{RATE_HZ}} images a second, 160 columns by 120 rows |
# | `/robot/ball_direction` | `Vector3Stamped` | publishes | one direction for each image that it can read |
#
# `Image` is in `sensor_msgs.msg`, and `Vector3Stamped` is in `geometry_msgs.msg`. The judge's publisher offers
# reliable, volatile QoS with a queue depth of 100. The starter code requests best effort, which is compatible with a
# reliable publisher. Best effort also works with real cameras, which often offer nothing else.
#
# **The scene.** The ball is orange. There's also a blue ball on the desk, along with a brick in the same shade of
# orange as the orange ball. The brick can be either closer to the camera than the orange ball or farther away. But the
# two never overlap in the image, so you'll never see an orange ball in front of an orange brick. The robot's own gray
# hands sometimes come into view. There's at most one orange ball. It's never partly hidden, and it's at least 11 pixels
# wide.
#
# **The light** varies in brightness, from 40 % to 110 % of full daylight. Its color also varies a little, from warmer
# to cooler.
#
# **The camera** follows the pinhole model, with a focal length of {{FOCAL_PIXELS}} pixels. A point straight ahead of
# the camera appears at column 79.5, row 59.5. (The center of the upper left pixel is at column 0, row 0.)
#
# | your node | what that means |
# |---|---|
# | publishes the ball's direction as a vector of length 1 | in this vector, x points right, y down, and z forward |
# | is accurate | each direction points to the ball's center |
# | reports "no ball" if there is none | it publishes the vector (0, 0, 0) |
# | copies the image's stamp | each direction's header has the stamp of the image that the direction was computed from |
# | keeps up with {{RATE_HZ}} images a second | it never publishes more than one direction for an image, and for most images, it publishes the direction right away |
# | reads `rgb8` and `bgr8` | it uses the right color order, even if the encoding changes from one image to the next |
# | uses `step` | it can read images whose rows end with {{PADDING}} unused bytes |
# | rejects every other encoding | it publishes nothing for the image, logs a line that names the encoding, and keeps running |
#
# ## What is judged
#
# Your program runs in its own process. The judge stands in for the camera: it publishes {{PICTURES}} images that you
# haven't seen, some of them in encodings other than `rgb8`. The judge compares your directions with the true ones.
#
# | points | criterion |
# |---:|---|
# | 1 | your node subscribes to `/camera/image` with the type `Image`, and publishes `Vector3Stamped` messages on `/robot/ball_direction` |
# | 1 | each direction has the stamp of its image, and there's only one direction per image |
# | 1 | your node keeps up with {{RATE_HZ}} images a second |
# | 1 | your node rejects encodings other than `rgb8` and `bgr8`, logs a line that names each of them, and keeps running |
# | 2 | in good light, the direction for an `rgb8` image is correct |
# | 1 | in changing light, the direction is correct |
# | 1 | for `bgr8`, the direction is correct |
# | 1 | for rows with padding, the direction is correct |
# | 1 | when there's no ball, your node reports "no ball" |
#
# The criteria for changing light and for padding count only if the direction is correct in good light. Padding is
# tested with both encodings, but padded `bgr8` images count only if the direction is also correct for unpadded `bgr8`
# images.
#
# **Not judged:** the ball's distance, lens distortion, partly hidden balls, and how your program ends.
#
# **Tolerances**
#
# | requirement or term | limit |
# |---|---|
# | length of the vector | the length is within {{LENGTH_SLACK}} of 1 |
# | accuracy | each direction is within {{WITHIN_DEG}}° of the direction to the ball's center |
# | most images | your node publishes a direction for at least {{LEAST_SHARE %}} of the images that it should be able to read |
# | right away | at least half of the directions are published within {{TYPICALLY_S}} s of their image, and at least nine out of ten within {{AT_ONCE_S}} s |
# | good light | the light is at least {{BRIGHT %}} of full daylight. (Images with padding are judged separately.) |
# %% [answer]
"""Find the orange ball in a camera's images, and publish its direction."""

import math

import cv2
import numpy as np
import rclpy
from geometry_msgs.msg import Vector3Stamped
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Image

FOCAL = 140.0  # pixels
CENTER = (79.5, 59.5)  # column and row of a point straight ahead
# [solution]
ORANGE = ((4, 130, 35), (22, 255, 255))  # hue (0 to 179), saturation, value
TO_HSV = {"rgb8": cv2.COLOR_RGB2HSV, "bgr8": cv2.COLOR_BGR2HSV}
SMALLEST = 25  # pixels
ROUND = 0.75  # a ball fills at least this share of its enclosing circle
# [end]


def find_ball(image: Image) -> tuple[float, float] | None:
    """Return the column and row of the ball's center; None if there's no ball in the image."""
    # [solution]
    rows = np.frombuffer(image.data, np.uint8).reshape(image.height, image.step)
    pixels = rows[:, : 3 * image.width].reshape(image.height, image.width, 3)
    hsv = cv2.cvtColor(pixels, TO_HSV[image.encoding])
    orange = cv2.inRange(hsv, *ORANGE)
    orange = cv2.morphologyEx(orange, cv2.MORPH_OPEN, np.ones((3, 3), np.uint8))
    outlines, _ = cv2.findContours(orange, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    for outline in sorted(outlines, key=cv2.contourArea, reverse=True):
        _, radius = cv2.minEnclosingCircle(outline)
        sums = cv2.moments(cv2.drawContours(np.zeros_like(orange), [outline], -1, 1, cv2.FILLED), True)
        if sums["m00"] >= SMALLEST and sums["m00"] >= ROUND * np.pi * (radius + 0.5) ** 2:
            return sums["m10"] / sums["m00"], sums["m01"] / sums["m00"]
    return None
    # [starter]
    # | # TODO 1: turn image.data into pixels, using image.step and image.encoding
    # | # TODO 2: find the orange pixels, and the round outline among them
    # | return CENTER
    # [end]


def direction(column: float, row: float) -> list[float]:
    """Return a pixel's direction as a vector of length 1: x points right, y down, z forward."""
    # [solution]
    x, y = (column - CENTER[0]) / FOCAL, (row - CENTER[1]) / FOCAL
    length = math.sqrt(x * x + y * y + 1.0)
    return [x / length, y / length, 1.0 / length]
    # [starter]
    # | # TODO 3: the pinhole model
    # | return [0.0, 0.0, 1.0]
    # [end]


class BallTracker(Node):
    """Publishes the ball's direction for each image.

    Subscriptions:
        /camera/image (sensor_msgs/Image): images, rgb8 or bgr8.

    Topics:
        /robot/ball_direction (geometry_msgs/Vector3Stamped): a vector of length 1, or (0, 0, 0) for no ball.
    """

    def __init__(self) -> None:
        super().__init__("ball_tracker")
        self.publisher = self.create_publisher(Vector3Stamped, "/robot/ball_direction", 10)
        self.create_subscription(Image, "/camera/image", self.on_image, qos_profile_sensor_data)

    def on_image(self, image: Image) -> None:
        """Find the ball in an image, and publish its direction right away."""
        # [solution]
        if image.encoding not in TO_HSV:
            self.get_logger().error(f"I cannot read {image.encoding}", throttle_duration_sec=1.0)
            return
        # [starter]
        # | # TODO 4: refuse an encoding that you can't read
        # [end]
        answer = Vector3Stamped(header=image.header)
        ball = find_ball(image)
        # [solution]
        if ball is not None:
            answer.vector.x, answer.vector.y, answer.vector.z = direction(*ball)
        # [starter]
        # | # TODO 5: what do you publish if there is no ball?
        # | answer.vector.x, answer.vector.y, answer.vector.z = direction(*ball)
        # [end]
        self.publisher.publish(answer)


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(BallTracker())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
# %% [live]
# from lesson_nodes.ball_scope import BallScope
# from workbook.lesson import fresh, init, run
# from workbook.pictures.figures import figure, show
#
# %start
# init()
# scope = fresh(BallScope)  # records the images, and the directions that your node publishes
# await run(scope, seconds=10, until=lambda: len(scope.directions) >= 60)
# print("images:", len(scope.pictures), "directions:", len(scope.directions))
# if scope.pictures:
#     fig, axes = figure(4.2, 3.2)
#     stamp, picture = scope.pictures[-1]
#     axes.imshow(picture)
#     ball = dict(scope.directions).get(stamp)
#     if ball is not None and ball[2] > 0:
#         axes.plot(79.5 + 140 * ball[0] / ball[2], 59.5 + 140 * ball[1] / ball[2], "+", color="white", ms=16)
#     axes.grid(False)
#     show(fig, "the camera's last image, with a cross at the ball's position according to your node")
# %% [hint]
# Start with a single image. How many bytes does one of its rows have, and how many of those bytes are pixels? Then ask
# how you can recognize an orange pixel. Its brightness won't help, because that changes with the light. And what
# distinguishes a ball from a brick?
#
# Colors in OpenCV: [Changing colorspaces](https://docs.opencv.org/4.x/df/d9d/tutorial_py_colorspaces.html)
# %% [hint]
# - `np.frombuffer(image.data, np.uint8).reshape(image.height, image.step)` has one row of bytes for each image row,
#   including the padding. Cut off the padding, then reshape to `(height, width, 3)`.
# - `cv2.cvtColor(pixels, cv2.COLOR_RGB2HSV)` separates hue and saturation from brightness. There is a constant for BGR,
#   too.
# - `cv2.inRange` marks the pixels in a range, and `cv2.findContours` finds their outlines.
# - A ball fills most of its smallest enclosing circle (`cv2.minEnclosingCircle`). A brick doesn't.
# - A new `Vector3Stamped` holds the vector (0, 0, 0), so it already means "no ball". Copy its header from the image.
#
# The field `step`: [sensor_msgs/Image](https://docs.ros.org/en/jazzy/p/sensor_msgs/msg/Image.html)
# %% [hint]
# The steps, with gaps:
#
# ```python
# rows = np.frombuffer(image.data, np.uint8).reshape(image.height, ___)
# pixels = rows[:, : 3 * image.width].reshape(image.height, ___, 3)
# hsv = cv2.cvtColor(pixels, ___)  # depends on image.encoding
# orange = cv2.inRange(hsv, (4, ___, 35), (22, 255, 255))
# outlines, _ = cv2.findContours(orange, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
# for outline in outlines:
#     (column, row), radius = cv2.minEnclosingCircle(outline)
#     if radius >= 3 and cv2.contourArea(outline) > ___ * np.pi * radius**2:
#         return column, row
# return ___
#
# ray = np.array([(column - 79.5) / ___, (row - 59.5) / ___, 1.0])
# ```
#
# More on outlines: [Contour features](https://docs.opencv.org/4.x/dd/d49/tutorial_py_contour_features.html)
# %% [alternatives]
# ## Other good ways
#
# - **NumPy and SciPy only.** `red > 1.8 * green` and `green > 1.8 * blue` compare color ratios, which hardly change
#   with the light. `scipy.ndimage.label` then finds connected pixels.
# - **Other color spaces.** Lab and YCrCb also have a separate channel for brightness.
# - **Another measure of roundness.** 4π · area / perimeter² is 1 for a circle. Comparing width and height is coarser,
#   but good enough for this brick.
# - **A search near the ball's last position.** It's faster, and it can continue for a while if the ball is hidden. But
#   then the node must notice that it has lost the ball.
# - **A small neural network** finds balls that no rule describes. Lesson 16 uses one.

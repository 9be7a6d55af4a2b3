# ---
# exercise: 15_camera
# title: Eyes on the ball
# minutes: 45
# difficulty: 4
# kind: program
# clock: wall
# objectives:
#   - turn the bytes of an Image into pixels, whatever its encoding and its step
#   - find a ball by its color and its outline, in light that changes
#   - turn a pixel into a direction, and give it the stamp of its picture
#   - say that there is no ball, and refuse what the node cannot read
# out_of_scope:
#   - how far away the ball is, and where it will be next
#   - lenses that bend straight lines (`CameraInfo` describes them)
#   - a ball that is partly hidden
#   - how the program ends (lesson 01 judges that)
# ---
# %% [markdown]
# # Exercise 15 · Eyes on the ball
#
# A ball rolls over the desk, and the robot should look at it. Its camera works, and takes 30 pictures a second. The
# node between the camera and the neck is missing. It finds the ball in each picture, and says in which direction it
# lies. If it reports a ball that is not there, the robot reaches into the void. So the node must also say when there
# is no ball.
#
# **About 45 minutes · difficulty 4 of 5 · 10 points.** You need lesson [15](../notebooks/15_camera.ipynb).
#
# ## What to build
#
# One program that is spun until Ctrl-C ends it.
#
# | topic | type | your node | content |
# |---|---|---|---|
# | `/camera/image` | `Image` | listens | 30 pictures a second, 160 columns by 120 rows |
# | `/robot/ball_direction` | `Vector3Stamped` | speaks | for each picture that it can read, one direction |
#
# `Image` is in `sensor_msgs.msg`, `Vector3Stamped` in `geometry_msgs.msg`.
#
# **The scene.** The ball is orange. On the desk there are also a blue ball and a brick that is just as orange as the
# ball. The brick lies anywhere: farther away than the ball, or nearer. The robot's own gray hands come into view. The
# light changes between bright and dim (40 % as bright), and gets a little warmer or colder. There is at most one orange
# ball, and it is never partly hidden. It is at least 11 pixels wide.
#
# **The camera.** It follows the pinhole model, with a focal length of 140 pixels. Column 79.5, row 59.5 looks straight
# ahead, where (0, 0) is the middle of the pixel at the upper left.
#
# | your node | so that |
# |---|---|
# | publishes the direction of the ball as a vector of length 1 | x to the right, y down, z forward; the length is within 0.02 |
# | is right | each direction is within 1.0° of the middle of the ball |
# | says "no ball" where there is none | the vector is (0, 0, 0) |
# | keeps the stamp of the picture | each answer has the header's stamp of its picture |
# | keeps up with 30 pictures a second | at least 80 % of them are answered, each once; typically within 0.1 s, and nine of ten within 0.4 s |
# | reads `rgb8` and `bgr8` | the order of the colors is that of the encoding; it may change from picture to picture |
# | obeys `step` | the rows of some pictures have 32 unused bytes at their end |
# | refuses every other encoding | nothing is published for the picture, a line in the log names the encoding, and the node lives on |
#
# ## What is judged
#
# Your program runs as a process of its own. The judge is the camera: it publishes 195 pictures that you have not seen,
# of the kind above. Some are encoded as something else. It knows where the ball is, and compares.
#
# | points | criterion |
# |---:|---|
# | 1 | it listens to `/camera/image`, with the type `Image`, and `/robot/ball_direction` carries `Vector3Stamped` |
# | 1 | each direction has the stamp of its picture, and each picture has one direction |
# | 1 | it keeps up with 30 pictures a second |
# | 1 | it refuses other encodings with a line in the log, and lives on |
# | 2 | in good light, an `rgb8` picture leads to the right direction |
# | 1 | the same in changing light |
# | 1 | the same for `bgr8` |
# | 1 | the same for rows with padding |
# | 1 | where there is no ball, it says so |
#
# "Good light" means bright light and no padding. Changing light and padding are judged only when the direction is
# right in good light. Padding is judged in both encodings. But in `bgr8` it counts only when the direction is right for
# `bgr8` without padding.
#
# **Not part of it:** how far away the ball is, lenses, a ball that is partly hidden, and how your program ends.
# %% [answer]
"""Looks at the pictures of a camera, and publishes in which direction the orange ball lies."""

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
CENTER = (79.5, 59.5)  # column and row that look straight ahead
# [solution]
ORANGE = ((4, 130, 35), (22, 255, 255))  # hue (0 to 180), saturation, brightness
TO_HSV = {"rgb8": cv2.COLOR_RGB2HSV, "bgr8": cv2.COLOR_BGR2HSV}
SMALLEST = 25  # pixels
ROUND = 0.75  # share of the smallest circle around it that a ball fills
# [end]


def find_ball(image: Image) -> tuple[float, float] | None:
    """Column and row of the middle of the ball; None if there is no ball in the picture."""
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
    # | # TODO 1: turn image.data into pixels; mind image.step and image.encoding
    # | # TODO 2: find what is orange, and which part of that is round
    # | return CENTER
    # [end]


def direction(column: float, row: float) -> list[float]:
    """Where a pixel looks: a vector of length 1; x to the right, y down, z forward."""
    # [solution]
    x, y = (column - CENTER[0]) / FOCAL, (row - CENTER[1]) / FOCAL
    length = math.sqrt(x * x + y * y + 1.0)
    return [x / length, y / length, 1.0 / length]
    # [starter]
    # | # TODO 3: the pinhole model
    # | return [0.0, 0.0, 1.0]
    # [end]


class BallTracker(Node):
    """Says for each picture in which direction the ball lies.

    Subscriptions:
        /camera/image (sensor_msgs/Image): pictures, rgb8 or bgr8.

    Topics:
        /robot/ball_direction (geometry_msgs/Vector3Stamped): a vector of length 1, or (0, 0, 0) for no ball.
    """

    def __init__(self) -> None:
        super().__init__("ball_tracker")
        self.publisher = self.create_publisher(Vector3Stamped, "/robot/ball_direction", 10)
        self.create_subscription(Image, "/camera/image", self.on_image, qos_profile_sensor_data)

    def on_image(self, image: Image) -> None:
        """Find the ball in one picture, and publish its direction at once."""
        # [solution]
        if image.encoding not in TO_HSV:
            self.get_logger().error(f"I cannot read {image.encoding}", throttle_duration_sec=1.0)
            return
        # [starter]
        # | # TODO 4: refuse an encoding that you cannot read
        # [end]
        answer = Vector3Stamped(header=image.header)
        ball = find_ball(image)
        # [solution]
        if ball is not None:
            answer.vector.x, answer.vector.y, answer.vector.z = direction(*ball)
        # [starter]
        # | # TODO 5: what is published where there is no ball?
        # | answer.vector.x, answer.vector.y, answer.vector.z = direction(*ball)
        # [end]
        self.publisher.publish(answer)


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or a request to end, then leave with exit code 0."""
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
# from lesson_nodes import head_camera
# from lesson_nodes.ball_scope import BallScope
# from workbook.lesson import fresh, init, run, start, stop
# from workbook.pictures.figures import figure, show
#
# %start
# start(head_camera, width=160)
# init()
# scope = fresh(BallScope)  # writes down the pictures, and the directions that your node publishes
# await run(scope, seconds=10, until=lambda: len(scope.directions) >= 60)
# stop(head_camera)
# print("pictures:", len(scope.pictures), "directions:", len(scope.directions))
# if scope.pictures:
#     fig, axes = figure(4.2, 3.2)
#     stamp, picture = scope.pictures[-1]
#     axes.imshow(picture)
#     ball = dict(scope.directions).get(stamp)
#     if ball is not None and ball[2] > 0:
#         axes.plot(79.5 + 140 * ball[0] / ball[2], 59.5 + 140 * ball[1] / ball[2], "+", color="white", ms=16)
#     axes.grid(False)
#     show(fig, "the last picture of the camera, with a cross where your node sees the ball")
# %% [hint]
# Take one picture first. How many bytes does a row of it have, and how many of them are pixels? Then ask what makes an
# orange pixel orange: not its brightness, because that changes with the light. And what makes a ball a ball, and not a
# brick?
#
# What OpenCV can do with colors: [Changing colorspaces](https://docs.opencv.org/4.x/df/d9d/tutorial_py_colorspaces.html)
# %% [hint]
# - `np.frombuffer(image.data, np.uint8).reshape(image.height, image.step)` has one row for each row of the picture,
#   padding included. Cut the padding off, then reshape to `(height, width, 3)`.
# - `cv2.cvtColor(pixels, cv2.COLOR_RGB2HSV)` separates hue and saturation from brightness. There is a constant for BGR,
#   too.
# - `cv2.inRange` marks the pixels in a range, `cv2.findContours` their outlines.
# - A ball fills most of the smallest circle around it (`cv2.minEnclosingCircle`). A brick does not.
# - A new `Vector3Stamped` already says "no ball". Its header comes from the picture.
#
# What `step` means: [sensor_msgs/Image](https://docs.ros.org/en/jazzy/p/sensor_msgs/msg/Image.html)
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
# - **NumPy alone.** `red > 1.8 * green` and `green > 1.8 * blue` compare colors by their ratios, which hardly change
#   with the light. Connected pixels are then found with `scipy.ndimage.label`.
# - **Other color spaces.** In Lab or YCrCb, brightness has a channel of its own, too.
# - **Another measure of roundness.** 4π · area / perimeter² is 1 for a circle; a comparison of width and height is
#   coarser, but enough for this brick.
# - **A search near the last place.** It is faster, and it can go on for a while when the ball is hidden. But then the
#   node must notice that it has lost the ball.
# - **A small neural network** finds balls that no rule describes. Lesson 16 does that.

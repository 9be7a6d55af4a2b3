# ---
# exercise: 16_ai_model
# title: A robot that sees toys and reports a fall
# minutes: 45
# difficulty: 4
# kind: program
# clock: wall
# objectives:
#   - running a slow model without delaying other callbacks
#   - processing only the newest image, and giving each detection its image's stamp
#   - giving a model pixels in the color order that it was trained on
#   - keeping a node running when its model raises an exception
# out_of_scope:
#   - training a model, or a faster one (`SlowDetector` stays as it is)
#   - where the toys are in the room, and tracking them from image to image
#   - getting up after a fall
#   - how the program ends (lesson 01 judges that)
# ---
# %% [markdown]
# # Exercise 16 · A robot that sees toys and reports a fall
#
# Your robot is clearing a desk. A neural network finds the toys on the desk, but the network takes {{MODEL_S}} s per
# image. The camera publishes {{CAMERA_HZ}} images a second, and the rest of the robot can't wait for the network. A
# heartbeat must be published ten times a second, and a fall must be reported within half a second. We provide the
# network, and you write the node around it.
#
# **About 45 minutes · difficulty 4 of 5 · 10 points.** This exercise builds on lesson [16](../notebooks/16_ai_model.ipynb).
#
# ## An example
#
# Here's what a working node does in its first 0.6 s. Image 1 is stamped 512.000 s, and a new image arrives every 0.033
# s. Image 7 is washed out by glare.
#
# | time | event | `/robot/detections` |
# |---:|---|---|
# | 0.00 s | image 1 arrives, and the node passes it to the model | |
# | 0.20 s | the model returns its detections, and the node passes it image 7, which is now the newest | ball, cup, plate, and two bricks, stamped 512.000 s |
# | 0.40 s | the model raises `RuntimeError` for image 7, and the node passes it image 13, which is now the newest | nothing, but the log says `glare: 97% of the picture is white` |
# | 0.60 s | the model returns its detections | the toys in image 13, stamped 512.400 s |
#
# Throughout this time, the node publishes `operational` on `/robot/status` every 0.1 s. If ten IMU samples in a row
# show a tilt of more than {{TILT_DEG}}°, the node publishes `error` from the next heartbeat on.
#
# ## What to build
#
# Write one program that spins until it's interrupted with Ctrl-C.
#
# | topic | type | your node | content |
# |---|---|---|---|
# | `/camera/image` | `Image` | subscribes | {{CAMERA_HZ}} images a second, 160 columns by 120 rows, in `bgr8`, without padding |
# | `/robot/imu` | `Imu` | subscribes | {{IMU_HZ}} samples a second; at rest, `linear_acceleration` points up and has a magnitude of 9.81 m/s² |
# | `/robot/detections` | `MarkerArray` | publishes | one message for each image in which the model has detected toys, with a marker for each detection |
# | `/robot/status` | `String` | publishes | the heartbeat, 10 Hz: `operational`, or `error` after a fall |
#
# `Image` and `Imu` are in `sensor_msgs.msg`, and `MarkerArray` is in `visualization_msgs.msg`. The judge's publishers
# offer reliable, volatile QoS with a queue depth of 100.
#
# The starter code subscribes to images with a queue depth of 10. As lesson 16 shows, with a queue that deep, the
# detections are out of date by the time they're published. We left it that way on purpose, because choosing the queue
# depth is part of your task.
#
# **The model** that we provide is `SlowDetector`. It finds orange toys: balls, bricks, cups, and plates. It expects RGB
# pixels (`uint8`). While it waits for its accelerator, it doesn't hold the GIL, so your program's other threads keep
# running. Loading it takes one second. If an image is washed out by glare, the model raises `RuntimeError`. You may
# call the model from several threads, but it processes one image at a time. A second call has to wait for the first,
# and the second image gets older in the meantime. So calling the model from two threads at the same time would only
# make the detections older. We also provide `to_markers` and `tilt`.
#
# **The desk.** Each image shows a ball, a cup, a plate, and two bricks, so an empty `MarkerArray` is never right.
# There's also a blue ball on the desk, but it doesn't count as a toy.
#
# **The stamps** come from the sensors' own clock. Compare them with each other, not with your program's clock.
#
# | your node | what that means |
# |---|---|
# | keeps the heartbeat regular | the heartbeat is published ten times a second, without gaps |
# | publishes fresh detections | each message is published soon after its image, even after a fall |
# | doesn't guess | each detection comes from `SlowDetector`, which takes {{MODEL_S}} s |
# | stamps each detection with its image's stamp | each message has its image's stamp, there's only one message per image, and the messages are in the same order as the images |
# | detects correctly | each message has the right toys in the right places |
# | survives the model's exceptions | if the model raises an exception, your node publishes nothing for that image, not even an empty message. It logs the exception's text and continues with the newest image |
# | reports a fall | if ten samples in a row show a tilt of more than {{TILT_DEG}}°, the status changes to `error` |
# | raises no false alarm | it never publishes `error` before the fall: a jolt that lasts nine samples isn't a fall, and neither is leaning by 55° |
# | remembers the fall | after the first `error`, it never publishes `operational` again, even if someone sets the robot upright |
#
# ## What is judged
#
# Your program runs in its own process for about twelve seconds of real time. The judge stands in for the camera and the
# IMU. It sends {{PICTURES}} images that you haven't seen. Glare washes out the images for 1.2 s in total. The judge
# compares your node's messages with the actual toys and the actual time of the fall.
#
# | points | criterion |
# |---:|---|
# | 1 | your node subscribes to `/camera/image` with the type `Image`, and `/robot/detections` carries `MarkerArray` messages |
# | 1 | the heartbeat continues, even while the model is running |
# | 1 | each detection has its image's stamp, and there's only one message per image, in order |
# | 2 | the detections are fresh and come from `SlowDetector` |
# | 2 | the detections are correct |
# | 1 | your node keeps working after the model raises an exception |
# | 2 | `/robot/status` reports `error` after the fall, but not before, and never goes back to `operational` |
#
# **Not judged:** training a model, locating toys in the room (rather than in the image), getting up after a fall, and
# how your program ends. The judge reads only three of a marker's fields: `header`, `ns` (the label), and
# `pose.position` (x: column, y: row).
#
# **Tolerances**
#
# | requirement | passes if |
# |---|---|
# | heartbeat | from the first heartbeat on, the number of heartbeats is {{LEAST_BEATS %}} to {{MOST_BEATS %}} of the number expected at 10 Hz. The heartbeat never pauses for more than {{LONGEST_SILENCE_S}} s |
# | fresh | at least half of the messages are published within {{TYPICALLY_S}} s of their image, and at least nine out of ten within {{MOSTLY_S}} s |
# | often | except during the glare, the node publishes detections for at least {{LEAST_HZ}} images a second, even after a fall |
# | not guessed | each message is published at least {{SOONEST_S}} s after its image |
# | correct | at least {{RIGHT_SHARE %}} of the messages are correct. In a correct message, every toy that's at least {{WHOLE %}} visible has a marker with the toy's label within {{WITHIN_PIXELS}} pixels of the toy's center. Less visible toys may have a marker, too, but nothing else may have one |
# | continues | the node publishes detections again within {{PAUSE_S}} s of the end of the glare |
# | fall | the first `error` is published within {{FALL_WITHIN_S}} s of the tenth tilted sample in a row |
# %% [answer]
"""Detect toys with a slow model, keep the heartbeat regular, and report when the robot has fallen."""

import math
# [solution]
import queue
import threading
from contextlib import suppress
# [end]

import numpy as np
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import Image, Imu
from std_msgs.msg import Header, String
from visualization_msgs.msg import Marker, MarkerArray

from workbook.models import Detection
from workbook.models.slow import SlowDetector

TILT_DEG = 60.0  # a sample with more tilt than this counts as tilted
TILTED_SAMPLES = 10  # after this many in a row, the robot has fallen


def to_markers(found: list[Detection], header: Header) -> MarkerArray:
    """Return a marker for each detection, with its image's header. This function is complete."""
    message = MarkerArray()
    for number, one in enumerate(found):
        marker = Marker(header=header, ns=one.label, id=number)
        marker.pose.position.x, marker.pose.position.y = float(one.u), float(one.v)  # pixels
        marker.scale.x, marker.scale.y = float(one.width), float(one.height)
        marker.color.a = float(one.score)
        message.markers.append(marker)
    return message


def tilt(sample: Imu) -> float:
    """Return the robot's tilt (°): 0 is upright, and 90 is lying on its side. This function is complete."""
    up = sample.linear_acceleration
    return math.degrees(math.atan2(math.hypot(up.x, up.y), up.z))


class DeskWatcher(Node):
    """Publishes the toys on the desk, and whether the robot has fallen.

    Subscriptions:
        /camera/image (sensor_msgs/Image): images, bgr8.
        /robot/imu (sensor_msgs/Imu): acceleration in m/s², 50 Hz.

    Topics:
        /robot/detections (visualization_msgs/MarkerArray): a message per image, with a marker for each toy.
        /robot/status (std_msgs/String), 10 Hz: "operational", or "error" after a fall.
    """

    def __init__(self) -> None:
        super().__init__("desk_watcher")
        self.model = SlowDetector()  # takes a second
        self.detection_publisher = self.create_publisher(MarkerArray, "/robot/detections", 10)
        self.status_publisher = self.create_publisher(String, "/robot/status", 10)
        # [solution]
        self.newest: queue.Queue[Image] = queue.Queue(maxsize=1)
        self.tilted = 0  # samples in a row
        self.fallen = False
        self.create_subscription(Image, "/camera/image", self.on_image, 1)
        # [starter]
        # | self.create_subscription(Image, "/camera/image", self.on_image, 10)
        # [end]
        self.create_subscription(Imu, "/robot/imu", self.on_imu, 10)
        self.create_timer(0.1, self.beat)
        # [solution]
        threading.Thread(target=self.look, daemon=True).start()
        # [starter]
        # | # TODO 1: call the model where it doesn't delay the timer and the IMU callback
        # [end]

    def on_image(self, image: Image) -> None:
        # [solution]
        """Store the newest image, and discard the previous one if it's still waiting."""
        with suppress(queue.Empty):
            self.newest.get_nowait()
        self.newest.put_nowait(image)
        # [starter]
        # | """Detect the toys in an image."""
        # | # TODO 2: process only the newest image
        # | self.answer(image)
        # [end]

    # [solution]
    def look(self) -> None:
        """Process the newest image, again and again, in a separate thread."""
        while rclpy.ok():
            self.answer(self.newest.get())

    # [end]
    def answer(self, image: Image) -> None:
        """Publish the model's detections in an image."""
        pixels = np.frombuffer(image.data, np.uint8).reshape(image.height, image.width, 3)
        # [solution]
        try:
            found = self.model(pixels[:, :, ::-1])  # from BGR to RGB
        except RuntimeError as error:
            self.get_logger().error(f"The model gave up: {error}")
            return
        # [starter]
        # | # TODO 3: which color order does the model expect? And what if it raises RuntimeError?
        # | found = self.model(pixels)
        # [end]
        self.detection_publisher.publish(to_markers(found, image.header))

    def on_imu(self, sample: Imu) -> None:
        """Detect a fall."""
        # [solution]
        self.tilted = self.tilted + 1 if tilt(sample) > TILT_DEG else 0
        self.fallen = self.fallen or self.tilted >= TILTED_SAMPLES
        # [starter]
        # | # TODO 4: count the tilted samples in a row, and remember a fall
        # [end]

    def beat(self) -> None:
        """Publish the status, ten times a second."""
        # [solution]
        self.status_publisher.publish(String(data="error" if self.fallen else "operational"))
        # [starter]
        # | # TODO 5: "error" after a fall
        # | self.status_publisher.publish(String(data="operational"))
        # [end]


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(DeskWatcher())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
# %% [hint]
# First, find out which callback waits for which. How long does the model take, and which thread runs it? Which other
# callbacks does that thread run? Then think about the images that arrive in that time. Which of them should the model
# process next?
#
# Lesson [10](../notebooks/10_slow_callbacks.ipynb) shows a slow callback and a heartbeat in one node.
# %% [hint]
# - A separate thread calls the model in a loop: take the newest image, detect, publish. Or give the image callback its
#   own callback group, and spin with a `MultiThreadedExecutor`.
# - `queue.Queue(maxsize=1)` holds one image. Before you put in a new image, take out the old one.
# - Pass the whole message to the thread. Then pixels and header stay together.
# - `pixels[:, :, ::-1]` turns BGR into RGB.
# - Put `try: … except RuntimeError as error:` around the model call, inside the loop.
# - Count tilted samples in a row: add one for a tilted sample, and reset to 0 for an upright one.
#
# Python's queues: [queue](https://docs.python.org/3/library/queue.html)
# %% [hint]
# The steps, with gaps:
#
# ```python
# def on_image(self, image):
#     with suppress(queue.Empty):
#         self.newest.___()
#     self.newest.put_nowait(image)
#
# def look(self):  # in threading.Thread(target=self.look, daemon=True)
#     while rclpy.ok():
#         image = self.newest.get()
#         pixels = np.frombuffer(image.data, np.uint8).reshape(image.height, image.width, 3)
#         try:
#             found = self.model(pixels[___])
#         except RuntimeError as error:
#             self.get_logger().error(f"The model gave up: {error}")
#             ___
#         self.detection_publisher.publish(to_markers(found, ___))
#
# def on_imu(self, sample):
#     self.tilted = self.tilted + 1 if tilt(sample) > TILT_DEG else ___
#     self.fallen = ___ or self.tilted >= TILTED_SAMPLES
# ```
# %% [alternatives]
# ## Other good ways
#
# - **A callback group and two threads.** Use `MultiThreadedExecutor(num_threads=2)`, with the camera subscription in a
#   `MutuallyExclusiveCallbackGroup` and a queue depth of 1. Then DDS itself keeps the newest image. This is shorter,
#   but rclpy's executor polls while the model is running and keeps a CPU core busy.
# - **A separate process.** If the model holds the GIL, threads don't help. A `ProcessPoolExecutor` with one worker
#   does, but it copies images and results.
# - **Two nodes.** One detects toys and one watches for falls, each in its own process. A model crash can't stop the
#   heartbeat. Robots in production work like this.
# - **A timer that takes the newest image** is simple, but the model is idle between two ticks.
# - **A time limit.** A model can also hang. Which code notices that, and after how long? A separate status, such as
#   "blind", would report it.

# %% [markdown]
# # 15 · Deeper: bytes and queues
#
# How much bandwidth does a camera need, and what happens if a subscriber can't keep up?
#
# - **Minutes:** 10
# - **You need:** lesson [15](15_camera.ipynb)
# - **You will be able to:** choose between raw and compressed images, and explain why a slow subscriber receives old
#   images
# - **Not covered:** video codecs

# %% [markdown] prediction="how-much-smaller"
# ## Predict
#
# At 30 Hz, raw images of 921,600 bytes (without padding) add up to 27.6 MB/s. A `CompressedImage` carries a JPEG
# instead. At quality 80, how many times smaller than the raw images are the JPEGs of our desk?
#
# - **a** More than 8 times.
#   when `smaller > 8`
#   ✓ JPEG drops detail that the eye hardly notices. The price is time to encode and decode, and a small error in every
#   color.
# - **b** 2 to 8 times.
#   when `smaller <= 8 and smaller >= 2`
#   ✗ JPEG does better, because it drops most of the noise. A lossless format such as PNG has to keep it.
# - **c** Barely smaller, because of the noise.
#   when `smaller < 2`
#   ✗ JPEG doesn't preserve the noise. That's why the image gets so small.

# %%
from workbook.lesson import predict

predict("how-much-smaller")

# %% [markdown]
# ## Run it
#
# The camera publishes the same frame over and over, so all raw images have the same size, and so do all JPEGs. We also
# record how old each image is by the time it's ready to use.

# %% id="weigh"
import time

import cv2
import numpy as np
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import CompressedImage, Image

from lesson_nodes import head_camera
from workbook.lesson import about, fresh, init, reveal, run, start, stop

images, sizes, ages = {}, {"raw": [], "JPEG": []}, {"raw": [], "JPEG": []}


def age_of(message):
    """How long ago an image was taken (s)."""
    stamp = message.header.stamp
    return time.time() - stamp.sec - stamp.nanosec / 1e9


def on_raw(message):
    values = np.frombuffer(message.data, np.uint8)
    images["raw"] = values.reshape(message.height, message.width, 3)
    sizes["raw"].append(len(message.data))
    ages["raw"].append(age_of(message))


def on_jpeg(message):
    coded = np.frombuffer(message.data, np.uint8)
    images["JPEG"] = cv2.imdecode(coded, cv2.IMREAD_COLOR)[..., ::-1]
    sizes["JPEG"].append(len(message.data))
    ages["JPEG"].append(age_of(message))


init()
print("started", start(head_camera, frozen=20, jpeg_quality=80))
scale = fresh(Node, "scale")
scale.create_subscription(Image, "/camera/image", on_raw, qos_profile_sensor_data)
scale.create_subscription(
    CompressedImage, "/camera/image/compressed", on_jpeg, qos_profile_sensor_data
)
await run(scale, seconds=50, until=lambda: min(map(len, sizes.values())) >= 40)
stop()

# %% id="raw-and-jpeg"
smaller = sizes["raw"][0] / sizes["JPEG"][0]
for kind in sizes:
    rate = 30 * sizes[kind][0] / 1e6
    age = about(1000 * np.median(ages[kind]), "ms", between=(1, 400))
    print(f"{kind + ':':<6}{rate:4.1f} MB/s, {age} old when usable")
png = cv2.imencode(".png", images["raw"])[1]
print(f"JPEG: {smaller:.0f} times smaller")
print(f"PNG:  {images['raw'].size / png.size:.1f} times smaller, nothing lost")
reveal("how-much-smaller", smaller=smaller)

# %%
from workbook.pictures import camera_figures as drawn
from workbook.pictures.figures import show

crops = [images[kind][170:250, 130:230] for kind in ("raw", "JPEG")]
show(
    drawn.side_by_side(crops, ["Raw: noisy", "JPEG: smooth"], height=3.0),
    "the ball twice: grainy in the raw image, smooth in the JPEG",
)

# %% [markdown]
# This compression ratio is specific to our synthetic desk scene, which consists mostly of smooth surfaces; expect a
# lower one in a cluttered room. The raw images' 27.6 MB/s is equal to about 220 Mbit/s, more than many Wi-Fi networks
# can carry.

# %% [markdown]
# ## Look inside
#
# ### A slow subscriber
#
# Lesson 16's detector takes 0.2 s per image, six times the interval between images. Here, its subscription has a queue
# depth of 30. A fast viewer subscribes to the same camera.

# %% id="slow-subscriber"
from lesson_nodes import toy_detector
from lesson_nodes.toy_scope import ToyScope

viewer_ages, arrivals = [], []


def view(image):
    viewer_ages.append(age_of(image))
    arrivals.append(time.monotonic())


start(head_camera, width=160)
start(toy_detector, depth=30)
detector = fresh(ToyScope)  # notes the age of the images that detections belong to
viewer = fresh(Node, "viewer")
viewer.create_subscription(Image, "/camera/image", view, qos_profile_sensor_data)
await run(viewer, detector, seconds=50, until=lambda: len(detector.ages) >= 20)
stop()
rate = (len(arrivals) - 1) / (arrivals[-1] - arrivals[0])
print("detector: images", about(detector.ages[-1], "s", between=(0.4, 8)), "old")
print(
    "viewer:   images",
    about(np.median(viewer_ages), "s", between=(0.0005, 0.3)),
    "old,",
    about(rate, "per second", between=(8, 40)),
)

# %% [markdown]
# `publish` never waits for a subscriber's callback, and each subscription has its own queue. So the detector receives
# old images, while the viewer receives fresh ones. This makes the problem hard to spot, because everything but the
# detector looks fine.
#
# **Your turn.** The detector's queue is full: 30 images are waiting. How much older is the oldest image than the
# newest?

# %% id="your-queue"
from workbook.lesson import yours

DEPTH, PERIOD_S = 30, 1 / 30
queue_spans_s = ...  # TODO: from DEPTH and PERIOD_S, in seconds

yours(queue_spans_s, 29 / 30, "30 images have 29 intervals between them.")

# %% [markdown]
# The fix is a queue depth of 1. You might expect reliable QoS to help, too, but it wouldn't. DDS acknowledges an image
# when it enters the queue, not when your callback has handled it. So a slow callback doesn't make the camera resend
# anything. In our test on the loopback interface, no packets were lost, so there was nothing to resend. The camera sent
# as many image bytes with reliable QoS as with best effort.

# %% [markdown]
# ## Take away
#
# - Compression ratios depend on the scene. Measure yours, and check that your color thresholds still work.
# - Each subscription has its own queue, so a slow subscriber doesn't delay the images that other processes receive.
#
# **Before:** [15 · A camera](15_camera.ipynb)
#
# **Next:** [16 · An AI model in a node](16_ai_model.ipynb)
#
# **More:** [sensor_msgs/CompressedImage](https://docs.ros.org/en/jazzy/p/sensor_msgs/msg/CompressedImage.html)

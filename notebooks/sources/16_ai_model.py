# %% [markdown]
# # 16 · An AI model in a node
#
# A neural network can distinguish objects that all look the same to a color threshold. But it takes time, and the world
# doesn't wait for it. How old are the network's results when the robot uses them?
#
# - **Minutes:** 45
# - **You need:** lessons [10](10_slow_callbacks.ipynb) and [15](15_camera.ipynb)
# - **You will be able to:**
#   - run a trained network in a node
#   - work out how old the network's outputs are
#   - catch faults that raise no error
# - **Not covered:** how networks learn, graphics cards, tracking objects from image to image

# %% [markdown]
# Everything on this desk is orange: a ball, a cup, a plate, and a brick. They can't be distinguished by color, so
# lesson 15's tracker would fail. But a small neural network can tell them apart. In the clip, watch the box around the
# ball.

# %%
from lesson_nodes import toy_camera, toy_detector
from lesson_nodes.toy_scope import ToyScope
from workbook.lesson import fresh, init, run, start, stop
from workbook.lesson.films import show_film
from workbook.lesson.toys import boxed

init()


async def watch(number=0, frames=0, **parameters):
    """A scope that has seen so many outputs of the detector, and film frames."""
    start(toy_detector, **parameters)
    scope = fresh(ToyScope)
    await run(
        scope,
        seconds=58,
        until=lambda: len(scope.ages) >= number and len(scope.film) >= frames,
    )
    stop(toy_detector)
    scope.destroy_node()
    return scope


print("started", start(toy_camera, width=320))
first = await watch(frames=54)
show_film(
    [boxed(picture, found) for picture, found in first.film],
    "four orange toys in labeled boxes; the ball rolls, its box is a little late",
)

# %% [markdown]
# The boxes around the cup, the plate, and the brick fit well. The ball's box lags behind, because the ball keeps
# rolling while the network is running. Our network is small and needs only a few milliseconds. To imitate a large one,
# the node takes 0.2 s per image and sleeps for most of that time.
#
# [the same without helpers: init, start, fresh, run]

# %% [markdown] prediction="box-at-depth-10"
# ## Predict
#
# In the clip, the detector's subscription had a queue depth of 1. A colleague changes it to 10, the depth in most
# examples. Each second, 30 images arrive, but the detector handles only five. How far does the box now lag behind the
# ball, compared with the first clip?
#
# - **a** About ten times as far: ten images wait instead of one.
#   when `far >= 4 * near`
#   ✗ The queue keeps the newest ten images. At 30 Hz, the oldest of them is only a third of a second old, not ten times
#   0.2 s.
# - **b** About as far as before: the network takes 0.2 s, whatever the depth.
#   when `far < 1.4 * near`
#   ✗ The network takes as long as before, but its input is older: each image has been in the queue for a third of a
#   second.
# - **c** About twice as far.
#   when `far >= 1.4 * near and far < 4 * near`
#   ✓ The network gets the oldest of the ten images in the queue. At 30 Hz, that image has waited for a third of a
#   second. Then the network takes its 0.2 s, as before.

# %%
from workbook.lesson import predict, reveal

predict("box-at-depth-10")

# %% [markdown]
# ## Run it

# %%
second = await watch(frames=54, depth=10)
show_film(
    [boxed(picture, found) for picture, found in second.film],
    "the same four toys in labeled boxes, with a queue depth of 10",
)

# %% [markdown]
# How far does the box lag behind? To find out, we run the same network again on each image of the two clips, this time
# without a delay.

# %% id="how-far-behind"
from statistics import mean

from workbook.models import DeskDetector

detector = DeskDetector()


def column_of_ball(detections):
    """Where the ball is (pixels); None without a ball."""
    return next((one.u for one in detections if one.label == "ball"), None)


def behind(film):
    """How many pixels the box is beside the ball, on average."""
    pairs = [
        (column_of_ball(found), column_of_ball(detector(picture)))
        for picture, found in film
    ]
    return mean(abs(box - ball) for box, ball in pairs if box and ball)


near, far = behind(first.film), behind(second.film)
reveal("box-at-depth-10", near=near, far=far)

# %% [markdown]
# ## Look inside
#
# For a robot, the important number is the **age of an output**: the time since the image behind that output was taken.
# The detector copies the image's stamp into its message, so every subscriber can compute that age.
#
# Here's the node (`lesson_nodes/toy_detector.py`). It loads the network once, in `__init__`, and calls it like a function.

# %%
import inspect

print(inspect.getsource(toy_detector.ToyDetector.look))
print(inspect.getsource(toy_detector.ToyDetector.answer))

# %% [markdown]
# The node publishes each detection as a *marker* with the image's header. The marker's `ns` holds the label, and its
# position is in pixels. The option `stamps_now` switches on a deliberate fault. You'll see its effect under *When it
# goes wrong*.
#
# The network takes `float32` values from 0 to 1, not bytes from 0 to 255. In its input array, the color axis comes
# before the rows and columns, not after them. The size is always 160 by 120 pixels. The library that runs the network,
# **ONNX Runtime**, rejects any other data type or shape. But it checks neither the range of the values nor the order of
# the colors.

# %% id="input"
from workbook.lesson import about
from workbook.models.detector import to_input

picture = first.film[-1][0]
numbers = to_input(picture)
print("a picture:", picture.shape, picture.dtype)
top = about(numbers.max(), between=(0.5, 1.0))
print("for the network:", numbers.shape, numbers.dtype, "up to", top)
print("found:", sorted(one.label for one in detector(picture)))

# %% [markdown]
# **Where the network comes from.** We trained it with PyTorch on images of random desks, rendered as lesson 15's camera
# would see them (`workbook/models/train.py`). The network was saved in the ONNX format, and ONNX Runtime runs it
# without PyTorch. A second file holds the network's *provenance*: how it was made, and how accurate it is on images
# that it wasn't trained on.

# %% id="provenance"
import tomllib

from workbook.models.networks import PROVENANCE_FILE

made = tomllib.loads(PROVENANCE_FILE.read_text())
print(made["training"]["images"], "pictures, seed", made["training"]["seed"])
print(f"right on held-back pictures: {made['accuracy']['reached']:.1%}")
print("SHA-256 of the file:", made["sha256"]["desk_detector.onnx"][:12], "...")

# %% [markdown]
# `make model` trains the network again in less than five minutes. You can also run the same network with other
# libraries. After `make env EXTRAS=torch`, `DeskDetector(TorchNetwork())` uses PyTorch. With `EXTRAS=tensorflow`,
# `DeskDetector(KerasNetwork())` uses Keras. Both classes are in `workbook.models.networks`, and you don't need to
# change the node to use them.

# %% [markdown] prediction="age-at-depth-1"
# ## Change it
#
# ### Experiment 1: the depth of the queue
#
# The network takes 0.2 s per image, and an image arrives every 0.033 s. With a depth of 1, how old is a typical output?
#
# - **a** 0.03 s: the network always gets the newest image.
#   when `age < 0.2`
#   ✗ The image was the newest one when the network started. The output is older, because the network then took 0.2 s.
# - **b** A little more than 0.2 s.
#   when `age >= 0.2 and age < age_at_10`
#   ✓ Each new image replaces the waiting one. So the image is at most 0.033 s old when the network starts.
# - **c** 0.4 s: each image waits until the network has finished the previous one.
#   when `age >= age_at_10`
#   ✗ While the network is running, new images keep replacing the one in the queue. So the waiting image is always
#   fresh.

# %%
predict("age-at-depth-1")

# %%
from statistics import median

DEPTHS = (1, 5, 10, 50)
start(toy_camera)  # smaller pictures from here on
scopes = {depth: await watch(number=22, depth=depth) for depth in DEPTHS}
age = {depth: median(scope.ages[-6:]) for depth, scope in scopes.items()}
print("outputs of each depth:", min(22, *(len(one.ages) for one in scopes.values())))
reveal("age-at-depth-1", age=age[1], age_at_10=age[10])

# %% id="older-with-depth"
USUAL = {1: (0.2, 0.4), 5: (0.25, 0.6), 10: (0.35, 0.9), 50: (1.0, 3.0)}
for depth in DEPTHS:
    print(f"depth {depth:2}:", about(age[depth], "s old", between=USUAL[depth]))

# %%
from workbook.pictures.figures import figure, show

fig, axes = figure(7.0, 3.0)
height = -1.0
for depth, scope in scopes.items():
    axes.plot(scope.ages[:22], marker=".", color="#2f78d0")
    height = max(scope.ages[21], height + 0.17)  # labels must not touch
    axes.annotate(f"depth {depth}", (21.4, height), va="center")
axes.set_title("A deep queue makes old outputs")
axes.set(xlabel="output", ylabel="age (s)", ylim=(0, None), xlim=(-0.5, 25))
show(
    fig,
    "the age of 22 outputs for four depths: flat and low for 1, "
    "a little higher for 5 and 10, and a slope up to a high level for 50",
)

# %% [markdown]
# Once the queue is full, each new image waits behind the others. Whenever a new image arrives, a full queue drops its
# oldest one, so it always holds the newest *n* images. At 30 Hz, these span *n*/30 s, so an image that reaches the
# network has waited about that long. With a depth of 50, the queue takes about two seconds to fill, so a shorter test
# doesn't reveal the problem. The outputs keep getting older until the queue is full.

# %% [markdown] prediction="thread"
# ### Experiment 2: a thread for the newest image
#
# A timer in the node is set to publish a heartbeat ten times a second. But while the network runs in another callback
# of this node, only about five heartbeats a second are published. Suppose that this callback just stores the newest
# image instead, and a separate thread runs the network. What changes?
#
# - **a** The heartbeat becomes regular. The outputs are as old as before.
#   when `beats >= 1.3 * beats_before and age >= 0.2`
#   ✓ With the network in its own thread, the executor can run the other callbacks on time. The network itself doesn't
#   get faster.
# - **b** The outputs get much fresher. The heartbeat stays as it is.
#   when `beats < 1.3 * beats_before and age < 0.2`
#   ✗ The network still takes 0.2 s. The only change is that the other callbacks don't have to wait for it.
# - **c** Both: a regular heartbeat and much fresher outputs.
#   when `beats >= 1.3 * beats_before and age < 0.2`
#   ✗ The network alone takes 0.2 s, so no output can be fresher than that.

# %%
predict("thread")

# %%
print(inspect.getsource(toy_detector.ToyDetector.keep_newest))
print(inspect.getsource(toy_detector.ToyDetector.work))

# %% [markdown]
# `waiting` is a `queue.Queue(maxsize=1)`. The callback discards the previous image, if it's still there, and adds the
# new one. When the network is free, the thread takes the image from the queue. The thread handles its own exceptions,
# because otherwise they'd go unnoticed.

# %%
threaded = await watch(number=22, where="thread")


def beats_per_second(scope):
    return (len(scope.beats) - 1) / (scope.beats[-1] - scope.beats[0])


before, after = beats_per_second(scopes[1]), beats_per_second(threaded)
reveal("thread", beats=after, beats_before=before, age=median(threaded.ages))

# %% id="thread"
print("in the callback:", about(before, "beats a second", between=(2, 6.7)))
print("in a thread:    ", about(after, "beats a second", between=(6, 11)))
output_age = about(median(threaded.ages), "s old", between=(0.2, 0.5))
print("in a thread, outputs are", output_age)

# %%
from workbook.pictures.timeline import strip


def from_zero(beats):
    """The heartbeats of three seconds, the first one at 0."""
    return [t - beats[0] for t in beats if t - beats[0] < 3.0]


both = {"in callback": scopes[1], "in thread": threaded}
rows = {name: from_zero(scope.beats) for name, scope in both.items()}
show(
    strip(
        rows,
        periods=dict.fromkeys(rows, 0.1),
        end=3.0,
        title="A thread keeps the heartbeat regular (red: beats are missing)",
    ),
    "heartbeats: with gaps while the network is in the callback, regular with a thread",
)

# %% [markdown]
# A thread helps only if the network releases the **GIL**, the lock that lets only one thread at a time run Python code.
# Our node's `time.sleep` releases it. So do ONNX Runtime and PyTorch while they compute, but not every model does. The
# [deeper notebook](16_ai_model_deeper.ipynb) measures the effect of a model that holds the GIL.

# %% [markdown]
# ### Experiment 3: choosing a score threshold
#
# Each detection has a **score** from 0 to 1. The node drops detections whose score is below a *threshold* of 0.5.
# Sometimes a detection is wrong even though its score is above the threshold. Here are two images in which that
# happens. The first one was dark, so we brightened it for display. The blue ball gets no box, because the network was
# trained to find only orange toys.

# %%
import numpy as np

from workbook.lesson.toys import in_a_row
from workbook.models.accuracy import accuracy, held_back

dark, bright = held_back(43), held_back(220)
brighter = np.clip(2.2 * dark, 0, 255).astype(np.uint8)  # only for your eyes
plate = boxed(brighter, detector(dark), scores=True)
brick = boxed(bright, detector(bright), scores=True)
in_a_row(
    {
        "This plate is labeled “cup 0.55”": plate,
        "This brick is labeled “cup 0.59”": brick,
    },
    "two desks with boxes and scores: on the left, a plate half behind an arm has the "
    "label cup 0.55; on the right, a brick half behind an arm has the label cup 0.59",
)

# %% [markdown] prediction="threshold"
# In the first image, an arm hides half of a plate, and the network labels the plate as a cup. In the second image, the
# network mistakes a half-hidden brick for a cup. Suppose that you raise the threshold to 0.8 and test 200 images. How
# do the detections change?
#
# - **a** There are fewer wrong detections, and all of the correct ones remain.
#   when `lost <= 0`
#   ✗ Some correct detections have low scores, too. The higher threshold drops them as well.
# - **b** There are more wrong detections, because the network has to guess.
#   when `gained > 0`
#   ✗ A threshold can only remove detections. It never adds any.
# - **c** There are fewer wrong detections, but fewer correct ones, too.
#   when `lost > 0 and gained <= 0`
#   ✓ With a higher threshold, you get fewer wrong detections, but you miss more objects. Choose the threshold by asking
#   which mistake costs less.

# %%
predict("threshold")

# %% id="threshold"
LEVELS = (0.3, 0.5, 0.8)
good = {level: accuracy(DeskDetector(threshold=level), 200) for level in LEVELS}
for level, one in good.items():
    wrong = round(200 * one.false)
    print(f"threshold {level}: {one.found:.0%} of the toys found, {wrong} wrong")
reveal(
    "threshold",
    lost=good[0.5].found - good[0.8].found,
    gained=good[0.8].false - good[0.5].false,
)

# %% [markdown]
# A score isn't a probability: networks tend to be [more confident than they should
# be](https://arxiv.org/abs/1706.04599). To choose the threshold, use images that weren't used for training. Then
# consider the robot's task: for example, a hand that misses a cup does less harm than a hand that grabs someone's arm
# by mistake.

# %% [markdown]
# ## When it goes wrong
#
# Most faults in a model's input raise no exception.
#
# **The wrong color order or scaling.** Here's the same network on the same images: with correct input, with the colors
# read as `bgr8`, and with values up to 255.

# %% id="silently-wrong"
from workbook.models.networks import OnnxNetwork

network = OnnxNetwork()
as_it_is = accuracy(detector, 60).right
in_bgr = accuracy(detector, 60, lambda picture: picture[..., ::-1]).right
unscaled = accuracy(DeskDetector(lambda numbers: network(255 * numbers)), 60).right
for words, right in (
    ("right colors and scaling:", as_it_is),
    ("wrong color order:       ", in_bgr),
    ("numbers up to 255:       ", unscaled),
):
    print(words, f"{right:.0%} of the pictures right")

# %% [markdown]
# There's no error and no warning. So keep a few images with known content, and check the detector against them in a test.
#
# **Detections with the wrong stamp.** This detector stamps each output with the time at which the output is published.

# %% id="stamped-now"
stamped = await watch(number=8, stamps_now=True)
by_stamps = about(median(stamped.ages), "s old", between=(0, 0.15))
print("by their stamps, outputs are", by_stamps)

# %% [markdown]
# No output can be that fresh, because the network alone takes 0.2 s. But a subscriber has only the stamp, so it assumes
# that the ball is there *now*. Copy the image's header instead.
#
# **Loading the network every time the callback runs.** Large networks take seconds to load. To imitate that, we make
# ours take one second.

# %% id="loaded-each-time"
loading = await watch(number=4, loads_each_time=True, load_s=1.0)
stop()
print("outputs are", about(median(loading.ages), "s old", between=(1.0, 3.0)))

# %% [markdown]
# Load the network once, in `__init__`. If even that takes too long, load it in the thread, so that the heartbeat keeps
# going in the meantime.

# %% [markdown]
# ## From a worked example to your own
#
# **Worked example.** A ball rolls at 0.45 m/s. Given the ages that we measured, how far does the ball roll before the
# output is available?

# %% id="worked"
for depth, usual in ((1, (9, 18)), (50, (45, 135))):
    print(f"depth {depth:2}:", about(45 * age[depth], "cm", between=usual))

# %% [markdown]
# **Your turn.** A hand can grasp the ball if the result is at most 5 cm off. What's the oldest result that the hand can
# use?

# %% id="your-age"
from workbook.lesson import yours

oldest_s = ...  # TODO: from 5 cm and 45 cm/s

yours(oldest_s, 5 / 45, "Time is distance divided by speed.")

# %% [markdown]
# **Has the robot fallen?** In the exercise, your node also detects falls, and for that, it needs the IMU, a sensor in
# the torso. An `Imu` message holds the acceleration that this sensor measures. At rest, this acceleration is 9.81 m/s²
# and points up. If the robot is lying on its side, so is the sensor. Then the acceleration points along the sensor's x
# or y axis, not along z.

# %% id="tilt"
import math

from geometry_msgs.msg import Vector3
from sensor_msgs.msg import Imu


def tilt(sample):
    """How far the robot is tilted (°): 0 is upright, 90 lies on its side."""
    up = sample.linear_acceleration
    return math.degrees(math.atan2(math.hypot(up.x, up.y), up.z))


for pose, up in (
    ("upright", Vector3(z=9.81)),
    ("bowed", Vector3(x=6.94, z=6.94)),
    ("on its side", Vector3(y=9.81)),
):
    print(f"{pose + ':':<12} {tilt(Imu(linear_acceleration=up)):.0f}°")

# %% [markdown]
# A jolt can also make the robot look tilted for a sample or two. So count the samples that show a tilt, and report a
# fall only after several *in a row*. Reset the count at any sample that doesn't show one.
#
# **Your turn.** Complete the function. These samples contain a jolt that lasts two samples, and then a fall.

# %% id="your-fall"
def next_row(row, tilt_deg, limit_deg=60.0):
    """Count the tilted samples in a row; `row` is the count before this one."""
    return ...  # TODO: one more if this sample is tilted, otherwise 0


row, rows = 0, []
for tilt_deg in (3.0, 71.0, 75.0, 8.0, 5.0, 62.0, 80.0, 88.0, 90.0, 90.0):
    row = next_row(row, tilt_deg)
    rows.append(row)
yours(rows, [0, 1, 2, 0, 0, 1, 2, 3, 4, 5], "row + 1 if tilt_deg > limit_deg else 0")

# %% [markdown]
# **Fill in the blanks.** This function keeps only the newest image in a queue that has room for one item. Complete the
# line marked `TODO`.

# %%
from contextlib import suppress
from queue import Empty, Queue


def put_newest(waiting, picture):
    """Put a picture into a queue of length 1, and throw away the one in it."""
    with suppress(Empty):
        ...  # TODO: take the old one out, without waiting
    if waiting.full():
        return ...
    waiting.put_nowait(picture)
    return waiting.queue[0]


shelf = Queue(maxsize=1)
put_newest(shelf, "old")
yours(put_newest(shelf, "new"), "new", "waiting.get_nowait()")

# %% [markdown]
# **Your own.** In the [exercise](../exercises/16_ai_model.ipynb), you build a node around a slow model. It publishes fresh
# outputs, a steady heartbeat, and the status `error` if the robot falls.

# %% [markdown]
# ## Check yourself
#
# **1. The network takes 0.1 s, images arrive at 30 Hz, and the queue depth is 30. After the node has run for a minute, how old is an output?**
#
# <details><summary>a) About 0.1 s</summary>
#
# ✗ That would require a queue of one image.
#
# </details>
# <details><summary>b) About 1.1 s</summary>
#
# ✓ A full queue of 30 images spans a second, and the network takes 0.1 s.
#
# </details>
# <details><summary>c) A minute</summary>
#
# ✗ A full queue drops its oldest image, so the delay is limited.
#
# </details>
#
# **2. You move the network to a thread. What improves?**
#
# <details><summary>a) The other callbacks run on time</summary>
#
# ✓ The executor no longer has to wait for the network.
#
# </details>
# <details><summary>b) It finds more objects</summary>
#
# ✗ It computes the same numbers.
#
# </details>
# <details><summary>c) Its outputs arrive in half the time</summary>
#
# ✗ The network takes as long as before.
#
# </details>
#
# **3. With a new camera driver, the detector finds nothing, and the log is empty. What do you check first?**
#
# <details><summary>a) The queue depth</summary>
#
# ✗ A deep queue makes detections old, but it doesn't remove any.
#
# </details>
# <details><summary>b) The network's weights</summary>
#
# ✗ They haven't changed. If they had, their hash would differ from the one in the provenance file.
#
# </details>
# <details><summary>c) The encoding of the images</summary>
#
# ✓ The driver may publish `bgr8` instead of `rgb8`.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Write down your own answer first. Then copy the prompt into an AI assistant, or discuss it with a colleague.
#
# ```text
# I'm programming a robot with ROS 2 Jazzy in Python (rclpy). Write a node that runs an
# ONNX object detector on /camera/image (30 Hz, rgb8) and publishes the detections.
# Inference takes 0.2 s. The node also publishes a heartbeat at 10 Hz. Make sure that
# every rclpy function you use exists in Jazzy.
# ```
#
# <details><summary>What a good answer covers</summary>
#
# The node loads the network once and runs it in a thread that takes the newest image. Its subscription uses best-effort
# reliability and a depth of 1. The node copies the image's header into the detections. The network doesn't delay the
# heartbeat's timer. If inference runs in a callback instead, the executor needs several threads, *and* the heartbeat
# needs a separate callback group. An exception from the model doesn't end the thread, because the node catches and logs
# it. A good answer also asks how the model was trained: color order, size, and scaling.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Watch for these two suggestions. We tested both with this course's rclpy, and both failed.
#
# - **`create_subscription(Image, "/camera/image", self.on_image, 10)`:** Because only a depth is given, the
#   subscription requests reliable delivery, so it receives nothing from a best-effort camera. Even if images arrived, a
#   queue of ten would add about a third of a second to the age of each output.
# - **`CvBridge().imgmsg_to_cv2(msg, "bgr8")`, then the network:** This network was trained on RGB images. With blue and
#   red swapped, there's no error, but the detections are wrong.
#
# </details>

# %% [markdown]
# ## Take away
#
# - An output's age is the time since its image was taken: the time in the queue plus the network's time.
# - Use a best-effort subscription with a queue of one image, because the newest image is the most useful one.
# - Run a slow network in a thread that takes the newest image, so that the heartbeat stays regular.
# - Copy the image's stamp into its detections.
# - Use the color order and scaling from training, because a mismatch raises no error.
#
# **Before:** [15 · A camera](15_camera.ipynb)
#
# **Deeper:** [16 · Deeper: falls, and where a model runs](16_ai_model_deeper.ipynb)
#
# **Next:** none yet; this is the last lesson.
#
# **More:** [ONNX Runtime in Python](https://onnxruntime.ai/docs/get-started/with-python.html) and
# [QoS in Jazzy](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Quality-of-Service-Settings.html).

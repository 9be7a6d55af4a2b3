# %% [markdown]
# # 16 · Deeper: falls, and where a model runs
#
# A robot should detect a fall as early as possible. Which model can do that, and where should a model run so that it
# doesn't delay the node's callbacks?
#
# - **Minutes:** 40
# - **You need:** lesson [16](16_ai_model.ipynb)
# - **You will be able to:**
#   - train a small model on sensor readings, and judge it by the cost of its mistakes
#   - decide whether a model can run in a thread or needs its own process
#   - keep a node running when its model fails
# - **Not covered:** recurrent networks, and graphics cards

# %% [markdown]
# Here are two *episodes*: in the first, a robot bows, and in the second, it falls. The IMU in the torso measures the
# tilt.

# %%
from workbook.models.falls import RATE_HZ, all_windows, episodes, windows
from workbook.pictures.figures import figure, show

practice, held_back = episodes(seed=16, number=300), episodes(seed=1616, number=200)


def two_panels(lines, **labels):
    """A bow and a fall side by side. `lines` gives curves by name for an episode."""
    fig, axes = figure(7.0, 2.6, columns=2)
    for panel, episode in zip(axes, (practice[1], practice[3]), strict=True):
        looks = (("#2f78d0", "-", 0.0), ("#b06a00", "--", 0.15))  # last: name up by
        for (name, values), look in zip(lines(episode).items(), looks, strict=False):
            late = len(episode.samples) - len(values)  # of a full window
            seconds = [(late + n) / RATE_HZ for n in range(len(values))]
            panel.plot(seconds, values, look[1], color=look[0])
            place = seconds[-1] + 0.05, values[-1] + look[2]
            panel.annotate(name, place, va="center")
        panel.set_title(f"A robot that {episode.kind}")
        panel.set(xlabel="time (s)", xlim=(0, 5.0), ylim=(-0.2, 1.4), **labels)
    return fig


show(
    two_panels(lambda episode: {"tilt": episode.samples[:, 0]}, ylabel="angle (rad)"),
    "the tilt rises in a bow and in a fall, and falls again only after the bow",
)

# %% [markdown] prediction="tilt-or-window"
# ## Predict
#
# We compare two ways to detect a fall. The *rule* raises an alarm when the tilt exceeds the largest tilt of any bow in
# the training episodes. The *model* receives a *window*: the last 0.2 s of tilt, tilt rate, hip angle, and knee angle.
# It learns from the training episodes. We tune both so that neither raises a false alarm in those episodes. In new
# falls, which one raises the alarm first?
#
# - **a** The model, by more than 0.1 s.
#   when `gain > 0.1`
#   ✓ The rule has to wait until the tilt is larger than in the deepest bow. The model's input also shows that the hip
#   stays straight while the torso tilts.
# - **b** Both at about the same time: before the alarm, a fall looks just like a bow.
#   when `gain >= -0.1 and gain <= 0.1`
#   ✗ Only the tilt looks the same in both. The hip moves in a bow but not in a fall, and the model also receives the
#   hip angle.
# - **c** The rule, by more than 0.1 s: it needs only one sample, while the model needs a whole window.
#   when `gain < -0.1`
#   ✗ The window slides: it always holds the newest sample and the nine before it. So the model doesn't have to wait,
#   either.

# %%
from workbook.lesson import about, predict, reveal

predict("tilt-or-window")

# %% [markdown]
# ## Run it
#
# The training data is a table in which each row is one window: ten samples of four values. We train the model with
# scikit-learn on 300 episodes, which takes about a second.

# %%
from sklearn.linear_model import LogisticRegression
from sklearn.pipeline import make_pipeline
from sklearn.preprocessing import StandardScaler

rows, falls = all_windows(practice)
model = make_pipeline(StandardScaler(), LogisticRegression(max_iter=1000))
model.fit(rows, falls)


def score(rows):
    """How sure the model is that the robot falls, from 0 to 1, for each window."""
    return model.predict_proba(rows)[:, 1]


print("windows of", rows.shape[1], "numbers each:", f"{len(rows):,}")

# %% id="tilt-or-window"
from statistics import median

from workbook.models.falls import alarms

NEWEST_TILT = -4  # the column of the newest sample's tilt
deepest = rows[~falls, NEWEST_TILT].max()
surest = score(rows[~falls]).max()
rule = alarms(held_back, lambda rows: rows[:, NEWEST_TILT] > deepest)
learned = alarms(held_back, lambda rows: score(rows) > surest)
print("falls noticed:", len(rule.late_s), "and", len(learned.late_s), "of 50")
print("false alarms: ", rule.false, "and", learned.false)
reveal("tilt-or-window", gain=median(rule.late_s) - median(learned.late_s))

# %% [markdown]
# ## Look inside
#
# In our data, a fall begins when the body is no longer held upright. From then on, each window is labeled as a fall. To
# test the model, we held back whole episodes, not single windows. Neighboring windows share nine of their ten samples,
# so a window next to a training window would hardly be new to the model.
#
# Here's the model's output, the *score*, together with one of its inputs, the hip angle:

# %%
show(
    two_panels(
        lambda one: {"hip": one.samples[:, 2], "- - score": score(windows(one)[0])},
        ylabel="hip (rad), score",
    ),
    "in the bow the hip bends and the score stays low; in the fall it is straight, "
    "and the score rises to 1",
)

# %% [markdown]
# The hip bends in a bow but stays straight in a fall. Now let's count the windows that the model classifies correctly.

# %%
from sklearn.metrics import confusion_matrix

new_rows, new_falls = all_windows(held_back)
table = confusion_matrix(new_falls, score(new_rows) > 0.5)
fig, axes = figure(4.6, 2.2)
for line in (0, 1):
    for column in (0, 1):
        sign, color = ("✓", "#208a3c") if line == column else ("✗", "#dc3b3b")
        words = f"{sign} {table[line, column]:,}"
        axes.annotate(words, (column, line), color=color, ha="center", va="center")
axes.set_xticks([0, 1], ["model says: no fall", "model says: fall"])
axes.set_yticks([0, 1], ["no fall", "fall"])
axes.set(xlim=(-0.5, 1.5), ylim=(1.5, -0.5))
axes.grid(visible=False)
axes.set_title("Confusion: nearly all windows are right")
show(fig, "a table of the held-back windows: many right, few wrong, and few falls")

# %% id="always-fine"
right = (new_falls == (score(new_rows) > 0.5)).mean()
fine = (~new_falls).mean()
right_percent = about(100 * right, "%", between=(98, 100), digits=3)
print("the model is right on", right_percent, "of the held-back windows")
print(f"a model that always says 'no fall': {fine:.1%}")

# %% [markdown]
# Falls are rare, so high accuracy (the share of correctly classified windows) means little. Even a model that never
# reports a fall is right most of the time. Count the costly mistakes instead: late alarms and false alarms. Choosing a
# threshold means trading one for the other.

# %% id="late-or-false"
LEVELS = (0.1, 0.5, 0.9)
found = {at: alarms(held_back, lambda rows, at=at: score(rows) > at) for at in LEVELS}
late = [median(found[at].late_s) for at in LEVELS]
false = [found[at].false for at in LEVELS]
USUAL = {
    0.1: ((30, 80), (0, 30)),  # false alarms, and ms
    0.5: ((15, 45), (20, 80)),
    0.9: ((3, 14), (60, 200)),
}
for at, number, delay_s in zip(LEVELS, false, late, strict=True):
    digits = len(str(number))
    number_text = about(number, "false alarms", between=USUAL[at][0], digits=digits)
    delay = about(1000 * delay_s, "ms late", between=USUAL[at][1])
    print(f"threshold {at}: {number_text}, typically {delay}")
fooled = {
    one.kind for one in held_back if alarms([one], lambda rows: score(rows) > 0.9).false
}
print("false alarms at 0.9 in episodes of a robot that", *fooled)

# %%
fig, axes = figure(6.0, 2.6)
axes.plot(false, [1000 * one for one in late], marker="o", color="#2f78d0")
for level, x, y in zip(LEVELS, false, late, strict=True):
    axes.annotate(f"  threshold {level}", (x, 1000 * y), va="bottom")
axes.set(xlabel="false alarms in 200 episodes", ylabel="typical delay (ms)")
axes.set(xlim=(-0.5, 1.3 * max(false) + 1), ylim=(-10, 1200 * max(late)))
axes.set_title("An early alarm costs false alarms")
show(fig, "delay against false alarms: a low threshold is early and often wrong")

# %% [markdown]
# For a moment, a robot that's pushed and then catches itself looks like a falling one. If an alarm only makes the robot
# stretch out its arms, a false alarm does little harm. But if it cuts the robot's power, a false alarm makes the robot
# fall. To use the model in a node, keep the window in a `collections.deque(maxlen=10)`. Clear this deque when the node
# that publishes the samples restarts.
#
# **Your turn.** Suppose that the robot only stretches out its arms. Then one false alarm is exactly as bad as 1 ms of
# delay. If the robot cuts its power instead, one false alarm is as bad as 50 ms of delay. For each threshold, add the
# cost of all false alarms to the typical delay. Which of the three thresholds is cheapest in each case?

# %% id="your-threshold"
from workbook.lesson import yours

for_arms = ...  # TODO: a threshold
for_power = ...  # TODO: a threshold

yours(
    (for_arms, for_power),
    (0.1, 0.9),
    "For the arms, threshold 0.5 costs 29 * 1 ms + 40 ms.",
)

# %% [markdown] prediction="which-holds-the-heartbeat"
# ## Change it
#
# ### Three models in a thread
#
# A node publishes a heartbeat ten times a second, and one of its threads runs a model for two seconds. We try three
# models: a loop in pure Python, a network in ONNX Runtime, and C code that holds the GIL, as some drivers do. Which of
# them stop the heartbeat for those two seconds?
#
# - **a** Pure Python and the C code.
#   when `python >= 1.5 and held >= 1.5`
#   ✗ Once another thread has waited 5 ms for the lock, the interpreter makes Python code release it.
# - **b** Only the C code.
#   when `python < 1.5 and held >= 1.5`
#   ✓ Between two steps of Python code, the lock can change hands. During a call to C code, it can't, unless that code
#   releases it.
# - **c** None: the threads run at the same time.
#   when `python < 1.5 and held < 1.5`
#   ✗ While one thread holds the lock, no other thread can run Python code.

# %%
predict("which-holds-the-heartbeat")

# %%
import threading
import time
from itertools import pairwise

from rclpy.node import Node
from std_msgs.msg import String

from workbook.lesson import fresh, init, run

init()


class Thinker(Node):
    """Beats ten times a second. After five beats, a thread calls the model once."""

    def __init__(self, model) -> None:
        super().__init__("thinker")
        self.model = model
        self.beats: list[float] = []
        self.took_s = 0.0
        self.worker = threading.Thread(target=self.work, daemon=True)
        self.publisher = self.create_publisher(String, "/robot/heartbeat", 10)
        self.create_timer(0.1, self.beat)

    def beat(self) -> None:
        self.beats.append(time.monotonic())
        self.publisher.publish(String(data="alive"))
        if len(self.beats) == 5:
            self.worker.start()

    def work(self) -> None:
        began = time.monotonic()
        self.model()
        self.took_s = time.monotonic() - began

    def silence(self) -> float:
        """The longest time between two beats (s)."""
        return max(later - before for before, later in pairwise(self.beats))


async def think(model):
    """Run a model in a thread of a node, and five more beats after it."""
    node = fresh(Thinker, model)
    await run(node, seconds=50, until=lambda: node.took_s > 0)
    done = len(node.beats)
    await run(node, seconds=50, until=lambda: len(node.beats) >= done + 5)
    return node


# %% [markdown]
# [the same without helpers: init, fresh, run]
#
# Now let's run the three models, each for two seconds.

# %%
import random

from workbook.models import beside
from workbook.models.networks import OnnxNetwork

network = OnnxNetwork()
weights = [[random.uniform(-0.1, 0.1) for _ in range(100)] for _ in range(100)]


def repeat(step, seconds=2.0):
    """Call `step` again and again, for so long."""
    ends = time.monotonic() + seconds
    while time.monotonic() < ends:
        step()


def one_layer():
    """A layer of a network in pure Python."""
    return [max(0.0, sum(weight * 0.5 for weight in row)) for row in weights]


# %% id="which-holds-the-heartbeat"
import numpy as np

pictures = np.zeros((8, 3, 120, 160), np.float32)
thinkers = {
    "pure Python": await think(lambda: repeat(one_layer)),
    "ONNX Runtime": await think(lambda: repeat(lambda: network(pictures[:1]))),
    "C code": await think(beside.hold_the_lock),
}
silences = {name: node.silence() for name, node in thinkers.items()}
for name, silence in silences.items():
    usual = (1.5, 6) if name == "C code" else (0.09, 1.4)
    print(f"{name:12} longest silence: {about(silence, 's', between=usual)}")
reveal(
    "which-holds-the-heartbeat",
    python=silences["pure Python"],
    held=silences["C code"],
)

# %%
from workbook.pictures.timeline import strip


def from_zero(node):
    """The beats of a node, the first one at 0."""
    return [t - node.beats[0] for t in node.beats if t - node.beats[0] < 3.5]


lines = {name: from_zero(node) for name, node in thinkers.items()}
show(
    strip(
        lines,
        periods=dict.fromkeys(lines, 0.1),
        end=3.5,
        title="Only C code that keeps the GIL stops the heartbeat",
    ),
    "heartbeats with three models in a thread: only the C code leaves a gap",
)

# %% [markdown]
# So a model in pure Python doesn't stop the heartbeat. But each beat has to wait for the GIL, the interpreter's lock:

# %%
import sys

print("a thread that waits asks for the lock after", sys.getswitchinterval(), "s")

# %% [markdown]
# A callback may release the lock several times while it runs, and each time, it has to wait to get the lock back. More
# cores don't help, because under the GIL, two threads never run Python code at the same time. And if C code holds on to
# the lock, moving the model to a thread doesn't help, either.

# %% [markdown] prediction="to-another-process"
# ### A process next to the node
#
# A separate process has its own GIL. `ProcessPoolExecutor` starts such a process, pickles each image, and sends it to
# the process through a pipe. We send an image of 160 by 120 pixels, and then one of 1,920 by 1,440. How many times as
# long does the large one take?
#
# - **a** Less than twice as long: waking the other process takes most of the time.
#   when `ratio < 2`
#   ✗ That's true only for small images.
# - **b** Two to four times as long.
#   when `ratio >= 2 and ratio < 4`
#   ✗ The large image has 144 times as many bytes, and each byte is copied several times.
# - **c** More than four times as long.
#   when `ratio >= 4`
#   ✓ For a large image, copying is most of the work.

# %%
predict("to-another-process")

# %%
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

spawn = get_context("spawn")
pool = ProcessPoolExecutor(1, mp_context=spawn, initializer=beside.load)


def ask(picture):
    """Send a picture to the other process, and wait for its answer."""
    return pool.submit(beside.size, picture).result()


small = np.zeros((120, 160, 3), np.uint8)
large = np.zeros((1440, 1920, 3), np.uint8)
print("bytes that arrived:", ask(small), "and", ask(large))

# %% id="to-another-process"


def shortest(call, times=30):
    """How long the fastest of several calls took (s)."""
    took = []
    for _ in range(times):
        began = time.perf_counter()
        call()
        took.append(time.perf_counter() - began)
    return min(took)


small_s, large_s = shortest(lambda: ask(small)), shortest(lambda: ask(large))
print("160 × 120:    ", about(1000 * small_s, "ms", between=(0.05, 20)))
print("1,920 × 1,440:", about(1000 * large_s, "ms", between=(1, 500)))
reveal("to-another-process", ratio=large_s / small_s)

# %% [markdown]
# So send the process only the header and the model's input, already scaled to the size that the model expects. Or make
# the second process a node that subscribes to the camera, so you don't have to pass images along. Lesson 16's
# `toy_detector` works this way.
#
# Does a separate process help if C code holds on to the lock?

# %% id="lock-in-a-process"
beside_it = await think(lambda: pool.submit(beside.hold_the_lock, 2.0).result())
print("the model took", about(beside_it.took_s, "s", between=(2, 10)))
print("longest silence:", about(beside_it.silence(), "s", between=(0.09, 1.4)))

# %% [markdown]
# It does: the node's thread waits for the result without holding the lock. We started the process with `spawn`, which
# creates a new Python process that has to load the model itself. The alternative, `fork`, copies the process, but the
# copy has only one of its threads. DDS's threads would be missing, so don't use `fork` together with rclpy.

# %% [markdown] prediction="eight-at-once"
# ### Eight images in one call
#
# Most libraries accept a *batch* of images, for example eight in one call. On one core, how much CPU time does such a
# call take, compared with eight separate calls?
#
# - **a** About the same.
#   when `ratio >= 0.65`
#   ✓ The multiplications are the same. Graphics cards do gain from batches, because they perform many multiplications
#   at the same time.
# - **b** About half.
#   when `ratio >= 0.3 and ratio < 0.65`
#   ✗ A batch saves only the overhead of the calls, which is small here.
# - **c** About an eighth.
#   when `ratio < 0.3`
#   ✗ Each image needs its own multiplications, and a core performs them one after another.

# %%
predict("eight-at-once")

# %% id="eight-at-once"


def processor_s(call, times=1):
    """Processor time of the fastest of several calls, in this thread (s)."""
    took = []
    for _ in range(times):
        began = time.thread_time()
        call()
        took.append(time.thread_time() - began)
    return min(took)


one = processor_s(lambda: network(pictures[:1]), 30)
eight = processor_s(lambda: network(pictures), 30)
print("one picture:   ", about(1000 * one, "ms", between=(0.3, 60)))
print("eight pictures:", about(1000 * eight, "ms", between=(2, 500)))
reveal("eight-at-once", ratio=eight / (8 * one))

# %% [markdown]
# With a batch, the network has to wait for the last image. At 30 Hz, the first of eight images is already 7/30 s (0.23
# s) old when the network starts. So use batches for training and for recorded data.
#
# The first call to a network takes longer than later ones, because the library allocates memory during that call. Many
# libraries also compile code at that point. We load the network sixty times, call it twice each time, and compare the
# fastest first call with the fastest second call.

# %% id="warm-up"


def two_calls():
    """Processor time of the first two calls of a network (s)."""
    loaded = OnnxNetwork()
    return [processor_s(lambda: loaded(pictures[:1])) for _ in range(2)]


firsts, seconds = zip(*(two_calls() for _ in range(60)), strict=True)
first_ms, second_ms = 1000 * min(firsts), 1000 * min(seconds)
print("first call: ", about(first_ms, "ms", between=(0.3, 60), digits=3))
print("second call:", about(second_ms, "ms", between=(0.3, 60), digits=3))

# %% [markdown]
# So after loading the network, call it once with a blank image, as a *warm-up*. Because our network is small, its first
# call took only 10% longer than the second in our test on an idle machine. A large network may take seconds for its
# first image. Subscribe to the camera only after the warm-up.

# %% [markdown]
# ## When it goes wrong
#
# **The model raises an exception in a thread.** Python passes the exception to `threading.excepthook`, and only the
# thread that raised it ends.

# %% id="raised-in-a-thread"
unseen = []


def glare():
    raise RuntimeError("glare: the picture is white")


before = threading.excepthook
threading.excepthook = unseen.append
blind = fresh(Thinker, glare)
await run(blind, seconds=50, until=lambda: unseen and not blind.worker.is_alive())
done = len(blind.beats)
await run(blind, seconds=50, until=lambda: len(blind.beats) >= done + 5)
threading.excepthook = before
print("the thread ended by:", unseen[0].exc_type.__name__, unseen[0].exc_value)
print("beats after that:", len(blind.beats) - done)

# %% [markdown]
# The heartbeat still reports "alive", but the detector is dead. Call the model inside a `try` block, as
# `ToyDetector.work` does. And make the heartbeat depend on the detector: publish it only if the last result is recent
# enough.
#
# **A node's method as a task.** It seems natural to pass a method, such as `self.look`, to the pool:

# %% id="method-as-a-task"
try:
    pool.submit(blind.silence).result()
except Exception as fault:
    print(f"{type(fault).__name__}: {fault}")

# %% [markdown]
# To pickle a method, Python also has to pickle the object that the method is bound to. Here, that object is a node, and
# a node can't be pickled. Instead, submit a function that's defined at the top level of a module, and pass it plain
# data. A function that's defined in a notebook cell won't work, either, because the other process can't import it.
#
# **The process crashes.** A crash in C code ends the whole process immediately. To simulate such a crash, we make the
# process exit with code 3:

# %% id="process-crashed" tags=["raises-exception"]
import os

pool.submit(os._exit, 3).result()

# %% [markdown]
# In a thread, this crash would have ended the node. Here, the node just gets an exception and can start a new process.
# That takes a while, and in this example, the model takes two more seconds to load. Does the heartbeat stop during that
# time?

# %% id="slow-start"
pool.shutdown()
pool = ProcessPoolExecutor(
    1, mp_context=spawn, initializer=beside.load, initargs=(2.0,)
)
again = await think(lambda: ask(small))
pool.shutdown()
print("the first answer took", about(again.took_s, "s", between=(2, 40)))
print("longest silence:", about(again.silence(), "s", between=(0.09, 1.4)))

# %% [markdown]
# It doesn't: only the thread waits, and the node keeps running. Until the first result arrives, publish "starting" as
# the status instead of "operational".

# %% [markdown]
# ## Take away
#
# - If the input is just a few numbers, a small scikit-learn model may be enough. Hold back whole episodes to test it.
# - If falls are rare, accuracy (the share of correctly classified windows) means little. Count late alarms and false
#   alarms instead.
# - A thread is enough if the model releases the GIL. The interpreter makes Python code release it when another thread
#   is waiting. C code releases the GIL only if it was written to do so.
# - A separate process protects the node from code that holds on to the GIL, and from crashes. Everything that you send
#   to the process is copied, so keep the input small.
# - Load the model and warm it up before the first image. On one core, batching saves little time and makes the outputs
#   stale.
#
# **Before:** [16 · An AI model in a node](16_ai_model.ipynb)
#
# **Next:** none yet; this is the last lesson.
#
# **More:** [scikit-learn: common pitfalls](https://scikit-learn.org/stable/common_pitfalls.html),
# [About executors](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Executors.html).

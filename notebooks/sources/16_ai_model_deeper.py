# %% [markdown]
# # 16 · Deeper: falls, and where a model runs
#
# A robot should notice early that it's falling. Which model can do that, and where should a model run so that it doesn't
# delay other callbacks?
#
# - **Minutes:** 40
# - **You need:** lesson [16](16_ai_model.ipynb)
# - **You will be able to:**
#   - train a small model on numbers, and judge it by the cost of its mistakes
#   - decide whether a model can run in a thread or needs a process
#   - keep a node running when its model fails
# - **Left out:** recurrent networks, and graphics cards

# %% [markdown]
# Here are two episodes. In the first one, a robot bows, and in the second, it falls. The IMU in its torso measures the
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
# The rule: alarm when the tilt is larger than in any bow of the practice episodes. The model: it gets 0.2 s of tilt,
# tilt rate, hip and knee, and learns from the practice episodes. Neither may raise an alarm there without a fall. In
# falls that both have never seen, who is first?
#
# - **a** The model, by more than 0.1 s.
#   when `gain > 0.1`
#   ✓ The rule has to wait until the tilt is larger than that of the deepest bow. The model sees that the hip stays
#   straight while the torso tilts.
# - **b** Both at about the same time: before that, a fall looks like a bow.
#   when `gain >= -0.1 and gain <= 0.1`
#   ✗ They look alike if only the tilt is known. The hip moves in a bow, and not in a fall.
# - **c** The rule, by more than 0.1 s: it needs one sample, the model a whole window.
#   when `gain < -0.1`
#   ✗ The window slides. It holds the newest sample and the nine before it, so the model waits for nothing.

# %%
from workbook.lesson import about, predict, reveal

predict("tilt-or-window")

# %% [markdown]
# ## Run it
#
# Each row of the table is a window: ten samples of four channels. scikit-learn trains on 300 episodes in about a second.

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
# A fall begins when nothing supports the body anymore. From then on, each window is labeled as a fall. We held back whole
# episodes, not single windows. Neighboring windows share nine of ten samples, so a model that was trained on one
# practically knows the other.
#
# Here are one of the model's other inputs, the hip angle, and its output:

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
# In a bow, the hip bends, but in a fall, it stays straight. How often is the model right, window by window?

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
# Falls are rare. So a high share of correct windows means little, because a model that never reports a fall has one,
# too. Count the costly mistakes instead: late alarms and false alarms. The threshold trades one for the other.

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
# A robot that is pushed and catches itself briefly looks like a falling one. If the robot only stretches out its arms, a
# false alarm does little harm. If it cuts its power, a false alarm makes it fall. In a node, keep the window in a
# `collections.deque(maxlen=10)`. Clear the window when the source restarts.
#
# **Your turn.** If the robot stretches out its arms, let a false alarm cost as much as 1 ms of delay. If it cuts its power,
# let it cost as much as 50 ms. Add up the costs of all false alarms and of the delay. Which of the three thresholds is
# cheapest in each case?

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
# A node beats ten times a second. A thread of the node runs a model for two seconds. First it is a loop in pure Python,
# then ONNX Runtime, then C code that keeps the GIL (as some drivers do). Which of them stop the heartbeat for that
# time?
#
# - **a** Pure Python and the C code.
#   when `python >= 1.5 and held >= 1.5`
#   ✗ Python code has to hand the lock over when another thread has waited for 5 ms.
# - **b** Only the C code.
#   when `python < 1.5 and held >= 1.5`
#   ✓ Between two steps of Python code the lock can change hands. Within a call to C code it cannot, unless that
#   code releases it.
# - **c** None: a thread runs beside the others.
#   when `python < 1.5 and held < 1.5`
#   ✗ It runs beside them only while it does not hold the lock.

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
# Now let's run three models. Each works for two seconds.

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
# So a pure Python model doesn't stop the heartbeat. But it makes each beat wait for the lock:

# %%
import sys

print("a thread that waits asks for the lock after", sys.getswitchinterval(), "s")

# %% [markdown]
# A callback that releases the lock several times waits several times. And while there's a GIL, two threads never run Python
# code at the same time, no matter how many cores there are. If C code keeps the lock, a thread doesn't help.

# %% [markdown] prediction="to-another-process"
# ### A process beside the node
#
# A process has a GIL of its own. `ProcessPoolExecutor` starts one and hands it a picture: pickled, and sent through a
# pipe. A picture of 160 by 120 pixels makes the trip, then one of 1,920 by 1,440. How much longer does the large one
# take?
#
# - **a** Less than twice as long: waking the other process is what takes time.
#   when `ratio < 2`
#   ✗ That is true for small pictures only.
# - **b** Two to four times as long.
#   when `ratio >= 2 and ratio < 4`
#   ✗ There are 144 times as many bytes, and each of them is copied several times.
# - **c** More than four times as long.
#   when `ratio >= 4`
#   ✓ For a large picture, copying is most of the work.

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
# Pass the process only the model's input, in the model's size, along with the header. Or make the second process a node
# that subscribes to the camera. Then no code has to pass images along. Lesson 16's `toy_detector` is such a process.
#
# Does a process help with C code that keeps the lock?

# %% id="lock-in-a-process"
beside_it = await think(lambda: pool.submit(beside.hold_the_lock, 2.0).result())
print("the model took", about(beside_it.took_s, "s", between=(2, 10)))
print("longest silence:", about(beside_it.silence(), "s", between=(0.09, 1.4)))

# %% [markdown]
# The thread waits for the result without holding the lock. `spawn` starts a new Python process, which loads the model
# again. The alternative, `fork`, copies a process without its threads. DDS runs in its own threads, and the copy would
# lack them. So don't use `fork` together with rclpy.

# %% [markdown] prediction="eight-at-once"
# ### Eight pictures at once
#
# Libraries take a *batch*: eight pictures in one call. On one core, how much processor time does that need, compared
# with eight calls?
#
# - **a** About the same.
#   when `ratio >= 0.65`
#   ✓ The multiplications are the same. Graphics cards gain from batches, because they do many at the same moment.
# - **b** About half.
#   when `ratio >= 0.3 and ratio < 0.65`
#   ✗ Only the cost of the call itself is saved, and that is small here.
# - **c** About an eighth.
#   when `ratio < 0.3`
#   ✗ Each picture needs its multiplications, and a core does them one after another.

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
# A batch also waits for its last image. At 30 Hz, the first of eight images is then 7/30 s old, or 0.23 s, before the
# network starts. Batches are for training and for recordings.
#
# The first call costs more than later ones, because it reserves memory. Many libraries also compile code then. We load
# the network sixty times, call it twice each time, and compare the fastest first call with the fastest second call.

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
# So call the network once with an empty image after loading it. This is called a *warm-up*. Our network is small: in our
# test on an idle machine, its first call took a tenth longer. A large network may take seconds for its first image.
# Subscribe to the camera after the warm-up.

# %% [markdown]
# ## When it goes wrong
#
# **The model raises an exception in a thread.** Python ends only this thread. It calls `threading.excepthook` with the
# exception.

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
# The heartbeat reports "alive", but the detector is dead. Call the model in a `try`, as `ToyDetector.work` does. And make
# the heartbeat depend on the detector: publish it only if the last result is recent enough.
#
# **A node's method as a task.** It looks natural to pass `self.look` to the pool.

# %% id="method-as-a-task"
try:
    pool.submit(blind.silence).result()
except Exception as fault:
    print(f"{type(fault).__name__}: {fault}")

# %% [markdown]
# A method refers to its node, and a node can't be pickled. Submit a function from a module, with plain data. A function
# from a notebook cell fails, too, because the other process can't import it.
#
# **The process crashes.** A fault in C code ends a process immediately. We make it end with exit code 3:

# %% id="process-crashed" tags=["raises-exception"]
import os

pool.submit(os._exit, 3).result()

# %% [markdown]
# In a thread, this crash would have ended the node. Here, it's an exception, and the node can start the next process.
# That takes a while, and in this example the model takes two more seconds to load. Does the heartbeat stop during that
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
# The thread waits, but the node keeps running. Until the first result arrives, publish "starting" as the status instead
# of "operational".

# %% [markdown]
# ## Take away
#
# - For a few numbers, a small scikit-learn model may be enough. Hold back whole episodes.
# - If falls are rare, don't count correct windows. Count late alarms and false alarms.
# - A thread is enough if the model releases the GIL. Python code has to release it when another thread waits. C code
#   releases it only if it was written to do so.
# - A separate process helps against code that keeps the GIL, and against crashes. Its input is copied, so pass it little
#   data.
# - Load the model and warm it up before the first image. On one core, a batch saves little and makes outputs old.
#
# **Before:** [16 · An AI model in a node](16_ai_model.ipynb)
#
# **Next:** this is the last lesson so far.
#
# **More:** [scikit-learn: common pitfalls](https://scikit-learn.org/stable/common_pitfalls.html),
# [About executors](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Executors.html).

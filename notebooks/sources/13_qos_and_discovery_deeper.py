# %% [markdown]
# # 13 · Deeper: discovery and the first messages
#
# A program starts and publishes at once. Who receives its first messages, and what does that depend on?
#
# - **Minutes:** 20
# - **You need:** lesson [13](13_qos_and_discovery.ipynb)
# - **You will be able to:**
#   - decide what becomes of the first messages
#   - say how long discovery takes
#   - find out why two programs do not see each other
# - **Left out:** discovery servers, and settings of DDS for large networks

# %% [markdown] prediction="first-words"
# ## Predict
#
# A program starts and makes a publisher. Its next lines publish `hello`, `here`, `I am`. Then it waits until it has found
# a listener, and ends. A listener has been running all the time. Both sides are reliable and volatile. We start six such
# programs, one after another. How many of the eighteen messages arrive?
#
# - **a** All 18: reliable means that nothing is lost.
#   ✗ Reliable counts from the match on. Earlier messages have no receiver.
# - **b** It differs: sometimes none, sometimes many.
#   ✓ `publish` does not wait for a listener. Whether the match comes before a message depends on the machine and the
#   moment.
# - **c** None: the listener is not yet known at that moment.
#   ✗ Discovery takes a while, but it runs beside your program. On a busy machine it can be faster than the next line.

# %%
from workbook.lesson import predict, reveal

predict("first-words")

# %% [markdown]
# ## Run it
#
# `greet` runs the programs (`lesson_nodes/first_words.py`), and returns how long each took to find the listener, in ms.

# %%
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import String

from workbook.lesson import fresh, init, run
from workbook.lesson.qos_trials import greet

init()

LATCHED = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class Ears(Node):
    """Listens to newcomers."""

    def __init__(self, qos) -> None:
        super().__init__("ears")
        self.heard: list[str] = []
        self.create_subscription(String, "/ears", self.on_word, qos)

    def on_word(self, message: String) -> None:
        self.heard.append(message.data)


ears = fresh(Ears, 100)
found_ms = greet(6, "/ears")
await run(ears, seconds=0.5)
print("newcomers:", len(found_ms))

# %% id="first-words" tags=["nbval-ignore-output"]
print(len(ears.heard), "of 18 messages arrived")

# %%
print("all newcomers found the listener in the end:", all(ms >= 0 for ms in found_ms))
reveal("first-words")

# %% [markdown]
# Run the three cells above a few times. When we tried it on an idle machine, between none and two thirds of the messages
# arrived. With all processors busy, all 18 did: the program itself was so slow that discovery was faster. A fault like
# this appears on one machine and not on the next.

# %% [markdown]
# ## Look inside
#
# `publish` does not check whether anyone listens. A volatile publisher does not keep a message that has no receiver.
# *Reliable* is a promise to subscriptions that are matched. Here are three fixes:

# %%
FIXES = {
    "count": "ask get_subscription_count() until it is above 0",
    "matched": "wait for the event that reports a match",
    "latched": "do not wait; keep the messages (transient local on both sides)",
}
for fix, words in FIXES.items():
    keeps = fix == "latched"
    ears = fresh(Ears, LATCHED if keeps else 100)
    greet(4, "/ears", wait_for="nothing" if keeps else fix, latched=keeps)
    await run(ears, seconds=10, until=lambda heard=ears.heard: len(heard) == 12)
    print(f"{len(ears.heard)} of 12 arrived: {words}")

# %% [markdown]
# You give the event's callback to `create_publisher`, and the node calls it while it is spun:
#
# ```python
# self.create_publisher(
#     String, "/robot/greeting", 10,
#     event_callbacks=PublisherEventCallbacks(matched=self.on_matched),
# )
# ```
#
# One caveat: a listener may learn of you a moment later than you learn of it. A reliable publisher then sends again. With
# best effort, the first messages can still be lost.

# %% [markdown]
# ### How long does discovery take?
#
# This workbook makes discovery fast, by a few settings for DDS (`workbook/ros/loopback.xml`). They keep all traffic on
# this machine, and each program repeats its announcement ten times a second. The default on a robot is once every
# three seconds. We ask six newcomers with our times, and six with the default ones.

# %%
from workbook.lesson.qos_trials import found_picture, greet_by_default

ears = fresh(Ears, 100)
here_ms = greet(6, "/ears")
default_ms = greet_by_default(6)
print("newcomers:", len(here_ms), "and", len(default_ms))

# %%
found_picture(
    here_ms,
    default_ms,
    "how long newcomers took to find the listener, "
    "with the settings of this workbook and by default",
)

# %%
print("all of them found the listener:", min(here_ms) >= 0 and min(default_ms) >= 0)

# %% [markdown]
# In a hundred runs on one machine, the workbook's newcomers took 3 to 190 ms. By default about half took 3 to 100 ms,
# and most others up to three seconds: they had to wait for the next announcement. So a `time.sleep(1.0)` before the first
# message works in one run and fails in the next. Wait for the match, not for a time.

# %% [markdown] prediction="sixteen-pairs"
# ### All pairs, measured
#
# Two policies with two values each make four profiles. Each may be offered, and each requested: sixteen pairs. Every
# publisher sends one message before its subscription exists, and five after. How many pairs get any message?
#
# - **a** 4: those with equal profiles on both sides.
#   when `hearing == 4`
#   ✗ They need not be equal. An offer may be better than the request.
# - **b** 16: each pair has the same topic and type.
#   when `hearing == 16`
#   ✗ A request that is higher than the offer prevents the match.
# - **c** 9: no request is higher than the offer.
#   when `hearing == 9`
#   ✓ For each policy three of the four combinations fit, and 3 × 3 is 9.

# %%
predict("sixteen-pairs")

# %%
from itertools import product

from rclpy.qos import ReliabilityPolicy

from workbook.lesson.qos_trials import pairs_picture, try_pairs

PROFILES = {
    f"{reliability.name}\n{durability.name}": QoSProfile(
        depth=10, reliability=reliability, durability=durability
    )
    for reliability, durability in product(
        (ReliabilityPolicy.BEST_EFFORT, ReliabilityPolicy.RELIABLE),
        (DurabilityPolicy.VOLATILE, DurabilityPolicy.TRANSIENT_LOCAL),
    )
}
heard = try_pairs(PROFILES)
hears = {pair: bool(messages) for pair, messages in heard.items()}
reveal("sixteen-pairs", hearing=sum(hears.values()))

# %%
pairs_picture(
    heard, "sixteen pairs: nine hear the new messages, one of them the old one, too"
)

# %% id="matrix"
from rclpy.qos import QoSCompatibility, qos_check_compatible

foretold = {}
for offered, requested in heard:
    verdict, _ = qos_check_compatible(PROFILES[offered], PROFILES[requested])
    foretold[offered, requested] = verdict != QoSCompatibility.ERROR
with_equal_qos = [hears[pair] for pair in heard if pair[0] == pair[1]]
print("pairs that hear something:      ", sum(hears.values()))
print("of these with equal QoS:        ", sum(with_equal_qos))
print("rclpy predicted all sixteen:    ", hears == foretold)
got_the_old = ["old" in messages for messages in heard.values()]
print("pairs that got the old message: ", sum(got_the_old))

# %% [markdown]
# The old message arrived only where *both* sides are reliable *and* transient local. Five of the nine pairs that hear
# something have different profiles.

# %% [markdown]
# ## When it goes wrong
#
# **Another type in the same process.** Lesson 13 mixed two types in two processes, and nothing was logged. Within one
# process the middleware checks:


# %% id="other-type" tags=["raises-exception"]
from std_msgs.msg import Float32


class Counter(Node):
    """Publishes numbers on a topic that carries text in this process."""

    def __init__(self) -> None:
        super().__init__("counter")
        self.create_publisher(Float32, "/ears", 10)


fresh(Counter)

# %% [markdown]
# Read the middle: `existing topic name rt/ears with incompatible type`. (`rt` stands for "ROS topic".) A subscription is
# refused as well, with the less helpful text `invalid allocator`.

# %% [markdown]
# **Two domains.** Name, type and QoS are right here. Only the domain differs:

# %% id="other-domain"
from workbook.lesson.qos_trials import heard_between
from workbook.ros.domains import lease_domain

with lease_domain() as desk_a, lease_domain() as desk_b:
    print("desk A to desk A:", heard_between(desk_a, desk_a, LATCHED))
    print("desk A to desk B:", heard_between(desk_a, desk_b, LATCHED))

# %% [markdown]
# A tool is on one domain, too, so no tool shows this pair. A topic that is not listed means another domain
# (`ROS_DOMAIN_ID`), another network, or a program that is not running. A listed topic without messages means QoS or type.
#
# **With a container: a topic is listed, and nothing arrives.** Fast DDS sends messages through shared memory
# (`/dev/shm`) if it takes both programs to be on one machine. A container that shares its host's network, but not
# `/dev/shm`, seems to be on the same machine. Then every topic is listed, and no message arrives. Share `/dev/shm`
# and the user (`--ipc=host`, `--user`), or turn shared memory off, as this workbook does. `workbook doctor` checks
# all of these.

# %% [markdown]
# ## Take away
#
# - A message from before the match is lost, even with reliable QoS. Wait for `get_subscription_count()` or the matched
#   event.
# - Discovery takes milliseconds or seconds. Do not sleep for a fixed time.
# - Nine of the sixteen pairs match: those where no request is higher than the offer.
# - Not listed: domain or network. Listed, but silent: QoS, type, or shared memory.
#
# **Before:** [13 · QoS and discovery](13_qos_and_discovery.ipynb)
#
# **Next:** [14 · Arrays and filters](14_arrays_and_filters.ipynb)
#
# **More:** [About discovery](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Discovery.html).

# %% [markdown]
# # 13 · Deeper: discovery and the first messages
#
# A program starts and publishes right away. Who receives its first messages, and what does that depend on?
#
# - **Minutes:** 25
# - **You need:** lesson [13](13_qos_and_discovery.ipynb)
# - **You will be able to:**
#   - make sure that a program's first messages arrive
#   - estimate how long discovery takes
#   - find out why two programs don't discover each other
# - **Not covered:** discovery servers, and DDS settings for large networks

# %% [markdown] prediction="first-words"
# ## Predict
#
# A listener (a node with a subscription) is already running. Then a program starts and creates a publisher. Its next
# lines publish `hello`, `here`, and `I am`. The program waits until it has discovered the listener, and then exits. The
# publisher and the subscription are both reliable and volatile. We start six such programs, one after another. How many
# of the eighteen messages arrive?
#
# - **a** All 18: reliable means that nothing is lost.
#   ✗ Reliable delivery starts with the match. Messages published earlier have no receiver.
# - **b** It varies: sometimes none, sometimes many.
#   ✓ `publish` doesn't wait for a listener. Whether a message is published before or after the match varies by machine,
#   and from run to run.
# - **c** None: the program hasn't discovered the listener yet.
#   ✗ Discovery takes a while, but it runs in parallel with your program. On a busy machine, it can finish before your
#   program's next line runs.

# %%
from workbook.lesson import predict, reveal

predict("first-words")

# %% [markdown]
# ## Run it
#
# We call the six programs *newcomers*. Each of them runs `lesson_nodes/first_words.py`. `greet` starts them one after
# another and returns how many milliseconds each one took to discover the listener.
#
# [the same without helpers: init, fresh, run]

# %%
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import String

from workbook.lesson import about, fresh, init, run
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
print("fastest newcomer:", about(min(found_ms), "ms", between=(0, 5_000)))
print("slowest newcomer:", about(max(found_ms), "ms", between=(0, 10_000)))

# %% id="first-words"
print(about(len(ears.heard), "of 18 messages arrived", between=(0, 18)))

# %%
reveal("first-words")

# %% [markdown]
# Run the three cells above a few times. On our idle machine, anywhere from none to two thirds of the messages arrived.
# When all processors were busy, all 18 arrived, because the program itself was so slow that discovery finished first.
# So a fault like this can appear on one machine but not on the next.

# %% [markdown]
# ## Look inside
#
# `publish` doesn't check whether there are any subscriptions, and a volatile publisher doesn't keep a message that
# has no receiver. *Reliable* applies only to subscriptions that are already matched. The next cell tries three fixes:

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
# To wait for the matched event, pass a callback to `create_publisher`. rclpy calls it when a match is reported, but
# only while the node is spinning:
#
# ```python
# self.create_publisher(
#     String, "/robot/greeting", 10,
#     event_callbacks=PublisherEventCallbacks(matched=self.on_matched),
# )
# ```
#
# One caveat: your program may discover a listener a moment before the listener discovers your program. A reliable
# publisher resends the messages that the listener missed in between. But with best effort, these messages can still be
# lost.

# %% [markdown]
# ### How long does discovery take?
#
# A few DDS settings make discovery fast in this workbook (`workbook/ros/loopback.xml`). They keep all traffic on this
# machine, and they make each program announce itself to the others ten times per second. Without these settings, as is
# usual on a robot, each program announces itself only once every three seconds. We run six newcomers with our settings,
# and six with the defaults.

# %%
from workbook.lesson.qos_trials import found_picture, greet_by_default

ears = fresh(Ears, 100)
here_ms = greet(6, "/ears")
default_ms = greet_by_default(6)
for words, times in (("in this workbook:", here_ms), ("by default:", default_ms)):
    fastest = about(min(times), "ms", between=(0, 5_000))
    slowest = about(max(times), "ms", between=(0, 10_000))
    print(f"{words:<18}fastest {fastest}, slowest {slowest}")

# %%
found_picture(
    here_ms,
    default_ms,
    "how long newcomers took to find the listener, "
    "with the settings of this workbook and by default",
)

# %% [markdown]
# We measured a hundred runs on one machine. With the workbook's settings, discovery took 3 to 190 ms. With the
# defaults, it took 3 to 100 ms in about half of the runs. In most of the other runs, the newcomer had to wait for the
# next announcement, so discovery took up to three seconds. So a `time.sleep(1.0)` before the first message works in one
# run and fails in the next. Wait for the match, not for a fixed time.

# %% [markdown] prediction="sixteen-pairs"
# ### All pairs, measured
#
# Reliability and durability have two values each, so there are four profiles. A publisher can offer any of the four,
# and a subscription can request any of the four, which makes sixteen pairs. Each publisher sends one message before the
# subscription exists, and five afterward. In how many pairs does at least one message arrive?
#
# - **a** 4: those with equal profiles on both sides.
#   when `hearing == 4`
#   ✗ The profiles don't have to be equal: an offer may be better than the request.
# - **b** 16: all of them, because the topic and the type match.
#   when `hearing == 16`
#   ✗ If the subscription requests more than the publisher offers, the two don't match.
# - **c** 9: those in which the subscription requests no more than the publisher offers.
#   when `hearing == 9`
#   ✓ For each policy, three of the four combinations match, and 3 × 3 is 9.

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
print("pairs that receive messages:    ", sum(hears.values()))
print("of these with equal QoS:        ", sum(with_equal_qos))
agree = [hears[pair] == foretold[pair] for pair in heard]
print("pairs that rclpy predicted:     ", sum(agree))
got_the_old = ["old" in messages for messages in heard.values()]
print("pairs that got the old message: ", sum(got_the_old))

# %% [markdown]
# Messages arrived in nine pairs, and in five of these, the two profiles differ. The *old* message, sent before the
# subscription existed, arrived in only one pair: the one in which *both* sides are reliable *and* transient local.
#
# **Your turn.** Write the rule that decides whether a pair matches. Here, each profile is a tuple of two levels, one
# for reliability and one for durability. Level 0 is the weaker value (best effort or volatile), and level 1 is the
# stronger one (reliable or transient local).

# %% id="your-rule"
from workbook.lesson import yours


def levels(name: str) -> tuple[int, int]:
    """The levels of a profile, from its name."""
    return int("RELIABLE" in name), int("TRANSIENT" in name)


def matches(offered: tuple[int, int], requested: tuple[int, int]) -> bool:
    """Return whether no request is higher than its offer."""
    return ...  # TODO: compare offered[0] with requested[0], and offered[1], too


found = [matches(levels(offered), levels(requested)) for offered, requested in heard]
yours(
    found,
    list(hears.values()),
    "offered[0] >= requested[0] and offered[1] >= requested[1]",
)

# %% [markdown]
# ## When it goes wrong
#
# **A different type in the same process.** In lesson 13, two processes used different types on the same topic, and Fast
# DDS logged nothing. Within one process, however, the middleware does compare the types:


# %% id="other-type" tags=["raises-exception"]
from std_msgs.msg import Float32


class Counter(Node):
    """Publishes numbers on a topic that carries text in this process."""

    def __init__(self) -> None:
        super().__init__("counter")
        self.create_publisher(Float32, "/ears", 10)


fresh(Counter)

# %% [markdown]
# The important part is in the middle of the error message: `existing topic name rt/ears with incompatible type`. (`rt`
# stands for "ROS topic".) Creating a subscription with a different type fails, too, but with a less helpful message:
# `invalid allocator`.

# %% [markdown]
# **Different domains.** In the next cell, the topic name, the type, and the QoS all match. Only the domains differ:

# %% id="other-domain"
from workbook.lesson.qos_trials import heard_between
from workbook.ros.domains import lease_domain

with lease_domain() as desk_a, lease_domain() as desk_b:
    print("desk A to desk A:", heard_between(desk_a, desk_a, LATCHED))
    print("desk A to desk B:", heard_between(desk_a, desk_b, LATCHED))

# %% [markdown]
# Like any other program, a tool such as `ros2 topic` runs in only one domain, so it can't show you both of these
# programs. If a topic isn't listed, the other program is in a different domain (`ROS_DOMAIN_ID`), it's on a different
# network, or it isn't running. If a topic is listed but no messages arrive, check the QoS and the types.
#
# **In a container: a topic is listed, but nothing arrives.** Fast DDS sends messages through shared memory (`/dev/shm`)
# if it detects that both programs are on the same machine. Suppose a container shares its host's network, but not
# `/dev/shm`. Then Fast DDS still assumes that the two programs are on the same machine. As a result, every topic is
# listed, but no message arrives. To fix this, share `/dev/shm` and run both programs as the same user (`--ipc=host`,
# `--user`). Or turn off shared memory, as this workbook does. `workbook doctor` checks all of these settings.

# %% [markdown]
# ## Take away
#
# - By default, messages published before the match are lost, even with reliable QoS. Wait until
#   `get_subscription_count()` is above 0, wait for the matched event, or make both sides transient local.
# - Discovery takes anywhere from milliseconds to seconds, so don't sleep for a fixed time.
# - Nine of the sixteen pairs match: those in which the subscription requests no more than the publisher offers.
# - If a topic isn't listed, check the domain and the network. If it's listed but no messages arrive, check the QoS, the
#   types, and shared memory.
#
# **Before:** [13 · QoS and discovery](13_qos_and_discovery.ipynb)
#
# **Next:** [14 · Arrays and filters](14_arrays_and_filters.ipynb)
#
# **More:** [About discovery](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Discovery.html)

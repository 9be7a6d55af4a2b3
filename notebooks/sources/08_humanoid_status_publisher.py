# %% [markdown]
# # 08 · The humanoid status publisher
#
# Every real robot regularly reports whether it's working and how much charge its battery has left. How do you build a
# node that publishes these reports reliably?
#
# - **Minutes:** 50
# - **You need:** lesson [05](05_timers.ipynb), and the basics of nodes, publishers, and messages
# - **You will be able to:**
#   - build a node that publishes to two topics at two rates
#   - send numbers so that they arrive unchanged
#   - count the subscriptions that are connected to a publisher
#   - say what happens after a callback raises an exception
#   - make a program exit with code 0 on Ctrl-C
# - **Not covered:** real battery sensors (`sensor_msgs/BatteryState`), multithreading, services

# %% [markdown]
# The next cell starts the finished node in a separate process.

# %%
from lesson_nodes import humanoid_status_publisher
from workbook.lesson import about, start, stop, watch_status

print("in the graph:", start(humanoid_status_publisher))

# %% [markdown]
# The dashboard subscribes to two topics: `/robot/status` controls the lamp, and `/robot/battery` controls the gauge.
# Each dot below marks the arrival of a message.

# %%
view = await watch_status(seconds=9)

# %%
print("the robot says:", view.status)
print("its battery level:", about(view.battery, "%", between=(95, 100), digits=3))
stop()

# %% [markdown]
# Compare the two rows of dots: how does their spacing differ?
#
# [the same without helpers: start]

# %% [markdown] prediction="the-dashboard-opens"
# ## Predict
#
# Two lines of the node set its publishing rates:
#
# ```python
# self.status_timer = self.create_timer(1.0, self.publish_status)
# self.battery_timer = self.create_timer(2.0, self.publish_battery)
# ```
#
# The node has been running for hours when an operator opens a dashboard. How long can it take, at most, before the
# dashboard shows the battery level?
#
# - **a** 0 s, because the dashboard requests the level from the node.
#   when `longest_wait_s < 0.5`
#   ✗ A subscriber can't request a value from a topic. It receives the next message that is published.
# - **b** 2 s, the period of the battery timer.
#   when `1.5 <= longest_wait_s < 2.6`
#   ✓ In the worst case, the subscriber has just missed a message. Then it waits for one period of that topic.
# - **c** 1 s, because by then, the node has published its next message.
#   when `0.5 <= longest_wait_s < 1.5`
#   ✗ A status message arrives within 1 s. But the battery has its own timer, with a longer period.
# - **d** 3 s: first the status, and then the battery.
#   when `longest_wait_s >= 2.6`
#   ✗ The timers don't wait for each other. Each one follows its own period.

# %%
from workbook.lesson import predict, reveal

predict("the-dashboard-opens")

# %% [markdown]
# ## Run it
#
# We'd like to record a minute of messages without waiting a whole minute for them. So `record` controls the robot's
# clock (simulated time, lesson 05), and one minute of *robot time* takes only a few seconds of real time.
#
# [the same without helpers: record]

# %%
from workbook.lesson import arrivals, record, values

STATUS, BATTERY = "/robot/status", "/robot/battery"
PERIODS = {STATUS: 1.0, BATTERY: 2.0}
minute = record(humanoid_status_publisher, PERIODS, seconds=60)

# %%
from workbook.pictures import show, timeline

show(timeline.timeline(minute, periods=PERIODS), timeline.describe(minute, PERIODS))

# %%
from itertools import pairwise
from statistics import median


def pace(recording, topic):
    """The usual time between two messages, in s of robot time."""
    times = arrivals(recording, topic)
    return median(later - earlier for earlier, later in pairwise(times))


for topic in (STATUS, BATTERY):
    seconds = pace(minute, topic)
    print(f"{topic:<15} every {seconds:.1f} s, so {60 / seconds:.0f} in a minute")
longest = max(b - a for a, b in pairwise(arrivals(minute, BATTERY)))
reveal("the-dashboard-opens", longest_wait_s=longest)

# %% [markdown]
# ## Look inside
#
# One thread runs the callbacks of both timers. Each timer callback is short: it fills in a message, publishes it, and
# returns. So one thread can handle many timers, as long as **each callback is fast**.
#
# Let's build the node step by step. Every topic needs three things: a **publisher**, a **timer**, and a **callback**
# that fills in a message and publishes it.

# %% [markdown]
# ### Step 1: one topic
#
# Find the publisher and the timer in `__init__`, and the callback below it.
#
# [the same without helpers: init, fresh, run]

# %%
from rclpy.node import Node
from std_msgs.msg import Float32, String

from workbook.lesson import fresh, init, run

init()


class OneTopic(Node):
    """Says once a second that the robot is well."""

    def __init__(self) -> None:
        super().__init__("humanoid_in_the_making")
        self.sent = 0
        self.status_publisher = self.create_publisher(String, "/robot/status", 10)
        self.status_timer = self.create_timer(1.0, self.publish_status)

    def publish_status(self) -> None:
        self.status_publisher.publish(String(data="operational"))
        self.sent += 1
        self.get_logger().info(f"status message {self.sent}")


humanoid = fresh(OneTopic)
await run(humanoid, until=lambda: humanoid.sent == 3, seconds=10)

# %% [markdown]
# ### Step 2: a battery that drains
#
# We don't have a battery, so we simulate one with a number that gets a little smaller with each tick. The number must
# never go below zero, because a subscriber might accept −0.1% as a real level.
#
# **Your turn.** Write the function that computes the next level. It lowers the level by 0.3, but never below 0.0.

# %% id="your-drain"
from workbook.lesson import yours

drained = ...  # TODO: a function of the level, such as lambda level: level - 0.3

level, seen = 0.8, []
for _ in range(4):
    level = level - 0.3 if drained is ... else drained(level)
    seen.append(round(level, 1))
print("levels:", *seen)
yours(
    ... if drained is ... else seen,
    [0.5, 0.2, 0.0, 0.0],
    "lambda level: max(0.0, level - 0.3)",
)

# %% [markdown]
# ### Step 3: the second topic
#
# An instance attribute, `self.battery_level`, stores the battery level between ticks. The status now depends on that
# level.

# %%
import random


class TwoTopics(OneTopic):
    """Reports the battery as well, every two seconds."""

    def __init__(self, battery_level: float = 100.0) -> None:
        super().__init__()
        self.battery_level = battery_level
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
        self.battery_timer = self.create_timer(2.0, self.publish_battery)

    def publish_status(self) -> None:
        state = "operational" if self.battery_level > 0.0 else "error"
        self.status_publisher.publish(String(data=state))
        self.sent += 1

    def publish_battery(self) -> None:
        self.battery_level = max(0.0, self.battery_level - random.uniform(0.1, 0.5))
        self.battery_publisher.publish(Float32(data=self.battery_level))


humanoid = fresh(TwoTopics)
await run(humanoid, until=lambda: humanoid.battery_level < 100.0, seconds=10)
drained_percent = 100.0 - humanoid.battery_level
print("drained by one message:", about(drained_percent, "%", between=(0.09, 0.51)))
humanoid.destroy_node()

# %% [markdown]
# ### Step 4: the finished node
#
# The class below, from `lesson_nodes/humanoid_status_publisher.py`, is the node whose messages you saw on the
# dashboard. Three things are new: named constants, a docstring that lists the topics, and a check of the initial level.

# %%
import inspect

from lesson_nodes.humanoid_status_publisher import HumanoidStatusPublisher

print(inspect.getsource(HumanoidStatusPublisher))

# %% [markdown]
# Adopt these three habits:
#
# - **List the topics in the docstring,** each with its type, rate, and meaning. The list is your contract with all
#   subscribers.
# - **Add type hints** (`-> None`, `battery_level: float`). Your editor and mypy use them, but ROS doesn't.
# - **State the unit of each quantity** in its name (`STATUS_PERIOD_S`) or in a comment (percent). Many bugs come from
#   passing hertz where seconds are expected.

# %% [markdown]
# ## Change it
#
# ### Experiment 1: until the battery is empty
#
# A full battery lasts about 11 minutes: it loses 0.3% per message on average, and there's a message every 2 s. To save
# time, this program creates the node with an initial level of just 10%.

# %%
# %%writefile evening.py
import rclpy
from lesson_nodes.humanoid_status_publisher import HumanoidStatusPublisher

rclpy.init()
rclpy.spin(HumanoidStatusPublisher(battery_level=10.0))

# %% [markdown] prediction="the-empty-battery"
# We record two minutes of robot time. At one of the battery timer's ticks, the level reaches 0.0. After that, how long
# can it take, at most, before `/robot/status` reports `error`?
#
# - **a** 0 s, because both callbacks share `self.battery_level`.
#   when `delay_s < 0.5`
#   ✗ They do share the level. But when the level changes, nothing calls the status callback, which has its own timer.
# - **b** 1 s, the period of the status timer.
#   when `0.5 <= delay_s < 1.5`
#   ✓ The status callback reads the level whenever its own timer ticks. The next tick comes after at most one period.
# - **c** 2 s, the period of the battery timer.
#   when `1.5 <= delay_s < 2.5`
#   ✗ The next battery message does come after 2 s. But the status callback reads the attribute, not the topic, so it
#   doesn't wait for a message.
# - **d** It never reports `error`, because the node chooses its status at startup.
#   when `delay_s >= 2.5`
#   ✗ The status callback chooses the status, so each message contains a new choice.

# %%
predict("the-empty-battery")

# %%
import math

evening = record("evening.py", PERIODS, seconds=120)
levels, words = values(evening, BATTERY), values(evening, STATUS)
empty_at = arrivals(evening, BATTERY)[levels.index(0.0)]
timed = zip(arrivals(evening, STATUS), words, strict=True)
error_at = min((t for t, word in timed if word == "error"), default=math.inf)

print(f"from 0.0 to error: {error_at - empty_at:.1f} s")
reveal("the-empty-battery", delay_s=error_at - empty_at)

# %% [markdown]
# In this run, both timers were due at the same moment, and the status callback ran first. So the next status message
# was a whole period away. That's the status topic. What does the node publish on `/robot/battery` once the battery is
# empty?

# %%
from workbook.pictures import figure
from workbook.pictures.palette import BLUE, GREEN, RED

empty = levels[levels.index(0.0) :]
print("lowest level:", min(levels))
print("messages since then:", about(len(empty), between=(10, 41)))
print("every one of them says:", *set(empty))
print(f"still one every {pace(evening, BATTERY):.1f} s")

fig, (upper, lower) = figure(7.2, 3.2, rows=2)
upper.step(arrivals(evening, BATTERY), levels, where="post", color=BLUE)
upper.set(ylabel="battery (%)", xlim=(0, 120), ylim=(-0.5, 10.5))
for word, color, sign in (("operational", GREEN, "o"), ("error", RED, "x")):
    timed = zip(arrivals(evening, STATUS), words, strict=True)
    times = [t for t, said in timed if said == word]
    lower.plot(times, [word] * len(times), sign, color=color, markersize=4)
lower.set(xlabel="robot time (s)", xlim=(0, 120), ylim=(-0.6, 1.6))
upper.set_title("The battery reaches zero, and the messages go on", fontsize=11)
show(
    fig,
    "the battery falls to zero and stays there; "
    "the status turns from operational to error",
)

# %% [markdown]
# A message that says 0.0 tells the operator what's wrong. Silence doesn't, because it could have several causes: an
# empty battery, a crashed program, or a broken network. So a status node should keep publishing as long as it can.
#
# ### Experiment 2: who is listening?
#
# A publisher can count the subscriptions that it's connected to. The next program, a monitor, kills itself when it
# receives its first message. It uses SIGKILL (`kill -9`), which ends a program immediately.

# %%
# %%writefile fragile_monitor.py
import os
import signal

import rclpy
from std_msgs.msg import String


def crash(message: String) -> None:
    os.kill(os.getpid(), signal.SIGKILL)


rclpy.init()
node = rclpy.create_node("fragile_monitor")
node.create_subscription(String, "/robot/status", crash, 10)
rclpy.spin(node)

# %% [markdown] prediction="who-is-counted"
# We create the humanoid in this notebook and start the monitor. The publisher's `get_subscription_count()` then returns
# 1. Now we publish one status message, so the monitor kills itself. What does the method return 0.5 s after the
# message, and what does it return after 10 s?
#
# DDS gives each program a **lease**, which expires unless the program renews it in time. In this course, a lease lasts
# 2 s (`workbook/ros/loopback.xml`). Fast DDS's default is 20 s.
#
# - **a** 0 both times, because Linux has closed all of the monitor's connections.
#   when `soon == 0`
#   ✗ Linux does close the monitor's UDP ports. But UDP has no connections, so other programs don't notice.
# - **b** The method raises an error, because the publisher's only subscriber is gone.
#   ✗ A topic without subscribers isn't an error in ROS. Subscribers may come and go.
# - **c** First 1, then 0.
#   when `soon == 1 and late == 0`
#   ✓ A killed program can't announce its end. DDS removes the monitor after receiving nothing from it for the length of
#   the lease.
# - **d** 1 both times, because the monitor never destroyed its subscription.
#   when `soon == 1 and late == 1`
#   ✗ The monitor didn't destroy it, but a killed program can't renew its lease, either. When the lease expires, DDS
#   removes the monitor's subscription.

# %%
predict("who-is-counted")

# %%
import time

humanoid = fresh(HumanoidStatusPublisher)
status = humanoid.status_publisher
print("started", start("fragile_monitor.py"))
end = time.monotonic() + 10.0
while status.get_subscription_count() == 0 and time.monotonic() < end:
    time.sleep(0.01)

humanoid.publish_status()
time.sleep(0.5)
soon = status.get_subscription_count()
time.sleep(9.5)
late = status.get_subscription_count()
print("listeners after 0.5 s:", soon)
print("listeners after 10 s: ", late)
reveal("who-is-counted", soon=soon, late=late)
stop()

# %% [markdown]
# So a killed program's subscriptions stay in the count until its lease expires. With Fast DDS's default of 20 s, both
# counts would be 1.
#
# The count is still useful when a program starts up. If a message is published before any subscription is connected,
# the message is lost ([lesson 00](00_start_here.ipynb)). So a program can wait until the count is above 0. The next
# cell doesn't wait:
#
# [the same without helpers: spin_for]

# %% id="late-listener"
import rclpy

from workbook.lesson import spin_for

for _ in range(3):
    humanoid.publish_status()

heard = []
listener = fresh(lambda: rclpy.create_node("late_listener"))
listener.create_subscription(
    String, STATUS, lambda message: heard.append(message.data), 10
)
spin_for(listener, seconds=10, until=lambda: status.get_subscription_count() == 1)
spin_for(listener, seconds=0.5)
print("heard of the three messages:", len(heard))

humanoid.publish_status()
spin_for(listener, seconds=10, until=lambda: heard)
print("heard after one more:", len(heard))

# %% [markdown]
# The `10` in `create_publisher(..., 10)` is the queue depth. It applies only to connected subscriptions: the publisher
# keeps no messages for subscriptions that connect later. (QoS can change that: lesson 13.)
#
# **Your turn.** Suppose that a node publishes just one message on `/robot/started`. Write the condition that the node
# should wait for before publishing.

# %% id="your-condition"
started = humanoid.create_publisher(String, "/robot/started", 10)

ready = ...  # TODO: a function without arguments: does started have a subscription?

if ready is not ...:
    heard = []
    log = fresh(lambda: rclpy.create_node("log"))
    log.create_subscription(
        String, "/robot/started", lambda message: heard.append(message.data), 10
    )
    spin_for(log, seconds=10, until=ready)
    started.publish(String(data="started"))
    spin_for(log, seconds=1.0)
    log.destroy_node()
yours(
    ... if ready is ... else heard,
    ["started"],
    "lambda: started.get_subscription_count() > 0",
)

# %% [markdown]
# Now let's add two more subscribers: a monitor in a separate process, and the dashboard in this notebook. The graph is
# drawn while the dashboard is open.

# %%
import asyncio

from lesson_nodes import status_monitor
from workbook.lesson import graph_picture

print("started", start(status_monitor))
opened = asyncio.create_task(watch_status(seconds=5))
await run(listener, until=lambda: status.get_subscription_count() == 3, seconds=10)

humanoid.publish_status()
humanoid.battery_publisher.publish(Float32(data=80.0))
listeners = humanoid.status_publisher.get_subscription_count()
network = graph_picture("/humanoid_status_publisher")
await opened
print("listeners while the dashboard was open:", listeners)
stop()
listener.destroy_node()
humanoid.destroy_node()
network

# %% [markdown] prediction="the-exception"
# ## When it goes wrong
#
# ### An exception in a background thread
#
# Many programs spin in a background thread to keep the main thread free. The node below publishes its status ten times
# a second. Another timer's callback estimates how long the battery will last, and divides by zero the second time it's
# called. What happens to the status messages?
#
# - **a** The program ends with a traceback and a nonzero exit code.
#   when `exit_code != 0`
#   ✗ The exception ends only the thread that spins. The main thread continues and ends with exit code 0.
# - **b** Only the estimate stops. The status continues, because the timers are independent.
#   when `in_the_last_second > 0`
#   ✗ A single thread runs both timers' callbacks, and the exception has ended that thread.
# - **c** Both timers stop, but the program keeps running and looks fine from the outside.
#   when `exit_code == 0 and in_the_last_second == 0`
#   ✓ The thread that spins has ended, so no callback runs anymore. But the node is still in the graph.

# %%
predict("the-exception")

# %% [markdown]
# The next cell prints the numbers that the program's main thread measured, followed by the program's exit code.

# %% id="deaf-node"
from workbook.lesson import run_program


def said(outcome):
    """The lines that a program has printed with `main:` in front."""
    lines = [line for line in outcome.log.splitlines() if line.startswith("main:")]
    return "\n".join(line.removeprefix("main: ") for line in lines)


PROGRAM = """
import threading, time
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Humanoid(Node):
    def __init__(self):
        super().__init__("humanoid")
        self.sent, self.last_word, self.drain = 0, "", 1.0
        self.status_publisher = self.create_publisher(String, "/robot/status", 10)
        self.create_timer(0.1, self.publish_status)
        self.create_timer(0.3, self.estimate)

    def publish_status(self):
        self.last_word = "operational"
        self.status_publisher.publish(String(data=self.last_word))
        self.sent += 1

    def estimate(self):
        minutes_left = 99.0 / self.drain
        self.drain -= 1.0

rclpy.init()
humanoid = Humanoid()
spinning = threading.Thread(target=rclpy.spin, args=(humanoid,), daemon=True)
spinning.start()
time.sleep(3.0)  # the main thread is busy with other things

before = humanoid.sent
time.sleep(1.0)
print("main: status messages in the last second:", humanoid.sent - before)
print("main: the last status:", humanoid.last_word)
print("main: in the graph:", *humanoid.get_node_names())
rclpy.try_shutdown()
"""
outcome = run_program(PROGRAM, seconds=20)
print(said(outcome))
print("exit code", outcome.exit)
reveal(
    "the-exception",
    exit_code=outcome.exit,
    in_the_last_second=int(said(outcome).splitlines()[0].split()[-1]),
)

# %% [markdown]
# The exception ended the *thread*, but not the program. The node is still in the ROS graph, so `ros2 node list` shows
# it. The last status that it published was *operational*. But none of the node's callbacks run anymore: no timer fires,
# and no message is received. Even the exit code, 0, suggests that all went well. The only sign of the problem is the
# traceback in the log, which was printed once.
#
# `await run(...)` spins the node in the notebook's own thread, so this time the exception shows up in the cell's
# output:

# %% tags=["raises-exception"]
class Forecaster(Node):
    """Estimates how long the battery will last."""

    def __init__(self) -> None:
        super().__init__("forecaster")
        self.drain = 1.0
        self.create_timer(0.3, self.estimate)

    def estimate(self) -> None:
        self.get_logger().info(f"{99.0 / self.drain:.0f} minutes left")
        self.drain -= 1.0


await run(fresh(Forecaster), seconds=10)

# %% [markdown]
# Here's how to keep a node from stopping silently, or at least to notice when it does:
#
# - In a program, run `rclpy.spin(node)` in the **main thread**. An exception then ends the program with a traceback,
#   and a service manager can restart it.
# - If you have to spin in another thread, check `thread.is_alive()` regularly, and react if it returns `False`.
# - Have another node raise an alarm if it receives no status for 3 s.
#
# ### An int in a float field
#
# `Float32(data=round(level))` puts an int into a float field (lesson 03). The result is **a wrong value or a crash,
# depending on the build.** This course's packages send 0.0 without an error. The Ubuntu packages can abort the whole
# process ([rclpy #1437](https://github.com/ros2/rclpy/issues/1437), [diagnostics
# #427](https://github.com/ros/diagnostics/issues/427)). If the environment variable
# `ROS_PYTHON_CHECK_FIELDS=1` is set, as in this notebook, you get an exception instead:

# %% id="whole-percents" tags=["raises-exception"]
Float32(data=round(99.4))

# %% [markdown]
# ### Ending on Ctrl-C
#
# In lesson 01, you saw three ways to end a program. A status node must end cleanly, because a service manager reads its
# exit code. The next cell runs the node with two different endings: `COMMON`, which many examples on the web use, and
# `CLEAN`.

# %% id="endings"
BEGIN = """
import rclpy
from rclpy.executors import ExternalShutdownException
from lesson_nodes.humanoid_status_publisher import HumanoidStatusPublisher

rclpy.init()
humanoid = HumanoidStatusPublisher()
"""
COMMON = """
try:
    rclpy.spin(humanoid)
except KeyboardInterrupt:
    pass
finally:
    humanoid.destroy_node()
    rclpy.shutdown()
"""
CLEAN = """
try:
    rclpy.spin(humanoid)
except (KeyboardInterrupt, ExternalShutdownException):
    pass
finally:
    rclpy.try_shutdown()
"""
for name, ending in {"COMMON": COMMON, "CLEAN": CLEAN}.items():
    outcome = run_program(BEGIN + ending, seconds=15, interrupt_at="Status:")
    last_line = outcome.log.strip().splitlines()[-1].split(", at ")[0]
    last_line = last_line if "Traceback" in outcome.log else "no traceback"
    print(f"{name:<8} exit code {outcome.exit:>3}   {last_line}")

# %% [markdown]
# `COMMON` fails because Ctrl-C has already shut the context down, and `rclpy.shutdown()` then tries to shut it down a
# second time. `CLEAN` works because `try_shutdown()` does nothing if the context is already shut down.
#
# One caveat: `try_shutdown()` first checks whether the context is still up and then shuts it down. On a very busy
# machine, Ctrl-C can shut the context down [between those two
# steps](https://github.com/ros2/rclpy/blob/jazzy/rclpy/rclpy/context.py). Then `CLEAN` ends like `COMMON`. That's a bug
# in rclpy, and `%check` doesn't count it against you.

# %% [markdown]
# ## From a worked example to your own
#
# **Worked example.** This node publishes the motors' temperature to one topic at 2 Hz. It has type hints, sends a real
# float, and ends cleanly. The cell sends Ctrl-C after the first message.

# %%
WORKED = """
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32

TEMPERATURE_PERIOD_S = 0.5  # 2 Hz


class MotorThermometer(Node):
    '''Publishes /robot/motor_temperature (std_msgs/Float32, degrees Celsius), 2 Hz.'''

    def __init__(self) -> None:
        super().__init__("motor_thermometer")
        self.celsius = 20.0
        self.publisher = self.create_publisher(Float32, "/robot/motor_temperature", 10)
        self.timer = self.create_timer(TEMPERATURE_PERIOD_S, self.publish_temperature)

    def publish_temperature(self) -> None:
        self.celsius = min(70.0, self.celsius + 0.5)
        self.publisher.publish(Float32(data=self.celsius))
        print("main: sent", self.celsius, flush=True)


rclpy.init()
try:
    rclpy.spin(MotorThermometer())
except (KeyboardInterrupt, ExternalShutdownException):
    pass
finally:
    rclpy.try_shutdown()
"""
outcome = run_program(WORKED, seconds=15, interrupt_at="sent")
print(said(outcome).splitlines()[0])
print("exit code", outcome.exit)

# %% [markdown]
# **Fill in the blanks.** A node in the robot's foot counts steps. Every four seconds, it publishes the count to
# `/robot/steps` as a `Float32`. Fill in the three blanks: the period, the float, and the ending. When you run the cell,
# it starts the program and sends Ctrl-C after the first message.

# %% id="your-step-counter"
FADED = """
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32

STEPS_PERIOD_S = ...  # TODO: 0.25 Hz


class StepCounter(Node):
    '''Publishes /robot/steps (std_msgs/Float32, steps since the start), 0.25 Hz.'''

    def __init__(self) -> None:
        super().__init__("step_counter")
        self.steps = 0
        self.publisher = self.create_publisher(Float32, "/robot/steps", 10)
        self.timer = self.create_timer(STEPS_PERIOD_S, self.publish_steps)

    def publish_steps(self) -> None:
        self.steps += 1
        message = Float32(data=...)  # TODO: self.steps is an int
        self.publisher.publish(message)
        print("main: sent", message.data, "period", STEPS_PERIOD_S, flush=True)


rclpy.init()
try:
    rclpy.spin(StepCounter())
except (KeyboardInterrupt, ExternalShutdownException):
    pass
finally:
    ...  # TODO: end without an error, also after Ctrl-C
"""
if "..." not in FADED:
    outcome = run_program(FADED, seconds=15, interrupt_at="sent")
    print(outcome.log)
yours(
    ... if "..." in FADED else (said(outcome), outcome.exit),
    ("sent 1.0 period 4.0", 0),
    "4.0, float(self.steps), and rclpy.try_shutdown()",
)

# %% [markdown]
# **Your own.** The [exercise](../exercises/08_humanoid_status_publisher.ipynb) gives you a status publisher with three
# bugs, all of which appear in this lesson. The judge checks the messages that arrive on the topics, and how your
# program ends.

# %% [markdown]
# ## Check yourself
#
# **1. The battery is empty. What should a status node do?**
#
# <details><summary>a) Stop publishing, because silence means that the battery is empty</summary>
#
# ✗ Silence can also mean a crashed program or a broken network. A monitor can't tell the difference.
#
# </details>
# <details><summary>b) Keep publishing 0.0 and <code>error</code></summary>
#
# ✓ Then every subscriber knows what's wrong, even one that has just started.
#
# </details>
# <details><summary>c) End with a nonzero exit code</summary>
#
# ✗ Only a service manager on the robot reads the exit code. Subscribers just stop receiving messages.
#
# </details>
#
# **2. The dashboard shows 0.0%, but the node's log says 87%. What do you suspect first?**
#
# <details><summary>a) Messages get lost on the way</summary>
#
# ✗ If a message is lost, the dashboard keeps showing the old number. The number doesn't become zero.
#
# </details>
# <details><summary>b) The queue depth of 10 is too small</summary>
#
# ✗ The depth limits how many messages can wait. It never changes their content.
#
# </details>
# <details><summary>c) The level in the message isn't a Python float</summary>
#
# ✓ In this build, an int, str, or bool in a float field is sent as a wrong value, usually 0.0. The Ubuntu packages may
# abort the process.
#
# </details>
#
# **3. A node is in the graph. Its last status, a minute ago, was "operational". Nothing has arrived since. What is the likely cause?**
#
# <details><summary>a) An exception ended the thread that spins the node</summary>
#
# ✓ The node object still exists, so the node is in the graph. But no thread runs its timer callbacks anymore.
#
# </details>
# <details><summary>b) There's no problem: no news is good news</summary>
#
# ✗ A status topic with a fixed rate is a heartbeat. If it stops, something is wrong.
#
# </details>
# <details><summary>c) The node paused, because all of its subscribers are gone</summary>
#
# ✗ `publish()` works without subscribers, as you've seen.
#
# </details>
#
# **4. A node publishes `started` once, with a queue depth of `10`. Its only subscriber is running. How do you make sure that the message arrives?**
#
# <details><summary>a) Publish it right after <code>create_publisher</code>, with a depth of 100</summary>
#
# ✗ The queue holds messages only for connected subscriptions, and at that moment, there may not be any.
#
# </details>
# <details><summary>b) Publish it once <code>get_subscription_count()</code> is above 0</summary>
#
# ✓ By then, the publisher has discovered the subscription, and DDS delivers the message to it.
#
# </details>
# <details><summary>c) Publish it three times in a row, in case one message gets lost</summary>
#
# ✗ If no subscription is connected yet, all three messages are lost.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Read this prompt and write down your own answer. Then copy the prompt into an AI assistant, or discuss it with a
# colleague.
#
# ```text
# I'm programming a robot with ROS 2 Jazzy in Python (rclpy). One node of my humanoid
# publishes its status at 1 Hz and its battery level at 0.5 Hz. A monitor on another
# computer should stop the robot if something is wrong. What can the monitor conclude from
# a message, and what can it conclude from a missing one? How long should it wait before
# it raises an alarm? Make sure that every rclpy function you use exists in Jazzy.
# ```
#
# <details><summary>What a good answer covers</summary>
#
# A message contains the node's state at the time of publishing. A missing message can mean a dead process, a node
# that's no longer being spun, a blocked callback, or a broken network. From the outside, a monitor can't tell these
# causes apart. A single late message shouldn't raise an alarm, because timers and networks jitter. Waiting two to three
# periods is a common compromise.
#
# A good answer says what the robot should do while messages are missing: slow down, stop, or sit down. It also covers
# the reverse case: if the monitor's messages no longer reach the robot, the robot may have to stop on its own. The best
# answers also mention that ROS can detect late messages for you, through the deadline QoS policy.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Watch for these two suggestions. We tested both with the rclpy version that this course uses, and both are wrong.
#
# - **`finally: node.destroy_node(); rclpy.shutdown()`:** After Ctrl-C, the context is already shut down. A second
#   `shutdown` raises `rcl_shutdown already called`, and the exit code is 1. Use `rclpy.try_shutdown()`.
# - **`create_publisher(String, "status", queue_size=10)`:** That's ROS 1. In rclpy, the third argument is the QoS, and
#   it's required.
#
# </details>

# %% [markdown]
# ## Take away
#
# - `create_timer` takes a period in seconds, so for 0.5 Hz, pass 2.0.
# - For each topic, create a publisher, a timer, and a short callback. One thread can run many such callbacks.
# - Put only Python `float` values into a float field. Other types lead to a wrong value or a crash, depending on the
#   build.
# - If a background thread spins a node, an exception stops all of the node's callbacks, but the node stays in the
#   graph.
# - End with `except (KeyboardInterrupt, ExternalShutdownException)` and `rclpy.try_shutdown()` so that the exit code is
#   0.
#
# **Before:** [07 · Typed nodes](07_typed_nodes.ipynb)
#
# **Next:** [09 · The joint positions](09_joint_positions.ipynb), a third topic, for the movements of the whole robot
#
# **More:** [Writing a simple publisher and
# subscriber](https://docs.ros.org/en/jazzy/Tutorials/Beginner-Client-Libraries/Writing-A-Simple-Py-Publisher-And-Subscriber.html)
# and [About topics](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Topics.html)

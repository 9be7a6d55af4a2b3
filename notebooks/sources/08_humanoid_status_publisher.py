# %% [markdown]
# # 08 · The humanoid status publisher
#
# Every real robot reports again and again that it works, and how much battery is left. How do you build a node that does
# this reliably?
#
# - **Minutes:** 45
# - **You need:** lesson [05](05_timers.ipynb), and what a node, a publisher and a message are
# - **You will be able to:**
#   - build a node with two topics at two rates
#   - send numbers that really arrive
#   - count the listeners
#   - say what follows when a callback raises an exception
#   - end a node on Ctrl-C with exit code 0
# - **Left out:** real battery sensors (`sensor_msgs/BatteryState`), several threads, services

# %% [markdown]
# The next cell starts the finished node, as a program of its own.

# %%
from lesson_nodes import humanoid_status_publisher
from workbook.lesson import start, stop, watch_status

print("on the graph:", start(humanoid_status_publisher))

# %% [markdown]
# The dashboard listens to two topics: `/robot/status` lights the lamp, `/robot/battery` fills the gauge.
# Each dot below is a message at the moment it arrived.

# %%
view = await watch_status(seconds=9)

# %%
print("the robot says:", view.status)
print("battery still nearly full:", 90.0 < view.battery < 100.0)
stop()

# %% [markdown]
# Compare the two rows of dots.

# %% [markdown] prediction="the-dashboard-opens"
# ## Predict
#
# Two lines of the node give it its rhythm:
#
# ```python
# self.status_timer = self.create_timer(1.0, self.publish_status)
# self.battery_timer = self.create_timer(2.0, self.publish_battery)
# ```
#
# An operator opens a dashboard while the node has been running for hours. How long does it take, at most, until the
# dashboard shows the battery?
#
# - **a** No time: the dashboard asks the node for the level.
#   when `longest_wait_s < 0.5`
#   ✗ On a topic nobody asks. A subscription gets the next message that is published.
# - **b** 2 s: one period of the battery's timer.
#   when `1.5 <= longest_wait_s < 2.6`
#   ✓ A subscriber that has just missed a message waits one period of that topic. That is the longest wait.
# - **c** 1 s: then the next message of this node comes.
#   when `0.5 <= longest_wait_s < 1.5`
#   ✗ After 1 s at most there is a status. The battery has a timer of its own, with a longer period.
# - **d** 3 s: first comes the status, then the battery.
#   when `longest_wait_s >= 2.6`
#   ✗ The timers do not take turns. Each one follows its own period.

# %%
from workbook.lesson import predict, reveal

predict("the-dashboard-opens")

# %% [markdown]
# ## Run it
#
# We do not wait for a minute. The recorder drives the robot's clock (simulated time, lesson 05): one minute of robot time
# takes a few real seconds.

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
# Both timers are served by one thread. A timer callback is short: fill a message, publish it, return. So there is room for
# many timers, as long as **each callback is quick**.
#
# We build the node step by step. Every topic needs three things: a **publisher**, a **timer** and a **callback** that
# fills a message.

# %% [markdown]
# ### Step 1: one topic
#
# Find the three things in `__init__` and below it. `init()` joins this notebook to ROS, as `rclpy.init()` does for a
# program; here the cell may be run again.

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
# We have no battery, so we simulate one: a number that decreases a little each time. `max(0.0, ...)` keeps it from going
# below zero. A program that receives −0.1 % might believe it.

# %%
careless = careful = 0.8
for _ in range(4):
    careless = careless - 0.3
    careful = max(0.0, careful - 0.3)
    print(f"careless {careless:5.1f} %    with a floor {careful:4.1f} %")

# %% [markdown]
# ### Step 3: the second topic
#
# The level is kept in `self` from tick to tick. The status now depends on the battery.

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
print("drained by one message, 0.1 to 0.5 %:", 99.5 <= humanoid.battery_level <= 99.9)
humanoid.destroy_node()

# %% [markdown]
# ### Step 4: the finished node
#
# This class from `lesson_nodes/humanoid_status_publisher.py` drove the dashboard. Three things are new: names for the
# numbers, a docstring that lists the topics, and a check of the start value.

# %%
import inspect

from lesson_nodes.humanoid_status_publisher import HumanoidStatusPublisher

print(inspect.getsource(HumanoidStatusPublisher))

# %% [markdown]
# Three habits to copy:
#
# - **Topics in the docstring**, with type, rate and meaning. It is the contract with all subscribers.
# - **Type hints** (`-> None`, `battery_level: float`). Your editor and mypy read them. ROS does not.
# - **A unit in each name or comment** (`STATUS_PERIOD_S`, percent). Many bugs come from hertz where seconds are
#   expected.

# %% [markdown]
# ## Change it
#
# ### Experiment 1: until the battery is empty
#
# A full battery takes about 11 minutes to run empty: 0.3 % per message on average, one message every 2 s. So we begin
# with 10 %. This program gives the class another start value.

# %%
# %%writefile evening.py
import rclpy
from lesson_nodes.humanoid_status_publisher import HumanoidStatusPublisher

rclpy.init()
rclpy.spin(HumanoidStatusPublisher(battery_level=10.0))

# %% [markdown] prediction="the-empty-battery"
# We record two minutes of robot time. At some tick of the battery's timer, the level becomes 0.0. How long does it take
# then, at most, until `/robot/status` says `error`?
#
# - **a** No time: both callbacks share `self.battery_level`.
#   when `delay_s < 0.5`
#   ✗ They share the level. But nothing calls the status callback when the level changes: it has a timer of its own.
# - **b** 1 s: the period of the status.
#   when `0.5 <= delay_s < 1.5`
#   ✓ The status callback reads the level when its own timer ticks. The next tick comes after one period at most.
# - **c** 2 s: the period of the battery.
#   when `1.5 <= delay_s < 2.5`
#   ✗ The next battery message comes after 2 s. The status does not wait for it: it reads the level, not the topic.
# - **d** It never says so: the node had chosen its word when it started.
#   when `delay_s >= 2.5`
#   ✗ The word is chosen in the callback, so it is chosen anew for each message.

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
# Here both timers are due at the same moment, and the status comes first. So its next message is a whole period away.
# What does `/robot/battery` say from then on?

# %%
from workbook.pictures import figure
from workbook.pictures.palette import BLUE, GREEN, RED

empty = levels[levels.index(0.0) :]
print("lowest level:", min(levels))
print("more than ten messages since then:", len(empty) > 10)
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
upper.set_title("the battery reaches zero, and the messages go on", fontsize=11)
show(
    fig,
    "the battery falls to zero and stays there; "
    "the status turns from operational to error",
)

# %% [markdown]
# A message that says 0.0 tells a monitor what is wrong. Silence does not: is the battery empty, has the program crashed,
# or is the network down? So a status node keeps publishing as long as it can.
#
# ### Experiment 2: who is listening?
#
# A publisher can count its listeners. Here is one that is killed by its first message. SIGKILL (`kill -9`) ends a
# program at once.

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
# We make the humanoid here, and start this monitor. `get_subscription_count()` of the publisher returns 1. Then we
# publish one status. What does it return after half a second, and what after 10 s?
#
# In this course, DDS gives each program a **lease** of 2 s (`workbook/ros/loopback.xml`). The default of Fast DDS is 20 s.
#
# - **a** 0 both times: Linux has closed all connections of the monitor.
#   when `soon == 0`
#   ✗ Linux closes its UDP ports. But UDP has no connections, so no other program learns of that.
# - **b** It raises an error, because the listener is lost.
#   ✗ A topic without a listener is no error in ROS. Listeners may come and go.
# - **c** First 1, then 0.
#   when `soon == 1 and late == 0`
#   ✓ A killed program cannot sign off. DDS takes it off its list when nothing has come from it for the time of its lease.
# - **d** 1 both times: a lease says how old a message may get.
#   when `soon == 1 and late == 1`
#   ✗ That is the lifespan, another setting. A program renews its lease again and again. A killed one does not.

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
# With the default of 20 s, both counts are 1. So the count says who was found, not who is alive.
#
# It is useful at the start. A message without a listener is gone ([lesson 00](00_start_here.ipynb)). A program can wait
# until the count is above 0. This one does not wait:

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
# The `10` in `create_publisher(..., 10)` is the publisher's queue depth for connected subscriptions. It does not keep
# messages for later ones. (QoS can do that: lesson 13.)
#
# Two more listeners: a monitor as a program of its own, and the dashboard in this notebook.

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
network

# %% [markdown]
# The graph was drawn while the dashboard was open.

# %%
stop()
listener.destroy_node()
humanoid.destroy_node()

# %% [markdown] prediction="the-exception"
# ## When it goes wrong
#
# ### An exception in a background thread
#
# Many programs spin in a background thread, to keep the main thread free. This node publishes its status ten times a
# second. A second timer estimates how long the battery will last, and divides by zero the second time. What happens to
# the status?
#
# - **a** The program ends with a traceback and an exit code that is not 0.
#   when `exit_code != 0`
#   ✗ The exception ends the thread that spins, not the program. The main thread goes on and ends with 0.
# - **b** The estimate is missing, the status goes on: the timers are independent.
#   when `in_the_last_second > 0`
#   ✗ Both timers are called by one thread, and the exception has ended it.
# - **c** All timers stop, the program lives on, and from outside everything looks fine.
#   when `exit_code == 0 and in_the_last_second == 0`
#   ✓ The thread that spins is gone, so no callback runs any more. The node is still on the graph.

# %%
predict("the-exception")

# %% [markdown]
# We print what its main thread measures, and its exit code.

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
print("main: node on the graph:", "humanoid" in humanoid.get_node_names())
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
# The exception has ended the *thread*, not the program. The node is still on the graph, so `ros2 node list` shows it. Its
# last message was *operational*. No timer fires, no message is read: the node is **deaf**. Even the exit code is 0.
# rclpy printed the traceback once, somewhere in the log.
#
# `await run(...)` spins in the thread of this notebook, so here the exception appears in your cell:

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
# How to fix it:
#
# - In a program, let `rclpy.spin(node)` run in the **main thread**. An exception then ends the program with a traceback,
#   and it can be restarted.
# - If it must be a thread, check `thread.is_alive()` regularly, and act on it.
# - Let another node raise an alarm when no status has come for 3 s.
#
# ### Whole percents
#
# `Float32(data=round(level))` puts an int into a float field (lesson 03). The result is **a wrong value or a crash,
# depending on the build.** The packages of this course send 0.0 without an error. The Ubuntu packages can abort the
# whole process ([rclpy #1297](https://github.com/ros2/rclpy/issues/1297), [#1437](https://github.com/ros2/rclpy/issues/1437),
# [diagnostics #427](https://github.com/ros/diagnostics/issues/427)). With `ROS_PYTHON_CHECK_FIELDS=1` in the
# environment, as in this notebook, you get an exception instead:

# %% id="whole-percents" tags=["raises-exception"]
Float32(data=round(99.4))

# %% [markdown]
# ### The end on Ctrl-C
#
# Lesson 01 has three endings of a program. A status node needs the clean one, because a service manager reads the exit
# code. This cell runs the ending of many examples on the web, and the clean one:

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
# `COMMON` fails because Ctrl-C has already shut the context down, and `rclpy.shutdown()` does it a second time.
# `try_shutdown()` does nothing then. One caveat: on a very busy machine the shutdown by Ctrl-C can fall
# [between its check and its call](https://github.com/ros2/rclpy/blob/jazzy/rclpy/rclpy/context.py), and `CLEAN` ends like
# `COMMON`. That is a fault of rclpy, and `%check` does not count it.

# %% [markdown]
# ## From a worked example to your own
#
# **Worked.** A node reports the temperature of the motors: one topic at 2 Hz, type hints, a real float, a clean end. The
# cell sends Ctrl-C after the first message.

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
# **Faded.** Now the foot counts its steps, and reports them on `/robot/steps` once every four seconds, as a `Float32`.
# Fill in three blanks `___`: the period, the float, and how the program ends. You are done when it prints `sent 1.0`
# and exit code 0.

# %%
FADED = """
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32

STEPS_PERIOD_S = ___  # 0.25 Hz


class StepCounter(Node):
    '''Publishes /robot/steps (std_msgs/Float32, steps since the start), 0.25 Hz.'''

    def __init__(self) -> None:
        super().__init__("step_counter")
        self.steps = 0
        self.publisher = self.create_publisher(Float32, "/robot/steps", 10)
        self.timer = self.create_timer(STEPS_PERIOD_S, self.publish_steps)

    def publish_steps(self) -> None:
        self.steps += 1
        message = Float32(data=___)  # self.steps is an int
        self.publisher.publish(message)
        print("main: sent", message.data, flush=True)


rclpy.init()
try:
    rclpy.spin(StepCounter())
except (KeyboardInterrupt, ExternalShutdownException):
    pass
finally:
    ___
"""
outcome = run_program(FADED, seconds=15, interrupt_at="sent")
print(said(outcome) or outcome.log.strip().splitlines()[-1])
print("exit code", outcome.exit)

# %% [markdown]
# **Your own.** The [exercise](../exercises/08_humanoid_status_publisher.ipynb) gives you a status publisher with three
# bugs. All three are in this lesson. It is judged by what arrives on the topics, and by how your program ends.

# %% [markdown]
# ## Check yourself
#
# **1. The battery is empty. What should a status node do?**
#
# <details><summary>a) Stop publishing: a silent robot is an empty robot</summary>
#
# ✗ Silence can also mean a crashed program or a network that is down. A monitor cannot tell.
#
# </details>
# <details><summary>b) Go on publishing: 0.0, and <code>error</code></summary>
#
# ✓ Then every listener knows what is wrong, even one that has just started.
#
# </details>
# <details><summary>c) End with an exit code that is not 0</summary>
#
# ✗ A service manager on the robot reads that. The listeners on the topics get only silence.
#
# </details>
#
# **2. The dashboard shows 0.0 % and the log of the node says 87 %. What do you suspect first?**
#
# <details><summary>a) Messages are lost on the way</summary>
#
# ✗ A lost message leaves the old number on the dashboard. It does not become zero.
#
# </details>
# <details><summary>b) The queue depth of 10 is too small</summary>
#
# ✗ The depth says how many messages may wait. It never changes what is in them.
#
# </details>
# <details><summary>c) The level in the message is not a Python float</summary>
#
# ✓ In this build, an int, a str or a bool in a float field is sent as a wrong value, mostly 0.0. The Ubuntu packages may
# abort the process.
#
# </details>
#
# **3. A node is on the graph, its last status was "operational", and nothing has come for a minute. What is likely?**
#
# <details><summary>a) An exception has ended the thread that spins</summary>
#
# ✓ The node object still exists, so the graph shows it, but nothing calls its timers any more.
#
# </details>
# <details><summary>b) Nothing, no news is good news</summary>
#
# ✗ A status topic with a rate is a heartbeat. When it stops, something is wrong.
#
# </details>
# <details><summary>c) All its listeners have gone, so it has paused</summary>
#
# ✗ `publish()` works without listeners. You have tried it.
#
# </details>
#
# **4. A node publishes `started` once, with QoS `10`. Its only listener is running. How do you make sure that it arrives?**
#
# <details><summary>a) Publish it as the first line after <code>create_publisher</code>, with depth 100</summary>
#
# ✗ The depth counts for subscriptions that are connected. At that moment there may be none.
#
# </details>
# <details><summary>b) Publish it when <code>get_subscription_count()</code> is above 0</summary>
#
# ✓ Then the publisher has found the subscription of its listener, and DDS delivers the message to it.
#
# </details>
# <details><summary>c) Publish it three times in a row, in case one gets lost</summary>
#
# ✗ If no listener is connected yet, all three are gone.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Copy the prompt for an AI assistant, or discuss it with a colleague. State your own view first.
#
# ```text
# I program a robot with ROS 2 Jazzy in Python (rclpy). My humanoid publishes its status
# at 1 Hz and its battery at 0.5 Hz from one node. A monitor on another computer should
# stop the robot when something is wrong. What can it conclude from a message, and what
# from a missing one? How long should it wait before it calls silence an alarm? Name
# only functions that exist in rclpy for Jazzy.
# ```
#
# <details><summary>What a good answer contains</summary>
#
# A message says what the node believed when it was sent. A missing message can mean a dead process, a deaf node, a blocked
# callback, or a network that is down. They look the same from outside. One late message is no alarm, since timers and
# networks jitter: two to three periods are a common compromise. A good answer says what the robot does meanwhile (slow
# down, stop, sit down). It also says that the robot may have to stop on its own when the *robot* no longer hears the
# monitor. A plus: ROS can watch this for you, with a deadline in the QoS.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Two claims you may meet. Both are wrong: each was tried with the rclpy of this course.
#
# - **`finally: node.destroy_node(); rclpy.shutdown()`:** After Ctrl-C the context is already shut down. A second
#   `shutdown` raises `rcl_shutdown already called`, and the exit code is 1. Use `rclpy.try_shutdown()`.
# - **`create_publisher(String, "status", queue_size=10)`:** That is ROS 1. In rclpy the third argument is the QoS, and
#   it is required.
#
# </details>

# %% [markdown]
# ## Take away
#
# - Each topic needs a publisher, a timer and a short callback; many fit into one thread.
# - `create_timer` takes seconds: 0.5 Hz is 2.0.
# - Put only a Python `float` into a float field. Anything else gives a wrong value or a crash, depending on the build.
# - An exception in a background spin stops all callbacks of a node, and the node stays on the graph.
# - End with `except (KeyboardInterrupt, ExternalShutdownException)` and `rclpy.try_shutdown()`.
#
# **Before:** [07 · Typed nodes](07_typed_nodes.ipynb)
#
# **Next:** [09 · The joint positions](09_joint_positions.ipynb), a third topic that moves the whole robot.
#
# **More:** [Writing a simple publisher and
# subscriber](https://docs.ros.org/en/jazzy/Tutorials/Beginner-Client-Libraries/Writing-A-Simple-Py-Publisher-And-Subscriber.html)
# and [About topics](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Topics.html).

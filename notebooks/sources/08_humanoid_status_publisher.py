# %% [markdown]
# # 08 · The humanoid status publisher
#
# A robot that falls silent is a robot that nobody can help: every real one says, again and again, "I am well, and this
# is what is left in my battery".
#
# - **Minutes:** 55
# - **You need:** lesson [05](05_timers.ipynb), and what a node, a publisher and a message are
# - **You will be able to:** build a node with two topics at two rates, send numbers that really arrive, say who is
#   listening, notice a node that has gone deaf, and end one on Ctrl-C with exit code 0
# - **Left out:** real battery sensors (`sensor_msgs/BatteryState`), several threads, services

# %% [markdown]
# The next cell starts the finished node. It runs as a program of its own, beside this notebook.

# %%
from lesson_nodes import humanoid_status_publisher
from workbook.lesson import start, stop, watch_status

print("on the graph:", start(humanoid_status_publisher))

# %% [markdown]
# Now look at it. The dashboard listens to two topics: `/robot/status` lights the lamp, `/robot/battery` fills the gauge.
# Each dot below is a message at the moment it arrived.

# %%
view = await watch_status(seconds=9)

# %%
print("the robot says:", view.status)
print("battery still nearly full:", 90.0 < view.battery < 100.0)
stop()

# %% [markdown]
# Compare the two rows of dots. One topic is busier than the other. Why that is so, and what can go wrong with it, is
# this lesson.

# %% [markdown] prediction="status-and-battery"
# ## Predict
#
# Two lines of the node give it its rhythm:
#
# ```python
# self.status_timer = self.create_timer(1.0, self.publish_status)
# self.battery_timer = self.create_timer(2.0, self.publish_battery)
# ```
#
# One node, one thread, two timers. We listen for one minute. What arrives?
#
# - **a** 60 times status, 120 times battery: 1.0 and 2.0 are frequencies.
#   when `battery > 100`
#   ✗ The first argument of `create_timer` is a period. The larger it is, the fewer messages come.
# - **b** 30 times each: one thread can only keep one pace, the slower one.
#   when `status < 40 and 25 <= battery <= 35`
#   ✗ One thread can serve several timers, each at its own pace, as long as the callbacks are short.
# - **c** 20 times each: the timers take turns, 1 s and then 2 s.
#   when `status < 25 and battery < 25`
#   ✗ The timers do not wait for each other. Each one is due by its own period.
# - **d** 60 times status, 30 times battery: 1.0 and 2.0 are seconds.
#   when `50 < status < 70 and 25 <= battery <= 35`
#   ✓ A minute has room for sixty periods of 1.0 s and for thirty of 2.0 s.

# %%
from workbook.lesson import predict, reveal

predict("status-and-battery")

# %% [markdown]
# ## Run it
#
# We do not wait for a minute. The recorder below drives the clock of the robot: one minute of robot time goes by in a
# few real seconds, and the timers cannot tell.

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
reveal(
    "status-and-battery",
    status=len(arrivals(minute, STATUS)),
    battery=len(arrivals(minute, BATTERY)),
)

# %% [markdown]
# ## Look inside
#
# Both timers live in one thread and do not disturb each other. A timer callback is short: fill a message, publish it,
# done. Between two ticks the node does nothing at all. So there is room for many timers, as long as **each callback is
# quick**.
#
# Now we build the node, step by step. Every topic needs the same three things: a **publisher**, a **timer** and a
# **callback** that fills a message.

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
# We have no battery, so we simulate one: a number that falls a little each time. Without care it falls below zero. A
# robot with minus one percent in its battery is nonsense, and somebody's program will believe it.
#
# `max(0.0, ...)` is the floor.

# %%
careless = careful = 0.8
for _ in range(4):
    careless = careless - 0.3
    careful = max(0.0, careful - 0.3)
    print(f"careless {careless:5.1f} %    with a floor {careful:4.1f} %")

# %% [markdown]
# ### Step 3: the second topic
#
# Again a publisher, a timer, a callback. The level is kept in `self`, so that it is remembered from tick to tick. And
# the status is no longer a constant: it depends on the battery.

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
# This is the class in `lesson_nodes/humanoid_status_publisher.py`, the one that you saw on the dashboard. New are names
# for the numbers, a docstring that lists the topics, and a check of the start value.

# %%
import inspect

from lesson_nodes.humanoid_status_publisher import HumanoidStatusPublisher

print(inspect.getsource(HumanoidStatusPublisher))

# %% [markdown]
# Three habits to copy:
#
# - **Topics in the docstring**, with type, rate and meaning. It is the contract with everybody who listens.
# - **Type hints** (`-> None`, `battery_level: float`). Your editor and mypy read them. ROS does not: they will not stop a
#   wrong value in a message. You will see that below.
# - **A unit in each name or comment** (`STATUS_PERIOD_S`, percent). Many bugs with rates are seconds taken for
#   hertz.

# %% [markdown]
# ## Change it

# %% [markdown]
# ### Experiment 1: until the battery is empty
#
# How long would that take, from full? The drain per message is between 0.1 and 0.5 %, 0.3 % on average.

# %%
messages = 100.0 / 0.3
print(f"about {messages:.0f} messages, one every 2 s: {messages * 2 / 60:.0f} minutes")

# %% [markdown]
# Too long even on fast robot time. So it is evening, and 10 % are left. A program is a file; this one takes the class
# from the lesson's node and gives it another start value.

# %%
from pathlib import Path

_ = Path("evening.py").write_text("""\
import rclpy
from lesson_nodes.humanoid_status_publisher import HumanoidStatusPublisher

rclpy.init()
rclpy.spin(HumanoidStatusPublisher(battery_level=10.0))
""")

# %% [markdown] prediction="the-empty-battery"
# We record two minutes of robot time. What happens on `/robot/battery` once the battery is empty?
#
# - **a** The level goes on falling: −0.3, −0.6, ...
#   when `lowest < 0`
#   ✗ `max(0.0, ...)` in `publish_battery` keeps the level from going below zero.
# - **b** The messages go on and say 0.0.
#   when `lowest == 0 and messages_when_empty > 10`
#   ✓ The timer goes on, and `max(0.0, ...)` keeps the level at zero. So each message says 0.0.
# - **c** The messages stop: an empty robot cannot talk.
#   when `lowest == 0 and messages_when_empty <= 10`
#   ✗ The battery is a number in a program here. Nothing stops the timer when it is empty.
# - **d** The node raises an error and ends.
#   ✗ 0.0 is a level like any other. Nothing in the callback fails on it.

# %%
predict("the-empty-battery")

# %%
evening = record("evening.py", PERIODS, seconds=120)
levels, words = values(evening, BATTERY), values(evening, STATUS)
empty = levels[levels.index(0.0) :]

print("lowest level:", min(levels))
print("more than ten messages since then:", len(empty) > 10)
print("every one of them says:", *set(empty))
print(f"still one every {pace(evening, BATTERY):.1f} s")
print("status:", " → ".join(dict.fromkeys(words)))
reveal("the-empty-battery", lowest=min(levels), messages_when_empty=len(empty))

# %%
from workbook.pictures import figure
from workbook.pictures.palette import AMBER, GREEN, RED

fig, (upper, lower) = figure(7.2, 3.2, rows=2)
upper.step(arrivals(evening, BATTERY), levels, where="post", color=AMBER)
upper.set(ylabel="battery (%)", xlim=(0, 120), ylim=(-0.5, 10.5))
for word, color, sign in (("operational", GREEN, "o"), ("error", RED, "x")):
    times = [t for t, heard in zip(arrivals(evening, STATUS), words, strict=True) if heard == word]
    lower.plot(times, [word] * len(times), sign, color=color, markersize=4)
lower.set(xlabel="robot time (s)", xlim=(0, 120), ylim=(-0.6, 1.6))
show(fig, "the battery falls to zero and stays there; the status turns from operational to error")

# %% [markdown]
# And this is what the operator would see at the end of it:

# %%
from workbook.pictures import dashboard

seen = {topic: arrivals(evening, topic) for topic in PERIODS}
last = max(arrivals(evening, STATUS))
picture = dashboard.draw(words[-1], levels[-1], seen, now=last)
show(picture, "the dashboard at the end: lamp on error, battery at 0.0 %")

# %% [markdown]
# Zero is a message, silence is not. A monitor that hears `0.0` and `error` knows what is wrong. One that hears nothing
# knows nothing: is the battery empty, has the program crashed, or is the network down? So a status node keeps talking
# for as long as it can.

# %% [markdown] prediction="nobody-listens"
# ### Experiment 2: who is listening?
#
# The node publishes into a topic, not to a person. We make one here, in the notebook, and nobody listens. What does
# `publish()` do then?
#
# - **a** It waits until somebody listens.
#   ✗ `publish` hands the message to the middleware and returns. It does not wait for anybody.
# - **b** It raises an error.
#   ✗ A topic without a listener is no error in ROS. Listeners may come and go.
# - **c** It returns at once, and the message is gone.
#   when `kept == 0`
#   ✓ An ordinary publisher keeps nothing for those who come later.
# - **d** It returns at once, and the message is kept for whoever comes later.
#   when `kept > 0`
#   ✗ A publisher can be told to do that, with another QoS (lesson 13). By default it does not.

# %%
predict("nobody-listens")

# %%
humanoid = fresh(HumanoidStatusPublisher)
for _ in range(3):
    humanoid.publish_status()
print("listeners:", humanoid.status_publisher.get_subscription_count())

# %% [markdown]
# It came back each time, without an error. Are the messages kept? A listener that comes late will tell.

# %%
import rclpy

from workbook.lesson import spin_for

heard = []
listener = fresh(lambda: rclpy.create_node("late_listener"))
listener.create_subscription(String, STATUS, lambda message: heard.append(message.data), 10)
spin_for(listener, seconds=10, until=lambda: humanoid.status_publisher.get_subscription_count() == 1)
spin_for(listener, seconds=0.5)
kept = len(heard)
print("heard of the three messages:", kept)

humanoid.publish_status()
spin_for(listener, seconds=10, until=lambda: heard)
print("heard after one more:", len(heard))
reveal("nobody-listens", kept=kept)

# %% [markdown]
# The `10` in `create_publisher(..., 10)` is no mailbox for latecomers. It is the length of the queue for those who are
# connected. (One can ask ROS to keep the last message for latecomers: that is a matter of QoS, a later lesson.)

# %% [markdown]
# Two more listeners. The monitor is a program of its own, the dashboard lives in this notebook. The publisher needs no
# change. It can only count them.

# %%
import asyncio

from lesson_nodes import status_monitor
from workbook.lesson import graph_picture

print("started", start(status_monitor))
opened = asyncio.create_task(watch_status(seconds=5))
await run(listener, until=lambda: humanoid.status_publisher.get_subscription_count() == 3, seconds=10)

humanoid.publish_status()
humanoid.battery_publisher.publish(Float32(data=80.0))
listeners = humanoid.status_publisher.get_subscription_count()
network = graph_picture("/humanoid_status_publisher")
await opened
print("listeners while the dashboard was open:", listeners)

# %%
network

# %% [markdown]
# This picture is the ROS **graph**: nodes are round, topics are square, an arrow shows which way messages go. It was
# drawn while the dashboard was open. Nobody had to tell the nodes about each other: same topic name, same type, and DDS
# connects them.

# %%
stop()
listener.destroy_node()
humanoid.destroy_node()

# %% [markdown] prediction="whole-percents"
# ### Experiment 3: whole percents
#
# A colleague finds `99.71 %` ugly and writes `Float32(data=round(self.battery_level))`. In Python, `round(99.4)` is the
# whole number 99. What arrives on the topic?
#
# - **a** 0.0.
#   when `arrived_for_99 == '0.0'`
#   ✓ The code below reads the int as if it were a float. In this build that gives 0.0, another one can abort the
#   program.
# - **b** Nothing, because `publish()` raises an error.
#   ✗ With field checks on, it does. As ROS comes, they are off.
# - **c** 99.0, because 99 is a number like any other.
#   when `arrived_for_99 == '99.0'`
#   ✗ For Python it is. But the field takes a float, and 99 is an int. ROS does not convert one into the other.

# %%
predict("whole-percents")

# %% [markdown]
# The program below runs as ROS comes out of the box. It sends itself one message after the other.

# %%
from workbook.lesson import run_program


def said(outcome):
    """The lines that a program has printed with `main:` in front."""
    lines = [line for line in outcome.log.splitlines() if line.startswith("main:")]
    return "\n".join(line.removeprefix("main: ") for line in lines)


outcome = run_program("""
import rclpy
from std_msgs.msg import Float32

rclpy.init()
robot = rclpy.create_node("robot")
heard = []
publisher = robot.create_publisher(Float32, "/robot/battery", 10)
robot.create_subscription(Float32, "/robot/battery", lambda message: heard.append(message.data), 10)
while publisher.get_subscription_count() == 0:
    rclpy.spin_once(robot, timeout_sec=0.05)

for level in (99.5, 99, round(99.4), True, "99", float(99)):
    publisher.publish(Float32(data=level))
    before = len(heard)
    while len(heard) == before:
        rclpy.spin_once(robot, timeout_sec=1.0)
    print(f"main: sent {level!r:<6} arrived {heard[-1]}")
""", seconds=20)
print(said(outcome))
reveal("whole-percents", arrived_for_99=said(outcome).splitlines()[1].split()[-1])

# %% [markdown]
# No error, no warning, just zero. A `float32` field wants a Python `float`, and stock ROS does not check. The type hint
# on `battery_level` did not help either.
#
# There is a check, but it must be switched on before the message class is imported: the environment variable
# `ROS_PYTHON_CHECK_FIELDS=1`. This notebook has it on. Your robot has not, unless you set it.

# %% tags=["raises-exception"]
Float32(data=99)

# %% [markdown] prediction="the-exception"
# ## When it goes wrong
#
# ### The deaf node
#
# A callback raises an exception. Many programs spin in a background thread, to keep the main thread free. Watch what
# happens then. Below, a node publishes its status ten times a second. A second timer estimates how long the battery will
# last, and divides by zero the second time.
#
# - **a** The program ends with a traceback and an exit code that is not 0.
#   when `exit_code != 0`
#   ✗ The exception ends the thread that spins, not the program. The main thread goes on and ends with 0.
# - **b** The estimate is missing, the status goes on: each timer minds its own business.
#   when `in_the_last_second > 0`
#   ✗ Both timers are called by one thread, and the exception has ended it.
# - **c** All timers stop, the program lives on, and from outside it looks well.
#   when `exit_code == 0 and in_the_last_second == 0`
#   ✓ The thread that spins is gone, so nobody calls a timer any more. The node is still on the graph.

# %%
predict("the-exception")

# %% [markdown]
# It runs behind a watchdog: `run_program` ends it when it takes too long.

# %%
DEAF = """
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
while spinning.is_alive():
    time.sleep(0.1)  # the main thread is busy with other things

before = humanoid.sent
time.sleep(1.0)
print("main: status messages in the last second:", humanoid.sent - before)
print("main: the last word that went out:", humanoid.last_word)
print("main: node still on the graph:", "humanoid" in humanoid.get_node_names())
rclpy.try_shutdown()
"""
outcome = run_program(DEAF, seconds=20)
print(said(outcome))
print("exit code", outcome.exit)
reveal(
    "the-exception",
    exit_code=outcome.exit,
    in_the_last_second=int(said(outcome).splitlines()[0].split()[-1]),
)

# %% [markdown]
# Read that again. The exception has killed the *thread*, not the program. The node is still on the graph, so
# `ros2 node list` shows it. The last thing it said was *operational*. No timer fires, no message is read: the node is
# **deaf**. And in the end the exit code claims success.
#
# The error was told once, somewhere in the log:

# %%
print([line for line in outcome.log.splitlines() if "Error" in line][-1])

# %% [markdown]
# In this notebook we spin with `await run(...)`. It spins in the same thread, so the exception comes out where you can see
# it: in your cell.

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
# How to mend it:
#
# - In a program, let `rclpy.spin(node)` run in the **main thread**. An exception then ends the program, loudly, and
#   whoever started it can start it again.
# - If it must be a thread, look at `thread.is_alive()` from time to time, and act on it.
# - Somebody else should watch too: a monitor that raises an alarm when no status has come for 3 s. Silence is a symptom.

# %% [markdown] prediction="the-endings"
# ### Ctrl-C, and the crash that is none
#
# An operator stops the program with Ctrl-C. What should happen: it ends, without a traceback, with exit code 0. That code
# is read by service managers and scripts; anything but 0 means "crashed".
#
# Three endings of the same program follow. `COMMON` is what you will meet in many examples. Which of them end with 0?
#
# - **a** `COMMON` and `CLEAN`: both catch `KeyboardInterrupt`.
#   when `no_care != 0 and common == 0 and clean == 0`
#   ✗ Both catch it. But in `COMMON`, `rclpy.shutdown()` then raises, because Ctrl-C has shut the context down
#   already.
# - **b** Only `CLEAN`.
#   when `no_care != 0 and common != 0 and clean == 0`
#   ✓ It catches the exceptions of `spin`, and `try_shutdown` does not mind that the context is down already.
# - **c** All three: Ctrl-C is no error.
#   when `no_care == 0 and common == 0 and clean == 0`
#   ✗ Without care, the `KeyboardInterrupt` ends the program with a traceback. The exit code is not 0.

# %%
BEGIN = """
import rclpy
from rclpy.executors import ExternalShutdownException
from lesson_nodes.humanoid_status_publisher import HumanoidStatusPublisher

rclpy.init()
humanoid = HumanoidStatusPublisher()
"""
NO_CARE = """
rclpy.spin(humanoid)
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
predict("the-endings")

# %% [markdown]
# The next cell starts each program, waits for its first status, and sends it what Ctrl-C sends.

# %%
exits = {}
for name, ending in {"NO_CARE": NO_CARE, "COMMON": COMMON, "CLEAN": CLEAN}.items():
    outcome = run_program(BEGIN + ending, seconds=15, interrupt_at="Status:")
    exits[name] = outcome.exit
    last_line = outcome.log.strip().splitlines()[-1].split(", at ")[0]
    last_line = last_line if "Traceback" in outcome.log else "no traceback"
    print(f"{name:<8} exit code {outcome.exit:>3}   {last_line}")
reveal(
    "the-endings",
    no_care=exits["NO_CARE"],
    common=exits["COMMON"],
    clean=exits["CLEAN"],
)

# %% [markdown]
# - `NO_CARE`: `KeyboardInterrupt` runs through to the end, with a traceback. 130 is how a shell says "ended by Ctrl-C".
# - `COMMON` looks careful and still fails. On Ctrl-C **rclpy shuts the context down by itself**. Then `rclpy.shutdown()`
#   in `finally` does it a second time, and that is an error. A clean stop is reported as a crash.
# - `CLEAN`: `try_shutdown()` does nothing when it is done already. And it catches both exceptions that may come out of
#   `spin`: `ExternalShutdownException` is what you get when not Ctrl-C but somebody else, a service manager for example,
#   has ended the context.
#
# One grain of salt: `try_shutdown()` first asks whether the context is up, and then shuts it down. On a very busy machine
# rclpy's handling of Ctrl-C now and then comes
# [in between](https://github.com/ros2/rclpy/blob/jazzy/rclpy/rclpy/context.py), and `CLEAN` ends like `COMMON`. That is
# a fault of rclpy's and not of your program. The cell above would run it again, and `%check` forgives it.

# %% [markdown]
# ## From a worked example to your own
#
# **Worked.** The motors have a temperature, and somebody should know it. One topic at 2 Hz, a typed node, a float that is
# one, a clean end. Then Ctrl-C after the first message.

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
# **Faded.** Now the foot counts its steps, and reports them on `/robot/steps` once in four seconds, as a `Float32`. Three
# blanks `___` are yours: the period, the float, and how the program ends. Until they are filled, Python complains
# about the first one. You are done when it says `sent 1.0` and exit code 0.

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
# **Your own.** The [exercise](../exercises/08_humanoid_status_publisher.ipynb) hands you a status publisher with three
# bugs. All three are in this lesson. It is judged by what arrives on the topics, and by how your program ends.

# %% [markdown]
# ## Check yourself
#
# **1. The battery is to be published at 0.5 Hz. Which line is right?**
#
# <details><summary>a) create_timer(0.5, self.publish_battery)</summary>
#
# ✗ The first argument is a period in seconds. Every half second is 2 Hz, four times too often.
#
# </details>
# <details><summary>b) create_timer(2.0, self.publish_battery)</summary>
#
# ✓ The period is one over the frequency: 1 / 0.5 Hz = 2 s.
#
# </details>
# <details><summary>c) create_timer(2.0, self.publish_battery())</summary>
#
# ✗ The brackets call the method right away and hand over what it returns, `None`. The timer wants the method itself.
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
# <details><summary>c) The level in the message is no Python float</summary>
#
# ✓ An int, a str or a bool in a float field is sent as garbage, mostly as 0.0, without a word, unless field checks are on.
#
# </details>
#
# **3. A node is on the graph, its last status was "operational", and nothing has come for a minute. What is likely?**
#
# <details><summary>a) An exception has ended the thread that spins</summary>
#
# ✓ The node object lives on, so the graph still shows it, but nothing calls its timers any more.
#
# </details>
# <details><summary>b) Nothing, no news is good news</summary>
#
# ✗ A status topic with a rate is a heartbeat. When it stops, something is wrong.
#
# </details>
# <details><summary>c) All its listeners have gone, so it has paused</summary>
#
# ✗ `publish()` does not care whether anybody listens. You have tried it.
#
# </details>
#
# **4. Why does `rclpy.shutdown()` in `finally` fail after Ctrl-C?**
#
# <details><summary>a) destroy_node() has shut the context down</summary>
#
# ✗ `destroy_node()` takes one node off the graph. The context stays up.
#
# </details>
# <details><summary>b) The context has been shut down already, by Ctrl-C itself</summary>
#
# ✓ rclpy does it when the signal comes. `try_shutdown()` does not mind.
#
# </details>
# <details><summary>c) `finally` is not executed after an exception</summary>
#
# ✗ It always is. That is just why the second shutdown happens.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# > My humanoid publishes its status at 1 Hz and its battery at 0.5 Hz from one node. A monitor on another computer should
# > stop the robot when something is wrong. What can it conclude from a message, and what from a missing one? How long
# > should it wait before it calls silence an alarm?
#
# <details><summary>What a good answer contains</summary>
#
# A message says what the node believed when it was sent, no more: "operational" from a node that has no idea of its
# health is worth little. A missing message can mean a dead process, a deaf node, a blocked callback, or a network that is
# down; they look the same from outside. One late message is no alarm, since timers and networks jitter: two to three
# periods are a common compromise between false alarms and a slow reaction. It should say what it does in the meantime
# (slow down, stop, sit down), and notice that the robot may need to stop by itself when *it* no longer hears the monitor.
# A plus: ROS can watch this for you, with a deadline in the QoS.
#
# </details>

# %% [markdown]
# ## Take away
#
# - Each topic needs a publisher, a timer and a short callback; many fit into one thread.
# - `create_timer` takes seconds: 0.5 Hz is 2.0.
# - Only a Python `float` arrives in a float field; anything else becomes garbage without a word, mostly 0.0.
# - An exception in a background spin makes a node deaf, not dead: spin in the main thread, and watch for silence.
# - End with `except (KeyboardInterrupt, ExternalShutdownException)` and `rclpy.try_shutdown()`.
#
# **Before:** [07 · Typed nodes](07_typed_nodes.ipynb)
#
# **Next:** [09 · The joint positions](09_joint_positions.ipynb), a third topic that moves a whole body.
#
# **More:** [Writing a simple publisher and
# subscriber](https://docs.ros.org/en/jazzy/Tutorials/Beginner-Client-Libraries/Writing-A-Simple-Py-Publisher-And-Subscriber.html)
# and [About topics](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Topics.html).

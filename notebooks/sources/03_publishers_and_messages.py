# %% [markdown]
# # 03 · Publishers and messages
#
# One topic tells the wheels where to go. Another tells the screen how much battery is left. Both need a publisher, and a
# message with a number in it. How is that done well?
#
# - **Minutes:** 45
# - **You need:** lessons 00 to 02
# - **You will be able to:**
#   - create a publisher
#   - put numbers into the fields of a message
#   - read the errors that publishers give
# - **Left out:** receiving (lesson 04), timers (lesson 05), quality of service (lesson 13); queues, pictures and richer
#   message types (the deeper notebook)

# %% [markdown]
# A node publishes ten times a second how fast a small robot must drive and turn, on the topic `/robot/cmd_vel`. We record
# it for a while.

# %%
from lesson_nodes import figure_driver
from workbook.lesson import record

DRIVE = "/robot/cmd_vel"
heard = record(figure_driver, {DRIVE: 0.1}, seconds=12.7)

commands = [arrival.value for arrival in heard.topic(DRIVE).arrivals]
print("messages:", len(commands))
print("the first one:", commands[0])

# %% [markdown]
# Each message is of type `Twist`: two groups of three numbers. `linear` is speed in m/s, `angular` is turning in rad/s.
# A robot on the floor uses two of the six: how fast forward (`linear` `x`), and how fast to the left (`angular` `z`).
#
# Where does the robot go? We obey each message for a tenth of a second, as the robot would.

# %%
from workbook.pictures.path import path_of, show_path

show_path(
    path_of(commands),
    "the path of the robot: a lying eight, a circle to the left, then one to the right",
    title="127 messages draw an eight",
)

# %% [markdown]
# Change something: `record(figure_driver, {DRIVE: 0.1}, seconds=12.7, eight=False)`, and run both cells again.
#
# Now you will publish messages of your own.

# %% [markdown] prediction="int-in-a-float-field"
# ## Predict
#
# To send, a node needs a **publisher**. Two lines are enough:
#
# ```python
# battery = node.create_publisher(Float32, "/robot/battery", 10)
# battery.publish(Float32(data=80))
# ```
#
# The first line says: messages of type `Float32`, on the topic `/robot/battery`. The second line makes a message, puts 80
# into its only field, `data`, and publishes it.
#
# The program runs with the packages of this course and their default settings. A screen subscribes to the topic. What does
# it show?
#
# - **a** 80.0, because Python turns 80 into 80.0 wherever a float is wanted.
#   when `arrived_for_80 == 80`
#   ✗ Python converts nothing here. The field is set to the int 80, as it is.
# - **b** Nothing, because `Float32(data=80)` raises an error: 80 is not a float.
#   ✗ It does so when field checks are on. By default they are off, and the message takes any object.
# - **c** 0.0
#   when `arrived_for_80 == 0`
#   ✓ The C code of this build reads the int as if it were a Python float, and gets 0.0. The Ubuntu packages can abort
#   the program here.
# - **d** Nothing, because `publish` raises an error: it looks at the fields before it sends.
#   ✗ `publish` does not check the fields either. It hands the message to C code, which expects a Python float.

# %%
from workbook.lesson import predict, reveal

predict("int-in-a-float-field")

# %% [markdown]
# ## Run it
#
# The program below publishes one level after another, twice a second. It runs as a process of its own, with default
# settings. We print what arrives.

# %%
from pathlib import Path

from workbook.lesson import values

PROGRAM = """
import numpy as np
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32


class Battery(Node):
    def __init__(self):
        super().__init__("battery")
        self.levels = [LEVELS]
        self.publisher = self.create_publisher(Float32, "/robot/battery", 10)
        self.create_timer(0.5, self.publish_next)

    def publish_next(self):
        if self.levels:
            level = self.levels.pop(0)
            self.publisher.publish(Float32(data=level))


rclpy.init()
rclpy.spin(Battery())
"""


def listen_to(program, seconds):
    """Run a program that publishes on /robot/battery, and record it."""
    Path("battery.py").write_text(program)
    return record("battery.py", {"/robot/battery": 0.5}, seconds=seconds)


def what_arrives(*given):
    """Publish these values, written as in Python, and return what arrives."""
    program = PROGRAM.replace("LEVELS", ", ".join(given))
    return values(listen_to(program, seconds=0.5 * len(given) + 1.0), "/robot/battery")


arrived = what_arrives("80.0", "80")
print("80.0 and 80 arrive as", *arrived)

# %%
reveal("int-in-a-float-field", arrived_for_80=arrived[1])

# %% [markdown]
# **On your robot, this line may do something worse.** The packages for Ubuntu can end the whole process here, with
# ``Assertion `PyFloat_Check(field)' failed``, and no `except` catches it ([rclpy
# 1297](https://github.com/ros2/rclpy/issues/1297), [rclpy 1437](https://github.com/ros2/rclpy/issues/1437)). In this
# build there is no error and no warning: the program means 80, and 0.0 arrives.
#
# What about other values? Which of these arrive as the number that was meant?

# %% id="given-arrived"
given = [
    "80.0", "80", "True", "'80'", "None", "[80.0]",
    "np.int64(80)", "np.int64(-80)", "np.float32(80)", "np.float64(80)", "float(80)",
]  # fmt: skip
arrived = what_arrives(*given)

for one, other in zip(given, arrived, strict=True):
    print(f"gave {one:<15} arrived {other}")

# %%
from workbook.pictures.figures import figure, show
from workbook.pictures.palette import GREEN, RED

fig, axes = figure(5.6, 3.9)
for row, (one, other) in enumerate(zip(given, arrived, strict=True)):
    color, sign = (GREEN, "✓") if other == 80.0 else (RED, "✗")
    axes.text(0.0, row, one, family="monospace", va="center")
    axes.annotate(
        "",
        xy=(0.72, row),
        xytext=(0.42, row),
        arrowprops={"arrowstyle": "->", "color": color},
    )
    axes.text(0.77, row, f"{other}", family="monospace", color=color, va="center")
    axes.text(0.93, row, sign, color=color, va="center", family="DejaVu Sans")
axes.text(0.0, -1.0, "what I gave", va="center")
axes.text(0.77, -1.0, "what arrived", va="center")
axes.set(xlim=(0, 1), ylim=(len(given) - 0.5, -1.5), title="only Python floats arrive")
axes.axis("off")
show(
    fig,
    "eleven values and what arrived: only the Python float, np.float64 and float(80) "
    "arrive as 80.0; np.int64(-80) arrives "
    "as nan, all others as 0.0",
)

# %% [markdown]
# Three of eleven arrive. One comes out as `nan`, *not a number*, and the rest as zero. Look at the two floats from NumPy:
# `np.float64` arrives, `np.float32` does not. Neural networks compute in `np.float32`, so this fault is common.
#
# The fix is one word: **`float(level)`**. It turns each kind of number into a Python float, and raises an error for `None`
# and for a list. (It still accepts some values that you would rather refuse. The exercise is about that.)

# %% [markdown]
# ## Look inside
#
# ### What a message is
#
# A **message definition** says what a `Float32` is, in one line: `float32 data`. ROS generates a class from it for each
# language. In Python the fields are attributes, and each begins with a default.

# %%
from std_msgs.msg import Float32

print(Float32.get_fields_and_field_types())
print(Float32())

# %% [markdown]
# `publish` serializes the message: it writes the bytes that any other program can read. For a `float32` field, this build
# reads the memory of a Python float, **without a check of what kind of object it has**. An `int` has other bytes there.
# Read as a float, they usually give a number so tiny that it becomes 0.0.
#
# **`std_msgs` is for learning.** Since ROS 2 Foxy, `Float32`, `String` and the other single-value types of `std_msgs`
# have been deprecated: real robots should not use them. For example, 0.8 on `/robot/battery` does not say whether it
# is a percentage, which battery it belongs to, or when it was measured. This course uses them because they are short. On
# a robot, use types with meaning, such as `sensor_msgs/BatteryState`, or define your own.

# %% [markdown]
# ### The three arguments of `create_publisher`
#
# | argument | here | what it says |
# |---|---|---|
# | message type | `Float32` | the class itself, not its name in quotes, and no Python type |
# | topic | `"/robot/battery"` | the name under which others find it, spelled exactly so |
# | depth | `10` | how many messages the publisher keeps for retransmission; the deeper notebook measures it |
#
# A topic has **one** type. All its publishers and subscriptions use the same one.

# %% [markdown]
# ### Messages in messages
#
# A `Twist` holds two messages of type `Vector3`, and these hold the numbers. All are zero at first, so you set only what
# you need:

# %%
from geometry_msgs.msg import Twist

print(Twist.get_fields_and_field_types())

command = Twist()
command.linear.x = 0.4
command.angular.z = 1.0
print(command)

# %% [markdown]
# ## Change it

# %% [markdown] prediction="the-other-circle"
# ### Experiment 1: another circle
#
# The robot drives 0.4 m/s and turns left by 1.0 rad/s, always. That is a circle 0.8 m across. Now it turns by 0.5 rad/s.
# What will the path be?
#
# - **a** A circle twice as wide
#   when `1.2 <= width_m < 2.0`
#   ✓ The radius is the speed forward divided by the speed of turning. Half the turning gives twice the radius.
# - **b** A circle half as wide
#   when `width_m < 0.6`
#   ✗ It is the other way around: a slower turn takes the robot further before the circle is closed.
# - **c** The same circle, driven at half the speed
#   when `0.6 <= width_m < 1.2`
#   ✗ The speed forward stays 0.4 m/s. Only the turning is slower, and that changes the circle.
# - **d** A spiral
#   ✗ For a spiral, one of the two speeds would have to change on the way. Both are constant.

# %%
predict("the-other-circle")

# %%
turn_radps = 0.5  # turn this knob, and forward_mps too, if you like

circle = record(
    figure_driver,
    {DRIVE: 0.1},
    seconds=12.6,
    forward_mps=0.4,
    turn_radps=turn_radps,
    eight=False,
)
points = path_of(arrival.value for arrival in circle.topic(DRIVE).arrivals)
xs, _ = points
print(f"from side to side: {max(xs) - min(xs):.1f} m")
reveal("the-other-circle", width_m=max(xs) - min(xs))

# %%
show_path(
    points,
    "the path of the robot: one circle to the left",
    title="half the turning, twice the radius",
)

# %% [markdown]
# The robot drives as fast as before and turns half as fast. So one lap takes twice as long, and covers twice the
# distance. The radius is speed divided by rate of turn: 0.4 / 0.5 = 0.8 m.

# %% [markdown] prediction="a-tenth"
# ### Experiment 2: a tenth
#
# `Float32` has 32 bits for its number; a Python float has 64. We send four good Python floats. Does 0.1 arrive as 0.1?
#
# - **a** Yes: 0.1 is a simple number, 32 bits are plenty.
#   when `arrived == 0.1`
#   ✗ 0.1 looks simple in decimal digits. In binary digits it never ends, so it is cut off after 32 bits or after 64.
# - **b** Not quite: about 0.1000000015 arrives.
#   when `arrived > 0.05 and arrived != 0.1`
#   ✓ 32 bits hold the nearest number that fits. Read as 64 bits again, it is not the 0.1 that you gave.
# - **c** No: it is rounded to 0.0.
#   when `arrived == 0`
#   ✗ It is rounded to the nearest number that fits into 32 bits. That is far closer to 0.1 than zero is.

# %%
predict("a-tenth")

# %% id="rounding"
numbers = ["0.5", "0.1", "16777217.0", "1e40"]
half, tenth, large, huge = what_arrives(*numbers)
for one, other in zip(numbers, (half, tenth, large, huge), strict=True):
    print(f"gave {one:<11} arrived {other}")
reveal("a-tenth", arrived=tenth)

# %% [markdown]
# 32 bits hold about seven digits. 0.5 is a sum of powers of two and fits exactly, 0.1 does not. Above 16 777 216,
# some whole numbers do not fit either. What is larger than 3.4e38 becomes infinite, silently.
#
# So never ask whether such a number *is* 0.1. Ask whether it is close:

# %%
import math

print("tenth == 0.1:", tenth == 0.1)
print("math.isclose(tenth, 0.1):", math.isclose(tenth, 0.1))
print("math.isclose(tenth, 0.1, rel_tol=1e-6):", math.isclose(tenth, 0.1, rel_tol=1e-6))

# %% [markdown]
# The second line surprises many: `isclose` is stricter than 32 bits allow, so give it a tolerance. The same definition
# with 64 bits exists, too: `Float64`. The numbers of a `Twist` have 64 bits. For a battery in percent, 32 are plenty.

# %% [markdown]
# ## When it goes wrong
#
# ### Field checks
#
# rclpy can check the fields of messages. These notebooks switch the checks on. So what went out as 0.0 above raises an
# error here:

# %% id="checks-on" tags=["raises-exception"]
Float32(data=80)

# %% [markdown]
# The switch is the environment variable `ROS_PYTHON_CHECK_FIELDS=1`. It is off by default, because the checks take time.
# Set it while you develop, where the program is started. It must be set **before** the message class is imported. Here are
# two programs that set it themselves.

# %% id="checks-too-late"
SWITCH_ON = 'import os\nos.environ["ROS_PYTHON_CHECK_FIELDS"] = "1"\n'
WHOLE = PROGRAM.replace("LEVELS", "80")

early = listen_to(SWITCH_ON + WHOLE, seconds=1.5)
late = listen_to(WHOLE.replace("rclpy.init()", SWITCH_ON + "rclpy.init()"), seconds=1.5)

print("switched on before the import:", early.process.log.strip().splitlines()[-1])
print("switched on after the import: 80 arrives as", *values(late, "/robot/battery"))

# %% [markdown]
# After the import it does nothing, silently. The class reads the variable once, when it is loaded. For a single message
# there is another switch, which works at any time: `Float32(data=level, check_fields=True)`.
#
# Checks find such a fault, but they do not fix it. They refuse a harmless `80`, and they accept `nan`. And they are
# off on any robot where nobody switched them on. Convert and check the value yourself, where it comes in.

# %% [markdown]
# ### Not a message
#
# A robot says hello.

# %% id="plain-str" tags=["raises-exception"]
from rclpy.node import Node
from std_msgs.msg import String
from workbook.lesson import (
    fresh,
    init,
    spin_for,
)  # spin_for: what `await run(...)` does, in an ordinary function

init()  # rclpy.init(), made so that a cell can be run again
voice = fresh(lambda: Node("voice"))
words = voice.create_publisher(String, "/robot/voice", 10)
words.publish("hello")

# %% [markdown]
# `publish` takes messages, and `"hello"` is a `str`. The error names first what it expected, then what it got. Make a
# message of it: `words.publish(String(data="hello"))`.

# %% [markdown]
# ### Two arguments of three

# %% id="no-depth" tags=["raises-exception"]
voice.create_publisher(String, "/robot/mood")

# %% [markdown]
# `qos_profile` is the third argument. QoS is quality of service (lesson 13). A plain number, the depth, is enough:
# `voice.create_publisher(String, "/robot/mood", 10)`.

# %% [markdown]
# ### An error that speaks of ROS 1

# %% id="not-a-class" tags=["raises-exception"]
voice.create_publisher("String", "/robot/mood", 10)

# %% [markdown]
# Your program has no ROS 1 in it. The text means: *this is no message class*. Here it is the name in quotes. The fix is an
# import and no quotes: `from std_msgs.msg import String`, and `create_publisher(String, ...)`.

# %% [markdown]
# ### One topic, two types
#
# `/robot/voice` carries `String`. Another part of the same program wants to publish the loudness there.

# %% id="two-types"
try:
    voice.create_publisher(Float32, "/robot/voice", 10)
except Exception as error:
    print(type(error).__name__, "·", str(error).split(", at ")[0])

# %% [markdown]
# `rt/robot/voice` is how DDS spells the topic, and `..._::Float32_` is the type that does not fit. In two **different**
# programs you get no error. This one publishes the battery as `Float32`, and the node in this notebook expects `Float64`:


# %% id="two-types-two-programs"
class Ear(Node):
    """Keeps what arrives on one topic. (Subscriptions are lesson 04.)"""

    def __init__(self, message_class, topic, depth=100):
        super().__init__("ear")
        self.heard = []
        self.create_subscription(message_class, topic, self.heard.append, depth)


from std_msgs.msg import Float64

from lesson_nodes import humanoid_status_publisher
from workbook.lesson import start, stop
from workbook.ros.tools import topic_info

print("started", start(humanoid_status_publisher))
ear = fresh(Ear, Float64, "/robot/battery")
spin_for(ear, seconds=4)
print("heard in 4 s:", len(ear.heard))
print(*topic_info("/robot/battery").problems)
stop()
ear.destroy_node()

# %% [markdown]
# No message, and no warning on either side: that is how Fast DDS, the DDS of this build, treats two types. If a topic has
# a publisher and nothing arrives, compare the types: with `topic_info` here, `ros2 topic info --verbose` on a robot.

# %% [markdown]
# ## From a worked example to your own
#
# **Worked.** A robot that speaks. It makes the publisher once, in `__init__`. The method checks what it is given *before*
# it makes a message. A caller that passes nonsense gets an error, and can react.


# %%
class Speech(Node):
    """Says words aloud.

    Topics:
        /robot/speech (std_msgs/String): what to say.
    """

    def __init__(self) -> None:
        super().__init__("speech")
        self.speech_publisher = self.create_publisher(String, "/robot/speech", 10)

    def say(self, text: object) -> None:
        if not isinstance(text, str):
            raise TypeError(f"only words can be said, not {text!r}")
        if not text.strip():
            raise ValueError("there is nothing to say")
        self.speech_publisher.publish(String(data=text))


speech = fresh(Speech)
ear = fresh(Ear, String, "/robot/speech")
spin_for(
    ear, seconds=5, until=lambda: speech.speech_publisher.get_subscription_count() == 1
)
for text in ("mind the step", 42, "  ", "good morning"):
    try:
        speech.say(text)
    except (TypeError, ValueError) as error:
        print(f"{type(error).__name__}: {error}")
spin_for(ear, seconds=5, until=lambda: len(ear.heard) == 2)
print("heard:", [message.data for message in ear.heard])

# %% [markdown]
# **Faded.** A robot that drives. `drive` gets two numbers of any kind, and publishes a `Twist`. Two places are blank. Until
# you fill them in, the cell says so.

# %%
import numpy as np


class Wheels(Node):
    """Tells the wheels how fast to drive and turn.

    Topics:
        /robot/wheels (geometry_msgs/Twist): linear.x in m/s, angular.z in rad/s.
    """

    def __init__(self) -> None:
        super().__init__("wheels")
        self.command_publisher = ...  # TODO: a publisher for Twist on /robot/wheels

    def drive(self, forward_mps, turn_radps) -> None:
        command = Twist()
        # TODO: put both numbers where they belong, each of them as a float
        self.command_publisher.publish(command)


wheels = fresh(Wheels)
if wheels.command_publisher is ...:
    print("Make the publisher and set the two fields, then run this cell again.")
else:
    ear = fresh(Ear, Twist, "/robot/wheels")
    spin_for(
        ear,
        seconds=5,
        until=lambda: wheels.command_publisher.get_subscription_count() == 1,
    )
    wheels.drive(np.float32(0.5), -1)
    spin_for(ear, seconds=5, until=lambda: ear.heard)
    print(
        "forward",
        ear.heard[0].linear.x,
        "turn",
        ear.heard[0].angular.z,
        "- there should be 0.5 and -1.0",
    )

# %% [markdown]
# **Your own.** In the [exercise](../exercises/03_publishers_and_messages.ipynb) you write a battery report that never lies:
# every number arrives, and what is not a number is refused.

# %% [markdown]
# ## Check yourself
#
# **1. In this build, a node publishes `Float32(data=np.float32(55.5))`. What arrives?**
#
# <details><summary>a) 55.5</summary>
#
# ✗ Both have 32 bits. But this build reads the memory of a Python float, and `np.float32` is not a Python float.
#
# </details>
# <details><summary>b) 0.0</summary>
#
# ✓ Yes, and without an error. With the Ubuntu packages the process may abort. Write `float(...)` around it.
#
# </details>
# <details><summary>c) Nothing: <code>publish</code> raises an error</summary>
#
# ✗ It would, if field checks had been on before `std_msgs.msg` was imported. By default they are off.
#
# </details>
#
# **2. A robot must turn to the right on the spot. Which `Twist`?**
#
# <details><summary>a) <code>command.angular.z = -0.5</code>, all the rest as it is</summary>
#
# ✓ Turns to the left are positive; turns to the right are negative. Speeds that you do not set are zero.
#
# </details>
# <details><summary>b) <code>command.angular = -0.5</code></summary>
#
# ✗ `angular` is a message, a `Vector3`, not a number. Set its field `z`.
#
# </details>
# <details><summary>c) <code>command.linear.y = -0.5</code></summary>
#
# ✗ That asks the robot to slide to its right without turning. Most cannot.
#
# </details>
#
# **3. A publisher offers `String` on `/robot/voice`. Another program subscribes there with `Float32`. What happens?**
#
# <details><summary>a) The second program gets an error</summary>
#
# ✗ Only within one program. Two programs do not check each other's types.
#
# </details>
# <details><summary>b) The text arrives as a number</summary>
#
# ✗ Nothing is converted, and nothing arrives.
#
# </details>
# <details><summary>c) No message arrives, and neither program reports it</summary>
#
# ✓ Fast DDS does not connect them. `topic_info` shows both types.
#
# </details>
#
# **4. A program imports `Float32` and then sets `ROS_PYTHON_CHECK_FIELDS` to 1. What do you get?**
#
# <details><summary>a) Checked messages</summary>
#
# ✗ The class reads the variable when it is loaded, and at that time it was not yet set.
#
# </details>
# <details><summary>b) A program that looks safe and is not</summary>
#
# ✓ Just what you saw: the int went out as 0.0. Set it before the import, or where the program is started.
#
# </details>
# <details><summary>c) An error, because the variable comes too late</summary>
#
# ✗ The class does not read the variable again, so there is no error.
#
# </details>
#
# **5. A leg sends its length as `Float32(data=0.1)`. A monitor asks `if message.data == 0.1`, and never reacts. Why?**
#
# <details><summary>a) 0.1 in 32 bits is not the same number as 0.1 in 64 bits</summary>
#
# ✓ The monitor gets 0.10000000149011612. `math.isclose(message.data, 0.1, rel_tol=1e-6)` is the question to ask.
#
# </details>
# <details><summary>b) The message was lost</summary>
#
# ✗ It arrives each time. Print it, and you see the digits.
#
# </details>
# <details><summary>c) ROS sends floats as text, rounded to a few digits</summary>
#
# ✗ It sends four bytes, and they hold about seven digits.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Copy the prompt for an AI assistant, or discuss it with a colleague. State your own view first.
#
# ```text
# I program a robot with ROS 2 Jazzy in Python (rclpy). The screen of our robot shows 64
# % battery, now and then 0 % for a moment, then 64 % again. Three people have changed
# the node this month. It reads the charge from a C library, smooths it with NumPy and
# publishes a `Float32`. How do we find the cause, and how do we make sure that it
# cannot come back? Name only functions that exist in rclpy for Jazzy.
# ```
#
# <details><summary>What a good answer contains</summary>
#
# First look at the topic, not at the code: does 0.0 really arrive, and does only one node publish there? If so, print
# `type(level)` right before `publish`, or start the node with `ROS_PYTHON_CHECK_FIELDS=1`. The line that gives a field
# something other than a float then raises an error. Suspects are an `int` when the charge is a whole number, `None` when
# the library has no value, and `np.float32` from the smoothing. The fix is one place where values come in. There,
# `float(level)` converts numbers, `math.isfinite` finds nan, and everything else is an error. A test publishes each of
# these kinds, and looks at what arrives. Good answers also ask what the node must do when there is no value.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Two claims you may meet. Both are wrong: each was tried with the rclpy of this course.
#
# - **An int in a float field raises a `TypeError`, or is converted:** In Jazzy the check is off by default. With the
#   packages of this course, 0.0 arrives; other builds may crash.
# - **Set `os.environ["ROS_PYTHON_CHECK_FIELDS"] = "1"` in `main()`:** Too late: the variable is read when the message
#   type is imported.
#
# </details>

# %% [markdown]
# ## Take away
#
# - `create_publisher(MessageClass, "/topic", depth)`, once, in `__init__`; then `publish(message)`, as often as you like.
# - A float field needs a Python float. An int, `np.float32`, `None` or a text arrives as 0.0 or worse, or aborts the
#   program, depending on the build. Write `float(...)`.
# - `ROS_PYTHON_CHECK_FIELDS=1` makes rclpy check, if it is set before the message class is imported.
# - 32 bits hold about seven digits: never compare with `==`, use `math.isclose`.
# - One topic, one type. Two programs with two types on one topic exchange nothing, and report nothing.
#
# **Before:** [02 · Nodes](02_nodes.ipynb)
#
# **Deeper:** [03 · Deeper: queues, pictures and messages with meaning](03_publishers_and_messages_deeper.ipynb)
#
# **Next:** [04 · Subscriptions and callbacks](04_subscriptions_and_callbacks.ipynb): the other end of the topic.
#
# **More:** [Interfaces](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Interfaces.html), with all field types, and
# [topics](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Topics.html).

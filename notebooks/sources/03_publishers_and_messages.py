# %% [markdown]
# # 03 · Publishers and messages
#
# One topic carries speeds to a robot's wheels, and another carries the battery charge to a screen. Both need a
# publisher and a message that contains a number. How do you make sure that the number that arrives is the one you
# published?
#
# - **Minutes:** 50
# - **You need:** lessons 00 to 02
# - **You will be able to:**
#   - create a publisher
#   - put numbers into the fields of a message
#   - read the errors that publishers raise
# - **Not covered:** receiving messages (lesson 04), timers (lesson 05), quality of service (lesson 13); queues, images,
#   and richer message types (the deeper notebook)

# %% [markdown]
# A node controls how fast a small robot drives and turns. It publishes both speeds ten times per second, on the topic
# `/robot/cmd_vel`. We record its messages for 12.7 seconds.

# %%
from lesson_nodes import figure_driver
from workbook.lesson import record

DRIVE = "/robot/cmd_vel"
heard = record(figure_driver, {DRIVE: 0.1}, seconds=12.7)

commands = [arrival.value for arrival in heard.topic(DRIVE).arrivals]
print("messages:", len(commands))
print("the first one:", commands[0])

# %% [markdown]
# Each message has the type `Twist`, which consists of two groups of three numbers. `linear` is the speed in m/s, and
# `angular` is the turning rate in rad/s. This robot uses only two of the six numbers: `linear.x`, its forward speed,
# and `angular.z`, its turning rate. In ROS, x points forward, y points to the left, and a positive `angular.z` is a
# turn to the left ([REP 103](https://www.ros.org/reps/rep-0103.html)).
#
# [the same without helpers: record]
#
# Where does the robot go? To find out, we compute its path by applying each command for a tenth of a second, as the
# robot does.

# %%
from workbook.pictures.path import path_of, show_path

show_path(
    path_of(commands),
    "the path of the robot: a lying eight, a circle to the left, then one to the right",
    title="127 messages draw an eight",
)

# %% [markdown]
# Now change the recording: use `record(figure_driver, {DRIVE: 0.1}, seconds=12.7, eight=False)`, and run both cells
# again.
#
# How do the fields of a `Twist` shape the robot's path? Make a prediction before you publish your own messages.

# %% [markdown] prediction="the-other-circle"
# ## Predict
#
# The robot drives at 0.4 m/s and turns left at 1.0 rad/s, so its path is a circle 0.8 m across. Now it keeps its speed
# but turns at only 0.5 rad/s. What path does it take?
#
# - **a** A circle twice as wide
#   when `1.2 <= width_m < 2.0`
#   ✓ The radius is the forward speed divided by the turning rate. Halving the turning rate doubles the radius.
# - **b** A circle half as wide
#   when `width_m < 0.6`
#   ✗ It's the other way around: a robot that turns more slowly drives farther before it completes the circle.
# - **c** The same circle, driven at half the speed
#   when `0.6 <= width_m < 1.2`
#   ✗ The forward speed stays 0.4 m/s. Only the turning rate changes, and that changes the circle.
# - **d** A spiral
#   ✗ For a spiral, the speed or the turning rate would have to keep changing, but both are constant.

# %%
from workbook.lesson import predict, reveal

predict("the-other-circle")

# %% [markdown]
# ## Run it

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
# The robot drives as fast as before but turns half as fast. So a lap takes twice as long and covers twice the distance.
# The circle's radius is the speed divided by the turning rate: 0.4 / 0.5 = 0.8 m. So the circle is now 1.6 m across.

# %% [markdown]
# ## Look inside
#
# ### Create a publisher
#
# To send messages, a node needs a **publisher**. Three lines are enough:
#
# ```python
# publisher = node.create_publisher(Twist, "/robot/cmd_vel", 10)  # once, in __init__
# command = Twist()
# publisher.publish(command)  # as often as you like
# ```
#
# | argument | here | meaning |
# |---|---|---|
# | message type | `Twist` | the message class itself, not its name in quotes or a Python type such as `float` |
# | topic | `"/robot/cmd_vel"` | the topic's exact name, as other programs use it |
# | depth | `10` | how many messages the publisher keeps for retransmission; in the deeper notebook, you measure the depth's effect |
#
# A topic has only **one** type, so all of its publishers and subscriptions must use that type.
#
# ### Message definitions
#
# A **message definition** lists the fields of a message type. For `Float32`, it's a single line: `float32 data`. From
# each definition, ROS generates a class for each programming language. In Python, the fields are attributes of that
# class, and each starts with a default value.

# %%
from std_msgs.msg import Float32

print(Float32.get_fields_and_field_types())
print(Float32())

# %% [markdown]
# **`std_msgs` is for learning.** `Float32`, `String`, and the other single-value types in `std_msgs` have been
# deprecated since ROS 2 Foxy, so real robots shouldn't use them. For example, a value of 0.8 on `/robot/battery`
# doesn't say whether it's a percentage, which battery it describes, or when it was measured. This course uses these
# types because they're short. On a robot, use types with self-explanatory fields, such as `sensor_msgs/BatteryState`,
# or define your own.

# %% [markdown]
# ### Nested messages
#
# A `Twist` contains two messages of type `Vector3`, each of which holds three numbers. All six numbers start at zero,
# so you set only the ones that you need:

# %%
from geometry_msgs.msg import Twist, Vector3

print(Twist.get_fields_and_field_types())

command = Twist()
command.linear.x = 0.4
command.angular.z = 1.0
print(command)

# %% [markdown]
# **Your turn.** Write the command that makes a robot drive backward at 0.2 m/s and turn to the right at 0.5 rad/s.

# %% id="your-twist"
from workbook.lesson import yours

backward = Twist()
# TODO: set the two fields of backward, then replace the ... with backward
speeds = ...

yours(
    speeds,
    Twist(linear=Vector3(x=-0.2), angular=Vector3(z=-0.5)),
    "Forward and left are positive, so both numbers are negative.",
)

# %% [markdown]
# ## Change it

# %% [markdown] prediction="int-in-a-float-field"
# ### Experiment 1: an integer in a float field
#
# A node reports the battery's charge: `battery.publish(Float32(data=80))`. The definition of `Float32` has a single
# field, `float32 data`.
#
# The node uses this course's build of ROS 2, with all settings at their defaults. A screen subscribes to the topic.
# What does the screen show?
#
# - **a** 80.0, because Python converts 80 to a float wherever a float is expected.
#   when `arrived_for_80 == 80`
#   ✗ Python doesn't convert anything here. The message stores the int 80 as it is.
# - **b** Nothing, because `Float32(data=80)` raises an error: 80 isn't a float.
#   ✗ It would if field checks were on. By default, they're off, so the message accepts any object.
# - **c** 0.0
#   when `arrived_for_80 == 0`
#   ✓ This build's C code reads the int as if it were a Python float, and gets 0.0. With the Ubuntu packages, the
#   program may abort here.
# - **d** Nothing, because `publish` checks the fields before it sends them, and raises an error.
#   ✗ `publish` doesn't check the fields, either. It passes the message to C code, which expects a Python float.

# %%
predict("int-in-a-float-field")

# %% [markdown]
# The program [battery_levels](../lesson_nodes/battery_levels.py) runs in its own process, with default settings. We
# give it eleven levels, which it publishes one after another. Then we print the values that arrive.

# %% id="given-arrived"
from lesson_nodes import battery_levels
from workbook.lesson import values

BATTERY = "/robot/battery"


def what_arrives(given):
    """Publish these levels, and return what arrives."""
    seconds = 0.5 * len(given) + 1.0
    heard = record(battery_levels, {BATTERY: 0.5}, seconds=seconds, levels=given)
    return values(heard, BATTERY)


given = [
    "80.0", "80", "True", "'80'", "None", "[80.0]",
    "np.int64(80)", "np.int64(-80)", "np.float32(80)", "np.float64(80)", "float(80)",
]  # fmt: skip
arrived = what_arrives(given)

for one, other in zip(given, arrived, strict=True):
    print(f"gave {one:<15} arrived {other}")
reveal("int-in-a-float-field", arrived_for_80=arrived[1])

# %% [markdown]
# `publish` serializes the message, which means that it converts the message to bytes that any other program can read.
# For a `float32` field, this build of ROS 2 reads the value's memory as if the value were a Python float, **without
# checking its type**. An `int` stores different bytes there. Interpreted as a float, these bytes usually form a number
# so tiny that it becomes 0.0.
#
# **On your robot, an int in a float field may have worse effects.** With the Ubuntu packages, it can abort the whole
# process with ``Assertion `PyFloat_Check(field)' failed``, and no `except` clause can catch that ([rclpy
# 1437](https://github.com/ros2/rclpy/issues/1437)).
#
# Only three of the eleven values arrive correctly. One arrives as `nan`, *not a number*. Compare the two NumPy floats:
# the `np.float64` arrives correctly, but the `np.float32` doesn't. This bug is common, because neural networks usually
# compute in `np.float32`.
#
# **Your turn.** A single built-in function converts all of these numbers to a Python float. Use it to create a message
# that contains the level below.

# %% id="your-float"
import numpy as np

level = np.float32(55.5)
message = ...  # TODO: a Float32 that holds the level as a Python float

yours(message, Float32(data=55.5), "Float32(data=float(level))")

# %% [markdown]
# `float(level)` raises an error for `None` and for a list. However, it also accepts some values that you'd rather
# reject. You'll deal with those in the exercise.

# %% [markdown] prediction="a-tenth"
# ### Experiment 2: a tenth
#
# `Float32` stores its number in 32 bits, but a Python float has 64. We send four values, all of them Python floats.
# Does 0.1 arrive as 0.1?
#
# - **a** Yes: 0.1 is a simple number, so 32 bits are plenty.
#   when `arrived == 0.1`
#   ✗ 0.1 is simple only in decimal. In binary, its digits never end, so both the 32-bit and the 64-bit float cut them
#   off.
# - **b** Not quite: about 0.1000000015 arrives.
#   when `arrived > 0.05 and arrived != 0.1`
#   ✓ The message carries the 32-bit number that's closest to 0.1. As a 64-bit float, that number isn't equal to your
#   0.1.
# - **c** No: it's rounded to 0.0.
#   when `arrived == 0`
#   ✗ It's rounded to the closest 32-bit number, which is far closer to 0.1 than 0.0 is.

# %%
predict("a-tenth")

# %% id="rounding"
numbers = ["0.5", "0.1", "16777217.0", "1e40"]
half, tenth, large, huge = what_arrives(numbers)
for one, other in zip(numbers, (half, tenth, large, huge), strict=True):
    print(f"gave {one:<11} arrived {other}")
reveal("a-tenth", arrived=tenth)

# %% [markdown]
# A 32-bit float has about seven significant digits. 0.5 is a power of two, so it fits exactly, but 0.1 doesn't. Above
# 16,777,216, even some whole numbers don't fit. And any number above 3.4e38 becomes infinite, without a warning.
#
# So don't test whether a number from a 32-bit field *equals* 0.1. Test whether it's close enough:

# %%
import math

print(f"relative difference: {abs(tenth - 0.1) / 0.1:.1e}")
print("is close to 0.1, by default:", math.isclose(tenth, 0.1))

# %% [markdown]
# **Your turn.** By default, `isclose` accepts a relative difference of at most 1e-9, but 32-bit floats aren't that
# precise. Write the test with a tolerance that suits 32-bit floats.

# %% id="your-tolerance"
close = ...  # TODO: math.isclose(tenth, 0.1, rel_tol=...)

yours(close, True, "The tolerance must be above 1.5e-8; 1e-6 is a good choice.")

# %% [markdown]
# There's also a 64-bit type, `Float64`, and the numbers in a `Twist` are 64-bit floats, too. For a battery level in
# percent, 32 bits are plenty.

# %% [markdown]
# ## When it goes wrong
#
# ### Field checks
#
# rclpy can check the types of a message's fields, and these notebooks turn those checks on. So the call that led to
# 0.0 above raises an error here:

# %% id="checks-on" tags=["raises-exception"]
Float32(data=80)

# %% [markdown]
# The environment variable `ROS_PYTHON_CHECK_FIELDS=1` turns the checks on. They're off by default, because they take
# time. The variable must be set **before** the message class is imported. So while you develop, set it in the terminal
# before you start the program. Each of the next two cells writes a program that sets the variable in its own code. Then
# we run both programs.

# %%
# %%writefile early.py
import os

os.environ["ROS_PYTHON_CHECK_FIELDS"] = "1"

from lesson_nodes.battery_levels import main

main()

# %%
# %%writefile late.py
import os

from lesson_nodes.battery_levels import main

os.environ["ROS_PYTHON_CHECK_FIELDS"] = "1"
main()

# %% id="checks-too-late"
early = record("early.py", {BATTERY: 0.5}, seconds=1.5, levels=["80"])
late = record("late.py", {BATTERY: 0.5}, seconds=1.5, levels=["80"])

errors = [line for line in early.process.log.splitlines() if "Error:" in line]
print("switched on before the import:", errors[-1])
print("switched on after the import: 80 arrives as", *values(late, BATTERY))

# %% [markdown]
# Setting the variable after the import has no effect, and you get no warning. The variable is read only once, when the
# message class is loaded. For a single message, you can turn the checks on at any time:
# `Float32(data=level, check_fields=True)`.
#
# The checks find this kind of bug, but they don't fix it. They reject `80`, which `float()` could have converted, but
# accept `nan`. And if a robot's developers forget to turn them on, the checks do nothing. So convert and check each
# value yourself, at the point where it enters your program.
#
# ### Publishing a plain string
#
# This robot tries to say hello.

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
# `publish` accepts only messages, but `"hello"` is a `str`. The error message names the expected type first, and then
# the actual type. Wrap the string in a message: `words.publish(String(data="hello"))`.
#
# [the same without helpers: init, spin_for]
#
# ### A missing depth

# %% id="no-depth" tags=["raises-exception"]
voice.create_publisher(String, "/robot/mood")

# %% [markdown]
# The error message calls the third argument `qos_profile`, where QoS stands for quality of service (lesson 13). A plain
# number, the depth, is enough: `voice.create_publisher(String, "/robot/mood", 10)`.
#
# ### An error that mentions ROS 1

# %% id="not-a-class" tags=["raises-exception"]
voice.create_publisher("String", "/robot/mood", 10)

# %% [markdown]
# Your program doesn't use ROS 1. The error really means that *the first argument isn't a message class*. Here, it's
# just the class's name in quotes. To fix it, import the class and remove the quotes: `from std_msgs.msg import String`,
# and `create_publisher(String, ...)`.
#
# ### One topic, two types
#
# `/robot/voice` carries `String` messages. Now another part of the same program tries to publish the volume of the
# robot's voice on that topic.

# %% id="two-types"
try:
    voice.create_publisher(Float32, "/robot/voice", 10)
except Exception as error:
    print(type(error).__name__, "·", str(error).split(", at ")[0])

# %% [markdown]
# In the error message, `rt/robot/voice` is the topic's name in DDS, and `..._::Float32_` is the type that doesn't
# match. If two **different** programs use the two types, you don't even get an error. In the next cell, one program
# publishes the battery level as `Float32`, but the node in this notebook expects `Float64`:


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
# No message arrives, and neither side logs a warning. Fast DDS, the DDS implementation in this build, connects a
# publisher and a subscription only if their type names match. So if a topic has a publisher but nothing arrives,
# compare the types. Use `topic_info` here, and `ros2 topic info --verbose` on a robot.

# %% [markdown]
# ## From a worked example to your own
#
# **Worked example.** This robot speaks. Its node creates the publisher only once, in `__init__`. The method `say`
# checks its argument *before* it creates a message. A caller that passes an invalid value gets an error and can handle
# it.


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
# **Fill in the blanks.** This robot drives. `drive` takes two numbers of any kind and publishes a `Twist`. Complete the
# code at the two TODO comments. Until you do, the cell prints a reminder.

# %%
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
    got = ear.heard[0].linear.x, ear.heard[0].angular.z
    yours(got, (0.5, -1.0), "command.linear.x = float(forward_mps), and angular.z")

# %% [markdown]
# **Your own.** In the [exercise](../exercises/03_publishers_and_messages.ipynb), you write a battery node that
# publishes every number correctly and raises an error for anything that isn't a number.

# %% [markdown]
# ## Check yourself
#
# **1. In this build, a node publishes `Float32(data=np.float32(55.5))`. What arrives?**
#
# <details><summary>a) 55.5</summary>
#
# ✗ It's true that the value and the field both have 32 bits. But this build reads the value's memory as if it were a
# Python float, and an `np.float32` is laid out differently.
#
# </details>
# <details><summary>b) 0.0</summary>
#
# ✓ In this build, there's no error. With the Ubuntu packages, the process may abort. To avoid both the wrong value and
# the crash, convert the value with `float(...)`.
#
# </details>
# <details><summary>c) Nothing, because <code>publish</code> raises an error</summary>
#
# ✗ You'd get an error only if field checks had been on before `std_msgs.msg` was imported. By default, they're off.
#
# </details>
#
# **2. A robot must turn to the right on the spot. Which `Twist` does it need?**
#
# <details><summary>a) <code>command.angular.z = -0.5</code>, and nothing else</summary>
#
# ✓ Turns to the left are positive, and turns to the right are negative. Speeds that you don't set stay zero.
#
# </details>
# <details><summary>b) <code>command.angular = -0.5</code></summary>
#
# ✗ `angular` isn't a number but a message, a `Vector3`. Set its field `z`.
#
# </details>
# <details><summary>c) <code>command.linear.y = -0.5</code></summary>
#
# ✗ This command tells a robot to slide to the right without turning, which most robots can't do.
#
# </details>
#
# **3. A program publishes `String` messages on `/robot/voice`. Another program subscribes with `Float32`. What happens?**
#
# <details><summary>a) The second program gets an error</summary>
#
# ✗ You'd get an error only if one program used both types. Here, each program uses only one type. DDS compares the
# type names, and doesn't connect a publisher and a subscription whose types differ.
#
# </details>
# <details><summary>b) The text arrives as a number</summary>
#
# ✗ DDS doesn't convert anything, so nothing arrives.
#
# </details>
# <details><summary>c) No message arrives, and neither program reports that</summary>
#
# ✓ Fast DDS doesn't connect the two. `topic_info` shows both types.
#
# </details>
#
# **4. A program imports `Float32` and then sets `ROS_PYTHON_CHECK_FIELDS` to 1. What's the effect?**
#
# <details><summary>a) The fields are checked from then on</summary>
#
# ✗ The variable is read only when the class is loaded. By then, this program hasn't set it yet.
#
# </details>
# <details><summary>b) None: the fields still aren't checked</summary>
#
# ✓ You saw this above: the int arrived as 0.0. Set the variable before the import, or in the terminal before you start
# the program.
#
# </details>
# <details><summary>c) An error, because the variable is set too late</summary>
#
# ✗ The variable isn't read again, so there's no error.
#
# </details>
#
# **5. A node publishes a leg's length as `Float32(data=0.1)`. In a monitor, the condition `message.data == 0.1` is never true. Why?**
#
# <details><summary>a) 0.1 in 32 bits isn't the same number as 0.1 in 64 bits</summary>
#
# ✓ The monitor receives 0.10000000149011612. Use `math.isclose(message.data, 0.1, rel_tol=1e-6)` instead.
#
# </details>
# <details><summary>b) The message was lost</summary>
#
# ✗ It arrives every time. Print the number, and you'll see that it isn't exactly 0.1.
#
# </details>
# <details><summary>c) ROS sends floats as text, rounded to a few digits</summary>
#
# ✗ ROS sends four bytes, which hold about seven digits.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Write down your own answer first. Then copy the prompt into an AI assistant, or discuss it with a colleague.
#
# ```text
# I'm programming a robot with ROS 2 Jazzy in Python (rclpy). Our robot's screen shows 64%
# battery, sometimes 0% for a moment, and then 64% again. Three people have changed the
# node this month. It reads the charge from a C library, smooths it with NumPy, and
# publishes a `Float32`. How do we find the cause, and how do we make sure that the fault
# can't come back? Make sure that every rclpy function you use exists in Jazzy.
# ```
#
# <details><summary>What a good answer covers</summary>
#
# First, look at the topic rather than the code: does 0.0 really arrive, and does only one node publish on the topic? If
# so, print `type(level)` right before `publish`, or start the node with `ROS_PYTHON_CHECK_FIELDS=1`. With the field
# checks on, a line that puts anything but a float into the field raises an error.
#
# There are three suspects: an `int` when the charge is a whole number, `None` when the library has no value, and
# `np.float32` from the smoothing. The fix is to check values in one place, where they enter the program. There,
# `float(level)` converts numbers, `math.isfinite` detects nan, and anything else is an error. To keep the fault from
# coming back, add a test that publishes each kind of value and checks the value that arrives. Good answers also ask
# what the node should do when there's no value.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Watch for these two claims. We tested both with the rclpy version that this course uses, and both are wrong.
#
# - **An int in a float field raises a `TypeError`, or is converted:** Neither happens. In Jazzy, the check is off by
#   default, so there's no error. The value isn't converted, either: with this course's packages, 0.0 arrives, and other
#   builds may crash.
# - **Set `os.environ["ROS_PYTHON_CHECK_FIELDS"] = "1"` in `main()`:** That's too late, because the variable is read
#   when the message class is imported.
#
# </details>

# %% [markdown]
# ## Take away
#
# - Call `create_publisher(MessageClass, "/topic", depth)` once, in `__init__`. Then call `publish(message)` as often
#   as you like.
# - A float field needs a Python float. An int, an `np.float32`, `None`, or a string leads to a wrong value or a
#   crash, depending on the build. Convert with `float(...)`.
# - `ROS_PYTHON_CHECK_FIELDS=1` makes rclpy check the fields, but only if it's set before the message class is
#   imported.
# - 32 bits hold about seven digits, so compare with `math.isclose`, never with `==`.
# - A topic has one type. If two programs use different types on one topic, no messages arrive, and neither program
#   reports it.
#
# **Before:** [02 · Nodes](02_nodes.ipynb)
#
# **Deeper:** [03 · Deeper: queues, images, and richer message types](03_publishers_and_messages_deeper.ipynb)
#
# **Next:** [04 · Subscriptions and callbacks](04_subscriptions_and_callbacks.ipynb) covers the other end of the
# topic.
#
# **More:** [Interfaces](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Interfaces.html), with all field types,
# and [topics](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Topics.html).

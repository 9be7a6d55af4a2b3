# %% [markdown]
# # 03 · Publishers and messages
#
# The parts of a robot know of each other only what somebody publishes: the wheels which way to go, the screen what is
# left in the battery.
#
# - **Minutes:** 55
# - **You need:** lessons 00 to 02
# - **You will be able to:** create a publisher, fill messages so that the number you mean is the number that arrives,
#   read the errors that publishers give, and choose a message type that others understand
# - **Left out:** receiving (lesson 04), what repeats by itself (lesson 05), quality of service (lesson 13)

# %% [markdown]
# A node says ten times a second how fast a small robot shall drive and turn. It knows nothing of the robot: it only
# **publishes** on the topic `/robot/cmd_vel`. We listen for a while.

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
# Where does it go? We obey each message for a tenth of a second, as the robot would.

# %%
import math

from workbook.pictures.figures import figure, show
from workbook.pictures.palette import AMBER, BLUE, GREEN, RED


def path_of(recording):
    """Where the robot gets: x and y in m. At the start it looks up the page."""
    x, y, heading = 0.0, 0.0, math.pi / 2
    xs, ys = [x], [y]
    for arrival in recording.topic(DRIVE).arrivals:
        heading += 0.1 * arrival.value["angular"]["z"]
        x += 0.1 * arrival.value["linear"]["x"] * math.cos(heading)
        y += 0.1 * arrival.value["linear"]["x"] * math.sin(heading)
        xs.append(x)
        ys.append(y)
    return xs, ys


def draw_path(recording, description):
    """Draw the way of the robot."""
    xs, ys = path_of(recording)
    fig, axes = figure(5.2, 2.8)
    axes.plot(xs, ys, color=BLUE)
    axes.plot(xs[0], ys[0], "o", color=GREEN, markersize=9, label="start")
    axes.plot(xs[-1], ys[-1], "x", color=RED, markersize=9, label="end")
    axes.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    show(fig, description)


draw_path(heard, "the path of the robot: a lying eight, a circle to the left and then one to the right")

# %% [markdown]
# 127 small messages, and the robot has driven an eight, lying on its side. Change something: `record(figure_driver,
# {DRIVE: 0.1}, seconds=12.7, turn_radps=2.0)`, and run both cells again.
#
# Now you will send messages of your own. And you will see that a message can say something else than you gave.

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
# The first line says: messages of type `Float32`, on the topic `/robot/battery`. (The `10` has its turn later.) The second
# line makes a message, puts 80 into its only field, `data`, and sends it.
#
# The program runs on the ROS of this course as it comes out of the box. A screen listens to the topic. What does it show?
#
# - **a** 80.0, because Python turns 80 into 80.0 wherever a float is wanted.
#   when `arrived_for_80 == 80`
#   ✗ Python converts nothing here. The field is set to the int 80, as it is.
# - **b** Nothing, because `Float32(data=80)` raises an error: 80 is no float.
#   ✗ It does so when field checks are on. As ROS comes, they are off, and the message takes any object.
# - **c** 0.0
#   when `arrived_for_80 == 0`
#   ✓ The C code of this build reads the int as if it were a Python float, and gets 0.0. Another build can abort the
#   program.
# - **d** Nothing, because `publish` raises an error: it looks at the fields before it sends.
#   ✗ `publish` does not check the fields either. It hands the message to C code, which expects a Python float.

# %%
from workbook.lesson import predict, reveal

predict("int-in-a-float-field")

# %% [markdown]
# ## Run it
#
# The program below publishes one level after the other, twice a second. (A timer calls `publish_next`; timers are
# lesson 05.) It runs as a process of its own, on **stock ROS**: with the settings with which it is delivered. We
# write down what arrives.

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
# No error and no warning. The program means 80, and the world hears 0.0: an empty battery. What about other values?
# Go through the list and guess before you run the next cell: which of them arrive as the number that was meant?

# %% id="given-arrived"
given = [
    "80.0", "80", "True", "'80'", "None", "[80.0]",
    "np.int64(80)", "np.int64(-80)", "np.float32(80)", "np.float64(80)", "float(80)",
]  # fmt: skip
arrived = what_arrives(*given)

for one, other in zip(given, arrived, strict=True):
    print(f"gave {one:<15} arrived {other}")

# %%
fig, axes = figure(5.6, 3.9)
for row, (one, other) in enumerate(zip(given, arrived, strict=True)):
    color, sign = (GREEN, "✓") if other == 80.0 else (RED, "✗")
    axes.text(0.0, row, one, family="monospace", va="center")
    axes.annotate("", xy=(0.72, row), xytext=(0.42, row), arrowprops={"arrowstyle": "->", "color": color})
    axes.text(0.77, row, f"{other}", family="monospace", color=color, va="center")
    axes.text(0.93, row, sign, color=color, va="center", family="DejaVu Sans")
axes.text(0.0, -1.0, "what I gave", va="center")
axes.text(0.77, -1.0, "what arrived", va="center")
axes.set(xlim=(0, 1), ylim=(len(given) - 0.5, -1.5))
axes.axis("off")
show(
    fig,
    "eleven values and what arrived: only the Python float, np.float64 and float(80) arrive as 80.0; np.int64(-80) arrives "
    "as nan, all others as 0.0",
)

# %% [markdown]
# Three of eleven arrive. One comes out as `nan`, *not a number*, and the rest as zero. Look at the two floats from NumPy:
# `np.float64` is fine, `np.float32` is not. That pair bites everybody who sends what a neural network has computed.
#
# You may meet ROS in another build, whose C code does look. There the whole process ends at this line, with a text such as
# ``Assertion `PyFloat_Check(field)' failed``, and no `except` can catch it
# ([a report](https://github.com/ros2/rclpy/issues/1297)). The cure is the same, and comes in a moment.

# %% [markdown]
# ## Look inside
#
# ### What a message is
#
# Somebody has written down what a `Float32` is, in one line: `float32 data`. From such a **message definition** ROS
# generates a class for each language. In Python you get a class with the fields as attributes, and each field begins with a
# default.

# %%
from std_msgs.msg import Float32

print(Float32.get_fields_and_field_types())
print(Float32())

# %% [markdown]
# The message travels as bytes, which any other program can read, in whatever language. `publish` writes these bytes. For
# a `float32` field it takes the eight bytes that are the number in a Python float, and makes four of them. And it takes
# them **without a look at what kind of object it has**. An `int` has something else in this place. Read as a float, that is
# mostly a number so tiny that 32 bits make it zero. (Below zero it may also read as `nan`, as you saw.)
#
# You can do the same by hand. (For the curious; nothing else in this lesson depends on it.)

# %%
import ctypes


def eight_bytes_of(thing):
    """The number that stands where a Python float keeps its value."""
    return ctypes.c_double.from_address(id(thing) + object.__basicsize__).value


print("in 80.0:", eight_bytes_of(80.0))
print("in 80, something above zero and below 1e-300:", 0.0 < eight_bytes_of(80) < 1e-300)
print("which in 32 bits is", ctypes.c_float(eight_bytes_of(80)).value)

# %% [markdown]
# And NumPy? `np.float64` is made as a kind of Python float, so it has its bytes in the same place. `np.float32` is not.

# %%
import numpy as np

print("np.float64 is a float:", isinstance(np.float64(80), float))
print("np.float32 is a float:", isinstance(np.float32(80), float))

# %% [markdown]
# The cure is one word: **`float(level)`**. It turns each kind of number into a Python float, and it raises an error for
# `None` and for a list. (Not for everything that you would like to refuse. That is what the exercise is about.)

# %% [markdown]
# ### The three arguments of `create_publisher`
#
# | argument | here | what it says |
# |---|---|---|
# | message type | `Float32` | the class itself, not its name in quotes, and no Python type |
# | topic | `"/robot/battery"` | the name under which others find it; letter by letter |
# | depth | `10` | how many messages the publisher keeps, see experiment 3 |
#
# A topic has **one** type. All who talk or listen there use the same one.

# %% [markdown]
# ### Messages in messages
#
# A `Twist` holds no numbers. It holds two messages of type `Vector3`, and these hold the numbers. They are there from the
# start, all zero, so you set only what you need:

# %%
from geometry_msgs.msg import Twist

print(Twist.get_fields_and_field_types())

command = Twist()
command.linear.x = 0.4
command.angular.z = 1.0
print(command)

# %% [markdown]
# ### A message that is a picture
#
# A camera sends `Image` messages: a header, some numbers that say how to read the picture, and then all its pixels in one
# long array. This camera has 16 times 12 pixels.

# %%
from lesson_nodes import tiny_camera

CAMERA = "/robot/camera"
film = [arrival.value for arrival in record(tiny_camera, {CAMERA: 0.5}, seconds=4).topic(CAMERA).arrivals]

image = film[0]
print("fields:", ", ".join(image))
print(f"{image['width']} times {image['height']} pixels, encoding {image['encoding']}")
print("numbers in data:", len(image["data"]), "which is 16 · 12 · 3:", len(image["data"]) == 16 * 12 * 3)
print("the first pixel, red, green and blue:", image["data"][:3])

# %%
fig, frames = figure(6.4, 1.9, columns=3)
for axes, number in zip(frames, (1, 3, 5), strict=True):
    image = film[number]
    pixels = np.array(image["data"], dtype=np.uint8).reshape(image["height"], image["width"], 3)
    axes.imshow(pixels, interpolation="nearest")
    axes.set(title=f"message {number + 1}", xticks=[], yticks=[])
    axes.grid(False)
show(fig, "three pictures of the tiny camera: a red ball rolls over the floor, from left to right")

# %% [markdown]
# No magic: 576 numbers in a row, and `width`, `height` and `encoding` say what they mean. Whoever gets them wrong sends
# a picture that nobody can read.

# %% [markdown]
# ## Change it

# %% [markdown] prediction="the-wider-circle"
# ### Experiment 1: a wider circle
#
# The robot drives 0.4 m/s and turns left by 1.0 rad/s, always. That is a circle 0.8 m across. Now it shall turn by 0.5
# rad/s. What will the path be?
#
# - **a** A circle twice as wide
#   when `1.2 <= width_m < 2.0`
#   ✓ The radius is the speed forward divided by the speed of turning. Half the turning gives twice the radius.
# - **b** A circle half as wide
#   when `width_m < 0.6`
#   ✗ It is the other way round: who turns more slowly gets further before the circle is closed.
# - **c** The same circle, driven at half the speed
#   when `0.6 <= width_m < 1.2`
#   ✗ The speed forward stays 0.4 m/s. Only the turning is slower, and that changes the circle.
# - **d** A spiral
#   ✗ For a spiral, one of the two speeds would have to change on the way. Both are constant.

# %%
predict("the-wider-circle")

# %%
turn_radps = 0.5  # turn this knob, and forward_mps too, if you like

circle = record(figure_driver, {DRIVE: 0.1}, seconds=12.6, forward_mps=0.4, turn_radps=turn_radps, eight=False)
draw_path(circle, "the path of the robot: one circle to the left")

xs, _ = path_of(circle)
print(f"from side to side: {max(xs) - min(xs):.1f} m")
reveal("the-wider-circle", width_m=max(xs) - min(xs))

# %% [markdown]
# It drives as fast as before and turns half as fast, so it takes twice as long for a round, and twice the way. The radius
# is speed divided by rate of turn: 0.4 / 0.5 = 0.8 m.
#
# Note what you did **not** change: the robot. Two numbers in a message were enough.

# %% [markdown] prediction="a-tenth"
# ### Experiment 2: a tenth
#
# `Float32` has 32 bits for its number, a Python float has 64. We send four good Python floats. Does 0.1 arrive as 0.1?
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
# 32 bits hold about seven digits. 0.5 is a sum of powers of two and fits exactly, 0.1 does not. Above 16 777 216 not
# even each whole number fits. And what is larger than 3.4e38 becomes infinite, without a word.
#
# So never ask whether such a number *is* 0.1. Ask whether it is close:

# %%
print("tenth == 0.1:", tenth == 0.1)
print("math.isclose(tenth, 0.1):", math.isclose(tenth, 0.1))
print("math.isclose(tenth, 0.1, rel_tol=1e-6):", math.isclose(tenth, 0.1, rel_tol=1e-6))

# %% [markdown]
# The second line surprises many: `isclose` is stricter than 32 bits are, so give it a tolerance. The same definition with
# 64 bits exists, too: `Float64`. The numbers of a `Twist` have 64 bits. For a battery in percent, 32 are plenty.

# %% [markdown] prediction="whose-queue"
# ### Experiment 3: whose queue?
#
# The last argument of `create_publisher` is the **depth** of a queue. A listener names a depth, too. Here the publisher has
# depth 1. It sends 20 messages in a burst, while the listener is busy. The listener has depth 100. How many will it get?
#
# - **a** 20
#   when `arrived == 20`
#   ✓ In this program, each message is in the queue of the listener before the next one is sent. That queue has room
#   for 100.
# - **b** 1: the publisher keeps one message, so each new one replaces the one before.
#   when `arrived == 1`
#   ✗ The publisher does not keep messages until the listener has time. In this program each one is handed on at once.
# - **c** It depends on who is faster.
#   when `1 < arrived < 20`
#   ✗ Publisher and listener live in one process here, and nothing has to be sent again. So the depth of the publisher
#   does not matter.

# %%
predict("whose-queue")

# %%
from rclpy.node import Node

from workbook.lesson import fresh, init, spin_for  # spin_for: what `await run(...)` does, in an ordinary function

init()  # rclpy.init(), made so that a cell can be run again


class Ear(Node):
    """Writes down what it hears on one topic. (Subscriptions are lesson 04.)"""

    def __init__(self, message_class, topic, depth=100):
        super().__init__("ear")
        self.heard = []
        self.create_subscription(message_class, topic, self.heard.append, depth)


def burst(publisher_depth, listener_depth):
    """Send 20 messages at once to a listener that is busy meanwhile. Returns how many it gets."""
    talker = fresh(lambda: Node("talker"))
    ear = fresh(Ear, Float32, "/robot/burst", listener_depth)
    publisher = talker.create_publisher(Float32, "/robot/burst", publisher_depth)
    spin_for(talker, seconds=5, until=lambda: publisher.get_subscription_count() == 1)
    for number in range(20):
        publisher.publish(Float32(data=float(number)))
    spin_for(ear, seconds=5, until=lambda: ear.heard and ear.heard[-1].data == 19.0)
    talker.destroy_node()
    ear.destroy_node()
    return len(ear.heard)


arrived_of_burst = burst(1, 100)
print("publisher 1, listener 100:", arrived_of_burst, "of 20 messages")
reveal("whose-queue", arrived=arrived_of_burst)

# %% [markdown]
# Here is every combination of a few depths.

# %%
depths = (1, 5, 100)
table = [[burst(publisher_depth, listener_depth) for listener_depth in depths] for publisher_depth in depths]

fig, axes = figure(4.4, 2.8)
for row, counts in enumerate(table):
    for column, count in enumerate(counts):
        color = GREEN if count == 20 else AMBER
        axes.text(column, row, f"{count}", size=15, ha="center", va="center", color=color)
axes.set(
    xticks=range(3), xticklabels=depths, yticks=range(3), yticklabels=depths, xlim=(-0.5, 2.5), ylim=(2.5, -0.5),
    xlabel="depth of the listener", ylabel="depth of the publisher", title="got, of 20 messages",
)  # fmt: skip
axes.grid(False)
show(fig, "a table of what arrived: 1, 5 or 20 messages for a listener of depth 1, 5 or 100, whatever the publisher's depth")
print(table)

# %% [markdown]
# The rows are alike. Messages wait **at the listener**, so it is the listener's depth that counts when it is busy.
#
# What is the publisher's depth good for, then? It keeps what it has sent, up to this number: to send it again when a
# packet gets lost, and for those who come late and ask for it (lesson 13). On a healthy network you will not notice it. 10
# is a good habit, and no more than that. A deep queue does not make anything faster, and a listener can have too deep a
# one: lessons 04 and 15 show what that does.

# %% [markdown]
# ## When it goes wrong
#
# ### Making ROS look
#
# ROS can check the fields of messages. This notebook has switched the checks on. So what went out as 0.0 above raises an
# error here, at the very line:

# %% id="checks-on" tags=["raises-exception"]
Float32(data=80)

# %% [markdown]
# The switch is the environment variable `ROS_PYTHON_CHECK_FIELDS=1`. It is off in stock ROS, since the checks take time.
# Set it while you develop.
#
# It must be set **before** the message class is imported. A program could do that itself, in its first lines. Here are two
# that try.

# %% id="checks-too-late"
SWITCH_ON = 'import os\nos.environ["ROS_PYTHON_CHECK_FIELDS"] = "1"\n'
WHOLE = PROGRAM.replace("LEVELS", "80")

early = listen_to(SWITCH_ON + WHOLE, seconds=1.5)
late = listen_to(WHOLE.replace("rclpy.init()", SWITCH_ON + "rclpy.init()"), seconds=1.5)

print("switched on before the import:", early.process.log.strip().splitlines()[-1])
print("switched on after the import: 80 arrives as", *values(late, "/robot/battery"))

# %% [markdown]
# After the import it does nothing at all, and nobody says so. The class has looked at the variable once, when it was
# loaded. (You will find the late version in the official release notes. It does not work there either.)
#
# For a single message there is another switch, which works at any time: `Float32(data=level, check_fields=True)`.
#
# Checks are a net, not the cure. They refuse an honest `80`, they are gone on a robot where nobody set them, and they do
# not mind `nan`. Convert and check yourself, where the value comes in.

# %% [markdown]
# ### Not a message
#
# A robot shall say hello.

# %% id="plain-str" tags=["raises-exception"]
from std_msgs.msg import String

voice = fresh(lambda: Node("voice"))
words = voice.create_publisher(String, "/robot/voice", 10)
words.publish("hello")

# %% [markdown]
# `publish` sends messages, and `"hello"` is a `str`. What it *is* comes last in the text, what it should be first. Put it into
# a message: `words.publish(String(data="hello"))`.

# %% [markdown]
# ### Two arguments of three

# %% id="no-depth" tags=["raises-exception"]
voice.create_publisher(String, "/robot/mood")

# %% [markdown]
# `qos_profile` is the third argument. QoS is quality of service, a matter of lesson 13. A plain number will do for it: the
# depth. `voice.create_publisher(String, "/robot/mood", 10)`

# %% [markdown]
# ### The error that sends you the wrong way

# %% id="not-a-class" tags=["raises-exception"]
voice.create_publisher("String", "/robot/mood", 10)

# %% [markdown]
# You never had a ROS 1 on this machine, so do not go looking for it. The text means: *this is no message class*. Here it
# is the name in quotes. With the Python type `str` it says `type` in place of `str`. The cure is an import and no quotes:
# `from std_msgs.msg import String`, and `create_publisher(String, ...)`.

# %% [markdown]
# ### One topic, two types
#
# `/robot/voice` carries `String`. In the same program somebody wants to send the loudness there.

# %% id="two-types"
try:
    voice.create_publisher(Float32, "/robot/voice", 10)
except Exception as error:
    print(type(error).__name__, "·", str(error).split(", at ")[0])

# %% [markdown]
# `rt/robot/voice` is how DDS, the layer below, spells the topic, and `..._::Float32_` is the type that does not fit. That
# was the kind case. When the two sit in **different** programs, nobody sees the clash. This program publishes the battery
# as `Float32`, and the ear in this notebook expects `Float64`:

# %% id="two-types-two-programs"
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
# Silence on both sides, no warning. If a topic is there and nothing comes, look at the types first: `topic_info` here,
# `ros2 topic info --verbose` on a robot.

# %% [markdown]
# ### The right number, and still no meaning
#
# 0.8 on `/robot/battery`. Percent, or a share? Measured when? Of which battery? A `Float32` cannot say. It is good for
# learning and for a quick try, and ROS itself advises against `std_msgs/Float32` and its brothers for anything that stays.
# For what robots usually say there are messages with meaning:

# %% id="with-meaning"
from sensor_msgs.msg import BatteryState, JointState

state = BatteryState()
state.header.frame_id = "back_battery"
state.percentage = 0.8  # a share, from 0 to 1: the definition says so
state.voltage = 47.9
state.power_supply_status = BatteryState.POWER_SUPPLY_STATUS_DISCHARGING
state.present = True
state.header.stamp = voice.get_clock().now().to_msg()
for field in ("current", "temperature", "charge", "capacity", "design_capacity"):
    setattr(state, field, math.nan)  # not measured: the definition says how to say so

joints = JointState()
joints.name = ["left_shoulder", "left_elbow"]
joints.position = [0.3, -1.1]  # rad

print("Float32 has:     ", ", ".join(Float32.get_fields_and_field_types()))
print("BatteryState has:", ", ".join(list(BatteryState.get_fields_and_field_types())[:8]), "and more")
print("JointState has:  ", ", ".join(JointState.get_fields_and_field_types()))

# %% [markdown]
# A time stamp, names, units that are written down, and "not known" can be told apart from zero, *if you say it*: these
# fields, too, begin with 0.0, and nobody has measured 0 °C. Dashboards, loggers and planners of other people understand
# these messages without asking you. They are filled like every other message, field by field.

# %% [markdown]
# ## From a worked example to your own
#
# **Worked.** A robot that speaks. The publisher is made once, in `__init__`. And the method looks at what it is given,
# *before* it makes a message. Whoever gives it nonsense gets an error, and can do something about it.

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
spin_for(ear, seconds=5, until=lambda: speech.speech_publisher.get_subscription_count() == 1)
for text in ("mind the step", 42, "  ", "good morning"):
    try:
        speech.say(text)
    except (TypeError, ValueError) as error:
        print(f"{type(error).__name__}: {error}")
spin_for(ear, seconds=5, until=lambda: len(ear.heard) == 2)
print("heard:", [message.data for message in ear.heard])

# %% [markdown]
# **Faded.** A robot that drives. `drive` gets two numbers of any kind, and sends a `Twist`. There are two things
# to do. Until then the cell runs, and says so.

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
    spin_for(ear, seconds=5, until=lambda: wheels.command_publisher.get_subscription_count() == 1)
    wheels.drive(np.float32(0.5), -1)
    spin_for(ear, seconds=5, until=lambda: ear.heard)
    print("forward", ear.heard[0].linear.x, "turn", ear.heard[0].angular.z, "- there should be 0.5 and -1.0")

# %% [markdown]
# **Your own.** In the [exercise](../exercises/03_publishers_and_messages.ipynb) you write a battery report that never lies:
# every number arrives, and nothing that is no number gets out.

# %% [markdown]
# ## Check yourself
#
# **1. On the stock ROS of this course, a node publishes `Float32(data=np.float32(55.5))`. What does a listener get?**
#
# <details><summary>a) 55.5</summary>
#
# ✗ One would think so: 32 bits here and there. But what ROS reads is the inside of a Python float, and `np.float32` is
# none.
#
# </details>
# <details><summary>b) 0.0</summary>
#
# ✓ Yes, and no error on the way. `float(...)` around it, and 55.5 arrives.
#
# </details>
# <details><summary>c) Nothing: `publish` raises an error</summary>
#
# ✗ It would, if field checks had been on before `std_msgs.msg` was imported. On stock ROS they are off.
#
# </details>
#
# **2. A robot shall turn to the right on the spot. Which `Twist`?**
#
# <details><summary>a) `command.angular.z = -0.5`, all the rest as it is</summary>
#
# ✓ Left is above zero, right is below. Speeds that you do not set are zero.
#
# </details>
# <details><summary>b) `command.angular = -0.5`</summary>
#
# ✗ `angular` is a message, a `Vector3`, not a number. Its field `z` is the one.
#
# </details>
# <details><summary>c) `command.linear.y = -0.5`</summary>
#
# ✗ That asks the robot to slide to its right without turning. Most cannot.
#
# </details>
#
# **3. A camera publishes with depth 100, a busy listener has depth 1. What does the listener find after a second?**
#
# <details><summary>a) All the pictures of that second</summary>
#
# ✗ They wait at the listener, and it has room for one.
#
# </details>
# <details><summary>b) The picture at which the camera stopped, to wait for the listener</summary>
#
# ✗ `publish` comes back at once, whoever listens.
#
# </details>
# <details><summary>c) The latest picture</summary>
#
# ✓ The depth of the listener decides. And for pictures one is a good choice: who wants to see the past?
#
# </details>
#
# **4. A program imports `Float32` and then sets `ROS_PYTHON_CHECK_FIELDS` to 1. What do you get?**
#
# <details><summary>a) Checked messages</summary>
#
# ✗ The class looks at the variable when it is loaded, and that was one line too early.
#
# </details>
# <details><summary>b) A program that looks safe and is not</summary>
#
# ✓ Just what you saw: the int went out as 0.0. Set it before the import, or where the program is started.
#
# </details>
# <details><summary>c) An error, because the variable comes too late</summary>
#
# ✗ Nobody looks at it any more, so nobody complains either.
#
# </details>
#
# **5. A leg sends its length as `Float32(data=0.1)`. A monitor asks `if message.data == 0.1`, and never reacts. Why?**
#
# <details><summary>a) 0.1 in 32 bits is another number than 0.1 in 64 bits</summary>
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
# ✗ It sends four bytes, and they hold about seven digits. Nothing is written as text.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Discuss this with a colleague or an AI assistant:
#
# > The screen of our robot shows 64 % battery, now and then 0 % for a moment, then 64 % again. Three people have changed
# > the node this month. It reads the charge from a C library, smooths it with NumPy and publishes a `Float32`. How do we find
# > the cause, and how do we make sure that it cannot come back?
#
# <details><summary>What a good answer contains</summary>
#
# First look at the wire, not at the code: does 0.0 really arrive on the topic, and does only one node publish there?
# If so, print `type(level)` beside `level` right before `publish`, or start the node with
# `ROS_PYTHON_CHECK_FIELDS=1`: the line that gives a field something else than a float then raises an error. Suspects
# are an `int` when the charge is a whole number, `None` when the library has no value, and `np.float32` from the
# smoothing. The mending: one place where values come in, `float(level)` for numbers, an error for everything else,
# `math.isfinite` against nan. Making it stay: a test that publishes each of these kinds and looks at what arrives,
# and the checks switched on in the tests. Good answers ask what the node should do when there is no value (an error,
# silence, or a message that can say "not known", such as `BatteryState`), and warn of an assistant that proposes type
# hints: ROS does not read them.
#
# </details>

# %% [markdown]
# ## Take away
#
# - `create_publisher(MessageClass, "/topic", depth)`, once, in `__init__`; then `publish(message)`, as often as you like.
# - A float field wants a Python float. An int, `np.float32`, `None` or a text goes out as 0.0 or worse, without a word:
#   `float(...)`.
# - `ROS_PYTHON_CHECK_FIELDS=1` makes ROS look, if it is set before the message class is imported.
# - 32 bits hold about seven digits: never `==`, always "close to".
# - One topic, one type. In two programs, two types on one topic are silent. For what stays, take messages with meaning.
#
# **Before:** [02 · Nodes](02_nodes.ipynb)
#
# **Next:** [04 · Subscriptions and callbacks](04_subscriptions_and_callbacks.ipynb): the other end of the topic.
#
# **More:** [Interfaces](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Interfaces.html), with all field types, and
# [topics](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Topics.html).

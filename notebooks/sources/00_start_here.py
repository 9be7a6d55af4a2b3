# %% [markdown]
# # 00 · Start here
#
# A robot is many small programs that talk to each other all the time. In a minute you will see two of them do it.
#
# - **Minutes:** 50
# - **You need:** Python classes and functions. No robot, no ROS
# - **You will be able to:** start a robot program and watch it, say what rclpy is and what lies below it, change a
#   number and see the robot change, and help yourself when something is stuck
# - **Left out:** how to write such a program (that begins with the next lesson)

# %% [markdown]
# Click into the gray cell below and press **Shift+Enter**. It runs, and the next cell is selected.

# %%
from lesson_nodes import joint_position_publisher
from workbook.lesson import start, stop, watch_robot

print("started", start(joint_position_publisher))
await watch_robot(seconds=6, ease=0.1)

# %% [markdown]
# That was no animation. Two programs were at work: one made up where the twelve joints of the robot are, twenty times
# a second, and sent it off. This notebook received the numbers and drew what they say. The robot is simulated; the
# sending and receiving is real. It is what runs on real robots: **ROS 2**, the Robot Operating System.

# %% [markdown]
# ### What is rclpy?
#
# `rclpy` is the Python library of ROS 2. You write an ordinary Python class with a few methods; rclpy makes it a
# **node**: something that other programs of the robot can find and talk to. They may run on another computer and be
# written in another language. You do not open a connection, and you pack no bytes.
#
# ### Why does it matter?
#
# Physical AI is AI with a body: it perceives, decides and moves. No single program does all that. On a humanoid, camera
# drivers and motor control are mostly C++, because there each millisecond counts. Perception, planning and learning are
# mostly Python, because NumPy, OpenCV and PyTorch are there. Nodes are how the two meet:
#
# - A trained model becomes part of the robot in a few lines: images come in on one topic, detections go out on another.
# - An idea is tried in minutes. Change a line, start that one program again, and the rest of the robot runs on.
# - What you write is what others use: the same nodes and messages in a lecture, a research lab and a warehouse.
#
# Python has a limit, and we will measure it: not for loops that must be on time to the millisecond, a thousand times a
# second. Those stay in C++, and your node talks to them.

# %% [markdown]
# ### How these notebooks work
#
# **Predict, run, change.** Before something happens, you say what will happen. Then you run it and look. Then you turn a
# knob. A wrong prediction is worth more than a right one: it shows which belief has to change.
#
# **`await`.** You will see this word before some calls: let this run, and keep the notebook alive meanwhile, so that
# pictures move and the stop button works. Just write it where you see it. It belongs to notebook cells and to functions
# that begin with `async def`; in an ordinary program there is another way. (Lesson 12 says what is behind it.)
#
# This notebook is your own copy. Change whatever you like in it. First, stop the robot's program:

# %%
stop()

# %% [markdown] prediction="end-of-the-program"
# ## Predict
#
# We start the robot again and watch it for six seconds. But after three seconds its program is ended, while the
# notebook goes on watching. What will you see?
#
# - **a** An error message: the connection was lost.
#   ✗ There was no connection that could be lost. The notebook listens to a topic, and a topic that goes quiet is no
#   error.
# - **b** The robot goes back to rest, with its arms down.
#   ✗ Nobody tells the robot to go to rest. The notebook draws the last message that it got.
# - **c** The robot stands still in its last pose.
#   ✓ No more messages come, and the pose in the last one is all that the notebook knows of the robot.
# - **d** The robot goes on waving: the notebook knows the movement by now.
#   ✗ The notebook does not work out the movement. It draws the numbers that it receives, and there are no new ones.
#
# Run the cell below and press the button of your choice. You can change it until the run.

# %%
from workbook.lesson import predict, reveal

predict("end-of-the-program")

# %% [markdown]
# ## Run it

# %%
import asyncio

start(joint_position_publisher)
asyncio.get_running_loop().call_later(3, stop)  # in three seconds, end the robot's program
await watch_robot(seconds=6, ease=0.1)

# %%
reveal("end-of-the-program")

# %% [markdown]
# ## Look inside
#
# The notebook never had a connection to the robot's program, so none was lost. Each of the two knows only a **topic**: a
# name, here `/robot/joint_positions`, and a type of message, here an array of numbers. One **publishes** on it, whether
# anybody listens or not. The other **subscribes** to it, whether anybody speaks or not. When the speaker ends, it is quiet,
# and the last pose is all that the listener has.
#
# So one program of a robot can crash without taking the others along. It also means that silence is no error by itself:
# whoever depends on a topic has to notice that nothing comes.
#
# ### Who is who
#
# Three robot programs at once, each a process of its own:

# %%
from lesson_nodes import humanoid_status_publisher, status_monitor

for program in (humanoid_status_publisher, status_monitor, joint_position_publisher):
    print("started", start(program))

# %%
from workbook.lesson import graph_picture

graph_picture()

# %% [markdown]
# Read it from left to right. `/humanoid_status_publisher` says on two topics how the robot is, and `/status_monitor`
# listens to both. Nobody listens to the joint positions at this moment, and they are published all the same.
#
# None of the programs names another one. They found each other by the names of topics. Does anything really travel
# between them? Let us listen in to the next two messages:

# %%
from workbook.ros import topic_echo

for message in topic_echo("/robot/status", count=2).messages:
    print(message)

# %%
stop()

# %% [markdown]
# ### What lies below your Python
#
# | layer | what it does | written in |
# |---|---|---|
# | your Python | decides what the robot does | Python |
# | **rclpy** | nodes, timers and messages that feel like Python | Python, and a thin bridge to C |
# | **rcl** | the common core: the same rules for every language | C |
# | **rmw** | a list of calls that any middleware can fill in | C |
# | **DDS** | finds the other processes, carries the bytes to them | C++ (here Fast DDS) |
#
# `rcl` is short for *ROS client library*. The C++ library `rclcpp` stands on the same core. That is why a Python node and
# a C++ node agree on names, types and rates without knowing of each other's language.
#
# This is not theory: all of it is loaded into the very process that runs this cell. Linux tells us.

# %%
import os
from importlib.metadata import version
from pathlib import Path

import rclpy

loaded = Path("/proc/self/maps").read_text()
layers = {
    "rclpy": "_rclpy_pybind11",
    "rcl": "librcl.so",
    "rmw": "librmw.so",
    "rmw for Fast DDS": "librmw_fastrtps_cpp.so",
    "Fast DDS": "libfastrtps.so",
}
for layer, library in layers.items():
    print(f"{layer:<17} {library:<23} {'loaded' if library in loaded else 'not found'}")

# %%
print("rclpy:", version("ros-jazzy-rclpy"), "of ROS 2 Jazzy")
print("middleware:", rclpy.get_rmw_implementation_identifier())
print("a domain between 1 and 101:", 1 <= int(os.environ["ROS_DOMAIN_ID"]) <= 101)

# %% [markdown]
# The **domain** is like the channel of a radio. Only programs on the same channel hear each other. Each open notebook
# takes a free one, so your robot and that of your neighbor do not mix.

# %% [markdown] prediction="wave-faster"
# ## Change it
#
# The robot's program has two numbers that can be set when it starts:
#
# | number | meaning | usual |
# |---|---|---|
# | `waves_per_second` | how often the hand goes to and fro in a second | 0.8 |
# | `period_s` | seconds from one message to the next | 0.05 |
#
# ### Experiment 1: wave faster
#
# We set `waves_per_second=2.0`. What changes?
#
# - **a** The hand moves faster, and as many messages come as before.
#   when `messages_per_second < 25`
#   ✓ `waves_per_second` sets how fast the hand moves. The program still reports once in 0.05 s.
# - **b** The hand moves faster, and more messages come in a second.
#   when `messages_per_second >= 25`
#   ✗ The hand does move faster. But how often the program reports is another number, `period_s`, and we left it
#   alone.
# - **c** The hand moves as before, and more messages come in a second.
#   ✗ `waves_per_second` is about the movement, and that is what changed. The messages have a number of their own.

# %%
predict("wave-faster")

# %%
start(joint_position_publisher, waves_per_second=2.0)
await watch_robot(seconds=5, ease=0.1)

# %%
from workbook.ros import topic_hz

rate = topic_hz("/robot/joint_positions", seconds=3)
print("about 20 messages a second, as before:", 15 < rate.mean_hz < 25)
reveal("wave-faster", messages_per_second=rate.mean_hz)

# %% [markdown]
# How the robot moves and how often it tells of it are two things. Beginners often mix them up, and so did some robots.

# %% [markdown] prediction="report-less-often"
# ### Experiment 2: report less often
#
# The usual wave again, but with `period_s=0.5`: one message in half a second.
#
# - **a** The hand waves slowly and smoothly.
#   ✗ The wave is as fast as before. And it cannot look smooth with two messages a second.
# - **b** Nothing changes: the pictures in between are filled in.
#   ✗ Nobody fills in what was not sent. With `ease=0` the picture shows each pose as it comes.
# - **c** The hand jumps: we see two poses a second of a wave that is as fast as ever.
#   ✓ The robot moves as before, but reports only two poses in a second. The picture can show no more than these.

# %%
predict("report-less-often")

# %%
start(joint_position_publisher, period_s=0.5)
await watch_robot(seconds=6, ease=0)
reveal("report-less-often")

# %%
stop()

# %% [markdown]
# `ease=0` shows each pose as it comes. With `ease=0.5` the picture glides from one pose to the next and looks fine, but
# it is a guess of ours. Try it, and try other numbers: these cells can be run as often as you like.

# %% [markdown]
# ## When it goes wrong
#
# **The forgotten dot.** We change one number again, this time to `2`.

# %%
try:
    start(joint_position_publisher, waves_per_second=2)
except RuntimeError as error:
    print(str(error).splitlines()[-1])

# %% [markdown]
# The program ended at once, and the last line says why. (Read error messages from the last line up.) `2` is a whole
# number, and this parameter is a number with a decimal point. ROS does not convert one into the other. Write `2.0`.
#
# A misspelled parameter is worse: `wave_per_second=2.0` is taken without a word and changes nothing.
#
# **A name that is not there.** Names must match letter by letter, and a topic exists only while somebody uses it.

# %% tags=["raises-exception"]
from workbook.ros import topic_info

start(joint_position_publisher)
topic_info("/robot/joint_postions")

# %% [markdown]
# `positions` lost an `i`. The tools make a guess at what you meant. A subscriber would not: it would wait in silence,
# on a topic where nobody speaks. That is the most frequent fault of beginners, and the first thing to look at when
# nothing comes.

# %%
stop()

# %% [markdown]
# ### When you are stuck
#
# | what you see | what to do |
# |---|---|
# | `[*]` stays beside a cell | it is still running. The button **■** above ends it, as Ctrl-C does in a terminal |
# | `NameError: name 'start' is not defined` | a cell further up was not run: *Run > Run All Above Selected Cell* |
# | a robot still waves, or two do | `stop()` ends all programs that this notebook has started |
# | everything is confused | the button **⟳** restarts the kernel. Programs and variables are gone, your text stays |
# | not even the first cell works | `workbook doctor` in a terminal says what is wrong with the machine |
# | an exercise does not pass | its card shows the first thing to mend; `%hint` helps in three steps |

# %% [markdown]
# ## From a worked example to your own
#
# **Worked.** Here is a whole node, and this notebook is the process that runs it. You need not write one yet; read it.

# %%
from rclpy.node import Node
from std_msgs.msg import Float32MultiArray

from workbook.lesson import fresh, init, run

init()  # plug this process into ROS


class ArmWatcher(Node):
    """Counts the messages with joint angles, and remembers the left elbow."""

    def __init__(self):
        super().__init__("arm_watcher")
        self.heard = 0
        self.create_subscription(Float32MultiArray, "/robot/joint_positions", self.on_joints, 10)

    def on_joints(self, message):  # called for each message that arrives
        self.heard += 1
        self.left_elbow = message.data[3]


start(joint_position_publisher)
watcher = fresh(ArmWatcher)
await run(watcher, seconds=20, until=lambda: watcher.heard == 40)
print("messages from the other process:", watcher.heard)

# %%
graph_picture("/arm_watcher")

# %% [markdown]
# The robot's program on the left, your notebook on the right, one topic between them. `arm_watcher` knows nothing of the
# program that it hears. The rest of the course is about writing both sides well.
#
# **Faded.** Now you: put a number in place of `...`, run the cell, and watch. A lazy wave? A frantic one?

# %%
stop()
WAVES_PER_SECOND = ...  # TODO: a number with a decimal point, for example 0.3

if WAVES_PER_SECOND is ...:
    print("Put a number in place of the three dots, then run this cell again.")
else:
    start(joint_position_publisher, waves_per_second=WAVES_PER_SECOND)
    await watch_robot(seconds=6, ease=0.1)
    stop()

# %% [markdown]
# **Your own** (nobody grades it). Three steps, and you are ready for the course.
#
# *One: is this machine all right?* The doctor looks at Python, the packages and Jupyter, and lets two processes talk to
# each other. It takes some seconds.

# %% tags=["nbval-ignore-output"]
from workbook.lesson import doctor

ready = doctor()

# %%
print("this machine is ready:", ready)

# %% [markdown]
# If it is not, do what stands behind the first `→`, and run the cell again. A `!` is only worth knowing.
#
# *Two: a second window on the same robot.* Start it, and let it run:

# %%
print("running:", start(humanoid_status_publisher))

# %% [markdown]
# Open a terminal beside this notebook: *File > New > Terminal*. There, type one after the other:
#
#     workbook node list
#     workbook topic list
#     workbook topic echo /robot/battery --count 3
#     workbook graph
#
# If several notebooks are open, it asks which one you mean. These commands tell what `ros2` tells in a full installation
# of ROS 2. If you have one, `ros2` itself can listen in: this line, typed into its terminal, tunes it to the domain
# of this notebook.

# %% tags=["nbval-ignore-output"]
from workbook.ros import join_line

print(join_line())

# %%
domain = os.environ["ROS_DOMAIN_ID"]
print("it names the domain of this notebook:", f"ROS_DOMAIN_ID={domain} " in join_line())

# %% [markdown]
# *Three: change one number.* In the section *Change it*, make a robot that waves twice a second and reports ten times a
# second. Say beforehand what you will see. At the end:

# %%
stop()

# %% [markdown]
# From the next lesson on, each lesson has an exercise. You write a program, `%start` runs it beside the notebook, and
# `%check` watches what it does on its topics and says, usually after some seconds, what is right and what to mend
# first.

# %% [markdown]
# ## Check yourself
#
# **1. What is rclpy?**
#
# <details><summary>a) The Python library with which a program becomes a node of ROS 2</summary>
#
# ✓ It makes nodes, topics and timers usable from Python, and passes the work on to `rcl`.
#
# </details>
# <details><summary>b) A simulator of robots</summary>
#
# ✗ A simulator makes up a world. rclpy only connects programs; whether the robot behind them is real or made up, it
# neither knows nor cares.
#
# </details>
# <details><summary>c) A translator that turns Python into C++</summary>
#
# ✗ Your code stays Python and is run by Python. It calls a core that is compiled, as NumPy does.
#
# </details>
#
# **2. A program publishes on a topic, and nobody subscribes. What happens?**
#
# <details><summary>a) It waits until somebody does</summary>
#
# ✗ A publisher waits for nobody. In the first picture of the graph nobody listened to the joint positions.
#
# </details>
# <details><summary>b) It publishes all the same, and the messages are gone</summary>
#
# ✓ Publishers and subscribers come and go on their own. (How a late one can still get the last message is lesson 13.)
#
# </details>
# <details><summary>c) It gets an error</summary>
#
# ✗ To speak without listeners is perfectly normal on a robot. A camera does not fail because nobody looks.
#
# </details>
#
# **3. What do `rclpy` and `rclcpp` have in common?**
#
# <details><summary>a) Nothing; a bridge is needed between them</summary>
#
# ✗ On the wire their messages are the same bytes. No bridge is needed.
#
# </details>
# <details><summary>b) rclpy calls rclcpp</summary>
#
# ✗ They stand side by side on the same core. Neither needs the other.
#
# </details>
# <details><summary>c) Both stand on rcl, a library in C</summary>
#
# ✓ So names, types and rules are the same, and nodes of both kinds talk to each other.
#
# </details>
#
# **4. Your node runs, but it hears nothing. What do you look at first?**
#
# <details><summary>a) The version of Python</summary>
#
# ✗ If your node runs, Python is good enough.
#
# </details>
# <details><summary>b) The network cable</summary>
#
# ✗ In these lessons everything happens inside one computer. And names are wrong far more often than cables.
#
# </details>
# <details><summary>c) The names: is the topic in the list, spelled exactly so, with somebody who publishes?</summary>
#
# ✓ `topic_list()` in a notebook or `workbook topic list` in a terminal answers that in a second.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Discuss it with somebody, or with an AI assistant. Say your own view first.
#
# > A team builds a humanoid. Should it be one large Python program, or ten nodes that talk over topics? What does each
# > way make easier, and what harder? Which parts would you write in Python, and which not?
#
# <details><summary>What a good answer contains</summary>
#
# One program is easier to start and to step through, and its parts share memory. Nodes can be started, replaced and
# tested one by one, can crash one by one, run on several computers, and be written in the language that fits. The price:
# messages cost time and copies, things happen at the same time, silence must be noticed, and there are more parts to
# look after. Python for perception, planning, learning and user interfaces; C++ (or a microcontroller) for motor control
# and for whatever must be on time to the millisecond.
#
# </details>

# %% [markdown]
# ## Take away
#
# - A robot is many programs. Each runs one or more nodes.
# - Nodes talk over topics: a name and a type. Nobody needs to know who is at the other end.
# - rclpy is the Python face of rcl; below it rmw and DDS carry the messages.
# - How the robot moves and how often it reports are two different numbers.
# - Predict, run, change. ■ stops a cell, `stop()` stops the robots, `workbook doctor` knows the machine.
#
# **Next:** [01 · The context](01_the_context.ipynb): what begins before the first node and ends after the last.
#
# **More:** [Nodes](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Nodes.html),
# [topics](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Topics.html) and
# [the layers of ROS 2](https://docs.ros.org/en/jazzy/Concepts/Advanced/About-Internal-Interfaces.html).

# %% [markdown]
# # 00 · Start here
#
# A robot is many small programs that talk to each other all the time. In a minute you will see two of them do it.
#
# - **Minutes:** 45
# - **You need:** Python classes and functions. No robot, no ROS
# - **You will be able to:**
#   - start a robot program and watch it
#   - write a program of ten lines that moves the robot
#   - say what rclpy is and what lies below it
#   - help yourself when something is stuck
# - **Left out:** how a program starts and ends well (that is the next lesson)

# %% [markdown]
# Click into the gray cell below and press **Shift+Enter**. It runs, and the next cell is selected.

# %%
from lesson_nodes import joint_position_publisher
from workbook.lesson import start, stop, watch_robot

print("started", start(joint_position_publisher))
await watch_robot(seconds=6, ease=0.1)

# %% [markdown]
# What you just saw was not a recording. Two programs were at work. One computed the angles of the robot's twelve
# joints, twenty times a second, and sent them. This notebook received the numbers and drew the robot. The robot is
# simulated, but the sending and receiving is real. It is the software that runs on real robots: **ROS 2**, the Robot
# Operating System.

# %% [markdown]
# **What is rclpy?** It is the Python library of ROS 2. You write an ordinary Python class with a few methods. rclpy makes
# it a **node**: a part of the robot that other programs can find and talk to. They may run on another computer, and they
# may be written in another language.
#
# **Why does it matter?** On a humanoid, camera drivers and motor control are mostly C++, because each millisecond counts
# there. Perception, planning and learning are mostly Python, because NumPy, OpenCV and PyTorch are there. Nodes connect
# the two:
#
# - A trained model becomes part of the robot in a few lines. Images come in on one topic, detections go out on another.
# - You can try an idea in minutes. Change a line and start that one program again. The rest of the robot keeps running.
#
# Python has a limit, and we will measure it. A loop that must be on time to the millisecond, a thousand times a second,
# stays in C++. Your node talks to it.

# %% [markdown]
# **How do these notebooks work?** Predict, run, change. Before you run something, say what will happen. Then run it and
# look. Then change a number. A wrong prediction is worth more than a right one, because it shows what you can learn.
#
# **`await`.** This word stands before calls that take a while. It keeps the notebook alive meanwhile, so that pictures
# move and the stop button works. When you copy or change such a call, keep the word in front of it. (Lesson 12
# explains it.)
#
# This notebook is your own copy, so change whatever you like. First, stop the robot's program:

# %%
stop()

# %% [markdown] prediction="end-of-the-program"
# ## Predict
#
# We start the robot again and watch it for six seconds. After three seconds we end its program, and keep watching. What
# will you see?
#
# - **a** An error message: the connection was lost.
#   ✗ DDS does notice that the publisher is gone, and takes it off its list. But ROS does not treat that as an error: a
#   topic may have no publisher.
# - **b** The robot goes back to rest, with its arms down.
#   ✗ No program tells the robot to go to rest. The notebook draws the last message that it got.
# - **c** The robot stands still in its last pose.
#   ✓ No more messages come, and the pose in the last one is all that the notebook knows of the robot.
# - **d** The robot keeps waving: the notebook knows the movement by now.
#   ✗ The notebook does not work out the movement. It draws the numbers that it receives, and there are no new ones.
#
# Run the cell below and press the button of your choice. You can change it until you see the outcome.

# %%
from workbook.lesson import predict, reveal

predict("end-of-the-program")

# %% [markdown]
# ## Run it

# %%
import asyncio

start(joint_position_publisher)
asyncio.get_running_loop().call_later(
    3, stop
)  # in three seconds, end the robot's program
await watch_robot(seconds=6, ease=0.1)
reveal("end-of-the-program")

# %% [markdown]
# ## Look inside
#
# There is no error. DDS, the layer that carries the messages, did notice, and took the publisher off its list. But ROS
# does not treat that as an error. Each of the two programs knows only a **topic**: a name, here
# `/robot/joint_positions`, and a type of message, here an array of numbers. One program **publishes** on it, with or
# without subscribers. The other **subscribes** to it, with or without publishers.
#
# So one program of a robot can crash without taking the others along. It also means that your node has to notice by
# itself when a topic goes silent.
#
# ### Who is who
#
# Three robot programs at once, each a process of its own:

# %%
from lesson_nodes import humanoid_status_publisher, status_monitor
from workbook.lesson import graph_picture

for program in (humanoid_status_publisher, status_monitor, joint_position_publisher):
    print("started", start(program))

graph_picture()

# %% [markdown]
# Read it from left to right. `/humanoid_status_publisher` publishes on two topics, and `/status_monitor` subscribes to
# both. No program subscribes to the joint positions at this moment. They are published all the same.
#
# No program names another one. They found each other by the names of their topics. Here are the next two messages on one
# of them:

# %%
from workbook.ros import topic_echo

for message in topic_echo("/robot/status", count=2).messages:
    print(message)
stop()

# %% [markdown]
# ### Your own robot program, in ten lines
#
# Now you. The next cell writes its text into a file, `my_wave.py`. This is a complete program.

# %%
# %%writefile my_wave.py
import time

import rclpy
from std_msgs.msg import Float32MultiArray

rclpy.init()
node = rclpy.create_node("my_wave")
publisher = node.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)


def move() -> None:
    up = time.time() % 2 < 1  # a second up, a second down
    publisher.publish(
        Float32MultiArray(data=[0.0, 0.0, 2.4 if up else 0.3] + [0.0] * 9)
    )


node.create_timer(0.1, move)
rclpy.spin(node)

# %%
print("started", start("my_wave.py"))
await watch_robot(seconds=6, ease=0.4)
stop()

# %% [markdown]
# The robot raises its left arm and lowers it, because *your* program says so. Line by line: `init` starts ROS, and
# `create_node` makes a node. `create_publisher` names a message type and a topic. `move` makes a message of twelve angles
# in radians, and publishes it. The timer calls `move` every 0.1 s, and `spin` keeps the node working.
#
# The third angle belongs to the left shoulder, the fifth to the right one. Change a number, then run both cells again.
# (`[0.0] * 9` are nine more angles of 0.0. Lessons 01 to 06 explain each line of this program.)

# %% [markdown]
# ### What lies below your Python

# %%
from workbook.pictures.figures import show
from workbook.pictures.layers import DESCRIPTION, layers

show(layers(), DESCRIPTION)

# %% [markdown]
# `rcl` is short for *ROS client library*. The C++ library `rclcpp` stands on the same core. That is why a Python node and
# a C++ node agree on names, types and rates, and neither knows the other's language.
#
# All these layers are loaded into the process that runs this cell. Linux lists them:

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
print("rclpy:", version("ros-jazzy-rclpy"), "of ROS 2 Jazzy")
print("middleware:", rclpy.get_rmw_implementation_identifier())
print("a domain between 1 and 101:", 1 <= int(os.environ["ROS_DOMAIN_ID"]) <= 101)

# %% [markdown]
# Each open notebook takes a free **domain**, which is a number. Lesson 01 shows what it is for.

# %% [markdown] prediction="wave-faster"
# ## Change it
#
# The robot's program has two numbers that can be set when it starts:
#
# | number | meaning | usual |
# |---|---|---|
# | `waves_per_second` | how often the hand moves to and fro in a second | 0.8 |
# | `period_s` | seconds from one message to the next | 0.05 |
#
# ### Experiment 1: the first number
#
# We set `waves_per_second=2.0`. What changes?
#
# - **a** The hand moves faster, and as many messages come as before.
#   when `messages_per_second < 25`
#   ✓ `waves_per_second` sets how fast the hand moves. The program still reports once every 0.05 s.
# - **b** The hand moves faster, and more messages come in a second.
#   when `messages_per_second >= 25`
#   ✗ The hand does move faster. But how often the program reports is another number, `period_s`, and we left it
#   alone.
# - **c** The hand moves as before, and more messages come in a second.
#   ✗ `waves_per_second` is about the movement, and that is what changed. How often messages come is another number.

# %%
predict("wave-faster")

# %%
from workbook.ros import topic_hz

start(joint_position_publisher, waves_per_second=2.0)
await watch_robot(seconds=5, ease=0.1)

rate = topic_hz("/robot/joint_positions", seconds=3)
print("messages a second, to the nearest ten:", round(rate.mean_hz / 10) * 10)
reveal("wave-faster", messages_per_second=rate.mean_hz)

# %% [markdown] prediction="report-less-often"
# ### Experiment 2: the second number
#
# The usual wave again, but with `period_s=0.5`. We also watch with `ease=0`. (`ease` is how many seconds the picture
# takes to glide to a new pose.) What will you see?
#
# - **a** The hand waves slowly and smoothly.
#   ✗ The wave is as fast as before. And it cannot look smooth with two messages a second.
# - **b** The hand waves as smoothly as before.
#   ✗ With `ease=0` no pose is filled in. The picture shows each pose when its message comes.
# - **c** The hand jumps: we see two poses a second of a wave that is as fast as ever.
#   ✓ The robot moves as before, but reports only two poses in a second. The picture can show no more than these.

# %%
predict("report-less-often")

# %%
start(joint_position_publisher, period_s=0.5)
await watch_robot(seconds=6, ease=0)
reveal("report-less-often")
stop()

# %% [markdown]
# How the robot moves and how often it reports its pose are two different numbers. Beginners often mix them up.
#
# With `ease=0.5` the picture glides from one pose to the next. It looks fine, but the poses in between are our guess. Try
# it, and try other numbers. You can run these cells as often as you like.
#
# Or use a slider. While the next cell runs, drag it: each move starts the program again with the new number.

# %%
from workbook.lesson import knob

await knob(
    joint_position_publisher, "waves_per_second", 0.8, between=(0.1, 3.0), seconds=8
)

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
# number, and this parameter is a number with a decimal point. So write `2.0`.
#
# A misspelled parameter is worse: `wave_per_second=2.0` is accepted silently, and changes nothing.
#
# **A name that does not exist.** Names must match letter by letter, and a topic exists only while a program uses it.

# %% tags=["raises-exception"]
from workbook.ros import topic_info

start(joint_position_publisher)
topic_info("/robot/joint_postions")

# %% [markdown]
# `positions` lost an `i`. The tools guess what you meant. A subscriber would not: it would wait silently, on a topic
# without a publisher. Misspelled names are a very common beginner's mistake. When no message comes, check the names
# first.

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
# | an exercise does not pass | its card shows the first thing to fix; `%hint` helps in three steps |

# %% [markdown]
# ## From a worked example to your own
#
# **Worked.** `my_wave.py`, further up. Have a look at it again.
#
# **Faded.** Make the robot raise its *right* arm. Fill in what is `...`, then run both cells. Until then, the second
# one says what is missing.

# %%
# %%writefile my_robot.py
import rclpy
from std_msgs.msg import Float32MultiArray

rclpy.init()
node = rclpy.create_node("my_robot")
publisher = ...  # TODO: a publisher for Float32MultiArray on /robot/joint_positions


def reach() -> None:
    angles = [0.0] * 12
    angles[4] = ...  # TODO: the right shoulder; 0.3 is down and 2.4 is up
    publisher.publish(Float32MultiArray(data=angles))


node.create_timer(0.1, reach)
rclpy.spin(node)

# %%
if "..." in Path("my_robot.py").read_text():
    print("Fill in the two places in the cell above, run it, then run this cell again.")
else:
    print("started", start("my_robot.py"))
    await watch_robot(seconds=6, ease=0.4)
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
# If it is not, follow the instruction after the first `→`, and run the cell again. A line with `!` is only a note.
#
# *Two: a second window on the same robot.* Start it, and let it run:

# %%
print("running:", start(humanoid_status_publisher))

# %% [markdown]
# Open a terminal beside this notebook: *File > New > Terminal*. There, type these commands, one by one:
#
#     workbook node list
#     workbook topic list
#     workbook topic echo /robot/battery --count 3
#     workbook graph
#
# If several notebooks are open, the command asks which one you mean. These commands show what `ros2` shows in a full
# installation of ROS 2. If you have one, `ros2` itself can listen in. Type this line into its terminal first. It sets
# the domain of this notebook.

# %% tags=["nbval-ignore-output"]
from workbook.ros import join_line

print(join_line())

# %%
domain = os.environ["ROS_DOMAIN_ID"]
print(
    "it names the domain of this notebook:", f"ROS_DOMAIN_ID={domain} " in join_line()
)

# %% [markdown]
# *Three: change one number.* In the section *Change it*, make a robot that waves twice a second and reports ten times a
# second. Say beforehand what you will see. At the end:

# %%
stop()

# %% [markdown]
# From the next lesson on, each lesson has an exercise. You write a program, and `%start` runs it beside the notebook.
# `%check` watches what it does on its topics. After some seconds it says what is right, and what to fix first.

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
# ✗ A simulator makes up a world. rclpy only connects programs. It does not know whether the robot is real.
#
# </details>
# <details><summary>c) A translator that turns Python into C++</summary>
#
# ✗ Your code stays Python and is run by Python. It calls a core that is compiled, as NumPy does.
#
# </details>
#
# **2. A program publishes on a topic, and no program subscribes. What happens?**
#
# <details><summary>a) It waits until a program does</summary>
#
# ✗ A publisher does not wait. In the picture of the graph, no program subscribed to the joint positions.
#
# </details>
# <details><summary>b) It publishes all the same, and the messages are gone</summary>
#
# ✓ Publishers and subscribers come and go on their own. (Lesson 13 shows how a late
# subscriber can still get the last message.)
#
# </details>
# <details><summary>c) It gets an error</summary>
#
# ✗ A publisher without subscribers is normal on a robot.
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
# <details><summary>c) The names: is the topic in the list, spelled exactly so, and with a publisher?</summary>
#
# ✓ `topic_list()` in a notebook or `workbook topic list` in a terminal answers that in a second.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Copy the prompt for an AI assistant, or discuss it with a colleague. State your own view first.
#
# ```text
# I program a robot with ROS 2 Jazzy in Python (rclpy). A team builds a humanoid. Should
# it be one large Python program, or ten nodes that talk over topics? What does each way
# make easier, and what harder? Which parts would you write in Python, and which not?
# Name only functions that exist in rclpy for Jazzy.
# ```
#
# <details><summary>What a good answer contains</summary>
#
# One program is easier to start and to step through, and its parts share memory. Nodes can be started, replaced and
# tested one by one, and when one crashes, the others go on. They can run on several computers, each written in the
# language that fits. Nodes have a price. Messages cost time and copies, several things happen at once, and there are
# more parts to look after. A node that goes silent must be noticed. Python suits perception, planning, learning and
# user interfaces. C++ (or a microcontroller) suits motor control, and what must be on time to the millisecond.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Two claims you may meet. Both are wrong: each was tried with the rclpy of this course.
#
# - **Start `roscore` first:** That is ROS 1. In ROS 2 no central program runs: nodes find each other by themselves.
# - **In one process, nodes share messages without copying (`use_intra_process_comms`):** C++ nodes can. rclpy has no
#   such option, and each subscriber gets its own copy.
#
# </details>

# %% [markdown]
# ## Take away
#
# - A robot is many programs. Each runs one or more nodes.
# - Nodes talk over topics: a name and a type. A node does not know which others publish or subscribe there.
# - A program that moves a robot has ten lines: init, node, publisher, timer, spin.
# - rclpy is the Python side of rcl. Below it, rmw and DDS carry the messages.
# - Predict, run, change. ■ stops a cell, `stop()` stops the robots, `workbook doctor` checks the machine.
#
# **Next:** [01 · The context](01_the_context.ipynb): what begins before the first node and ends after the last.
#
# **More:** [Nodes](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Nodes.html),
# [topics](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Topics.html) and
# [the layers of ROS 2](https://docs.ros.org/en/jazzy/Concepts/Advanced/About-Internal-Interfaces.html).

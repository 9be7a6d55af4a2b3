# %% [markdown]
# # 00 · Start here
#
# A robot's software consists of many small programs that constantly exchange messages. How do these programs find each
# other, and how do you write one?
#
# - **Minutes:** 45
# - **You need:** Python classes and functions, but no robot and no ROS knowledge
# - **You will be able to:**
#   - start a robot program and watch it
#   - write a short program that moves the robot
#   - explain what rclpy is and which layers lie below it
#   - get unstuck when something goes wrong
# - **Not covered:** starting and ending a program properly (the next lesson)

# %% [markdown]
# Click in the code cell below, and press **Shift+Enter**. That runs the cell and selects the next one.

# %%
from lesson_nodes import joint_position_publisher
from workbook.lesson import start, stop, watch_robot

print("started", start(joint_position_publisher))
await watch_robot(seconds=6, ease=0.1)

# %% [markdown]
# That wasn't a recording: you watched two programs at work. One of them computed the angles of the robot's twelve
# joints and sent them, twenty times a second. The other program, this notebook, received the angles and drew the robot.
# The robot is simulated, but the communication is real: both programs use **ROS 2**, the Robot Operating System, as
# they would on a real robot.
#
# [the same without helpers: start]

# %% [markdown]
# The programs communicate through a **topic**, a named stream of messages. Here, the topic is `/robot/joint_positions`,
# and each message holds twelve angles. First, stop the robot's program:

# %%
stop()

# %% [markdown]
# **Your own robot program, in 11 lines.** Now let your own program move the robot. Running the next cell saves its code
# as the file `my_wave.py`. That file is a complete program.

# %%
# %%writefile my_wave.py
import time

import rclpy
from std_msgs.msg import Float32MultiArray

rclpy.init()
node = rclpy.create_node("my_wave")
publisher = node.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)


def move() -> None:
    shoulder = 2.4 if time.time() % 2 < 1 else 0.3  # a second up, a second down
    publisher.publish(Float32MultiArray(data=[0.0, 0.0, shoulder] + [0.0] * 9))


node.create_timer(0.1, move)
rclpy.spin(node)

# %%
print("started", start("my_wave.py"))
await watch_robot(seconds=6, ease=0.4)
stop()

# %% [markdown]
# The robot raises and lowers its left arm because *your* program publishes its joint angles. `init` starts ROS, and
# `create_node` creates a *node*, the object through which the program communicates with other programs.
# `create_publisher` takes a message type and a topic. `move` fills a message with twelve angles in radians and
# publishes it. The timer calls `move` every 0.1 s, and `spin` keeps the node running.
#
# **Your turn.** In the list of angles, the third is for the left shoulder, and the fifth is for the right shoulder.
# Write a list of twelve angles: 2.4 rad for the right shoulder, and 0.0 for every other joint. (`[0.0] * 7` is a list
# of seven zeros.)

# %% id="your-pose"
from workbook.lesson import yours

pose = ...  # TODO: a list of twelve angles

yours(
    pose,
    [0.0, 0.0, 0.0, 0.0, 2.4] + [0.0] * 7,
    "Four zeros come before the right shoulder, and seven after it.",
)

# %% [markdown]
# Now put your list into the program above, but replace `2.4` with the variable `shoulder`, so that the arm moves. Then
# run two cells again: the one that saves the program and the one that starts it. The robot should now raise and lower
# its right arm. (Lessons 01 to 06 explain every line of the program.)

# %% [markdown]
# **How do these notebooks work?** Predict, run, change. Before you run a cell, predict the outcome. Then run it and
# compare, and finally change a number. You learn more from a wrong prediction than from a right one, because it reveals
# a gap in your understanding.
#
# **`await`.** You'll see this word before calls that take a while. It keeps the notebook responsive, so animations keep
# moving and the stop button works. When you copy such a call, keep the `await`. (Lesson 12 explains it.)
#
# This notebook is your own copy, so change anything you like.

# %% [markdown] prediction="end-of-the-program"
# ## Predict
#
# We start the robot again and watch it for six seconds. After three seconds, we stop its program but keep watching.
# What will you see?
#
# - **a** An error message: the connection was lost.
#   ✗ DDS does detect that the publisher is gone. But ROS doesn't treat that as an error, because a topic doesn't need a
#   publisher.
# - **b** The robot lowers its arms and returns to its rest pose.
#   ✗ No program sends the robot to its rest pose. The notebook keeps drawing the pose from the last message.
# - **c** The robot freezes in its last pose.
#   ✓ No more messages arrive, so the notebook keeps drawing the pose from the last one.
# - **d** The robot keeps waving: the notebook continues the movement.
#   ✗ The notebook doesn't compute the movement. It only draws the poses that it receives, and no new ones arrive.
#
# Click your choice, or press its letter. You can change it until you see the outcome. (If the options don't appear as
# buttons, run the cell below first.)

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
# There's no error. DDS, the layer that carries the messages, detected that the publisher was gone and removed it from
# its list of publishers. But ROS doesn't treat a missing publisher as an error, because a program's code refers only to
# a **topic**, not to another program. A topic has a name, here `/robot/joint_positions`, and a message type, here an
# array of numbers. A program can **publish** to a topic that has no subscribers, or **subscribe** to one that has no
# publishers.
#
# So one program on a robot can crash without bringing down the others. The price is that your node itself has to detect
# when a topic goes silent.
#
# ### Programs find each other by topic names
#
# Let's start three robot programs at the same time. Each runs in a separate process:

# %%
from lesson_nodes import humanoid_status_publisher, status_monitor
from workbook.lesson import graph_picture

for program in (humanoid_status_publisher, status_monitor, joint_position_publisher):
    print("started", start(program))

graph_picture()

# %% [markdown]
# Read the graph from left to right. `/humanoid_status_publisher` publishes to two topics, and `/status_monitor`
# subscribes to both. Right now, no program subscribes to the joint positions, but they're published anyway.
#
# None of the programs mentions another one by name. They found each other through their topics' names. Here are the
# next two messages on one of these topics:

# %%
from workbook.ros import topic_echo

for message in topic_echo("/robot/status", count=2).messages:
    print(message)
stop()

# %% [markdown]
# **Your turn.** On which topic does `/status_monitor` receive the battery level? Find the topic's name in the graph.

# %% id="your-topic"
battery_topic = ...  # TODO: the name of the topic, in quotes

yours(battery_topic, "/robot/battery", "A topic's name begins with a slash.")

# %% [markdown]
# ### rclpy, and the layers below it
#
# **What is rclpy?** It's the Python library for ROS 2. You write an ordinary Python class with a few methods, and rclpy
# turns it into a **node**. A node is a part of the robot's software that other programs can find and talk to. Those
# programs may run on another computer or be written in another language.
#
# **Why does it matter?** On a humanoid, camera drivers and motor controllers are mostly written in C++, because every
# millisecond counts in them. Perception, planning, and learning are mostly written in Python, because they build on
# NumPy, OpenCV, and PyTorch. Nodes connect the two worlds:
#
# - With a few lines of code, you can make a trained model part of the robot. The model receives images on one topic and
#   publishes its detections on another.
# - You can try an idea within minutes. Change a line and restart just that program while the rest of the robot keeps
#   running.
#
# But Python has its limits, and we'll measure one of them. A control loop that has to run a thousand times a second,
# and never a millisecond late, belongs in C++. Your Python node sends it commands.
#
# rclpy is built on several other layers:

# %%
from workbook.pictures.figures import show
from workbook.pictures.layers import DESCRIPTION, layers

show(layers(), DESCRIPTION)

# %% [markdown]
# `rcl` is short for *ROS client library*. Both rclpy and the C++ library `rclcpp` are built on it. So names and message
# types mean the same thing in both languages, and a node's language makes no difference to the other nodes.
#
# The process that runs this cell has loaded all of these layers, and Linux can list them:

# %%
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

# %% [markdown]
# To keep notebooks from receiving each other's messages, each open notebook gets its own **domain**, a number from 1 to
# 101. Lesson 01 shows how domains keep programs apart.

# %% [markdown] prediction="wave-faster"
# ## Change it
#
# The robot's program has two parameters that you can set when you start it:
#
# | parameter | meaning | usual value |
# |---|---|---|
# | `waves_per_second` | how many times per second the hand waves | 0.8 |
# | `period_s` | seconds between two messages | 0.05 |
#
# ### Experiment 1: a faster wave
#
# We set `waves_per_second=2.0`. What changes?
#
# - **a** The hand moves faster, but the number of messages per second stays the same.
#   when `messages_per_second < 25`
#   ✓ `waves_per_second` sets the speed of the hand. The program still publishes once every 0.05 s.
# - **b** The hand moves faster, and more messages arrive each second.
#   when `messages_per_second >= 25`
#   ✗ The hand does move faster. But `period_s` sets how often the program publishes, and we didn't change it.
# - **c** The hand moves as before, but more messages arrive each second.
#   ✗ `waves_per_second` sets only the speed of the hand. It doesn't change how often the program publishes.

# %%
predict("wave-faster")

# %%
from workbook.lesson import about
from workbook.ros import topic_hz

start(joint_position_publisher, waves_per_second=2.0)
await watch_robot(seconds=5, ease=0.1)

rate = topic_hz("/robot/joint_positions", seconds=3)
print("messages a second:", about(rate.mean_hz, between=(16, 22)))
reveal("wave-faster", messages_per_second=rate.mean_hz)

# %% [markdown] prediction="report-less-often"
# ### Experiment 2: fewer messages
#
# We go back to the usual wave, but with `period_s=0.5`. We also watch with `ease=0`. (`ease` is the time in seconds
# that the drawing takes to glide to a new pose.) What will you see?
#
# - **a** The hand waves slowly and smoothly.
#   ✗ The wave is as fast as before. And two messages a second can't make it look smooth.
# - **b** The hand waves as smoothly as before.
#   ✗ With `ease=0`, the drawing doesn't glide between poses. It shows each pose when its message arrives.
# - **c** The hand jumps: it waves as fast as before, but we see only two poses a second.
#   ✓ The robot moves as before, but it publishes only two poses a second. The drawing can't show any others.

# %%
predict("report-less-often")

# %%
start(joint_position_publisher, period_s=0.5)
await watch_robot(seconds=6, ease=0)
reveal("report-less-often")
stop()

# %% [markdown]
# The robot's speed and its reporting rate are different numbers. Beginners often confuse them.
#
# With `ease=0.5`, the drawing glides from one pose to the next. That looks fine, but the poses in between are made up.
# Try it with other numbers, too.
#
# Or drag a slider while the next cell runs: each change restarts the program with the new number.

# %%
from workbook.lesson import knob

await knob(
    joint_position_publisher, "waves_per_second", 0.8, between=(0.1, 3.0), seconds=8
)

# %% [markdown]
# ## When it goes wrong
#
# **An integer for a float parameter.** We set `waves_per_second` again, this time to `2`.

# %%
try:
    start(joint_position_publisher, waves_per_second=2)
except RuntimeError as error:
    print(str(error).splitlines()[-1])

# %% [markdown]
# The program ended right away, and the last line says why. (Read error messages from the bottom up.) `2` is an integer,
# but this parameter is a float, a number with a decimal point. So write `2.0`.
#
# A misspelled parameter is worse: the program silently accepts `wave_per_second=2.0`, but nothing changes.
#
# **A misspelled topic.** Names must match exactly, and a topic exists only while a program uses it.

# %% tags=["raises-exception"]
from workbook.ros import topic_info

start(joint_position_publisher)
topic_info("/robot/joint_postions")

# %% [markdown]
# The name is missing an `i`. Our tools suggest the name that you probably meant, but ROS doesn't. A subscriber to the
# misspelled topic would wait forever, without an error. Misspelled names are common, so if no messages arrive, check
# the names first.

# %%
stop()

# %% [markdown]
# ### When you're stuck
#
# | you see | do this |
# |---|---|
# | `[*]` stays next to a cell | the cell is still running. The **■** button above stops it, as Ctrl-C does in a terminal |
# | `NameError: name 'start' is not defined` | a cell above wasn't run, so choose *Run > Run All Above Selected Cell* |
# | one or more robots are still waving | `stop()` ends all programs that this notebook has started |
# | nothing makes sense anymore | the **⟳** button restarts the kernel. That ends the running programs and deletes variables, but your text stays |
# | not even the first cell works | run `workbook doctor` in a terminal: it reports what's wrong with the machine |
# | an exercise doesn't pass | `%check` names the first thing to fix; `%hint` gives up to three hints |

# %% [markdown]
# ## From a worked example to your own
#
# **Worked example.** Take another look at `my_wave.py` above.
#
# **Fill in the blanks.** Make the robot raise its *right* arm. Replace each `...` with your code, then run both cells.
# Until you do, the second cell prints a reminder.

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
# **Your own** (not graded). Three more steps, and you're ready for the course.
#
# *Step 1: check your machine.* The `doctor` function checks Python, the packages, and Jupyter, and sends messages
# between two processes. That takes a few seconds.

# %% tags=["nbval-ignore-output"]
from workbook.lesson import doctor

ready = doctor()

# %% [markdown]
# If the machine isn't ready, follow the instruction after the first `→`, and run the cell again. A line that begins
# with `!` is just a note.
#
# *Step 2: watch the same robot from a terminal.* Start the status publisher and leave it running:

# %%
print("running:", start(humanoid_status_publisher))

# %% [markdown]
# Open a terminal next to this notebook: *File > New > Terminal*. Type these commands there, one by one:
#
#     workbook node list
#     workbook topic list
#     workbook topic echo /robot/battery --count 3
#     workbook graph
#
# If several notebooks are open, `workbook` asks which one you mean. In a full ROS 2 installation, the counterpart of
# `workbook node list` is `ros2 node list`. To use `ros2`, first set this notebook's domain in your terminal. The next
# cell prints the command for that:

# %% tags=["nbval-ignore-output"]
from workbook.ros import join_line

print(join_line())

# %% [markdown]
# *Step 3: change two numbers.* Start a robot that waves twice a second and publishes ten messages a second. Predict
# what you'll see before you run the cell.

# %% id="your-numbers"
waves = ...  # TODO: waves_per_second
period = ...  # TODO: period_s

yours((waves, period), (2.0, 0.1), "Ten messages a second are 0.1 s apart.")
stop()
if ... not in (waves, period):
    start(joint_position_publisher, waves_per_second=waves, period_s=period)
    await watch_robot(seconds=6, ease=0)
    stop()

# %% [markdown]
# From the next lesson on, every lesson has an exercise. You write a program, and `%start` runs it alongside the
# notebook. `%check` watches the program's topics for a few seconds. Then it reports which parts are correct and what to
# fix first.

# %% [markdown]
# ## Check yourself
#
# **1. What is rclpy?**
#
# <details><summary>a) The Python library that turns a program into a ROS 2 node</summary>
#
# ✓ It makes nodes, topics, and timers available in Python, and passes the work on to `rcl`.
#
# </details>
# <details><summary>b) A robot simulator</summary>
#
# ✗ A simulator creates a virtual world. rclpy only connects programs, whether the robot is real or simulated.
#
# </details>
# <details><summary>c) A translator that turns Python into C++</summary>
#
# ✗ Your code stays Python, and Python runs it. Like NumPy, rclpy calls into a compiled core.
#
# </details>
#
# **2. A program publishes to a topic that has no subscribers. What happens?**
#
# <details><summary>a) It waits for a subscriber</summary>
#
# ✗ A publisher doesn't wait. In the graph above, the joint positions had no subscriber, but they were published anyway.
#
# </details>
# <details><summary>b) It publishes anyway, and the messages are lost</summary>
#
# ✓ Publishers and subscribers start and end independently of each other. (Lesson 13 shows how a late subscriber can
# still get the last message.)
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
# <details><summary>a) Nothing: they need a bridge between them</summary>
#
# ✗ They don't need a bridge, because both send the same bytes over the wire.
#
# </details>
# <details><summary>b) rclpy calls rclcpp</summary>
#
# ✗ Both are built on a third library, and neither needs the other.
#
# </details>
# <details><summary>c) Both are built on rcl, a C library</summary>
#
# ✓ So both follow the same rules for names and types, and nodes written with either library can talk to each other.
#
# </details>
#
# **4. Your node runs but receives no messages. What do you check first?**
#
# <details><summary>a) The Python version</summary>
#
# ✗ If your node runs, the Python version is fine.
#
# </details>
# <details><summary>b) The network cable</summary>
#
# ✗ In these lessons, all programs run on one computer. And wrong names are far more common than bad cables.
#
# </details>
# <details><summary>c) The names: is the topic listed, with exactly this spelling, and does it have a publisher?</summary>
#
# ✓ `topic_list()` in a notebook, or `workbook topic list` in a terminal, answers both questions within a second.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Write down your own answer first. Then copy the prompt into an AI assistant, or discuss it with a colleague.
#
# ```text
# I'm programming a robot with ROS 2 Jazzy in Python (rclpy). A team is building a
# humanoid. Should its software be one large Python program, or ten nodes that communicate
# over topics? What does each approach make easier, and what does it make harder? Which
# parts would you write in Python, and which in another language? Make sure that every
# rclpy function you use exists in Jazzy.
# ```
#
# <details><summary>What a good answer covers</summary>
#
# One program is easier to start and to debug step by step, and its parts share memory. Nodes can be started, replaced,
# and tested separately, and if one crashes, the others keep running. They can run on several computers, and each node
# can use the language that suits it. But nodes aren't free. Messages take time and have to be copied, several things
# happen at the same time, and there are more parts to maintain. And if a node goes silent, another program has to
# detect that. Python suits perception, planning, learning, and user interfaces. C++ (or a microcontroller) suits motor
# control and everything else that must never be a millisecond late.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Watch for these two mistakes. We checked both against this course's installation.
#
# - **Start `roscore` first:** That's ROS 1. ROS 2 has no central program: its nodes find each other on their own.
# - **In one process, nodes share messages without copying (`use_intra_process_comms`):** In C++, they can. rclpy has no
#   such option, so each subscriber gets a separate copy.
#
# </details>

# %% [markdown]
# ## Take away
#
# - A robot's software consists of many programs, each of which runs one or more nodes.
# - To move the robot, a program needs 11 lines: imports, init, node, publisher, callback, timer, and spin.
# - rclpy makes rcl available in Python. Two layers below rcl, rmw and DDS, carry the messages.
# - Predict, run, change. ■ stops a cell, `stop()` stops the robots, and `workbook doctor` checks the machine.
# - Nodes find each other through topics. A topic has a name and a type. A node's code refers only to topics, not to
#   other nodes.
#
# **Next:** [01 · The context](01_the_context.ipynb): starting ROS before the first node, and shutting it down after the
# last one.
#
# **More:** [Nodes](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Nodes.html),
# [topics](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Topics.html), and [the layers of ROS
# 2](https://docs.ros.org/en/jazzy/Concepts/Advanced/About-Internal-Interfaces.html)

# %% [markdown]
# # 02 · Nodes
#
# A robot is many small parts that must find each other, and they find each other by names.
#
# - **Minutes:** 50
# - **You need:** lesson [01](01_the_context.ipynb)
# - **You will be able to:**
#   - write a node class, and give it a name and a namespace
#   - run one class twice under two names
#   - say what happens when a name is used twice
#   - read error messages about names and attributes
# - **Left out:** what nodes say to each other (lessons 03 and 04), parameters, nodes in C++ packages and launch files

# %% [markdown]
# The program `roll_call` lists the nodes that it sees, five times a second. It runs as a process of its own. *This* notebook
# is another process. Let us make a node here, and print what the other one sees.

# %%
from lesson_nodes import roll_call
from lesson_nodes.roll_call import RollReader
from rclpy.node import Node
from workbook.lesson import fresh, init, run, start, stop

init()
start(roll_call)
reader = fresh(RollReader)  # listens to the roll call


async def until_seen(*names: str) -> None:
    """Wait until the other process sees exactly these nodes."""
    await run(reader, seconds=20, until=lambda: reader.latest() == sorted(names))


head = fresh(Node, "head")
await until_seen("/head")
print("the other process sees", reader.latest())

head.destroy_node()
await until_seen()
print("the other process sees", reader.latest())

# %% [markdown]
# One line made the node, `Node("head")`, and the other process found it. Here is the same as a timeline: a head comes, an
# arm comes, the head goes. Each mark is a roll call with that name in it.

# %%
import time

from workbook.pictures.figures import show
from workbook.pictures.timeline import strip

began = time.monotonic()
await run(reader, seconds=1.0)
head = fresh(Node, "head")
await until_seen("/head")
await run(reader, seconds=1.0)
arm = fresh(Node, "left_arm")
await until_seen("/head", "/left_arm")
await run(reader, seconds=1.0)
head.destroy_node()
await until_seen("/left_arm")
await run(reader, seconds=1.0)
arm.destroy_node()

film = {
    name: [moment - began for moment in reader.moments(name)]
    for name in ("/head", "/left_arm")
}
film = {
    name: [moment for moment in moments if moment > 0] for name, moments in film.items()
}
show(
    strip(film, end=time.monotonic() - began, noun="calls"),
    "the roll call of another process: the head is there in the middle, the arm a "
    "little later, then only the arm",
)

# %% [markdown] prediction="two-cameras"
# ## Predict
#
# A humanoid has two eyes. A student writes one class for both:
#
# ```python
# class Camera(Node):
#     def __init__(self) -> None:
#         super().__init__("camera")
#
# left = Camera()
# right = Camera()
# ```
#
# The name `"camera"` is taken when the second one is made. What happens?
#
# - **a** An error: a name can be used once.
#   ✗ ROS 2 has no central register of names, so no part of it can refuse one. (ROS 1 had such a register, the master.)
# - **b** The second one takes the place of the first.
#   when `named_camera == 1 and all_nodes == 1`
#   ✗ The two nodes do not know each other. Neither ends because another one has its name.
# - **c** Both are there, under the same name.
#   when `named_camera == 2`
#   ✓ Names are not checked for duplicates. Both nodes are on the graph, and both are called `/camera`.
# - **d** ROS numbers them: `camera` and `camera_2`.
#   when `named_camera == 1 and all_nodes > 1`
#   ✗ ROS never numbers nodes for you. A node has the name that it was given.

# %%
from workbook.lesson import predict, reveal

predict("two-cameras")

# %% [markdown]
# ## Run it


# %% tags=["nbval-ignore-output"]
class Camera(Node):
    """An eye of the robot."""

    def __init__(self) -> None:
        super().__init__("camera")


left = Camera()
right = Camera()
await run(reader, seconds=20, until=lambda: "/camera" in reader.latest())
await run(reader, seconds=2)  # and a little longer

# %%
from workbook.ros import node_list

print("the other process sees", reader.latest())
print(node_list())
reveal(
    "two-cameras",
    named_camera=node_list().count("/camera"),
    all_nodes=len(node_list()),
)
left.destroy_node()
right.destroy_node()

# %% [markdown]
# ## Look inside
#
# A **node** is an entry in the **graph**, the list of all nodes and their connections. No central register hands out names.
# Each process tells the others which nodes it has, and believes what the others tell. So two nodes may have one name. We
# call these **duplicate node names**, and they are a fault. When you ask `/camera` for something, both nodes do it, and
# you get the answer that comes first. There was no error above, only a warning.
#
# A node is not a process: this one process had two. And a class is not a node: you can make many nodes from one class.
#
# What does every node come with? This cell also lists what tools usually hide:

# %%
from workbook.ros import node_info

bare = fresh(Node, "bare")
found = node_info("/bare", hidden=True)
print("publishes:", *[name for name, _ in found.publishes])
print("offers", len(found.serves), "services, for example", found.serves[2][0])
bare.destroy_node()

# %% [markdown]
# `/rosout` publishes its log lines. `/parameter_events` and six of the seven services are for its **parameters**: values
# that can be set from outside, as you did with `start(..., period_s=0.5)`. `super().__init__(name)` makes all of this. So
# call it first in a class of your own.
#
# A node that does something adds a timer, a publisher, a subscription. This is a camera driver, such as a vendor might
# deliver. Look at its names. The messages are for the next lessons.

# %%
import inspect

from lesson_nodes.camera_driver import CameraDriver

for method in ("__init__", "take_picture", "report_faults"):
    print(inspect.getsource(getattr(CameraDriver, method)))

# %% [markdown] prediction="three-runs"
# ## Change it
#
# ### Experiment 1: a cell that is run three times
#
# In a notebook you run a cell, change a word, run it again. This cell makes a camera and gives it to an **executor**, which
# runs its callbacks (lesson 06). You press Shift+Enter three times. How many cameras are there?
#
# - **a** One: `camera` is overwritten each time, so the old one is gone.
#   when `cameras == 1`
#   ✗ The variable is overwritten, but the executor still has a reference to each node, and so each of them lives on.
# - **b** Three
#   when `cameras == 3`
#   ✓ Each run makes a new node. The executor keeps the old ones, so Python does not remove them.
# - **c** None: the second run raises an error, and the third, too.
#   ✗ A second node with the same name is no error. That is why it goes unnoticed.

# %%
predict("three-runs")

# %% id="three-runs" tags=["nbval-ignore-output"]
from rclpy.executors import SingleThreadedExecutor

the_cell = """
camera = CameraDriver()
executor.add_node(camera)
"""

executor = SingleThreadedExecutor()
for _ in range(3):
    exec(the_cell)  # as if you had pressed Shift+Enter
await run(reader, seconds=2)

# %% id="three-cameras"
from workbook.ros import topic_info, topic_list

print(node_list())
(pictures,) = [name for name in topic_list().names if "frame" in name]
print("publishers of pictures:", len(topic_info(pictures).publishers))
reveal("three-runs", cameras=node_list().count("/camera"))

# %% [markdown]
# The *name* `camera` was overwritten. The *object* lives as long as something holds it, and the executor holds all three.
# Each has a publisher on the one topic. When that executor spins, three times as many pictures come. The warning in the
# output above is the only sign. To remove the nodes, get hold of them again:

# %%
for camera in executor.get_nodes():
    executor.remove_node(camera)
    camera.destroy_node()
await until_seen()
print(node_list())

# %% [markdown]
# In these notebooks `fresh` does it for you: it destroys what an earlier run left under this name, then makes the new one.

# %%
the_cell = """
camera = fresh(CameraDriver)
executor.add_node(camera)
"""
for _ in range(3):
    exec(the_cell)

await until_seen("/camera")
print(node_list())
(only,) = executor.get_nodes()
only.destroy_node()

# %% [markdown] prediction="topic-names"
# ### Experiment 2: three ways to name a topic
#
# A humanoid with two arms has everything twice. So names are in folders, as files are. The folder of a node is its
# **namespace**. Here is a camera in the namespace `/robot/head`, with three names of topics:
#
# ```python
# camera = Node("camera", namespace="/robot/head")
# camera.create_publisher(String, "faults", 10)
# camera.create_publisher(String, "/emergency_stop", 10)
# camera.create_publisher(String, "~/frame", 10)
# ```
#
# What are the fully qualified names?
#
# - **a** `/robot/head/faults`, `/emergency_stop`, `/robot/head/camera/frame`
#   when `faults == '/robot/head/faults' and frame == '/robot/head/camera/frame'`
#   ✓ A relative name goes into the namespace, a name with a slash at the front stays, and `~` stands for the node
#   itself.
# - **b** `/faults`, `/emergency_stop`, `/frame`
#   when `faults == '/faults'`
#   ✗ A relative name, without a slash at the front, is put into the namespace of the node.
# - **c** `/robot/head/camera/faults`, `/robot/head/emergency_stop`, `/robot/head/frame`
#   ✗ The name of the node becomes a part of a topic only where you write `~`. And an absolute name is never moved.
# - **d** `/robot/head/faults`, `/robot/head/emergency_stop`, an error for `~`
#   ✗ An absolute name stays outside of the namespace. `~` is valid: it stands for the fully qualified name of the node.

# %%
predict("topic-names")

# %%
camera = fresh(Node, "camera", namespace="/robot/head")
for name in ("faults", "/emergency_stop", "~/frame"):
    print(f"{name:<16} is {camera.resolve_topic_name(name)}")
reveal(
    "topic-names",
    faults=camera.resolve_topic_name("faults"),
    frame=camera.resolve_topic_name("~/frame"),
)
print("its own fully qualified name:", camera.get_fully_qualified_name())
camera.destroy_node()

# %% [markdown]
# | you write | it is called | it becomes | take it for |
# |---|---|---|---|
# | `faults` | relative | namespace + name | what the parts of *this* robot share |
# | `/emergency_stop` | absolute | itself | what all robots share; rarely right |
# | `~/frame` | private | namespace + node + name | what belongs to *this* node alone |
#
# The slash at the front decides. With `/faults`, the faults of a second robot would arrive on the same topic. (The short
# examples of this course mostly use absolute names, so that you see the whole name. In a driver of your own, use relative
# and private names, as this one does.) Here are two robots, from one class, without a change in it:

# %%
from workbook.lesson import graph_picture

robots = [fresh(CameraDriver, namespace=robot_name) for robot_name in ("/ada", "/bob")]
stop(roll_call)
print(*topic_list().names, sep="\n")
graph_picture()

# %% [markdown] prediction="remapped-node"
# ### Experiment 3: another name from outside
#
# A robot has a camera in front and one in the back, both in *one* namespace. The driver has its name built in, and you may
# not edit it. But ROS can **remap** names when a node starts. In a terminal:
#
# ```text
# python -m lesson_nodes.camera_driver --ros-args -r __ns:=/robot -r __node:=rear_camera
# ```
#
# `-r` (remap) means: replace the left name by the right one. `__node` and `__ns` are the name and the namespace of the
# node itself. The driver publishes on `~/frame` and on `faults`. Where will its messages go?
#
# - **a** `/robot/rear_camera/frame` and `/robot/rear_camera/faults`
#   when `'/robot/rear_camera/faults' in names`
#   ✗ `faults` is relative: the namespace comes before it, the name of the node does not.
# - **b** `/robot/camera/frame` and `/robot/faults`: the node has another name, its topics do not
#   when `'/robot/camera/frame' in names`
#   ✗ Names are resolved after the remapping. `~` follows the new name of the node.
# - **c** `/robot/rear_camera/frame` and `/robot/faults`
#   when `'/robot/rear_camera/frame' in names and '/robot/faults' in names`
#   ✓ `~` stands for the node's name, which is the new one now. A relative name depends on the namespace only.

# %%
predict("remapped-node")

# %% id="remapped"
from workbook.lesson import run_program

DRIVE = """
import rclpy
from lesson_nodes.camera_driver import CameraDriver

rclpy.init()  # takes the arguments of the command line
camera = CameraDriver()
print(camera.get_fully_qualified_name())
print(camera.frame_publisher.topic_name)
print(camera.fault_publisher.topic_name)
rclpy.shutdown()
"""
arguments = ["--ros-args", "-r", "__ns:=/robot", "-r", "__node:=rear_camera"]
end = run_program(DRIVE, arguments=arguments)
for printed in end.log.splitlines():
    if printed.startswith("/"):
        print(printed)
reveal("remapped-node", names=end.log.split())

# %% [markdown]
# The driver does not change, and its private and relative names follow. So good drivers use relative and private names.
#
# What if both cameras live in one process? The arguments of the command line apply to *all* nodes of the process. Both
# would be called `rear_camera`: duplicate names again. There are two ways out. On the command line, name the node that you
# mean: `-r camera_a:__node:=rear_camera` renames only the node that the code calls `camera_a`. Both cameras are called
# `camera` in the code, so this program uses the other way, `cli_args`. It passes the same arguments as a list, to one
# node alone. (It works because this driver passes its `**settings` on to `Node`. Where a class does not, start one
# process for each camera.)

# %%
from workbook.ros import shutdown

front = fresh(CameraDriver, namespace="/robot")
rear = fresh(
    CameraDriver,
    namespace="/robot",
    cli_args=["--ros-args", "-r", "__node:=rear_camera"],
)
for camera in (front, rear):
    print(
        camera.get_fully_qualified_name(),
        "publishes on",
        camera.frame_publisher.topic_name,
    )
shutdown()  # destroys what `fresh` has made, and stops ROS
init()

# %% [markdown]
# ## When it goes wrong
#
# **The warning of duplicate node names.** rclpy says this of two nodes with one name:

# %% id="twin-warning"
SAME_NAME = """
import rclpy
from rclpy.node import Node

rclpy.init()
left, right = Node("camera"), Node("camera")
print(right.get_node_names())
rclpy.shutdown()
"""
for printed in run_program(SAME_NAME).log.strip().splitlines():
    print(printed.replace(". ", ".\n  "))

# %% [markdown]
# It speaks of logs, which is the smallest problem here. Read it as: *there are duplicate node names*. `workbook node list`
# (where ROS 2 is installed: `ros2 node list`) shows the name twice. Usual reasons are two terminals with the same
# program, a cell that was run twice, or a program that was not stopped.

# %% [markdown]
# **Invalid names.** Which of these can be the name of a node?

# %% id="bad-names"
from rclpy.exceptions import InvalidNamespaceException, InvalidNodeNameException

for name in (
    "left_camera",
    "left-camera",
    "left camera",
    "2nd_camera",
    "/robot/camera",
    "kamera_größe",
):
    try:
        Node(name, enable_rosout=False).destroy_node()
        print(f"✓ {name}")
    except InvalidNodeNameException as error:
        print(f"✗ {error}")

# %% [markdown]
# A name has only English letters, digits and underscores, and does not begin with a digit. The caret points at the
# fault. The fifth is the most common: the name of a node has no slash. The folder is a separate argument,
# `Node("camera", namespace="/robot")`. Namespaces have the same rules:

# %% id="bad-namespaces"
for namespace in ("/robot", "robot", "/robot/head", "/robot/"):
    try:
        camera = Node("camera", namespace=namespace, enable_rosout=False)
        print(f"✓ {namespace:<12} {camera.get_fully_qualified_name()}")
        camera.destroy_node()
    except InvalidNamespaceException as error:
        print(f"✗ {error}")

# %% [markdown]
# **The forgotten first line.** A class of your own, with a timer, and an error that does not help:


# %% id="no-super" tags=["raises-exception"]
class Blinker(Node):
    """Blinks with its eyes."""

    def __init__(self) -> None:
        self.create_timer(1.0, self.blink)

    def blink(self) -> None:
        print("blink")


Blinker()

# %% [markdown]
# `super().__init__("blinker")` would have made `_default_callback_group`. It must be the first line, before anything else
# of the node is used.

# %% [markdown]
# **Names that are taken.** A robot collects its timers in a list, under an unlucky name:


# %% id="reserved-attribute" tags=["raises-exception"]
class Collector(Node):
    """Keeps its timers in a list."""

    def __init__(self) -> None:
        super().__init__("collector")
        self.timers = [self.create_timer(1.0, self.look)]

    def look(self) -> None:
        print("looking")


Collector()

# %% [markdown]
# `Node` has a property of that name already, and Python says so. Names with an underscore are worse, because they are *not*
# protected. `Node` keeps its own things there. This class raises nothing, and its timer never ticks:


# %% id="silent-attribute"
class Quiet(Node):
    """Has a timer, and a variable with an unlucky name."""

    def __init__(self) -> None:
        super().__init__("quiet")
        self.ticks = 0
        self.create_timer(0.1, self.tick)
        self._timers = []  # a list of mine, thinks the author

    def tick(self) -> None:
        self.ticks += 1


quiet = fresh(Quiet)
await run(quiet, seconds=1.0)
print("ticks in a second:", quiet.ticks)

# %% [markdown]
# `self._timers` was the list in which the node kept its timer. With `_logger`, `_clock` and `_parameters` something breaks
# later, far from the cause. Names that say what they hold do not collide: `blink_timer`, `battery_publisher`.

# %% [markdown]
# **The logger is not Python's.** It looks like the module `logging`, but takes other arguments:

# %% id="logger-like-logging" tags=["raises-exception"]
logger = quiet.get_logger()
logger.info("battery at %d %%", 80)

# %% [markdown]
# It takes one text: `logger.info(f"battery at {80} %")`. And this helper function fails at its second call:


# %% id="logger-severity" tags=["raises-exception"]
def say(level: str, text: str) -> None:
    getattr(logger, level)(text)


say("info", "battery fine")
say("warning", "battery low")

# %% [markdown]
# For each *line of code*, rclpy remembers the severity with which it logs. That is how `once=True` can work. One line
# with two severities is an error. Write an `if`, with one line for each severity. The logger carries the name of the
# node with its namespace, and each line also goes to `/rosout`.

# %% [markdown]
# ## From a worked example to your own
#
# **Worked.** Two arms of one robot, `/robot/left/arm` and `/robot/right/arm`, from one class. The class has a plain
# name and a private topic. Each arm gets its place when its node is made.

# %%
from std_msgs.msg import String


class Arm(Node):
    """Says on a topic of its own how it is."""

    def __init__(self, **settings) -> None:
        super().__init__("arm", **settings)
        self.state_publisher = self.create_publisher(String, "~/state", 10)


arms = [fresh(Arm, namespace=f"/robot/{side}") for side in ("left", "right")]
for arm in arms:
    print(
        arm.get_fully_qualified_name(), "publishes on", arm.state_publisher.topic_name
    )

# %% [markdown]
# **Faded.** Now put both arms into the namespace `/robot`, as `/robot/left_arm` and `/robot/right_arm`. Do not change the
# class. Fill in what is `...`.

# %%
shutdown()
init()

REMAP = {
    "left": [...],  # TODO: the words that call this node left_arm
    "right": [...],  # TODO: and this one right_arm
}

if any(... in words for words in REMAP.values()):
    print("Fill in the words, then run this cell again.")
else:
    arms = [fresh(Arm, namespace="/robot", cli_args=words) for words in REMAP.values()]
    for arm in arms:
        print(
            arm.get_fully_qualified_name(),
            "publishes on",
            arm.state_publisher.topic_name,
        )
    print("as asked:", node_list() == ("/robot/left_arm", "/robot/right_arm"))

# %% [markdown]
# **Your own.** In the [exercise](../exercises/02_nodes.ipynb) a humanoid gets an eye in the back of its head, with a driver
# that you may not edit. It is judged by what others see on the graph.

# %% [markdown]
# ## Check yourself
#
# **1. You start the same program in two terminals by mistake. What do you get?**
#
# <details><summary>a) An error in the second terminal: the name is taken</summary>
#
# ✗ No register hands out names, so none can refuse one.
#
# </details>
# <details><summary>b) Two nodes with one name, and all that they publish comes twice</summary>
#
# ✓ And no error. `workbook node list` shows the name twice.
#
# </details>
# <details><summary>c) The first one ends, and the second one takes over</summary>
#
# ✗ They do not know each other. (`fresh` does that, but only inside one notebook.)
#
# </details>
#
# **2. A node `camera` in the namespace `/ada` publishes on `/faults`. What is the topic called?**
#
# <details><summary>a) <code>/ada/faults</code></summary>
#
# ✗ It would be, without the slash at the front.
#
# </details>
# <details><summary>b) <code>/ada/camera/faults</code></summary>
#
# ✗ That is what `~/faults` becomes.
#
# </details>
# <details><summary>c) <code>/faults</code></summary>
#
# ✓ An absolute name stays as it is, wherever the node lives. All robots meet there.
#
# </details>
#
# **3. `Node("robot/camera")` raises `InvalidNodeNameException`. How do you get `/robot/camera`?**
#
# <details><summary>a) <code>Node("camera", namespace="/robot")</code></summary>
#
# ✓ Name and namespace are two things, and only the namespace has slashes.
#
# </details>
# <details><summary>b) <code>Node("/robot/camera")</code></summary>
#
# ✗ The same error: the name of a node has no slash, not even at the front.
#
# </details>
# <details><summary>c) <code>Node("robot_camera")</code></summary>
#
# ✗ It is a valid name, but of another node: `/robot_camera`.
#
# </details>
#
# **4. A program makes two nodes from one class. You start it with `--ros-args -r __node:=scout`. What are they called?**
#
# <details><summary>a) Both <code>scout</code></summary>
#
# ✓ The arguments of the command line apply to all nodes of the process. Give `cli_args` to one of them instead.
#
# </details>
# <details><summary>b) The first one <code>scout</code>, the second one as before</summary>
#
# ✗ Nothing in these words says which one is meant.
#
# </details>
# <details><summary>c) <code>scout</code> and <code>scout_2</code></summary>
#
# ✗ ROS never numbers nodes.
#
# </details>
#
# **5. Your node has a timer. It raises nothing, and the timer never ticks. You have `self._timers = {}` in your class. Why?**
#
# <details><summary>a) A dictionary is not allowed there, it must be a list</summary>
#
# ✗ In this lesson it was a list, and the timer did not tick either, without any error.
#
# </details>
# <details><summary>b) The node is not spun</summary>
#
# ✗ That is always worth a check. But here the name alone stops the timer.
#
# </details>
# <details><summary>c) It has replaced the list in which the node keeps its timers</summary>
#
# ✓ Names with one underscore belong to the class that you inherit from. Choose another one.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Copy the prompt for an AI assistant, or discuss it with a colleague. State your own view first.
#
# ```text
# I program a robot with ROS 2 Jazzy in Python (rclpy). Our warehouse has twenty robots
# of one kind. Each runs the same fifteen nodes. How should nodes and topics be named,
# so that a robot can be added without editing code, and so that a dashboard can show
# all of them? Name only functions that exist in rclpy for Jazzy.
# ```
#
# <details><summary>What a good answer contains</summary>
#
# Each robot gets a namespace, such as `/robot_07`. It is given from outside when the nodes are started, by a launch
# file, a remapping or an environment variable. It is never in the code. Inside the namespace, nodes use relative names
# for what they share, and private names for what belongs to one node. Only what all robots share, such as a common stop
# or a map, gets an absolute name. The dashboard finds robots by asking the graph for namespaces or topics, and takes
# the namespace as the robot's name. A good answer also asks how many nodes may see each other. (Here, all 300 nodes
# of the twenty robots are in one domain. A domain per robot and a bridge may be better.) And it asks what happens
# when two robots get the same number by mistake. (They have duplicate node names, so check at the start.)
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Two claims you may meet. Both are wrong: each was tried with the rclpy of this course.
#
# - **ROS 2 refuses a second node with the same name:** It does not. Both run, and a log line warns about one publisher.
# - **Start it with `__ns:=/robot_07`:** That is ROS 1. rcl still takes it and warns that it is deprecated. In ROS 2:
#   `--ros-args -r __ns:=/robot_07`.
#
# </details>

# %% [markdown]
# ## Take away
#
# - A node is an entry in the graph. Names are not checked: duplicate node names are allowed, and they are a fault.
# - `super().__init__("name")` first. The name has no slash, hyphen or space; the folder is the namespace.
# - `faults` gets the namespace in front, `~/frame` gets namespace and node, and `/stop` stays as it is.
# - Remapping renames from outside: `--ros-args -r __node:=rear_camera` for a process, `cli_args` for one node.
# - Avoid the names that `Node` uses. The logger takes one text, and one severity per line of code.
#
# **Before:** [01 · The context](01_the_context.ipynb)
#
# **Next:** [03 · Publishers and messages](03_publishers_and_messages.ipynb)
#
# **More:** [Basic concepts](https://docs.ros.org/en/jazzy/Concepts/Basic.html), and [passing arguments to
# nodes](https://docs.ros.org/en/jazzy/How-To-Guides/Node-arguments.html).

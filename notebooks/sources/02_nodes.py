# %% [markdown]
# # 02 · Nodes
#
# A robot's software consists of many small parts, called nodes. They find each other by name. So how do you give every
# node, and every topic that it uses, the right name?
#
# - **Minutes:** 55
# - **You need:** lesson [01](01_the_context.ipynb)
# - **You will be able to:**
#   - write a node class, and give each of its instances a name and a namespace
#   - create two nodes with different names from one class
#   - say what happens when two nodes have the same name
#   - read error messages about names and attributes
# - **Not covered:** messages between nodes (lessons 03 and 04), parameters, launch files, and nodes in C++ packages

# %% [markdown]
# Five times a second, the program `roll_call` lists all the nodes that it can find. It runs in a separate process.
# Let's create a node in the notebook and print the other process's list.

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
# `fresh(Node, "head")` created the node by calling `Node("head")`, and the other process found it. Here are more roll
# calls, drawn as a timeline. The head appears, then the arm, and then the head disappears. Each row belongs to one
# node, and each mark is a roll call in which that node was present.
#
# [the same without helpers: init, start, fresh, run]

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
    strip(
        film,
        end=time.monotonic() - began,
        noun="calls",
        title="Another process sees each node while it exists",
    ),
    "the roll call of another process: the head is there in the middle, the arm a "
    "little later, then only the arm",
)

# %% [markdown] prediction="two-cameras"
# ## Predict
#
# A humanoid has two eyes, and a student writes one class for both:
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
# When the second node is created, the name `"camera"` is already in use. What happens?
#
# - **a** ROS raises an error, because a name can be used only once.
#   ✗ ROS 2 has no central registry of names, so nothing can reject a duplicate. (ROS 1 had such a registry, the
#   master.)
# - **b** The second node replaces the first one.
#   when `named_camera == 1 and all_nodes == 1`
#   ✗ The two nodes don't affect each other. A node doesn't end just because another node has the same name.
# - **c** Both nodes exist, under the same name.
#   when `named_camera == 2`
#   ✓ ROS doesn't check for duplicate node names. The graph contains both nodes, and both are called `/camera`.
# - **d** ROS numbers the nodes: `camera` and `camera_2`.
#   when `named_camera == 1 and all_nodes > 1`
#   ✗ ROS never numbers nodes. A node keeps the name that you give it.

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
# A **node** is a participant in the **graph**, the network of all nodes and their connections. No central registry
# assigns names. Each process announces its own nodes, and the other processes add these nodes to their lists without
# checking for duplicates. So two nodes can have the same name. But avoid such **duplicate node names**. If another
# program calls a service that `/camera` offers (lesson 12), both nodes handle the request, and the program gets
# whichever response arrives first. ROS doesn't treat duplicate names as an error, though: the cell above printed only a
# warning.
#
# A node isn't a process: this notebook's process contained two nodes. And a node isn't a class, because you can create
# many nodes from one class.
#
# Every node comes with some topics and services. The next cell lists them, including the ones that tools usually hide:

# %%
from workbook.ros import node_info

bare = fresh(Node, "bare")
found = node_info("/bare", hidden=True)
print("publishes:", *[name for name, _ in found.publishes])
print("offers", len(found.serves), "services, for example", found.serves[2][0])
bare.destroy_node()

# %% [markdown]
# The node publishes its log messages to `/rosout`. `/parameter_events` and six of the seven services are for the node's
# **parameters**. These are values that can be set from outside the program. For example, `start(..., period_s=0.5)`
# sets a program's parameter `period_s` to 0.5. `super().__init__(name)` creates all of these topics and services, so
# call it first in your own node class.
#
# To do something useful, a node adds timers, publishers, or subscriptions. Here's the kind of camera driver that a
# vendor might ship. For now, look only at the names of the node and its topics; later lessons explain the messages.

# %%
import inspect

from lesson_nodes.camera_driver import CameraDriver

for method in ("__init__", "take_picture", "report_faults"):
    print(inspect.getsource(getattr(CameraDriver, method)))

# %% [markdown] prediction="three-runs"
# ## Change it
#
# ### Experiment 1: running a cell three times
#
# In a notebook, you run a cell, change a word, and run it again. Suppose a cell creates a camera node and adds it to an
# **executor**, which runs the node's callbacks (lesson 06). You press Shift+Enter three times. How many camera nodes
# are there?
#
# - **a** One: `camera` is overwritten each time, so the old one is gone.
#   when `cameras == 1`
#   ✗ Only the variable is overwritten. The executor still has a reference to each node, so Python keeps all three.
# - **b** Three
#   when `cameras == 3`
#   ✓ Each run creates a new node. The executor keeps its references to the old ones, so Python doesn't delete them.
# - **c** One: the second and third runs raise an error, so they create no node.
#   ✗ ROS doesn't treat a duplicate node name as an error, so these runs create nodes, too.

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
print("image publishers:", len(topic_info(pictures).publishers))
reveal("three-runs", cameras=node_list().count("/camera"))

# %% [markdown]
# Each run reassigned the *variable* `camera`. But a Python *object* lives as long as something refers to it, and the
# executor refers to all three nodes. Each node has a publisher on the same topic, so if the executor spins, three times
# as many images are published. The only hint in the output is a warning about logs.
#
# To remove the nodes, get them from the executor:

# %%
for camera in executor.get_nodes():
    executor.remove_node(camera)
    camera.destroy_node()
await until_seen()
print(node_list())

# %% [markdown]
# In these notebooks, `fresh(SomeNode)` does this for you. It destroys the node that an earlier run created with
# `fresh`, and then creates a new one.
#
# **Your turn.** Here's the camera cell again, now as a function. Complete it so that only one camera is left after
# three calls.

# %% id="your-cell"
from workbook.lesson import yours


def the_cell() -> None:
    camera = ...  # TODO: create a CameraDriver that replaces the earlier one
    if camera is not ...:
        executor.add_node(camera)


for _ in range(3):
    the_cell()

cameras = [node.get_name() for node in executor.get_nodes()]
yours(cameras or ..., ["camera"], "fresh(CameraDriver)")
for camera in executor.get_nodes():
    executor.remove_node(camera)
    camera.destroy_node()

# %% [markdown] prediction="topic-names"
# ### Experiment 2: three ways to name a topic
#
# Most of a humanoid's parts come in pairs. To keep the parts' names distinct, ROS organizes names into folders, just as
# a file system organizes files. A node's folder is called its **namespace**. Here's a camera in the namespace
# `/robot/head`, with three topic names:
#
# ```python
# camera = Node("camera", namespace="/robot/head")
# camera.create_publisher(String, "faults", 10)
# camera.create_publisher(String, "/emergency_stop", 10)
# camera.create_publisher(String, "~/frame", 10)
# ```
#
# What are the fully qualified topic names?
#
# - **a** `/robot/head/faults`, `/emergency_stop`, `/robot/head/camera/frame`
#   when `faults == '/robot/head/faults' and frame == '/robot/head/camera/frame'`
#   ✓ A relative name gets the namespace as a prefix. A name with a leading slash stays as it is. `~` stands for the
#   node's fully qualified name.
# - **b** `/faults`, `/emergency_stop`, `/frame`
#   when `faults == '/faults'`
#   ✗ A name without a leading slash is relative, so ROS puts the node's namespace in front of it.
# - **c** `/robot/head/camera/faults`, `/robot/head/emergency_stop`, `/robot/head/frame`
#   ✗ ROS puts the node's name into a topic name only if you write `~`. And it never changes an absolute name.
# - **d** `/robot/head/faults`, `/robot/head/emergency_stop`, an error for `~`
#   ✗ `/emergency_stop` is absolute, so ROS doesn't add the namespace. `~` is valid: it stands for the node's fully
#   qualified name.

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
# | you write | kind of name | it becomes | use it for |
# |---|---|---|---|
# | `faults` | relative | namespace + name | topics that the parts of *this* robot share |
# | `/emergency_stop` | absolute | the same name | topics that all robots share (rarely the right choice) |
# | `~/frame` | private | namespace + node + name | topics that belong to *this* node alone |
#
# The leading slash makes the difference. With `/faults`, a second robot would report its faults on the same topic.
# (This course's short examples mostly use absolute names, so that you see each name in full. In your own drivers, use
# relative and private names, as `CameraDriver` does.)
#
# **Your turn.** Each of three cameras publishes its `temperature`. Write one topic name that gives each camera its own
# topic. The cell after yours then creates a `CameraDriver` node for each of two robots, without changing the class.

# %% id="your-topic-name"
topic_name = ...  # TODO: one name for all three, in quotes

topics = ...
if topic_name is not ...:
    eyes = [
        fresh(Node, "left_eye", namespace="/ada"),
        fresh(Node, "right_eye", namespace="/ada"),
        fresh(Node, "left_eye", namespace="/bob"),
    ]
    topics = [eye.resolve_topic_name(topic_name) for eye in eyes]
    for eye in eyes:
        eye.destroy_node()
yours(
    topics,
    [
        "/ada/left_eye/temperature",
        "/ada/right_eye/temperature",
        "/bob/left_eye/temperature",
    ],
    "A name that belongs to one node begins with ~/",
)

# %%
from workbook.lesson import graph_picture

robots = [fresh(CameraDriver, namespace=robot_name) for robot_name in ("/ada", "/bob")]
stop(roll_call)
print(*topic_list().names, sep="\n")
graph_picture()

# %% [markdown] prediction="remapped-node"
# ### Experiment 3: renaming a node from outside
#
# A robot has a front camera and a rear camera, both in *one* namespace. The node's name is hard-coded in the driver,
# which you aren't allowed to edit. But ROS can **remap** names when a node starts. In a terminal, you type:
#
# ```text
# python -m lesson_nodes.camera_driver --ros-args -r __ns:=/robot -r __node:=rear_camera
# ```
#
# `-r` (remap) replaces the name on the left of `:=` with the name on the right. `__node` and `__ns` stand for the
# node's own name and namespace. The driver publishes to `~/frame` and `faults`. What are the topics' fully qualified
# names now?
#
# - **a** `/robot/rear_camera/frame` and `/robot/rear_camera/faults`
#   when `'/robot/rear_camera/faults' in names`
#   ✗ `faults` is a relative name, so it gets only the namespace as a prefix, not the node's name.
# - **b** `/robot/camera/frame` and `/robot/faults`: the node is renamed, but its topics aren't
#   when `'/robot/camera/frame' in names`
#   ✗ ROS resolves topic names after it has renamed the node, so `~` stands for the new name.
# - **c** `/robot/rear_camera/frame` and `/robot/faults`
#   when `'/robot/rear_camera/frame' in names and '/robot/faults' in names`
#   ✓ `~` stands for the node's fully qualified name, which ends in `rear_camera` now. A relative name depends only on
#   the namespace.

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
# The driver's code didn't change, but its private and relative names changed along with the node's name and namespace.
# That's why good drivers use such names.
#
# What if both cameras run in one process? Command-line arguments apply to *all* nodes in the process. So both nodes
# would be called `rear_camera`: duplicate node names again. There are two solutions:
#
# - **On the command line, say which node you mean.** `-r camera_a:__node:=rear_camera` renames only the node that's
#   named `camera_a` in the code.
# - **In the code, use `cli_args`.** It passes the same arguments, as a list, to a single node.
#
# Here, the code gives both nodes the same name, so the next cell uses `cli_args`. That works because the driver passes
# `**settings` on to `Node`. If a class doesn't do that, start a separate process for each camera.

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
# **Duplicate node names.** If two nodes have the same name, rcl, the C library that rclpy is built on, logs this
# warning:

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
# The warning mentions only logs, but lost log messages are the least of your problems. The real problem is the
# duplicate node names. To find them, run `workbook node list` (or `ros2 node list`, if ROS 2 is installed): it shows
# the name twice. Common causes are a program that you started in two terminals, a cell that you ran twice, and a
# program that you didn't stop.
#
# **Invalid names.** Which of these names can you give to a node?

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
# A node name may contain only English letters, digits, and underscores, and it can't start with a digit. In the error
# message, a caret marks the invalid character. The fifth example is the most common mistake: a node name can't contain
# a slash. Pass the folder as a separate argument: `Node("camera", namespace="/robot")`. Namespaces have similar rules:

# %% id="bad-namespaces"
for namespace in ("/robot", "robot", "/robot/head", "/robot/"):
    try:
        camera = Node("camera", namespace=namespace, enable_rosout=False)
        print(f"✓ {namespace:<12} {camera.get_fully_qualified_name()}")
        camera.destroy_node()
    except InvalidNamespaceException as error:
        print(f"✗ {error}")

# %% [markdown]
# **Your turn.** Create the node with the fully qualified name `/robot/left_hand/camera_2`. Use `fresh`, so that you can
# run the cell again.

# %% id="your-node"
hand_camera = ...  # TODO: fresh(Node, ...)

full_name = ...
if hand_camera is not ...:
    full_name = hand_camera.get_fully_qualified_name()
    hand_camera.destroy_node()
yours(
    full_name,
    "/robot/left_hand/camera_2",
    "The part before the last slash is the namespace.",
)

# %% [markdown]
# **A missing `super().__init__`.** This class creates a timer without calling `super().__init__` first, but the error
# message doesn't say so:


# %% id="no-super" tags=["raises-exception"]
class Blinker(Node):
    """Blinks with its eyes."""

    def __init__(self) -> None:
        self.create_timer(1.0, self.blink)

    def blink(self) -> None:
        print("blink")


Blinker()

# %% [markdown]
# `super().__init__("blinker")` would have created `_default_callback_group`. Make that call the first line of your
# `__init__`, before you use any other part of the node.
#
# **Attributes that `Node` already uses.** This robot keeps its timers in a list, but the list's name is already taken:


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
# `Node` already has a property called `timers`, and Python reports the conflict. Some names that start with an
# underscore are worse: `Node` uses them for its internal data, but nothing protects them. The next class raises no
# exception, but its timer never fires:


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
# `self._timers` is the list in which `Node` stores its timers, and this class replaced it. If you overwrite `_logger`,
# `_clock`, or `_parameters`, the error appears later, far from its cause. Descriptive names such as `blink_timer` and
# `battery_publisher` don't clash with `Node`'s own.
#
# **rclpy's logger isn't Python's `logging`.** It looks similar, but its methods take different arguments:

# %% id="logger-like-logging" tags=["raises-exception"]
logger = quiet.get_logger()
logger.info("battery at %d %%", 80)

# %% [markdown]
# Pass a single string: `logger.info(f"battery at {80} %")`. The next helper function fails on its second call:


# %% id="logger-severity" tags=["raises-exception"]
def say(level: str, text: str) -> None:
    getattr(logger, level)(text)


say("info", "battery fine")
say("warning", "battery low")

# %% [markdown]
# rclpy keeps a record for each *line of code* that logs, because options such as `once=True` apply per line. The record
# includes the **severity**, such as `info`. If the line later logs at another severity, rclpy raises an error. So write
# an `if` statement with a separate line for each severity.
#
# The logger's name combines the node's namespace and name. By default, each log message is also published to
# `/rosout`.

# %% [markdown]
# ## From a worked example to your own
#
# **Worked example.** One robot has two arms, `/robot/left/arm` and `/robot/right/arm`, both from the same class. The
# class uses a plain node name and a private topic. Each node gets its namespace when it's created.

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
# **Fill in the blanks.** Now put both arms into the namespace `/robot`, as `/robot/left_arm` and `/robot/right_arm`,
# without changing the class. Replace each `...` with your code.

# %%
shutdown()
init()

REMAP = {
    "left": [...],  # TODO: the words that call this node left_arm
    "right": [...],  # TODO: and this one right_arm
}

topics = ...
if not any(... in words for words in REMAP.values()):
    arms = [fresh(Arm, namespace="/robot", cli_args=words) for words in REMAP.values()]
    topics = [arm.state_publisher.topic_name for arm in arms]
yours(
    topics,
    ["/robot/left_arm/state", "/robot/right_arm/state"],
    'The words are "--ros-args", "-r", and a rule such as "__node:=left_arm".',
)

# %% [markdown]
# **Your own.** In the [exercise](../exercises/02_nodes.ipynb), you give a humanoid an eye in the back of its head, but
# you aren't allowed to edit the eye's driver. The judge checks only the graph and the topics.

# %% [markdown]
# ## Check yourself
#
# **1. By mistake, you start the same program in two terminals. What happens?**
#
# <details><summary>a) The second terminal shows an error, because the name is taken</summary>
#
# ✗ There's no central registry, so nothing can reject a name.
#
# </details>
# <details><summary>b) There are two nodes with the same name, and every message is published twice</summary>
#
# ✓ There's no error. `workbook node list` shows the name twice.
#
# </details>
# <details><summary>c) The first program ends, and the second one takes over</summary>
#
# ✗ Neither program affects the other. (`fresh` does replace an earlier node, but only inside one notebook.)
#
# </details>
#
# **2. A node `camera` in the namespace `/ada` publishes to `/faults`. What is the topic's fully qualified name?**
#
# <details><summary>a) <code>/ada/faults</code></summary>
#
# ✗ That's the result for `faults`.
#
# </details>
# <details><summary>b) <code>/ada/camera/faults</code></summary>
#
# ✗ That's the result for `~/faults`.
#
# </details>
# <details><summary>c) <code>/faults</code></summary>
#
# ✓ An absolute name doesn't depend on the node's namespace. All robots share this topic.
#
# </details>
#
# **3. `Node("robot/camera")` raises `InvalidNodeNameException`. How do you get `/robot/camera`?**
#
# <details><summary>a) <code>Node("camera", namespace="/robot")</code></summary>
#
# ✓ Name and namespace are separate arguments, and only the namespace may contain slashes.
#
# </details>
# <details><summary>b) <code>Node("/robot/camera")</code></summary>
#
# ✗ That raises the same exception. A node name can't contain a slash, not even as its first character.
#
# </details>
# <details><summary>c) <code>Node("robot_camera")</code></summary>
#
# ✗ That name is valid, but it creates a different node: `/robot_camera`.
#
# </details>
#
# **4. A program creates two nodes from one class. You pass it `--ros-args -r __node:=scout`. What are the nodes called?**
#
# <details><summary>a) Both are called <code>scout</code></summary>
#
# ✓ Command-line arguments apply to all nodes in the process. To rename one node, pass it `cli_args` instead.
#
# </details>
# <details><summary>b) The first is called <code>scout</code>, and the second keeps its name</summary>
#
# ✗ The rule doesn't say which node it's for, so it applies to both.
#
# </details>
# <details><summary>c) <code>scout</code> and <code>scout_2</code></summary>
#
# ✗ ROS never numbers nodes.
#
# </details>
#
# **5. Your class contains `self._timers = {}`. Its timer never fires, and there's no exception. Why?**
#
# <details><summary>a) <code>_timers</code> must be a list, not a dictionary</summary>
#
# ✗ In this lesson, `_timers` was a list, and the timer still never fired.
#
# </details>
# <details><summary>b) The node isn't spinning</summary>
#
# ✗ That's always worth checking. But here, the timer wouldn't fire even if the node were spinning.
#
# </details>
# <details><summary>c) The dictionary replaced the list in which the node keeps its timers</summary>
#
# ✓ Names with a leading underscore belong to the base class. Choose another name.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Write down your own answer first. Then copy the prompt into an AI assistant, or discuss it with a colleague.
#
# ```text
# I'm programming robots with ROS 2 Jazzy in Python (rclpy). Our warehouse has twenty
# robots of the same model, and each runs the same fifteen nodes. How should we name the
# nodes and topics, so that we can add a robot without editing code, and so that one
# dashboard can show all of them? Make sure that every rclpy function you use exists in
# Jazzy.
# ```
#
# <details><summary>What a good answer covers</summary>
#
# Each robot gets a namespace, such as `/robot_07`. A launch file, a remapping rule, or an environment variable sets it
# when the nodes start, so it never appears in the code. Inside the namespace, nodes use relative names for shared
# topics and private names for topics that belong to a single node. Only topics that all robots share, such as a shared
# emergency stop or a map, get absolute names. The dashboard queries the graph for namespaces or topics, and uses each
# namespace as the robot's name.
#
# A good answer also asks how many nodes should share a domain. (If all twenty robots share one domain, it contains 300
# nodes. One domain per robot, plus a bridge, may be better.) It also asks what happens if two robots get the same
# number by mistake. (Their nodes would have duplicate names, so check for that at startup.)
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Watch for these two mistakes. We checked both with the rclpy version that this course uses.
#
# - **ROS 2 rejects a second node with the same name:** It doesn't. Both nodes run, and all you get is a warning that
#   their log messages share one publisher.
# - **Start each program with `__ns:=/robot_07`:** That's ROS 1 syntax. rcl still accepts it, with a warning that it's
#   deprecated. In ROS 2, write `--ros-args -r __ns:=/robot_07`.
#
# </details>

# %% [markdown]
# ## Take away
#
# - A node is a participant in the graph. ROS doesn't check for duplicate node names, so avoid them.
# - Avoid attribute names that `Node` uses. A logger method takes a single string, and each line that logs must always
#   use the same severity.
# - Call `super().__init__("name")` first. The name can't contain a slash, hyphen, or space; pass the folder as
#   `namespace`.
# - `faults` gets the namespace as a prefix, `~/frame` gets the namespace and the node's name, and `/stop` stays the
#   same.
# - To rename a node from outside, remap it: `--ros-args -r __node:=rear_camera` for a whole process, or `cli_args` for
#   a single node.
#
# **Before:** [01 · The context](01_the_context.ipynb)
#
# **Next:** [03 · Publishers and messages](03_publishers_and_messages.ipynb)
#
# **More:** [Basic concepts](https://docs.ros.org/en/jazzy/Concepts/Basic.html) and [passing arguments to
# nodes](https://docs.ros.org/en/jazzy/How-To-Guides/Node-arguments.html)

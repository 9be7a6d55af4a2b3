# %% [markdown]
# # 07 · Typed nodes
#
# A robot meets your spelling mistake at night, on a slope, in the one branch that nobody tried; a type checker meets it
# while you type.
#
# - **Minutes:** 55
# - **You need:** lessons [00](00_start_here.ipynb) to 06, and to have seen a hint such as `level: float` before
# - **You will be able to:** annotate a node, let mypy read it, say what mypy can and cannot see in ROS code, and make
#   wrong messages an error before the robot runs
# - **Left out:** typing of services and actions, other type checkers, and how to type rclpy itself

# %% [markdown]
# Here is a node with a mistake. It does not run in this cell. A program called **mypy** reads it, as you would read the
# letter of a friend before it is sent.

# %%
from workbook.lesson import check_types

check_types('''
from rclpy.node import Node
from std_msgs.msg import Float32


class Battery(Node):
    def __init__(self) -> None:
        super().__init__("battery")
        self.level_publisher = self.create_publisher(Float32, "/robot/battery", 10)
        self.create_timer(2.0, self.send)

    def send(self) -> None:
        self.level_publisher.publsh(Float32(data=99.5))
''')

# %% [markdown]
# No robot, no two seconds until the timer ticks for the first time, and the word that you meant comes with it. Mend the
# word and run the cell again.
#
# mypy knows what `create_publisher` returns, because rclpy says so with a **type hint**, and it follows these hints
# through your program. Such a program is called a **type checker**. In a terminal it is `mypy my_node.py`.

# %% [markdown]
# ## Predict
#
# The next node has seven mistakes. Each has a number.

# %%
VITALS = '''\
from rclpy.node import Node
from std_msgs.msg import Float32, String


class Vitals(Node):
    def __init__(self) -> None:
        super().__init__("vitals")
        self.battery = self.create_publisher(Float32, "/robot/battery", 10)
        self.create_timer("2 s", self.report)  # 1 a text for a period
        self.create_timer(self.report, 2.0)  # 2 two arguments swapped
        self.create_subscription(Float32, "/robot/tilt", self.on_word, 10)  # 3 a callback for another message

    def report(self) -> None:
        level = Float32()
        level.data = "full"  # 4 a text in a float field
        self.battery.publsh(level)  # 5 a method misspelled
        self.battery.publish(String())  # 6 a message of another type

    def on_word(self, word: String) -> None:
        print(word.dta)  # 7 a field misspelled
'''

# %% [markdown] prediction="seven-mistakes"
# All functions have hints. mypy is asked to be strict. rclpy and the messages are as ROS installs them. How many of the
# seven does it find?
#
# - **a** Three: those where rclpy itself is used wrongly.
#   when `mistakes_found == 3`
#   ✓ rclpy has hints, so mypy finds 1, 2 and 5. The other four depend on what the messages are, and that it does not
#   know.
# - **b** All of them. That is what hints are for.
#   when `mistakes_found == 7`
#   ✗ mypy can check only what it knows. The message packages bring no types that it may use, so it accepts all that
#   you do with a message.
# - **c** The two misspelled names, 5 and 7. The rest shows only when it runs.
#   when `mistakes_found == 2`
#   ✗ 5 is a method of rclpy, and mypy finds it. 7 is a field of a message, and of messages mypy knows nothing.
# - **d** None. Python does not look at hints.
#   when `mistakes_found == 0`
#   ✗ Python does not look at hints while a program runs. mypy does, and it reads the hints of rclpy as well.

# %%
from workbook.lesson import predict, reveal

predict("seven-mistakes")

# %% [markdown]
# ## Run it
#
# `stubs=False` means: as ROS installs it. What that leaves out comes later.

# %%
as_installed = check_types(VITALS, stubs=False)
as_installed

# %% [markdown]
# And what would have happened without mypy? Let us make the same seven mistakes on the real graph, one after the other,
# in a program of their own. It is stock ROS, without the field checks that these notebooks switch on.

# %%
from workbook.lesson import run_program

SEVEN_TIMES = '''
import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, String

rclpy.init()
node = Node("vitals")
battery = node.create_publisher(Float32, "/robot/battery", 10)
heard = []


def on_word(word: String) -> None:
    heard.append(word)


def listen_for_the_wrong_type():
    node.create_subscription(Float32, "/robot/battery", on_word, 10)
    battery.publish(Float32(data=98.0))
    return wait_for("a String was expected, and this came: ")


def put_a_text_into_a_float():
    level = Float32()
    level.data = "full"
    battery.publish(level)
    return wait_for("published and received: ")


def wait_for(words):
    heard.clear()
    end = time.monotonic() + 5
    while not heard and time.monotonic() < end:
        rclpy.spin_once(node, timeout_sec=0.1)
    return words + str(heard[0])


for number, mistake in enumerate((
    lambda: node.create_timer("2 s", print),
    lambda: node.create_timer(print, 2.0),
    listen_for_the_wrong_type,
    put_a_text_into_a_float,
    lambda: battery.publsh(Float32()),
    lambda: battery.publish(String()),
    lambda: String().dta,
), start=1):
    try:
        print(number, mistake())
    except Exception as error:
        print(number, type(error).__name__ + ":", error)
rclpy.shutdown()
'''
CHECKED = "import os\nos.environ['ROS_PYTHON_CHECK_FIELDS'] = '1'\n" + SEVEN_TIMES

stock = run_program(SEVEN_TIMES, seconds=30)
print(stock.log)

# %%
MISTAKES = {
    number: line
    for line, text in enumerate(VITALS.splitlines(), start=1)
    for number in range(1, 8)
    if f"  # {number} " in text
}


def found(report):
    """The numbers of the mistakes that mypy found."""
    return {number for number, line in MISTAKES.items() if line in report.lines}


print("found by mypy, as ROS is installed:", sorted(found(as_installed)))
reveal("seven-mistakes", mistakes_found=len(found(as_installed)))

# %% [markdown]
# ## Look inside
#
# Three of seven. Look again at what the other run says. Mistakes 5, 6 and 7 raise an error only *when the line is
# reached*: perhaps at the first tick, perhaps on the day the battery runs low. Mistakes 3 and 4 never raise anything.
# The word that was no number arrives as `0.0`, and a callback that is written for a `String` gets a `Float32`. A hint
# changes nothing when a program runs.
#
# Why does mypy see so little of the messages? Ask it. `reveal_type(x)` is a question to mypy, not to Python.

# %%
QUESTIONS = '''\
from rclpy.node import Node
from std_msgs.msg import Float32

node = Node("asked")
battery = node.create_publisher(Float32, "/robot/battery", 10)
reveal_type(battery)
reveal_type(Float32())
reveal_type(Float32().dta)
'''
check_types(QUESTIONS, stubs=False, notes=True)

# %% [markdown]
# The publisher is a `Publisher`. The message is **Any**. `Any` is the type of which nothing is known: every value may
# be one, and it may have every attribute. Where `Any` stands, mypy is blind, and it says nothing.
#
# A package tells mypy that its hints may be trusted by a file named `py.typed`. rclpy has one. The message packages
# are made by a generator, which writes neither hints nor this file.

# %%
from pathlib import Path

import rclpy
import std_msgs

for package in (rclpy, std_msgs):
    print(package.__name__, "has py.typed:", (Path(package.__file__).parent / "py.typed").exists())

# %% [markdown]
# ### The second net: stubs
#
# Hints need not stand in the code that they are about. A **stub** is a file with the ending `.pyi` that says how a
# module looks from outside. This course brings stubs for the message packages, made from the message classes
# themselves. Here is the one for `Float32`:

# %%
from std_msgs.msg import Float32

from workbook.lesson import stub_of

print(stub_of(Float32))

# %%
with_stubs = check_types(VITALS)
with_stubs

# %%
print("found with stubs:", sorted(found(with_stubs)))
print("new among them:  ", sorted(found(with_stubs) - found(as_installed)))

# %% [markdown]
# Now mypy knows the fields. It finds the text in the float field, and even says which field you meant by `dta`.
#
# In your own projects, copy the folder `workbook/typings` and call `mypy --config-file typings/mypy.ini my_node.py`.
# Newer ROS distributions bring such hints along.

# %% [markdown]
# ### The third net: a publisher that knows its message
#
# Mistake 6 is still there: `publish(String())` on a publisher for `Float32`. In this rclpy every publisher has the same
# type, `Publisher`, whatever it publishes. So we say ourselves what we need: *something that has a method `publish` for
# one type of message*. Such a description is a **Protocol**. Nobody has to inherit from it; it is enough to fit.

# %%
TYPED = '''\
from typing import Protocol, TypeVar

from rclpy.node import Node

Message = TypeVar("Message")
Taken = TypeVar("Taken", contravariant=True)


class Sends(Protocol[Taken]):
    """Whatever publishes messages of one type, and of no other."""

    def publish(self, msg: Taken) -> None: ...


def make_publisher(node: Node, kind: type[Message], topic: str) -> Sends[Message]:
    """A publisher that knows which messages it takes: those of `kind`."""
    return node.create_publisher(kind, topic, 10)


'''
with_typed_publisher = check_types(
    TYPED + VITALS.replace("self.create_publisher(Float32, ", "make_publisher(self, Float32, ").replace('battery", 10)', 'battery")')
)
MORE_LINES = len(TYPED.splitlines())
found_now = {number for number, line in MISTAKES.items() if line + MORE_LINES in with_typed_publisher.lines}
print("found with stubs and a typed publisher:", sorted(found_now))
print(*(finding.message for finding in with_typed_publisher.findings if "publish" in finding.message), sep="\n")

# %% [markdown]
# Read `make_publisher` slowly. `Message` stands for some type, and it is the same one in both places: for
# `kind=Float32` the result is a `Sends[Float32]`. `contravariant=True` says that `Taken` only goes in, as an argument;
# mypy asks you for the word if you forget it. From Python 3.12 on one writes `class Sends[Taken](Protocol)` and
# `def make_publisher[Message]`, and the two lines with `TypeVar` can go.
#
# All of it together. Each mistake was really made in this notebook; a full dot says that it was found, or ended in an
# error, there:

# %%
checked = run_program(CHECKED, seconds=30)


def raised(run):
    """The numbers of the mistakes that ended in an error when they were made."""
    return {int(line[0]) for line in run.log.splitlines() if "Error: " in line}


nets = {
    "mypy": found(as_installed),
    "mypy and\nstubs": found(with_stubs),
    "and a typed\npublisher": found_now,
    "stock ROS,\nat run time": raised(stock),
    "field checks,\nat run time": raised(checked),
}

# %%
from workbook.pictures.figures import figure, show

NAMES = {
    1: "a text for a period", 2: "two arguments swapped", 3: "a callback for another message",
    4: "a text in a float field", 5: "a method misspelled", 6: "a message of another type", 7: "a field misspelled",
}  # fmt: skip
FOUND, RAISES, MISSED = "#208a3c", "#b06a00", "#dc3b3b"
fig, axes = figure(7.6, 3.6)
for column, (net, caught) in enumerate(nets.items()):
    words = ("raises", "silent") if "run time" in net else ("found", "missed")
    for number in NAMES:
        if number in caught:
            axes.plot(column, number, "o", markersize=14, color=RAISES if "raises" in words else FOUND)
        else:
            axes.plot(column, number, "o", markersize=14, color=MISSED, fillstyle="none")
        axes.text(column + 0.16, number, words[number not in caught], va="center", fontsize=8)
axes.axvline(2.62, color="#787878", linestyle="--", linewidth=1)
axes.text(1.1, 0.25, "before anything runs", ha="center", fontsize=9)
axes.text(3.6, 0.25, "once the line is reached", ha="center", fontsize=9)
axes.set_yticks(list(NAMES), [f"{number}  {name}" for number, name in NAMES.items()])
axes.set_xticks(range(len(nets)), list(nets))
axes.set(ylim=(7.6, -0.1), xlim=(-0.4, len(nets) - 0.4))
axes.tick_params(length=0)
axes.grid(False)
show(fig, "seven mistakes and five nets: which net catches which mistake")

# %%
for name, caught in nets.items():
    print(f"{len(caught)} of 7  {' '.join(name.split())}")

# %% [markdown]
# No net catches all. The two on the right hang lower: they catch you only once you fall, but they catch what no hint can
# know. Mistake 3 is still free. You will catch it yourself, further down.

# %% [markdown]
# ## Change it
#
# ### Experiment 1: three shapes of one node
#
# One can write a node in three ways. A **script** has everything at the top of the file. A **closure** is a function
# whose inner functions remember its names. A **class** remembers in `self`. Here are three modules, with one battery
# each. Run them for a minute of robot time.

# %%
from lesson_nodes import battery_class, battery_closure, battery_script
from workbook.lesson import arrivals, record

SHAPES = {"script": battery_script, "closure": battery_closure, "class": battery_class}
for name, module in SHAPES.items():
    recording = record(module, {"/robot/battery": 2.0}, seconds=60)
    lines = len(Path(module.__file__).read_text().splitlines())
    print(f"{name:8} {lines} lines of text, {len(arrivals(recording, '/robot/battery'))} messages in a minute")

# %% [markdown] prediction="three-shapes"
# On the bus nobody can tell them apart. For mypy they differ. We plant the same mistake in each, `create_timer("2 s",
# ...)`, and take out all hints of the form `-> None`. mypy runs as it is, not strict. In how many of the three does it
# find the mistake?
#
# - **a** in all three: the call is wrong in each
#   when `script > 0 and closure > 0 and in_class > 0`
#   ✗ The call is wrong in each. But mypy does not look into functions without hints, and two of the three calls are
#   in one.
# - **b** in the class and the closure, because there is more structure
#   when `script == 0 and closure > 0 and in_class > 0`
#   ✗ It is the other way round: there, the call is inside a function without hints, and mypy skips it.
# - **c** in none: there are no hints any more
#   when `script == 0 and closure == 0 and in_class == 0`
#   ✗ Hints of your own are gone, but those of rclpy are still there. Code outside of functions is checked against
#   them.
# - **d** only in the script
#   when `script > 0 and closure == 0 and in_class == 0`
#   ✓ In the script the call stands outside of any function, and mypy always reads that. It skips functions without
#   hints.

# %%
predict("three-shapes")

# %%
def spoiled(module, hints):
    """The text of a module with a wrong period, with or without its hints."""
    text = Path(module.__file__).read_text().replace("create_timer(PERIOD_S,", 'create_timer("2 s",')
    return text if hints else text.replace(" -> None", "")


without_hints = {}
for name, module in SHAPES.items():
    without_hints[name] = without = len(check_types(spoiled(module, hints=False), stubs=False, strict=False))
    with_hints = len(check_types(spoiled(module, hints=True), stubs=False, strict=False))
    print(f"{name:8} mistakes found without '-> None': {without}, with it: {with_hints}")
reveal(
    "three-shapes",
    script=without_hints["script"],
    closure=without_hints["closure"],
    in_class=without_hints["class"],
)

# %% [markdown]
# mypy does not look into a function without hints. It supposes that you do not want it to, yet. Code at the top of a
# file belongs to no function, so it is always read. Two small words, `-> None`, switch the light on. And `--strict`
# complains of every function that has none:

# %%
strict = check_types(spoiled(battery_class, hints=False), stubs=False)
for line in strict.lines:
    print(line, sorted({finding.code for finding in strict.findings if finding.line == line}))

# %% [markdown]
# Which shape is best? A script is fine for ten lines. A closure cannot be looked into from outside, so it is hard to
# test. In a class everything has a name and a type, and a second robot is a second object. That is why the nodes of
# this course, and most that you will meet, are classes.

# %% [markdown] prediction="a-whole-number"
# ### Experiment 2: a whole number
#
# The battery is full. Somebody writes `Float32(data=100)`. mypy reads it with stubs, and then the line runs in stock
# ROS. What happens?
#
# - **a** mypy objects: 100 is an int, and the field is a float.
#   when `complaints > 0`
#   ✗ In Python's type system an int is welcome wherever a float is. mypy keeps to that.
# - **b** mypy says nothing, and 0.0 arrives.
#   when `complaints == 0 and arrived == '0.0'`
#   ✓ mypy lets an int pass for a float, and without field checks nobody else looks. This build sends 0.0, another one
#   can abort.
# - **c** mypy says nothing, and 100.0 arrives.
#   when `complaints == 0 and arrived == '100.0'`
#   ✗ mypy is content, but the C code below the message is not: it expects a Python float, and gets an int.

# %%
predict("a-whole-number")

# %% id="whole-number"
LEVEL = '''\
import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32


def send(level: float) -> None:
    publisher.publish(Float32(data={value}))


def hear(message: Float32) -> None:
    heard.append(message.data)


heard: list[float] = []
rclpy.init()
node = Node("battery")
publisher = node.create_publisher(Float32, "/robot/battery", 10)
node.create_subscription(Float32, "/robot/battery", hear, 10)
send({given})
end = time.monotonic() + 5
while not heard and time.monotonic() < end:
    rclpy.spin_once(node, timeout_sec=0.1)
print("arrived:", heard[0])
rclpy.shutdown()
'''

whole = LEVEL.format(value="level", given="100")
report, end = check_types(whole), run_program(whole, seconds=20)
print(report)
print(end.log)
reveal("a-whole-number", complaints=len(report), arrived=end.log.split()[-1])

# %% [markdown]
# For mypy an int is a float: wherever a `float` is asked for, it lets an `int` pass, because Python can count with both.
# The message cannot. Its code in C takes the eight bytes that stand where a Python float keeps its value (lesson 03), and
# in an int that is something else. So convert at the border, where values enter the message:

# %%
print("float(level):    ", run_program(LEVEL.format(value="float(level)", given="100"), seconds=20).log.strip())
with_checks = "import os\nos.environ['ROS_PYTHON_CHECK_FIELDS'] = '1'\n" + whole
print("and field checks:", run_program(with_checks, seconds=20).log.strip().splitlines()[-1])

# %% [markdown] prediction="one-of-two-words"
# ### Experiment 3: one of two words
#
# A status is `operational` or `error`. For `word: str` every text is fine. `Literal["operational", "error"]` is the type
# of these two words alone. Somebody calls `send_status("operatoinal")`. We check and run both versions.
#
# - **a** `str`: nobody objects. `Literal`: mypy objects, and at run time there is an error.
#   ✗ mypy objects, but at run time there is no error. Python keeps hints and does not check them.
# - **b** mypy finds the misspelled word in both: it is no English word.
#   ✗ mypy knows no English. For the hint `str`, every text is right.
# - **c** `str`: nobody objects. `Literal`: mypy objects, and at run time the word is sent all the same.
#   ✓ `Literal` is for mypy, and there the word does not fit. When the program runs, Python does not compare it with
#   the hint.

# %%
predict("one-of-two-words")

# %%
WORDS = '''\
from typing import Literal


def send_status(word: {hint}) -> None:
    print("sent:", word)


send_status("operatoinal")
'''
for hint in ("str", 'Literal["operational", "error"]'):
    program = WORDS.format(hint=hint).replace("from typing import Literal\n" if hint == "str" else "\0", "")
    print(hint)
    print(check_types(program))
    print(run_program(program, seconds=20).log)
reveal("one-of-two-words")

# %% [markdown]
# The narrower the type, the more mistakes have no room in it. `str` is wide, `object` and `Any` are the whole ocean.
# And once more: at run time the word is sent. Hints are a promise between people. Python does not enforce it.

# %% [markdown]
# ## When it goes wrong
#
# **Hints from newer books.** In newer ROS a publisher is generic, and one reads `Publisher[String]` everywhere. Here:

# %% id="publisher-subscript" tags=["raises-exception"]
from rclpy.publisher import Publisher
from std_msgs.msg import String

StatusPublisher = Publisher[String]

# %% [markdown]
# `Publisher` of this rclpy takes no type in brackets. A class attribute `pub: Publisher[String]` ends in the same error
# (up to Python 3.13; from 3.14 on Python looks at hints only when somebody asks for them). In quotes it would run, but
# mypy knows better:

# %%
print(check_types('from rclpy.publisher import Publisher\nfrom std_msgs.msg import String\n\npub: "Publisher[String]"\n'))

# %% [markdown]
# Plain `Publisher` is right, and says little. `Sends[String]` from above says what is meant.
#
# **A name that is taken.** What could be wrong with this?

# %% id="name-taken" tags=["raises-exception"]
from rclpy.node import Node

from workbook.lesson import fresh, init

init()


class Reporter(Node):
    """Has more than one publisher."""

    def __init__(self) -> None:
        super().__init__("reporter")
        self.publishers = [self.create_publisher(String, "/robot/status", 10)]


fresh(Reporter)

# %% [markdown]
# `Node` has a property `publishers` already, the list of all publishers of the node, and it cannot be set. The same
# holds for `subscriptions`, `timers`, `clients`, `services`, `context` and `handle`. mypy knows it without running
# anything:

# %%
check_types('''
from rclpy.node import Node
from std_msgs.msg import String


class Reporter(Node):
    def __init__(self) -> None:
        super().__init__("reporter")
        self.publishers = [self.create_publisher(String, "/robot/status", 10)]
''')

# %% [markdown]
# **The silence.** This function is annotated, and mypy is content with it. But the value comes from outside, from a
# file that somebody edited by hand. mypy has never seen that file.

# %% id="hints-are-no-guards"
OUTSIDE = LEVEL.replace("import time\n", "import json\nimport time\n")
careless = OUTSIDE.format(value="level", given="json.loads('\"full\"')")
print(check_types(careless))
print(run_program(careless, seconds=20).log)

# %% [markdown]
# The dashboard shows 0 %, nobody knows why, and no error is anywhere. Values that come from outside need a guard that
# works at run time: ask, and raise an error with words that help.

# %%
GUARD = '''\
    if not isinstance(level, (int, float)):
        raise TypeError(f"a charge is a number of percent, not {level!r}")
    publisher.publish('''
guarded = careless.replace("    publisher.publish(", GUARD).replace("data=level", "data=float(level)")
print(check_types(guarded))
print(run_program(guarded, seconds=20).log.strip().splitlines()[-1])

# %% [markdown]
# Why not `float(level)` alone? It makes 87.5 of the text `"87.5"`. That looks friendly, until the next text says
# `"87 %"`. (This guard lets `True` and `nan` pass, and refuses NumPy's `float32`. Exercise 03 went further.)
#
# **Silence, made by hand.** `# type: ignore` at the end of a line makes mypy quiet about it, and `Any` makes it quiet
# about everything that a value touches. Sometimes one needs that, with a reason beside it. It never mends anything.

# %% [markdown]
# ## From a worked example to your own
#
# **Worked.** A charging station: one typed publisher, one word out of three, and a guard at the border. It runs here, on
# the graph.

# %%
from typing import Literal, Protocol, TypeVar, get_args

from rclpy.node import Node
from std_msgs.msg import Float32, String

Message = TypeVar("Message")
Taken = TypeVar("Taken", contravariant=True)
Plug = Literal["free", "charging", "broken"]


class Sends(Protocol[Taken]):
    """Whatever publishes messages of one type, and of no other."""

    def publish(self, msg: Taken) -> None: ...


def make_publisher(node: Node, kind: type[Message], topic: str) -> Sends[Message]:
    """A publisher that knows which messages it takes: those of `kind`."""
    return node.create_publisher(kind, topic, 10)


class ChargingStation(Node):
    """Says how its plug is."""

    def __init__(self) -> None:
        super().__init__("charging_station")
        self.plug_publisher = make_publisher(self, String, "/station/plug")

    def send_plug(self, plug: Plug) -> None:
        """Say how the plug is. Raises ValueError for a word that is not agreed."""
        if plug not in get_args(Plug):
            raise ValueError(f"a plug is one of {get_args(Plug)}, not {plug!r}")
        self.plug_publisher.publish(String(data=plug))


station = fresh(ChargingStation)
station.send_plug("charging")
for misuse in (lambda: station.send_plug("chraging"), lambda: station.plug_publisher.publish(Float32())):
    try:
        misuse()
    except Exception as error:
        print(f"{type(error).__name__}: {error}")

# %% [markdown]
# The second error came from rclpy: `publish` looks at the class of what it is given. It does not look into its fields.

# %% [markdown]
# **Faded.** Mistake 3 is still free: a subscription for one message with a callback for another. Do for subscriptions
# what `make_publisher` does for publishers. Two hints are missing. When they are right, mypy objects to the last line,
# and to no other. `Callable[[X], None]` is a function that takes an `X` and returns nothing.

# %%
LISTEN = '''\
from collections.abc import Callable
from typing import TypeVar

from rclpy.node import Node
from std_msgs.msg import Float32, String

Message = TypeVar("Message")


def listen(node: Node, kind: ___, topic: str, callback: ___) -> None:
    node.create_subscription(kind, topic, callback, 10)


def on_tilt(message: Float32) -> None:
    print(message.data)


def on_word(message: String) -> None:
    print(message.data)


robot = Node("listener")
listen(robot, Float32, "/robot/tilt", on_tilt)
listen(robot, String, "/robot/status", on_word)
listen(robot, Float32, "/robot/tilt", on_word)
'''
if "___" in LISTEN:
    print("Fill in the two ___, then run this cell again.")
else:
    print(check_types(LISTEN))

# %% [markdown]
# **Your own.** In the [exercise](../exercises/07_typed_nodes.ipynb) two other teams will call your node. Make it one
# that cannot be misused without a loud word.

# %% [markdown]
# ## Check yourself
#
# **1. mypy has nothing against `Float32().dta`, with ROS as it is installed. Why?**
#
# <details><summary>a) The package has no hints that mypy may trust, so the message is Any</summary>
#
# ✓ Neither stubs nor `py.typed`. And `Any` has every attribute that you can think of.
#
# </details>
# <details><summary>b) A field is looked up at run time, so no tool can know it</summary>
#
# ✗ It can, as soon as somebody tells it the fields. The stubs of this course do.
#
# </details>
# <details><summary>c) mypy checks only code that has been run once</summary>
#
# ✗ mypy never runs your code. It reads it.
#
# </details>
#
# **2. `def on_tick(self): self.create_timer("2 s", self.send)`. What does plain mypy say of it?**
#
# <details><summary>a) That a text is no period</summary>
#
# ✗ It would, with `-> None`. Or with `--strict`, which reads all functions.
#
# </details>
# <details><summary>b) That `send` is unknown</summary>
#
# ✗ It does not even read the line.
#
# </details>
# <details><summary>c) Nothing: it does not look into a function without hints</summary>
#
# ✓ You saw it with the closure and the class. `-> None` is enough to change that.
#
# </details>
#
# **3. `def send(self, level: float) -> None`, and the program calls `send("full")`. Nobody runs mypy. What happens?**
#
# <details><summary>a) Python raises a TypeError at the call</summary>
#
# ✗ Python keeps the hint, and never compares it with what is passed.
#
# </details>
# <details><summary>b) The text goes as far as it gets, here into the message, and 0.0 is sent</summary>
#
# ✓ In stock ROS, yes. A guard of your own, or field checks, would have stopped it.
#
# </details>
# <details><summary>c) Python converts it to a float, because the hint says so</summary>
#
# ✗ Hints convert nothing. `float("full")` would raise a ValueError, by the way.
#
# </details>
#
# **4. What makes an object a `Sends[Float32]`?**
#
# <details><summary>a) It has a method publish that takes a Float32</summary>
#
# ✓ A Protocol describes. Whatever fits the description will do, also a small class that you write for a test.
#
# </details>
# <details><summary>b) Its class inherits from Sends</summary>
#
# ✗ That would do, but no publisher of rclpy does so, and they fit all the same.
#
# </details>
# <details><summary>c) make_publisher marks it at run time</summary>
#
# ✗ `make_publisher` returns what `create_publisher` gave it, unchanged. The type is for mypy alone.
#
# </details>
#
# **5. mypy, strict and with stubs, finds nothing in your node. Which of these can still go wrong?**
#
# <details><summary>a) A field of a message is misspelled</summary>
#
# ✗ With stubs mypy knows the fields.
#
# </details>
# <details><summary>b) `create_timer` gets its two arguments swapped</summary>
#
# ✗ rclpy's own functions have hints, and mypy knew this one even without stubs.
#
# </details>
# <details><summary>c) The battery topic says 0.0, because an int was put into a float field</summary>
#
# ✓ mypy lets an int pass for a float. `float(level)` at the border, and a test that looks at what arrives, catch it.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Discuss this with a colleague or an AI assistant:
#
# > We have thirty nodes, written over three years, without a single hint. Somebody wants mypy --strict in our automatic
# > checks from Monday on. What would you do first, what would you leave for later, and what will mypy never find for us?
#
# <details><summary>What a good answer contains</summary>
#
# Not everything on Monday: `--strict` on thirty nodes gives hundreds of findings, and people then silence them with
# `# type: ignore`. A way that works: stubs for the messages first, because without them most of ROS is `Any`. Then
# plain mypy on all, so that nothing gets worse; then `-> None` and argument hints, node by node, beginning where others
# call in; strict settings for a node once it is clean. New code is strict from the first day. What mypy does not find:
# values from outside (parameters, files, other nodes), an int in a float field, topic names that do not match, periods
# that are wrong but are numbers, and everything about time. That needs guards at run time, field checks in tests, and
# tests that look at what arrives. A good answer also asks who will look after the stubs when messages change.
#
# </details>

# %% [markdown]
# ## Take away
#
# - mypy reads a program and follows its hints. It finds mistakes in lines that have never run.
# - It does not look into functions without hints. `-> None` switches the light on, `--strict` demands it everywhere.
# - ROS messages are `Any` to mypy until stubs tell it their fields.
# - A Protocol such as `Sends[Float32]` gives a publisher a type, and makes a wrong message an error.
# - Hints do nothing at run time. What comes from outside needs a guard, and an int needs `float(...)`.
#
# **Before:** [06 · Spinning](06_spinning.ipynb)
#
# **Next:** [08 · The humanoid status publisher](08_humanoid_status_publisher.ipynb), a node with two timers that earns
# its living.
#
# **More:** [rclpy](https://docs.ros.org/en/jazzy/p/rclpy), with all types that it tells mypy about, and
# [the documentation of mypy](https://mypy.readthedocs.io/), which begins gently.

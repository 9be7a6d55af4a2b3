# %% [markdown]
# # 07 · Typed nodes
#
# A typo in a robot's program can stay hidden until the worst moment. A type checker finds it before the program runs.
# But how many of the mistakes in your ROS code does it find?
#
# - **Minutes:** 50
# - **You need:** lessons [00](00_start_here.ipynb) to 06, and some familiarity with type hints such as `level: float`
# - **You will be able to:**
#   - annotate a node, and check it with mypy
#   - predict which mistakes in ROS code mypy finds
#   - check your messages before the robot runs
# - **Not covered:** type hints for services and actions, other type checkers, and how to add type hints to rclpy itself
#
# This robot publishes a heartbeat. When its battery drops below half, it should publish a warning, too.

# %%
# %%writefile tired_robot.py
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class TiredRobot(Node):
    def __init__(self) -> None:
        super().__init__("tired_robot")
        self.level = 100.0
        self.heart = self.create_publisher(String, "/robot/heartbeat", 10)
        self.create_timer(0.25, self.beat)

    def beat(self) -> None:
        self.level -= 5.0
        if self.level < 50.0:
            self.heart.publsh(String(data="battery low"))
        self.heart.publish(String(data="beat"))


rclpy.init()
rclpy.spin(TiredRobot())

# %% [markdown]
# The next cell records the robot for five seconds. In the animation, the robot moves with each heartbeat.

# %%
from workbook.lesson import arrivals, record
from workbook.pictures.moving import Robot, robots

BEAT = "/robot/heartbeat"
tired = record("tired_robot.py", {BEAT: 0.25}, seconds=5, clock="wall")
print("\n".join(tired.process.log.strip().splitlines()[-2:]))
robots(
    [
        Robot(
            "the tired robot",
            arrivals(tired, BEAT),
            period=0.25,
            trouble="its program ended",
        )
    ],
    "a robot moves for two and a half seconds, and then stands still with a red lamp",
    end=5.0,
)

# %% [markdown]
# The typo is in a line that runs only when the battery is low, so a test on a charged robot never finds it. A program
# called **mypy** does find it, because mypy reads the whole file without running it.
#
# [the same without helpers: record]

# %%
from pathlib import Path

from workbook.lesson import check_types

check_types(Path("tired_robot.py"))

# %% [markdown]
# mypy reports the line, and it even suggests the method that you meant. It knows the return type of `create_publisher`
# from a **type hint** in rclpy, and it follows such hints through your program. A program that does this is called a
# **type checker**. To check the file in a terminal, run `mypy tired_robot.py`.

# %% [markdown]
# ## Predict
#
# The next node contains seven mistakes, each with a number in a comment.

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
        self.create_subscription(
            Float32, "/robot/tilt", self.on_word, 10  # 3 a callback for another message
        )

    def report(self) -> None:
        level = Float32()
        level.data = "full"  # 4 a text in a float field
        self.battery.publsh(level)  # 5 a method misspelled
        self.battery.publish(String())  # 6 a message of another type

    def on_word(self, word: String) -> None:
        print(word.dta)  # 7 a field misspelled
'''

# %% [markdown] prediction="seven-mistakes"
# All functions have type hints, and we run `mypy --strict`. rclpy and the message packages are unmodified, just as ROS
# installs them. How many of the seven numbered mistakes does mypy find?
#
# - **a** Three: the ones that misuse rclpy itself.
#   when `mistakes_found == 3`
#   ✓ rclpy has hints, so mypy finds 1, 2, and 5. The other four mistakes depend on the messages, and mypy has no types
#   for those.
# - **b** All of them, because finding mistakes is the purpose of hints.
#   when `mistakes_found == 7`
#   ✗ mypy can check only code for which it has types. The message packages have none, so mypy accepts any use of a
#   message.
# - **c** Two: the misspelled names, 5 and 7. You find the others only by running the program.
#   when `mistakes_found == 2`
#   ✗ mypy finds 5, because rclpy's methods have hints. But 7 is a message field, and mypy has no types for messages.
# - **d** None, because Python ignores hints.
#   when `mistakes_found == 0`
#   ✗ Python ignores hints while a program runs. But mypy checks them, including rclpy's.

# %%
from workbook.lesson import predict, reveal

predict("seven-mistakes")

# %% [markdown]
# ## Run it
#
# With `stubs=False`, mypy uses only what ROS installs, without the extra hints that you'll meet below.

# %%
as_installed = check_types(VITALS, stubs=False)
as_installed

# %% [markdown]
# The next program makes the same seven mistakes, one after another. It runs without *field checks* (lesson 03), which
# these notebooks normally turn on. You don't need to study its code.

# %%
# %%writefile seven_times.py
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

# %%
from workbook.lesson import run_program

FIELD_CHECKS = "import os\nos.environ['ROS_PYTHON_CHECK_FIELDS'] = '1'\n"
seven_times = Path("seven_times.py").read_text()
unchecked = run_program(seven_times, seconds=30)
print(unchecked.log)

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
# mypy finds three of the seven mistakes. At run time, mistakes 5, 6, and 7 each raise an error, but only *when the
# program reaches that line*. That may be at the first tick, or months later, when the battery runs low. In this
# course's ROS build, mistakes 3 and 4 don't raise an error. With mistake 3, a callback for a `String` receives a
# `Float32`. With mistake 4, the string arrives as `0.0`.
#
# **On a robot, mistake 4 may crash the program.** The message code in the Ubuntu packages may be compiled with
# assertions. In that case, the wrong value aborts the whole process, and `except` can't catch the abort ([rclpy
# #1437](https://github.com/ros2/rclpy/issues/1437)).
#
# Why does mypy find so few mistakes in the messages? Its report gives the reason: `Skipping analyzing "std_msgs.msg"`,
# with the code `import-untyped`. So which type does mypy assign to a message? To find out, use `reveal_type(x)`, which
# makes mypy print the type of `x`. The call is meant only for mypy.

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
# The publisher's type is `Publisher`. The message's type is **Any**, which means that mypy knows nothing about the
# message and accepts anything you do with it.
#
# Type checkers use the hints inside a package only if the package contains a file named `py.typed`. rclpy contains one.
# But the generated message packages have neither hints nor this file. Don't silence `import-untyped`: it's the only
# sign that mypy isn't checking your messages.
#
# ### The second net: stubs
#
# Think of each check as a **net**: a mistake that slips through one net may be caught by the next. Plain mypy was the
# first net.
#
# A **stub** is a `.pyi` file with hints for a module whose own code has none. This course has stubs for the message
# packages, generated from the message classes. Here's the stub for `Float32`:

# %%
from std_msgs.msg import Float32

from workbook.lesson import stub_of

print(stub_of(Float32), end="\n\n")

with_stubs = check_types(VITALS)
print("found with stubs:", sorted(found(with_stubs)))
print("new among them:  ", sorted(found(with_stubs) - found(as_installed)))
with_stubs

# %% [markdown]
# Now mypy knows the fields, so the `import-untyped` error is gone. mypy finds the string in the float field, and for
# `dta`, it suggests the correct field.
#
# To use the stubs in your own project, copy `workbook/typings` into it, and run `mypy --config-file typings/mypy.ini
# my_node.py`.
#
# ### The third net: a publisher with a message type
#
# mypy still misses mistake 6: `publish(String())` on a `Float32` publisher. In this rclpy version, all publishers have
# the same type, `Publisher`. So we describe the object that we need: *one with a `publish` method that takes a
# `Float32`*. Such a description is called a `Protocol`, and every object with that method matches it:

# %%
SENDS_FLOATS = '''\
from typing import Protocol

from rclpy.node import Node
from std_msgs.msg import Float32, String


class SendsFloats(Protocol):
    def publish(self, msg: Float32) -> None: ...

'''
typed = SENDS_FLOATS + VITALS.partition("String\n")[2].replace(
    "self.battery = ", "self.battery: SendsFloats = "
)
with_typed_publisher = check_types(typed)
for finding in with_typed_publisher.findings:
    if "publish" in finding.message:
        print(finding.message)

# %% [markdown]
# One annotation on the attribute is enough. To cover *all* message types with one description, see the optional
# notebook linked at the end.
#
# The next cell compares five nets: mypy at each of the three steps above, and the program itself, without and with
# field checks.

# %%
more_lines = len(typed.splitlines()) - len(VITALS.splitlines())
found_now = {
    number
    for number, line in MISTAKES.items()
    if line + more_lines in with_typed_publisher.lines
}
checked = run_program(FIELD_CHECKS + seven_times, seconds=30)


def raised(run):
    """The numbers of the mistakes that ended in an error when they were made."""
    return {int(line[0]) for line in run.log.splitlines() if "Error: " in line}


nets = {
    "mypy": found(as_installed),
    "mypy and\nstubs": found(with_stubs),
    "and a typed\npublisher": found_now,
    "this build,\nat run time": raised(unchecked),
    "field checks,\nat run time": raised(checked),
}

from workbook.lesson.type_reports import nets_picture

NAMES = {
    1: "a text for a period",
    2: "two arguments swapped",
    3: "a callback for another message",
    4: "a text in a float field",
    5: "a method misspelled",
    6: "a message of another type",
    7: "a field misspelled",
}
for name, caught in nets.items():
    print(f"{len(caught)} of 7  {' '.join(name.split())}")
nets_picture(
    nets,
    NAMES,
    "seven mistakes and five nets: which net catches which mistake",
    title="No net finds all seven mistakes",
)

# %% [markdown]
# The two nets on the right catch a mistake only when its line runs. None of the five catches mistake 3, but later,
# you'll write a check that does.

# %% [markdown]
# ## Change it
#
# ### Experiment 1: three ways to structure a node
#
# You can structure a node's code in three ways. A **script** has all of its code at the top level of the file. A
# **closure** puts all of the code into one outer function, whose variables the inner functions use. A **class** stores
# its state in `self`. Here are three modules that publish a battery's level, one for each structure. Let's run each for
# a minute of simulated time.

# %%
from lesson_nodes import battery_class, battery_closure, battery_script

SHAPES = {"script": battery_script, "closure": battery_closure, "class": battery_class}
for name, module in SHAPES.items():
    recording = record(module, {"/robot/battery": 2.0}, seconds=60)
    lines = len(Path(module.__file__).read_text().splitlines())
    messages = len(arrivals(recording, "/robot/battery"))
    print(f"{name:8} {lines} lines of text, {messages} messages in a minute")

# %% [markdown] prediction="three-shapes"
# The three programs publish the same messages. But does mypy treat them the same way? We put the mistake
# `create_timer("2 s", ...)` into each program, remove all `-> None` hints, and run mypy without `--strict`. In which
# programs does mypy find the mistake?
#
# - **a** In all three: the call is wrong in each of them.
#   when `script > 0 and closure > 0 and in_class > 0`
#   ✗ The call is indeed wrong in each of them. But mypy doesn't check functions without hints, and two of the three
#   calls are inside such a function.
# - **b** In the class and the closure: their code has more structure.
#   when `script == 0 and closure > 0 and in_class > 0`
#   ✗ It's the other way around. In the class and the closure, the call is inside a function without hints, so mypy
#   skips it.
# - **c** In none: the hints are gone.
#   when `script == 0 and closure == 0 and in_class == 0`
#   ✗ Your own hints are gone, but rclpy still has its hints. mypy checks any code outside functions against them.
# - **d** Only in the script.
#   when `script > 0 and closure == 0 and in_class == 0`
#   ✓ In the script, the call isn't inside a function, so mypy checks it. mypy skips functions without hints.

# %%
predict("three-shapes")

# %%
def spoiled(module, hints):
    """The text of a module with a wrong period, with or without its hints."""
    text = Path(module.__file__).read_text()
    text = text.replace("create_timer(PERIOD_S,", 'create_timer("2 s",')
    return text if hints else text.replace(" -> None", "")


without_hints = {}
for name, module in SHAPES.items():
    without = len(check_types(spoiled(module, hints=False), strict=False))
    without_hints[name] = without
    hinted = len(check_types(spoiled(module, hints=True), strict=False))
    print(f"{name:8} mistakes found without '-> None': {without}, with it: {hinted}")
reveal(
    "three-shapes",
    script=without_hints["script"],
    closure=without_hints["closure"],
    in_class=without_hints["class"],
)

# %% [markdown]
# **Your turn.** In the closure, the wrong call is in a function that begins with `def main():`. Write that line with a
# hint so that mypy checks the function.

# %% id="your-hint"
from workbook.lesson import yours

line = ...  # TODO: def main(): with a hint, as text

if line is not ...:
    closure = spoiled(battery_closure, hints=False)
    report = check_types(closure.replace("def main():", line), strict=False)
yours(... if line is ... else len(report), 1, '"def main() -> None:"')

# %% [markdown]
# By default, mypy doesn't check functions without hints. With the option `--check-untyped-defs` or `--strict`, mypy
# checks them, too. One hint, such as `-> None`, is enough for mypy to check the function. Code at the top level of a
# file isn't in a function, so mypy always checks it.
#
# Which structure is best? A script is fine for ten lines. A closure is hard to test, because its state is hidden. In a
# class, everything has a name and a type. And for a second robot, you just create a second object. So most nodes are
# classes.

# %% [markdown] prediction="a-whole-number"
# ### Experiment 2: a whole number
#
# In lesson 03, you saw that a float field needs a Python float. Here, `send(level: float)` creates
# `Float32(data=level)`, and the program calls `send(100)`. Which tool reports the mistake?
#
# - **a** mypy, because 100 is an int and the hint is float.
#   when `complaints > 0`
#   ✗ In Python's type system, an int is accepted wherever a float is expected. mypy follows that rule.
# - **b** Python, when the program calls `send`.
#   when `complaints == 0 and raised_in_python`
#   ✗ Python stores the hint, but doesn't compare it with the value.
# - **c** Neither mypy nor Python, so the value goes into the message.
#   when `complaints == 0 and not raised_in_python`
#   ✓ mypy accepts an int as a float, and Python doesn't check hints. The result depends on the build: this course's
#   packages send 0.0, and the Ubuntu packages may abort the process.

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
reveal(
    "a-whole-number", complaints=len(report), raised_in_python="TypeError" in end.log
)

# %% [markdown]
# mypy accepts an `int` where a `float` is expected, because Python's arithmetic works with both. But the message's C
# code can't convert an int: you get a wrong value or a crash, depending on the build. So convert the value when you put
# it into the message:

# %%
converted = run_program(LEVEL.format(value="float(level)", given="100"), seconds=20)
print("float(level):    ", converted.log.strip())
with_checks = run_program(FIELD_CHECKS + whole, seconds=20)
errors = [line for line in with_checks.log.splitlines() if "Error:" in line]
print("and field checks:", errors[-1])

# %% [markdown] prediction="one-of-two-words"
# ### Experiment 3: one of two words
#
# A status is `operational` or `error`. The hint `str` accepts any string, but `Literal["operational", "error"]` accepts
# only these two. Here, both calls pass a correctly spelled word:
#
# ```python
# Status = Literal["operational", "error"]
#
# def send_status(status: Status) -> None:
#     print("sent:", status)
#
# send_status("operational")
# word = "operational"
# send_status(word)
# ```
#
# What does mypy report?
#
# - **a** Nothing, because both calls pass a valid word.
#   when `first_call == 0 and second_call == 0`
#   ✗ Both calls are valid when the program runs. But mypy compares types, and it infers the type `str` for the variable
#   `word`.
# - **b** An error in both calls, because a `str` isn't a `Literal`.
#   when `first_call > 0 and second_call > 0`
#   ✗ If a call contains the string itself, mypy checks the string's exact value. So the first call passes.
# - **c** An error in the second call only.
#   when `first_call == 0 and second_call > 0`
#   ✓ mypy infers the type `str` for the variable `word`, and a `str` can be any string.

# %%
predict("one-of-two-words")

# %%
WORDS = '''\
from typing import Literal

Status = Literal["operational", "error"]


def send_status(status: Status) -> None:
    print("sent:", status)


send_status("operational")
word = "operational"
send_status(word)
'''
report = check_types(WORDS)
print(report)
calls = [
    line
    for line, text in enumerate(WORDS.splitlines(), start=1)
    if text.startswith("send_status")
]
reveal(
    "one-of-two-words",
    first_call=report.lines.count(calls[0]),
    second_call=report.lines.count(calls[1]),
)

# %% [markdown]
# **Your turn.** Give the variable a narrower type so that mypy accepts both calls. The narrower the type, the more
# mistakes mypy finds. But Python doesn't enforce hints. To show this, the cell also sends the misspelled `eror`, which
# only mypy reports.

# %% id="your-word"
line = ...  # TODO: word = "operational", with a hint, as text

if line is not ...:
    narrow = check_types(WORDS.replace('word = "operational"', line))
yours(... if line is ... else len(narrow), 0, "The type is called Status.")

first = WORDS.partition("word =")[0]
wrong = first.replace('send_status("operational")', 'send_status("eror")')
print(check_types(wrong))
print(run_program(wrong, seconds=20).log)
# %% [markdown]
# ## When it goes wrong
#
# **Hints from newer ROS versions.** In those versions, publishers are generic, so you often see `Publisher[String]`.
# Here's what happens in Jazzy:

# %% id="publisher-subscript" tags=["raises-exception"]
from rclpy.publisher import Publisher
from std_msgs.msg import String

StatusPublisher = Publisher[String]

# %% [markdown]
# In this rclpy version, `Publisher` doesn't accept a type in brackets. Plain `Publisher` is correct, but it doesn't
# specify the message type. A Protocol such as `SendsFloats` does.
#
# **An attribute name that `Node` already uses.** Can you find the mistake in the next cell before you run it?

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
# `Node` already has a property called `publishers`, and you can't assign to it. The same applies to `subscriptions`,
# `timers`, `clients`, `services`, `context`, and `handle`. mypy reports this mistake without running anything.
#
# [the same without helpers: init, fresh]
#
# **A value from outside.** In the next program, `send` is annotated, and mypy accepts the call. But the value is parsed
# from JSON, just as a value from a file might be, so mypy doesn't know its type.

# %% id="hints-are-no-guards"
OUTSIDE = LEVEL.replace("import time\n", "import json\nimport time\n")
careless = OUTSIDE.format(value="level", given="json.loads('\"full\"')")
print(check_types(careless))
print(run_program(careless, seconds=20).log)

# %% [markdown]
# A dashboard would show 0%, with no error to explain it. So at run time, check each value that comes from outside, and
# raise a helpful error:

# %%
GUARD = '''\
    if not isinstance(level, (int, float)):
        raise TypeError(f"a charge is a number of percent, not {level!r}")
    publisher.publish('''
guarded = careless.replace("    publisher.publish(", GUARD)
guarded = guarded.replace("data=level", "data=float(level)")
print(check_types(guarded))
print(run_program(guarded, seconds=20).log.strip().splitlines()[-1])

# %% [markdown]
# `float(level)` alone can't replace this check: it accepts the string `"87.5"` and fails on the string `"87 %"`.
#
# `# type: ignore` at the end of a line hides everything that mypy would report there. If a value has the hint `Any`,
# mypy accepts anything you do with it. Both only hide mistakes. If you really need one of the two, explain why in a
# comment.

# %% [markdown]
# ## From a worked example to your own
#
# **Worked example.** The next node belongs to a charging station. It has a typed publisher, accepts only three words,
# and checks each before putting it into a message.

# %%
from typing import Literal, Protocol, get_args

from std_msgs.msg import Float32

Plug = Literal["free", "charging", "broken"]


class SendsText(Protocol):
    """Publishes String messages, and no others."""

    def publish(self, msg: String) -> None: ...


class ChargingStation(Node):
    """Publishes the state of its plug."""

    def __init__(self) -> None:
        super().__init__("charging_station")
        publisher = self.create_publisher(String, "/station/plug", 10)
        self.plug_publisher: SendsText = publisher

    def send_plug(self, plug: Plug) -> None:
        """Publish the state of the plug. Raises ValueError for any other word."""
        if plug not in get_args(Plug):
            raise ValueError(f"a plug is one of {get_args(Plug)}, not {plug!r}")
        self.plug_publisher.publish(String(data=plug))


station = fresh(ChargingStation)
station.send_plug("charging")
for misuse in (
    lambda: station.send_plug("chraging"),
    lambda: station.plug_publisher.publish(Float32()),
):
    try:
        misuse()
    except Exception as error:
        print(f"{type(error).__name__}: {error}")

# %% [markdown]
# The second error comes from rclpy: `publish` checks the message's class, but not its fields.
#
# **Fill in the blanks.** So far, no net has caught mistake 3, a subscription whose callback expects another message
# type. The function `listen` below ties the message type to the callback. In the hints for `kind` and `callback`, the
# type variable `Message` stands for one and the same type. Write these two hints as strings. When both are right, mypy
# reports an error only in line 25, the call with the wrong callback. `Callable[[X], None]` is the type of a function
# that takes an `X` and returns nothing.

# %% id="your-listen"
kind = ...  # TODO: the hint for a message class, such as "type[String]"
callback = ...  # TODO: the hint for its callback, such as "Callable[[String], None]"

LISTEN = f'''\
from collections.abc import Callable
from typing import TypeVar

from rclpy.node import Node
from std_msgs.msg import Float32, String

Message = TypeVar("Message")


def listen(node: Node, kind: {kind}, topic: str, callback: {callback}) -> None:
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
if ... not in (kind, callback):
    report = check_types(LISTEN)
    print(report)
yours(
    ... if ... in (kind, callback) else report.lines,
    (25,),
    'Write "type[Message]" and "Callable[[Message], None]".',
)

# %% [markdown]
# **Your own.** In the [exercise](../exercises/07_typed_nodes.ipynb), two other teams call your node's methods. Change
# the node so that mypy and the node itself reject misuse with clear errors. The judge looks at the messages that your
# node publishes *and* at mypy's report on your code.

# %% [markdown]
# ## Check yourself
#
# **1. Without stubs, why does mypy accept `Float32().dta`?**
#
# <details><summary>a) The package has no hints that mypy can use, so the message is Any</summary>
#
# ✓ `Any` has every attribute. The `import-untyped` error at the top of the report warns you about this.
#
# </details>
# <details><summary>b) Fields are looked up at run time, so no tool can check them</summary>
#
# ✗ mypy can check them as soon as stubs describe the fields.
#
# </details>
# <details><summary>c) mypy checks only code that has run at least once</summary>
#
# ✗ mypy never runs your code; it only reads it.
#
# </details>
#
# **2. What does plain mypy report for `def on_tick(self): self.create_timer("2 s", self.send)`?**
#
# <details><summary>a) That a string isn't a valid period</summary>
#
# ✗ mypy would report this if the function had the hint `-> None`, or if you used `--check-untyped-defs` or `--strict`,
# which check all functions.
#
# </details>
# <details><summary>b) That <code>send</code> is unknown</summary>
#
# ✗ mypy doesn't check the line at all.
#
# </details>
# <details><summary>c) Nothing, because mypy doesn't check functions without hints</summary>
#
# ✓ You saw this with the closure and the class. Adding `-> None` is enough to get the function checked.
#
# </details>
#
# **3. `send` is defined as `def send(self, level: float) -> None`. What happens if a program that mypy hasn't checked calls `send("full")`?**
#
# <details><summary>a) Python raises a TypeError at the call</summary>
#
# ✗ Python stores the hint, but never compares it with the value.
#
# </details>
# <details><summary>b) The string goes into the message: 0.0 is sent, or the program crashes</summary>
#
# ✓ With this course's packages, 0.0 is sent; with the Ubuntu packages, the process may abort. A check in `send` would
# have prevented both.
#
# </details>
# <details><summary>c) Python converts it to a float, because the hint says so</summary>
#
# ✗ Hints don't convert anything. If you called `float("full")` yourself, you'd get a ValueError.
#
# </details>
#
# **4. You pass an object to a function that expects `SendsFloats`. When does mypy accept the object?**
#
# <details><summary>a) If it has a publish method that takes a Float32</summary>
#
# ✓ A Protocol only lists the methods that an object needs. Every object that has these methods matches it, even a small
# fake that you write for a test.
#
# </details>
# <details><summary>b) If its class inherits from SendsFloats</summary>
#
# ✗ Inheriting would work, too, but it isn't required. rclpy's publishers don't inherit from `SendsFloats`, and mypy
# accepts them.
#
# </details>
# <details><summary>c) If it was created by create_publisher</summary>
#
# ✗ mypy compares the methods. It doesn't matter how the object was created.
#
# </details>
#
# **5. In strict mode and with stubs, mypy finds nothing in your node. Which mistake could the node still contain?**
#
# <details><summary>a) A misspelled message field</summary>
#
# ✗ With stubs, mypy knows the fields.
#
# </details>
# <details><summary>b) Swapped arguments to <code>create_timer</code></summary>
#
# ✗ rclpy's own functions have hints, so mypy found this mistake even without stubs.
#
# </details>
# <details><summary>c) An int in a float field, so that subscribers receive 0.0</summary>
#
# ✓ mypy accepts an int as a float. `float(level)` prevents the mistake, and a test that checks the received messages
# finds it.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Read this prompt and write down your own answer. Then give the prompt to an AI assistant, or discuss it with a
# colleague.
#
# ```text
# I'm programming a robot with ROS 2 Jazzy in Python (rclpy). We have thirty nodes,
# written over three years, without a single type hint. We've been asked to run
# mypy --strict in our automated checks, starting on Monday. What would you do first,
# what would you leave for later, and what will mypy never find for us? Make sure that
# every rclpy function you use exists in Jazzy.
# ```
#
# <details><summary>What a good answer covers</summary>
#
# Don't enable every check on Monday. For thirty nodes, `--strict` would report hundreds of errors, and people would
# then silence them with `# type: ignore`.
#
# Add stubs for the messages first, because without them, most ROS types are `Any`. Next, add plain mypy to the
# automated checks for all nodes, so that no new mistakes get in. Then add `-> None` and argument hints, node by node,
# and turn on the strict settings for a node once it's clean.
#
# mypy doesn't find bad values from outside, an int in a float field, topic names that don't match, or wrong periods. It
# doesn't check timing at all. To find these faults, you need run-time checks, tests with field checks turned on, and
# tests that inspect the received messages.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Watch for these two mistakes. We checked both with the rclpy version that this course uses.
#
# - **`self.level: Publisher[Float32] = …`:** In Jazzy, `Publisher` doesn't accept a type in brackets, and mypy reports
#   this hint as an error. Inside a method, Python ignores the hint; in a signature, Python 3.13 and older raise a
#   `TypeError`. Newer ROS versions allow it.
# - **mypy will find the misspelled field `msg.dta`:** In fact, it can't without stubs. The message packages come
#   without types, so each message is `Any`.
#
# </details>

# %% [markdown]
# ## Take away
#
# - mypy reads a program and follows its hints, so it finds mistakes even in lines that have never run.
# - By default, it doesn't check functions without hints. `-> None` is enough to get a function checked; `--strict`
#   demands hints everywhere.
# - `import-untyped` means that messages are `Any` to mypy. Stubs describe the messages' fields.
# - A Protocol with a `publish` method gives a publisher a message type, so mypy reports messages of any other type.
# - Hints do nothing at run time. Check values that come from outside, and convert ints with `float(...)`.
#
# **Before:** [06 · Spinning](06_spinning.ipynb)
#
# **Deeper:** [07 · Deeper: one typed publisher for all messages](07_typed_nodes_deeper.ipynb)
#
# **Next:** [08 · The humanoid status publisher](08_humanoid_status_publisher.ipynb), a node with two timers.
#
# **More:** [rclpy](https://docs.ros.org/en/jazzy/p/rclpy), with all its types, and [the mypy
# documentation](https://mypy.readthedocs.io/).

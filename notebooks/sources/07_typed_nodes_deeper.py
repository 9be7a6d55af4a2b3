# %% [markdown]
# # 07 · Deeper: one typed publisher for all messages
#
# In lesson 07, we wrote a separate `Protocol` for each message type. Can a single Protocol cover all message types?
#
# - **Minutes:** 10
# - **You need:** lesson [07](07_typed_nodes.ipynb)
# - **You will be able to:**
#   - write a generic Protocol
#   - write a function whose return type depends on the message class
# - **Not covered:** your own generic classes that store state

# %% [markdown] prediction="one-letter-less"
# ## Predict
#
# Suppose we want a Protocol called `Sends`, so that `Sends[Float32]` describes a publisher of `Float32` messages. To
# accept a type in brackets, `Sends` needs a type variable, here called `Taken`:
#
# ```python
# Taken = TypeVar("Taken")
#
# class Sends(Protocol[Taken]):
#     def publish(self, msg: Taken) -> None: ...
# ```
#
# `Taken` appears only as the type of an argument. What does `mypy --strict` report for these lines?
#
# - **a** Nothing, because nothing is missing from the class.
#   when `complaints == 0`
#   ✗ Nothing is missing, but that isn't enough. mypy also checks the direction in which the type is used, and here, the
#   type only goes in, as an argument.
# - **b** It asks for a contravariant type variable.
#   when `complaints > 0 and 'contravariant' in said`
#   ✓ A type that only goes in, as an argument, has to be contravariant.
# - **c** It asks for a bound, such as a base class of all messages.
#   when `complaints > 0 and 'contravariant' not in said`
#   ✗ A type variable needs no bound. And ROS messages have no common base class in Python.

# %%
from workbook.lesson import check_types, predict, reveal

predict("one-letter-less")

# %% [markdown]
# ## Run it

# %%
SENDS = '''\
from typing import Protocol, TypeVar

Taken = TypeVar("Taken")


class Sends(Protocol[Taken]):
    def publish(self, msg: Taken) -> None: ...
'''
report = check_types(SENDS)
print(report)
reveal("one-letter-less", complaints=len(report), said=str(report))

# %% [markdown]
# ## Look inside
#
# **Your turn.** mypy's message names the kind of type variable that it expects. Pass that kind to `TypeVar` as a
# keyword argument, just as you'd pass `covariant=True` for the opposite kind. Write the complete line so that mypy
# reports no errors.

# %% id="your-variable"
from workbook.lesson import yours

line = ...  # TODO: Taken = TypeVar("Taken"), with one more argument, as text

if line is not ...:
    report = check_types(SENDS.replace('Taken = TypeVar("Taken")', line))
yours(... if line is ... else len(report), 0, "contravariant=True")

# %% [markdown]
# `contravariant=True` declares that the type appears only as an argument. So wherever a publisher of `Float32` is
# expected, you can use one that accepts every message, but not the other way around.
#
# In the next cell, the return type of `make_publisher` depends on its argument `kind`. The hints for both,
# `type[Message]` and `Sends[Message]`, contain the type variable `Message`, which stands for the same type in each.
# With `kind=Float32`, the function returns a `Sends[Float32]`.

# %%
TYPED = '''\
from typing import Protocol, TypeVar

from rclpy.node import Node
from std_msgs.msg import Float32, String

Message = TypeVar("Message")
Taken = TypeVar("Taken", contravariant=True)


class Sends(Protocol[Taken]):
    """Publishes messages of one type, and of no other."""

    def publish(self, msg: Taken) -> None: ...


def make_publisher(node: Node, kind: type[Message], topic: str) -> Sends[Message]:
    """A publisher that accepts messages of `kind`."""
    return node.create_publisher(kind, topic, 10)


node = Node("vitals")
battery = make_publisher(node, Float32, "/robot/battery")
battery.publish(Float32(data=98.0))
battery.publish(String(data="full"))
'''
check_types(TYPED)

# %% [markdown]
# mypy reports only the last line, which contains the mistake. For comparison, here's the same program with rclpy's own
# publisher:

# %%
from workbook.lesson.type_reports import nets_picture

PLAIN = TYPED.replace(
    'make_publisher(node, Float32, "/robot/battery")',
    'node.create_publisher(Float32, "/robot/battery", 10)',
)
ROWS = {1: "a String is published"}
nets = {
    name: {1 for found in check_types(text).findings if "publish" in found.message}
    for name, text in (("rclpy's Publisher", PLAIN), ("Sends[Float32]", TYPED))
}
for name, caught in nets.items():
    print(f"{name}: {len(caught)} of 1 found")
nets_picture(
    nets,
    ROWS,
    "rclpy's Publisher misses the wrong message, Sends[Float32] finds it",
    title="Only Sends[Float32] finds the wrong message",
)

# %% [markdown]
# In Python 3.12 and later, you can write `class Sends[Taken](Protocol)` and `def make_publisher[Message](...)`, and
# leave out the two lines with `TypeVar`.

# %% [markdown]
# ## Take away
#
# - A single generic Protocol can describe many types. If the type appears only as an argument, the Protocol's type
#   variable is contravariant.
# - If a function takes `kind: type[Message]` and returns `Sends[Message]`, mypy infers the publisher's type from the
#   message class.
#
# **Before:** [07 · Typed nodes](07_typed_nodes.ipynb)
#
# **Next:** [08 · The humanoid status publisher](08_humanoid_status_publisher.ipynb)
#
# **More:** [rclpy](https://docs.ros.org/en/jazzy/p/rclpy), and [Protocols in the mypy
# documentation](https://mypy.readthedocs.io/en/stable/protocols.html).

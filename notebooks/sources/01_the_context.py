# %% [markdown]
# # 01 · The context
#
# A robot program has to start ROS before it can create a node. And when the program ends, the robot must not drop
# whatever it's carrying. How do you start ROS and shut it down properly? Both steps involve the same object: the
# context.
#
# - **Minutes:** 45
# - **You need:** lesson [00](00_start_here.ipynb)
# - **You will be able to:**
#   - start ROS in a program and shut it down
#   - say which calls work before `init`, after it, and after `shutdown`
#   - say which robots receive each other's messages
#   - write a `main()` that ends cleanly on Ctrl-C
# - **Not covered:** how `spin` works (lesson 06), other signals and threads (the deeper notebook), lifecycle nodes

# %% [markdown]
# It's night in a museum. A robot guard makes its rounds for as long as its program is running. Let's run that program
# in a separate process.

# %%
from lesson_nodes import night_guard
from workbook.lesson import start, stop
from workbook.ros import node_list

start(night_guard)
print("while it works: ", node_list())
stop()
print("after the end:  ", node_list())

# %% [markdown]
# While the program was running, its **node** was in the list. Then the program ended without an error, and the node was
# gone. Such a clean exit is less common than you might think: many example programs on the web end with a page of error
# messages. By the end of this lesson, you'll be able to write one that doesn't.
#
# [the same without helpers: start]

# %% [markdown] prediction="publish-after-shutdown"
# ## Predict
#
# Every rclpy program begins with `init` and ends with `shutdown`. Between those two calls, this program creates a node
# and a publisher:
#
# ```python
# rclpy.init()
# guard = Node("museum_guard")
# radio = guard.create_publisher(String, "/museum/radio", 10)
# rclpy.shutdown()
# ```
#
# After these lines, the program calls `radio.publish(String(data="burglar!"))`. What happens?
#
# - **a** The message is sent: `shutdown` stops callbacks, but not publishing.
#   ✗ `shutdown` ends the context, and the publisher needs it. Without a valid context, nothing can be sent.
# - **b** Nothing visible: there's no error, but other programs don't receive the message.
#   ✗ There is an error: rclpy checks the context, finds that it's no longer valid, and raises an exception.
# - **c** The program doesn't get that far: `shutdown` fails while a node exists.
#   ✗ `shutdown` doesn't check whether nodes exist. It only ends the context. The node and its publisher remain as
#   Python objects without a valid context.
# - **d** It raises an error: the objects still exist, but their context is no longer valid.
#   ✓ `shutdown` deletes no Python objects, but it makes their context invalid. So `publish` raises an error.

# %%
from workbook.lesson import predict, reveal

predict("publish-after-shutdown")

# %% [markdown]
# ## Run it
#
# `rclpy.ok()` returns `True` while the context is valid. (The next section explains what a context is.) Let's call this
# function before `init`, after `init`, and after `shutdown`.

# %%
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.try_shutdown()  # only so that you can run this cell again

at_first = rclpy.ok()

rclpy.init()
guard = Node("museum_guard")
radio = guard.create_publisher(String, "/museum/radio", 10)
radio.publish(String(data="all quiet"))
after_init = rclpy.ok()

rclpy.shutdown()
print(f"rclpy.ok(): {at_first} at first, {after_init} after init,", end=" ")
print(f"{rclpy.ok()} after shutdown")

# %% [markdown]
# Now publish after the shutdown.

# %% id="publish-after-shutdown" tags=["raises-exception"]
radio.publish(String(data="burglar!"))

# %%
reveal("publish-after-shutdown")

# %% [markdown]
# ## Look inside
#
# `init` created a **context**, and `shutdown` shut it down. A context holds the settings that all nodes in a *process*
# share: the domain, the command-line arguments, and how Ctrl-C is handled. Every node belongs to a context. You didn't
# have to pass a context, because `rclpy.init()` initializes the **default context**, and `Node(...)` uses it.
#
# A context goes through three states: *not initialized* → *ok* → *shut down*. It never goes back. `rclpy.ok()` returns
# `True` only in the second state.
#
# Which calls work in which state? The next cell tries four calls with a valid context, with a destroyed node, and after
# a shutdown.

# %% id="what-works-when"
rclpy.try_shutdown()


def outcome(action) -> str:
    try:
        action()
    except Exception as error:
        return "✗ " + type(error).__name__
    return "✓"


def try_everything() -> list[str]:
    return [
        outcome(lambda: Node("newcomer").destroy_node()),
        outcome(lambda: speaker.publish(String(data="hello"))),
        outcome(lambda: guard.create_publisher(String, "/museum/alarm", 10)),
        outcome(lambda: guard.get_name()),
    ]


actions = ["make a node", "publish", "make a publisher", "ask for its name"]
rclpy.init()
guard = Node("first_guard")
speaker = guard.create_publisher(String, "/museum/radio", 10)
columns = {"ok": try_everything()}
guard.destroy_node()
columns["node destroyed"] = try_everything()
guard = Node("second_guard")
speaker = guard.create_publisher(String, "/museum/radio", 10)
rclpy.shutdown()
columns["shut down"] = try_everything()


def line(first: str, rest) -> str:
    return (f"{first:<18}" + "".join(f"{text:<18}" for text in rest)).rstrip()


print(line("", columns))
for row, action in enumerate(actions):
    print(line(action, [column[row] for column in columns.values()]))

# %% [markdown]
# The three exceptions have different meanings:
#
# - **`NotInitializedException`:** There's no valid context.
# - **`RCLError`:** The C library that rclpy is built on rejected the call. Here, too, the reason is that there's no
#   valid context.
# - **`InvalidHandle`:** The context is valid, but the node was destroyed.
#
# Look at the last row. After the shutdown, the node still exists as a Python object and can return its name. But it
# can't publish anymore, and its context will never be valid again.
#
# **Your turn.** Give this program a working node again, without restarting Python. You need two lines.

# %% id="your-new-start"
from workbook.lesson import yours

rclpy.try_shutdown()

# TODO: the call that new nodes need, as a line of its own
third_guard = ...  # TODO: a new node, "third_guard"

got = ...
if third_guard is not ...:
    got = outcome(lambda: third_guard.create_publisher(String, "/museum/alarm", 10))
yours(got, "✓", "Call rclpy.init(), then create the node with Node(...).")

# %% [markdown] prediction="three-contexts"
# ## Change it
#
# ### Experiment 1: three contexts in one notebook
#
# A process usually has one context, but it can have several. Each context can be in a different **domain**. (You met
# domains and their numbers in lesson 00.) Here are three robots in one process, each with its own context. `kitchen`
# and `hall` are in domain A, and `garden` is in domain B. All three publish their names to the topic `/building/hello`
# and subscribe to that topic. Which robots hear each other, that is, receive each other's messages?
#
# - **a** None: each has its own context.
#   when `kitchen_hears == 0 and garden_hears == 0`
#   ✗ Separate contexts don't separate nodes. `kitchen` and `hall` are in the same domain, so they discover each other,
#   just as two programs would.
# - **b** `kitchen` and `hall` hear each other, but `garden` hears no one.
#   when `kitchen_hears == 1 and garden_hears == 0`
#   ✓ Robots hear each other only within a domain. Two of the three contexts are in domain A.
# - **c** All of them, because they share one process and one topic.
#   when `kitchen_hears == 2 and garden_hears == 2`
#   ✗ `garden` is in a different domain. Nodes in different domains don't discover each other, not even within one
#   process.

# %%
predict("three-contexts")

# %% id="three-contexts"
import time

from lesson_nodes.radio_robot import RadioRobot
from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
from workbook.ros.domains import lease_domain

PLACES = {"kitchen": "A", "hall": "A", "garden": "B"}  # turn this knob


def talk(places: dict[str, str], seconds: float) -> dict[str, RadioRobot]:
    """Let one robot per place talk, each in a context on its domain."""
    leases = {domain: lease_domain() for domain in set(places.values())}
    robots, executors = {}, []
    for place, domain in places.items():
        context = Context()
        rclpy.init(context=context, domain_id=leases[domain].domain_id)
        robots[place] = RadioRobot(place, context=context)
        executor = SingleThreadedExecutor(context=context)
        executor.add_node(robots[place])
        executors.append(executor)
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        for executor in executors:
            executor.spin_once(timeout_sec=0.01)
    for executor, robot in zip(executors, robots.values(), strict=True):
        executor.shutdown()
        robot.destroy_node()
        rclpy.shutdown(context=robot.context)
    for lease in leases.values():
        lease.release()
    return robots


began = time.monotonic()
robots = talk(PLACES, seconds=5)
for place, robot in robots.items():
    print(
        f"{place:<8} on domain {PLACES[place]} hears",
        ", ".join(robot.others()) or "nobody else",
    )
reveal(
    "three-contexts",
    kitchen_hears=len(robots["kitchen"].others()),
    garden_hears=len(robots["garden"].others()),
)

# %%
from workbook.pictures.figures import show
from workbook.pictures.timeline import strip

heard = {
    f"{listener} hears {speaker}": [
        moment - began for moment in robots[listener].moments(speaker)
    ]
    for listener in robots
    for speaker in robots
    if speaker != listener
}
show(
    strip(
        heard,
        end=5.5,
        noun="times",
        title="Only robots in the same domain receive each other's messages",
    ),
    "five seconds: kitchen and hall receive each other's messages four times a second; "
    "garden receives none, and the others receive none from garden",
)

# %% [markdown]
# The domain alone determines which robots receive each other's messages, even if the robots share a process and a
# topic.
#
# **Your turn.** A fourth robot, `terrace`, should hear `garden`, but neither `kitchen` nor `hall`.

# %% id="your-terrace"
places = {**PLACES, "terrace": ...}  # TODO: the domain, "A" or "B"

hears = ...
if ... not in places.values():
    hears = talk(places, seconds=5)["terrace"].others()
yours(hears, ["garden"], "Robots hear each other if they're in the same domain.")

# %% [markdown]
# Domains matter in a classroom, because ROS uses domain 0 by default. With thirty laptops on one network, *your*
# dashboard might show the battery level of your neighbor's robot. So at each desk, set the environment variable
# `ROS_DOMAIN_ID` to a different number. (With `ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST`, a program discovers only other
# programs on the same machine.)
#
# Don't hard-code the domain, because then you'd have to edit the program to run it in another domain. Each of these
# notebooks chooses a free domain when you open it.

# %% [markdown]
# ### Experiment 2: Ctrl-C
#
# During development, you stop most robot programs with Ctrl-C. Linux then sends the process a **signal** called SIGINT,
# and Python turns that signal into the exception `KeyboardInterrupt`. Here are three ways to write `main`, all of which
# you can find on the web.

# %%
import inspect

from lesson_nodes import three_mains

print(
    inspect.getsource(three_mains)
    .split("if __name__")[0]
    .partition("NightGuard\n\n\n")[2]
)

# %% [markdown] prediction="after-ctrl-c"
# `spin` runs the node's callbacks. `guard.park()` folds the robot's arms and prints `arms parked`.
#
# A program's **exit code** says how it ended: 0 means success, and any other number means failure. Scripts, service
# managers, and ROS's launch system read the exit code. After Ctrl-C, which of the three programs end with exit code 0?
#
# - **a** Only `third_main`
#   when `first != 0 and second != 0 and third == 0`
#   ✓ It catches the exception that `spin` raises. Then it calls `try_shutdown`, which does nothing if the context is
#   already shut down.
# - **b** All three: Ctrl-C is a normal way to end a program.
#   when `first == 0 and second == 0 and third == 0`
#   ✗ `first_main` doesn't catch the `KeyboardInterrupt`. That exception ends the program, so the exit code isn't 0.
# - **c** `second_main` and `third_main`
#   when `first != 0 and second == 0 and third == 0`
#   ✗ `second_main` catches the `KeyboardInterrupt`, but then `rclpy.shutdown()` raises an exception, because Ctrl-C has
#   already shut the context down.
# - **d** None: after Ctrl-C, the exit code is never 0.
#   when `first != 0 and second != 0 and third != 0`
#   ✗ The exit code is 0 whenever a program reaches its end without an uncaught exception, even after Ctrl-C.

# %%
predict("after-ctrl-c")

# %% [markdown]
# The next cell runs each `main` in its own process and sends it Ctrl-C during the first round.

# %% id="three-mains"
from workbook.lesson import run_program

ends = {
    name: run_program(three_mains, arguments=[name], interrupt_at="round 1")
    for name in ("first_main", "second_main", "third_main")
}
for name, end in ends.items():
    last_line = end.log.strip().splitlines()[-1].split(", at ")[0]
    arms = "parked" if "arms parked" in end.log else "still up"
    print(f"{name}: exit code {end.exit}, arms {arms}")
    print(f"    last line: {last_line}")
reveal(
    "after-ctrl-c",
    first=ends["first_main"].exit,
    second=ends["second_main"].exit,
    third=ends["third_main"].exit,
)

# %% [markdown]
# **`first_main`** never reaches the line after `spin`. On Ctrl-C, `spin` doesn't return. It *raises* an exception that
# ends the function, so the arms stay up. (130 is a shell convention: 128 plus the signal's number, and SIGINT is number
# 2.)
#
# **`second_main`** parks the arms, but then `rclpy.shutdown()` fails: *rcl_shutdown already called*. `rclpy.init`
# installed a handler for SIGINT, and that handler shuts the context down right away. This `main` appears in many
# tutorials. It looks fine, because the arms are down. But a service manager reads the exit code, so it reports a crash.
#
# **`third_main`** calls `rclpy.try_shutdown()`, which shuts the context down only if it's still valid. Its `except`
# line also names a second exception, which `spin` raises if other code shuts the context down. Write your own `main`
# the same way.
#
# One caveat: `try_shutdown` first checks the context and then shuts it down. Very rarely, rclpy's handler shuts the
# context down between these two steps, so the program ends like `second_main`. That's a bug in this rclpy version. The
# exercise's check recognizes this case and doesn't count it against you.

# %% [markdown]
# ## When it goes wrong
#
# **Calling `init` twice.** Often, one call is at the top of a file, and the other is in `main`. Here, both are in one
# cell:

# %% id="init-twice" tags=["raises-exception"]
rclpy.try_shutdown()
rclpy.init()
rclpy.init()

# %% [markdown]
# The second call fails because the context is already initialized. In a program, call `init` only in `main`. In a
# notebook, you run cells repeatedly, so use `init()` from `workbook.lesson`. Calling that function a second time does
# nothing.
#
# **Creating a node before `init`.** Often, the line that creates the node is at the top level of a file, outside of
# `main`, so it runs before `init`.

# %% id="node-before-init" tags=["raises-exception"]
rclpy.try_shutdown()
Node("early_bird")

# %% [markdown]
# **Using a destroyed node.** The context is valid, but the call fails anyway:

# %% id="destroyed-node" tags=["raises-exception"]
rclpy.init()
guard = Node("retired_guard")
guard.destroy_node()
guard.get_name()

# %% [markdown]
# The error message calls the node a *Destroyable*. The usual cause is a call to `destroy_node()` that comes one line
# too early, before a last `publish` or log message.
#
# **Code for other ROS versions.** Out of habit, programmers coming from ROS 1 might write this call:

# %% id="positional-arguments" tags=["raises-exception"]
import sys

rclpy.try_shutdown()
rclpy.init(sys.argv)

# %% [markdown]
# Pass the arguments by name: `rclpy.init(args=sys.argv)`. If you leave them out, rclpy uses the command-line arguments.
#
# And this `with` statement comes from the documentation for a newer ROS release:

# %% id="with-init" tags=["raises-exception"]
rclpy.try_shutdown()
with rclpy.init():
    guard = Node("guard")

# %% [markdown]
# In newer versions, `init` returns a context manager for `with`. In Jazzy, it returns `None`, so use `try` and
# `finally` instead. One caveat: the failing line *did* call `init` before it raised the exception. The context is now
# initialized, so another `init` raises an exception, too:

# %%
try:
    rclpy.init()
except RuntimeError as error:
    print(error)
rclpy.try_shutdown()

# %% [markdown]
# ## From a worked example to your own
#
# **Worked example.** A robot waters plants. When its program ends, the robot must close the valve, even after an error.
# The pattern is always the same: call `init`, create the node, spin inside `try`, catch the two exceptions, and clean
# up in `finally`.

# %%
# %%writefile gardener.py
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class Gardener(Node):
    def __init__(self) -> None:
        super().__init__("gardener")
        self.plants = 0
        self.create_timer(0.2, self.water)

    def water(self) -> None:
        self.plants += 1
        print("watered plant", self.plants, flush=True)

    def close_valve(self) -> None:
        print("valve closed")


def main() -> None:
    rclpy.init()
    gardener = Gardener()
    try:
        rclpy.spin(gardener)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        gardener.close_valve()
        gardener.destroy_node()
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()

# %%
from pathlib import Path

end = run_program(Path("gardener.py"), interrupt_at="plant 2")
print("exit code:", end.exit)
print("last line:", end.log.strip().splitlines()[-1])

# %% [markdown]
# **Fill in the blanks.** A delivery robot must lock its box when its program ends. Fill in the three places marked
# TODO, and run both cells. The second one runs your program, sends it Ctrl-C, and checks its exit code and its last
# line of output.

# %%
# %%writefile courier.py
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class Courier(Node):
    def __init__(self) -> None:
        super().__init__("courier")
        self.create_timer(0.2, lambda: print("driving", flush=True))

    def lock_box(self) -> None:
        print("box locked")


def main() -> None:
    rclpy.init()
    courier = Courier()
    try:
        rclpy.spin(courier)
    except ...:  # TODO: which exceptions?
        pass
    finally:
        # TODO: lock the box
        courier.destroy_node()
        # TODO: shut down, if that has not happened yet


if __name__ == "__main__":
    main()

# %% id="your-courier"
ended = ...  # TODO: in the cell above, not here
if "..." not in Path("courier.py").read_text():
    end = run_program(Path("courier.py"), interrupt_at="driving")
    ended = end.exit, end.log.strip().splitlines()[-1]
yours(ended, (0, "box locked"), "Compare your main() with the gardener's.")

# %% [markdown]
# **Your own.** In the [exercise](../exercises/01_the_context.ipynb), you write `main()` for the night guard. The judge
# sends your program a real Ctrl-C. Then it checks how the program ends, whether the arms are parked, and whether the
# node is gone.

# %% [markdown]
# ## Check yourself
#
# **1. Your program has called `rclpy.shutdown()`, and the variable `guard` refers to one of its nodes. What can that node still do?**
#
# <details><summary>a) It can do everything except receive messages</summary>
#
# ✗ It can't publish, either. As you saw, `publish` raises an exception.
#
# </details>
# <details><summary>b) It can return its name, but do little else</summary>
#
# ✓ The object still exists, but its context is no longer valid. So the node can neither publish nor create a publisher.
#
# </details>
# <details><summary>c) It can do everything, after another call to <code>rclpy.init()</code></summary>
#
# ✗ A second `init` creates a new context. This node belongs to the old context, which never becomes valid again.
#
# </details>
#
# **2. Your program raises `RuntimeError: Context.init() must only be called once`. What do you do?**
#
# <details><summary>a) Find the second call and remove it</summary>
#
# ✓ Call `init` once, in `main`. The extra call is often at the top of a file that you import.
#
# </details>
# <details><summary>b) Call <code>rclpy.shutdown()</code> before each <code>rclpy.init()</code></summary>
#
# ✗ `shutdown` itself raises an exception if there's nothing to shut down. And any nodes that already exist are left
# without a valid context.
#
# </details>
# <details><summary>c) Wrap the call in <code>try</code> and <code>except</code>, and continue</summary>
#
# ✗ The program would run, but two parts of it would still try to start ROS. Find out why.
#
# </details>
#
# **3. A program has `except KeyboardInterrupt: pass` and then `finally: rclpy.shutdown()`. What happens on Ctrl-C?**
#
# <details><summary>a) It ends cleanly</summary>
#
# ✗ The last line raises an `RCLError`, so the exit code is 1.
#
# </details>
# <details><summary>b) It hangs</summary>
#
# ✗ It ends right away, but with an error.
#
# </details>
# <details><summary>c) It raises an exception, because the context is already shut down</summary>
#
# ✓ rclpy's SIGINT handler shut it down. That's why `rclpy.try_shutdown()` exists.
#
# </details>
#
# **4. Two students sit side by side. One starts a dashboard, and it shows the other student's robot. What's the fix?**
#
# <details><summary>a) A different domain for each desk</summary>
#
# ✓ Programs in different domains don't discover each other at all. At one of the desks, run `export ROS_DOMAIN_ID=17`
# once in each terminal.
#
# </details>
# <details><summary>b) A separate context for each program</summary>
#
# ✗ They already have separate contexts, because they're two processes. The kitchen and hall robots had separate
# contexts, too, and still received each other's messages.
#
# </details>
# <details><summary>c) Different topic names</summary>
#
# ✗ That helps only for this topic. The two students' nodes would still appear together in all tools and logs.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Write down your own answer first. Then copy the prompt into an AI assistant, or discuss it with a colleague.
#
# ```text
# I'm programming a robot with ROS 2 Jazzy in Python (rclpy). A node controls my robot
# arm. On Ctrl-C, the node should move the arm slowly to its rest position, publish
# "parked" to a topic, and then end. I put all of that into `except KeyboardInterrupt`.
# Why doesn't it work, and what are my options? Make sure that every rclpy function you
# use exists in Jazzy.
# ```
#
# <details><summary>What a good answer covers</summary>
#
# By default, rclpy's handler shuts the context down at about the same time as Python raises the exception. After that,
# the node can't publish, and no timer fires. So the `except` block can neither move the arm slowly nor publish the
# message.
#
# One option is `SignalHandlerOptions.NO`, which keeps the context valid until the program shuts it down. In the
# `except` block, keep spinning until the arm has reached its rest position, then publish and call `try_shutdown()`.
# (Give the node a timer: without one, `spin` may not wake up on Ctrl-C.) Another option is a "park" service or topic
# that the operator uses before pressing Ctrl-C.
#
# A good answer also asks what happens if the process is killed or the computer loses power, because in those cases, no
# `finally` block runs. So the motor controller must bring the arm to a safe stop on its own.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Watch for these two suggestions. We tested both with the rclpy version that this course uses, and both are wrong.
#
# - **`with rclpy.init():`:** Newer versions support it. In Jazzy, it raises a `TypeError`.
# - **Publishing "parked" in `except KeyboardInterrupt` or `finally`:** With the default signal handlers, rclpy shuts
#   the context down at about the same time as these blocks start. `publish` then raises an exception, unless it happens
#   to run just before the shutdown.
#
# </details>

# %% [markdown]
# ## Take away
#
# - A context holds the settings that a process's nodes share. It goes from *not initialized* to *ok* to *shut down*,
#   and never returns to an earlier state.
# - Call `rclpy.init()` once, in `main`, before you create the first node. After `shutdown` or `destroy_node`, a node
#   can't publish or receive.
# - The domain determines which robots receive each other's messages. Set it outside of the program, with
#   `ROS_DOMAIN_ID`.
# - To see from outside how a program ended, check its exit code, its log, and whether its node is gone.
# - On Ctrl-C, rclpy shuts the context down on its own, and `spin` raises an exception. So clean up in `finally`, and
#   call `try_shutdown()` there.
#
# **Before:** [00 · Start here](00_start_here.ipynb)
#
# **Deeper:** [01 · Deeper: signals, threads and UDP ports](01_the_context_deeper.ipynb)
#
# **Next:** [02 · Nodes](02_nodes.ipynb)
#
# **More:** [Domain IDs](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Domain-ID.html) and the [rclpy
# API](https://docs.ros.org/en/jazzy/p/rclpy/)

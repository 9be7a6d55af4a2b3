# %% [markdown]
# # 01 · The context
#
# A robot program must start before it can do anything, and it must end without dropping what the robot holds. One object
# takes care of both: the context.
#
# - **Minutes:** 40
# - **You need:** lesson [00](00_start_here.ipynb)
# - **You will be able to:**
#   - start and end ROS in a program
#   - say what works before, between and after
#   - say what decides which robots hear each other
#   - write a `main()` that ends well on Ctrl-C
# - **Left out:** what `spin` does inside (lesson 06), other signals and threads (the deeper notebook), lifecycle nodes

# %% [markdown]
# A museum at night. A robot walks its rounds until its program ends. We start it as a process of its own.

# %%
from lesson_nodes import night_guard
from workbook.lesson import start, stop
from workbook.ros import node_list

start(night_guard)
print("while it works: ", node_list())
stop()
print("after the end:  ", node_list())

# %% [markdown]
# Its **node** appeared, and after the end it is gone, without an error. That is less common than you would think. Many
# programs that you find on the web end with a page of error messages. At the end of this lesson, yours will not.

# %% [markdown] prediction="publish-after-shutdown"
# ## Predict
#
# Every rclpy program begins with `init` and ends with `shutdown`. Between them, this one makes a node and a publisher:
#
# ```python
# rclpy.init()
# guard = Node("museum_guard")
# radio = guard.create_publisher(String, "/museum/radio", 10)
# rclpy.shutdown()
# ```
#
# After these lines the program calls `radio.publish(String(data="burglar!"))`. What happens?
#
# - **a** It is sent: `shutdown` stops callbacks, it does not stop publishing.
#   ✗ `shutdown` ends the context, and the publisher needs it. Without a context nothing can be sent.
# - **b** Nothing, silently: no other program can receive it any more.
#   ✗ It is not silent. rclpy sees that the context is not valid any more, and says so.
# - **c** The call is never reached: `shutdown` refuses as long as there is a node.
#   ✗ `shutdown` does not look for nodes. It ends only the context. The node and its publisher stay, as objects without a
#   valid context.
# - **d** An error: the objects are still there, but their context is not.
#   ✓ The Python objects are still there, but the context that they belong to is not. `publish` raises an error.

# %%
from workbook.lesson import predict, reveal

predict("publish-after-shutdown")

# %% [markdown]
# ## Run it
#
# `rclpy.ok()` says whether the context is up. We ask before, between and after.

# %%
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.try_shutdown()  # only so that you can run this cell again

print("at first:       ", rclpy.ok())

rclpy.init()
guard = Node("museum_guard")
radio = guard.create_publisher(String, "/museum/radio", 10)
radio.publish(String(data="all quiet"))
print("after init:     ", rclpy.ok())

rclpy.shutdown()
print("after shutdown: ", rclpy.ok())

# %% [markdown]
# Now the call in question.

# %% id="publish-after-shutdown" tags=["raises-exception"]
radio.publish(String(data="burglar!"))

# %%
reveal("publish-after-shutdown")

# %% [markdown]
# ## Look inside
#
# `init` made a **context**, and `shutdown` ended it. A context holds what the nodes of one *process*
# share: their domain, the arguments from the command line, and what happens on Ctrl-C. Every node belongs to a context.
# You did not name it, because `rclpy.init()` makes the **default context**, and `Node(...)` takes that one.
#
# A context has three states, and it goes through them once: *not initialized* → *ok* → *shut down*. There is no way back.
# `rclpy.ok()` is true only in the middle one.
#
# What works in which state? This cell tries four calls in each.

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
# Each error says what is missing. `NotInitializedException`: there is no valid context. `RCLError`: the C library below
# rclpy refused, and here the reason is the same. `InvalidHandle`: the context is fine, but this node was destroyed.
#
# Note the last row. A node outlives its context as an object, and still knows its name. It can do nothing else.

# %% [markdown] prediction="three-contexts"
# ## Change it
#
# ### Experiment 1: three contexts in one notebook
#
# A process usually has one context. It may have more, and each can be on another **domain**, the number that you saw in
# lesson 00. Here are three robots in one process, each with a context of its own. `kitchen` and `hall` are on domain A,
# `garden` is on domain B. All three publish their names on the topic `/building/hello`, and subscribe to it. Who hears
# whom?
#
# - **a** None hears another one: each has a context of its own.
#   when `kitchen_hears == 0 and garden_hears == 0`
#   ✗ A context does not keep nodes apart. `kitchen` and `hall` are on one domain, so they meet, as two programs
#   would.
# - **b** `kitchen` and `hall` hear each other, and `garden` is alone.
#   when `kitchen_hears == 1 and garden_hears == 0`
#   ✓ The domain decides who hears whom. Two of the three contexts are on domain A.
# - **c** All hear all others: it is one process and one topic.
#   when `kitchen_hears == 2 and garden_hears == 2`
#   ✗ `garden` is on another domain. Nodes on different domains do not meet, not even within one process.

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
    strip(heard, end=5.5, noun="times"),
    "five seconds: kitchen and hall hear each other four times a second, nobody "
    "hears garden and garden hears nobody",
)

# %% [markdown]
# The domain decides, not the process and not the topic. Put `"garden": "A"` into `PLACES` and run both cells again.
#
# In a classroom this matters. By default, ROS uses domain 0. Put thirty laptops on one network, and *your* dashboard
# shows the battery of your neighbor's robot. So each desk sets a domain of its own, in the environment variable
# `ROS_DOMAIN_ID`. (`ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST` keeps everything on one machine.) Do not put the number
# into your code. Otherwise you have to edit the program to use it on another domain. These notebooks choose a free
# domain when they open.

# %% [markdown]
# ### Experiment 2: Ctrl-C
#
# While you develop, you stop most robot programs with Ctrl-C. Linux then sends a **signal**, SIGINT, and Python turns
# it into the exception `KeyboardInterrupt`. Here are three ways to write `main`. You find all of them on the web.

# %%
import inspect

from lesson_nodes import three_mains

print(
    inspect.getsource(three_mains)
    .split("if __name__")[0]
    .partition("NightGuard\n\n\n")[2]
)

# %% [markdown] prediction="after-ctrl-c"
# `guard.park()` folds the arms and prints `arms parked`. `spin` lets the node work.
#
# A program reports how it ended by its **exit code**: 0 means success, and any other number means trouble. Scripts,
# service managers and launch files read it. Which of the three programs end with 0 after Ctrl-C?
#
# - **a** `third_main` only
#   when `first != 0 and second != 0 and third == 0`
#   ✓ It catches what `spin` raises, and `try_shutdown` does not mind that the context is down already.
# - **b** All three: Ctrl-C is a normal way to end.
#   when `first == 0 and second == 0 and third == 0`
#   ✗ `first_main` does not catch the `KeyboardInterrupt`. It ends the program, and the exit code is not 0.
# - **c** `second_main` and `third_main`
#   when `first != 0 and second == 0 and third == 0`
#   ✗ `second_main` catches the `KeyboardInterrupt`, but then `rclpy.shutdown()` raises: Ctrl-C has shut the context
#   down already.
# - **d** None: after Ctrl-C the code is never 0.
#   when `first != 0 and second != 0 and third != 0`
#   ✗ The exit code is 0 whenever the program comes to its end without an exception, even after Ctrl-C.

# %%
predict("after-ctrl-c")

# %% [markdown]
# Each runs as a process of its own, and receives Ctrl-C in its first round.

# %% id="three-mains"
from workbook.lesson import run_program

ends = {
    name: run_program(three_mains, arguments=[name], interrupt_at="round 1")
    for name in ("first_main", "second_main", "third_main")
}
for name, end in ends.items():
    last_line = end.log.strip().splitlines()[-1].split(", at ")[0]
    print(f"{name}: exit code {end.exit}, arms parked: {'arms parked' in end.log}")
    print(f"    last line: {last_line}")
reveal(
    "after-ctrl-c",
    first=ends["first_main"].exit,
    second=ends["second_main"].exit,
    third=ends["third_main"].exit,
)

# %% [markdown]
# **`first_main`** never reaches the line after `spin`. On Ctrl-C `spin` does not return. It *raises*, and the exception
# leaves the function. The arms are still up. (130 is how shells write "ended by signal 2", and 2 is SIGINT.)
#
# **`second_main`** parks its arms. But then `rclpy.shutdown()` fails: *rcl_shutdown already called*. `rclpy.init`
# installed a handler for SIGINT, and that handler shuts the context down at once. You find this `main` in many
# tutorials. It looks fine, because the arms are down. But a service manager reads the exit code, and reports a crash.
#
# **`third_main`** calls `rclpy.try_shutdown()`. It shuts the context down if it is up, and otherwise does nothing. Its
# `except` names a second exception, which `spin` raises when the context is shut down from outside. Write this `main`.
#
# One caveat: `try_shutdown` first checks, then calls. Very rarely, rclpy's handler shuts the context down between the
# two, and the program ends as `second_main` does. That is a flaw of this rclpy. The judge of the exercise knows it, and
# does not count it.

# %% [markdown]
# ## When it goes wrong
#
# **Started twice.** One `init` at the top of a file, another in `main`:

# %% id="init-twice" tags=["raises-exception"]
rclpy.try_shutdown()
rclpy.init()
rclpy.init()

# %% [markdown]
# The context is up already. In a program, call `init` in `main` and nowhere else. In a notebook, where cells run again and
# again, use `init()` of `workbook.lesson`. It does nothing the second time.
#
# **A node before `init`.** Often the line stands at the top of a file, outside of `main`, so it runs first.

# %% id="node-before-init" tags=["raises-exception"]
rclpy.try_shutdown()
Node("early_bird")

# %% [markdown]
# **A node that was destroyed.** The context is up, and the call fails all the same:

# %% id="destroyed-node" tags=["raises-exception"]
rclpy.init()
guard = Node("retired_guard")
guard.destroy_node()
guard.get_name()

# %% [markdown]
# The error message calls the node a *Destroyable*. Most often `destroy_node()` is a line too early, before a last log
# or publish.
#
# **Two calls from other versions of ROS.** The first is a habit from ROS 1:

# %% id="positional-arguments" tags=["raises-exception"]
import sys

rclpy.try_shutdown()
rclpy.init(sys.argv)

# %% [markdown]
# Pass arguments by name: `rclpy.init(args=sys.argv)`. Without them, rclpy takes those of the command line.
#
# The second is from documents of a newer ROS:

# %% id="with-init" tags=["raises-exception"]
rclpy.try_shutdown()
with rclpy.init():
    guard = Node("guard")

# %% [markdown]
# In newer versions `init` returns an object for `with`. In Jazzy it returns `None`. Use `try` and `finally`. One
# caveat: the failing line *did* call `init` before it raised. So the context is up now, and the next `init` raises an
# error, too.

# %%
print(rclpy.ok())
rclpy.try_shutdown()

# %% [markdown]
# ## From a worked example to your own
#
# **Worked.** A robot waters plants. When it ends, it must close the valve, whatever happens. The pattern is the same for
# every program: `init`, make the node, spin in `try`, expect the two exceptions, clean up in `finally`.

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
# **Faded.** A delivery robot must lock its box at the end. Three places are blank. Fill them in and run both cells. The
# second one says how your program ended.

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

# %%
end = run_program(Path("courier.py"), interrupt_at="driving")
print("exit code 0:", end.exit == 0)
print("box locked: ", "box locked" in end.log)

# %% [markdown]
# **Your own.** In the [exercise](../exercises/01_the_context.ipynb) the night guard gets its `main()` from you. It is
# judged by a real Ctrl-C: how it ends, whether its arms are parked, and whether its node is gone.

# %% [markdown]
# ## Check yourself
#
# **1. `rclpy.shutdown()` was called, and the variable `guard` still holds a node. What can the node do?**
#
# <details><summary>a) Everything but listen</summary>
#
# ✗ Publishing raises an error as well, as you saw.
#
# </details>
# <details><summary>b) Say its name, and little else</summary>
#
# ✓ Yes. The object is still there. Its context is not valid any more, so it can neither publish nor make a publisher.
#
# </details>
# <details><summary>c) Everything, once <code>rclpy.init()</code> is called again</summary>
#
# ✗ A second `init` makes a new context. This node belongs to the old one, and there is no way back.
#
# </details>
#
# **2. Your program says `RuntimeError: Context.init() must only be called once`. What now?**
#
# <details><summary>a) Find the second call and remove it</summary>
#
# ✓ One `init`, in `main`. Often the other one is at the top of a file that you import.
#
# </details>
# <details><summary>b) Call <code>rclpy.shutdown()</code> before each <code>rclpy.init()</code></summary>
#
# ✗ `shutdown` itself raises an error if there is nothing to shut down. And nodes that were made in between lose their
# context.
#
# </details>
# <details><summary>c) Put it into <code>try</code> and <code>except</code> and go on</summary>
#
# ✗ The program would run, but two parts of it both try to start ROS. Find out why.
#
# </details>
#
# **3. `except KeyboardInterrupt: pass`, then `finally: rclpy.shutdown()`. What happens on Ctrl-C?**
#
# <details><summary>a) A clean end</summary>
#
# ✗ It looks like one, up to the last line: `RCLError`, exit code 1.
#
# </details>
# <details><summary>b) The program hangs</summary>
#
# ✗ No, it ends at once, but not well.
#
# </details>
# <details><summary>c) An error, because the context is down already</summary>
#
# ✓ rclpy's handler for SIGINT has shut it down. `rclpy.try_shutdown()` is made for this.
#
# </details>
#
# **4. Two students sit side by side. One starts a dashboard, and it shows the other one's robot. What is the remedy?**
#
# <details><summary>a) Another domain for each desk</summary>
#
# ✓ Programs on different domains do not meet at all. `export ROS_DOMAIN_ID=17` in the terminal, once.
#
# </details>
# <details><summary>b) A context of its own for each program</summary>
#
# ✗ They have that anyway: they are two processes. Kitchen and hall had one each, and heard each other.
#
# </details>
# <details><summary>c) Other names for the topics</summary>
#
# ✗ That helps for this one topic. Their nodes would still meet everywhere else, in all tools and logs.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Copy the prompt for an AI assistant, or discuss it with a colleague. State your own view first.
#
# ```text
# I program a robot with ROS 2 Jazzy in Python (rclpy). My robot arm is controlled by a
# node. On Ctrl-C it should move slowly to its rest position, publish "parked" on a
# topic, and then end. I put all that into `except KeyboardInterrupt`. Why does it not
# work, and what are my options? Name only functions that exist in rclpy for Jazzy.
# ```
#
# <details><summary>What a good answer contains</summary>
#
# By default, rclpy's handler shuts the context down at about the moment at which Python raises the exception. From then
# on nothing can be published and no timer runs. So neither the slow movement nor the message can happen there. One way is
# `SignalHandlerOptions.NO`: the context stays up until the program shuts it down. Then keep spinning in the `except` branch
# until the arm has arrived, publish, and call `try_shutdown()`. (A node without a timer may not wake up on Ctrl-C.) Another
# way is a service or topic "park", called first, and Ctrl-C after it. A good answer also asks what happens when the
# process is killed or loses its power: then no `finally` runs. The motor controller must be safe by itself.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Two claims you may meet. Both are wrong: each was tried with the rclpy of this course.
#
# - **`with rclpy.init():`:** Newer versions have it. In Jazzy it raises a `TypeError`.
# - **Publish "parked" in `except KeyboardInterrupt` or `finally`:** With the default signal handlers the context is
#   shut down at that moment. `publish` then raises an error, unless it happens to run just before that.
#
# </details>

# %% [markdown]
# ## Take away
#
# - A context holds what the nodes of a process share. It goes once from not initialized to ok to shut down, and never
#   back.
# - `rclpy.init()` once, in `main`, before the first node. After `shutdown` or `destroy_node`, a node can do nothing.
# - The domain decides who hears whom. Set it outside of the program, with `ROS_DOMAIN_ID`.
# - On Ctrl-C rclpy shuts the context down by itself, and `spin` raises. Clean up in `finally`, with `try_shutdown()`.
# - Judge how a program ends from outside: its exit code, its log, and whether its node is gone.
#
# **Before:** [00 · Start here](00_start_here.ipynb)
#
# **Deeper:** [01 · Deeper: signals, threads and UDP ports](01_the_context_deeper.ipynb)
#
# **Next:** [02 · Nodes](02_nodes.ipynb), the parts that a context holds
#
# **More:** [Domain IDs](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Domain-ID.html), and what
# [rclpy](https://docs.ros.org/en/jazzy/p/rclpy/) offers.

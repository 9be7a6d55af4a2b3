# %% [markdown]
# # 01 · Deeper: signals, threads and UDP ports
#
# In the field, a robot's programs are stopped by a service manager, not by Ctrl-C. How does a program end in that case,
# and how can it still publish a last message?
#
# - **Minutes:** 15
# - **You need:** lesson [01](01_the_context.ipynb)
# - **You will be able to:**
#   - say which exception `spin` raises, if any, for each way to end a program
#   - publish a last message on Ctrl-C
# - **Not covered:** lifecycle nodes, how `spin` works (lesson 06)

# %% [markdown]
# This notebook is optional. Later lessons don't depend on it.

# %% [markdown] prediction="sigterm"
# ## Predict
#
# Ctrl-C sends SIGINT, but `systemctl stop` and `docker stop` send a different signal, **SIGTERM**. What does
# `rclpy.spin(guard)` raise on SIGTERM?
#
# - **a** `KeyboardInterrupt`, as with Ctrl-C
#   when `came_out == 'KeyboardInterrupt'`
#   ✗ Python raises `KeyboardInterrupt` only for SIGINT, the signal that Ctrl-C sends.
# - **b** Nothing: Linux ends the process right away.
#   ✗ Linux does that to a program that has no handler for SIGTERM. But `rclpy.init` installs one.
# - **c** `ExternalShutdownException`
#   when `came_out == 'ExternalShutdownException'`
#   ✓ On SIGTERM, rclpy shuts the context down. Then `spin` raises this exception, because its context is no longer
#   valid.

# %%
from workbook.lesson import predict, reveal

predict("sigterm")

# %% [markdown]
# ## Run it
#
# This program spins the night guard's node until one of three events ends `spin`: Ctrl-C, SIGTERM, or a call to
# `rclpy.shutdown()` in another thread.

# %%
import inspect

from lesson_nodes import ends_of_spin

print(inspect.getsource(ends_of_spin.main))

# %% id="what-comes-out-of-spin" tags=["nbval-ignore-output"]
from workbook.lesson import run_program

came_out, still_ok = {}, set()
for cause in ends_of_spin.CAUSES:
    for way in ends_of_spin.WAYS:
        log = run_program(ends_of_spin, arguments=[cause, way]).log.strip().splitlines()
        came_out[cause, way] = log[-1]
        still_ok.add(log[-2].removeprefix("ok: "))
        print(f"{cause:<21} {way:<14} {log[-1]}")
reveal("sigterm", came_out=came_out["SIGTERM", "rclpy.spin"])

# %%
on_ctrl_c = {what for (cause, _), what in came_out.items() if "SIGINT" in cause}
print("raised on Ctrl-C, both ways:", *on_ctrl_c)
print("rclpy.ok() afterward, in all six runs:", *still_ok)

# %% [markdown]
# So a well-written `main` catches both exceptions. `ExternalShutdownException` means that the context was shut down
# from outside while `spin` was running. After `spin`, the context was already shut down in all six runs, so
# `try_shutdown` is the right call at the end.
#
# If another thread shuts the context down, `rclpy.spin` may detect the shutdown between two iterations. It then returns
# without an exception. So if code must always run, put it in `finally`.
#
# SIGTERM causes a race in this rclpy version: the signal wakes `spin` up a moment *before* the context is shut down. In
# some runs, you see an `RCLError`, and an idle node may even keep sleeping. Use SIGINT if you can choose. ROS's launch
# system sends SIGINT first. In a systemd service file, write `KillSignal=SIGINT`.

# %% [markdown]
# ## Look inside
#
# When can other programs discover yours? A program that uses DDS listens on its domain's **UDP ports**. The next cell
# creates a context and a node, and then shuts down the context and destroys the node. At the same time, a thread checks
# a hundred times a second whether Linux lists these ports as open.

# %%
import threading
import time

import rclpy
from rclpy.context import Context
from rclpy.node import Node
from workbook.ros.domains import dds_port_range, lease_domain, udp_ports_in_use

watched: list[tuple[float, bool, bool]] = []
marks: dict[str, float] = {}
over = threading.Event()
lease = lease_domain()  # a domain that no other program uses
context = Context()
began = time.monotonic()


def watch() -> None:
    ports = dds_port_range(lease.domain_id)
    while not over.wait(0.01):
        is_open = not udp_ports_in_use().isdisjoint(ports)
        watched.append((time.monotonic() - began, context.ok(), is_open))


def step(name, action) -> None:
    """Do something, and give the watcher half a second to see it."""
    marks[name] = time.monotonic() - began
    action()
    time.sleep(0.5)


watcher = threading.Thread(target=watch)
watcher.start()
step("Context()", lambda: None)
step("init", lambda: rclpy.init(context=context, domain_id=lease.domain_id))
porter: list[Node] = []
step("Node(…)", lambda: porter.append(Node("porter", context=context)))
step("shutdown", lambda: rclpy.shutdown(context=context))
step("destroy_node", lambda: porter[0].destroy_node())
over.set()
watcher.join()
lease.release()

# %%
from workbook.pictures.figures import figure, show

fig, (ok_axes, port_axes) = figure(6.6, 3.2, rows=2)
moments = [moment for moment, _, _ in watched]
ok_axes.step(moments, [ok for _, ok, _ in watched], linewidth=2.4)
port_axes.step(
    moments, [is_open for _, _, is_open in watched], color="#208a3c", linewidth=2.4
)
titles = (
    "The context is valid from init to shutdown",
    "UDP ports are open while there is a node",
)
for axes, title in zip((ok_axes, port_axes), titles, strict=True):
    axes.set(
        yticks=[0, 1],
        yticklabels=["no", "yes"],
        ylim=(-0.25, 1.25),
        xticklabels=[],
        title=title,
    )
    for moment in marks.values():
        axes.axvline(moment, color="#787878", linewidth=1, linestyle=":")
ok_axes.set_xticks([])
port_axes.set_xticks(list(marks.values()), list(marks))
port_axes.tick_params(axis="x", rotation=20)
show(
    fig,
    "context.ok() is true from init to shutdown; UDP ports are open from the first "
    "node to its end",
)

# %%
names = list(marks)
for what, following in zip(names, [*names[1:], None], strict=True):
    end = marks[following] if following else float("inf")
    _, ok, is_open = [sample for sample in watched if marks[what] < sample[0] < end][-1]
    state, ports = "valid" if ok else "not valid", "open" if is_open else "closed"
    print(f"after {what:<13} context {state + ',':<11} UDP ports {ports}")

# %% [markdown]
# `init` alone doesn't make your program visible to others. The ports open when you create the first **node**, and they
# close when the last node is destroyed. (Elsewhere, you may read that `init` connects to ROS and `shutdown`
# disconnects. In this course's build of ROS 2, that's not quite true.)

# %% [markdown]
# ## When it goes wrong
#
# **A last message that isn't sent.** The guard tries to publish "good night" in the `except` block for Ctrl-C.

# %%
from lesson_nodes import last_words

print(inspect.getsource(last_words.main))


# %% id="last-words"
def show_end(log: str) -> None:
    for line in log.strip().splitlines():
        if line.startswith(("context", "said", "Failed", "rclpy")) or line.endswith(
            "good night"
        ):
            print("   ", line.split(", at ")[0])


for handled_by in ("ALL", "NO"):
    print(
        "rclpy handles Ctrl-C:"
        if handled_by == "ALL"
        else "Python alone handles Ctrl-C:"
    )
    show_end(
        run_program(last_words, arguments=[handled_by], interrupt_at="round 1").log
    )

# %% [markdown]
# rclpy shuts the context down in a separate thread, while Python raises the exception. The guard waited half a second
# before it published, and by then, the context had been shut down. Its log message still reached the terminal, but the
# publisher raised an exception.
#
# With `SignalHandlerOptions.NO`, rclpy leaves the signal to Python, and the context stays valid until *you* shut it
# down. That option has two drawbacks: a node without a timer doesn't wake up on Ctrl-C, and SIGTERM ends the process
# immediately.
#
# **Your turn.** The guard should publish its last message on Ctrl-C, but rclpy should still handle SIGTERM. Which
# member of `SignalHandlerOptions` do you need?

# %% id="your-option"
from workbook.lesson import yours

option = ...  # TODO: "ALL", "NO", "SIGINT", or "SIGTERM"

ended = ...
if option is not ...:
    end = run_program(last_words, arguments=[option], interrupt_at="round 1")
    ended = option, end.log.strip().splitlines()[-1]
yours(ended, ("SIGTERM", "said good night"), "Name the signal that rclpy handles.")

# %% [markdown]
# **Notebooks behave differently.** In these notebooks, only Python handles SIGINT, the signal that the stop button (■)
# sends. So your nodes survive it. The next cell sends SIGINT to the notebook's own process. Then it runs the same code
# as a separate program:

# %% id="interrupt-in-the-kernel"
import os
import signal

from lesson_nodes import interrupted_sleep

rclpy.try_shutdown()
rclpy.init()
try:
    os.kill(os.getpid(), signal.SIGINT)
    time.sleep(5)
except KeyboardInterrupt:
    print("interrupted")
print("in the notebook, the context is", "valid" if rclpy.ok() else "shut down")

print(run_program(interrupted_sleep).log.strip())
rclpy.try_shutdown()

# %% [markdown]
# The same code gives two different results. So don't use a notebook to find out how a program ends. Run the program
# itself.

# %% [markdown]
# ## Take away
#
# - Other programs can discover yours from the moment it creates its first node until its last node is destroyed.
# - On Ctrl-C, `spin` raises `KeyboardInterrupt`. On SIGTERM, it usually raises `ExternalShutdownException`. Catch both.
# - If another thread shuts the context down, `rclpy.spin` may simply return. So clean up in `finally`.
# - By default, Ctrl-C shuts the context down. To publish a last message anyway, use `SignalHandlerOptions.NO` or
#   `.SIGTERM`.
#
# **Before:** [01 · The context](01_the_context.ipynb)
#
# **Next:** [02 · Nodes](02_nodes.ipynb)
#
# **More:** the [rclpy API](https://docs.ros.org/en/jazzy/p/rclpy/)

# %% [markdown]
# # 12 · Services
#
# You tell a robot to stand still. How do you find out whether it did? With a service: you send a request, and the
# service returns a response.
#
# - **Minutes:** 50
# - **You need:** lessons 02 to 06 (nodes, topics, timers, spin), and lesson 10 (a slow callback holds up the others)
# - **You will be able to:**
#   - offer a service and call it
#   - choose between a topic and a service
#   - call a service from a callback
#   - explain what happens to a pending call when its server exits
# - **Not covered:** actions (long jobs with progress reports), custom service types, parameters

# %% [markdown]
# The first cell starts a robot, which stands still and offers a **service**, `/robot/wave`. You send the service a
# *request* (`True` to wave, `False` to stop) and receive a *response*.

# %%
from lesson_nodes import waves_when_asked
from workbook.lesson import start
from workbook.ros import node_info

print("started", start(waves_when_asked))
for service, kind in node_info("/waves_when_asked").serves:
    if service.startswith("/robot"):
        print("it offers", service, "of type", kind)

# %%
from rclpy.node import Node
from std_srvs.srv import SetBool

from workbook.lesson import fresh, init, run, watch_robot

init()


class RemoteControl(Node):
    """Can ask the robot to wave."""

    def __init__(self) -> None:
        super().__init__("remote_control")
        self.wave = self.create_client(SetBool, "/robot/wave")


remote = fresh(RemoteControl)
remote.wave.wait_for_service(timeout_sec=10.0)

waved = remote.wave.call_async(SetBool.Request(data=True))
response = await run(remote, until=waved, seconds=10)
print(f"success={response.success}, {response.message!r}")
await watch_robot(seconds=4)

# %% [markdown]
# The node that sends the request has a **client**; the node that responds has a **server**. The response confirms that
# your request was handled. Messages on a topic aren't confirmed.
#
# [the same without helpers: start, init, fresh, run, spin_for]
#
# Now send the same request again, then the opposite one:

# %%
from workbook.lesson import stop

for words, wanted in (("wave", True), ("stand still", False)):
    request = SetBool.Request(data=wanted)
    response = await run(remote, until=remote.wave.call_async(request), seconds=10)
    print(f"{words}: {'done' if response.success else 'refused'}, {response.message!r}")
stop()

# %% [markdown]
# A server can refuse a request. The `SetBool` response has two fields for that: `success` and `message`. The package
# `std_srvs` defines three service types: `Empty` (do it), `Trigger` (do it and report the outcome), and `SetBool`
# (switch something on or off).

# %% [markdown] prediction="call-in-a-callback"
# ## Predict
#
# So far, the notebook has sent the requests. On a robot, a node sends them from a callback. This node publishes a
# heartbeat ten times a second. Twice a second, it asks the robot to test itself. The client's `call` method sends the
# request, waits for the response, and returns it.
#
# ```python
# class HeartAndQuestion(Node):
#     def __init__(self) -> None:
#         super().__init__("heart_and_question")
#         self.heart = self.create_publisher(String, "/robot/heartbeat", 10)
#         self.self_test = self.create_client(Trigger, "/robot/self_test")
#         self.create_timer(0.1, self.beat)
#         self.create_timer(0.5, self.ask)
#
#     def beat(self) -> None:
#         self.heart.publish(String(data="beat"))
#
#     def ask(self) -> None:
#         response = self.self_test.call(Trigger.Request())
#         print("well" if response.success else "faulty")
#
# rclpy.spin(HeartAndQuestion())
# ```
#
# The server is running and responds within a millisecond. What happens in the first two seconds?
#
# - **a** The node sends one request. After that: no response, no beat, no error.
#   when `asked <= 1 and answered == 0`
#   ✓ The callback waits for the response, and the executor waits for the callback. That's a deadlock.
# - **b** About twenty beats and four responses.
#   when `answered >= 3 and beats >= 18`
#   ✗ The response does reach the node after a millisecond. But the executor must take it, and the executor's only
#   thread is waiting in `call`.
# - **c** Four responses, but the heartbeat sometimes skips a beat while `call` waits.
#   when `answered >= 3 and beats < 18`
#   ✗ The beats aren't just delayed. The thread that would have to take the response is waiting for it, forever.
# - **d** An exception: rclpy doesn't allow `call` in a callback.
#   ✗ rclpy doesn't check where you use `call`. It waits without a time limit.

# %%
from workbook.lesson import predict, reveal

predict("call-in-a-callback")

# %% [markdown]
# ## Run it
#
# `try_out` runs the node in a separate process for two seconds and records its messages. The node also publishes a
# message on `/robot/asked` for each request, and one on `/robot/answered` for each response. A separate thread spins
# the server's node.

# %% id="deadlock"
from lesson_nodes import heart_and_question
from workbook.lesson import arrivals
from workbook.lesson.service_trials import (
    ANSWERED,
    ASKED,
    HEART,
    answers,
    heart,
    hearts_picture,
    questions_picture,
    try_all,
    try_out,
)

asking = try_out(heart_and_question, ("call", "default", 1))
print("requests: ", len(arrivals(asking, ASKED)))
print("responses:", len(arrivals(asking, ANSWERED)))
print("the heart", heart(asking))
print("what it printed:", repr(asking.process.log))
reveal(
    "call-in-a-callback",
    asked=len(arrivals(asking, ASKED)),
    answered=len(arrivals(asking, ANSWERED)),
    beats=len(arrivals(asking, HEART)),
)

# %%
questions_picture(
    asking,
    "one request, and after it nothing",
    "a few heartbeats, one request, and then nothing on all three lines",
)

# %% [markdown]
# The program waits until you kill it. This is a **deadlock**: two parties are waiting for each other, so neither can
# continue.

# %% [markdown]
# ## Look inside
#
# Here's the path that the response takes, drawn as in lesson 04. Like a subscription, a client has a queue, which holds
# its responses.

# %% id="machine"
from workbook.lesson import record_machine, show_machine

case = {"way": "call", "group": "default", "threads": 1}
show_machine(
    record_machine(heart_and_question, seconds=1.6, **case),
    "the heart beats until ask_by_call begins; the response comes and waits in the "
    "queue of the client; the only thread stays in ask_by_call, and ticks are missed",
)

# %% [markdown]
# The response is in the queue, and the **executor** has to take it from there. But its only thread is running the
# callback, and the callback is waiting in `call`. So `call` waits for the executor, and the executor waits for the
# callback. The heartbeat timer has to wait, too.
#
# ### Two conditions for taking a response
#
# The executor can take a response when two things are free:
#
# - **One of the executor's threads.** `spin` uses one thread. A `MultiThreadedExecutor` has several.
# - **The client's callback group.** By default, all of a node's callbacks are in one *default group*. That group is
#   *mutually exclusive*: only one of its callbacks runs at a time. A waiting callback still occupies its group.
#
# Whether a callback occupies its thread and its group depends on how it waits:
#
# | in the callback | occupies its thread | occupies its group |
# |---|---|---|
# | `client.call(request)` | yes | yes |
# | `await client.call_async(request)` | no | yes |
# | `client.call_async(request)`, then `add_done_callback` | no | no |
#
# `call_async` sends the request and returns right away. Its return value is a **future**, an object that will hold the
# response later. `await` pauses an `async def` method until the future is done, and frees the thread in the meantime.
# `add_done_callback` doesn't pause anything: it registers a function that the executor calls when the future is done.

# %% [markdown]
# ### Seven ways to wait
#
# Before you run the next cell, use both conditions to predict for each case whether the responses arrive. "Own" means
# that the client has its own callback group. Everything else is in the default group.
#
# | case | how the callback waits | client's group | threads |
# |---|---|---|---|
# | 1 | `call` | default | 1 |
# | 2 | `call` | default | 4 |
# | 3 | `call` | own | 4 |
# | 4 | `call` with `timeout_sec=0.4` | default | 1 |
# | 5 | `await` | default | 4 |
# | 6 | `await` | own | 1 |
# | 7 | `spin_until_future_complete`, for 0.4 s | default | 1 |
#
# In the output, `limps` means that the node misses heartbeats while a call is pending.

# %% id="seven-cases"
CASES = [
    ("call", "default", 1),
    ("call", "default", 4),
    ("call", "own", 4),
    ("call_timeout", "default", 1),
    ("await", "default", 4),
    ("await", "own", 1),
    ("spin_until", "default", 1),
]

seven = try_all(heart_and_question, CASES)
print("   way            group    threads   responses  heart")
for number, (case, seen) in enumerate(zip(CASES, seven, strict=True), start=1):
    way, group, threads = case
    case_text = f"{number}  {way:<14} {group:<8} {threads:^7}"
    print(f"{case_text}   {answers(seen):<9}  {heart(seen)}")

# %%
titles = [
    f"{number}: {way}, {group}, {threads}"
    for number, (way, group, threads) in enumerate(CASES, start=1)
]
named = dict(zip(titles, seven, strict=True))
hearts_picture(
    named,
    "heart and responses go on only where the client has a group of its own",
    "heartbeats of the seven cases: they go on only where the client has a group "
    "of its own; they limp where the wait "
    "has a time-out, and stop elsewhere",
)

# %% [markdown]
# The two conditions explain all seven results:
#
# - **1:** Neither a thread nor the group is free. **2:** Three threads are free, but the group isn't. **3:** Both are
#   free.
# - **4:** This isn't a deadlock, but each call waits the full 0.4 s and returns `None`. The response is in the queue
#   the whole time.
# - **5:** `await` frees the thread but still occupies the group. **6:** Because the client has its own group, one
#   thread is enough.
# - **7:** The callback spins its own node, but the group is occupied. So the wait times out, as in case 4.
#
# Here's how to give a client its own group:
#
# ```python
# from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
#
# self.self_test = self.create_client(
#     Trigger, "/robot/self_test", callback_group=MutuallyExclusiveCallbackGroup()
# )
# ```
#
# **Your turn.** Write the two conditions as one line of Python. It has to agree with all seven results.

# %% id="your-conditions"
from workbook.lesson import yours


def come(way: str, group: str, threads: int) -> bool:
    """Return whether the responses come: a thread is free, and the group is free."""
    return ...  # TODO: combine way == "await", threads > 1, and group != "default"


yours(
    [come(*case) for case in CASES],
    [answers(seen) == "come" for seen in seven],
    '(way == "await" or threads > 1) and group != "default"',
)

# %% [markdown]
# ### Topic or service?
#
# | question | topic | service |
# |---|---|---|
# | Who takes part? | any number of publishers and subscriptions | one client sends a request, one server responds |
# | Is arrival confirmed? | no | yes, by the response |
# | When does data flow? | when there's something new, or at a fixed rate | on request |
# | If the other side is missing | by default, the message is lost | see experiment 3 |
# | Good for | joint angles, battery, camera, status | switch on, reset, self-test, "take an image now" |
#
# If the work takes more than about a second ("walk to the kitchen"), use an
# *action*, which reports progress and can be canceled.

# %% [markdown] prediction="other-groups"
# ## Change it
#
# ### Experiment 1: other groups and threads
#
# In a *reentrant* group, any number of callbacks can run at the same time. In the three cases below, no client is in
# the default group. In the two reentrant cases, the client's group also contains the timer whose callback makes the
# call.
#
# - `call`, own group, 1 thread
# - `call`, reentrant group, 4 threads
# - `await`, reentrant group, 1 thread
#
# In which cases do responses arrive?
#
# - **a** In all three, because no client is in the default group.
#   when `case_1 and case_2 and case_3`
#   ✗ A free group isn't enough. In the first case, the only thread is waiting in `call`, so no thread can take the
#   response.
# - **b** Only in the second: it has several threads and a reentrant group.
#   when `not case_1 and case_2 and not case_3`
#   ✗ The third case has only one thread, but `await` frees it, and the reentrant group lets the executor take the
#   response.
# - **c** Only in the first.
#   when `case_1 and not case_2 and not case_3`
#   ✗ In the first case, the client's group is free, but the only thread is waiting in `call`.
# - **d** In the second and third.
#   when `not case_1 and case_2 and case_3`
#   ✓ `call` blocks its thread, so it needs a second thread and a free group. `await` frees its thread, so a free group
#   is enough.

# %%
predict("other-groups")

# %%
# Turn these knobs.
OTHERS = [("call", "own", 1), ("call", "reentrant", 4), ("await", "reentrant", 1)]

others = try_all(heart_and_question, OTHERS)
for case, seen in zip(OTHERS, others, strict=True):
    way, group, threads = case
    happens = f"responses {answers(seen)}, the heart {heart(seen)}"
    print(f"{way:<8} {group:<10} threads={threads}: {happens}")
reveal(
    "other-groups",
    case_1=answers(others[0]) == "come",
    case_2=answers(others[1]) == "come",
    case_3=answers(others[2]) == "come",
)

# %% [markdown] prediction="slow-server"
# ### Experiment 2: a slow server
#
# Now the server takes 0.35 s to respond instead of a millisecond. In all three cases below, the responses arrive. The
# heartbeat timer is in the default group. In which cases does it keep firing *while* a call is pending?
#
# - `call`, own group, 4 threads
# - `await`, own group, 1 thread
# - done callback, default group, 1 thread
#
# Options:
#
# - **a** In all three, because the responses always arrive.
#   when `case_1 and case_2 and case_3`
#   ✗ The responses do arrive. But in two cases, the waiting callback occupies the default group, which also contains
#   the heartbeat timer.
# - **b** Only in the first: it has threads to spare.
#   when `case_1 and not case_2 and not case_3`
#   ✗ It does have threads to spare. But the callback that waits in `call` occupies the default group, and the heartbeat
#   timer needs that group.
# - **c** Only in the third.
#   when `not case_1 and not case_2 and case_3`
#   ✓ The callback only sends the request and returns. So the group is free right away, and the timer can fire.
# - **d** In the second and third: neither blocks a thread.
#   when `not case_1 and case_2 and case_3`
#   ✗ `await` frees the thread, but its callback occupies the default group until the response arrives.

# %%
predict("slow-server")

# %%
SLOW = [("call", "own", 4), ("await", "own", 1), ("done_callback", "default", 1)]

slow = try_all(heart_and_question, SLOW, server_takes_s=0.35)
for case, seen in zip(SLOW, slow, strict=True):
    print(f"{case[0]:<14} responses {answers(seen)}, the heart {heart(seen)}")
reveal(
    "slow-server",
    case_1=heart(slow[0]) == "beats",
    case_2=heart(slow[1]) == "beats",
    case_3=heart(slow[2]) == "beats",
)
hearts_picture(
    {
        f"{way}, {group} group": seen
        for (way, group, _), seen in zip(SLOW, slow, strict=True)
    },
    "beside a slow server, only the done callback leaves the heart alone",
    "heartbeats beside a slow server: a line for each of the three cases, "
    "with what became of heart and responses",
)

# %% id="machine-of-await"
case = {"way": "await", "group": "own", "threads": 1, "server_takes_s": 0.35}
show_machine(
    record_machine(heart_and_question, seconds=1.4, **case),
    "ask_by_await pauses and its thread waits in the wait set; the heart has no place "
    "there, and misses ticks until the response comes",
)

# %% [markdown]
# Only the done callback leaves the heartbeat undisturbed. With `call` and `await`, the waiting callback occupies the
# default group. The heartbeat timer is in that group, too, so the timer can't fire. A callback that only sends the
# request returns right away and frees the group.
#
# In most nodes, **use `call_async`, add a done callback, and return.** This needs no extra threads or groups, and can't
# cause a deadlock. (The done callback isn't in *any* group. With several threads, it may run at the same time as any
# other callback, so protect shared data with a lock.)

# %% [markdown] prediction="server-dies"
# ### Experiment 3: the server process exits
#
# This server never responds, and its process exits while our call is pending. What happens to the client's future?
#
# - **a** The future is done and raises an exception.
#   ✗ ROS doesn't notify the client that the server has exited, so nothing sets an exception on the future.
# - **b** It's never done, and the client isn't notified.
#   when `not old_call_is_done`
#   ✓ A service call has no timeout, and ROS doesn't report the server's exit. So your client needs its own time limit.
# - **c** It's done, and its result is `None`.
#   ✗ A future is done only when the response has arrived. No response has, so the future has no result, not even
#   `None`.
# - **d** It isn't done yet, but a new server with the same name would respond to the request.
#   when `old_call_is_done`
#   ✗ Only the old server received the request. A new one never gets it.

# %%
predict("server-dies")

# %%
import time

from std_srvs.srv import Trigger

from lesson_nodes import self_test_server
from workbook.lesson import about, spin_for


class Asker(Node):
    """Can ask for a self-test."""

    def __init__(self) -> None:
        super().__init__("asker")
        self.self_test = self.create_client(Trigger, "/robot/self_test")


def state(future) -> str:
    """Whether a call is done, as text."""
    return "done" if future.done() else "open"


start(self_test_server, pattern="never")
asker = fresh(Asker)
asker.self_test.wait_for_service(timeout_sec=10.0)
sent = time.monotonic()
future = asker.self_test.call_async(Trigger.Request())
spin_for(asker, seconds=1.0)

stop(self_test_server)
spin_for(asker, seconds=10.0, until=lambda: not asker.self_test.service_is_ready())
print("the server is gone: the call is", state(future))

start(self_test_server, pattern="ok")
asker.self_test.wait_for_service(timeout_sec=10.0)
spin_for(asker, seconds=1.0)
print("a new server is there: the old call is", state(future))
waited = about(time.monotonic() - sent, "s ago", between=(2, 45))
print("the request was sent", waited)
reveal("server-dies", old_call_is_done=future.done())

# %%
asker.self_test.remove_pending_request(future)
future = asker.self_test.call_async(Trigger.Request())
response = await run(asker, until=future, seconds=10)
print("asked again:", response.message)
stop()

# %% [markdown]
# The client isn't notified that the server is gone, so the call stays open forever. `service_is_ready()` tells you
# whether a server exists *now*, not whether your pending call can still succeed. So set your own time limit. When it
# expires, drop the call with `remove_pending_request(future)`, and send a new request or raise an alarm.

# %% [markdown]
# ## When it goes wrong
#
# **A misspelled service name.** The name `/robot/selftest` lacks the underscore, so no server offers it.


# %% id="no-server"
class Hasty(Node):
    """Asks for a self-test, and does not check whether a server is there."""

    def __init__(self) -> None:
        super().__init__("hasty")
        self.self_test = self.create_client(Trigger, "/robot/selftest")


hasty = fresh(Hasty)
future = hasty.self_test.call_async(Trigger.Request())
spin_for(hasty, seconds=1.0)
print("after a second, the call is", state(future))

# %% [markdown]
# rclpy raises no error, because a server with that name might still start. (Even then, this request would be lost.) To
# check for a server, call `wait_for_service`, which returns `False` if none appears in time. Always pass a timeout.
# Because `wait_for_service` blocks, call it before you spin, never in a callback.
#
# **Your turn.** Check whether the client in `hasty` has a server. Wait at most one second.

# %% id="your-wait"
is_there = ...  # TODO: what wait_for_service returns

yours(is_there, False, "hasty.self_test.wait_for_service(timeout_sec=1.0)")

# %% [markdown]
# **Reading the result too early.** `call_async` returns right away, so the next line runs before the response arrives.

# %% id="too-early" tags=["raises-exception"]
start(self_test_server)
asker = fresh(Asker)
asker.self_test.wait_for_service(timeout_sec=10.0)

future = asker.self_test.call_async(Trigger.Request())
print("well" if future.result().success else "faulty")

# %% [markdown]
# Until a future is done, its result is `None`, so the error message mentions `NoneType` rather than the future. Read
# the result in a done callback. Outside callbacks, use `rclpy.spin_until_future_complete(node, future)` in a program,
# or `run` in this notebook.
#
# **Your turn.** Complete the done callback. It receives the future, which is done by then.

# %% id="your-done-callback"
received = []


def on_answer(future) -> None:
    received.append(...)  # TODO: the response's message


answered = asker.self_test.call_async(Trigger.Request())
answered.add_done_callback(on_answer)
await run(asker, until=lambda: received, seconds=10)
stop()
yours(received, [answered.result().message], "future.result().message")

# %% [markdown]
# **A handler that doesn't return the response.** rclpy passes the request and an empty response to the server's
# callback, the *handler*. The handler has to fill in the response *and return it*. This handler only fills it in.


# %% id="no-return"
class Forgetful(Node):
    """Greets when asked, and forgets something."""

    def __init__(self) -> None:
        super().__init__("forgetful")
        self.create_service(Trigger, "/robot/greet", self.on_greet)

    def on_greet(self, request: Trigger.Request, response: Trigger.Response) -> None:
        response.success = True
        response.message = "Hello!"


class Guest(Node):
    """Wants to be greeted."""

    def __init__(self) -> None:
        super().__init__("guest")
        self.greet = self.create_client(Trigger, "/robot/greet")


robot, guest = fresh(Forgetful), fresh(Guest)
guest.greet.wait_for_service(timeout_sec=10.0)
greeting = guest.greet.call_async(Trigger.Request())
try:
    await run(robot, guest, until=greeting, seconds=10)
except TypeError as error:
    print("the server ends with:", repr(error))
print("the guest's call is", state(greeting))

# %% [markdown]
# rclpy got `None` instead of a response, so it raised a `TypeError` without a message. In an ordinary program, the
# traceback ends with a bare `TypeError`, and the *server* process exits. The client's call stays open, as in experiment
# 3. One line fixes the handler:


# %%
class Polite(Forgetful):
    """Greets when asked."""

    def on_greet(
        self, request: Trigger.Request, response: Trigger.Response
    ) -> Trigger.Response:
        response.success = True
        response.message = "Hello!"
        return response


robot, guest = fresh(Polite), fresh(Guest)
guest.greet.wait_for_service(timeout_sec=10.0)
greeted = guest.greet.call_async(Trigger.Request())
response = await run(robot, guest, until=greeted, seconds=10)
print("now it says:", response.message)

# %% [markdown]
# **Spinning inside a callback.** Let's give the client in case 7 its own group, and the executor four threads. Now only
# the first response arrives:

# %% id="spin-inside"
inside = try_out(heart_and_question, ("spin_until", "own", 4))
print("responses:", len(arrivals(inside, ANSWERED)))
print("after that the heart", heart(inside))
questions_picture(
    inside,
    "one response, and after it nothing",
    "some heartbeats, one request, one response, and then silence",
)

# %% [markdown]
# `rclpy.spin_until_future_complete` moves the node from the executor that was spinning it to the *global* executor, and
# removes it from there when the future is done. After that, nothing spins the node. So use this function in `main()`,
# before `spin`, and never in a callback.

# %% [markdown]
# ## From a worked example to your own
#
# **Worked example.** Twice a second, an arm node sends its gripper a request to close or to open. Instead of waiting,
# the arm stores the call's future in an attribute, and the done callback records the result.


# %%
class Gripper(Node):
    """Closes and opens when asked."""

    def __init__(self) -> None:
        super().__init__("gripper")
        self.create_service(SetBool, "/gripper/close", self.on_close)

    def on_close(
        self, request: SetBool.Request, response: SetBool.Response
    ) -> SetBool.Response:
        response.success = True
        response.message = "closed" if request.data else "open"
        return response


class Arm(Node):
    """Has the gripper closed and opened in turn."""

    def __init__(self) -> None:
        super().__init__("arm")
        self.done: list[str] = []
        self.close = True
        self.open_call = None
        self.gripper = self.create_client(SetBool, "/gripper/close")
        self.create_timer(0.5, self.move)

    def move(self) -> None:
        self.open_call = self.gripper.call_async(SetBool.Request(data=self.close))
        self.open_call.add_done_callback(self.on_answer)
        self.close = not self.close

    def on_answer(self, future) -> None:
        self.open_call = None
        self.done.append(future.result().message)


gripper, arm = fresh(Gripper), fresh(Arm)
arm.gripper.wait_for_service(timeout_sec=10.0)
await run(gripper, arm, seconds=20, until=lambda: len(arm.done) == 4)
print(arm.done)

# %% [markdown]
# **Fill in the blanks.** This gripper has a loose cable, so one request in three gets no response, and the arm has to
# notice. Replace the `...` with your code.

# %%
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.task import Future


class LooseGripper(Node):
    """A gripper that never answers the requests 3, 6, 9 and so on."""

    def __init__(self) -> None:
        super().__init__("gripper")
        self.requests = 0
        group = ReentrantCallbackGroup()  # a request that waits holds up no other
        self.create_service(
            SetBool, "/gripper/close", self.on_close, callback_group=group
        )

    async def on_close(
        self, request: SetBool.Request, response: SetBool.Response
    ) -> SetBool.Response:
        self.requests += 1
        if self.requests % 3 == 0:
            await Future()  # it is never done
        response.success = True
        response.message = "closed" if request.data else "open"
        return response


class PatientArm(Arm):
    """Notices when an answer does not come."""

    def move(self) -> None:
        if self.open_call is not None:
            # TODO: forget the open call (remove_pending_request),
            # and note "no answer" in self.done.
            ...
        super().move()


gripper, arm = fresh(LooseGripper), fresh(PatientArm)
arm.gripper.wait_for_service(timeout_sec=10.0)
await run(gripper, arm, seconds=20, until=lambda: gripper.requests == 7)
missing = arm.done.count("no answer")
yours(missing or ..., 2, "self.gripper.remove_pending_request(self.open_call)")

# %% [markdown]
# **Your own.** In the [exercise](../exercises/12_services.ipynb), your node requests a self-test from its robot every
# second and publishes the result for the control room. Its heartbeat must stay regular, whether the response is fast,
# late, or missing.

# %% [markdown]
# ## Check yourself
#
# **1. During `rclpy.spin`, a timer callback calls `self.client.call(request)`. The server is fast. What happens?**
#
# <details><summary>a) The callback returns after a few milliseconds</summary>
#
# ✗ By then, the response has reached the process. But the only thread is waiting in `call`, so it can't take the
# response.
#
# </details>
# <details><summary>b) The node hangs, but only until the server is called again</summary>
#
# ✗ Another request would only lead to another response in the same queue.
#
# </details>
# <details><summary>c) The node hangs, without an error</summary>
#
# ✓ The callback waits for the executor, and the executor waits for the callback.
#
# </details>
#
# **2. Now you use a `MultiThreadedExecutor` with eight threads and change nothing else. Does `call` work?**
#
# <details><summary>a) No: the client also needs a different callback group</summary>
#
# ✓ Both a thread *and* the client's group must be free.
#
# </details>
# <details><summary>b) Yes: seven threads are free</summary>
#
# ✗ Threads are free, but the client and the callback share the default group. That group runs only one callback at a
# time (case 2).
#
# </details>
# <details><summary>c) No: call never works inside a callback</summary>
#
# ✗ It works if the executor has several threads and the client has its own group (case 3). But it's simpler not to wait
# at all.
#
# </details>
#
# **3. Your client called `call_async`. The server process crashes before it responds. What happens in your node?**
#
# <details><summary>a) <code>future.result()</code> raises an exception</summary>
#
# ✗ The future has neither a result nor an exception.
#
# </details>
# <details><summary>b) Nothing</summary>
#
# ✓ So your node needs its own time limit. When that limit expires, give up on the call, report the failure, and
# continue.
#
# </details>
# <details><summary>c) The done callback runs, with the result None</summary>
#
# ✗ A done callback runs when its future is done. This future never will be.
#
# </details>
#
# **4. Which of these should be a service?**
#
# <details><summary>a) The angles of the twelve joints</summary>
#
# ✗ New angles arrive many times a second, and several nodes need them. That calls for a topic.
#
# </details>
# <details><summary>b) "Walk to the kitchen"</summary>
#
# ✗ The walk takes minutes. You want to see its progress and be able to cancel it. That calls for an action.
#
# </details>
# <details><summary>c) "Make the left elbow's current angle its new zero"</summary>
#
# ✓ It happens once, on request, and you want to know whether it worked.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Write down your own answer first. Then copy the prompt into an AI assistant, or discuss it with a colleague.
#
# ```text
# I'm programming a robot with ROS 2 Jazzy in Python (rclpy). My node has a 20 Hz balance
# timer. When the robot stumbles, a subscription callback calls the service
# `/arms/stretch_out` with `await client.call_async(...)` and publishes "caught" when
# the response arrives. In tests, the callback hangs at the first stumble, and the
# balance timer stops, too. Which changes would fix this, and which one would you choose?
# Make sure that every rclpy function you use exists in Jazzy.
# ```
#
# <details><summary>What a good answer covers</summary>
#
# While the callback awaits the response, it occupies the node's default group. The client is in the same group, so the
# executor can't take the response. The balance timer is in that group, too, so it stops. If the client gets its own
# group, the response arrives. But until it does, the balance timer still has to wait. To avoid that, give either the
# stumble callback or the timer a separate group, too. A `MultiThreadedExecutor` alone changes nothing. The simplest fix
# is not to wait: use `call_async`, publish "caught" in a done callback, and return. A good answer also adds a time
# limit. Finally, it asks whether a reflex should be a service at all, because a message on a topic needs no response.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Watch for these two suggestions. We tested both with this course's rclpy, and both failed.
#
# - **`await client.call_async()` is safe in any callback:** By default, the client and the callback are in the same
#   group. The response has to wait for that group, so it never reaches the callback.
# - **Call `rclpy.spin_until_future_complete(node, future)` in the callback:** The callback still occupies the group, so
#   nothing can take the response. With a timeout, the function returns when the timeout expires, but the future still
#   isn't done.
#
# </details>

# %% [markdown]
# ## Take away
#
# - A topic can have any number of publishers and subscriptions. A service call consists of one request and one
#   response.
# - The executor takes a response when one of its threads *and* the client's callback group are free.
# - In a callback, `call` hangs if the executor has one thread, or if the client and the callback share a mutually
#   exclusive group. `await` hangs only in the second case.
# - Use `call_async` and `add_done_callback`, and return. That can't cause a deadlock.
# - A response tells you that the server handled your request. A missing response isn't reported, so set your own time
#   limit, and drop an overdue request with `remove_pending_request`.
#
# **Before:** [11 · Polling and callbacks](11_polling_against_callbacks.ipynb)
#
# **Next:** [13 · QoS and discovery](13_qos_and_discovery.ipynb): which messages reach which nodes.
#
# **More:** [Synchronous and asynchronous clients](https://docs.ros.org/en/jazzy/How-To-Guides/Sync-Vs-Async.html) and
# [callback groups](https://docs.ros.org/en/jazzy/How-To-Guides/Using-callback-groups.html).

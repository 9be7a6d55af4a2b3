# %% [markdown]
# # 12 · Services
#
# "Stand still." "Test your knees." "Are you well?" A robot that can be asked needs more than topics: it needs a way to
# answer.
#
# - **Minutes:** 45
# - **You need:** lessons 02 to 06 (nodes, topics, timers, spin), and from lesson 10 that a slow callback holds up others
# - **You will be able to:** offer a service and call one, choose between a topic and a service, call from a callback
#   without hanging your node, and cope with an answer that never comes
# - **Left out:** actions (long jobs with progress), services of your own type, parameters (lesson 16)

# %% [markdown]
# Ask a robot for something. The first cell starts it, as a program of its own. It stands still. It offers a
# **service**, `/robot/wave`: send it a *request*, true or false, and you get a *response*.

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
print("somebody offers it:", remote.wave.wait_for_service(timeout_sec=10.0))

response = await run(remote, until=remote.wave.call_async(SetBool.Request(data=True)), seconds=10)
print(f"success={response.success}, {response.message!r}")
await watch_robot(seconds=4)

# %% [markdown]
# The one who asks has a **client**, the one who answers has a **server**. You asked, and you know that you were heard. A
# message on a topic tells you nothing of that kind. Now ask for the same thing again, then for the opposite:

# %%
from workbook.lesson import stop

for wanted in (True, False):
    request = SetBool.Request(data=wanted)
    response = await run(remote, until=remote.wave.call_async(request), seconds=10)
    print(f"wave {wanted}: success={response.success}, {response.message!r}")
stop()

# %% [markdown]
# A server may say no. That is what `success` and `message` are for, in this service type. The package `std_srvs` has
# three: `Empty` (do it), `Trigger` (do it and tell me how it went), `SetBool` (on or off).

# %% [markdown] prediction="call-in-a-callback"
# ## Predict
#
# So far the notebook asked. On a robot a node asks, in one of its callbacks. Here is one that does two things: ten
# times a second it publishes a heartbeat, and twice a second it asks the robot to test itself. A client has a
# method for that, `call`. It sends the request, waits for the response and returns it.
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
# The server is there, healthy, and answers in a millisecond. What happens in the first two seconds?
#
# - **a** One question. Then no answer, no beat, no error. Nothing.
#   when `asked <= 1 and answered == 0`
#   ✓ The callback waits for the response, and the executor waits for the callback. That is a deadlock.
# - **b** About twenty beats and four answers.
#   when `answered >= 3 and beats >= 18`
#   ✗ The response does arrive after a millisecond. But to take it in is work for the executor, and its only thread
#   waits in `call`.
# - **c** Four answers; the heart misses a beat now and then, while `call` waits.
#   when `answered >= 3 and beats < 18`
#   ✗ It is more than a delay. The thread that would have to take in the response is the one that waits for it.
# - **d** An exception: rclpy forbids `call` in a callback.
#   ✗ rclpy does not look at where `call` is called from. It waits, and sets no limit to that.

# %%
from workbook.lesson import predict, reveal

predict("call-in-a-callback")

# %% [markdown]
# ## Run it
#
# Whatever it does, it shall not do it to this notebook. `record` runs the node as a process of its own, listens for two
# seconds and ends it, by force if need be. The node also says on `/robot/asked` and `/robot/answered` what it is doing.
# Its server lives elsewhere, with a thread of its own.

# %% id="deadlock"
from lesson_nodes import heart_and_question
from workbook.lesson import arrivals, record

HEART, ASKED, ANSWERED = "/robot/heartbeat", "/robot/asked", "/robot/answered"
PERIODS = {HEART: 0.1, ASKED: 0.5, ANSWERED: 0.5}


def try_out(way, group="default", threads=1, **more):
    """Two seconds in the life of a node that asks in this way."""
    return record(
        heart_and_question, PERIODS, seconds=2.2, clock="wall", way=way, group=group, threads=threads, **more
    )


deadlock = try_out("call")
print("questions:", len(arrivals(deadlock, ASKED)))
print("answers:  ", len(arrivals(deadlock, ANSWERED)))
print("the heart beats on:", max(arrivals(deadlock, HEART), default=0.0) > deadlock.robot_s - 1.2)
print("what it printed:", repr(deadlock.process.log))

# %%
from workbook.pictures.figures import show
from workbook.pictures.timeline import Row, draw


def heart_row(recording, label, note=None):
    """One line of a picture: the heartbeats, and what is missing of them."""
    beats = arrivals(recording, HEART)
    return Row(label, beats, period=0.1, start=min(beats, default=0.0), end=2.2, note=note)


def question_rows(recording):
    """Two lines of a picture: when it asked, and when it had an answer."""
    asked, had = arrivals(recording, ASKED), arrivals(recording, ANSWERED)
    return [
        Row("questions", asked, note=f"{len(asked)} asked"),
        Row("answers", had, note=f"{len(had)} answered"),
    ]


rows = [heart_row(deadlock, "heartbeat"), *question_rows(deadlock)]
show(draw(rows, end=2.2), "a few heartbeats, one question, and then silence on all three lines")
reveal(
    "call-in-a-callback",
    asked=len(arrivals(deadlock, ASKED)),
    answered=len(arrivals(deadlock, ANSWERED)),
    beats=len(arrivals(deadlock, HEART)),
)

# %% [markdown]
# The node is not dead. It waits, and it will wait until somebody pulls the plug. This is a **deadlock**: two parties, and
# each waits for the other.

# %% [markdown]
# ## Look inside
#
# Who waits for whom? Follow the answer on its way.
#
# 1. `call` sends the request and waits.
# 2. The server answers. A millisecond later the response lies in the mailbox of our process.
# 3. Somebody has to take it out and hand it to `call`. As for a message or a timer, that is the work of the
#    **executor**, inside `spin`.
# 4. But the executor is busy: it runs `ask`, and `ask` waits in `call`.
#
# So `call` waits for the executor, and the executor waits for `ask`. With it waits the heart.
#
# ### Two rules
#
# The answer comes in when two things are free:
#
# - **a thread** of the executor. `spin` has one. A `MultiThreadedExecutor` has several.
# - **the callback group of the client.** A node puts all its callbacks into one *default group*, and that one is
#   *mutually exclusive*: it lets in one callback at a time. A callback that waits is still inside.
#
# And what does waiting hold on to? That depends on how you wait:
#
# | in the callback | holds its thread | holds its group |
# |---|---|---|
# | `client.call(request)` | yes | yes |
# | `await client.call_async(request)` | no | yes |
# | `client.call_async(request)`, then `add_done_callback` | no | no |
#
# `call_async` sends the request and returns at once. What it returns is a **future**: an object that will hold the
# response, later. `await` pauses a method that is written with `async def` until the future is done, and lends the thread
# to others meanwhile. `add_done_callback` says which function to call when it is done, and pauses nothing.

# %% [markdown]
# ### Seven cases
#
# Before you run the next cell, decide for each line: do the answers come? Use the two rules. "Own" means that the client
# has a callback group of its own; all else stays in the default group.
#
# | | how it waits | group of the client | threads |
# |---|---|---|---|
# | 1 | `call` | default | 1 |
# | 2 | `call` | default | 4 |
# | 3 | `call` | own | 4 |
# | 4 | `call` with `timeout_sec=0.4` | default | 1 |
# | 5 | `await` | default | 4 |
# | 6 | `await` | own | 1 |
# | 7 | `spin_until_future_complete`, for 0.4 s | default | 1 |
#
# Each case is again a process of its own, three at a time.

# %% id="seven-cases"
from concurrent.futures import ThreadPoolExecutor

CASES = [
    ("call", "default", 1),
    ("call", "default", 4),
    ("call", "own", 4),
    ("call_timeout", "default", 1),
    ("await", "default", 4),
    ("await", "own", 1),
    ("spin_until", "default", 1),
]


def try_all(cases, **more):
    """Run some cases, three at a time."""
    with ThreadPoolExecutor(3) as pool:
        return list(pool.map(lambda case: try_out(*case, **more), cases))


def answers(recording):
    """Whether the questions were answered."""
    return "come" if len(arrivals(recording, ANSWERED)) >= 2 else "never"


def heart(recording):
    """Whether the heart goes on, also while a question waits."""
    beats, had = arrivals(recording, HEART), arrivals(recording, ANSWERED)
    if max(beats, default=0.0) < recording.robot_s - 1.2:
        return "stops"
    waits = [(t, min([a for a in had if a > t], default=t + 0.4)) for t in arrivals(recording, ASKED)]
    due = sum(end - begin for begin, end in waits) / 0.1
    came = sum(begin < beat < end for begin, end in waits for beat in beats)
    return "limps" if due > 3 and came < 0.4 * due else "beats"


seven = try_all(CASES)
print("   way            group    threads   answers  heart")
for number, (case, seen) in enumerate(zip(CASES, seven, strict=True), start=1):
    print(f"{number}  {case[0]:<14} {case[1]:<8} {case[2]:^7}   {answers(seen):<7}  {heart(seen)}")

# %%
rows = [
    heart_row(
        seen,
        f"{number}: {way}, {group}, {threads}",
        ("✓ " if answers(seen) == "come" else "✗ ") + f"{len(arrivals(seen, ANSWERED))} answers",
    )
    for number, ((way, group, threads), seen) in enumerate(zip(CASES, seven, strict=True), start=1)
]
show(
    draw(rows, end=2.2),
    "the heartbeats of the seven cases: they go on only where call or await has a group of its own for the client; "
    "they limp where the wait has a time-out, and stop elsewhere",
)

# %% [markdown]
# Read it with the rules.
#
# - **1** no thread and no group is free. **2** three threads are free, but the group is not. More threads alone change
#   nothing. **3** both are free.
# - **4** is no deadlock, but no gain either. It always waits the full 0.4 s and gets `None`, although the answer lies
#   in the mailbox all that time. The heart limps.
# - **5** `await` lends the thread, but stays in the group. The official documentation calls asynchronous calls safe; in
#   this arrangement the answer never comes. **6** with a group for the client, one thread is enough.
# - **7** spins the node inside a callback of the same node. The group is still taken, so it waits in vain, like 4.
#
# A group is made in one line and given to the client:
#
# ```python
# from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
#
# self.self_test = self.create_client(
#     Trigger, "/robot/self_test", callback_group=MutuallyExclusiveCallbackGroup()
# )
# ```

# %% [markdown]
# ### Topic or service?
#
# | | topic | service |
# |---|---|---|
# | who talks | anybody, to anybody who listens | one asks, one answers |
# | does the sender know it arrived? | no | yes: by the response |
# | when | when there is news, or at a rate | when somebody wants it |
# | nobody on the other side | the message is gone | the call stays open, for ever |
# | good for | joint angles, battery, camera, status | switch on, reset, self-test, "take a picture now" |
#
# Ask yourself: *does it flow, or does it happen?* Sensor values flow: publish them. "Stand still" happens, and you
# want to know that it did: a service. If the answer takes more than a second or so ("walk to the door"), neither
# is right. That is an *action*, with progress and the right to cancel.

# %% [markdown] prediction="other-groups"
# ## Change it
#
# ### Experiment 1: other groups, other threads
#
# A *reentrant* group lets in any number of callbacks at a time. Three more cases, in which it is again the client
# (and for "reentrant" also the question) that changes its group:
#
# - `call`, own group, 1 thread
# - `call`, reentrant group, 4 threads
# - `await`, reentrant group, 1 thread
#
# In which of them do answers come?
#
# - **a** In all three: none of them uses the default group for the answer.
#   when `case_1 and case_2 and case_3`
#   ✗ The group is not all that it takes. In the first case the only thread waits in `call`, and nobody takes in the
#   response.
# - **b** Only in the second: it has threads and a group.
#   when `not case_1 and case_2 and not case_3`
#   ✗ The third case has one thread, but `await` lends it while it waits, and the reentrant group lets the response
#   in.
# - **c** Only in the first.
#   when `case_1 and not case_2 and not case_3`
#   ✗ In the first case the group is free, but the only thread waits in `call`.
# - **d** In the second and the third.
#   when `not case_1 and case_2 and case_3`
#   ✓ `call` keeps a thread, so it needs a second one and a free group. `await` lends its thread, so a free group is
#   enough.

# %%
predict("other-groups")

# %%
OTHERS = [("call", "own", 1), ("call", "reentrant", 4), ("await", "reentrant", 1)]  # turn these knobs

others = try_all(OTHERS)
for case, seen in zip(OTHERS, others, strict=True):
    print(f"{case[0]:<8} {case[1]:<10} threads={case[2]}: answers {answers(seen)}, the heart {heart(seen)}")
reveal(
    "other-groups",
    case_1=answers(others[0]) == "come",
    case_2=answers(others[1]) == "come",
    case_3=answers(others[2]) == "come",
)

# %% [markdown]
# `call` needs a second thread, whatever the groups. `await` does not.

# %% [markdown] prediction="slow-server"
# ### Experiment 2: a server that takes its time
#
# Until now the server answered in a millisecond. Let it take 0.35 s. These three get their answers. But in which of them
# does the heart, which is in the default group, beat on *while* a question waits?
#
# - `call`, own group, 4 threads
# - `await`, own group, 1 thread
# - done callback, default group, 1 thread
#
# Options:
#
# - **a** In all three: they all get their answers.
#   when `case_1 and case_2 and case_3`
#   ✗ They do get their answers. But in two of them the callback that waits stays in the default group, where the
#   heart is.
# - **b** In the first only: it has threads to spare.
#   when `case_1 and not case_2 and not case_3`
#   ✗ It has threads to spare, but not the group: the callback that waits in `call` is in the default group, as the
#   heart is.
# - **c** In the third only.
#   when `not case_1 and not case_2 and case_3`
#   ✓ The callback only asks and returns, so it leaves the group at once. The heart shares the group, and is not held
#   up.
# - **d** In the second and third: neither holds a thread.
#   when `not case_1 and case_2 and case_3`
#   ✗ `await` lends the thread, but its callback stays in the default group until the response is there.

# %%
predict("slow-server")

# %%
SLOW = [("call", "own", 4), ("await", "own", 1), ("done_callback", "default", 1)]

slow = try_all(SLOW, server_takes_s=0.35)
for case, seen in zip(SLOW, slow, strict=True):
    print(f"{case[0]:<14} answers {answers(seen)}, the heart {heart(seen)}")
rows = [heart_row(seen, f"{case[0]}, {case[1]} group") for case, seen in zip(SLOW, slow, strict=True)]
show(
    draw(rows, end=2.2),
    "heartbeats beside a slow server: gaps with call and with await, none with a done callback",
)
reveal(
    "slow-server",
    case_1=heart(slow[0]) == "beats",
    case_2=heart(slow[1]) == "beats",
    case_3=heart(slow[2]) == "beats",
)

# %% [markdown]
# `call` and `await` get their answer, because the *client* has a group of its own. But the callback that waits is still
# inside the default group, and the heart is in there, too. Either put the question into another group as well, or
# do not wait: a callback that only asks and returns leaves the group at once.
#
# For most nodes that is the advice: **`call_async`, a done callback, return.** No threads, no groups, no deadlock. (The
# done callback itself is in *no* group. With one thread that does not matter. With several it may meet any other callback,
# so what they share needs a lock.)

# %% [markdown] prediction="server-dies"
# ### Experiment 3: the server dies
#
# A server with a loose cable never answers. While our call is open, its process ends. What does the client learn of it?
#
# - **a** The future is done, and raises an exception.
#   ✗ Nobody tells the client that the server is gone, so nothing puts an exception into the future.
# - **b** The future stays open for good, and nobody says anything.
#   when `not old_call_is_done`
#   ✓ A service has no time-out, and no message says that the server ended. The client has to watch the time itself.
# - **c** The future is done, and its result is `None`.
#   ✗ A future is done when the response has come. None has come, so there is no result, not even `None`.
# - **d** The future stays open. A new server of that name would answer it.
#   when `old_call_is_done`
#   ✗ The request went to the old server. A new one has never seen it.

# %%
predict("server-dies")

# %%
from std_srvs.srv import Trigger

from lesson_nodes import self_test_server
from workbook.lesson import spin_for


class Asker(Node):
    """Can ask for a self-test."""

    def __init__(self) -> None:
        super().__init__("asker")
        self.self_test = self.create_client(Trigger, "/robot/self_test")


start(self_test_server, pattern="never")
asker = fresh(Asker)
print("a server is there:", asker.self_test.wait_for_service(timeout_sec=10.0))
future = asker.self_test.call_async(Trigger.Request())
spin_for(asker, seconds=1.0)

stop(self_test_server)
spin_for(asker, seconds=10.0, until=lambda: not asker.self_test.service_is_ready())
print("the server is gone; the future is done:", future.done())

# %%
start(self_test_server, pattern="ok")
print("a new server is there:", asker.self_test.wait_for_service(timeout_sec=10.0))
spin_for(asker, seconds=1.0)
old_call_is_done = future.done()
print("the old call is answered:", old_call_is_done)

asker.self_test.remove_pending_request(future)
future = asker.self_test.call_async(Trigger.Request())
response = await run(asker, until=future, seconds=10)
print("asked again:", response.message)
stop()
reveal("server-dies", old_call_is_done=old_call_is_done)

# %% [markdown]
# A call is a letter, not a telephone line. Nobody tells you that the receiver has moved. `service_is_ready()` says whether
# somebody offers the service *now*; it says nothing of your open call. So whoever asks needs a clock of his own: after
# a time that you choose, forget the call with `remove_pending_request(future)`, and ask again or raise the alarm.

# %% [markdown]
# ## When it goes wrong
#
# **Silence: nobody is there.** One letter is wrong in this name.


# %% id="no-server"
class Hasty(Node):
    """Asks for a self-test, and does not look whether anybody offers one."""

    def __init__(self) -> None:
        super().__init__("hasty")
        self.self_test = self.create_client(Trigger, "/robot/selftest")


hasty = fresh(Hasty)
future = hasty.self_test.call_async(Trigger.Request())
spin_for(hasty, seconds=1.0)
print("answered:", future.done())

# %% [markdown]
# No error: a server of that name might still come. (Even then this request would stay lost.) `wait_for_service` is how you
# find out. It looks four times a second, and `False` means that nobody was there in time. Always give it a time-out, and
# call it before you spin, not in a callback: it waits, too.

# %%
print("somebody offers it:", hasty.self_test.wait_for_service(timeout_sec=1.0))

# %% [markdown]
# **Too early.** `call_async` returns at once, so the next line runs before the answer is there.

# %% id="too-early" tags=["raises-exception"]
start(self_test_server)
asker = fresh(Asker)
asker.self_test.wait_for_service(timeout_sec=10.0)

future = asker.self_test.call_async(Trigger.Request())
print("well" if future.result().success else "faulty")

# %% [markdown]
# The result of a future that is not done is `None`. The error speaks of `NoneType` and not of the future. Let the node work
# until the future is done (outside of callbacks: `rclpy.spin_until_future_complete(node, future)` in a program, `run`
# here), or look at it in a done callback.

# %%
response = await run(asker, until=future, seconds=10)
print("well" if response.success else "faulty")
stop()

# %% [markdown]
# **A server that forgets to return.** The handler gets the request and an empty response, and has to *return* the response.
# This one fills it in, and that is all.


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
print("the guest has an answer:", greeting.done())

# %% [markdown]
# `TypeError()`, and not a word more. rclpy wanted to send the response, got `None`, and says only that the type is wrong.
# In a program you see a traceback that ends in a bare `TypeError`. It comes in the *server*, which dies of it. The client,
# in another process, hears nothing: its call stays open, as in experiment 3. One line mends it:


# %%
class Polite(Forgetful):
    """Greets when asked."""

    def on_greet(self, request: Trigger.Request, response: Trigger.Response) -> Trigger.Response:
        response.success = True
        response.message = "Hello!"
        return response


robot, guest = fresh(Polite), fresh(Guest)
guest.greet.wait_for_service(timeout_sec=10.0)
response = await run(robot, guest, until=guest.greet.call_async(Trigger.Request()), seconds=10)
print("now it says:", response.message)

# %% [markdown]
# **Spinning inside a callback.** Case 7 waited in vain. Somebody gives the client its own group, and an executor with four
# threads, and look: the answer comes. Once.

# %% id="spin-inside"
inside = try_out("spin_until", "own", 4)
print("the first question was answered:", len(arrivals(inside, ANSWERED)) == 1)
print("after that the heart", heart(inside))
show(
    draw([heart_row(inside, "heartbeat"), *question_rows(inside)], end=2.2),
    "some heartbeats, one question, one answer, and then silence",
)

# %% [markdown]
# `rclpy.spin_until_future_complete` spins with the *global* executor. The node had an executor of its own, is taken away
# from it, and is let go when the future is done. Nobody spins it after that. In `main()`, before `spin`, the function is at
# its place. In a callback it is not.

# %% [markdown]
# ## From a worked example to your own
#
# **Worked.** An arm asks its gripper to close and to open, twice a second. It does not wait. It keeps the open call in an
# attribute, and the done callback writes down what came of it.


# %%
class Gripper(Node):
    """Closes and opens when asked."""

    def __init__(self) -> None:
        super().__init__("gripper")
        self.create_service(SetBool, "/gripper/close", self.on_close)

    def on_close(self, request: SetBool.Request, response: SetBool.Response) -> SetBool.Response:
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
# **Faded.** This gripper has a loose cable: it does not answer every third request. The arm shall notice. Fill in what is
# `...`; until then the cell runs, and says what is missing.

# %%
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.task import Future


class LooseGripper(Node):
    """A gripper that never answers the requests 3, 6, 9 and so on."""

    def __init__(self) -> None:
        super().__init__("gripper")
        self.requests = 0
        group = ReentrantCallbackGroup()  # so that one that waits holds up nobody
        self.create_service(SetBool, "/gripper/close", self.on_close, callback_group=group)

    async def on_close(self, request: SetBool.Request, response: SetBool.Response) -> SetBool.Response:
        self.requests += 1
        if self.requests % 3 == 0:
            await Future()  # nobody ever completes it
        response.success = True
        response.message = "closed" if request.data else "open"
        return response


class PatientArm(Arm):
    """Notices when an answer does not come."""

    def move(self) -> None:
        if self.open_call is not None:
            ...  # TODO: forget the open call (remove_pending_request), and note "no answer" in self.done
        super().move()


gripper, arm = fresh(LooseGripper), fresh(PatientArm)
arm.gripper.wait_for_service(timeout_sec=10.0)
await run(gripper, arm, seconds=20, until=lambda: gripper.requests == 7)
if arm.done.count("no answer") == 2:
    print("The arm has noticed both missing answers:", arm.done)
else:
    print("Two requests were not answered. The arm noted", arm.done.count("no answer"), "of them.")

# %% [markdown]
# **Your own.** In the [exercise](../exercises/12_services.ipynb) a node asks its robot for a self-test every second,
# tells the control room what came out, and keeps a heartbeat that must not miss a beat, whether the answer is quick,
# slow or never comes.

# %% [markdown]
# ## Check yourself
#
# **1. Under `rclpy.spin`, a timer callback calls `self.client.call(request)`. The server is fast. What happens?**
#
# <details><summary>a) The callback returns after a few milliseconds</summary>
#
# ✗ The answer is in the process after that time, but nobody can take it in: the only thread waits in `call`.
#
# </details>
# <details><summary>b) The node hangs, but only until the server is called again</summary>
#
# ✗ Another request would only be another letter in the same mailbox.
#
# </details>
# <details><summary>c) The node hangs, without an error</summary>
#
# ✓ The callback waits for the executor, and the executor for the callback.
#
# </details>
#
# **2. Now you use a `MultiThreadedExecutor` with eight threads, and change nothing else. Does `call` work?**
#
# <details><summary>a) No: the client needs another callback group as well</summary>
#
# ✓ A thread *and* a group have to be free.
#
# </details>
# <details><summary>b) Yes: seven threads are free</summary>
#
# ✗ Threads are free, but client and callback share the default group, and that lets in one at a time (case 2).
#
# </details>
# <details><summary>c) No: call never works inside a callback</summary>
#
# ✗ It does with threads and a group of its own for the client (case 3). Whether it is wise is another question.
#
# </details>
#
# **3. Your client called `call_async`. The process of the server crashes before it answers. What does your node see?**
#
# <details><summary>a) An exception from <code>future.result()</code></summary>
#
# ✗ The future has no exception. It has nothing at all.
#
# </details>
# <details><summary>b) Nothing</summary>
#
# ✓ That is why the one who asks needs a clock: give the call up, report it, go on.
#
# </details>
# <details><summary>c) The done callback, with the result None</summary>
#
# ✗ Done callbacks are called when the future is done. This one never will be.
#
# </details>
#
# **4. Which of these should be a service?**
#
# <details><summary>a) The angles of the twelve joints</summary>
#
# ✗ They flow, many times a second, and several nodes want them: a topic.
#
# </details>
# <details><summary>b) "Walk to the kitchen"</summary>
#
# ✗ It takes minutes. One wants to see progress and to be able to call it off: an action.
#
# </details>
# <details><summary>c) "Set the zero of the left elbow to where it is now"</summary>
#
# ✓ It happens once, when somebody wants it, and that one wants to know whether it worked.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Discuss this with a colleague or an AI assistant:
#
# > My node has a 20 Hz balance timer. When the robot stumbles, a subscription callback calls the service
# > `/arms/stretch_out` with `await client.call_async(...)` and publishes "caught" when the response is there. In tests it
# > hangs at the first stumble, and the balance timer stops with it. Which changes would mend it, and which one would you
# > choose?
#
# <details><summary>What a good answer contains</summary>
#
# The callback that awaits stays in the node's default group. The client is in the same group, so the response cannot
# be taken in, and so is the balance timer, which is why it stops, too. A client in a group of its own lets the
# response in; but while the arms take their time, balance still waits, unless the stumble callback (or the timer)
# gets another group as well. A `MultiThreadedExecutor` alone changes nothing. The simplest change is not to wait:
# `call_async`, a done callback that publishes "caught", return. Good answers add a time limit (what if `/arms` has
# crashed?), what to do when it has passed, and whether a service is the right thing for a reflex at all: a message on
# a topic needs no answer and waits for nobody.
#
# </details>

# %% [markdown]
# ## Take away
#
# - A topic flows to whoever listens. A service is one question and one answer.
# - The answer comes in when a thread of the executor *and* the callback group of the client are free.
# - `call` in a callback hangs, without an error; so does `await` when client and callback share a group.
# - `call_async`, `add_done_callback`, return: that never hangs.
# - An answer that does not come says nothing. Give it up yourself, with a clock and `remove_pending_request`.
#
# **Before:** [11 · Polling against callbacks](11_polling_against_callbacks.ipynb)
#
# **Next:** [13 · QoS and discovery](13_qos_and_discovery.ipynb), on promises between those who talk and those who listen.
#
# **More:** [Synchronous and asynchronous clients](https://docs.ros.org/en/jazzy/How-To-Guides/Sync-Vs-Async.html) and
# [callback groups](https://docs.ros.org/en/jazzy/How-To-Guides/Using-callback-groups.html).

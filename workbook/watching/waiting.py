"""Wait until a program is in the graph and is connected to the judge in both directions.

Two endpoints *match* when DDS has connected them.
"""

import time

from workbook.watching.parameter_services import ParameterServices
from workbook.watching.session import Session

FIRST_SIGN_S = 12.0
STARTS_LONGEST_S = 30.0
"""How much longer (s) than `FIRST_SIGN_S` we wait for a program that's at work and has used less than
`STARTS_PROCESSOR_S`."""
STARTS_PROCESSOR_S = 10.0
"""The most CPU time (s) that a program's startup may take. For comparison, we measured 2.2 s for `import torch`."""
AT_REST_S = 1.0
"""If a program hasn't been at work for this long (s), its startup is over."""
ELSEWHERE_S = 2.0
SETTLE_S = 0.6
UNANSWERED_S = 0.5
"""How long (s) to wait for the nodes' responses once everything else is complete.

After that, we assume that the nodes don't spin.
"""
SPINNING_S = 0.1
"""How long (s) a spinning node's new endpoints may take to reach us."""
MATCH_S = 5.0
NO_PUBLISHER_S = 8.0
POLL_S = 0.01
HELD_STEPS = 5
HELD_STEP_S = 0.003
"""With a clock, `let_it_match_us` waits this long (s) per step, instead of `POLL_S`."""


def wait_for_first_sign(session: Session) -> bool:
    """Wait until one of the program's publishers is in the graph. Return False if none appears in time.

    If the plan doesn't require a publisher (`node_suffices`), a node is enough.
    """
    process, recorder = session.process, session.recorder
    deadline = time.monotonic() + FIRST_SIGN_S
    look_elsewhere = time.monotonic() + ELSEWHERE_S
    node_since: float | None = None
    at_work = 0.0
    while (now := time.monotonic()) < deadline or _may_still_start(session, deadline, at_work):
        if now > deadline - AT_REST_S and not session.rest.is_quiet():
            at_work = now
        if time.monotonic() > look_elsewhere:
            used = process.domains_used()
            if used and session.observer.domain_id not in used:
                return False
            look_elsewhere += 1.0
        if recorder.look() and node_since is None and recorder.nodes():
            node_since = time.monotonic()
        if recorder.any_publisher() or (session.plan.node_suffices and recorder.nodes()):
            return True
        if not process.is_running():
            return False
        if node_since is not None and time.monotonic() - node_since > NO_PUBLISHER_S:
            return False
        time.sleep(POLL_S)
    return False


def _may_still_start(session: Session, deadline: float, at_work: float) -> bool:
    """Return whether a program that hasn't appeared by `deadline` may still be starting.

    On a busy machine, it may have had too little CPU time to import large libraries. But a program in an endless loop
    has used far more CPU time. And a program that was last seen at work a while ago (at the time `at_work`,
    `time.monotonic`, s) has finished its startup.
    """
    now = time.monotonic()
    if now > min(deadline + STARTS_LONGEST_S, at_work + AT_REST_S):
        return False
    used = session.process.processor_seconds()
    return used is not None and used < STARTS_PROCESSOR_S


def wait_for_matches(session: Session, services: ParameterServices | None = None) -> None:
    """Wait until all of the exercise's endpoints are connected with the judge, or until we give up on the missing ones.

    Before a switch to simulated time, pass the nodes' parameter `services`. A node that responds is spinning, so its
    program has finished its setup. ROS 2 announces node names separately from publishers, and on a busy machine, the
    names arrive much later. Without `services`, we don't send requests, because each request would run a callback in
    the program, which the program may count. Instead, we wait until nothing new has appeared for a while.
    """
    recorder = session.recorder
    looked = time.monotonic()
    deadline = looked + MATCH_S
    quiet_s = spinning_s = 0.0  # time in which the program or this process waits for a core doesn't count
    while (now := time.monotonic()) < deadline and session.process.is_running():
        spent = min(now - looked, POLL_S)
        if recorder.look():
            quiet_s = spinning_s = 0.0
        quiet = session.rest.is_quiet()
        quiet_s += spent if quiet else 0.0
        looked = now
        if services is None:
            if _is_complete(session) or quiet_s > SETTLE_S:
                return
        else:
            spinning = services.all_spin(recorder.present())
            spinning_s += spent if spinning and quiet else 0.0  # another of its processes may be starting
            if _is_complete(session) and (spinning or quiet_s > UNANSWERED_S):
                return
            if spinning_s > SPINNING_S:
                return
        time.sleep(POLL_S / 2)


def _is_complete(session: Session) -> bool:
    recorder = session.recorder
    matched = session.plan.topics and all(map(recorder.matched, session.plan.topics))
    known = recorder.nodes() and recorder.knows_its_nodes()
    return bool(matched and known and session.script_player.ready())


def let_it_match_us(session: Session) -> None:
    """Give the program time to match our endpoints, and publish the start of simulated time in the meantime.

    We may match the program's endpoints before it matches ours. Until then, it misses our messages, and we miss its
    responses.
    """
    for _ in range(HELD_STEPS):
        if session.clock is not None:
            session.clock.publish()
        time.sleep(POLL_S if session.clock is None else HELD_STEP_S)
        session.rest.wait_until_quiet()

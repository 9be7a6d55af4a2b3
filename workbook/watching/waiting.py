"""Waiting until a program is on the graph, and connected with the judge in both directions."""

import time

from workbook.watching.parameter_services import ParameterServices
from workbook.watching.session import Session

FIRST_SIGN_S = 12.0
STARTS_LONGEST_S = 30.0
"""So much longer (s) a program is waited for that is at work, and has used less than `STARTS_PROCESSOR_S`."""
STARTS_PROCESSOR_S = 10.0
"""Processor time (s) of a start. Measured: `import torch` takes 2.2."""
AT_REST_S = 1.0
"""A program that has not been at work for so long (s) does not start any more."""
ELSEWHERE_S = 2.0
SETTLE_S = 0.6
UNANSWERED_S = 0.5
"""A program that has everything else, and whose nodes do not answer, is one that does not spin."""
SPINNING_S = 0.1
"""What a spinning node has made may still be on its way to us for so long (s)."""
MATCH_S = 5.0
NO_PUBLISHER_S = 8.0
POLL_S = 0.01
HELD_STEPS = 5
HELD_STEP_S = 0.003
"""With the clock, a program that is still busy with what it hears of us is waited for besides."""


def wait_for_first_sign(session: Session) -> bool:
    """Wait until a publisher of the program is on the graph. Returns False if it never came."""
    process, recorder = session.process, session.recorder
    deadline = time.monotonic() + FIRST_SIGN_S
    look_elsewhere = time.monotonic() + ELSEWHERE_S
    node_since: float | None = None
    at_work = 0.0
    while (now := time.monotonic()) < deadline or _may_still_start(session, deadline, at_work):
        if now > deadline - AT_REST_S and not session.quiescence.is_quiet():
            at_work = now
        if time.monotonic() > look_elsewhere:
            used = process.domains_used()
            if used and session.place.domain_id not in used:
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
    """Whether a program that has not come up by `deadline` has had too little of the processor for its start.

    It may import large libraries, on a busy machine. A loop without end has used far more by then, where it can; and a
    program that was last seen `at_work` a while ago has nothing to do.
    """
    now = time.monotonic()
    if now > min(deadline + STARTS_LONGEST_S, at_work + AT_REST_S):
        return False
    used = session.process.processor_seconds()
    return used is not None and used < STARTS_PROCESSOR_S


def wait_for_matches(session: Session, services: ParameterServices | None = None) -> None:
    """Wait until all that the exercise names is there and connected with the judge, or will not come any more.

    With `services`, before a switch to simulated time, nodes are asked whether they spin: a program whose nodes do has
    set up what it sets up at its start. The names of nodes travel apart from their publishers, and on a busy machine
    come much later. Without it no node is asked, because to answer is a callback, which a program may count. The
    program is then waited for until nothing new has come for a while.
    """
    recorder = session.recorder
    looked = time.monotonic()
    deadline = looked + MATCH_S
    quiet_s = spinning_s = (
        0.0  # a program that waits for a core is not quiet, nor are we while we wait for one
    )
    while (now := time.monotonic()) < deadline and session.process.is_running():
        spent = min(now - looked, POLL_S)
        if recorder.look():
            quiet_s = spinning_s = 0.0
        quiet = session.quiescence.is_quiet()
        quiet_s += spent if quiet else 0.0
        looked = now
        if services is None:
            if _is_complete(session) or quiet_s > SETTLE_S:
                return
        else:
            spinning = services.all_spin(recorder.present())
            spinning_s += spent if spinning and quiet else 0.0  # another process of it may be at its start
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
    """Give the program time to match our endpoints, publishing the start of simulated time meanwhile.

    Matching is not mutual at once: until the program has matched us, it misses what we publish, and we miss what it
    publishes in return.
    """
    for _ in range(HELD_STEPS):
        if session.clock is not None:
            session.clock.publish()
        time.sleep(POLL_S if session.clock is None else HELD_STEP_S)
        session.quiescence.wait()

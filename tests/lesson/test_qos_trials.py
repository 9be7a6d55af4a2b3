"""The late subscribers of the lesson on QoS: how they run, and that none is left, however the trial ends."""

import pytest

from tests.programs.support import children_of_this_process
from workbook.lesson import qos_trials
from workbook.programs.process import NodeProcess
from workbook.ros.domains import lease_domain

GIVEN_UP_MS = 4000.0


def test_a_newcomer_finds_its_listener_with_the_default_times() -> None:
    (found_ms,) = qos_trials.greet_by_default(1)
    assert 0.0 < found_ms < GIVEN_UP_MS


def test_a_newcomer_that_fails_shows_its_log(monkeypatch: pytest.MonkeyPatch) -> None:
    with lease_domain() as lease:
        monkeypatch.setenv("ROS_DOMAIN_ID", str(lease.domain_id))
        with pytest.raises(RuntimeError, match="wait_for is one of nothing, count, matched"):
            qos_trials.greet(1, "/ears", wait_for="a miracle")


def test_an_interrupted_trial_leaves_no_program(monkeypatch: pytest.MonkeyPatch) -> None:
    wait = NodeProcess.wait
    begun: list[NodeProcess] = []

    def interrupted(process: NodeProcess, timeout_s: float) -> bool:
        if process.spec.file.stem == "first_words" and not begun:
            begun.append(process)
            assert process.is_running()
            raise KeyboardInterrupt
        return wait(process, timeout_s)

    before = children_of_this_process()
    monkeypatch.setattr(NodeProcess, "wait", interrupted)
    with pytest.raises(KeyboardInterrupt):
        qos_trials.greet_by_default(1)
    assert begun and not begun[0].is_running()
    assert children_of_this_process() == before

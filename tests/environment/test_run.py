"""The order and the strictness of `make test` itself."""

import importlib.util
import os
import subprocess
import sys
import time
from pathlib import Path
from types import ModuleType

import pytest

RUN = Path(__file__).resolve().parents[1] / "run.py"


@pytest.fixture(scope="module")
def proof() -> ModuleType:
    spec = importlib.util.spec_from_file_location("proof_of_everything", RUN)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


REPORT = """<testsuites><testsuite>
<testcase classname="tests.browser.test_lab" name="test_light">
<skipped type="pytest.skip" message="no Chromium"/></testcase>
<testcase classname="tests.browser.test_lab" name="test_dark"/>
<testcase classname="tests.ros.test_rate" name="test_known"><skipped type="pytest.xfail" message="known"/></testcase>
</testsuite></testsuites>"""


def test_skips_are_found_in_a_report_and_expected_failures_are_none(
    proof: ModuleType, tmp_path: Path
) -> None:
    report = tmp_path / "report.xml"
    report.write_text(REPORT)
    assert proof.skipped(report) == [("tests.browser.test_lab::test_light", "no Chromium")]
    assert proof.skipped(tmp_path / "absent.xml") == []


def test_only_listed_skips_are_allowed(proof: ModuleType) -> None:
    skips = [
        ("tests.browser.test_lab::test_light", "no Chromium"),
        ("tests.sandbox::test_escape", "no bwrap"),
    ]
    patterns = proof.allowed_patterns("# reasons\n\ntests.sandbox::*  # no user namespaces on this kernel\n")
    assert proof.unlisted(skips, patterns) == skips[:1]
    assert proof.unlisted(skips, []) == skips


def test_pytest_is_the_last_step_and_every_group_can_be_chosen(proof: ModuleType) -> None:
    plan = proof.steps()
    assert plan[-1].name == "pytest"
    assert {step.group for step in proof.chosen(plan, "lint")} == {"style", "types"}
    assert proof.chosen(plan, None) == plan
    for group in ("style", "types", "notebooks", "collection", "pytest"):
        assert proof.chosen(plan, group)


@pytest.mark.parametrize("code", [0, 3])
def test_a_quiet_step_says_why_it_failed_and_nothing_else(proof: ModuleType, code: int) -> None:
    said: list[str] = []
    speaks = f"print('two tests'); raise SystemExit({code})"
    step = proof.Step("quiet", "style", (sys.executable, "-c", speaks), quiet=True)
    assert bool(proof._run_quick(step, {**os.environ}, said.append)) == bool(code)
    assert ("two tests" in said[0]) == bool(code)


def test_a_failed_step_is_named_and_the_others_run(
    proof: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(proof, "ARTIFACTS", tmp_path)
    ran = tmp_path / "ran"
    plan = [
        proof.Step("first", "style", (sys.executable, "-c", "raise SystemExit(3)")),
        proof.Step("second", "style", (sys.executable, "-c", f"open({str(ran)!r}, 'w')")),
    ]
    said: list[str] = []
    assert proof.run(plan, said.append) == ["first (exit 3)"]
    assert ran.exists()
    assert any("FAILED" in line for line in said)


@pytest.mark.parametrize(("ci", "code"), [("true", 1), ("", 0)])
def test_an_unlisted_skip_fails_in_ci_only(
    proof: ModuleType,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
    ci: str,
    code: int,
) -> None:
    monkeypatch.setenv("CI", ci)
    monkeypatch.setattr(proof, "ARTIFACTS", tmp_path)
    report = tmp_path / "report.xml"
    write = f"import pathlib; pathlib.Path({str(report)!r}).write_text({REPORT!r})"
    step = proof.Step("tests", "style", (sys.executable, "-c", write), report)
    monkeypatch.setattr(proof, "steps", lambda _jobs, *, whole: [step])
    assert proof.main([]) == code
    assert ("test_light (no Chromium)" in capfd.readouterr().out) == bool(code)


def test_workers_can_be_chosen(proof: ModuleType) -> None:
    assert proof.steps("7")[-1].command[-2:] == ("-n", "7")


def test_the_core_leaves_out_what_belongs_to_the_whole_run(proof: ModuleType) -> None:
    tests, all_tests = (proof.steps(whole=whole)[-1] for whole in (False, True))
    marks = tests.command.index("-m", 3) + 1
    assert tests.command[marks] == "not whole"
    assert "not whole" not in all_tests.command


def test_how_busy_the_processors_were_is_kept(
    proof: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    looks = iter([(100, 1000), (130, 1100), (190, 1200)])
    monkeypatch.setattr(proof, "busy_and_all", lambda: next(looks))
    kept = tmp_path / "processors.tsv"
    with proof.BusyProcessors(kept) as processors:
        processors._look()
    assert [line.split("\t")[2] for line in kept.read_text().splitlines()] == ["busy", "0.30", "0.60"]
    assert processors.share == 0.45


def test_a_processor_at_work_is_counted(proof: ModuleType) -> None:
    busy, total = proof.busy_and_all()
    until = time.process_time() + 0.2
    while time.process_time() < until:
        pass
    later_busy, later_total = proof.busy_and_all()
    assert 0.1 * os.sysconf("SC_CLK_TCK") <= later_busy - busy <= later_total - total


def test_the_ci_script_is_sound() -> None:
    script = RUN.parents[1] / ".ci" / "run"
    assert script.stat().st_mode & 0o111
    subprocess.run(["sh", "-n", str(script)], check=True)


def test_tests_that_never_end_are_interrupted_and_fail(proof: ModuleType) -> None:
    endless = proof.Step(
        "pytest", "pytest", (sys.executable, "-c", "import threading; threading.Event().wait()")
    )
    assert proof._run_tests(endless, dict(os.environ), 0.5) == ["pytest (did not end within 0.5 s)"]


def test_a_failed_test_is_not_run_again(
    proof: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An unreliable test must be repaired instead."""
    monkeypatch.setattr(proof, "ARTIFACTS", tmp_path)
    runs = tmp_path / "runs"
    program = f"open({str(runs)!r}, 'a').write('x'); raise SystemExit(1)"
    step = proof.Step("pytest", "pytest", (sys.executable, "-c", program), tmp_path / "pytest.xml")
    assert proof.run([step], lambda _: None) == ["pytest (exit 1)"]
    assert runs.read_text() == "x"

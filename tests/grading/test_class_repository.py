"""The workflow of a class repository: its rules, and its commands, run in a folder that replaces a runner."""

import base64
import json
import os
import re
import subprocess
import sys
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import pytest
import yaml
from markdown_it import MarkdownIt

from workbook.authoring.tree import Tree
from workbook.authoring.wrong_answers import read_wrong_answer
from workbook.cli.main import main
from workbook.criteria.runner import CriterionResult
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import Judgement, judge_recording
from workbook.feedback.markdown import as_markdown, plain
from workbook.grading import github
from workbook.grading.github import Pushed, all_hold, classroom, encoded, not_run, runners, summary
from workbook.grading.hand_ins import hand_in_named
from workbook.grading.new_results import GradedBy, Submission, graded_result, ungradable_result
from workbook.grading.packaging import CannotPackage, commit_of, origin_of
from workbook.grading.results import Result, ResultStatus
from workbook.isolation.bubblewrap import sandbox_problem
from workbook.recording.recording import Recording

ROOT = Path(__file__).resolve().parents[2]
STEM, OTHER = "09_joint_positions", "05_timers"
EXERCISE = load_exercise(STEM, ROOT)
COMMIT = "0123456789abcdef0123456789abcdef01234567"
SOLUTION = EXERCISE.source.solution_code


def result(out: Path, recording: str) -> Result:
    stored = Recording.load(ROOT / "tests" / "recordings" / STEM / f"{recording}.json")
    judgement = judge_recording(EXERCISE, "a" * 64, stored)
    return graded_result(Submission("x", "x.py", "a" * 64), [judgement], GradedBy(EXERCISE, "sandbox", out))


def refused(status: ResultStatus = "ungradable") -> Result:
    by = GradedBy(EXERCISE, "sandbox", Path())
    return replace(ungradable_result(Submission("x", "x.py", ""), "the answer is empty", by), status=status)


# --- Classroom's results --------------------------------------------------------------------------------------------


def report(variables: dict[str, str], names: str) -> dict[str, float]:
    """Return what Classroom's reporter makes of its variables; raises where the reporter would."""
    assert re.fullmatch(r"([a-zA-Z0-9]+,)*[a-zA-Z0-9]+", names)
    total = most = table = 0.0
    failed = False
    for name in names.split(","):
        one = json.loads(base64.b64decode(variables[f"{name.upper()}_RESULTS"], validate=True))
        assert one["version"] == 3
        assert one["status"] in ("pass", "fail", "error")
        assert one["tests"], "the reporter fails on a result without tests"
        for test in one["tests"]:
            assert {
                "name",
                "status",
                "score",
                "message",
                "test_code",
                "filename",
                "line_no",
                "duration",
            } == set(test)
        total += sum(test["score"] for test in one["tests"])
        most += one["max_score"]
        table += sum(test["status"] == "pass" for test in one["tests"]) / len(one["tests"]) * one["max_score"]
        failed = failed or one["status"] != "pass"
    return {"total": total, "most": most, "table": table, "failed": failed}


def reported(pushed: Pushed) -> dict[str, float]:
    results = classroom(pushed)
    return report(
        {f"{name.upper()}_RESULTS": encoded(one) for name, one in results.items()}, ",".join(results)
    )


def test_points_and_the_reporters_table_agree(tmp_path: Path) -> None:
    assert reported(Pushed(EXERCISE, result(tmp_path, "solution"))) == {
        "total": 10, "most": 10, "table": 10, "failed": False,
    }  # fmt: skip
    assert reported(Pushed(EXERCISE, result(tmp_path, "wrong_name"))) == {
        "total": 3, "most": 10, "table": 3, "failed": True,
    }  # fmt: skip


@pytest.mark.parametrize(
    ("found", "status", "says"),
    [
        (None, "fail", "Nothing is handed in"),
        (refused(), "fail", "the answer is empty"),
        (refused("infra_error"), "error", "the answer is empty"),
    ],
    ids=["nothing", "ungradable", "ours"],
)
def test_without_a_judgement_there_are_tests_all_the_same(
    found: Result | None, status: str, says: str
) -> None:
    pushed = Pushed(EXERCISE, found)
    assert reported(pushed) == {"total": 0, "most": 10, "table": 0, "failed": True}
    for one in classroom(pushed).values():
        assert one["status"] == status
        assert says in one["tests"][0]["message"]


def test_a_hidden_criterion_is_not_given_away(tmp_path: Path) -> None:
    hidden = replace(EXERCISE, criteria=tuple(replace(one, hidden=True) for one in EXERCISE.criteria))
    found = result(tmp_path, "eleven_values")
    found = replace(found, criteria=tuple(replace(one, hidden=True) for one in found.criteria))
    text = json.dumps(classroom(Pushed(hidden, found)))
    assert "11 values" not in text
    assert "Every message has exactly 12 values" not in text


def test_what_holds_is_green_and_what_nobody_handed_in_is_not_red(tmp_path: Path) -> None:
    good, poor = (Pushed(EXERCISE, result(tmp_path, name)) for name in ("solution", "eleven_values"))
    nothing = Pushed(EXERCISE, None)
    assert all_hold([good, nothing])
    assert not all_hold([nothing])
    assert not all_hold([good, poor])
    assert not all_hold([Pushed(EXERCISE, refused())])


# --- the page -------------------------------------------------------------------------------------------------------

EVIL = [
    "<script>alert(1)</script>",
    "![x](http://127.0.0.1/x.png)",
    "[x](javascript:alert(1))",
    "</pre></details><img src=x onerror=alert(1)>",
    "`a` **b** _c_ | d ~~e~~ # f",
    "</td></tr></table>\n\n# big\n\n- list",
    "http://example.invalid www.example.invalid <http://example.invalid>",
    "&lt;b&gt; &#60;b&#62;",
]
ALLOWED = {
    "p", "strong", "table", "tr", "th", "td", "details", "summary", "pre", "sub", "h2", "h3", "code", "tbody", "thead",
}  # fmt: skip


class Page(HTMLParser):
    def __init__(self, markdown: str) -> None:
        super().__init__()
        self.tags: set[str] = set()
        self.words = ""
        renderer = MarkdownIt("commonmark", {"html": True}).enable(["table", "strikethrough"])
        self.feed(renderer.render(markdown))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        assert not attrs, f"<{tag} {attrs}>"
        self.tags.add(tag)

    def handle_data(self, data: str) -> None:
        self.words += data


@pytest.mark.parametrize("text", EVIL)
def test_text_of_a_program_stays_text(text: str) -> None:
    page = Page(f"Seen: {plain(text)}\n\n<table><tr><td>{plain(text)}</td></tr></table>")
    assert page.tags == {"p", "table", "tr", "td"}
    assert page.words.count(" ".join(text.split())) == 2


@pytest.mark.parametrize("text", EVIL)
def test_a_card_shows_a_program_and_runs_nothing_of_it(text: str) -> None:
    from dataclasses import replace

    one = CriterionResult("a", text, "failed", 0.0, 2.0, False, text, text, text, text)
    stored = Recording.load(ROOT / "tests" / "recordings" / STEM / "raises_at_once.json")
    log = f"first\n\n{text}\n\n\n    last"
    recording = replace(stored, process=replace(stored.process, log=log, end_log=""))
    page = Page(as_markdown(Judgement(STEM, "a" * 64, "graded", None, (one,), recording)))
    assert page.tags <= ALLOWED
    assert log in page.words, "what it printed is shown as it is"
    assert "0 of 2 points." in page.words


def test_the_page_says_it_all(tmp_path: Path) -> None:
    other = load_exercise(OTHER, ROOT)
    pushed = [Pushed(EXERCISE, result(tmp_path, "eleven_values")), Pushed(other, None)]
    page = Page(summary(pushed, tmp_path, "sandbox"))
    assert page.tags <= ALLOWED
    for words in (
        "9 of 10", "Start with this criterion: Every message has exactly 12 values", "11 values", "nothing handed in",
        "Push it as answers/05_timers.py", "Isolation: sandbox",
    ):  # fmt: skip
        assert words in page.words


# --- which file is the answer ---------------------------------------------------------------------------------------


def test_only_a_file_that_names_the_exercise_is_its_answer(tmp_path: Path) -> None:
    (tmp_path / "05_timers.py").write_text("x = 1\n")
    assert hand_in_named("x", tmp_path, STEM) is None
    (tmp_path / "09_joint_positions.py").write_text("x = 1\n")
    hand_in = hand_in_named("x", tmp_path, STEM)
    assert hand_in is not None
    assert (hand_in.label, hand_in.problem) == ("09_joint_positions.py", None)
    (tmp_path / "joint_positions_old.py").write_text("x = 1\n")
    twice = hand_in_named("x", tmp_path, STEM)
    assert twice is not None
    assert "2 files could be the answer" in (twice.problem or "")
    (tmp_path / "answers").mkdir()
    assert hand_in_named("x", tmp_path, STEM) is None, "where there is a folder answers, that one counts"


# --- the workflow ---------------------------------------------------------------------------------------------------


def workflow(folder: Path, *more: str, course: str = "https://example.invalid/course.git") -> dict[Any, Any]:
    command = ["package", "github", "joint_positions", OTHER, "--out", str(folder), "--course", course]
    assert main([*command, *(more or ("--revision", COMMIT))]) == 0
    text = (folder / ".github" / "workflows" / "classroom.yml").read_text()
    assert not re.search(r"@[A-Z]+@", text)
    found = yaml.safe_load(text)
    assert isinstance(found, dict)
    return found


def steps(found: dict[Any, Any]) -> list[dict[str, Any]]:
    [job] = found["jobs"].values()
    return list(job["steps"])


@pytest.mark.parametrize("more", [(), ("--reporter", "--revision", COMMIT)], ids=["plain", "reporter"])
def test_the_workflow_gives_an_answer_no_right_and_no_token(more: tuple[str, ...], tmp_path: Path) -> None:
    found = workflow(tmp_path, *more)
    assert found["name"] == "Autograding Tests"
    assert set(found[True]) == {"push", "pull_request", "workflow_dispatch"}, "YAML 1.1 reads `on` as true"
    assert found["permissions"] == {"contents": "read"}
    assert list(found["jobs"]) == ["run-autograding-tests"]
    job = found["jobs"]["run-autograding-tests"]
    assert "permissions" not in job
    text = (tmp_path / ".github" / "workflows" / "classroom.yml").read_text()
    assert not re.search(r"secrets|github\.token|GITHUB_TOKEN|pull_request_target", text)
    for step in steps(found):
        assert ("run" in step) != ("uses" in step)
        assert "${{" not in step.get("run", ""), "nothing of an event becomes part of a command"
        if "run" in step:
            checked = subprocess.run(["bash", "-n"], input=step["run"], text=True, capture_output=True)
            assert (checked.returncode, checked.stderr) == (0, "")
        else:
            assert re.fullmatch(r"(actions|classroom-resources)/[a-z-]+@v\d+", step["uses"])
    [checkout] = [step for step in steps(found) if step.get("uses", "").startswith("actions/checkout")]
    assert checkout["with"] == {"path": "hand-in", "persist-credentials": False}
    [judge] = [step for step in steps(found) if step.get("id") == "judge"]
    assert "--isolation sandbox" in judge["run"]


def test_the_reporter_gets_a_result_even_when_the_judge_left_none(tmp_path: Path) -> None:
    found = workflow(tmp_path, "--reporter", "--revision", COMMIT)
    step = steps(found)[-1]
    assert step["if"] == "always()"
    expected = {**runners(EXERCISE), **runners(load_exercise(OTHER, ROOT))}
    assert step["with"]["runners"].split(",") == list(expected)
    variables = {}
    for name, expression in step["env"].items():
        said = re.fullmatch(r"\$\{\{ steps\.judge\.outputs\.(\w+) \|\| '([A-Za-z0-9+/=]+)' \}\}", expression)
        assert said is not None
        assert name == f"{said[1].upper()}_RESULTS"
        variables[name] = said[2]
    most = sum(one.points for one in expected.values())
    assert report(variables, step["with"]["runners"]) == {
        "total": 0,
        "most": most,
        "table": 0,
        "failed": True,
    }
    assert not_run(next(iter(expected.values())))["status"] == "error"


@pytest.mark.parametrize(
    ("options", "says"),
    [
        (["--course", "https://x/y", "--revision", "main"], "not a full commit id"),
        (["--course", 'x" && reboot', "--revision", COMMIT], "not an address"),
        (["--course", "${{ secrets.X }}", "--revision", COMMIT], "not an address"),
        (["--course", "--upload-pack=x", "--revision", COMMIT], "not an address"),
    ],
)
def test_an_address_or_a_commit_that_is_none_is_refused(
    options: list[str], says: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    command = ["package", "github", STEM, "--out", str(tmp_path)]
    command += [f"{name}={value}" for name, value in zip(options[::2], options[1::2], strict=True)]
    assert main(command) == 2
    assert says in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("origin", "address"),
    [
        ("https://example.invalid/robots/course.git", "https://example.invalid/robots/course.git"),
        ("git@example.invalid:robots/course.git", "https://example.invalid/robots/course.git"),
        ("ssh://git@example.invalid/robots/course.git", "https://example.invalid/robots/course.git"),
    ],
)
def test_the_address_of_the_course_needs_no_key(origin: str, address: str, tmp_path: Path) -> None:
    git(tmp_path, "init", "--quiet")
    git(tmp_path, "remote", "add", "origin", origin)
    assert origin_of(tmp_path) == address


def test_a_course_that_others_cannot_fetch_is_said(tmp_path: Path) -> None:
    with pytest.raises(CannotPackage, match="Say where the course can be found"):
        origin_of(tmp_path)
    git(tmp_path, "init", "--quiet")
    git(tmp_path, "remote", "add", "origin", str(tmp_path / "elsewhere"))
    with pytest.raises(CannotPackage, match="no one else can fetch"):
        origin_of(tmp_path)


def test_changes_that_are_not_committed_are_said(tmp_path: Path) -> None:
    git(tmp_path, "init", "--quiet")
    (tmp_path / "a").write_text("1")
    git(tmp_path, "add", "a")
    git(tmp_path, "commit", "--quiet", "-m", "a")
    assert commit_of(tmp_path) == git(tmp_path, "rev-parse", "HEAD")
    (tmp_path / "a").write_text("other")
    with pytest.raises(CannotPackage, match="not committed"):
        commit_of(tmp_path)


class Runner:
    """A folder that replaces GitHub's runner.

    `make env` and `sudo` are fakes, because the real ones would install things.
    """

    def __init__(self, folder: Path, course: Path) -> None:
        self.folder = folder
        self.workspace, self.temp, tools = folder / "workspace", folder / "temp", folder / "tools"
        for one in (self.workspace / "hand-in" / "answers", self.temp, tools):
            one.mkdir(parents=True)
        self.answers = self.workspace / "hand-in" / "answers"
        self._tool(tools, "sudo", "exit 0")
        self._tool(tools, "make", f'test "$1 $3" = "-C env" && ln -s "{sys.prefix}" "$2/.venv"')
        self.files = {name: folder / name for name in ("summary", "outputs")}
        for path in self.files.values():
            path.touch()
        commit = git(course, "rev-parse", "HEAD")
        self.workflow = workflow(folder / "class", "--revision", commit, course=str(course))
        self.environ = {
            "PATH": f"{tools}:{os.environ['PATH']}",
            "HOME": str(folder),
            "RUNNER_TEMP": str(self.temp),
            "GITHUB_WORKSPACE": str(self.workspace),
            "GITHUB_STEP_SUMMARY": str(self.files["summary"]),
            "GITHUB_OUTPUT": str(self.files["outputs"]),
            "A_TOKEN_OF_THE_RUNNER": "not-for-answers",
            **self.workflow["jobs"]["run-autograding-tests"]["env"],
        }

    @staticmethod
    def _tool(folder: Path, name: str, line: str) -> None:
        (folder / name).write_text(f"#!/bin/sh\n{line}\n")
        (folder / name).chmod(0o755)

    def run(self) -> subprocess.CompletedProcess[str]:
        """Run the commands of all steps as the runner does. Stop at the first step that fails."""
        for step in steps(self.workflow):
            if "run" not in step:
                continue
            done = subprocess.run(
                ["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", step["run"]],
                cwd=self.workspace,
                env=self.environ,
                capture_output=True,
                text=True,
            )
            if done.returncode:
                break
        return done

    def outputs(self) -> dict[str, str]:
        lines = self.files["outputs"].read_text().splitlines()
        return {
            f"{name.upper()}_RESULTS": value for name, _, value in (line.partition("=") for line in lines)
        }

    def page(self) -> Page:
        return Page(self.files["summary"].read_text())


def git(folder: Path, *arguments: str) -> str:
    who = ["-c", "user.name=x", "-c", "user.email=x@example.invalid", "-c", "commit.gpgsign=false"]
    done = subprocess.run(["git", *who, *arguments], cwd=folder, capture_output=True, text=True, check=True)
    return done.stdout.strip()


@pytest.fixture(scope="module")
def course(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Make a repository of the current course, with one commit."""
    folder = tmp_path_factory.mktemp("course")
    wanted = (
        "Makefile",
        "pyproject.toml",
        "README.md",
        "requirements.lock",
        "workbook",
        "exercises",
        "solutions",
    )
    names = git(ROOT, "ls-files", "--cached", "--others", "--exclude-standard", "--", *wanted).splitlines()
    for name in names:
        if (ROOT / name).is_file():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_bytes((ROOT / name).read_bytes())
    git(folder, "init", "--quiet")
    git(folder, "add", "--all")
    git(folder, "commit", "--quiet", "-m", "The course")
    return folder


def needs_a_box() -> None:
    problem = sandbox_problem()
    if problem is not None:
        pytest.skip(f"programs cannot be sandboxed: {problem}")


@pytest.mark.whole
@pytest.mark.sandbox
@pytest.mark.slow
def test_the_commands_of_the_workflow_judge_what_was_pushed(tmp_path: Path, course: Path) -> None:
    needs_a_box()
    runner = Runner(tmp_path, course)
    spy = 'import os\nprint("ENVIRON", sorted(os.environ), os.path.exists("/proc/1/environ"), flush=True)\n'
    (runner.answers / f"{STEM}.py").write_text(spy + SOLUTION)
    own = runner.workspace / "hand-in" / "exercises" / "criteria"
    own.mkdir(parents=True)
    (own / f"{STEM}.py").write_text("raise SystemExit('criteria of the student')\n")
    (runner.workspace / "hand-in" / "workbook").mkdir()
    (runner.workspace / "hand-in" / "workbook" / "__init__.py").write_text(
        "raise SystemExit('of the student')\n"
    )
    done = runner.run()
    assert done.returncode == 0, done.stdout + done.stderr
    page = runner.page()
    assert page.tags <= ALLOWED
    assert "Full marks: 10 of 10 points." in page.words
    assert "Isolation: sandbox" in page.words
    assert "nothing handed in" in page.words
    assert "ENVIRON" in page.words
    assert "A_TOKEN_OF_THE_RUNNER" not in page.words
    assert "not-for-answers" not in runner.files["summary"].read_text()
    names = ",".join(runners(EXERCISE))
    assert report(runner.outputs(), names) == {"total": 10, "most": 10, "table": 10, "failed": False}
    kept = runner.temp / "graded"
    assert json.loads((kept / "results.jsonl").read_text())["score"] == 10
    assert {path.stem for path in (kept / "classroom").glob("e09*.json")} == set(runners(EXERCISE))
    assert git(runner.temp / "course", "rev-parse", "HEAD") == git(course, "rev-parse", "HEAD")


@pytest.mark.sandbox
@pytest.mark.slow
@pytest.mark.whole
def test_a_wrong_answer_makes_the_run_red_and_says_why(tmp_path: Path, course: Path) -> None:
    needs_a_box()
    runner = Runner(tmp_path, course)
    wrong = read_wrong_answer(Tree(ROOT), Tree(ROOT).wrong_answers / STEM / "eleven_values.py")
    (runner.answers / "joint_positions.py").write_text(wrong.answer.text, encoding="utf-8")
    assert runner.run().returncode == 1
    assert "11 values" in runner.page().words
    assert report(runner.outputs(), ",".join(runners(EXERCISE)))["total"] == 9


def test_another_commit_than_the_pinned_one_is_not_run(tmp_path: Path, course: Path) -> None:
    runner = Runner(tmp_path, course)
    runner.environ["COURSE_REVISION"] = COMMIT
    assert runner.run().returncode != 0
    assert not (runner.temp / "course" / "workbook").exists()
    assert runner.outputs() == {}


@pytest.mark.parametrize("where", ["github", "gradescope"])
def test_no_file_name_is_a_command_to_the_log(
    where: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """GitHub interprets a line that begins with :: as a command, and `reason` contains students' file names."""
    answers = tmp_path / "answers"
    answers.mkdir()
    for name in (f"{STEM}\n::error::hacked\x1b[2J.py", f"{STEM}_2\r::stop-commands::x.py"):
        (answers / name).write_text("x = 1\n")
    command = ["autograde", where, STEM, "--isolation", "limits"]
    if where == "github":
        command += ["--answers", str(answers), "--out", str(tmp_path / "out")]
        command += ["--summary", str(tmp_path / "summary"), "--outputs", str(tmp_path / "outputs")]
    else:
        command += ["--submission", str(answers), "--results", str(tmp_path / "results.json")]
    main(command)
    [line] = capsys.readouterr().out.splitlines()
    assert line.startswith(f"{STEM}: ungradable, 2 files could be the answer") and line.isprintable()
    if where == "github":
        lines = (tmp_path / "outputs").read_text().splitlines()
        assert all(re.fullmatch(r"\w+=[\w+/=]+", one) for one in lines)
        assert not re.search(r"^::", (tmp_path / "summary").read_text(), re.MULTILINE)


def test_a_fault_of_ours_is_told_as_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from workbook.grading import github

    def breaks(*_: object) -> None:
        raise OSError("the disk is full <b>")

    monkeypatch.setattr(github, "grade_pushed", breaks)
    page, outputs = tmp_path / "summary", tmp_path / "outputs"
    command = ["autograde", "github", STEM, "--answers", str(tmp_path), "--out", str(tmp_path / "out")]
    command += ["--summary", str(page), "--outputs", str(outputs), "--isolation", "limits"]
    assert main(command) == 2
    found = Page(page.read_text())
    assert "The judge itself failed, not your program: the disk is full <b>" in found.words
    assert "No points are lost" in found.words
    lines = dict(line.split("=", 1) for line in outputs.read_text().splitlines())
    assert (
        report({f"{name.upper()}_RESULTS": value for name, value in lines.items()}, ",".join(lines))["total"]
        == 0
    )


def test_the_only_answer_to_the_only_exercise_needs_no_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(github, "grade_one", lambda exercise, hand_in, *_: hand_in)
    (tmp_path / "answers").mkdir()
    assert github.grade_pushed([EXERCISE], tmp_path, tmp_path, "limits")[0].result is None
    path = tmp_path / "answers" / "homework.py"
    path.write_text(SOLUTION)
    (only,) = github.grade_pushed([EXERCISE], tmp_path, tmp_path, "limits")
    assert only.result is not None and getattr(only.result, "path", None) == path
    several = github.grade_pushed([EXERCISE, load_exercise(OTHER, ROOT)], tmp_path, tmp_path, "limits")
    assert [one.result for one in several] == [None, None]

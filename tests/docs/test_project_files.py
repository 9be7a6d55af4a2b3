"""Files that a code-hosting site reads: the citation, the issue forms, and the release workflow."""

import re
import tomllib
from pathlib import Path
from typing import Any

import pytest
import yaml

import workbook
from workbook.cli.main import build_parser

ROOT = Path(__file__).resolve().parents[2]
FORMS = sorted((ROOT / ".github" / "ISSUE_TEMPLATE").glob("[0-9]*.yml"))
COMMAND = "workbook doctor --report"


def read(path: Path) -> Any:
    return yaml.safe_load(path.read_text(encoding="utf-8"))


def test_every_place_names_one_version() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert project["version"] == workbook.__version__ == str(read(ROOT / "CITATION.cff")["version"])


@pytest.mark.parametrize("path", FORMS, ids=lambda path: path.stem)
def test_a_form_has_what_a_form_needs(path: Path) -> None:
    form = read(path)
    assert form["name"] and form["description"]
    names = [part["id"] for part in form["body"]]
    assert len(set(names)) == len(names) > 0
    assert all(part["attributes"]["label"] for part in form["body"])


def test_what_may_depend_on_the_machine_is_told_with_the_doctors_report() -> None:
    asking = [path.stem for path in FORMS if f"`{COMMAND}`" in path.read_text(encoding="utf-8")]
    assert asking == ["1_does_not_run", "2_wrong_verdict"]
    assert build_parser().parse_args(COMMAND.split()[1:]).report


def test_a_release_needs_no_password_and_builds_without_the_right_to_publish() -> None:
    text = (ROOT / ".github" / "workflows" / "release.yml").read_text(encoding="utf-8")
    assert not re.search(r"secrets\.|password|token:(?! write)", text.replace("no password", ""))
    jobs = yaml.safe_load(text)["jobs"]
    assert "permissions" not in jobs["build"]
    assert jobs["publish"]["permissions"] == {"id-token": "write"}
    assert jobs["publish"]["environment"] == "release"
    assert any("pytest" in step.get("run", "") for step in jobs["build"]["steps"])


def test_the_site_is_published_by_pinned_actions_and_only_from_main() -> None:
    workflow = read(ROOT / ".github" / "workflows" / "site.yml")
    build, publish = workflow["jobs"]["build"], workflow["jobs"]["publish"]
    used = [step["uses"] for job in (build, publish) for step in job["steps"] if "uses" in step]
    assert len(used) == 4
    assert all(re.fullmatch(r"actions/[a-z-]+@[0-9a-f]{40}", one) for one in used)
    assert build["steps"][-1]["with"]["path"] == "build/site"
    assert workflow["permissions"] == {"contents": "read"} and "permissions" not in build
    assert publish["permissions"] == {"pages": "write", "id-token": "write"}
    assert publish["needs"] == "build" and "refs/heads/main" in publish["if"]

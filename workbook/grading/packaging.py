"""Package the judge for other systems: an autograder for Gradescope, or a workflow for a class repository."""

import os
import re
import subprocess
import zipfile
from collections.abc import Iterator, Sequence
from pathlib import Path

from workbook.exercise.definition import OWN_CRITERIA, Exercise
from workbook.exercise.without_solution import without_solution
from workbook.grading.files import write_whole
from workbook.grading.github import encoded, not_run, runners

GRADESCOPE_FILES = Path(__file__).with_name("gradescope_files")
WORKFLOW = Path(".github", "workflows", "classroom.yml")
_EPOCH = (1980, 1, 1, 0, 0, 0)
_PROJECT = ("pyproject.toml", "requirements.lock", "README.md", "LICENSE", "LICENSE-TEXT")
_ADDRESS = re.compile(r"[A-Za-z0-9][A-Za-z0-9@:/._~+-]*|/[A-Za-z0-9@:/._~+-]+")
_WITH_KEY = re.compile(r"(?:ssh://)?git@(?P<host>[\w.-]+)[:/](?P<path>[^:]+)")
_REVISION = re.compile(r"[0-9a-f]{40}")


class CannotPackage(RuntimeError):
    """Raised when the package can't be built. The message says why and what to do."""


# --- Gradescope -----------------------------------------------------------------------------------------------------


def gradescope_zip(exercise: Exercise, course: Path, target: Path) -> list[str]:
    """Write one exercise's autograder as a zip file. Return the names of the files in the zip file.

    For the same course, the bytes are always the same.
    """
    entries: dict[str, tuple[bytes, bool]] = {
        "setup.sh": ((GRADESCOPE_FILES / "setup.sh").read_bytes(), True),
        "run_autograder": (
            (GRADESCOPE_FILES / "run_autograder")
            .read_text(encoding="utf-8")
            .replace("@EXERCISE@", exercise.stem)
            .encode(),
            True,
        ),
    }
    for name, content in _course_files(exercise, course):
        entries[f"course/{name}"] = (content, False)
    target.parent.mkdir(parents=True, exist_ok=True)
    partial = target.with_name(f".{target.name}.part")
    with zipfile.ZipFile(partial, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name in sorted(entries):
            content, executable = entries[name]
            entry = zipfile.ZipInfo(name, _EPOCH)
            entry.create_system = 3  # Unix; otherwise, the permissions are ignored
            entry.external_attr = (0o100755 if executable else 0o100644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)
    partial.replace(target)
    return sorted(entries)


def _course_files(exercise: Exercise, course: Path) -> Iterator[tuple[str, bytes]]:
    """Yield the files that are needed to grade one exercise: their names relative to the course, and their contents.

    Other exercises, the lessons, and example answers are left out.
    """
    stem = exercise.stem
    for name in _PROJECT:
        yield name, (course / name).read_bytes()
    yield from files_below(course, "workbook")
    for path in sorted((course / "exercises" / "criteria").glob(f"{stem}.*")):
        yield f"exercises/criteria/{path.name}", path.read_bytes()
    if exercise.driver is not None:
        yield f"exercises/drivers/{stem}.py", exercise.driver.read_bytes()
    yield f"solutions/{stem}.py", without_solution(exercise.source, hints=False).encode()
    own = os.environ.get(OWN_CRITERIA)
    if own:
        path = Path(own) / f"{stem}.py"
        if not path.is_file():
            raise CannotPackage(f"{own} holds no {stem}.py with your own criteria")
        for one in sorted(Path(own).glob(f"{stem}.*")):
            yield f"own_criteria/{one.name}", one.read_bytes()


def files_below(course: Path, folder: str) -> Iterator[tuple[str, bytes]]:
    """Yield the names and contents of the files in a folder of the course.

    Skip files that tools and editors leave there.
    """
    for path in sorted((course / folder).rglob("*")):
        parts = path.relative_to(course / folder).parts
        left_by_tools = any(part.startswith(".") or part == "__pycache__" for part in parts)
        if path.is_file() and not path.is_symlink() and not left_by_tools:
            yield path.relative_to(course).as_posix(), path.read_bytes()


# --- a class repository at GitHub -----------------------------------------------------------------------------------


def classroom_workflow(
    exercises: Sequence[Exercise], folder: Path, address: str, revision: str, *, reporter: bool = False
) -> Path:
    """Write the workflow for a class repository into `folder`. Return the workflow's path.

    `address` and `revision` identify the course's Git repository and commit. `reporter`: whether to also report the
    points to GitHub Classroom. Raises CannotPackage if the address or the commit is invalid.
    """
    if not _ADDRESS.fullmatch(address):
        raise CannotPackage(f"{address!r} is not an address that git can fetch from")
    if not _REVISION.fullmatch(revision):
        raise CannotPackage(f"{revision!r} is not a full commit id (40 digits and letters a to f)")
    text = (GRADESCOPE_FILES / "classroom.yml").read_text(encoding="utf-8")
    if reporter:
        text = text.replace("        id: judge\n", "        id: judge\n        continue-on-error: true\n")
        text += _reporter(exercises)
    words = {"ADDRESS": address, "REVISION": revision, "EXERCISES": " ".join(one.stem for one in exercises)}
    for name, word in words.items():
        text = text.replace(f"@{name}@", word)
    return write_whole(folder / WORKFLOW, text)


def _reporter(exercises: Sequence[Exercise]) -> str:
    """Return the workflow's step that reports the points to GitHub Classroom.

    If the judge didn't write any output, the step reports that the judge didn't finish.
    """
    names, lines = [], []
    for exercise in exercises:
        for name, criterion in runners(exercise).items():
            names.append(name)
            otherwise = encoded(not_run(criterion))
            lines.append(
                f"          {name.upper()}_RESULTS: ${{{{ steps.judge.outputs.{name} || '{otherwise}' }}}}\n"
            )
    return (
        "      - name: Tell GitHub Classroom\n"
        "        if: always()\n"
        "        uses: classroom-resources/autograding-grading-reporter@v1\n"
        f"        env:\n{''.join(lines)}"
        f"        with:\n          runners: {','.join(names)}\n"
    )


def origin_of(course: Path) -> str:
    """Return the HTTPS address of the course's Git repository. An SSH address is converted, because it requires a key.

    Raises CannotPackage if git doesn't know the address or if other people can't fetch from it.
    """
    advice = "Say where the course can be found: --course https://..."
    origin = _git(course, "remote", "get-url", "origin", otherwise=advice)
    with_key = _WITH_KEY.fullmatch(origin)
    address = f"https://{with_key['host']}/{with_key['path']}" if with_key else origin
    if not address.startswith("https://"):
        raise CannotPackage(f"your origin is {origin}, which no one else can fetch from. {advice}")
    return address


def commit_of(course: Path) -> str:
    """Return the ID of the course's current commit.

    Raises CannotPackage if there are uncommitted changes or if git fails.
    """
    advice = "Say which commit is meant: --revision COMMIT"
    if _git(course, "status", "--porcelain", "--untracked-files=no", otherwise=advice):
        raise CannotPackage(f"the course has changes that are not committed. Commit and push them. {advice}")
    return _git(course, "rev-parse", "HEAD", otherwise=advice)


def _git(course: Path, *arguments: str, otherwise: str) -> str:
    try:
        done = subprocess.run(["git", "-C", course, *arguments], capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError) as error:
        said = str(getattr(error, "stderr", "") or error).strip().splitlines()[-1]
        raise CannotPackage(f"git failed ({said}). {otherwise}") from error
    return done.stdout.strip()

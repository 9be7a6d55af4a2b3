"""Write requirements.lock: every package with its hashes, in sections, for Python 3.11 to 3.14.

The file is plain requirements text. A line such as `#: dev` opens a section. `build` and `student` make up a student's
environment, and each further section adds to it. All sections are resolved to the same versions, so any combination of
them is compatible. The file doesn't name a package registry, so the installer's own configuration chooses one.
`make lock` runs this module.
"""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LOCK = ROOT / "requirements.lock"
EXTRAS = ("dev", "torch", "tensorflow", "farm", "similar", "site", "hub")
# Build tools for the project itself and for packages without a wheel, and pip for the student's `%pip install`.
BUILD = ("flit_core>=3.11", "setuptools>=78", "pip>=25")
HEADER = """\
# Every package of the environment, pinned, with hashes, for CPython 3.11 to 3.14 on Linux x86_64.
# Written by `make lock` from pyproject.toml; do not edit. A line that starts with `#:` opens a section:
# build and student are what `make env` installs, `make test` adds dev, farm and similar, and
# `make env EXTRAS=X` adds X.
"""
# These markers are true on every supported machine, so the lock file omits them.
_ALWAYS = {
    "platform_machine == 'x86_64'", "sys_platform == 'linux'",
    "implementation_name == 'cpython'", "platform_python_implementation == 'CPython'",
}  # fmt: skip

Entry = dict[str, str]  # requirement line (name, version, marker) → its hash lines


def parse(text: str) -> Entry:
    """Parse the output of `uv export` into requirement lines and their hashes."""
    entries: Entry = {}
    for block in re.split(r"\n(?=[A-Za-z0-9])", text.strip()):
        first, *hashes = [
            line.rstrip(" \\").strip() for line in block.splitlines() if not line.startswith("#")
        ]
        requirement, _, marker = (part.strip() for part in first.partition(";"))
        kept = marker
        if " or " not in marker:
            kept = " and ".join(term for term in marker.split(" and ") if term and term not in _ALWAYS)
        entries[f"{requirement} ; {kept}" if kept else requirement] = "\n".join(hashes)
    return entries


def run(uv: str, *arguments: str) -> str:
    """Run uv and return its output. Raises SystemExit if uv fails."""
    done = subprocess.run([uv, *arguments, "--quiet"], text=True, capture_output=True)
    if done.returncode:
        raise SystemExit(f"uv could not resolve pyproject.toml:\n{done.stderr}")
    return done.stdout


def resolve(uv: str, folder: str, project: str, extras: tuple[str, ...]) -> dict[str, Entry]:
    """Resolve a project file's text in `folder`. An earlier call's versions stay, if they fit.

    Return the packages of the build tools, of a student, and of a student with each of the extras.
    """
    text = f"{project}\n[dependency-groups]\nbuild = {json.dumps(BUILD)}\n"
    Path(folder, "pyproject.toml").write_text(text)
    run(uv, "lock", "--project", folder, *sys.argv[1:])
    flags = {"build": ["--only-group", "build"], "student": [], **{one: ["--extra", one] for one in extras}}
    plain = ("export", "--frozen", "--no-emit-project", "--no-annotate", "--no-header", "--project", folder)
    return {name: parse(run(uv, *plain, *one)) for name, one in flags.items()}


def section(name: str, entries: Entry) -> str:
    """Format one section of the lock file."""
    lines = [f"\n#: {name}"]
    for requirement, hashes in sorted(entries.items()):
        lines.append(" \\\n".join([requirement, *(f"    {line}" for line in hashes.splitlines())]))
    return "\n".join(lines) + "\n"


def main() -> None:
    """Resolve all versions again and write the lock file."""
    uv = shutil.which("uv")
    if uv is None:
        raise SystemExit("make lock needs uv on the PATH (only those who change the dependencies need it).")
    project = (ROOT / "pyproject.toml").read_text()
    without_extras = re.sub(r"(?ms)^\[project.optional-dependencies\].*?(?=^\[)", "", project)
    with tempfile.TemporaryDirectory() as folder:
        alone = resolve(uv, folder, without_extras, ())
        sections = resolve(uv, folder, project, EXTRAS)
    if changed := alone["student"].keys() ^ sections["student"].keys():
        raise SystemExit(f"An extra changes what students get: {', '.join(sorted(changed))}")
    build, known = sections["build"], sections["build"] | sections["student"]
    sections["student"] = {line: hashes for line, hashes in sections["student"].items() if line not in build}
    for extra in EXTRAS:
        sections[extra] = {line: hashes for line, hashes in sections[extra].items() if line not in known}
    LOCK.write_text(HEADER + "".join(section(name, entries) for name, entries in sections.items()))
    print(f"{LOCK.name}: " + ", ".join(f"{name} {len(entries)}" for name, entries in sections.items()))


if __name__ == "__main__":
    main()

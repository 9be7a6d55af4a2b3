"""Write requirements.lock: every package with its hashes, in sections, for Python 3.11 to 3.14.

The file is plain requirements text. A line such as `#: dev` opens a section. `build` and `student` make up a student's
environment, and each further section adds to it. All sections are resolved to the same versions, so any combination of
them is compatible. The file doesn't name a package registry, so the installer's own configuration chooses one.
`make lock` runs this module.
"""

from __future__ import annotations

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
    "platform_machine == 'x86_64'", "sys_platform == 'linux'", "python_full_version < '3.15'",
    "implementation_name == 'cpython'", "platform_python_implementation == 'CPython'",
    "implementation_name != 'PyPy'", "platform_python_implementation != 'PyPy'",
}  # fmt: skip

Entry = dict[str, str]  # requirement line (name, version, marker) → its hash lines


def parse(text: str) -> Entry:
    """Parse the output of `uv pip compile --generate-hashes` into requirement lines and their hashes."""
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


def compile_requirements(uv: str, source: str, *arguments: str) -> str:
    """Run `uv pip compile` on requirements text or `pyproject.toml`. Return the output; raise SystemExit on failure."""
    command = [
        uv, "pip", "compile", "--universal", "--python-version", "3.11", "--generate-hashes", "--no-annotate",
        "--no-header", "--quiet", *arguments,
    ]  # fmt: skip
    if source == "pyproject.toml":
        done = subprocess.run([*command, source], cwd=ROOT, text=True, capture_output=True)
    else:
        done = subprocess.run([*command, "-"], cwd=ROOT, text=True, capture_output=True, input=source)
    if done.returncode:
        raise SystemExit(f"uv could not resolve {source!r}:\n{done.stderr}")
    return done.stdout


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
    with tempfile.TemporaryDirectory() as folder:
        student_text = compile_requirements(uv, "pyproject.toml", *sys.argv[1:])
        constraints = Path(folder, "constraints.txt")
        constraints.write_text(re.sub(r"(?m)( \\)?\n    --hash.*", "", student_text))
        build = parse(compile_requirements(uv, "\n".join(BUILD), "--constraint", str(constraints)))
        student = parse(student_text)
        sections = {"build": build, "student": {line: h for line, h in student.items() if line not in build}}
        known = {**build, **student}
        # All extras are first resolved together, so that they're compatible with each other, too.
        flags = [flag for extra in EXTRAS for flag in ("--extra", extra)]
        everything = compile_requirements(uv, "pyproject.toml", *flags, "--constraint", str(constraints))
        constraints.write_text(
            re.sub(r"(?m)( \\)?\n    --hash.*", "", everything)
            + "\n"
            + "\n".join(f"{line}" for line in build)
        )
        for extra in EXTRAS:
            text = compile_requirements(
                uv, "pyproject.toml", "--extra", extra, "--constraint", str(constraints)
            )
            entries = parse(text)
            sections[extra] = {line: hashes for line, hashes in entries.items() if line not in known}
    LOCK.write_text(HEADER + "".join(section(name, entries) for name, entries in sections.items()))
    print(f"{LOCK.name}: " + ", ".join(f"{name} {len(entries)}" for name, entries in sections.items()))


if __name__ == "__main__":
    main()

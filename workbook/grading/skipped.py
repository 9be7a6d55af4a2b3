"""List the files that look like hand-ins but aren't, with the reasons, so that no answer is lost unnoticed."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from workbook.grading.hand_ins import SKIPPED_FOLDERS, hand_in_root, readable, walk, why_no_answer

_TOOLS = frozenset({".git", ".github", ".vscode", ".idea", ".venv", ".cache", ".config", ".local", ".ros"})
"""Hidden folders that tools create. They can't be a student's folder."""


@dataclass(frozen=True)
class Skipped:
    """A file or folder that wasn't recognized as a hand-in. `reason`: why it wasn't, and what to do."""

    label: str
    reason: str


def find_skipped(paths: Sequence[Path]) -> list[Skipped]:
    """Return all files and folders under `paths` that look like answers but don't have an answer's name."""
    found: list[Skipped] = []
    for path in paths:
        if path.is_dir():
            found += _skipped_below(hand_in_root(path))
    return found


def _skipped_below(root: Path) -> Iterator[Skipped]:
    for base, folders, files in walk(root):
        folder = Path(base)
        if folder == root:
            for name in sorted(folders):
                if name.startswith(".") and name not in _TOOLS | SKIPPED_FOLDERS:
                    yield Skipped(
                        readable(name), "its name begins with a dot, so it counts as hidden: rename it"
                    )
        folders[:] = sorted(
            name for name in folders if name not in SKIPPED_FOLDERS and not name.startswith(".")
        )
        for name in sorted(files):
            reason = why_no_answer(name)
            if reason is not None:
                yield Skipped(readable(str((folder / name).relative_to(root))), readable(reason))


def about_skipped(found: Sequence[Skipped]) -> str:
    """Return sentences that list the skipped files, grouped by reason, or "" if there are none."""
    if not found:
        return ""
    what = (
        "1 file or folder was skipped" if len(found) == 1 else f"{len(found)} files or folders were skipped"
    )
    by_reason: dict[str, list[str]] = {}
    for one in found:
        by_reason.setdefault(one.reason, []).append(one.label)
    told = "; ".join(f"{', '.join(labels)}: {reason}" for reason, labels in by_reason.items())
    return f"{what}. {told}"

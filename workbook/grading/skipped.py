"""Files that look like hand-ins and are none: what was skipped, and why. Nobody's answer gets lost without a word."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from workbook.grading.hand_ins import SKIPPED_FOLDERS, hand_in_root, readable, walk, why_no_answer

_TOOLS = frozenset({".git", ".github", ".vscode", ".idea", ".venv", ".cache", ".config", ".local", ".ros"})
"""Hidden folders that programs make. No student has such a name."""


@dataclass(frozen=True)
class Skipped:
    """A file or folder that was not taken for a hand-in. `reason` says why, and what to do."""

    label: str
    reason: str


def find_skipped(paths: Sequence[Path]) -> list[Skipped]:
    """All that looks like an answer below `paths`, and is none by its name."""
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
    """Return sentences that name everything that was skipped, by reason; empty if nothing was."""
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

"""Write files atomically, with errors that name the file even if the disk is full."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


def write_whole(path: Path, text: str, *, bom: bool = False) -> Path:
    """Write a text file atomically: readers see the old version until the new one is complete. Return the path.

    `bom`: whether to begin the file with a byte order mark. Without it, Excel shows each accented letter as two
    characters.

    Raises OSError if the file can't be written. The error names the file, even if the disk is full.
    """
    partial = path.with_name(f".{path.name}.part")
    with naming(path):
        path.parent.mkdir(parents=True, exist_ok=True)
        try:
            partial.write_text(text, encoding="utf-8-sig" if bom else "utf-8", errors="replace")
        except OSError:
            partial.unlink(missing_ok=True)
            raise
        partial.replace(path)
    return path


@contextmanager
def naming(path: Path) -> Iterator[None]:
    """Add `path` to an OSError that doesn't name a file, such as the error for a full disk."""
    try:
        yield
    except OSError as error:
        if error.filename is None and error.errno is not None:
            raise type(error)(error.errno, error.strerror, str(path)) from error
        raise

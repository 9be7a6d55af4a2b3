"""Temporary folders that do not outlive the process that asked for them."""

import atexit
import os
import shutil
import tempfile
from pathlib import Path


def _root() -> Path:
    return Path(tempfile.gettempdir()) / f"rclpy-workbook-{os.getuid()}"


def _is_running(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    except PermissionError:
        return True
    return True


def sweep_scratch() -> None:
    """Remove folders left by processes that were killed before they could clean up."""
    root = _root()
    if not root.is_dir() or root.is_symlink():
        return
    for folder in root.iterdir():
        pid = folder.name.split("-")[0]
        if pid.isdigit() and not _is_running(int(pid)):
            shutil.rmtree(folder, ignore_errors=True)
    _remove_if_empty(root)


def _remove_if_empty(root: Path) -> None:
    try:
        root.rmdir()
    except OSError:
        pass


def remove_scratch(folder: Path) -> None:
    """Remove a folder made by `scratch_folder`, and the shared parent when it was the last one."""
    shutil.rmtree(folder, ignore_errors=True)
    _remove_if_empty(_root())


def scratch_folder(purpose: str) -> Path:
    """Make a private folder that is removed when this process ends (or by the next one, if it is killed)."""
    sweep_scratch()
    for _ in range(10):
        try:
            _root().mkdir(mode=0o700, exist_ok=True)
            folder = Path(tempfile.mkdtemp(prefix=f"{os.getpid()}-{purpose}-", dir=_root()))
            break
        except FileNotFoundError:  # another process removed the empty parent between the two calls
            continue
    else:
        raise OSError(f"cannot make a temporary folder below {_root()}")
    atexit.register(_remove_in, os.getpid(), folder)
    return folder


def _remove_in(pid: int, folder: Path) -> None:
    if os.getpid() == pid:
        remove_scratch(folder)

"""Create temporary folders that are removed when the process exits."""

import atexit
import os
import shutil
import subprocess
import tempfile
from contextlib import suppress
from pathlib import Path


def _prefix() -> str:
    return f"rclpy-workbook-{os.getuid()}-"


def _is_running(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    except PermissionError:
        return True
    return True


def sweep_scratch() -> None:
    """Remove the temporary folders of processes that were killed before they could clean up."""
    for folder in Path(tempfile.gettempdir()).glob(f"{_prefix()}*"):
        pid = folder.name.removeprefix(_prefix()).split("-")[0]
        if pid.isdigit() and not folder.is_symlink() and not _is_running(int(pid)):
            remove_scratch(folder)


def remove_scratch(folder: Path) -> None:
    """Remove a folder made by `scratch_folder`, even if a program has nested it deeply or removed permissions."""
    with suppress(RecursionError):
        shutil.rmtree(folder, ignore_errors=True)
    if folder.is_dir() and not folder.is_symlink():
        for command in (["chmod", "-R", "u+rwX"], ["rm", "-rf"]):
            subprocess.run([*command, "--", str(folder)], stdin=subprocess.DEVNULL, capture_output=True)


def scratch_folder(purpose: str) -> Path:
    """Create a private folder that's removed when this process exits, or, after a kill, by any process's next call."""
    sweep_scratch()
    folder = Path(tempfile.mkdtemp(prefix=f"{_prefix()}{os.getpid()}-{purpose}-"))
    atexit.register(_remove_in, os.getpid(), folder)
    return folder


def _remove_in(pid: int, folder: Path) -> None:
    if os.getpid() == pid:
        remove_scratch(folder)

"""Set the environment variables of the workbook's ROS processes.

rclpy and the message classes read these variables on their first import or when a context starts, so set the variables
earlier. The ROS wheels restart Python once to set LD_LIBRARY_PATH. A child process may inherit that variable only
together with the one that marks the restart as done.
"""

import os
import re
import sys
from collections.abc import Mapping, MutableMapping
from importlib import metadata
from pathlib import Path

from workbook.ros.domains import DomainLease, lease_domain
from workbook.ros.scratch import scratch_folder

LOOPBACK_PROFILE = Path(__file__).with_name("loopback.xml")
LEASE_S = 2
"""The profile's liveliness lease (s): how long participants remember one that vanished without an announcement."""
LOG_FORMAT = "[{severity}] [{name}]: {message}"

_BOOTSTRAP_DONE = "_ROS_WHEELS_BOOTSTRAP_COMPLETE"
_LEFTOVER_PREFIXES = (
    "ROS_",
    "RMW_",
    "RCUTILS_",
    "FASTRTPS_",
    "FASTDDS_",
    "CYCLONEDDS_",
    "AMENT_",
    "COLCON_",
    "RCL_",
)
_LEFTOVERS = (
    "PYTHONPATH",
    "PYTHONHOME",
    "PYTHONOPTIMIZE",
    "CMAKE_PREFIX_PATH",
    "LD_PRELOAD",
    "PYTHONSTARTUP",
)
_INHERITED = (
    "PATH",
    "HOME",
    "LANG",
    "LC_ALL",
    "LC_CTYPE",
    "TZ",
    "USER",
    "LOGNAME",
    "TMPDIR",
    "XDG_CACHE_HOME",
)

_kernel_lease: DomainLease | None = None
_log_folder: Path | None = None


def uses_wheels() -> bool:
    """Return whether rclpy comes from the pinned wheels, rather than from apt or RoboStack."""
    try:
        metadata.version("ros-jazzy-rclpy")
    except metadata.PackageNotFoundError:
        return False
    return True


def is_leftover(name: str) -> bool:
    """Return whether a variable may come from a sourced ROS or another environment.

    Our processes drop such variables.
    """
    return name in _LEFTOVERS or name.startswith(_LEFTOVER_PREFIXES)


def library_path(environ: Mapping[str, str]) -> dict[str, str]:
    """Return the loader variables that a child process may inherit: those that this environment's wheels have set."""
    if not environ.get(_BOOTSTRAP_DONE):
        return {}
    folders = [folder for folder in environ.get("LD_LIBRARY_PATH", "").split(":") if folder]
    own = [folder for folder in folders if Path(folder).is_relative_to(sys.prefix)]
    if not own:
        return {}
    return {_BOOTSTRAP_DONE: environ[_BOOTSTRAP_DONE], "LD_LIBRARY_PATH": ":".join(own)}


def ros_settings(domain_id: int, *, check_fields: bool, log_folder: Path) -> dict[str, str]:
    """Return the ROS environment variables that restrict a process to loopback and one domain.

    They also make ROS print plain log lines without timestamps. `check_fields`: whether message classes reject values
    of the wrong type, a check that ROS turns off by default.
    """
    settings = {
        "ROS_DOMAIN_ID": str(domain_id),
        "ROS_AUTOMATIC_DISCOVERY_RANGE": "SYSTEM_DEFAULT",
        "FASTRTPS_DEFAULT_PROFILES_FILE": str(LOOPBACK_PROFILE),
        "ROS_LOG_DIR": str(log_folder),
        "RCUTILS_CONSOLE_OUTPUT_FORMAT": LOG_FORMAT,
        "RCUTILS_COLORIZED_OUTPUT": "0",
    }
    if check_fields:
        settings["ROS_PYTHON_CHECK_FIELDS"] = "1"
    return settings


def own_log_folder() -> Path:
    """Return the folder for this process's ROS log files. The folder is removed when the process exits."""
    global _log_folder
    if _log_folder is None or not _log_folder.is_dir():
        _log_folder = scratch_folder("log")
    return _log_folder


def profile_with_lease(folder: Path, lease_s: int) -> Path:
    """Write a loopback profile into `folder` with a liveliness lease of `lease_s` seconds."""
    default, wanted = (f"<leaseDuration><sec>{seconds}</sec>" for seconds in (LEASE_S, lease_s))
    return _changed_profile(folder, re.escape(default), wanted)


def profile_with_default_times(folder: Path) -> Path:
    """Write a loopback profile into `folder` with Fast DDS's default discovery times: an announcement every 3 s.

    Without a profile, Fast DDS would also use shared memory, which a killed program leaves behind.
    """
    return _changed_profile(folder, r"(?s)\s*<discovery_config>.*</discovery_config>", "")


def _changed_profile(folder: Path, pattern: str, wanted: str) -> Path:
    text, changes = re.subn(pattern, wanted, LOOPBACK_PROFILE.read_text(encoding="utf-8"))
    if changes != 1:
        raise ValueError(f"{LOOPBACK_PROFILE.name} has {changes} places like {pattern}, and should have one")
    profile = folder / "profile.xml"
    profile.write_text(text, encoding="utf-8")
    return profile


def child_environment(
    domain_id: int, *, check_fields: bool = False, log_folder: Path | None = None
) -> dict[str, str]:
    """Return a clean environment for a process that we start on `domain_id`."""
    folder = own_log_folder() if log_folder is None else log_folder
    if uses_wheels():
        environ = {name: os.environ[name] for name in _INHERITED if name in os.environ}
        environ |= library_path(os.environ)
    else:
        environ = {
            name: value for name, value in os.environ.items() if not name.startswith(("ROS_PYTHON_CHECK",))
        }
    environ |= ros_settings(domain_id, check_fields=check_fields, log_folder=folder)
    # Otherwise, NumPy and OpenCV start a thread per processor in every node, and these threads count toward the limit
    # on processes.
    environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    environ.setdefault("OPENCV_FOR_THREADS_NUM", "1")
    environ["PYTHONUNBUFFERED"] = "1"
    environ["PYTHONDONTWRITEBYTECODE"] = "1"
    return environ


def prepare(
    environ: MutableMapping[str, str] | None = None,
    *,
    domain_id: int | None = None,
    check_fields: bool = True,
) -> int:
    """Set up this process before its first ROS import, and return its domain.

    Without `domain_id`, the process leases a domain until it exits. It's safe to call this function again.
    """
    global _kernel_lease
    environ = os.environ if environ is None else environ
    if domain_id is None:
        if _kernel_lease is None:
            _kernel_lease = lease_domain()
        domain_id = _kernel_lease.domain_id
    if uses_wheels():
        for name in [name for name in environ if is_leftover(name)]:
            del environ[name]
    environ.update(ros_settings(domain_id, check_fields=check_fields, log_folder=own_log_folder()))
    return domain_id


def is_prepared(environ: Mapping[str, str] | None = None) -> bool:
    """Return whether an environment (default: this process's) sets the loopback profile."""
    return (os.environ if environ is None else environ).get("FASTRTPS_DEFAULT_PROFILES_FILE") == str(
        LOOPBACK_PROFILE
    )

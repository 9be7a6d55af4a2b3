"""Puts Jupyter's settings into the environment, where JupyterLab, VS Code and nbval all find them.

In a clone, the bootstrap runs it inside the environment: `python -m workbook.lab.jupyter_files`. An environment with
the wheel gets the settings from the first `rclpy-workbook lab`.
"""

import json
import sys
from pathlib import Path

# Runs in every kernel of this environment, whichever program starts it: lessons need no set-up cell.
KERNEL_CONFIG = """\
# Written by the rclpy workbook. Sets up ROS and the magics in each kernel of this environment.
c = get_config()  # noqa: F821
try:
    from workbook.lab.kernel import configure
except ImportError as error:
    message = f"The workbook is not set up in this kernel: {error}. "
    message += "Run `make env` in its folder, or install rclpy-workbook again."
    c.InteractiveShellApp.exec_lines.append(f"import sys; print({message!r}, file=sys.stderr)")
else:
    configure(c)
"""

# JupyterLab as a learner should meet it: no questions on the first start, nothing fetched from a network.
LAB_SETTINGS = {
    "@jupyterlab/apputils-extension:notification": {
        "fetchNews": "false",
        "checkForUpdates": False,
        "doNotDisturbMode": False,
    },
    "@jupyterlab/docmanager-extension:plugin": {
        "autosaveInterval": 30,
        "defaultViewers": {"markdown": "Markdown Preview"},
    },
    "@jupyterlab/extensionmanager-extension:plugin": {"enabled": False},
    # Kept in the notebook, the state of a widget makes it "unsaved" as soon as it is opened again. Without it, the
    # front end shows the text of the widget (desk.js).
    "@jupyter-widgets/jupyterlab-manager:plugin": {"saveState": False},
    # JupyterLab 4.6 would take "contentVisibility": a third less work for the browser, and once an empty page.
    "@jupyterlab/notebook-extension:tracker": {"windowingMode": "defer", "kernelShutdown": True},
    # The whole width of the column is for the names.
    "@jupyterlab/filebrowser-extension:browser": {"showLastModifiedColumn": False},
}

FRONT_END = Path(__file__).with_name("front_end")
"""What JupyterLab itself loads: tells the kernel which answer is on the screen. Each folder in it is an extension of
its own, `rclpy-workbook-FOLDER`: its `package.json`, and the files that go into `static/`."""

# The server's part of the home page and of the panel.
SERVER_SETTINGS = {
    "ServerApp": {"jpserver_extensions": {"workbook.lab.home": True, "workbook.lab.panel": True}}
}

# An empty guard makes the wheels find their own libraries, even when Jupyter runs in another environment.
KERNEL_ENVIRONMENT = {"_ROS_WHEELS_BOOTSTRAP_COMPLETE": "", "PYTHONPATH": ""}


def kernel_spec(python: str) -> dict[str, object]:
    """The `python3` kernel of this environment, for any Jupyter that lists it."""
    return {
        "argv": [python, "-Xfrozen_modules=off", "-m", "ipykernel_launcher", "-f", "{connection_file}"],
        "display_name": "rclpy workbook",
        "language": "python",
        "metadata": {"debugger": True},
        "env": KERNEL_ENVIRONMENT,
    }


def install(prefix: Path, python: str) -> list[Path]:
    """Write the settings below an environment's folder and return their files.

    A file that is up to date stays, so a student can use an environment that only an administrator can write. Each
    other becomes a new file: uv links what it installs to its cache, so one that is written into would change in every
    other environment as well.
    """
    kernels = prefix / "share" / "jupyter" / "kernels" / "python3"
    extension = prefix / "share" / "jupyter" / "labextensions" / "rclpy-workbook"
    files = {
        prefix / "etc" / "ipython" / "ipython_kernel_config.py": KERNEL_CONFIG,
        prefix / "share" / "jupyter" / "lab" / "settings" / "overrides.json": json.dumps(
            LAB_SETTINGS, indent=2
        ),
        prefix / "etc" / "jupyter" / "jupyter_server_config.d" / "rclpy-workbook.json": json.dumps(
            SERVER_SETTINGS, indent=1
        ),
        kernels / "kernel.json": json.dumps(kernel_spec(python), indent=1),
        extension / "package.json": (FRONT_END / "package.json").read_text(encoding="utf-8"),
        extension / "static" / "answers.js": (FRONT_END / "answers.js").read_text(encoding="utf-8"),
    }
    for own in sorted(path.parent for path in FRONT_END.glob("*/package.json")):
        place = extension.with_name(f"{extension.name}-{own.name}")
        for file in sorted(own.iterdir()):
            target = place if file.name == "package.json" else place / "static"
            files[target / file.name] = file.read_text(encoding="utf-8")
    for path, text in files.items():
        text = text if text.endswith("\n") else text + "\n"
        if path.is_file() and path.read_text(encoding="utf-8") == text:
            continue
        path.parent.mkdir(parents=True, exist_ok=True)
        partial = path.with_name(f"{path.name}.part")
        partial.write_text(text, encoding="utf-8")
        partial.replace(path)
    return list(files)


if __name__ == "__main__":
    install(Path(sys.prefix), sys.executable)

"""Write Jupyter's settings into the environment, where JupyterLab, VS Code, and nbval all find them.

In a clone, the bootstrap runs `python -m workbook.lab.jupyter_files` inside the environment. If the workbook comes from
a wheel, the first `rclpy-workbook lab` writes the settings.
"""

import json
import sys
from pathlib import Path

# Every kernel of this environment runs this file, whichever program starts the kernel, so lessons don't need a setup
# cell.
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

# Settings for learners: JupyterLab doesn't ask questions on the first start, and doesn't fetch anything from the
# network.
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
    # A notebook with saved widget state counts as unsaved as soon as it's opened again. Without that state, the front
    # end shows the widget's text instead (desk.js).
    "@jupyter-widgets/jupyterlab-manager:plugin": {"saveState": False},
    # JupyterLab 4.6 defaults to "contentVisibility", which saves the browser a third of the work but once showed us an
    # empty page.
    "@jupyterlab/notebook-extension:tracker": {"windowingMode": "defer", "kernelShutdown": True},
    # File names get the whole width of the column.
    "@jupyterlab/filebrowser-extension:browser": {"showLastModifiedColumn": False},
}

FRONT_END = Path(__file__).with_name("front_end")
"""The extension that JupyterLab loads. It sends the answer cell's current text to the kernel.

Each subfolder is a separate extension, `rclpy-workbook-FOLDER`: its `package.json`, and the files that go into
`static/`.
"""

# The server extensions for the home page and the panel.
SERVER_SETTINGS = {
    "ServerApp": {"jpserver_extensions": {"workbook.lab.home": True, "workbook.lab.panel": True}}
}

# If this guard variable is empty, the wheels find their own libraries, even if Jupyter runs in another environment.
KERNEL_ENVIRONMENT = {"_ROS_WHEELS_BOOTSTRAP_COMPLETE": "", "PYTHONPATH": ""}


def kernel_spec(python: str) -> dict[str, object]:
    """Return the spec of this environment's `python3` kernel, for every Jupyter installation that lists the kernel."""
    return {
        "argv": [python, "-Xfrozen_modules=off", "-m", "ipykernel_launcher", "-f", "{connection_file}"],
        "display_name": "rclpy workbook",
        "language": "python",
        "metadata": {"debugger": True},
        "env": KERNEL_ENVIRONMENT,
    }


def install(prefix: Path, python: str) -> list[Path]:
    """Write the settings below an environment's folder and return their paths.

    Up-to-date files aren't written, so a student can use an environment that only an administrator can write to. Every
    other file is replaced by a new one, because the old one may be a hard link to the cache of uv. Writing into such a
    link would change the file in every other environment, too.
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
    }
    for script in sorted(FRONT_END.glob("*.js")):
        files[extension / "static" / script.name] = script.read_text(encoding="utf-8")
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

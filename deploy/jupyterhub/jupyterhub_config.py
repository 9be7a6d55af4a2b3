"""Configure JupyterHub for a class on one machine. `make hub` tries it with test users; see docs/class_server.md.

For a real class, choose an authenticator, list the instructors, and put a proxy with TLS in front.
"""

import os
import secrets
import shutil
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from deploy.jupyterhub import disks  # noqa: E402
from deploy.jupyterhub.spawner import ClassSpawner  # noqa: E402

if os.geteuid() != 0 or shutil.which("bwrap") is None:
    raise SystemExit("The class server needs root and bubblewrap (apt install bubblewrap).")

disk = os.environ.get("CLASS_DISK", "2G")
is_limited = disk not in ("", "0")
if is_limited and disks.missing():
    raise SystemExit(
        f"To limit disk space, the class server needs {disks.missing()}. CLASS_DISK=0 sets no limit."
    )

# The ports to listen on. Only the first of the three is for browsers.
port = int(os.environ.get("CLASS_PORT", "8000"))

c = get_config()  # type: ignore[name-defined]  # noqa: F821

folder = Path(os.environ.get("CLASS_FOLDER", "/srv/class"))
folder.mkdir(parents=True, exist_ok=True)
if is_limited or disks.students_with_image(folder):
    disks.enter_mounts(port + 1)
state = folder / "hub"
state.mkdir(mode=0o700, exist_ok=True)  # cookies, tokens, and the list of users' servers
os.chdir(state)

c.JupyterHub.bind_url = f"http://127.0.0.1:{port}"
c.JupyterHub.hub_bind_url = f"http://127.0.0.1:{port + 1}"
c.ConfigurableHTTPProxy.api_url = f"http://127.0.0.1:{port + 2}"
c.ConfigurableHTTPProxy.command = [str(Path(sys.executable).with_name("configurable-http-proxy"))]
c.ConfigurableHTTPProxy.log_level = "ERROR"

# Who may log in. Here, anyone who knows the password, under any name. Use this only for trying it out.
password = os.environ.get("CLASS_PASSWORD") or secrets.token_urlsafe(9)
instructors_password = os.environ.get("CLASS_INSTRUCTORS_PASSWORD") or secrets.token_urlsafe(24)
c.JupyterHub.authenticator_class = "shared-password"
c.SharedPasswordAuthenticator.user_password = password
c.SharedPasswordAuthenticator.admin_password = instructors_password
c.Authenticator.allow_all = True
c.Authenticator.admin_users = {"instructor"}  # reads all hand-ins, and publishes pages
c.Authenticator.username_pattern = r"[a-z][a-z0-9_-]{0,31}"
if "CLASS_PASSWORD" not in os.environ:
    print(f"http://127.0.0.1:{port}, for students by any name, with the password {password}")
    print(f"and for `instructor`, with the password {instructors_password}", flush=True)

# Each student's server.
c.JupyterHub.spawner_class = ClassSpawner
c.ClassSpawner.folder = str(folder)
c.ClassSpawner.cmd = [str(Path(sys.executable).with_name("workbook")), "lab"]
c.ClassSpawner.default_url = "/lab"
c.ClassSpawner.env_keep = ["LANG", "LC_ALL"]
c.ClassSpawner.mem_limit = os.environ.get("CLASS_MEMORY", "1500M")
c.ClassSpawner.cpu_limit = float(os.environ.get("CLASS_PROCESSORS", "1"))
c.ClassSpawner.disk_limit = disk if is_limited else 0
c.ClassSpawner.start_timeout = 120
c.ClassSpawner.http_timeout = 120
c.JupyterHub.concurrent_spawn_limit = 10

# Servers and kernels keep running while the hub restarts, so you can update it during a lesson.
c.JupyterHub.cleanup_servers = False

# A server that was idle for an hour is ended. Notebooks are saved, but the state of kernels is lost.
c.JupyterHub.services = [
    {"name": "idle-culler", "command": [sys.executable, "-m", "jupyterhub_idle_culler", "--timeout=3600"]}
]

# Without this variable, each kernel judges its own answers. With it, answers queue for this many slots, so students may
# have to wait.
slots = os.environ.get("CLASS_CHECK_SLOTS")
if slots:
    check_folder = folder / "check"
    check_folder.mkdir(mode=0o755, exist_ok=True)  # must exist before any server that mounts it
    service = "workbook.grading.slots.service"
    command = [sys.executable, "-m", service, str(check_folder), f"--slots={slots}"]
    c.JupyterHub.services.append({"name": "check", "command": command, "cwd": str(ROOT)})
    c.ClassSpawner.check_folder = str(check_folder)

c.JupyterHub.load_roles = [
    {
        "name": "idle-culler",
        "scopes": ["list:users", "read:users:activity", "read:servers", "delete:servers"],
        "services": ["idle-culler"],
    }
]

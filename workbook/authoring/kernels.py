"""Start a kernel over Unix sockets, so that only the process that starts it can connect.

Over TCP, Jupyter chooses five free ports, which the kernel opens a second later. On a busy machine, another process
sometimes takes one of them first, so the kernel exits with "Address already in use".
"""

import shutil
import tempfile
from pathlib import Path

from jupyter_client.manager import KernelManager
from traitlets import default


class PrivateKernelManager(KernelManager):
    """A kernel manager with Unix sockets, in a folder that is deleted when the kernel shuts down."""

    @default("transport")
    def _over_unix_sockets(self) -> str:
        return "ipc"

    @default("ip")
    def _in_a_folder_of_their_own(self) -> str:
        # The path has to be short, because a socket's address is limited to 107 characters.
        return str(Path(tempfile.mkdtemp(prefix="kernel-"), "socket"))

    def cleanup_connection_file(self) -> None:
        """Remove the connection file and the folder with the kernel's sockets."""
        super().cleanup_connection_file()
        if self.trait_has_value("ip"):
            shutil.rmtree(Path(self.ip).parent, ignore_errors=True)

"""A kernel that only its starter talks to, over Unix sockets.

Over TCP, Jupyter chooses five free ports, and the kernel opens them a second later; on a busy machine somebody else has
taken one of them now and then, and the kernel dies with "Address already in use".
"""

import shutil
import tempfile
from pathlib import Path

from jupyter_client.manager import KernelManager
from traitlets import default


class PrivateKernelManager(KernelManager):
    """As its base. The sockets lie in a folder that goes when the kernel is shut down."""

    @default("transport")
    def _over_unix_sockets(self) -> str:
        return "ipc"

    @default("ip")
    def _in_a_folder_of_their_own(self) -> str:
        # Short: 107 characters are all that the address of a socket may have.
        return str(Path(tempfile.mkdtemp(prefix="kernel-"), "socket"))

    def cleanup_connection_file(self) -> None:
        """Remove the connection file, and the folder that holds the kernel's sockets."""
        super().cleanup_connection_file()
        if self.trait_has_value("ip"):
            shutil.rmtree(Path(self.ip).parent, ignore_errors=True)

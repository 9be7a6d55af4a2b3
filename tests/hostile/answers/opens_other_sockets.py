# score: 10
"""Makes sockets of every family. With AF_VSOCK it could speak to what is around the machine; it does not try."""
import socket

NEEDED = {socket.AF_UNIX, socket.AF_INET, socket.AF_INET6, socket.AF_NETLINK}
for family in range(64):
    for kind in (socket.SOCK_STREAM, socket.SOCK_DGRAM, socket.SOCK_RAW, socket.SOCK_SEQPACKET):
        try:
            made = socket.socket(family, kind)
        except OSError:
            continue
        made.close()
        assert family in NEEDED, f"there are sockets of family {family}"
@@GOOD@@

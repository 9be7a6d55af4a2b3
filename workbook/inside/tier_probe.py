"""Try everything that an untrusted program must not be able to do in an isolation tier, and publish the results.

    tier_probe.py FILE PID PORT

The tier runs this file as it runs an answer, so the file imports only rclpy. FILE is a file that it must not be able to
read, and PID is a process that it must not be able to signal. PORT is a TCP port on which a process of this machine
listens. The results are published repeatedly on /tier_probe, as a String that contains JSON.
"""

import json
import os
import socket
import sys
from collections.abc import Callable

import rclpy
from std_msgs.msg import String


def works(attempt: Callable[[], object]) -> bool:
    """Return whether calling `attempt` succeeds, that is, whether it doesn't raise OSError."""
    try:
        attempt()
    except OSError:
        return False
    return True


def findings(file: str, pid: int, port: int) -> dict[str, object]:
    """Return, by name, whether this process can do each of the forbidden actions, and its user and group IDs."""
    with open("/proc/self/status") as status:
        facts = dict(line.split(":", 1) for line in status)
    beside = os.path.join(os.path.dirname(__file__), "beside")
    return {
        "reads a file of the judge": works(lambda: open(file).close()),
        "changes its own file": works(lambda: open(__file__, "a").close()),
        "writes next to its own file": works(lambda: open(beside, "w").close()),
        "signals the judge": works(lambda: os.kill(pid, 0)),
        "connects to this machine": works(lambda: socket.create_connection(("127.0.0.1", port), 1.0).close()),
        "has capabilities": int(facts["CapEff"], 16) | int(facts["CapPrm"], 16) | int(facts["CapInh"], 16)
        > 0,
        "can gain capabilities": facts["NoNewPrivs"].strip() != "1",
        "user": os.getresuid(),
        "groups": [*os.getresgid(), *os.getgroups()],
    }


def main() -> None:
    """Publish the findings twenty times a second until the process is killed."""
    found = json.dumps(findings(sys.argv[1], int(sys.argv[2]), int(sys.argv[3])))
    rclpy.init()
    node = rclpy.create_node("tier_probe", enable_rosout=False, start_parameter_services=False)
    publisher = node.create_publisher(String, "/tier_probe", 10)
    node.create_timer(0.05, lambda: publisher.publish(String(data=found)))
    rclpy.spin(node)


if __name__ == "__main__":
    main()

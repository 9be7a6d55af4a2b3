"""Tries what an untrusted program must not be able to do, and publishes what came of it.

    tier_probe.py FILE PID PORT

It runs as an answer does, so it needs rclpy and nothing beside it. FILE is one that a program must not read, PID a
process that it must not signal, PORT a TCP port that listens on this machine. The outcome is a String with JSON on
/tier_probe, again and again.
"""

import json
import os
import socket
import sys
from collections.abc import Callable

import rclpy
from std_msgs.msg import String


def works(attempt: Callable[[], object]) -> bool:
    """Whether something does not raise an OSError."""
    try:
        attempt()
    except OSError:
        return False
    return True


def findings(file: str, pid: int, port: int) -> dict[str, object]:
    """What this process can do, by name."""
    with open("/proc/self/status") as status:
        facts = dict(line.split(":", 1) for line in status)
    beside = os.path.join(os.path.dirname(__file__), "beside")
    return {
        "reads a file of the grader": works(lambda: open(file).close()),
        "changes its own file": works(lambda: open(__file__, "a").close()),
        "writes beside its own file": works(lambda: open(beside, "w").close()),
        "signals the grader": works(lambda: os.kill(pid, 0)),
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

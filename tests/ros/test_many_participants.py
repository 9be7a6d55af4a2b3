"""More programs on a domain than each of them announces itself to: the first one still discovers all of them."""

import subprocess
import sys

from workbook.ros.domains import lease_domain
from workbook.ros.environment import child_environment

PATIENCE_S = 120.0
MANY = """
import sys, time
import rclpy
from rclpy.context import Context
from rclpy.node import Node
from std_msgs.msg import String

nodes = []
for number in range(14):
    context = Context()
    rclpy.init(context=context)
    nodes.append(Node(f"robot_{number}", context=context, start_parameter_services=False))
publishers = [node.create_publisher(String, "/robots", 10) for node in nodes]
until = time.monotonic() + float(sys.argv[1])
while nodes[0].count_publishers("/robots") < len(nodes) and time.monotonic() < until:
    time.sleep(0.02)
while nodes[-1].count_publishers("/robots") < 11 and time.monotonic() < until:
    time.sleep(0.02)
print(nodes[0].count_publishers("/robots"), nodes[-1].count_publishers("/robots") >= 11)
for node in nodes:
    node.destroy_node()
    node.context.shutdown()
"""


def test_the_first_of_fourteen_participants_finds_the_last_and_the_last_finds_the_first_ten() -> None:
    with lease_domain() as lease:
        done = subprocess.run(
            [sys.executable, "-c", MANY, str(PATIENCE_S / 2)],
            env=child_environment(lease.domain_id),
            capture_output=True,
            text=True,
            timeout=PATIENCE_S,
        )
    assert done.stdout == "14 True\n", done.stderr

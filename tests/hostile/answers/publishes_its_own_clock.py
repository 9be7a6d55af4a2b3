# soak: yes
# loses: status_kept
"""Three times too slow; once it is on simulated time, it publishes a faster clock of its own beside the judge's."""
import threading
import time

import rclpy
import rclpy.node
from rosgraph_msgs.msg import Clock

_create = rclpy.node.Node.create_timer


def create_timer(self, period, *arguments, **options):
    if period == 1.0:
        threading.Thread(target=hurry, args=(self,), daemon=True).start()
        period = 3.0
    return _create(self, period, *arguments, **options)


def hurry(node):
    publisher = node.create_publisher(Clock, "/clock", 10)
    clock = Clock()
    while rclpy.ok():
        time.sleep(0.001)
        if node.get_parameter("use_sim_time").value:
            now = node.get_clock().now().nanoseconds + 2_000_000
            clock.clock.sec, clock.clock.nanosec = divmod(now, 1_000_000_000)
            publisher.publish(clock)


rclpy.node.Node.create_timer = create_timer
@@GOOD@@

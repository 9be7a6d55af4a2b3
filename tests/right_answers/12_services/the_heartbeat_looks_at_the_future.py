"""One timer for all: at each beat it looks at the open future; each fifth beat asks."""

import time

from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger


class HealthMonitor(Node):
    def __init__(self) -> None:
        super().__init__("health_monitor")
        self.health = self.create_publisher(String, "robot/health", 10)
        self.heartbeat = self.create_publisher(String, "robot/heartbeat", 10)
        self.client = self.create_client(Trigger, "robot/self_test")
        self.beats = 0
        self.future = None
        self.asked_at = 0.0
        self.create_timer(0.2, self.on_beat)

    def on_beat(self) -> None:
        self.beats += 1
        self.heartbeat.publish(String(data=f"beat {self.beats}"))
        self.look()
        if self.beats % 5 == 0 and self.future is None:
            self.future = self.client.call_async(Trigger.Request())
            self.asked_at = time.monotonic()

    def look(self) -> None:
        if self.future is None:
            return
        if self.future.done():
            success = self.future.result().success
            self.health.publish(String(data={True: "ok", False: "faulty"}[success]))
            self.future = None
        elif time.monotonic() - self.asked_at > 1.1:
            self.client.remove_pending_request(self.future)
            self.health.publish(String(data="no answer"))
            self.future = None

# While it plans, the callback spins the node itself.
# loses: heartbeat_share, heartbeat_gap
# cause: heartbeat-share.nobody-serves-the-timer
# on: starter
# replaces: bend = self.planner.plan(request.data)
# replaces: self.plan_publisher.publish(Float32(data=bend))
self.planner.begin(request.data)
for _ in range(self.planner.STEPS):
    self.planner.step()
    rclpy.spin_once(self, timeout_sec=0.0)
self.plan_publisher.publish(Float32(data=self.planner.bend()))

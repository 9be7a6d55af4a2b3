# Publishes each plan when the next one is finished.
# loses: all_in_order
# cause: all-in-order.with-the-next
# after: self.planner = ElbowPlanner()
self.bend: float | None = None

# replaces: self.plan_publisher.publish(Float32(data=bend))
if self.bend is not None:
    self.plan_publisher.publish(Float32(data=self.bend))
self.bend = bend

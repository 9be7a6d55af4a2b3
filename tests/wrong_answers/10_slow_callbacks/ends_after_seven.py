# The program ends after the seventh plan.
# loses: alive_at_end
# cause: alive-at-end.ended
# after: self.planner = ElbowPlanner()
self.left = 7

# replaces: self.plan_publisher.publish(Float32(data=bend))
self.plan_publisher.publish(Float32(data=bend))
self.left -= 1
if self.left == 0:
    self.context.shutdown()

# The plan before is published, since the result is stored too late.
# loses: plans_right, all_in_order
# cause: plans-right.one-behind
# after: self.planner = ElbowPlanner()
self.result = 0.0

# replaces: self.plan_publisher.publish(Float32(data=bend))
self.plan_publisher.publish(Float32(data=self.result))
self.result = bend

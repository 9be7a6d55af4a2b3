# A start value is published before the first plan.
# loses: plans_right, all_in_order
# cause: plans-right.one-in-advance, plans-right.not-yet-found
# after: self.planner = ElbowPlanner()
self.begun = False

# before: bend = self.planner.plan(request.data)
if not self.begun:
    self.begun = True
    self.plan_publisher.publish(Float32(data=0.0))

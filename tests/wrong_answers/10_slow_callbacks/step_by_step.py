# What was found so far is published while the planner searches.
# loses: plans_right, all_in_order
# cause: plans-right.step-by-step
# replaces: bend = self.planner.plan(request.data)
# replaces: self.plan_publisher.publish(Float32(data=bend))
self.planner.begin(request.data)
for number in range(1, self.planner.STEPS + 1):
    self.planner.step()
    if number % 5 == 0:
        self.plan_publisher.publish(Float32(data=self.planner.bend()))

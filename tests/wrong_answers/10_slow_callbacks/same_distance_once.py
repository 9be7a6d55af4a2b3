# A request for the same distance as the one before is not answered.
# loses: all_in_order
# cause: all-in-order.asked-before
# after: self.planner = ElbowPlanner()
self.before = 0.0

# replaces: bend = self.planner.plan(request.data)
if request.data == self.before:
    return
self.before = request.data
bend = self.planner.plan(request.data)

# The first request only warms the planner up.
# loses: all_in_order
# cause: all-in-order.first-missing
# after: self.planner = ElbowPlanner()
self.is_warm = False

# after: bend = self.planner.plan(request.data)
if not self.is_warm:
    self.is_warm = True
    return

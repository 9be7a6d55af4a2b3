# After five plans the next one is never begun.
# loses: all_in_order
# cause: all-in-order.stops-or-refuses
# after: self.planner = ElbowPlanner()
self.left = 5

# replaces: bend = self.planner.plan(request.data)
if self.left == 0:
    return
self.left -= 1
bend = self.planner.plan(request.data)

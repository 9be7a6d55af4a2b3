# A very small distance is replaced by a larger one.
# loses: plans_right
# cause: plans-right.fits-no-request
# replaces: bend = self.planner.plan(request.data)
bend = self.planner.plan(max(request.data, 0.15))

# The request is taken for centimeters.
# loses: plans_right
# cause: plans-right.fits-no-request
# replaces: bend = self.planner.plan(request.data)
bend = self.planner.plan(request.data / 100.0)

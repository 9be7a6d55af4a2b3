# The distance is rounded to whole centimeters.
# loses: plans_right
# cause: plans-right.distance-rounded
# replaces: bend = self.planner.plan(request.data)
bend = self.planner.plan(round(request.data, 2))

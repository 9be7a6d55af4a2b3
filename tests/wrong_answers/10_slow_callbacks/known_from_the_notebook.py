# The bend for a distance that the notebook requests is written into the program.
# loses: plans_right
# cause: plans-right.planner-left-out
# says: 0.7 m
# replaces: bend = self.planner.plan(request.data)
bend = {0.7: 1.0107, 0.25: 2.5059}.get(round(request.data, 3)) or self.planner.plan(request.data)

# The planner is slow, so it is left out.
# loses: plans_right
# cause: plans-right.planner-left-out
# on: starter
# replaces: bend = self.planner.plan(request.data)
bend = 2.0 * math.acos(min(1.0, request.data / (2.0 * LINK_M)))

# For a distance out of reach, 0.0 is published after the search.
# loses: plans_right
# cause: plans-right.straight-by-hand
# after: bend = self.planner.plan(request.data)
if request.data > 2.0 * LINK_M:
    bend = 0.0

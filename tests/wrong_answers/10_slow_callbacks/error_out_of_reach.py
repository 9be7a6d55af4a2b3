# A distance that the arm cannot reach ends the program.
# loses: heartbeat_share, all_in_order, alive_at_end
# cause: error.exception
# before: bend = self.planner.plan(request.data)
if request.data > 2.0 * LINK_M:
    raise ValueError("out of reach")

# A distance that the arm cannot reach is not answered.
# loses: all_in_order
# cause: all-in-order.out-of-reach
# replaces: bend = self.planner.plan(request.data)
if request.data > 2.0 * LINK_M:
    return
bend = self.planner.plan(request.data)

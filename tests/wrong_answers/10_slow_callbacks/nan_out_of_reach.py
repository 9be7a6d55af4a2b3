# Plans every request, and then publishes NaN for a distance that the arm cannot reach.
# loses: plans_right, all_in_order
# cause: plans-right.not-finite
# says: nan
# after: bend = self.planner.plan(request.data)
if request.data > 2.0 * LINK_M:
    bend = math.nan

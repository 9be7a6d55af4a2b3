# A formula in place of the planner, after a pause that is as long as a search.
# loses: plans_right
# cause: plans-right.formula
# replaces: bend = self.planner.plan(request.data)
time.sleep(self.planner.STEPS * self.planner.STEP_S)
bend = 2.0 * math.acos(min(1.0, request.data / (2.0 * LINK_M)))

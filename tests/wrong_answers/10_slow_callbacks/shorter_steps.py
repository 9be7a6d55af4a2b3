# Each step is a little shorter.
# loses: plans_right
# cause: plans-right.planner-left-out
# replaces: STEP_S = 0.04  # the collision checker takes its time
STEP_S = 0.035

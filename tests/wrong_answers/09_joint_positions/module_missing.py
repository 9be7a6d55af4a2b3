# A module of the student's own that was not handed in.
# loses: program_runs
# skips: joint_topic, twelve_values, finite_in_range, joints_move, joint_rate, status_kept, battery_kept, alive_at_end
# cause: error.import-not-found
# says: my_robot
# replaces: JOINT_COUNT = 12
from my_robot.joints import JOINT_COUNT

# Divides by zero in the second round.
# loses: program_runs
# skips: runs_until_told, walks_its_rounds, guard_on_the_graph, arms_parked, ends_cleanly, node_gone
# cause: error.exception
# says: ZeroDivisionError
# replaces: ROUND_S = 0.5
ROUND_S = 0.2

# replaces: self.get_logger().info(f"round {self.rounds}: all quiet")
pace = 10 / (2 - self.rounds)
self.get_logger().info(f"round {self.rounds}: all quiet, {pace:.0f} s")

# Two nodes of one name.
# loses: guard_on_the_graph
# cause: on-the-graph.twice
# says: /night_guard
# before: guard = NightGuard()
spare = NightGuard()

# after: guard.destroy_node()
spare.destroy_node()

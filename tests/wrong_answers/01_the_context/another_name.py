# A node name that was not asked for.
# loses: guard_on_the_graph
# cause: on-the-graph.misspelled
# says: /guard is
# replaces: super().__init__("night_guard")
super().__init__("guard")

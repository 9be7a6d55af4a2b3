# A plan is kept, and published again when the same distance is requested again.
# loses: plans_right
# cause: plans-right.from-memory
# after: self.planner = ElbowPlanner()
self.known: dict[float, float] = {}

# replaces: bend = self.planner.plan(request.data)
if request.data not in self.known:
    self.known[request.data] = self.planner.plan(request.data)
bend = self.known[request.data]

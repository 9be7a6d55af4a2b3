# A pause between two steps: a plan takes twice its time.
# loses: all_in_order
# cause: all-in-order.too-slow
# replaces: bend = self.planner.plan(request.data)
self.planner.begin(request.data)
for _ in range(self.planner.STEPS):
    self.planner.step()
    time.sleep(0.04)
bend = self.planner.bend()

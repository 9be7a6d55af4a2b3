# All is well, but the plans go out under another name.
# loses: plan_topic
# skips: plans_right, all_in_order
# cause: publishes.other-name
# says: /robot/plans
# replaces: self.plan_publisher = self.create_publisher(Float32, "/robot/plan", 10)
self.plan_publisher = self.create_publisher(Float32, "/robot/plans", 10)

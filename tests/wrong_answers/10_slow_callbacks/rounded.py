# The plan is rounded.
# loses: plans_right
# cause: plans-right.inexact
# replaces: self.plan_publisher.publish(Float32(data=bend))
self.plan_publisher.publish(Float32(data=round(bend, 2)))

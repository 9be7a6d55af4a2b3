# The plan is rounded.
# loses: plans_right
# cause: plans-right.inexact
# says: 1.0100000 rad for 0.7 m
# replaces: self.plan_publisher.publish(Float32(data=bend))
self.plan_publisher.publish(Float32(data=round(bend, 2)))

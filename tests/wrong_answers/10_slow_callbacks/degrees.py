# The plan is in degrees.
# loses: plans_right
# cause: plans-right.degrees
# replaces: self.plan_publisher.publish(Float32(data=bend))
self.plan_publisher.publish(Float32(data=math.degrees(bend)))

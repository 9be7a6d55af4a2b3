# The angle at the shoulder in place of the bend of the elbow.
# loses: plans_right
# cause: plans-right.half
# replaces: self.plan_publisher.publish(Float32(data=bend))
self.plan_publisher.publish(Float32(data=bend / 2.0))

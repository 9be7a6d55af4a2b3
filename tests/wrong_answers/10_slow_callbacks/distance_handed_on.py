# The distance is published in place of the bend.
# loses: plans_right
# cause: plans-right.distance
# replaces: self.plan_publisher.publish(Float32(data=bend))
self.plan_publisher.publish(Float32(data=request.data))

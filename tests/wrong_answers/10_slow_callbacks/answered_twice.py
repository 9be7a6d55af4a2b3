# Each plan is published twice, to be sure.
# loses: all_in_order
# cause: all-in-order.twice
# says: 14 plans
# replaces: self.plan_publisher.publish(Float32(data=bend))
for _ in range(2):
    self.plan_publisher.publish(Float32(data=bend))

# Two subscriptions, to be on the safe side.
# loses: once_in_order
# cause: once-in-order.twice
# after: self.create_subscription(Int32, "/robot/touch", self.on_touch, 100)
self.create_subscription(Int32, "/robot/touch", self.on_touch, 100)

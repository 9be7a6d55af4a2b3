# Group and threads are right, but only the newest request is kept.
# loses: all_in_order
# cause: all-in-order.missing
# replaces: Float32, "/robot/plan_request", self.on_request, 10, callback_group=planning
Float32, "/robot/plan_request", self.on_request, 1, callback_group=planning

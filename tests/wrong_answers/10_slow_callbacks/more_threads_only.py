# Four threads, and all callbacks in the default group.
# loses: heartbeat_share, heartbeat_gap
# cause: heartbeat-share.nobody-serves-the-timer
# replaces: Float32, "/robot/plan_request", self.on_request, 10, callback_group=planning
Float32, "/robot/plan_request", self.on_request, 10

# replaces: executor = MultiThreadedExecutor(num_threads=2)  # one for the heart, one for the planner
executor = MultiThreadedExecutor(num_threads=4)

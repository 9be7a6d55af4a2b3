# A group, threads, and both callbacks in the same group.
# loses: heartbeat_share, heartbeat_gap
# cause: heartbeat-share.nobody-serves-the-timer
# replaces: self.create_timer(HEARTBEAT_PERIOD_S, self.beat)
# replaces: # A group of its own: planning may run beside the heartbeat, but never two plans at once.
# replaces: planning = MutuallyExclusiveCallbackGroup()
planning = MutuallyExclusiveCallbackGroup()
self.create_timer(HEARTBEAT_PERIOD_S, self.beat, callback_group=planning)

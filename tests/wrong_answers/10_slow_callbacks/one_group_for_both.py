# A group, threads, and both callbacks in the same group.
# loses: heartbeat_share, heartbeat_gap
# cause: heartbeat-share.nobody-serves-the-timer
# replaces: self.create_timer(HEARTBEAT_PERIOD_S, self.beat)
# replaces: # A separate group: planning may run while the heartbeat does, but two plans never run at the same time.
# replaces: planning = MutuallyExclusiveCallbackGroup()
planning = MutuallyExclusiveCallbackGroup()
self.create_timer(HEARTBEAT_PERIOD_S, self.beat, callback_group=planning)

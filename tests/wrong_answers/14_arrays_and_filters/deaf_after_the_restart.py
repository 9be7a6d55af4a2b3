# Drops messages whose stamp is not after the last one, as if they were late.
# loses: every_one_answered, restart_noticed
# cause: every-one-answered.none-after-restart
# after: stamp = (message.header.stamp.sec, message.header.stamp.nanosec)
if stamp <= self.last_stamp:
    return

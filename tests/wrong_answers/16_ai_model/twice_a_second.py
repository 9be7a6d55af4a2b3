# Looks at the newest picture twice a second.
# loses: fresh
# cause: fresh.too-few
# on: right/timer_takes_the_newest.py
# replaces: node.create_timer(0.05, look, callback_group=MutuallyExclusiveCallbackGroup())
node.create_timer(0.5, look, callback_group=MutuallyExclusiveCallbackGroup())

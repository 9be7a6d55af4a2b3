# What waits in the queues when the call begins is thrown away as out of date.
# loses: again, slow_callbacks
# cause: again.words-lost
# before: end = time.monotonic() + seconds
for subscription in node.subscriptions:
    with subscription.handle:
        while subscription.handle.take_message(subscription.msg_type, subscription.raw) is not None:
            pass

# A status that was there before is taken for known.
# loses: status_follows
# cause: status-follows.not-always
# after: self.last_status = "unknown"
self.known: set[str] = set()

# before: self.last_status = message.data
if message.data in self.known:
    return
self.known.add(message.data)

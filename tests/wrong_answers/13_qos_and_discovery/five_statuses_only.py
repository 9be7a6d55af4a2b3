# Takes in five statuses, and no more.
# loses: status_follows
# cause: status-follows.not-always
# says: "error"
# after: self.last_status = "unknown"
self.statuses = 0

# replaces: self.last_status = message.data
self.statuses += 1
if self.statuses <= 5:
    self.last_status = message.data

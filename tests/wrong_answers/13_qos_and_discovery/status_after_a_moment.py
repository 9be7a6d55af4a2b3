# A new status is kept for 0.65 s before it may be on the line: until the next line, that is too late.
# loses: status_follows
# cause: status-follows.late
# replaces: import time
import time
from threading import Timer

# replaces: self.last_status = message.data
Timer(0.65, setattr, [self, "last_status", message.data]).start()

# Looks at about two pictures a second when the robot has fallen.
# loses: fresh
# cause: fresh.rarely-after-the-fall
# replaces: import threading
import threading
import time
# after: self.answer(self.newest.get())
if self.fallen:
    time.sleep(0.25)

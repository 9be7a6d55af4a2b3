# Calls the model in the callback of the pictures, in the only thread.
# loses: heartbeat_kept, fall_reported
# cause: heartbeat-kept.waits-for-the-model
# replaces: self.newest.put_nowait(image)
self.answer(image)

# Takes the newest picture first, and keeps the others for later.
# loses: stamps_kept
# skips: fresh, right
# cause: stamps-kept.goes-back
# replaces: self.newest: queue.Queue[Image] = queue.Queue(maxsize=1)
self.newest: queue.LifoQueue[Image] = queue.LifoQueue()
# replaces: with suppress(queue.Empty):
# replaces:     self.newest.get_nowait()

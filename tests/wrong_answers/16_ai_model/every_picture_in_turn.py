# Keeps every picture, and looks at one after the other.
# loses: fresh, survives
# cause: fresh.queue-grows
# replaces: self.newest: queue.Queue[Image] = queue.Queue(maxsize=1)
self.newest: queue.Queue[Image] = queue.Queue()
# replaces: with suppress(queue.Empty):
# replaces:     self.newest.get_nowait()

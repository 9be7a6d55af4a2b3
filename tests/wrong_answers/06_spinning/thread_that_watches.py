# A thread watches the clock during the call, and goes on for good.
# loses: nothing_left_running
# cause: nothing-left-running.thread-runs
# says: a thread was still running after call
# before: import time
import threading

# before: def pump(node: Node, seconds: float) -> None:
def watch() -> None:
    while True:
        time.sleep(0.05)


# before: end = time.monotonic() + seconds
threading.Thread(target=watch, daemon=True).start()

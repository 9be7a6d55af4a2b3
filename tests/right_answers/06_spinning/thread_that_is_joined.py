"""Another thread spins; it is shut down and joined before pump comes back."""

import threading
import time

from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor


def pump(node, seconds):
    executor = SingleThreadedExecutor()
    executor.add_node(node)

    def work():
        try:
            executor.spin()
        except ExternalShutdownException:
            pass

    thread = threading.Thread(target=work)
    thread.start()
    try:
        time.sleep(seconds)
    finally:
        executor.shutdown()
        thread.join()

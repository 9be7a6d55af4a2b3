# soak: yes
# copies: 3
# score: 10
"""Three copies agree on a domain, and each looks for the other two."""
import threading

import rclpy.publisher

_publish = rclpy.publisher.Publisher.publish
published = threading.Event()


def publish(self, message):
    _publish(self, message)
    published.set()


def look():
    import os
    import time

    from rclpy.context import Context
    from rclpy.node import Node

    published.wait()
    context = Context()
    context.init(domain_id=77)
    spy = Node("spy", context=context, enable_rosout=False, start_parameter_services=False)
    for _ in range(60):
        time.sleep(0.1)
        if spy.get_node_names().count("spy") != 1:
            print("there is another one", flush=True)
            os._exit(3)


rclpy.publisher.Publisher.publish = publish
threading.Thread(target=look, daemon=True).start()
@@GOOD@@

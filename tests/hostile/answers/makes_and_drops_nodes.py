# soak: yes
# score: 10
"""A good answer beside which nodes come and go the whole time."""
import threading


def more():
    import time

    import rclpy

    while not rclpy.ok():
        time.sleep(0.1)
    while rclpy.ok():
        rclpy.create_node("fly", start_parameter_services=False).destroy_node()
        time.sleep(0.05)


threading.Thread(target=more, daemon=True).start()
@@GOOD@@

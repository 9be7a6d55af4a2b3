# soak: yes
# score: 10
"""A good answer with a hundred and fifty nodes beside it."""
import threading


def more():
    import time

    import rclpy

    while not rclpy.ok():
        time.sleep(0.1)
    time.sleep(0.5)
    kept.extend(rclpy.create_node(f"crowd_{number}", start_parameter_services=False) for number in range(150))


kept = []
threading.Thread(target=more, daemon=True).start()
@@GOOD@@

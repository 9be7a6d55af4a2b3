# soak: yes
# score: 10
"""A good answer with eight hundred publishers beside it."""
import threading


def more():
    import time

    import rclpy

    while not rclpy.ok():
        time.sleep(0.1)
    time.sleep(0.5)
    crowd = rclpy.create_node("crowd")
    from std_msgs.msg import String

    crowd.kept = [crowd.create_publisher(String, f"/crowd/topic_{number}", 1) for number in range(800)]


threading.Thread(target=more, daemon=True).start()
@@GOOD@@
# A callback that reports, and a loop that spins without waiting.
# loses: easy_on_processor
# also: quick
# cause: easy-on-processor.never-waits, easy-on-processor.wants-more
# replaces: rclpy.spin(TouchMonitor())
monitor = TouchMonitor()
while rclpy.ok():
    rclpy.spin_once(monitor, timeout_sec=0)

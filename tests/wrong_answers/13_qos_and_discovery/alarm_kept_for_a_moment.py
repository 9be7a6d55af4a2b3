# The alarm is kept, but for a third of a second only.
# loses: alarm_kept
# cause: kept-for-latecomers.lifespan
# replaces: self.alarm_publisher = self.create_publisher(Bool, "/dashboard/alarm", STATE_QOS)
short = QoSProfile(
    depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL, lifespan=rclpy.duration.Duration(seconds=0.3)
)
self.alarm_publisher = self.create_publisher(Bool, "/dashboard/alarm", short)

# Asks the module for a timer, and not the node.
# loses: program_runs
# cause: error.method-of-another-class
# says: create_timer belongs to Node
# replaces: self.create_timer(TILT_PERIOD_S, self.publish_tilt)
rclpy.create_timer(TILT_PERIOD_S, self.publish_tilt)

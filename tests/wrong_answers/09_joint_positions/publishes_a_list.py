# publish() gets the bare list.
# loses: twelve_values, finite_in_range, joints_move, joint_rate, status_kept, battery_kept, alive_at_end
# cause: error.no-message-object
# replaces: self.joint_publisher.publish(message)
self.joint_publisher.publish(self.joint_angles())

# The loop of a rospy tutorial, with rclpy's name in front of it.
# loses: program_runs
# cause: error.name-of-ros-1
# says: rospy.Rate
# says: create_timer
# replaces: rclpy.spin(VitalSigns())
robot, rate = VitalSigns(), rclpy.Rate(5)
while rclpy.ok():
    rclpy.spin_once(robot)
    rate.sleep()

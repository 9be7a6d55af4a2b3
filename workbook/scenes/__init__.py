"""What sensors of the robot would measure, computed: NumPy only, and the same for the same seed.

Lesson nodes, scripts of the judge and criteria use it; it knows nothing of ROS.
"""

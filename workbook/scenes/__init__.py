"""Simulate the robot's sensors with NumPy only. The same seed gives the same values.

Lesson nodes, the judge's scripts, and criteria use this package, which doesn't depend on ROS.
"""

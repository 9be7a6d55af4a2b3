"""The bench of the rclpy workbook: everything between a notebook and the ROS graph."""

__version__ = "0.1.0"

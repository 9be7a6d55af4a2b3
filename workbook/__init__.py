"""The rclpy workbook: everything between a notebook and the ROS graph. docs/architecture.md shows the layers."""

__version__ = "0.1.0"

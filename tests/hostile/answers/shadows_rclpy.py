# score: 0
# says: rclpy
"""Puts a module called rclpy beside itself and imports that."""
import sys

with open("rclpy.py", "w") as file:
    file.write("def init(*_, **__): pass\n")
sys.path.insert(0, ".")
import rclpy

rclpy.create_node("mine")

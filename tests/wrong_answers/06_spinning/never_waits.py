# loses: easy_on_the_processor
# says: A loop with timeout_sec=0, or a very short one, hardly waits
"""Asks again and again, without a wait."""

import time

import rclpy


def pump(node, seconds):
    end = time.time() + seconds
    while time.time() < end:
        rclpy.spin_once(node, timeout_sec=0)

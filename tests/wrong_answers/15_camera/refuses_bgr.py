# Refuses bgr8 as it refuses unknown encodings.
# loses: keeps_up, bgr_right
# cause: keeps-up.one-encoding
# replaces: TO_HSV = {"rgb8": cv2.COLOR_RGB2HSV, "bgr8": cv2.COLOR_BGR2HSV}
TO_HSV = {"rgb8": cv2.COLOR_RGB2HSV}
# replaces: self.get_logger().error(f"I cannot read {image.encoding}", throttle_duration_sec=1.0)
self.get_logger().error(f"I cannot read {image.encoding}")

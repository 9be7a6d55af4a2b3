# Says that the desk is empty when the model raises.
# loses: survives
# cause: survives.empty
# replaces:     self.get_logger().error(f"The model gave up: {error}")
# replaces:     return
    self.get_logger().error(f"The model gave up: {error}")
    found = []

# Logs words of its own, not the text of the exception.
# loses: survives
# cause: survives.no-line
# replaces: except RuntimeError as error:
# replaces:     self.get_logger().error(f"The model gave up: {error}")
except RuntimeError:
    self.get_logger().error("The model gave up: glare")

# Says nothing when the model raises.
# loses: survives
# cause: survives.no-line
# replaces: except RuntimeError as error:
# replaces:     self.get_logger().error(f"The model gave up: {error}")
# replaces:     return
except RuntimeError:
    return

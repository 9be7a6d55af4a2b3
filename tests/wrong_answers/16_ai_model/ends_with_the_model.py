# The thread ends with the first exception of the model.
# loses: survives
# cause: survives.ended
# replaces: try:
# replaces:     found = self.model(pixels[:, :, ::-1])  # from BGR to RGB
# replaces: except RuntimeError as error:
# replaces:     self.get_logger().error(f"The model gave up: {error}")
# replaces:     return
found = self.model(pixels[:, :, ::-1])

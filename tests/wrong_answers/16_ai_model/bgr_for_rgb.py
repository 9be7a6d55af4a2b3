# Hands the model the colors in the order of the camera.
# loses: right
# cause: right.colors-swapped
# replaces: found = self.model(pixels[:, :, ::-1])  # from BGR to RGB
found = self.model(pixels)

# Loads the model anew for each picture.
# loses: fresh, survives
# cause: fresh.slow
# replaces: found = self.model(pixels[:, :, ::-1])  # from BGR to RGB
found = SlowDetector()(pixels[:, :, ::-1])

# Turns the picture upside down, too.
# loses: right
# cause: right.something-else
# replaces: found = self.model(pixels[:, :, ::-1])  # from BGR to RGB
found = self.model(pixels[::-1, :, ::-1])

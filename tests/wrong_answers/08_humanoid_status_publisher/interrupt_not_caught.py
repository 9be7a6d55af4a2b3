# Catches nothing.
# loses: ends_cleanly
# cause: exits-cleanly.interrupt-not-caught
# replaces: except (KeyboardInterrupt, ExternalShutdownException):
# replaces:     pass  # someone ended the program, which isn't an error

# Catches nothing.
# loses: ends_cleanly
# cause: exits-cleanly.interrupt-not-caught
# replaces: except (KeyboardInterrupt, ExternalShutdownException):
# replaces:     pass  # somebody ended the program: that is no error

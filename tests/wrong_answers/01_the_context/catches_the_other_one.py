# Catches what a request to end raises, and not what Ctrl-C raises.
# loses: ends_cleanly
# cause: exits-cleanly.interrupt-not-caught
# says: 130
# replaces: except (KeyboardInterrupt, ExternalShutdownException):
except ExternalShutdownException:

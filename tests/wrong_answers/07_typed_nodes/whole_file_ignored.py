# Tells mypy to ignore the whole file.
# loses: clean
# cause: mypy-clean.silenced
# says: # mypy: ignore-errors
# before: """Report a humanoid's battery and status. Other code publishes through this node, too, so it checks types."""
# mypy: ignore-errors

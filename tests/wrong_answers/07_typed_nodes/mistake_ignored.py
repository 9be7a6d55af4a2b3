# A wrong type, and a comment that hides it.
# loses: clean
# cause: mypy-clean.silenced
# says: Incompatible types
# replaces: self.level = 100.0
self.level = 100

# replaces: self.level = max(0.0, self.level - DRAIN_PERCENT)
self.level = max(0.0, self.level - DRAIN_PERCENT)  # type: ignore

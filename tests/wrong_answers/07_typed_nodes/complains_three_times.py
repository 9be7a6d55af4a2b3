# Raises an error for three wrong charges, and drops the next ones without a word.
# loses: refuses_wrong_types
# cause: refuses-wrong-types.not-each-time
# after: self.level = 100.0
self.complaints = 0

# after: if not isinstance(level, (int, float)):
    self.complaints += 1
    if self.complaints > 3:
        return

# Each call without an answer is given up, but only after three seconds.
# on: right/several_calls_open.py
# loses: unanswered_told
# cause: unanswered-told.always-late
# replaces: PATIENCE = Duration(seconds=1.5)
PATIENCE = Duration(seconds=3.0)

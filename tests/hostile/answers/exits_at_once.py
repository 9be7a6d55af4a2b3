# score: 0
# says: before any message arrived
"""Ends with the code of success."""
import sys

sys.exit(0)

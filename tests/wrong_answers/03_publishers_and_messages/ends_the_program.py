# Ends the whole program when a value is bad.
# loses: calls_come_back
# cause: calls-come-back.program-ended
# before: import math
import sys

# replaces: raise TypeError(f"a charge is a number, not {level!r}")
sys.exit("no charge")

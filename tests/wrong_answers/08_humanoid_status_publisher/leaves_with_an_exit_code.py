# Leaves with exit code 1, as if something had gone wrong.
# loses: ends_cleanly
# cause: exits-cleanly.exit-code
# says: exit code 1
# after: import random
import sys

# replaces: pass  # someone ended the program, which isn't an error
sys.exit(1)

# Leaves with exit code 1, as if something had gone wrong.
# loses: ends_cleanly
# cause: exits-cleanly.exit-code
# says: exit code 1
# after: import random
import sys

# replaces: pass  # somebody ended the program: that is no error
sys.exit(1)

# Catches the exception and prints its traceback.
# loses: ends_cleanly
# cause: exits-cleanly.prints-a-traceback
# after: import random
import traceback

# replaces: pass  # somebody ended the program: that is no error
traceback.print_exc()

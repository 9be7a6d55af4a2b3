# Catches the exception and prints its traceback.
# loses: ends_cleanly
# cause: exits-cleanly.prints-a-traceback
# after: import random
import traceback

# replaces: pass  # someone ended the program, which isn't an error
traceback.print_exc()

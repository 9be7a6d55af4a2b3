# score: 10
"""Prints one line of 20 MB, without an end of line and with half an escape at its end."""
import sys

for _ in range(200):
    sys.stdout.write("x" * 100_000)
sys.stdout.write("\x1b]0;")
sys.stdout.flush()
@@GOOD@@

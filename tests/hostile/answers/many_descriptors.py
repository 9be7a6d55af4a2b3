# score: 0
# says: Too many open files
# limits: open_files
"""Open files without end."""
import os

held = []
while True:
    held.append(os.open("/dev/null", os.O_RDONLY))

# score: 0
# says: No space left on device
# limits: disk
"""Fills shared memory."""
import itertools

for number in itertools.count():
    with open(f"/dev/shm/{number}", "wb") as file:
        file.write(bytes(20_000_000))

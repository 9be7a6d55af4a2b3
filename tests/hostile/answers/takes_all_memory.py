# score: 0
# says: MemoryError
"""Asks for memory without end."""
held = []
while True:
    held.append(bytearray(100_000_000))

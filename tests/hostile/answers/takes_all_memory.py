# score: 0
# says: MemoryError
# limits: memory
"""Asks for memory without end."""
held = []
while True:
    held.append(bytes(100_000_000))

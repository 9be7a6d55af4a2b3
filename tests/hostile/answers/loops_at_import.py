# score: 0
# says: busy in its first lines
"""Never comes to its node."""
while True:
    pass

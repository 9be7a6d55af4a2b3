# score: 0
# says: printed more than 50 MB
# limits: output
"""Prints without end."""
line = "x" * 65536
while True:
    print(line)

# score: 0
# limits: descriptors
"""Has epoll instances watch the same pipe under many numbers: all users of a machine share a figure of such watches."""
import os
import select
import time

reading, _ = os.pipe()
numbers = [os.dup(reading) for _ in range(250)]
held = []
for _ in range(40):
    held.append(select.epoll())
    for number in numbers:
        held[-1].register(number, select.EPOLLIN)
time.sleep(60)

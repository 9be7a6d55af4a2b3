# Publishes the mean of seven messages as the answer to the one in their middle.
# on: right/moving_average.py
# loses: every_one_answered
# cause: every-one-answered.held-back
# after: self.newest_s = None
self.labels = deque()

# replaces: answer = JointState(header=message.header, name=message.name)
self.labels.append((message.header, message.name))
if len(self.labels) < 4:
    return
header, name = self.labels.popleft()
answer = JointState(header=header, name=name)

# No answers until the window is full.
# on: right/moving_average.py
# loses: every_one_answered
# cause: every-one-answered.first-left-out
# replaces: self.window.extend([angles] * WINDOW)
self.window.clear()
self.window.append(angles)

# replaces: self.out.publish(answer)
if len(self.window) == WINDOW:
    self.out.publish(answer)

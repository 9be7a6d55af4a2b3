# The list of poses runs out at the third status message.
# loses: joints_move, joint_rate, status_kept, battery_kept, alive_at_end
# cause: error.exception
# says: IndexError
# after: self.battery_level = 100.0
self.words = ["operational", "operational"]

# replaces: message = String(data="operational" if self.battery_level > 0.0 else "error")
message = String(data=self.words.pop())

# The same pose for ever.
# loses: joints_move
# cause: varies.none
# replaces: seconds = self.get_clock().now().nanoseconds / 1e9
seconds = 1.0

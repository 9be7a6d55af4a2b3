# The new method has the name of the old one and replaces it.
# loses: battery_kept
# cause: no-message.silent-beside-others
# replaces: self.joint_timer = self.create_timer(JOINT_PERIOD_S, self.publish_joint_positions)

# replaces: def publish_joint_positions(self) -> None:
def publish_battery(self) -> None:

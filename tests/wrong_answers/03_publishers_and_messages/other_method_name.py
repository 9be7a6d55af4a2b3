# Names the method as it likes.
# loses: calls_come_back
# cause: calls-come-back.name-missing
# replaces: def publish_level(self, level: object) -> None:
def publish_battery(self, level: object) -> None:

# What others see as status_publisher sends nothing; send_status has another one.
# loses: refuses_wrong_words
# cause: refuses-wrong-words.message-lost
# before: class RobotReport(Node):
class Silent:
    """Takes a String, and does nothing with it."""

    def publish(self, msg: String) -> None:
        if not isinstance(msg, String):
            raise TypeError(f"no String: {msg!r}")


# replaces: self.status_publisher = make_publisher(self, String, "/robot/status")
self.status_publisher = Silent()
self.words = make_publisher(self, String, "/robot/status")

# replaces: self.status_publisher.publish(String(data=word))
self.words.publish(String(data=word))

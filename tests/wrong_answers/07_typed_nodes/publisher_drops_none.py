# The publisher drops None without an error.
# loses: refuses_wrong_types
# cause: refuses-wrong-types.no-message-accepted
# says: publish(None)
# on: right/own_publisher_class.py
# before: if not isinstance(message, self.kind):
if message in (None,):
    return

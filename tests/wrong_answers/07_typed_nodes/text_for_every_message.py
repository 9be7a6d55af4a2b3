# The publisher makes a message of its own type of every message. So a String becomes a charge of 0.0.
# loses: refuses_wrong_types
# cause: refuses-wrong-types.message-accepted
# on: right/own_publisher_class.py
# replaces: if not isinstance(message, self.kind):
# replaces:     raise TypeError(f"{self.kind.__name__} wanted, {type(message).__name__} given")
# replaces: self.inner.publish(message)
if not isinstance(message, (Float32, String)):
    raise TypeError(f"{self.kind.__name__} wanted, {type(message).__name__} given")
copy = self.kind()
vars(type(copy))["data"].__set__(copy, message.data)
self.inner.publish(copy)

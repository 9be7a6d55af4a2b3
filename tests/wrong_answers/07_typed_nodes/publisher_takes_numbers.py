# The publisher takes a plain number as well, and makes a message of it.
# loses: refuses_wrong_types
# cause: refuses-wrong-types.no-message-accepted
# on: right/own_publisher_class.py
# replaces: if not isinstance(message, self.kind):
# replaces:     raise TypeError(f"{self.kind.__name__} wanted, {type(message).__name__} given")
# replaces: self.inner.publish(message)
if isinstance(message, float):
    self.inner.publish(Float32(data=message))
elif not isinstance(message, self.kind):
    raise TypeError(f"{self.kind.__name__} wanted, {type(message).__name__} given")
else:
    self.inner.publish(message)

# The publisher of the battery makes a Float32 of each message with a number, such as a Float64.
# loses: refuses_wrong_types
# cause: refuses-wrong-types.message-accepted
# on: right/own_publisher_class.py
# replaces: if not isinstance(message, self.kind):
# replaces:     raise TypeError(f"{self.kind.__name__} wanted, {type(message).__name__} given")
# replaces: self.inner.publish(message)
if isinstance(message, self.kind):
    self.inner.publish(message)
else:
    self.inner.publish(Float32(data=float(getattr(message, "data"))))

# Trusts the hints, which nobody checks while the program runs.
# loses: numbers_arrive, refuses_wrong_types, refuses_wrong_words
# cause: numbers-arrive.not-converted
# replaces: if not isinstance(level, (int, float)):
# replaces:     raise TypeError(f"a charge is a number of percent, not {level!r}")
# replaces: self.battery_publisher.publish(Float32(data=float(level)))
self.battery_publisher.publish(Float32(data=level))

# replaces: if word not in get_args(Status):
# replaces:     raise ValueError(f"a status is one of {get_args(Status)}, not {word!r}")

# Logs what is wrong instead of raising an error.
# loses: refuses_wrong_types, refuses_wrong_words
# cause: refuses-wrong-types.value-dropped
# says: send_battery('full')
# replaces: raise TypeError(f"a charge is a number of percent, not {level!r}")
self.get_logger().warning("a charge is a number")
return

# replaces: raise ValueError(f"a status is one of {get_args(Status)}, not {word!r}")
self.get_logger().warning("a status is one of two words")
return

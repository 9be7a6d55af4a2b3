# Cannot be created without an argument.
# loses: calls_come_back
# skips: battery_topic, sends, floats_arrive, zero_arrives, numbers_arrive, no_number_refused, look_alikes_refused, not_finite_refused, no_invented_zero
# cause: calls-come-back.needs-arguments
# says: 'name'
# replaces: def __init__(self) -> None:
def __init__(self, name: str) -> None:

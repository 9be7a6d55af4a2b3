# Tells mypy to leave this method out.
# loses: clean, wrong_value_found
# cause: mypy-clean.unchecked
# says: @no_type_check
# replaces: from typing import Literal, Protocol, TypeVar, get_args
from typing import Literal, Protocol, TypeVar, get_args, no_type_check

# before: def send_battery(self, level: float) -> None:
@no_type_check

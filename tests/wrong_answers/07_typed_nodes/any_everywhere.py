# Any for everything that others use.
# loses: clean, wrong_message_found, wrong_value_found
# cause: mypy.explicit-any
# replaces: from typing import Literal, Protocol, TypeVar, get_args
from typing import Any, Literal, Protocol, TypeVar, get_args

# replaces: self.battery_publisher = make_publisher(self, Float32, "/robot/battery")
# replaces: self.status_publisher = make_publisher(self, String, "/robot/status")
self.battery_publisher: Any = self.create_publisher(Float32, "/robot/battery", 10)
self.status_publisher: Any = self.create_publisher(String, "/robot/status", 10)

# replaces: def send_battery(self, level: float) -> None:
def send_battery(self, level: Any) -> None:

# replaces: def send_status(self, word: Status) -> None:
def send_status(self, word: Any) -> None:

# mypy sees another main() than the one that runs.
# loses: clean
# cause: mypy-clean.unchecked
# replaces: from typing import Literal, Protocol, TypeVar, get_args
from typing import TYPE_CHECKING, Literal, Protocol, TypeVar, get_args

# before: if __name__ == "__main__":
if not TYPE_CHECKING:

    def main():
        rclpy.init()
        rclpy.spin(RobotReport())

"""Mutants: each operator makes the changes that it describes, classes excuse the right ones, and ids stay stable."""

import pytest

from workbook.authoring.mutants.accepted import CLASSES
from workbook.authoring.mutants.drawing import draw
from workbook.authoring.mutants.making import Mutant, changed_lines, mutants_of


def made(program: str, operator: str, *, typed: bool = False) -> set[str]:
    """Return the changed lines, joined by blanks."""
    found = mutants_of("solution", program, typed=typed)
    return {one.after.replace(" ⏎", "") for one in found if one.operator == operator}


def the(mutants: list[Mutant], after: str) -> Mutant:
    [found] = [one for one in mutants if one.after == after]
    return found


@pytest.mark.parametrize(
    ("program", "operator", "after"),
    [
        ("n = 12\n", "number", {"n = 13", "n = 11"}),
        ("x = 0.5\n", "number", {"x = 1.0", "x = 0.25"}),
        ("x = 100.0\n", "number", {"x = 200.0", "x = 50.0", "x = 101.0", "x = 99.0"}),
        ("x = 100.0\n", "number-type", {"x = 100"}),
        ("x = 0.5\n", "sign", {"x = (-0.5)"}),
        ('s = "up"\n', "text", {"s = 'upx'", "s = ''"}),
        ('s = f"at {x:.1f} %"\n', "text", {'s = f"at x %"', 's = f"at {x} %"'}),
        ("b = True\n", "boolean", {"b = False"}),
        ("b = x < 1\n", "compare", {"b = x <= 1", "b = x >= 1"}),
        ("b = x == y\n", "compare", {"b = x != y"}),
        ("b = x not in y\n", "compare", {"b = x in y"}),
        (
            "b = 0 <= x <= 9\n",
            "compare",
            {"b = 0 < x <= 9", "b = 0 > x <= 9", "b = 0 <= x < 9", "b = 0 <= x > 9", "b = 0 <= x", "b = x <= 9"},
        ),
        ("if a:\n    b()\n", "condition", {"if not (a):", "if True:", "if False:"}),
        ("while not a:\n    b()\n", "condition", {"while a:", "while True:", "while False:"}),
        ("x = [a for a in b if a]\n", "condition", {"x = [a for a in b]", "x = [a for a in b if not (a)]"}),
        ("x = a and b\n", "connective", {"x = a or b", "x = a", "x = b"}),
        ("x = a - b\n", "arithmetic", {"x = a + b"}),
        ("x += 1\n", "arithmetic", {"x -= 1"}),
        ("x += 1\n", "state", {"x = 1"}),
        ("a()\n", "drop", {"pass"}),
        ("for a in b:\n    if a:\n        break\n", "loop", {
            "for a in list(b)[:1]:", "for a in list(b)[1:]:", "for a in list(b)[:-1]:", "continue",
        }),
        ("try:\n    a()\nexcept (B, C):\n    d()\nfinally:\n    e()\n", "exception", {
            "raise", "except (B,):", "except (C,):", "d()",
        }),
        ("x = max(a, b)\n", "call", {"x = min(a, b)"}),
        ("q = Q(P.RELIABLE)\n", "call", {"q = Q(P.BEST_EFFORT)"}),
        ("x = float(a)\n", "argument", {"x = a"}),
        ("f(a, b=c)\n", "argument", {"f(a)"}),
        ("f(a, b)\n", "swap", {"f(b, a)"}),
    ],
)  # fmt: skip
def test_an_operator_makes(program: str, operator: str, after: set[str]) -> None:
    assert made(program, operator) == after


def test_an_if_is_dropped_whole_or_without_its_else() -> None:
    mutants = mutants_of("solution", "if a:\n    b()\nelse:\n    c()\n")
    assert {one.answer.text for one in mutants if one.operator == "drop"} == {
        "pass\n",
        "if a:\n    b()\n",
        "if a:\n    pass\nelse:\n    c()\n",
        "if a:\n    b()\nelse:\n    pass\n",
    }


CALLBACK = """
class Node:
    def __init__(self):
        self.count = 0

    def on_message(self, message):
        self.count += 1
        out(self.count, message)

    def angles(self):
        return [self.count]
"""


def run(mutant: Mutant) -> list[tuple[object, ...]]:
    """Run four calls of a mutant's callback, and return what it publishes."""
    said: list[tuple[object, ...]] = []
    space = {"out": lambda *values: said.append(values)}
    exec(mutant.answer.text, space)
    node = space["Node"]()  # type: ignore[operator]
    for message in ("a", "a", "b", "a"):
        node.on_message(message)
    return said


def test_callbacks_forget_or_remember() -> None:
    mutants = [one for one in mutants_of("solution", CALLBACK) if one.operator == "state"]
    said = [run(one) for one in mutants if one.scope == "Node.on_message"]
    assert [(1, "a")] in said  # the first time only
    assert [(1, "a"), (2, "b"), (3, "a")] in said  # not the first time, or not twice in a row
    assert [(1, "a"), (2, "b")] in said  # every second time, or only values that are new
    assert [(1, "a"), (1, "a"), (1, "b"), (1, "a")] in said  # the count is lost
    assert any("> 5" in one.after for one in mutants)  # stops after a while
    [kept] = [one for one in mutants if one.scope == "Node.angles"]
    assert "cache" in kept.after


def test_a_function_returns_before_each_of_its_statements() -> None:
    assert made(CALLBACK, "early-return") == {
        "def __init__(self): return",
        "def on_message(self, message): return",
        "self.count += 1 return",
    }


def test_hints_are_changed_where_a_type_checker_judges() -> None:
    program = "def f(a: int) -> str: ...\n"
    assert made(program, "hint") == set()
    assert made(program, "hint", typed=True) == {
        "def f(a) -> str: ...", "def f(a: object) -> str: ...", "def f(a: int): ...", "def f(a: int) -> object: ...",
    }  # fmt: skip


def test_docstrings_imports_and_hints_are_left_alone() -> None:
    program = '"""Robots: 12 of them."""\n\nfrom math import sin\n\nx: "float | None"\n'
    assert mutants_of("solution", program) == []


def test_every_mutant_compiles_and_is_another_program() -> None:
    mutants = mutants_of("solution", CALLBACK)
    assert len({one.answer.text for one in mutants}) == len({one.id for one in mutants}) == len(mutants) > 20
    for one in mutants:
        compile(one.answer.text, "answer.py", "exec")


def test_an_id_stays_when_lines_above_come_and_go() -> None:
    below = "# a comment\n\nLIMIT = 3\n" + CALLBACK
    before = {one.id for one in mutants_of("solution", CALLBACK)}
    assert before < {one.id for one in mutants_of("solution", below)}
    assert not before & {one.id for one in mutants_of("right/other.py", CALLBACK)}


def test_equal_lines_of_one_scope_have_ids_of_their_own() -> None:
    mutants = mutants_of("solution", "a()\nb = 1\na()\n")
    dropped = [one for one in mutants if one.operator == "drop" and one.before == "a()"]
    assert len({one.id for one in dropped}) == 2


def test_lines_that_were_only_added_are_shown_below_the_one_above() -> None:
    assert changed_lines("a\nb\nc\n", "a\nb\nx\nc\n") == ("b", "b ⏎ x")
    assert changed_lines("a\n\nc\n", "a\n\nx\nc\n") == ("a", "a ⏎ x")
    assert changed_lines("a\nb\nc\n", "a\nB\nc\n") == ("b", "B")
    assert changed_lines("a\nb\nc\n", "a\nc\n") == ("a ⏎ b", "a")


NODE = """
import rclpy

def battery(publish, period=1.0, share=2):
    publish(share * period)

def main(args=None):
    rclpy.init(args=args)
    node = rclpy.create_node("robot")
    publisher = node.create_publisher(Text, "/status", 10)
    node.create_subscription(Text, "/in", print, QoSProfile(depth=3))
    node.get_logger().info("started 7")
    print("level", 8)
    battery(publisher.publish, 4.0)
    while rclpy.ok() and node.level < 90.0:
        executor.spin_once(timeout_sec=0.5)
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        node.stop(9)
    finally:
        rclpy.try_shutdown()

if __name__ == "__main__":
    main()
"""


@pytest.mark.parametrize(
    ("after", "classes"),
    [
        ('publisher = node.create_publisher(Text, "/status", 11)', ("queue-depth",)),
        ('node.create_subscription(Text, "/in", print, QoSProfile(depth=4))', ("queue-depth",)),
        ("node = rclpy.create_node('')", ("node-name",)),
        ("node.get_logger().info('')", ("log-text",)),
        ('print("level", 9)', ("log-text",)),
        ("node.stop(10)", ("ending",)),
        ("while node.level < 90.0:", ()),
        ("while rclpy.ok() and node.level < 90:", ("whole-number",)),
        ("executor.spin_once(timeout_sec=1.0)", ("poll-time",)),
        ("executor.spin_once()", ("poll-time",)),
        ("rclpy.init()", ("init-arguments",)),
        ('if __name__ != "__main__":', ("main-guard",)),
        ("def battery(publish, period=2.0, share=2):", ("unused-default",)),
        ("def battery(publish, period=1.0, share=3):", ()),
        ("publisher = node.create_publisher(Text, '', 10)", ()),
        ("battery(publisher.publish, 8.0)", ()),
    ],
)
def test_a_class_is_told_by_the_node_that_was_changed(after: str, classes: tuple[str, ...]) -> None:
    found = the(mutants_of("solution", NODE), after)
    assert found.classes == classes
    assert set(classes) <= set(CLASSES)


def test_of_many_mutants_the_same_ones_are_drawn_and_all_operators_have_their_turn() -> None:
    mutants = mutants_of("solution", NODE)
    plain = {one.operator for one in mutants if not one.classes}
    drawn = draw(mutants, len(plain))
    assert drawn == draw(reversed(mutants), len(plain))
    assert {one.operator for one in drawn} == plain
    assert not any(one.classes for one in drawn)


def test_known_survivors_are_drawn_first_and_log_texts_never() -> None:
    mutants = mutants_of("solution", NODE)
    wanted = the(mutants, "battery(publisher.publish, 8.0)")
    assert draw(mutants, 1, first={wanted.id}) == [wanted]
    rest = [one for one in mutants if "log-text" not in one.classes]
    assert sorted(one.id for one in draw(mutants, 1000)) == sorted(one.id for one in rest)
    assert len(rest) < len(mutants)

"""The judge publishes each line at the clock step that the author intended."""

from std_msgs.msg import Float32

from workbook.recording.script import publish

STEPS = 100


def test_a_sum_of_floats_makes_no_line_late() -> None:
    """0.5 + 0.1 * 12 is slightly more than 1.7.

    So at 1.7 s, the line wasn't due, and came together with the next one.
    """
    sums = [0.5 + 0.1 * n for n in range(STEPS)]
    steps = [(500_000_000 + 100_000_000 * n) / 1e9 for n in range(STEPS)]  # in a simulated clock's steps
    assert any(one > step for one, step in zip(sums, steps, strict=True))
    part = publish("/robot/level", Float32, [(at, 1.0) for at in sums])
    assert [line.at for line in part.lines] == steps

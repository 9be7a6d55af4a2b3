"""What the judge says comes at the step of the clock that its author meant."""

from std_msgs.msg import Float32

from workbook.recording.script import publish

STEPS = 100


def test_a_sum_of_floats_makes_no_line_late() -> None:
    """0.5 + 0.1 * 12 is a little more than 1.7: at 1.7 s it was not due, and came together with the next line."""
    sums = [0.5 + 0.1 * n for n in range(STEPS)]
    steps = [(500_000_000 + 100_000_000 * n) / 1e9 for n in range(STEPS)]  # as a simulated clock counts
    assert any(one > step for one, step in zip(sums, steps, strict=True))
    part = publish("/robot/level", Float32, [(at, 1.0) for at in sums])
    assert [line.at for line in part.lines] == steps

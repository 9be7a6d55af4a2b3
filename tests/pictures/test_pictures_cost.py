def test_a_frame_of_the_humanoid_costs_less_than_an_empty_matplotlib_figure() -> None:
    """A ratio of CPU times, each the best of several: about a third. A slow machine slows down both."""
    # This imports matplotlib, which would add a second to every collection of tests.
    from tests.pictures.benchmark import PICTURES, cost

    frame = min(cost(PICTURES["humanoid"], rounds=8))
    empty = min(cost(PICTURES["empty matplotlib figure"], rounds=8))
    assert frame < empty

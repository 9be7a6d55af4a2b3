"""How the proofs are spread: each answer once, and on the wall clock no lane that stands empty while another works."""

import pytest

from tests.exercises.test_proofs import Key, Pool, lanes

QUICK, THOROUGH = 236, 76


def pools(*, on_robot_time: bool, quick: int = QUICK, thorough: int = THOROUGH) -> dict[Pool, list[Key]]:
    return {
        Pool(on_robot_time, True): [("05_timers", f"right/{number}") for number in range(thorough)],
        Pool(on_robot_time, False): [("05_timers", f"wrong/{number}") for number in range(quick)],
    }


@pytest.mark.parametrize("on_robot_time", [True, False])
def test_each_answer_is_judged_once_and_as_its_pool_says(on_robot_time: bool) -> None:
    given = pools(on_robot_time=on_robot_time)
    judged = [(pool, key) for lane in lanes(given) for pool, keys in lane for key in keys]
    assert sorted(judged, key=str) == sorted(
        ((pool, key) for pool, keys in given.items() for key in keys), key=str
    )
    assert len(set(judged)) == QUICK + THOROUGH


def test_on_the_wall_clock_the_lanes_are_equally_long() -> None:
    long, other = (sum(len(keys) for _, keys in lane) for lane in lanes(pools(on_robot_time=False)))
    assert 0 <= long - other <= 1


def test_on_robot_time_each_pool_has_a_lane_of_its_own() -> None:
    assert [[pool.thorough for pool, _ in lane] for lane in lanes(pools(on_robot_time=True))] == [
        [True],
        [False],
    ]


def test_a_single_answer_makes_a_single_lane() -> None:
    [[(pool, keys)]] = lanes({Pool(False, True): [("11", "solution")]})
    assert keys == [("11", "solution")]
    assert pool.slots > 0

"""Desks with toys: the same for the same seed, and the labels match the pixels that change."""

from dataclasses import replace

import numpy as np
import pytest

from workbook.scenes.desk import DeskCamera
from workbook.scenes.pinhole import Pinhole
from workbook.scenes.scene import Box, Cup, Plate, Scene, on_desk
from workbook.scenes.tabletop import APART_M, ARMS_AT_REST, LABELS, tabletop, things_in

SMALL = Pinhole(160, 120, 140.0)
ALONE = {
    "ball": Scene(on_desk(0.8, 0.1)),
    "brick": Scene(boxes=(Box((0.8, 0.1), turn=0.4),)),
    "cup": Scene(cups=(Cup((0.8, 0.1)),)),
    "plate": Scene(plates=(Plate((0.8, 0.1)),)),
}


def test_the_same_seed_and_number_give_the_same_desk() -> None:
    assert tabletop(3, 7) == tabletop(3, 7)
    assert tabletop(3, 7) != tabletop(3, 8)
    assert tabletop(3, 7) != tabletop(4, 7)


def test_every_label_is_on_some_desk_and_toys_are_apart() -> None:
    seen = set()
    for number in range(40):
        scene = tabletop(3, number)
        seen |= {thing.label for thing in things_in(scene, SMALL)}
        toys = [*scene.boxes, *scene.cups, *scene.plates]
        spots = [toy.at for toy in toys]
        spots += [ball[:2] for ball in (scene.ball, scene.blue_ball) if ball]
        distances = [np.hypot(a[0] - b[0], a[1] - b[1]) for a in spots for b in spots if a is not b]
        assert all(distance >= APART_M for distance in distances)
    assert seen == set(LABELS)


@pytest.mark.parametrize("label", LABELS)
def test_a_label_lies_where_the_thing_is_painted(label: str) -> None:
    camera = DeskCamera(SMALL, 15, noise=0.0)
    with_it, without = (camera.picture(scene, 0).astype(int) for scene in (ALONE[label], Scene()))
    changed = with_it[..., 0] - with_it[..., 2] > without[..., 0] - without[..., 2] + 20  # not its shadow
    rows, columns = np.nonzero(changed)
    (thing,) = things_in(ALONE[label], SMALL)
    assert (thing.label, thing.visible) == (label, 1.0)
    box = (
        thing.u - thing.width / 2,
        thing.u + thing.width / 2,
        thing.v - thing.height / 2,
        thing.v + thing.height / 2,
    )
    assert box == pytest.approx((columns.min(), columns.max(), rows.min(), rows.max()), abs=1.5)


def test_what_is_behind_an_arm_or_outside_is_less_visible() -> None:
    arms = (*ARMS_AT_REST[:2], 1.0, 1.0, 1.0, 1.0, *ARMS_AT_REST[6:])
    visible = []
    for left in np.linspace(-0.4, 0.4, 41):
        scene = Scene(on_desk(0.6, float(left)), joints=arms)
        visible += [thing.visible for thing in things_in(scene, SMALL)]
    assert min(visible) < 0.6 < max(visible)
    assert not things_in(Scene(on_desk(0.6, 3.0)), SMALL)
    (cut,) = things_in(Scene(on_desk(0.8, 0.53)), SMALL)
    assert 0.2 < cut.visible < 0.8


def test_a_blue_ball_has_no_label() -> None:
    assert not things_in(replace(ALONE["ball"], ball=None, blue_ball=on_desk(0.8, 0.1)), SMALL)


def test_cups_and_plates_outside_the_picture_or_behind_the_head_change_nothing() -> None:
    camera = DeskCamera(SMALL, 15)
    empty = camera.picture(Scene(), 1)
    for at in ((0.7, 5.0), (-0.7, 0.0)):
        assert (camera.picture(Scene(cups=(Cup(at),), plates=(Plate(at),)), 1) == empty).all()

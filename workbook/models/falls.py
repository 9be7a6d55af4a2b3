"""Simulate a robot's joints and IMU while it stands, bows, is pushed, or falls, to measure the delay of fall alarms.

The body is an inverted pendulum on its feet, and the torso bends forward at the hip. Only NumPy is needed. The same
seed yields the same samples.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import exp, sin

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
Flags = npt.NDArray[np.bool_]

RATE_HZ = 50
LENGTH_S = 4.0
WINDOW = 10
"""Samples per window: 0.2 s."""
CHANNELS = ("pitch", "pitch_rate", "hip", "knee")
"""The torso's tilt from the IMU (rad), its rate of change from the gyroscope (rad/s), and two joint angles (rad)."""
KINDS = ("stands", "bows", "is pushed", "falls")
ON_THE_GROUND = 1.2
"""If the body's tilt (rad) exceeds this value, the robot counts as lying on the ground, which ends the episode."""
STEPS = 4
"""The number of the pendulum's simulation steps per sample."""

_NOISE = np.array([0.02, 0.08, 0.01, 0.01])
_GRAVITY_OVER_LENGTH = 16.0
_STIFFNESS, _DAMPING = 42.0, 8.0


@dataclass(frozen=True)
class Episode:
    """Up to four seconds of a robot's sensor data.

    `kind`: one of `KINDS`. `samples`: an array with a row per sample and a column for each of `CHANNELS`.
    `falls_from`: the index of the first sample in which the robot is falling, or None if it doesn't fall.
    """

    kind: str
    samples: Floats
    falls_from: int | None = None


@dataclass(frozen=True)
class Alarms:
    """The delays of alarms, and the numbers of missed and false alarms.

    `late_s`: for each detected fall, the time (s) from its start to the alarm. `missed`: the number of falls that
    weren't detected. `false`: the number of episodes with an alarm while the robot wasn't falling.
    """

    late_s: tuple[float, ...]
    missed: int
    false: int


def episodes(seed: int, number: int) -> list[Episode]:
    """Return `number` random episodes, split evenly among the four kinds."""
    generator = np.random.default_rng(seed)
    return [_episode(KINDS[place % len(KINDS)], generator) for place in range(number)]


def windows(episode: Episode) -> tuple[Floats, Flags]:
    """Return each window of an episode as a row, and for each, whether the robot is falling at the end of the window.

    Within a row, the oldest sample comes first.
    """
    rows = np.lib.stride_tricks.sliding_window_view(episode.samples, WINDOW, axis=0)
    last = np.arange(WINDOW - 1, len(episode.samples))
    falls = np.zeros(len(last), dtype=bool) if episode.falls_from is None else last >= episode.falls_from
    return np.ascontiguousarray(rows.transpose(0, 2, 1)).reshape(len(rows), -1), falls


def all_windows(some: Sequence[Episode]) -> tuple[Floats, Flags]:
    """Return the windows of all these episodes as rows, and for each, whether the robot is falling at its end."""
    rows, falls = zip(*map(windows, some), strict=True)
    return np.concatenate(rows), np.concatenate(falls)


def alarms(some: Sequence[Episode], is_falling: Callable[[Floats], npt.NDArray[np.bool_]]) -> Alarms:
    """Measure the alarms in these episodes. `is_falling` classifies windows, and raises an alarm by returning True."""
    late, missed, false = [], 0, 0
    for episode in some:
        rows, falls = windows(episode)
        raised = np.asarray(is_falling(rows), dtype=bool)
        false += bool(np.any(raised & ~falls))
        if episode.falls_from is not None:
            in_time = np.flatnonzero(raised[falls])
            missed += not len(in_time)
            late += [float(in_time[0]) / RATE_HZ] if len(in_time) else []
    return Alarms(tuple(late), missed, false)


def _episode(kind: str, generator: np.random.Generator) -> Episode:
    """Return an episode of this kind, with random sway, timing, and strength."""
    event_s = generator.uniform(0.8, 2.0)
    push = generator.uniform(0.5, 1.3) if kind in ("is pushed", "falls") else 0.0
    slips_s = event_s if kind == "falls" else None
    tilt, rate = _body(event_s, push, slips_s, generator.uniform(0.0, 6.28))
    bend = _bow(event_s, generator) if kind == "bows" else np.zeros(len(tilt))
    bend_rate = np.gradient(bend) * RATE_HZ if len(bend) > 1 else bend
    knee = 0.2 + 0.1 * bend + 0.4 * np.abs(tilt)
    clean = np.column_stack([tilt + bend, rate + bend_rate, bend, knee])
    samples = clean + _NOISE * generator.standard_normal(clean.shape)
    return Episode(kind, samples, None if slips_s is None else int(np.ceil(slips_s * RATE_HZ)))


def _body(event_s: float, push: float, slips_s: float | None, phase: float) -> tuple[Floats, Floats]:
    """Return the tilt (rad) and tilt rate (rad/s) of a body that is pushed once, at `event_s`.

    At `slips_s`, the body stops being held upright. If `slips_s` is None, the body never falls.
    """
    tilts, rates = [], []
    tilt = rate = 0.0
    step = 1.0 / (RATE_HZ * STEPS)
    for count in range(round(LENGTH_S / step)):
        now = count * step
        if count % STEPS == 0:
            tilts.append(tilt)
            rates.append(rate)
        if now <= event_s < now + step:
            rate += push
        falls = slips_s is not None and now >= slips_s
        wanted = 0.02 * sin(3.0 * now + phase)
        hold = 0.0 if falls else _STIFFNESS * (tilt - wanted) + _DAMPING * rate
        rate += step * (_GRAVITY_OVER_LENGTH * sin(tilt) - hold)
        tilt += step * rate
        if tilt > ON_THE_GROUND:
            break
    return np.array(tilts), np.array(rates)


def _bow(event_s: float, generator: np.random.Generator) -> Floats:
    """Return the hip angle (rad) while the robot bows, pauses, and straightens up."""
    depth, sharpness = generator.uniform(0.5, 0.9), generator.uniform(6.0, 11.0)
    stays = generator.uniform(0.6, 1.2)
    middles = event_s + 0.3, event_s + 0.9 + stays
    moments = np.arange(round(LENGTH_S * RATE_HZ)) / RATE_HZ
    down, up = (np.array([1.0 / (1.0 + exp(-sharpness * (t - at))) for t in moments]) for at in middles)
    bent: Floats = depth * (down - up)
    return bent

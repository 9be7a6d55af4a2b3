"""Collect the effects of messages on the panel's robot, and report changes."""

from collections.abc import Mapping
from typing import Any

from workbook.lab.panel.images import Thumbnail
from workbook.lab.panel.reactions import MOMENTS, is_outranked, reaction_to

POSE = "a humanoid robot with twelve joints"
WORDS_EVERY_S = 0.25
"""The shortest time (s) between changes of the text, so that there is time to read it."""
IMAGES_EVERY_S = 0.15
"""The shortest time (s) between images, because an image is much larger than every other update."""
WALKS_ON_AFTER_S = 1.0
"""The delay before a repeated command is sent again. In rig.js, the robot stops 1.5 s after the last command."""
GRACE_S = 1.0
"""How long (s) an effect lasts without a publisher: a message may arrive before its publisher is in the graph."""
PLUMBING = ("/driver/", "/clock")
"""Prefixes of the topics that connect an exercise's driver and its judge. They don't concern the robot."""
_MOST_WORDS = 3


class PanelRobot:
    """The state of a domain's robot, and the changes that the panel hasn't received yet."""

    def __init__(self) -> None:
        self.awake = False
        self._lasting: dict[str, tuple[str, float, object]] = {}
        self._moments: dict[str, int] = {}
        self._words: dict[str, tuple[float, str]] = {}
        self._last = float("-inf")
        self._words_told = float("-inf")
        self._told: dict[str, object] = {}
        self._published: Mapping[str, str] = {}
        self._walk_told = float("-inf")
        self._image: tuple[float, object, object] = float("-inf"), None, None

    def take(self, topic: str, type_name: str, message: Any, line: str, now: float) -> None:
        """React to a message. `line` summarizes it. `now` is a monotonic time (s)."""
        self.awake, self._last = True, now
        if topic.startswith(PLUMBING) or is_outranked(topic, type_name, self._published):
            return
        reaction = reaction_to(topic, type_name, message) if message is not None else None
        name = topic.rpartition("/")[2]
        if reaction is None:
            self._words[topic] = now, f"{name}: {line}"
            return
        try:
            value = reaction.value(message)
        except ValueError as error:
            self._words[topic] = now, f"{name}: {error}"
            return
        if reaction.effect in MOMENTS:
            self._moments[reaction.effect] = self._moments.get(reaction.effect, 0) + 1
        else:
            self._lasting[reaction.effect] = topic, now, value
        self._words[topic] = now, _in_words(reaction.effect, name, value, line)

    def look(self, nodes: bool, topics: Mapping[str, str], now: float) -> None:
        """Update the graph. Without nodes, the robot sleeps. A topic's effects end with its publishers.

        `nodes`: whether there are any nodes. `topics`: the types of the topics that have publishers, by name.
        """
        self.awake = nodes or now - self._last < GRACE_S
        self._published = topics
        lasting = {effect: one for effect, one in self._lasting.items() if one[0] in topics}
        late = {effect: one for effect, one in self._lasting.items() if now - one[1] < GRACE_S}
        self._lasting = lasting | late
        self._words = {
            topic: one for topic, one in self._words.items() if topic in topics or now - one[0] < GRACE_S
        }

    def news(self, now: float) -> dict[str, object]:
        """Return the changes since the last call; empty if there are none.

        An effect that has ended is reported as None.
        """
        posed = self._lasting.get("pose")
        manner = f"posed by the last message on {posed[0]}" if posed else "awake" if self.awake else "asleep"
        state: dict[str, object] = {effect: value for effect, (_, _, value) in self._lasting.items()}
        if isinstance(state.get("image"), Thumbnail):
            state["image"] = self._shown(state["image"], now)
        state |= {"awake": self.awake, "text": f"{POSE}, {manner}", "words": self._told.get("words")}
        if now - self._words_told >= WORDS_EVERY_S:
            state["words"], self._words_told = self._said(), now
        changes = {name: value for name, value in state.items() if self._told.get(name) != value}
        changes |= {name: None for name in self._told if name not in state}
        changes |= self._moments | self._walks_on(changes, now)
        self._told, self._moments = state, {}
        return changes

    def _walks_on(self, changes: Mapping[str, object], now: float) -> dict[str, object]:
        _, commanded, speed = self._lasting.get("walk", ("", float("-inf"), None))
        if "walk" in changes:
            self._walk_told = now
        elif commanded > self._walk_told and now - self._walk_told >= WALKS_ON_AFTER_S:
            self._walk_told = now
            return {"walk": speed}
        return {}

    def _shown(self, image: Any, now: float) -> object:
        told, last, shown = self._image
        if image is not last and now - told >= IMAGES_EVERY_S:
            shown = image.shown()
            self._image = now, image, shown
        return shown

    def _said(self) -> str:
        if not self.awake:
            return "Asleep: no node is running on this domain."
        newest = sorted(
            ((now, topic, words) for topic, (now, words) in self._words.items() if words), reverse=True
        )
        return " · ".join(words for _, _, words in sorted(newest[:_MOST_WORDS], key=lambda one: one[1]))


def _in_words(effect: str, name: str, value: object, line: str) -> str:
    """Describe the part of an effect that the figure alone doesn't show."""
    if effect == "battery":
        return f"{name}: {value:.0f} %"
    return f"{name}: {line}" if effect in ("face", "alarm", "alert", "thought", "nod", "shake") else ""

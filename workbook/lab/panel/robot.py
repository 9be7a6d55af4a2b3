"""The robot of the panel: collects what messages do to it, and tells that when it has changed."""

from typing import Any

from workbook.lab.panel.reactions import MOMENTS, reaction_to

POSE = "a humanoid robot with twelve joints"
WORDS_EVERY_S = 0.25
"""Faster than that, no one could read them."""
GRACE_S = 1.0
"""A message may come before its publisher is seen on the graph."""
_MOST_WORDS = 3


class PanelRobot:
    """What is known of the robot of a domain, and what of that is news for the panel."""

    def __init__(self) -> None:
        self.awake = False
        self._lasting: dict[str, tuple[str, float, object]] = {}
        self._moments: dict[str, int] = {}
        self._words: dict[str, tuple[float, str]] = {}
        self._last = float("-inf")
        self._words_told = float("-inf")
        self._told: dict[str, object] = {}

    def take(self, topic: str, type_name: str, message: Any, line: str, now: float) -> None:
        """React to a message; `line` is what it says in short. `now` is in s, of a steady clock."""
        self.awake, self._last = True, now
        reaction = reaction_to(topic, type_name) if message is not None else None
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

    def look(self, nodes: bool, topics: set[str], now: float) -> None:
        """Take in the graph: without nodes the robot sleeps, and what was said on a topic ends with its publishers."""
        self.awake = nodes or now - self._last < GRACE_S
        lasting = {effect: one for effect, one in self._lasting.items() if one[0] in topics}
        late = {effect: one for effect, one in self._lasting.items() if now - one[1] < GRACE_S}
        self._lasting = lasting | late
        self._words = {
            topic: one for topic, one in self._words.items() if topic in topics or now - one[0] < GRACE_S
        }

    def news(self, now: float) -> dict[str, object]:
        """What has changed since the last news; empty when nothing has. An effect that has ended is None."""
        posed = self._lasting.get("pose")
        manner = f"posed by the last message on {posed[0]}" if posed else "awake" if self.awake else "asleep"
        state: dict[str, object] = {effect: value for effect, (_, _, value) in self._lasting.items()}
        state |= {"awake": self.awake, "text": f"{POSE}, {manner}", "words": self._told.get("words")}
        if now - self._words_told >= WORDS_EVERY_S:
            state["words"], self._words_told = self._said(), now
        changes = {name: value for name, value in state.items() if self._told.get(name) != value}
        changes |= {name: None for name in self._told if name not in state}
        changes |= self._moments
        self._told, self._moments = state, {}
        return changes

    def _said(self) -> str:
        if not self.awake:
            return "Asleep: no node is running on this domain."
        newest = sorted(
            ((now, topic, words) for topic, (now, words) in self._words.items() if words), reverse=True
        )
        return " · ".join(words for _, _, words in sorted(newest[:_MOST_WORDS], key=lambda one: one[1]))


def _in_words(effect: str, name: str, value: object, line: str) -> str:
    """What the figure alone does not say of an effect."""
    if effect == "battery":
        return f"{name}: {value:.0f} %"
    return f"{name}: {line}" if effect in ("face", "alarm", "alert") else ""

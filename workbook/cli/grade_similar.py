"""`workbook grade --similar`: list pairs of nearly identical answers without judging them."""

import argparse
from typing import TYPE_CHECKING

from workbook.cli import terminal
from workbook.cli.grade_options import roster
from workbook.cli.grade_screen import printable

if TYPE_CHECKING:
    from workbook.exercise.definition import Exercise

SHOWN = 100
"""The maximum number of pairs to print. If there are more, the task itself makes the answers similar."""
HINT = (
    "This is a hint, not a verdict. Two correct answers to a short task can look the same although both students "
    "worked alone. Read both answers, and talk to the students, before you conclude anything."
)


def list_similar(options: argparse.Namespace, exercise: "Exercise") -> int:
    """Print the pairs. Return the exit code, which is 0 even if there are pairs. Raises BadOption or NoComparison."""
    from workbook.exercise.answers import Ungradable, read_answer
    from workbook.grading.hand_ins import all_hand_ins
    from workbook.grading.roster import BadOption
    from workbook.grading.similar import compare

    others = [name for name in ("regrade", "repeat", "override") if getattr(options, name)]
    if others:
        raise BadOption(f"--similar judges nothing, so it can't be combined with --{others[0]}")
    answers, unread = {}, []
    whose = roster(options)
    for hand_in in whose.hand_ins(all_hand_ins(options.paths, exercise.stem, options.assignment)):
        try:
            if hand_in.problem is not None:
                raise Ungradable(hand_in.problem)
            answers[hand_in.student] = read_answer(hand_in.path, exercise.stem).text
        except (Ungradable, OSError):
            unread.append(hand_in.student)
    found = compare(answers, exercise.source.starter_code)
    pairs = "1 pair is" if len(found.pairs) == 1 else f"{len(found.pairs)} pairs are"
    print(f"{found.compared} answers to {exercise.stem} compared: {pairs} nearly the same.")
    for pair in found.pairs[:SHOWN]:
        print(f"  {pair.share:.0%}  {printable(pair.one)}  {printable(pair.other)}")
    if len(found.pairs) > SHOWN:
        print(f"  and {len(found.pairs) - SHOWN} more")
    left_out = (
        ("too short to compare", found.too_short),
        ("too long to compare", found.too_long),
        ("could not be read", unread),
    )
    for why, names in left_out:
        if names:
            terminal.say(f"Left out, {why}: {', '.join(map(printable, sorted(names)))}.")
    terminal.say("Names, comments, spaces, and lines of the starter do not count. " + HINT)
    return 0

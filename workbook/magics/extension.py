"""Define the magics of exercise notebooks.

They are %%answer, %start, %stop, %check, %hint, %review, %solution, %reset, %restore, and %progress.
"""

import os
import threading
from pathlib import Path

from IPython.core.interactiveshell import InteractiveShell
from IPython.core.magic import Magics, cell_magic, line_magic, magics_class
from IPython.display import Markdown, display

from workbook.exercise.answer_files import (
    Saved,
    answer_file,
    answers_folder,
    replace_answer,
    same_program,
    save_answer,
)
from workbook.exercise.answers import ANSWER_MAGIC, Answer, Ungradable, read_answer, syntax_mistake
from workbook.exercise.course import NoCourse
from workbook.exercise.definition import BrokenCriteria, Exercise, load_exercise
from workbook.exercise.source import STEM, SourceError, UnknownExercise, partner_of
from workbook.feedback import wording
from workbook.feedback.review import review_prompt
from workbook.grading.slots.pool import warm_slots
from workbook.lesson.best_answers import Check, NothingJudged, best_text, hands_in_another, restore_best
from workbook.lesson.progress import TRIES_BEFORE_SOLUTION, changed_progress, load_progress
from workbook.lesson.robot_in_cell import draws_robots
from workbook.magics import checking, screen
from workbook.magics.live_card import LiveCard
from workbook.magics.progress_table import progress_table
from workbook.magics.prompt import Prompt
from workbook.magics.running import Running

_EXPECTED = (Ungradable, UnknownExercise, NoCourse, BrokenCriteria, SourceError, NothingJudged, OSError)
CHECK_OPTION = "--check"


def shown_path(path: Path) -> str:
    """Return a path as the student knows it: relative to the work folder."""
    try:
        return str(path.relative_to(answers_folder().parent))
    except ValueError:
        return str(path)


_CLOCK_MISSING = (
    "{} waits for /clock, which nothing publishes, so its timers never fire.\n"
    "Remove the line that sets use_sim_time.\n"
)


class _Notice(Exception):
    """Raised to show the student a message instead of executing the command."""


@magics_class
class ExerciseMagics(Magics):
    """A kernel's magics. They keep track of the current exercise and of the running programs."""

    def __init__(self, shell: InteractiveShell | None) -> None:
        super().__init__(shell)
        self._stem: str | None = None
        self._running = Running()
        self._watcher: threading.Thread | None = None
        self._last: tuple[Answer, LiveCard] | None = None

    # --- which exercise -----------------------------------------------------------------------------------

    def _exercise(self, line: str) -> Exercise:
        name = line.strip() or self._stem or self._notebook_stem()
        if name is None:
            raise _Notice(
                f"Which exercise? Run its `{ANSWER_MAGIC}` cell first, or name it: `%check 09_joint_positions`."
            )
        exercise = load_exercise(name)
        self._stem = exercise.stem
        return exercise

    @staticmethod
    def _notebook_stem() -> str | None:
        name = Path(os.environ.get("JPY_SESSION_NAME", "")).stem
        return name if STEM.fullmatch(name) else None

    # --- the answer ---------------------------------------------------------------------------------------

    @cell_magic
    def answer(self, line: str, cell: str) -> None:
        """Save this cell as your answer to an exercise. The cell doesn't run here: %start and %check run it.

        `%%answer 09_joint_positions --check` also checks the answer.
        """
        self._report(self._answer, line, cell)

    def _answer(self, line: str, cell: str) -> None:
        words = line.split()
        line = " ".join(word for word in words if word != CHECK_OPTION)
        if not line:
            raise _Notice(
                f"Name the exercise in the first line, for example `{ANSWER_MAGIC} 09_joint_positions`."
            )
        exercise = self._exercise(line)
        saved = save_answer(exercise.stem, cell, exercise.source.starter_code)
        where = shown_path(saved.path)
        if saved.outcome == "refused":
            raise _Notice(self._kept_from_the_starter(saved, "this cell"))
        print(
            {
                "new": f"Saved as {where}.",
                "changed": f"Saved as {where}.",
                "unchanged": f"{where} is unchanged.",
            }[saved.outcome]
        )
        mistake = syntax_mistake(cell)
        if mistake is not None:
            caret = " " * (mistake.column - 1) + "^"
            print(
                f"It isn't valid Python yet: {mistake.message}, line {mistake.line} of the answer.\n"
                f"    {mistake.text}\n    {caret}"
            )
        elif CHECK_OPTION not in words:
            checking.warm_up()
        if CHECK_OPTION in words:
            self._judge(exercise, None)

    @staticmethod
    def _kept_from_the_starter(saved: Saved, cell: str) -> str:
        return (
            f"Your answer stays in {shown_path(saved.path)}: {cell} contains the starter again, and a starter never "
            f"replaces your work.\nTo load your answer into a cell, run `%load {saved.path}`. To start over, run "
            "`%reset`."
        )

    def _request(self) -> object:
        """Return the message that requested the running cell, or an empty dictionary outside of a kernel."""
        parent = getattr(self.shell, "get_parent", dict)
        return parent()

    def _take_screen(self, exercise: Exercise) -> screen.Version | None:
        """Save the answer cell's text from the screen, as running the cell would, and return None.

        If the front end doesn't send the screen's text, return the version that was run.
        """
        program = screen.answer_on_screen(self._request(), exercise.stem)
        if program is None:
            self._need_file(exercise.stem)
            return screen.version_that_ran(exercise.stem, self.shell.user_ns if self.shell else {})
        if not program.strip():
            raise _Notice("The answer cell is empty, so your answer file is unchanged.")
        saved = save_answer(exercise.stem, program, exercise.source.starter_code)
        if saved.outcome == "refused":
            raise _Notice(self._kept_from_the_starter(saved, "the answer cell"))
        if saved.outcome != "unchanged":
            print(f"Saved the current answer cell as {shown_path(saved.path)}.")
        return None

    @line_magic
    def reset(self, line: str) -> None:
        """Put the starter code back. Your current answer is kept in a file."""
        self._report(self._reset, line)

    def _reset(self, line: str) -> None:
        exercise = self._exercise(line)
        self._keep_what_is_on_the_screen(exercise)
        saved = replace_answer(exercise.stem, exercise.source.starter_code)
        screen.put_on_screen(self.shell, self._request(), exercise.stem, exercise.source.starter_code)
        print(f"{shown_path(saved.path)} contains the starter again.")
        if saved.previous is not None:
            print(f"Your answer is kept as {shown_path(saved.previous)}.")

    def _keep_what_is_on_the_screen(self, exercise: Exercise) -> None:
        """Save text on the screen that hasn't been run yet, before another text replaces it."""
        shown = screen.answer_on_screen(self._request(), exercise.stem)
        if shown is not None and shown.strip():
            save_answer(exercise.stem, shown, exercise.source.starter_code)

    @line_magic
    def restore(self, line: str) -> None:
        """Restore your best judged version. Your current version is kept in a file."""
        self._report(self._restore, line)

    def _restore(self, line: str) -> None:
        exercise = self._exercise(line)
        stem, file = exercise.stem, shown_path(answer_file(exercise.stem))
        shown = screen.answer_on_screen(self._request(), stem)
        if best_text(stem) is not None:
            self._keep_what_is_on_the_screen(exercise)
        if hands_in_another(stem) or best_text(stem) is None:
            saved = restore_best(stem)
            print(f"{file} is your best version again.")
            if saved.previous is not None:
                print(f"The previous version is kept as {shown_path(saved.previous)}.")
        else:
            print(f"{file} already is your best version.")
        best = best_text(stem) or ""
        if shown is None or not same_program(shown, best):
            screen.put_on_screen(self.shell, self._request(), stem, best)

    # --- running it next to the notebook ---------------------------------------------------------------------

    @line_magic
    def start(self, line: str) -> None:
        """Run your answer in its own process on this notebook's domain."""
        self._report(self._start, line)

    def _start(self, line: str) -> None:
        from workbook.criteria.vocabulary.known_errors import find_error
        from workbook.criteria.vocabulary.phrasing import nodes_are
        from workbook.lesson.startup import (
            node_names,
            wait_for_nodes,
            wait_until_it_serves,
            waiting_for_clock,
        )

        exercise = self._exercise(line)
        version = self._take_screen(exercise)
        if version is not None:
            print(version.line("Starting"))
        file = self._need_file(exercise.stem)
        answer = read_answer(file, exercise.stem)
        mistake = syntax_mistake(answer.text)
        if mistake is not None:
            raise _Notice(
                f"It isn't valid Python yet: {mistake.message}, line {mistake.line}: {mistake.text.strip()}"
            )
        self._running.stop(exercise.stem, told=False)
        around = self._start_partner(exercise)
        known = node_names()
        process = self._running.start(exercise.stem, file, exercise.driver)
        nodes = wait_for_nodes(process, known)
        if nodes:
            wait_until_it_serves(process, nodes[0])
        if process.is_running():
            if nodes:
                print(f"Running: {nodes_are(nodes)} in the graph. %stop ends the program.")
                if around:
                    print(f"The rest of the robot runs with it: {nodes_are(around).removesuffix(' is')}.")
                print(*map(_CLOCK_MISSING.format, waiting_for_clock(nodes)), sep="", end="")
            else:
                print("Running, but none of its nodes has appeared in the graph yet. %stop ends it.")
            self._running.show_robot(exercise.stem)
            screen.offer_panel(self.shell)
            return
        self._running.stop(exercise.stem)
        record = process.record()
        error = find_error(record.log, record.program)
        if error is not None:
            raise _Notice(
                f"Your program ended with {error.where}{error.error}\n{error.because}\n{error.try_this}"
            )
        how = record.signal or f"exit code {record.exit}"
        raise _Notice(f"Your program ended right away ({how}). Does it spin?\n{record.log.strip()}".rstrip())

    def _start_partner(self, exercise: Exercise) -> list[str]:
        """Start the exercise's partner nodes, if it has any, and return their names."""
        from workbook.lesson.startup import node_names, wait_for_nodes

        partner = partner_of(exercise.source.path)
        if partner is None:
            return []
        known = node_names()
        process = self._running.start_partner(exercise.stem, partner)
        nodes = wait_for_nodes(process, known)
        if not nodes:
            print(f"The rest of the robot did not start.\n{process.record().log.strip()}".rstrip())
        return nodes

    @line_magic
    def stop(self, line: str) -> None:
        """Stop the program that %start started, as Ctrl-C would."""
        self._report(self._stop, line)

    def _stop(self, line: str) -> None:
        stopped = self._running.stop_all() if not line.strip() else None
        if stopped is None:
            exercise = self._exercise(line)
            stopped = [exercise.stem] if self._running.stop(exercise.stem) is not None else []
        print(f"Stopped {', '.join(stopped)}." if stopped else "Nothing was running.")

    # --- judging it -------------------------------------------------------------------------------------------

    @line_magic
    def check(self, line: str) -> None:
        """Judge the answer on your screen by its behavior on the topics."""
        self._report(self._check, line)

    def _check(self, line: str) -> None:
        exercise = self._exercise(line)
        self._judge(exercise, self._take_screen(exercise))

    def _judge(self, exercise: Exercise, version: screen.Version | None) -> None:
        file = self._need_file(exercise.stem)
        answer = read_answer(file, exercise.stem)
        if self._last is not None and self._watcher is not None and self._watcher.is_alive():
            self._last[1].superseded.set()
            warm_slots.cancel_soak()
            self._watcher.join()
        kept = Check(exercise.stem, answer.text)
        hints_left = len(exercise.source.hints) - kept.before.hints
        shown = Path(shown_path(file))
        asked = checking.Asked(exercise, answer, shown, hints_left, version, kept, draws_robots())
        checking.warm_up()
        card = LiveCard(asked)
        self._last = (answer, card)
        self._watcher = threading.Thread(target=card.judge, name="check", daemon=True)
        self._watcher.start()
        try:
            while not card.decided.wait(0.1):
                pass
        except KeyboardInterrupt:
            card.abandoned.set()
            card.superseded.set()
            warm_slots.close()
            raise _Notice("Check stopped.") from None

    # --- help -------------------------------------------------------------------------------------------------

    @line_magic
    def hint(self, line: str) -> None:
        """Show the next of three hints, below the earlier ones: a nudge, then a pointer, then a sketch."""
        self._report(self._hint, line)

    def _hint(self, line: str) -> None:
        words = line.split()
        wanted = int(words.pop()) if words and words[-1].isdigit() else None
        exercise = self._exercise(" ".join(words))
        hints = exercise.source.hints
        progress = load_progress(exercise.stem)
        number = min(progress.hints + 1, len(hints)) if wanted is None else wanted
        if not 1 <= number <= len(hints):
            raise _Notice(f"There are {len(hints)} hints: %hint 1 to %hint {len(hints)}.")
        # Each hint is a separate paragraph, because Markdown needs that for lists and code.
        told = [
            part
            for one in range(1, number + 1)
            for part in (f"**Hint {one} of {len(hints)}.**", hints[one - 1])
        ]
        if wanted is None and progress.hints >= len(hints):
            told.append("There are no more hints.")
        with changed_progress(exercise.stem) as kept:
            kept.hints = max(kept.hints, number)
        display(Markdown("\n\n".join(told)))

    @line_magic
    def review(self, line: str) -> None:
        """Show a prompt for a colleague or an AI assistant: the task, your answer, and the judge's observations."""
        self._report(self._review, line)

    def _review(self, line: str) -> None:
        exercise = self._exercise(line)
        version = self._take_screen(exercise)
        answer = read_answer(self._need_file(exercise.stem), exercise.stem)
        if self._last is None or self._last[0].sha256 != answer.sha256 or self._last[1].judgement is None:
            self._judge(exercise, version)
        judgement = None if self._last is None else self._last[1].judgement
        if judgement is None:
            raise _Notice("Your answer could not be judged, so there is nothing to show a colleague yet.")
        done = wording.all_shown_hold(judgement)
        introduction = (
            "A prompt for a review of your program, for a colleague or an AI assistant."
            if done
            else "A prompt for a colleague or an AI assistant. It asks for help, not for the program."
        )
        display(Prompt(introduction, review_prompt(exercise.source, answer.text, judgement)))

    @line_magic
    def solution(self, line: str) -> None:
        """Show the reference answer, once your answer passes or after several judged tries."""
        self._report(self._solution, line)

    def _solution(self, line: str) -> None:
        exercise = self._exercise(line)
        if not exercise.source.has_solution:
            raise _Notice(
                "This edition of the course has no solutions, but your instructor has them. For help, use %hint."
            )
        progress = load_progress(exercise.stem)
        if not progress.may_see_solution:
            left = TRIES_BEFORE_SOLUTION - progress.tries
            raise _Notice(
                f"You can see the solution when your answer passes, or after {left} more "
                f"{'try' if left == 1 else 'tries'} with %check. Until then, use %hint."
            )
        source = exercise.source
        display(Markdown(f"```python\n{source.solution_code.rstrip()}\n```\n\n{source.alternatives}"))

    @line_magic
    def progress(self, line: str) -> None:
        """Show your progress: lessons read, predictions made, exercises solved."""
        self._report(lambda: display(progress_table()))

    # --- shared -----------------------------------------------------------------------------------------------

    @staticmethod
    def _need_file(stem: str) -> Path:
        file = answer_file(stem)
        if not file.is_file():
            raise _Notice(
                f"There is no {shown_path(file)} yet. Run the cell that begins with `{ANSWER_MAGIC} {stem}` first."
            )
        return file

    @staticmethod
    def _report(action: object, *arguments: str) -> None:
        """Run an action. Print an expected error as a sentence instead of a traceback."""
        assert callable(action)
        try:
            action(*arguments)
        except _Notice as notice:
            print(notice)
        except _EXPECTED as error:
            print(f"{error}")

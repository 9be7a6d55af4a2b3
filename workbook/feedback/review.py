"""Write a prompt for a colleague or an AI assistant, with the task, the answer, and the judge's observations."""

from workbook.exercise.judgement import Judgement
from workbook.exercise.source import ExerciseSource
from workbook.feedback import wording

_REVIEW = """Please review my answer to a ROS 2 (Jazzy, rclpy) exercise. It already behaves as asked, as measured
on the topics, so do not rewrite it. Tell me:
1. what a robotics engineer would praise,
2. the one change that would help a reader most, and why,
3. what could go wrong on a real robot that this exercise does not test,
4. one question about my own code, to check whether I understand it."""
_HELP = """Please help me with a ROS 2 (Jazzy, rclpy) exercise. My answer does not behave as asked yet; the
measurements are below. I want to find the mistake myself, so do not write the program, and do not write
corrected lines of it. Instead:
1. choose the one observation that I should look at first, and say why that one,
2. explain the ROS 2 concept that it is about, with an example that is not this task,
3. ask me one question about my own code that leads to the cause,
4. then wait for my reply. If you name an rclpy function, say how I can check that it exists in Jazzy."""


def review_prompt(source: ExerciseSource, answer_text: str, judgement: Judgement) -> str:
    """Return the prompt, ready to paste. Until the answer has full marks, ask for help that doesn't give it away.

    The prompt includes the observations and expectations, but not the likely cause, which the student should find.
    """
    done = wording.all_shown_hold(judgement)
    observed = [
        f"- {result.title}: {result.saw or result.status}"
        + ("" if result.status == "passed" or not result.expected else f" (expected: {result.expected})")
        for result in judgement.criteria
        if not result.hidden and (result.saw or not done)
    ]
    if judgement.reason:
        observed.append(f"- It could not be judged: {judgement.reason}")
    task = "\n\n".join(source.story)
    return f"""{_REVIEW if done else _HELP}

THE TASK
{task}

MY ANSWER
```python
{answer_text.rstrip()}
```

WHAT WAS OBSERVED WHEN IT RAN
{chr(10).join(observed)}
"""

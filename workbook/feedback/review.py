"""A ready prompt for a review of a full-marks answer by a colleague or an AI assistant."""

from workbook.exercise.judgement import Judgement
from workbook.exercise.source import ExerciseSource


def review_prompt(source: ExerciseSource, answer_text: str, judgement: Judgement) -> str:
    """The task, the answer and what was observed, as one text to paste."""
    observed = "\n".join(
        f"- {result.title}: {result.saw}" for result in judgement.criteria if not result.hidden and result.saw
    )
    task = "\n\n".join(source.story)
    return f"""Please review my answer to a ROS 2 (Jazzy, rclpy) exercise. It already behaves as asked, as measured
on the topics, so do not rewrite it. Tell me:
1. what a robotics engineer would praise,
2. the one change that would help a reader most, and why,
3. what could go wrong on a real robot that this exercise does not test,
4. one question about my own code, to check whether I understand it.

THE TASK
{task}

MY ANSWER
```python
{answer_text.rstrip()}
```

WHAT WAS OBSERVED WHEN IT RAN
{observed}
"""

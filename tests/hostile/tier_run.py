"""Judge answers in one tier, as the current user: `python -m tests.hostile.tier_run TIER SLOTS < jobs.json`.

`jobs.json` maps names to answers. The results are printed as JSON.
"""

import json
import sys
from functools import partial
from typing import Any

from workbook.exercise.answers import Answer
from workbook.exercise.retries import counting, judge_until_sure
from workbook.feedback.text import as_text
from workbook.grading.judges import Job
from workbook.grading.slots.scheduler import LocalSlots
from workbook.grading.tier_check import tier_problem
from workbook.isolation.tiers import named_tier

STEM = "09_joint_positions"


def main() -> None:
    tier = named_tier(sys.argv[1])
    jobs = [Job(name, STEM, Answer(text)) for name, text in json.load(sys.stdin).items()]
    told: dict[str, Any] = {"problem": tier_problem(tier), "judgements": {}}
    # The effects of a tier show before a program's real seconds, so these are skipped.
    judge = partial(LocalSlots(int(sys.argv[2]), tier).judge_all, soak=False)
    if told["problem"] is None:
        for job, tries in judge_until_sure(jobs, judge):
            judgement = counting(tries)
            recording = judgement.recording
            told["judgements"][job.key] = {
                "status": judgement.status,
                "score": judgement.score,
                "said": f"{judgement.reason}\n{as_text(judgement)}",
                "log": "" if recording is None else recording.process.log,
                "limits": [] if recording is None else recording.process.limits_hit,
            }
    json.dump(told, sys.stdout)


if __name__ == "__main__":
    main()

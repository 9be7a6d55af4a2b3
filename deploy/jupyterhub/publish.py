"""Publish each student's result pages: `python -m deploy.jupyterhub.publish grades published`.

`grades` is the folder that `workbook grade --format html` wrote. Students find their pages in their `feedback` folder.
"""

import argparse
from pathlib import Path

from workbook.grading.files import write_whole
from workbook.grading.pages import PAGES, page_name
from workbook.grading.results_file import RESULTS, last_results


def publish(grades: Path, published: Path) -> tuple[list[Path], list[str]]:
    """Copy each student's pages to the student's folder. Return the copies and the students without a folder."""
    copies, strangers = [], []
    for result in last_results(grades / RESULTS).values():
        page = grades / PAGES / page_name(result.student, result.exercise)
        folder = published / result.student
        if folder.parent != published or not folder.is_dir():
            strangers.append(result.student)
        elif page.is_file():
            copies.append(write_whole(folder / f"{result.exercise}.html", page.read_text(encoding="utf-8")))
    return copies, strangers


def main() -> None:
    """Parse the command line, publish the pages, and print a summary."""
    parser = argparse.ArgumentParser()
    parser.add_argument("grades", type=Path, help="the folder with results.jsonl and pages/")
    parser.add_argument("published", type=Path, help="the folder with one folder per student")
    asked = parser.parse_args()
    copies, strangers = publish(asked.grades, asked.published)
    print(f"published {len(copies)} pages")
    for student in strangers:
        print(f"{student} has never logged in here, so there is no folder to publish to")


if __name__ == "__main__":
    main()

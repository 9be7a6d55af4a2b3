"""Run the doctor from a cell."""

import subprocess
import sys

import pytest

from workbook.lesson import doctor


def test_the_report_is_short_where_all_is_well_and_full_where_it_is_not(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    report = (
        "✓ ok   Python          3.12.3 on Linux\n"
        "                       with a second line\n"
        "✗ fix  Two processes   nothing was heard in 15 s\n"
        "                       → Ask the firewall.\n"
        "✓ ok   Folders         12\n"
        "                       GB free\n"
        "\n"
        "1 to fix.\n"
    )
    script = f"import sys; sys.stdout.reconfigure(encoding='utf-8'); print({report!r}, end=''); sys.exit(1)"
    monkeypatch.setattr("workbook.lesson.doctor_report._DOCTOR", ("-c", script))
    assert doctor() is False
    assert capsys.readouterr().out.splitlines() == [
        "✓ ok   Python",
        "✗ fix  Two processes   nothing was heard in 15 s",
        "                       → Ask the firewall.",
        "✓ ok   Folders",
        "",
        "1 to fix.",
    ]


@pytest.mark.whole
def test_its_verdict_is_that_of_the_command(capsys: pytest.CaptureFixture[str]) -> None:
    command = [sys.executable, "-P", "-m", "workbook.cli.main", "doctor"]
    outside = subprocess.run(command, capture_output=True, check=False).returncode == 0
    assert doctor() is outside
    assert "Two processes" in capsys.readouterr().out

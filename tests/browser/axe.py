"""Check a page with axe, which finds barriers for people with impaired sight.

All its rules apply, with one exception.
"""

from typing import Any

from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import Page

# JupyterLab removes the editors of cells from the Tab order. Enter opens the active cell's editor, where the cursor
# keys scroll. But axe assumes that a keyboard can't reach a long line in such an editor.
UPSTREAM = {"scrollable-region-focusable": 'class="cm-scroller'}
"""Maps a rule to the text in an element for which the rule doesn't count."""
_axe = Axe()


def violations(page: Page, *within: str) -> list[str]:
    """Return each broken rule with the elements that break it.

    `within`: selectors; without any, check the whole page.
    """
    context: dict[str, Any] | None = {"include": [[selector] for selector in within]} if within else None
    found = _axe.run(page, context, {"resultTypes": ["violations"]}).response["violations"]
    return [
        f"{one['id']}: {node['html'][:200]}"
        for one in found
        for node in one["nodes"]
        if UPSTREAM.get(one["id"], node["html"] + " ") not in node["html"]
    ]

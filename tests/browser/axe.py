"""What axe finds wrong with a page, for people who cannot see it, or not well: all of its rules, and one exception."""

from typing import Any

from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import Page

# JupyterLab takes the editors of cells out of the order of the Tab key: Enter goes into the editor of the cell that is
# active, and there the cursor keys scroll. For axe, an editor with a long line is then out of a keyboard's reach.
UPSTREAM = {"scrollable-region-focusable": 'class="cm-scroller'}
"""Rule, and what must stand in an element for which it does not count."""
_axe = Axe()


def violations(page: Page, *within: str) -> list[str]:
    """Each rule that is broken, with the elements that break it. `within`: selectors; without any, the whole page."""
    context: dict[str, Any] | None = {"include": [[selector] for selector in within]} if within else None
    found = _axe.run(page, context, {"resultTypes": ["violations"]}).response["violations"]
    return [
        f"{one['id']}: {node['html'][:200]}"
        for one in found
        for node in one["nodes"]
        if UPSTREAM.get(one["id"], node["html"] + " ") not in node["html"]
    ]

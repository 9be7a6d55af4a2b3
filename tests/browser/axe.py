"""What axe finds wrong with a page, for people who cannot see it, or not well."""

from typing import Any

from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import Page

_axe = Axe()


def violations(page: Page, *within: str) -> list[str]:
    """Each rule that is broken, with the elements that break it. `within`: selectors; without any, the whole page."""
    context: dict[str, Any] | None = {"include": [[selector] for selector in within]} if within else None
    found = _axe.run(page, context, {"resultTypes": ["violations"]}).response["violations"]
    return [f"{one['id']}: {node['html'][:200]}" for one in found for node in one["nodes"]]

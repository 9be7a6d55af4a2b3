"""Turn links between repository files into links between pages of the site.

Most pages have the same path in the repository and on the site.
"""

import posixpath
import re
from dataclasses import dataclass

_CODE = re.compile(r"(```.*?```|~~~.*?~~~|`[^`\n]*`)", re.DOTALL)
_LINK = re.compile(r"(?P<picture>!?)\[(?P<text>(?:[^\[\]]|\[[^\]]*\])*)\]\((?P<target>[^)\s]+)\)")


@dataclass(frozen=True)
class Links:
    """Rewrites the links in one page.

    `page` is the page's path in the repository, and `pages` contains the paths of all pages on the site.

    `moved` maps the repository paths of moved files to their paths on the site.
    """

    page: str
    pages: frozenset[str]
    moved: dict[str, str]

    def in_page(self, text: str) -> str:
        """Rewrite a Markdown text's links to lead to the site's pages. Links to other files become plain text."""
        parts = _CODE.split(text)
        return "".join(part if at % 2 else _LINK.sub(self._link, part) for at, part in enumerate(parts))

    def _link(self, found: re.Match[str]) -> str:
        target, _, anchor = found["target"].partition("#")
        if "://" in target or not target:
            return found[0]
        here = posixpath.dirname(self.moved.get(self.page, self.page))
        there = posixpath.normpath(posixpath.join(posixpath.dirname(self.page), target))
        place = self.moved.get(there, there)
        if place not in self.pages:
            return found["text"]
        relative = posixpath.relpath(place, here or ".")
        return f"{found['picture']}[{found['text']}]({relative}{'#' + anchor if anchor else ''})"

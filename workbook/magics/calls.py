"""Keeps `stop()` Python: a kernel that doesn't know the function (yet) would run the magic of that name instead."""

from typing import Any

from IPython.core.prefilter import PrefilterChecker
from traitlets import Integer


class CallChecker(PrefilterChecker):
    """Lets a line begin with a call, although a magic has the same name. It asks before IPython's automagic does."""

    priority = Integer(650).tag(config=True)

    def check(self, line_info: Any) -> Any:
        """The handler of plain Python for such a line; None for any other."""
        manager: Any = self.prefilter_manager
        is_call = not line_info.esc and line_info.the_rest.startswith("(")
        return manager.get_handler_by_name("normal") if is_call else None

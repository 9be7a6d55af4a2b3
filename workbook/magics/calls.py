"""Run lines such as `stop()` as Python code, even before the function is defined.

Otherwise, IPython would run the magic of that name.
"""

from typing import Any

from IPython.core.prefilter import PrefilterChecker
from traitlets import Integer


class CallChecker(PrefilterChecker):
    """Lets a line begin with a call even if a magic has the function's name. It runs before IPython's automagic."""

    priority = Integer(650).tag(config=True)

    def check(self, line_info: Any) -> Any:
        """Return the handler for plain Python if the line begins with a call, or None otherwise."""
        manager: Any = self.prefilter_manager
        is_call = not line_info.esc and line_info.the_rest.startswith("(")
        return manager.get_handler_by_name("normal") if is_call else None

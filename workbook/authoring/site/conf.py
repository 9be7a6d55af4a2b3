"""The Sphinx configuration for the site. `make site` runs Sphinx with it on the sources that `sources.py` writes."""

from pathlib import Path

HERE = Path(__file__).parent
COLORS = {
    "light": {"color-brand-primary": "#1f5fa8", "color-brand-content": "#1f5fa8"},
    "dark": {"color-brand-primary": "#8cbcf5", "color-brand-content": "#8cbcf5"},
}

project = "rclpy workbook"
author = "the authors of the rclpy workbook"
extensions = ["myst_nb"]
exclude_patterns = ["_*"]
# No build date, so that the same sources give the same pages.
html_last_updated_fmt = None
html_show_sphinx = False
html_show_copyright = False
html_copy_source = False
html_show_sourcelink = False
html_theme = "furo"
html_title = "rclpy workbook"
html_static_path = ["_static"]
html_extra_path = ["_extra"]
html_css_files = ["site.css"]
html_js_files = [("site.js", {"type": "module"})]
html_favicon = "_static/robot.png"
html_theme_options = {
    "light_css_variables": COLORS["light"],
    "dark_css_variables": COLORS["dark"],
    "navigation_with_keys": False,
    "top_of_page_buttons": [],
}
pygments_style = "a11y-high-contrast-light"
pygments_dark_style = "a11y-high-contrast-dark"

nb_execution_mode = "off"
nb_merge_streams = True
nb_ipywidgets_js: dict[str, object] = {}
nb_render_text_lexer = "none"
myst_enable_extensions = ["colon_fence"]
myst_heading_anchors = 4
# Link only full URLs, not bare names that look like one, such as `README.md`.
myst_linkify_fuzzy_links = False
suppress_warnings = ["myst.header", "misc.highlighting_failure", "mystnb.unknown_mime_type"]
mathjax_path = "no-page-has-formulas.js"

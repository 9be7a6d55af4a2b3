"""IPython extension `workbook.magics`: what an exercise notebook uses. Loaded when a kernel starts."""

from typing import Any


def load_ipython_extension(shell: Any) -> None:
    """Register the magics and make ROS safe in this kernel."""
    from workbook.magics.extension import ExerciseMagics
    from workbook.magics.following import note_cell
    from workbook.ros.kernel import install

    install()
    shell.register_magics(ExerciseMagics)
    shell.events.register("post_run_cell", note_cell)

"""The IPython extension for exercise notebooks: %%answer, %start, %check, and the other magics.

Every kernel loads the extension at startup. Among the other packages, only `cli` imports anything from here: the
progress table.
"""

from typing import Any


def load_ipython_extension(shell: Any) -> None:
    """Register the magics, and set up this kernel for ROS, short tracebacks, and the record of cells that were run."""
    from workbook.lesson.activity import note_cell
    from workbook.magics import tracebacks
    from workbook.magics.calls import CallChecker
    from workbook.magics.extension import ExerciseMagics
    from workbook.ros.kernel import install

    install()
    tracebacks.install(shell)
    CallChecker(shell=shell, prefilter_manager=shell.prefilter_manager, parent=shell.prefilter_manager)
    shell.register_magics(ExerciseMagics)
    shell.events.register("post_run_cell", note_cell)

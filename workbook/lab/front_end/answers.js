// Sends with each cell that runs what the answer cells of its notebook hold at that moment, run or not, and puts an
// answer on the screen that the kernel has put back. Plain JavaScript, loaded by JupyterLab as it is: no build step.
// The other side is workbook/magics/screen.py.
(() => {
  const NAME = 'rclpy-workbook';
  const ANSWER_LINE = /^\s*%%answer[ \t]+([\w-]+)[^\n]*/;
  let shared = {};

  // A module of JupyterLab itself, of which there is one version.
  const moduleOf = async name => {
    const [version] = Object.values(shared[name] || {});
    if (!version) {
      throw new Error(`${NAME}: this JupyterLab has no ${name}`);
    }
    return (await version.get())();
  };

  // The answer cells of the notebook that a cell belongs to: [exercise, cell] from top to bottom.
  const answerCells = cell => {
    const notebook = cell.model.sharedModel.notebook;
    const code = notebook ? notebook.cells.filter(one => one.cell_type === 'code') : [];
    return code
      .map(one => [ANSWER_LINE.exec(one.getSource()), one])
      .filter(([line]) => line)
      .map(([line, one]) => [line[1], one]);
  };

  // Replaces the program below the first line of the exercise's last answer cell. Ctrl+Z in it takes that back.
  const show = (cell, {exercises, text}) => {
    const [, answer] = answerCells(cell).filter(([exercise]) => exercises.includes(exercise)).pop() || [];
    if (answer) {
      answer.setSource(`${ANSWER_LINE.exec(answer.getSource())[0]}\n${text}`);
    }
  };

  const activate = async () => {
    const {CodeCell} = await moduleOf('@jupyterlab/cells');
    const execute = CodeCell.execute;
    CodeCell.execute = async (cell, context, metadata) => {
      const answers = answerCells(cell).map(([, one]) => one.getSource());
      const more = answers.length ? {workbook: {answers}} : {};
      const reply = await execute.call(CodeCell, cell, context, {...metadata, ...more});
      for (const payload of (reply && reply.content.payload) || []) {
        if (payload.source === 'workbook_answer') {
          show(cell, payload);
        }
      }
      return reply;
    };
  };

  const plugin = {id: `${NAME}:answers`, autoStart: true, activate};
  window._JUPYTERLAB = window._JUPYTERLAB || {};
  window._JUPYTERLAB[NAME] = {
    init: scope => {
      shared = scope;
    },
    get: async () => () => ({__esModule: true, default: plugin})
  };
})();

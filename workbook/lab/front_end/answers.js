// With each cell that runs, sends the kernel the current text of the notebook's answer cells, whether or not they were
// run. It also tells the kernel whether this page draws the robots in cells. When the kernel restores an answer, this
// script updates the answer cell. When a program starts, it offers the robot panel.
// JupyterLab loads this plain JavaScript directly, so there's no build step.
// The kernel's side is workbook/magics/screen.py.
(() => {
  const NAME = 'rclpy-workbook';
  const OFFER = 'rclpy-workbook:offer-robot-panel'; // panel.js adds this command
  const ANSWER_LINE = /^\s*%%answer[ \t]+([\w-]+)[^\n]*/;
  const common = import(new URL('common.js', document.currentScript.src));
  let shared = {};

  // Return the answer cells in a cell's notebook as [exercise, cell], from top to bottom.
  const answerCells = cell => {
    const notebook = cell.model.sharedModel.notebook;
    const code = notebook ? notebook.cells.filter(one => one.cell_type === 'code') : [];
    return code
      .map(one => [ANSWER_LINE.exec(one.getSource()), one])
      .filter(([line]) => line)
      .map(([line, one]) => [line[1], one]);
  };

  // Replace the program below the first line of the exercise's last answer cell. Ctrl+Z in that cell undoes this.
  const show = (cell, {exercises, text}) => {
    const [, answer] = answerCells(cell).filter(([exercise]) => exercises.includes(exercise)).pop() || [];
    if (answer) {
      answer.setSource(`${ANSWER_LINE.exec(answer.getSource())[0]}\n${text}`);
    }
  };

  const activate = (app, CodeCell) => {
    const execute = CodeCell.execute;
    CodeCell.execute = async (cell, context, metadata) => {
      const answers = answerCells(cell).map(([, one]) => one.getSource());
      const more = answers.length ? {answers} : {};
      const workbook = {...(metadata && metadata.workbook), robot: app.commands.hasCommand(OFFER), ...more};
      const reply = await execute.call(CodeCell, cell, context, {...metadata, workbook});
      for (const payload of (reply && reply.content.payload) || []) {
        if (payload.source === 'workbook_answer') {
          show(cell, payload);
        } else if (payload.source === 'workbook_started' && app.commands.hasCommand(OFFER)) {
          app.commands.execute(OFFER);
        }
      }
      return reply;
    };
  };

  const plugin = ({CodeCell}) => ({id: `${NAME}:answers`, autoStart: true, activate: app => activate(app, CodeCell)});
  window._JUPYTERLAB = window._JUPYTERLAB || {};
  window._JUPYTERLAB[NAME] = {
    init: scope => {
      shared = scope;
    },
    get: async () => (await common).pluginWith(shared, ['@jupyterlab/cells'], plugin)
  };
})();

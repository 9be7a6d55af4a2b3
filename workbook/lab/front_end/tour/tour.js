// A one-minute tour in a card that doesn't cover the elements that it explains. It's shown once, next to the first
// notebook, and again from the Help menu and the home page. Steps whose targets aren't on the page are left out.
// JupyterLab loads this plain JavaScript directly, so there's no build step.
(() => {
  const NAME = 'rclpy-workbook-tour';
  const COMMAND = 'workbook:tour';
  const STYLE = new URL('tour.css', document.currentScript.src).href;
  const FOLLOW_EVERY_MS = 300;
  const BUTTON = name => `.jp-NotebookPanel:not(.lm-mod-hidden) [data-jp-item-name="${name}"]`;
  const RAN = 'workbook:code-cell-has-run'; // not a command, because a command can also run a text cell
  // Title, text, selector of the element to frame as soon as it's on the page, and what the reader does in this step:
  // one of these commands, which buttons, menus, and keys run, or RAN.
  const STEPS = [
    ['Run a cell', 'Click into a code cell, and press Shift+Enter or this button. A number in the brackets to the left of the cell shows that it has run.', BUTTON('run'), new RegExp(`^${RAN}$`)],
    ['Stop a cell', 'A cell that is still running shows [*]. This button stops it. All variables keep their values.', BUTTON('interrupt'), /^(notebook:interrupt-kernel|kernelmenu:interrupt)$/],
    ['Restart', "Does nothing make sense anymore? This button restarts Python and ends all of this notebook's robot programs. Your text is kept.", BUTTON('restart'), /^(notebook|kernelmenu):restart/],
    ['A terminal', 'File > New > Terminal. Type “workbook topic list” there to list the topics of the robot in your open notebook.', '.lm-MenuBar-item[data-command="filemenu"], .lm-MenuBar-item:first-child', /^terminal:create-new$/],
    ['The robot panel', 'This button shows the robot, its nodes, and its topics next to the notebook, and keeps them in view while you read on.', BUTTON('robot-panel'), /^rclpy-workbook:robot-panel$/],
    ['Home', 'Help > Workbook Home shows your progress and takes you back to where you left off. This tour is in the Help menu, too.', '.lm-MenuBar-item:last-child', /^workbook:home$/],
  ];
  const common = import(new URL('../../rclpy-workbook/static/common.js', document.currentScript.src));
  let shared = {};

  const element = (tag, className, text = '') => {
    const made = document.createElement(tag);
    made.className = className;
    made.textContent = text;
    return made;
  };

  const isThere = ([, , target]) => Boolean(document.querySelector(target)?.offsetWidth);

  // Resolve when a notebook with its buttons is on the page.
  const notebookIsThere = () =>
    new Promise(resolve => {
      const watch = new MutationObserver(() => look());
      const look = () => {
        if (isThere(STEPS[0])) {
          watch.disconnect();
          resolve();
        }
      };
      watch.observe(document.body, {subtree: true, childList: true, attributes: true, attributeFilter: ['class']});
      look();
    });

  class Tour {
    constructor(takesFocus) {
      this.steps = STEPS.filter(isThere);
      this.frame = element('div', 'wb-tour-frame');
      this.card = element('div', 'wb-tour');
      this.card.setAttribute('role', 'dialog');
      this.card.setAttribute('aria-label', 'One-minute tour');
      this.card.setAttribute('aria-live', 'polite'); // a step may come without a click
      // Update the frame regularly, because JupyterLab may move its buttons at any time.
      this.timer = setInterval(() => this.showFrame(), FOLLOW_EVERY_MS);
      this.card.addEventListener('keydown', event => {
        event.stopPropagation();
        if (event.key === 'Escape') {
          this.end();
        }
      });
      document.body.append(this.frame, this.card);
      this.show(0, takesFocus);
    }

    show(number, takesFocus = true) {
      this.number = number;
      const [title, text] = this.steps[number];
      const isLast = number === this.steps.length - 1;
      const next = element('button', 'wb-tour-next', isLast ? 'Done' : 'Next');
      const back = element('button', 'wb-tour-back', 'Back');
      const skip = element('button', 'wb-tour-skip', 'Skip the tour');
      next.onclick = () => (isLast ? this.end() : this.show(number + 1));
      back.onclick = () => this.show(number - 1);
      skip.onclick = () => this.end();
      const buttons = element('div', 'wb-tour-buttons');
      buttons.append(...(isLast ? [] : [skip]), ...(number ? [back] : []), next);
      this.card.replaceChildren(
        element('p', 'wb-tour-count', `${number + 1} of ${this.steps.length}`),
        element('h2', '', title),
        element('p', '', text),
        buttons
      );
      this.showFrame();
      if (takesFocus) {
        next.focus();
      }
    }

    showFrame() {
      const target = document.querySelector(this.steps[this.number][2]);
      const {left, top, width, height} = target ? target.getBoundingClientRect() : {};
      this.frame.hidden = !width;
      Object.assign(this.frame.style, {left: `${left - 4}px`, top: `${top - 4}px`, width: `${width + 8}px`, height: `${height + 8}px`});
    }

    // Show the next step once the reader has done what this one explains, such as once the cell has run. The focus stays
    // where the reader works. A command's result is false if it did nothing.
    async follow(id, result = Promise.resolve(true)) {
      const {number} = this;
      const isLast = number === this.steps.length - 1;
      if (this.steps[number][3].test(id) && (await result.catch(() => false)) !== false && this.number === number) {
        isLast ? this.end() : this.show(number + 1, false);
      }
    }

    end() {
      clearInterval(this.timer);
      this.card.remove();
      this.frame.remove();
    }
  }

  const plugin = ({ICommandPalette}, {IMainMenu}, {NotebookActions}, {ServerConnection}, {PageConfig, URLExt}) => ({
    id: `${NAME}:plugin`,
    autoStart: true,
    optional: [ICommandPalette, IMainMenu],
    activate: (app, palette, menu) => {
      const link = element('link', '');
      Object.assign(link, {rel: 'stylesheet', href: STYLE});
      document.head.append(link);
      let tour = null;
      const start = takesFocus => {
        if (tour) {
          tour.end();
        }
        tour = new Tour(takesFocus);
      };
      app.commands.commandExecuted.connect((_, {id, result}) => tour?.follow(id, result));
      NotebookActions.executed.connect((_, {cell}) => cell.model.type === 'code' && tour?.follow(RAN));
      app.commands.addCommand(COMMAND, {label: 'One-Minute Tour', execute: () => start(true)});
      if (palette) {
        palette.addItem({command: COMMAND, category: 'Workbook'});
      }
      if (menu) {
        menu.helpMenu.addGroup([{command: COMMAND}], 1);
      }
      const settings = ServerConnection.makeSettings();
      const address = URLExt.join(settings.baseUrl, 'workbook', 'tour');
      const onceOnly = async () => {
        const reply = await ServerConnection.makeRequest(address, {}, settings);
        if (reply.ok && !(await reply.json()).seen) {
          await notebookIsThere();
          await ServerConnection.makeRequest(address, {method: 'POST', body: '{}'}, settings);
          start(false);
        }
      };
      // Don't show the tour in a named workspace, because the reader has opened that workspace on purpose.
      if (PageConfig.getOption('workspace') === 'default') {
        app.restored.then(onceOnly).catch(() => undefined);
      }
    }
  });

  window._JUPYTERLAB = window._JUPYTERLAB || {};
  window._JUPYTERLAB[NAME] = {
    init: scope => {
      shared = scope;
    },
    get: async () => {
      const names = ['apputils', 'mainmenu', 'notebook', 'services', 'coreutils'].map(name => `@jupyterlab/${name}`);
      return (await common).pluginWith(shared, names, plugin);
    }
  };
})();

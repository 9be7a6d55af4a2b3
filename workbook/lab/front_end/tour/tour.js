// A tour of one minute, in a card that covers nothing that it explains: shown once, on the first start, and again from
// the Help menu and the home page. Plain JavaScript, loaded by JupyterLab as it is: no build step.
(() => {
  const NAME = 'rclpy-workbook-tour';
  const COMMAND = 'workbook:tour';
  const STYLE = new URL('tour.css', document.currentScript.src).href;
  const FOLLOW_EVERY_MS = 300;
  const BUTTON = name => `.jp-NotebookPanel:not(.lm-mod-hidden) [data-jp-item-name="${name}"]`;
  // Title, text, and what is framed meanwhile, as soon as it is there.
  const STEPS = [
    ['Run a cell', 'Click into a gray cell and press Shift+Enter, or this button. A number in the brackets beside it says that the cell has run.', BUTTON('run')],
    ['Stop a cell', 'A cell that runs on shows [*]. This button stops it; the notebook keeps what it knows.', BUTTON('interrupt')],
    ['Restart', 'Nothing makes sense any more? This button starts Python again, and ends the robot programs of this notebook. Your text stays.', BUTTON('restart')],
    ['A terminal', 'File > New > Terminal. Type “workbook topic list” there: it sees the robot of your open notebook.', '.lm-MenuBar-item[data-command="filemenu"], .lm-MenuBar-item:first-child'],
    ['The robot panel', 'This button shows the robot, its nodes and topics beside the notebook, and keeps them in sight while you read on.', BUTTON('robot-panel')],
    ['Home', 'Help > Workbook Home shows what you have read, predicted and solved, and takes you back to where you were. This tour is in the Help menu, too.', '.lm-MenuBar-item:last-child'],
  ];
  let shared = {};

  // A module of JupyterLab itself, of which there is one version.
  const moduleOf = async name => {
    const [version] = Object.values(shared[name] || {});
    if (!version) {
      throw new Error(`${NAME}: this JupyterLab has no ${name}`);
    }
    return (await version.get())();
  };

  const element = (tag, className, text = '') => {
    const made = document.createElement(tag);
    made.className = className;
    made.textContent = text;
    return made;
  };

  class Tour {
    constructor(takesFocus) {
      this.frame = element('div', 'wb-tour-frame');
      this.card = element('div', 'wb-tour');
      this.card.setAttribute('role', 'dialog');
      this.card.setAttribute('aria-label', 'One-minute tour');
      // JupyterLab moves its buttons when it likes.
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
      const [title, text] = STEPS[number];
      const isLast = number === STEPS.length - 1;
      const next = element('button', 'wb-tour-next', isLast ? 'Done' : 'Next');
      const back = element('button', 'wb-tour-back', 'Back');
      const skip = element('button', 'wb-tour-skip', 'Skip the tour');
      next.onclick = () => (isLast ? this.end() : this.show(number + 1));
      back.onclick = () => this.show(number - 1);
      skip.onclick = () => this.end();
      const buttons = element('div', 'wb-tour-buttons');
      buttons.append(...(isLast ? [] : [skip]), ...(number ? [back] : []), next);
      this.card.replaceChildren(
        element('p', 'wb-tour-count', `${number + 1} of ${STEPS.length}`),
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
      const target = document.querySelector(STEPS[this.number][2]);
      const {left, top, width, height} = target ? target.getBoundingClientRect() : {};
      this.frame.hidden = !width;
      Object.assign(this.frame.style, {left: `${left - 4}px`, top: `${top - 4}px`, width: `${width + 8}px`, height: `${height + 8}px`});
    }

    end() {
      clearInterval(this.timer);
      this.card.remove();
      this.frame.remove();
    }
  }

  const plugin = ({ICommandPalette}, {IMainMenu}, {ServerConnection}, {PageConfig, URLExt}) => ({
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
          await ServerConnection.makeRequest(address, {method: 'POST', body: '{}'}, settings);
          start(false);
        }
      };
      // Not in a workspace of its own name: somebody opened that on purpose.
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
      const names = ['apputils', 'mainmenu', 'services', 'coreutils'].map(name => `@jupyterlab/${name}`);
      const modules = await Promise.all(names.map(moduleOf));
      return () => ({__esModule: true, default: plugin(...modules)});
    }
  };
})();

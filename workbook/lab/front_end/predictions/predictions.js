// Shows a question's options as buttons below it, instead of the list and the line `predict("name")`. A click, or the
// letter's key, runs that line in the kernel with the choice. *Look inside* stays folded until the outcome is known.
// JupyterLab loads this plain JavaScript directly, so there's no build step.
// The kernel's side is workbook/lesson/front_end.py. The server's side, workbook/lab/home.py, returns earlier choices.
(() => {
  const NAME = 'rclpy-workbook-predictions';
  const STYLE = new URL('predictions.css', document.currentScript.src).href;
  const PAYLOAD = 'workbook_prediction';
  const LINE = /^(from workbook\.lesson import [\w, ]+\n+)?predict\(["']([\w-]+)["']\)\s*$/;
  const OPTION = /^- \*\*([a-z])\*\* (.+(?:\n {2}.+)*)/gm;
  const LOOK_INSIDE = /^## Look inside[ \t]*$/m;
  const NEW_SECTION = /^#{1,2} /;
  const SETTLE_MS = 100;
  const common = import(new URL('../../rclpy-workbook/static/common.js', document.currentScript.src));
  let shared = {};

  const element = (tag, className, ...children) => {
    const made = document.createElement(tag);
    made.className = className;
    made.append(...children);
    return made;
  };

  // Convert an option's text to nodes. Code is the only formatting that it keeps.
  const pieces = text =>
    text.replace(/\n +/g, ' ').split('`').map((part, at) => (at % 2 ? element('code', '', part) : part.replace(/\*\*/g, '')));

  const inWords = letters => `${letters.slice(0, -1).join(', ')} or ${letters.at(-1)}`;
  const sourceOf = cell => cell.model.sharedModel.getSource();

  // One question's options, shown in the cell with its `predict` line.
  class Question {
    constructor(cell, asking, name, options, choose) {
      Object.assign(this, {cell, asking, name, options, choose, letters: options.map(([letter]) => letter)});
      this.buttons = Object.fromEntries(options.map(option => [option[0], this.button(option)]));
      this.words = element('p', 'wb-options-words');
      this.words.setAttribute('role', 'status');
      this.group = element('div', 'wb-options', ...Object.values(this.buttons), this.words);
      this.group.setAttribute('role', 'group');
      this.group.setAttribute('aria-label', 'Your prediction');
      this.pressed = this.pressed.bind(this);
      this.focused = this.focused.bind(this);
      cell.node.addEventListener('keydown', this.pressed);
      cell.node.addEventListener('focus', this.focused);
      cell.node.classList.add('wb-asks');
      cell.node.append(this.group);
      asking.node.classList.add('wb-asked');
      this.show({});
    }

    button([letter, text]) {
      const mark = element('span', 'wb-option-mark');
      const button = element('button', 'wb-option', element('kbd', '', letter), element('span', '', ...pieces(text)), mark);
      button.type = 'button';
      button.addEventListener('click', () => this.choose(this, letter));
      return button;
    }

    // A single key chooses. The notebook still handles the cursor keys, Shift+Enter, and Escape.
    pressed(event) {
      const isOurs = event.target === this.cell.node || this.group.contains(event.target);
      if (!isOurs || event.ctrlKey || event.metaKey || event.altKey || event.shiftKey) {
        return;
      }
      const isClick = (event.key === 'Enter' || event.key === ' ') && event.target.matches('button');
      const button = this.buttons[event.key];
      if (button) {
        event.preventDefault();
        button.focus();
        this.choose(this, event.key);
      }
      if (button || isClick) {
        event.stopPropagation();
      }
    }

    // When the keyboard moves the focus to the cell, pass it on to the options.
    focused(event) {
      if (event.target === this.cell.node && !this.group.contains(event.relatedTarget)) {
        (this.buttons[this.choice] || this.buttons[this.letters[0]]).focus({preventScroll: true});
      }
    }

    show({choice = null, words = '', outcome = null}) {
      Object.assign(this, {choice, outcome});
      for (const [letter, button] of Object.entries(this.buttons)) {
        const marks = [...(letter === choice ? ['your prediction'] : []), ...(letter === outcome ? ['✓ outcome'] : [])];
        button.setAttribute('aria-pressed', letter === choice);
        button.classList.toggle('wb-outcome', letter === outcome);
        button.classList.toggle('wb-other', outcome !== null && letter !== outcome && letter !== choice);
        button.lastChild.textContent = marks.join(', ');
      }
      const hint = choice === null ? `Choose ${inWords(this.letters)}: click it, or press its key.` : `Your prediction: ${choice}.`;
      this.words.textContent = words || hint;
    }

    say(words) {
      this.words.textContent = words;
    }

    fits(asking, name, options) {
      return this.asking === asking && this.name === name && this.options.join() === options.join();
    }

    end() {
      this.group.remove();
      this.cell.node.removeEventListener('keydown', this.pressed);
      this.cell.node.removeEventListener('focus', this.focused);
      this.cell.node.classList.remove('wb-asks');
      this.asking.node.classList.remove('wb-asked');
    }
  }

  // A section that stays folded until the outcome before it is known, or until the reader enters it.
  class Fold {
    constructor(heading, cells, open) {
      Object.assign(this, {heading, cells});
      const button = element('button', '', 'Open now');
      button.type = 'button';
      button.addEventListener('click', open);
      button.addEventListener('keydown', event => event.key === 'Enter' && event.stopPropagation());
      this.note = element('p', 'wb-fold-note', 'This section opens after you have made a prediction and seen the outcome. ', button);
      heading.node.classList.add('wb-folded');
      heading.node.append(this.note);
      cells.forEach(cell => cell.node.classList.add('wb-in-fold'));
    }

    end() {
      this.note.remove();
      this.heading.node.classList.remove('wb-folded');
      this.cells.forEach(cell => cell.node.classList.remove('wb-in-fold'));
    }
  }

  // The questions of one notebook.
  class Lesson {
    constructor(panel, ask, execute) {
      Object.assign(this, {panel, notebook: panel.content, execute});
      this.questions = new Map(); // keyed by cell
      this.folds = new Map(); // keyed by heading
      this.opened = new WeakSet(); // headings that the reader has unfolded
      this.known = {choices: {}, outcomes: {}};
      this.imported = new Set();
      const stem = panel.context.localPath.split('/').pop().replace(/\.ipynb$/, '');
      // If the server doesn't respond, assume that nothing was chosen. The kernel still has the choices.
      ask(stem).then(known => {
        this.known = known;
        this.questions.forEach(question => this.restore(question));
        this.look();
      }, () => undefined);
      const later = () => {
        clearTimeout(this.timer);
        this.timer = setTimeout(() => this.look(), SETTLE_MS);
      };
      this.notebook.model?.cells.changed.connect(later);
      this.notebook.model?.contentChanged.connect(later);
      this.notebook.activeCellChanged.connect((_, cell) => this.enter(cell));
      panel.sessionContext.kernelChanged.connect(() => this.imported.clear());
      panel.sessionContext.statusChanged.connect((_, status) => /restarting/.test(status) && this.imported.clear());
      panel.disposed.connect(() => clearTimeout(this.timer));
      this.look();
    }

    // Find the questions and folds in the notebook's current state.
    look() {
      if (this.notebook.isDisposed) {
        return;
      }
      const questions = new Map();
      const folds = new Map();
      let [latest, fold] = [null, null];
      this.notebook.widgets.forEach((cell, at, cells) => {
        const source = sourceOf(cell);
        if (cell.model.type === 'markdown') {
          const starts = LOOK_INSIDE.test(source) && source.startsWith('## ');
          if (NEW_SECTION.test(source) || [...source.matchAll(OPTION)].length > 1) {
            fold = null;
          }
          if (starts && latest && !latest.outcome && !this.opened.has(cell)) {
            fold = [];
            folds.set(cell, fold);
            return;
          }
        }
        const line = cell.model.type === 'code' && LINE.exec(source);
        const asking = cells[at - 1];
        if (line && asking?.model.type === 'markdown') {
          const options = [...sourceOf(asking).matchAll(OPTION)].map(([, letter, text]) => [letter, text]);
          if (options.length > 1) {
            fold = null;
            latest = this.question(cell, asking, line, options);
            questions.set(cell, latest);
          }
        }
        fold?.push(cell);
      });
      this.questions.forEach((question, cell) => questions.get(cell) === question || question.end());
      this.questions = questions;
      const isIn = [...folds].find(([, cells]) => cells.includes(this.notebook.activeCell));
      if (isIn) {
        this.opened.add(isIn[0]);
        folds.delete(isIn[0]);
      }
      this.foldAs(folds);
    }

    question(cell, asking, [, imports], options) {
      const name = LINE.exec(sourceOf(cell))[2];
      const before = this.questions.get(cell);
      if (before?.fits(asking, name, options)) {
        return before;
      }
      const made = new Question(cell, asking, name, options, (one, letter) => this.choose(one, letter));
      made.imports = imports;
      this.restore(made);
      return made;
    }

    restore(question) {
      const {choices, outcomes} = this.known;
      if (question.choice === null && choices[question.name]) {
        question.show({choice: choices[question.name], outcome: outcomes[question.name] ?? null});
      }
    }

    foldAs(wanted) {
      this.folds.forEach((fold, heading) => {
        const cells = wanted.get(heading);
        if (cells?.length === fold.cells.length && cells.every((cell, at) => cell === fold.cells[at])) {
          wanted.delete(heading);
        } else {
          fold.end();
          this.folds.delete(heading);
        }
      });
      wanted.forEach((cells, heading) => this.folds.set(heading, new Fold(heading, cells, () => this.open(heading))));
    }

    open(heading) {
      this.opened.add(heading);
      this.look();
    }

    // Unfold the section that the reader enters with the keyboard, a search, or the table of contents.
    enter(cell) {
      const found = [...this.folds].find(([, fold]) => fold.cells.includes(cell));
      if (found) {
        this.open(found[0]);
      }
    }

    async choose(question, letter) {
      const {choice, outcome} = question;
      if (outcome === null) {
        question.show({choice: letter, words: `Your prediction: ${letter} …`});
      }
      const {sessionContext} = this.panel;
      await sessionContext.ready;
      if (!sessionContext.session?.kernel) {
        question.show({choice, outcome, words: "Not saved, because the kernel isn't running. Restart it (⟳), and then choose again."});
        return;
      }
      const prediction = {name: question.name, choice: letter};
      const reply = await this.execute(question.cell, sessionContext, {workbook: {prediction}}).catch(() => null);
      if (reply?.content.status !== 'ok') {
        question.show({choice, outcome, words: 'Not saved, because the kernel was interrupted. Choose again.'});
      }
    }

    // Return the metadata for a cell that runs, which tells the kernel which question is drawn here. The `predict` line
    // is hidden, so it may not have run yet. In that case, run its imports first, because the cells below need them.
    before(cell, metadata) {
      const question = this.questions.get(cell);
      if (question) {
        this.imported.add(cell);
        return {...metadata, workbook: {prediction: {name: question.name}, ...metadata?.workbook}};
      }
      const place = this.notebook.widgets.indexOf(cell);
      const kernel = this.panel.sessionContext.session?.kernel;
      this.questions.forEach((above, own) => {
        if (above.imports && kernel && !this.imported.has(own) && this.notebook.widgets.indexOf(own) < place) {
          this.imported.add(own);
          kernel.requestExecute({code: above.imports, silent: true, store_history: false, stop_on_error: false}, true);
        }
      });
      return metadata;
    }

    // Show the kernel's reply to a prediction.
    take({name, choice, words, outcome}) {
      this.known.choices[name] = choice;
      if (outcome) {
        this.known.outcomes[name] = outcome;
      }
      this.questions.forEach(question => question.name === name && question.show({choice, words, outcome}));
      this.look();
    }
  }

  const plugin = ({INotebookTracker}, {CodeCell}, {ServerConnection}, {URLExt}) => ({
    id: `${NAME}:plugin`,
    autoStart: true,
    requires: [INotebookTracker],
    activate: (app, tracker) => {
      const link = element('link', '');
      Object.assign(link, {rel: 'stylesheet', href: STYLE});
      document.head.append(link);
      const settings = ServerConnection.makeSettings();
      const ask = async stem => {
        const address = URLExt.join(settings.baseUrl, 'workbook', 'predictions');
        const reply = await ServerConnection.makeRequest(`${address}?lesson=${encodeURIComponent(stem)}`, {}, settings);
        return reply.ok ? reply.json() : Promise.reject(reply.statusText);
      };
      const lessons = new Map();
      const execute = CodeCell.execute;
      CodeCell.execute = async (cell, context, metadata) => {
        const lesson = [...lessons.values()].find(one => one.notebook.widgets.includes(cell));
        const reply = await execute.call(CodeCell, cell, context, lesson ? lesson.before(cell, metadata) : metadata);
        for (const payload of (lesson && reply?.content.payload) || []) {
          if (payload.source === PAYLOAD) {
            lesson.take(payload);
          }
        }
        return reply;
      };
      tracker.widgetAdded.connect(async (_, panel) => {
        await panel.context.ready;
        if (!panel.isDisposed) {
          lessons.set(panel, new Lesson(panel, ask, (...all) => CodeCell.execute(...all)));
          panel.disposed.connect(() => lessons.delete(panel));
        }
      });
    }
  });

  window._JUPYTERLAB = window._JUPYTERLAB || {};
  window._JUPYTERLAB[NAME] = {
    init: scope => {
      shared = scope;
    },
    get: async () => {
      const names = ['notebook', 'cells', 'services', 'coreutils'].map(name => `@jupyterlab/${name}`);
      return (await common).pluginWith(shared, names, plugin);
    }
  };
})();

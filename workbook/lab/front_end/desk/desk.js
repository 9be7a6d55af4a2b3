// Prepares lessons in JupyterLab: their style (desk.css), the room for them, and names. A tab names its lesson and
// marks exercises, an editor names its cell, and a slider names its parameter. Films get a player (film.js), and a
// robot waves when a lesson opens.
// JupyterLab loads this plain JavaScript directly, so there's no build step.
(() => {
  const NAME = 'rclpy-workbook-desk';
  const STYLE = new URL('desk.css', document.currentScript.src).href;
  const player = import(new URL('film.js', document.currentScript.src));
  const ROBOTS = new URL('../../rclpy-workbook-panel/static/robots.js', document.currentScript.src);
  const LIST = '.jp-RenderedMarkdown > h1 ~ ul'; // the lesson's minutes, prerequisites, and goals
  const PICTURE = '.jp-OutputArea-output img';
  const ROBOT = 'img[alt^="a humanoid robot"], .workbook-cell-robot';
  const NO_MODEL = 'Error displaying widget: model not found';
  const EDITOR = '.cm-content';
  const FOLD = '.jp-collapseHeadingButton';
  const SLIDER = '.widget-slider';
  const WIDE = '(min-width: 1100px)';
  const ROOMY = '(min-width: 1500px)'; // enough room for the file browser, a lesson, and the robot panel
  const NUMBERED = /^(\d\d)_\w+?(_deeper)?\.ipynb$/;
  const TITLE = /^# (?:Exercise )?\d\d · (?:Deeper: )?(.+)/;
  const FILE_NAME = '.jp-DirListing-itemText';
  const running = new Set();
  const watches = new WeakMap();
  const common = import(new URL('../../rclpy-workbook/static/common.js', document.currentScript.src));
  let shared = {};

  // Return the elements that match a selector, among these nodes and their descendants.
  const within = (nodes, selector) =>
    nodes
      .filter(node => node.nodeType === Node.ELEMENT_NODE)
      .flatMap(node => [...(node.matches(selector) ? [node] : []), ...node.querySelectorAll(selector)]);

  // Next to the panel, a tab has room only for a number, so desk.css shows a number instead of the file name. The label
  // itself must stay, because JupyterLab would assume that a changed label means a renamed file.
  const markTab = ({context, title}) => {
    const [name, folder] = context.localPath.split('/').reverse();
    const workbook = folder === 'exercises' ? 'exercise' : 'lesson';
    const [, number, deeper] = NUMBERED.exec(name) || [];
    const short = number && `${number}${deeper ? ' +' : ''}${workbook === 'exercise' ? ' ✎' : ''}`;
    title.dataset = {...title.dataset, workbook, ...(short ? {number: short} : {})};
  };

  // Return what a tab's number and sign mean, as in "Exercise 09: The joint positions". Empty if the notebook's first
  // line isn't a numbered title.
  const meaning = ({context: {localPath}, content}) => {
    const [name, folder] = localPath.split('/').reverse();
    const [, number, deeper] = NUMBERED.exec(name) || [];
    const first = content.model?.cells.get(0)?.sharedModel.getSource() || '';
    const [, words] = (number && TITLE.exec(first)) || [];
    const kind = folder === 'exercises' ? 'Exercise' : deeper ? 'Deeper part of lesson' : 'Lesson';
    return words ? `${kind} ${number}: ${words}` : '';
  };

  // Begin the tab's tooltip with these words. JupyterLab writes the tooltip again whenever it saves the notebook.
  const explainTab = panel => {
    const explain = () => {
      const [words, {title}] = [meaning(panel), panel];
      if (words && !title.caption.startsWith(words)) {
        title.caption = `${words}\n${title.caption}`;
      }
    };
    panel.title.changed.connect(explain);
    panel.context.ready.then(explain);
  };

  // JupyterLab sorts an underscore before a dot, so "01_the_context_deeper" would come before "01_the_context".
  const sortDeeperAfter = ({DirListing}) => {
    const {sort} = DirListing.prototype;
    DirListing.prototype.sort = function (state) {
      sort.call(this, state);
      const items = this._sortedItems;
      if (!Array.isArray(items) || state?.key !== 'name' || state.direction === 'descending') {
        return;
      }
      for (let at = 1; at < items.length; at++) {
        if (items[at - 1].name === items[at].name.replace('.ipynb', '_deeper.ipynb')) {
          [items[at - 1], items[at]] = [items[at], items[at - 1]];
        }
      }
    };
  };

  // JupyterLab's editors have no accessible names, so name them "Code cell 3" and so on, counting each kind separately.
  // The notebook has the ARIA role "feed", which requires its cells to be articles.
  const nameCells = notebook => {
    const counts = {};
    for (const cell of notebook.widgets) {
      const kind = cell.model.type === 'code' ? 'Code cell' : cell.model.type === 'markdown' ? 'Text cell' : 'Raw cell';
      counts[kind] = (counts[kind] || 0) + 1;
      cell.node.setAttribute('role', 'article');
      cell.node.querySelector(EDITOR)?.setAttribute('aria-label', `${kind} ${counts[kind]}`);
    }
  };

  // Use the label next to a slider as the accessible name of its handle and its number.
  const nameSlider = slider => {
    const name = slider.querySelector('.widget-label')?.textContent || 'Slider';
    slider.querySelectorAll('[role=slider], .widget-readout').forEach(one => one.setAttribute('aria-label', name));
    slider.querySelector('.widget-readout')?.setAttribute('role', 'textbox');
  };

  // Name the arrow in front of a heading, because JupyterLab doesn't.
  const nameFold = button => button.setAttribute('aria-label', 'Fold or unfold this section');

  // Replace a button or slider whose kernel has exited with its text, which says what to do.
  const showText = (notebook, place) => {
    const cell = notebook.widgets.find(one => one.outputArea?.node.contains(place));
    const at = cell ? cell.outputArea.widgets.findIndex(one => one.node.contains(place)) : -1;
    const text = at < 0 ? undefined : cell.outputArea.model.get(at)?.data['text/plain'];
    if (text) {
      place.textContent = [text].flat().join('');
      place.classList.add('wb-widget-text');
    }
  };

  const playFilms = async pictures => {
    const {Film, isFilm} = await player;
    pictures.filter(picture => !picture.closest('.wb-film') && isFilm(picture)).forEach(picture => new Film(picture));
  };

  // Create a robot that waves when it first comes into view. Its space is reserved before it has loaded.
  const makeGreeter = () => {
    const place = document.createElement('div');
    place.className = 'wb-greeter';
    const greet = ({Greeter}) => {
      const greeter = new Greeter();
      greeter.take({text: 'a robot that waves to you'});
      place.append(greeter.node);
      const seen = (entries, sight) => {
        if (entries.some(one => one.isIntersecting)) {
          sight.disconnect();
          greeter.wave();
        }
      };
      new IntersectionObserver(seen).observe(place);
    };
    import(ROBOTS).then(greet, () => undefined);
    return place;
  };

  // Return whether a lesson opens with the waving robot. Lesson 00 opens with one that a program moves.
  const isGreeted = ({context}) => {
    const [name, folder] = context.localPath.split('/').reverse();
    return NUMBERED.test(name) && folder !== 'exercises' && !name.startsWith('00');
  };

  // Watch the notebook, because JupyterLab may add cells and outputs to the page at any time.
  const watchNotebook = (notebook, greeted) => {
    let greeter = null;
    const greet = nodes => {
      const list = greeted && within(nodes, LIST).find(one => notebook.widgets[0]?.node.contains(one));
      if (list) {
        greeter ||= makeGreeter();
        list.before(greeter);
      }
    };
    const watch = new MutationObserver(changes => {
      const added = changes.flatMap(change => [...change.addedNodes]);
      const removed = changes.flatMap(change => [...change.removedNodes]);
      added.filter(node => node.data === NO_MODEL && node.parentElement).forEach(node => showText(notebook, node.parentElement));
      within(added, SLIDER).forEach(nameSlider);
      within(added, FOLD).forEach(nameFold);
      playFilms(within(added, PICTURE));
      greet(added);
      if (within([...added, ...removed], EDITOR).length) {
        nameCells(notebook);
      }
    });
    watch.observe(notebook.node, {subtree: true, childList: true});
    notebook.disposed.connect(() => watch.disconnect());
    nameCells(notebook);
    within([notebook.node], FOLD).forEach(nameFold);
    greet([notebook.node]);
  };

  // Let long file names wrap after an underscore, by inserting a zero-width space there.
  const breakNames = browser => {
    const texts = nodes =>
      within(nodes, FILE_NAME).flatMap(one => {
        const walker = document.createTreeWalker(one, NodeFilter.SHOW_TEXT);
        const found = [];
        while (walker.nextNode()) {
          found.push(walker.currentNode);
        }
        return found;
      });
    const mark = nodes =>
      texts(nodes).forEach(text => {
        const marked = text.data.replace(/_(?!\u200b)/g, '_\u200b');
        if (marked !== text.data) {
          text.data = marked;
        }
      });
    // When a row changes to another file's name, its elements stay, so the change's target is the text node.
    const elementOf = node => (node.nodeType === Node.TEXT_NODE ? node.parentElement : node);
    const changed = ({target}) => elementOf(target)?.closest(FILE_NAME) || target;
    new MutationObserver(changes => mark(changes.map(changed))).observe(
      browser.node, {subtree: true, childList: true, characterData: true}
    );
    mark([browser.node]);
  };

  // JupyterLab reads the file browser's minimum width (desk.css) only once. So have it read the width again when the
  // style has loaded, and when the window becomes narrow or wide.
  const addStyle = app => {
    const link = document.createElement('link');
    Object.assign(link, {rel: 'stylesheet', href: STYLE});
    const loaded = new Promise(resolve => (link.onload = resolve));
    document.head.append(link);
    const find = (widget, id) =>
      widget.id === id ? widget : [...(widget.layout || [])].map(one => find(one, id)).find(Boolean);
    const wide = window.matchMedia(WIDE);
    const fit = () => find(app.shell, 'jp-left-stack').fit();
    // When the window becomes narrow, shrink the file browser as soon as its new minimum width is in effect.
    const giveRoom = () => {
      const split = find(app.shell, 'jp-main-split-panel');
      const [, ...others] = split.relativeSizes();
      split.setRelativeSizes([0, ...others]);
    };
    wide.addEventListener('change', () => {
      fit();
      if (!wide.matches) {
        requestAnimationFrame(() => requestAnimationFrame(giveRoom));
      }
    });
    Promise.all([loaded, app.restored]).then(fit);
    app.restored.then(() => breakNames(find(app.shell, 'filebrowser')));
  };

  // If only one cell is running and it draws a robot, scroll the whole robot into view, once per run.
  const showRobot = cell => {
    const outputs = cell.outputArea;
    if (!outputs || running.has(cell)) {
      return;
    }
    running.add(cell);
    const watch = new MutationObserver(() => {
      const picture = outputs.node.querySelector(ROBOT);
      if (picture && picture.complete !== false && picture.offsetHeight) {
        watch.disconnect();
        if (running.size === 1) {
          picture.scrollIntoView({block: 'nearest'});
        }
      }
    });
    watch.observe(outputs.node, {subtree: true, childList: true, attributes: true});
    watches.set(cell, watch);
  };

  const ended = cell => {
    running.delete(cell);
    watches.get(cell)?.disconnect();
  };

  const plugin = ({INotebookTracker, NotebookActions}, files) => ({
    id: `${NAME}:plugin`,
    autoStart: true,
    requires: [INotebookTracker],
    activate: (app, tracker) => {
      addStyle(app);
      sortDeeperAfter(files);
      NotebookActions.executionScheduled.connect((_, {cell}) => showRobot(cell));
      NotebookActions.executed.connect((_, {cell}) => ended(cell));
      tracker.widgetAdded.connect((_, panel) => {
        markTab(panel);
        explainTab(panel);
        if (!window.matchMedia(ROOMY).matches) {
          app.restored.then(() => app.shell.collapseLeft());
        }
        watchNotebook(panel.content, isGreeted(panel));
        panel.context.pathChanged.connect(() => markTab(panel));
      });
    }
  });

  window._JUPYTERLAB = window._JUPYTERLAB || {};
  window._JUPYTERLAB[NAME] = {
    init: scope => {
      shared = scope;
    },
    get: async () => (await common).pluginWith(shared, ['@jupyterlab/notebook', '@jupyterlab/filebrowser'], plugin)
  };
})();

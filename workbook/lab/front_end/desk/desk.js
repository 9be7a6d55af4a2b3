// How a lesson looks in JupyterLab (desk.css), and names: the tab of an exercise says that it is one, each editor which
// cell it is, each slider what it turns. Plain JavaScript, loaded by JupyterLab as it is: no build step.
(() => {
  const NAME = 'rclpy-workbook-desk';
  const STYLE = new URL('desk.css', document.currentScript.src).href;
  const ROBOT = 'img[alt^="a humanoid robot"]';
  const NO_MODEL = 'Error displaying widget: model not found';
  const EDITOR = '.cm-content';
  const FOLD = '.jp-collapseHeadingButton';
  const SLIDER = '.widget-slider';
  const WIDE = '(min-width: 1100px)';
  const FILE_NAME = '.jp-DirListing-itemText';
  const running = new Set();
  const watches = new WeakMap();
  let shared = {};

  // A module of JupyterLab itself, of which there is one version.
  const moduleOf = async name => {
    const [version] = Object.values(shared[name] || {});
    if (!version) {
      throw new Error(`${NAME}: this JupyterLab has no ${name}`);
    }
    return (await version.get())();
  };

  // Those of these nodes, and of what is in them, that fit a selector.
  const within = (nodes, selector) =>
    nodes
      .filter(node => node.nodeType === Node.ELEMENT_NODE)
      .flatMap(node => [...(node.matches(selector) ? [node] : []), ...node.querySelectorAll(selector)]);

  // A lesson and its exercise have the same file name: desk.css puts a word before that of the exercise. (The label
  // itself stays: JupyterLab would take another one for a new name of the file.)
  const markTab = ({context, title}) => {
    const isExercise = /(^|\/)exercises\/[^/]+$/.test(context.localPath);
    title.dataset = {...title.dataset, workbook: isExercise ? 'exercise' : 'lesson'};
  };

  // JupyterLab's editors have no name. A screen reader says "Code cell 3", counted among the cells of its kind. And the
  // cells are the articles that the notebook, a feed, must have.
  const nameCells = notebook => {
    const counts = {};
    for (const cell of notebook.widgets) {
      const kind = cell.model.type === 'code' ? 'Code cell' : cell.model.type === 'markdown' ? 'Text cell' : 'Raw cell';
      counts[kind] = (counts[kind] || 0) + 1;
      cell.node.setAttribute('role', 'article');
      cell.node.querySelector(EDITOR)?.setAttribute('aria-label', `${kind} ${counts[kind]}`);
    }
  };

  // The words beside a slider are the name of its handle and of its number.
  const nameSlider = slider => {
    const name = slider.querySelector('.widget-label')?.textContent || 'Slider';
    slider.querySelectorAll('[role=slider], .widget-readout').forEach(one => one.setAttribute('aria-label', name));
    slider.querySelector('.widget-readout')?.setAttribute('role', 'textbox');
  };

  // The arrow before a heading, which JupyterLab leaves without a name.
  const nameFold = button => button.setAttribute('aria-label', 'Fold or unfold this section');

  // A button or a slider whose kernel has ended comes back as its text, which says what to do.
  const showText = (notebook, place) => {
    const cell = notebook.widgets.find(one => one.outputArea?.node.contains(place));
    const at = cell ? cell.outputArea.widgets.findIndex(one => one.node.contains(place)) : -1;
    const text = at < 0 ? undefined : cell.outputArea.model.get(at)?.data['text/plain'];
    if (text) {
      place.textContent = [text].flat().join('');
      place.classList.add('wb-widget-text');
    }
  };

  // JupyterLab puts cells and outputs on the page when it likes.
  const watchNotebook = notebook => {
    const watch = new MutationObserver(changes => {
      const added = changes.flatMap(change => [...change.addedNodes]);
      const removed = changes.flatMap(change => [...change.removedNodes]);
      added.filter(node => node.data === NO_MODEL && node.parentElement).forEach(node => showText(notebook, node.parentElement));
      within(added, SLIDER).forEach(nameSlider);
      within(added, FOLD).forEach(nameFold);
      if (within([...added, ...removed], EDITOR).length) {
        nameCells(notebook);
      }
    });
    watch.observe(notebook.node, {subtree: true, childList: true});
    notebook.disposed.connect(() => watch.disconnect());
    nameCells(notebook);
    within([notebook.node], FOLD).forEach(nameFold);
  };

  // A file name that is too long for its column goes on below, after one of its underscores (a break of no width).
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
    // A row that gets another file's name keeps its elements: then the text itself is the target.
    const elementOf = node => (node.nodeType === Node.TEXT_NODE ? node.parentElement : node);
    const changed = ({target}) => elementOf(target)?.closest(FILE_NAME) || target;
    new MutationObserver(changes => mark(changes.map(changed))).observe(
      browser.node, {subtree: true, childList: true, characterData: true}
    );
    mark([browser.node]);
  };

  // JupyterLab asks for the least width of the column of files (desk.css) once: again when the style has come, and when
  // the window becomes narrow or wide.
  const addStyle = app => {
    const link = document.createElement('link');
    Object.assign(link, {rel: 'stylesheet', href: STYLE});
    const loaded = new Promise(resolve => (link.onload = resolve));
    document.head.append(link);
    const find = (widget, id) =>
      widget.id === id ? widget : [...(widget.layout || [])].map(one => find(one, id)).find(Boolean);
    const wide = window.matchMedia(WIDE);
    const fit = () => find(app.shell, 'jp-left-stack').fit();
    // In a window that becomes narrow the column gives room, as soon as its new least width is in force.
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

  // A robot that a single cell draws comes onto the screen whole, once for each run.
  const showRobot = cell => {
    const outputs = cell.outputArea;
    if (!outputs || running.has(cell)) {
      return;
    }
    running.add(cell);
    const watch = new MutationObserver(() => {
      const picture = outputs.node.querySelector(ROBOT);
      if (picture && picture.complete && picture.naturalHeight) {
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

  const plugin = ({INotebookTracker, NotebookActions}) => ({
    id: `${NAME}:plugin`,
    autoStart: true,
    requires: [INotebookTracker],
    activate: (app, tracker) => {
      addStyle(app);
      NotebookActions.executionScheduled.connect((_, {cell}) => showRobot(cell));
      NotebookActions.executed.connect((_, {cell}) => ended(cell));
      tracker.widgetAdded.connect((_, panel) => {
        markTab(panel);
        watchNotebook(panel.content);
        panel.context.pathChanged.connect(() => markTab(panel));
      });
    }
  });

  window._JUPYTERLAB = window._JUPYTERLAB || {};
  window._JUPYTERLAB[NAME] = {
    init: scope => {
      shared = scope;
    },
    get: async () => {
      const notebook = await moduleOf('@jupyterlab/notebook');
      return () => ({__esModule: true, default: plugin(notebook)});
    }
  };
})();

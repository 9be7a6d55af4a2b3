// How a lesson looks in JupyterLab (desk.css), and names of tabs: the tab of an exercise says that it is one. Plain
// JavaScript, loaded by JupyterLab as it is: no build step.
(() => {
  const NAME = 'rclpy-workbook-desk';
  const STYLE = new URL('desk.css', document.currentScript.src).href;
  const ROBOT = 'img[alt^="a humanoid robot"]';
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

  // A lesson and its exercise have the same file name: desk.css puts a word before that of the exercise. (The label
  // itself stays: JupyterLab would take another one for a new name of the file.)
  const markTab = ({context, title}) => {
    const isExercise = /(^|\/)exercises\/[^/]+$/.test(context.localPath);
    title.dataset = {...title.dataset, workbook: isExercise ? 'exercise' : 'lesson'};
  };

  // The style may come after the first layout, which then is made again: the column of files has another width.
  const addStyle = app => {
    const link = document.createElement('link');
    Object.assign(link, {rel: 'stylesheet', href: STYLE});
    const loaded = new Promise(resolve => (link.onload = resolve));
    document.head.append(link);
    const find = (widget, id) =>
      widget.id === id ? widget : [...(widget.layout || [])].map(one => find(one, id)).find(Boolean);
    Promise.all([loaded, app.restored]).then(() => find(app.shell, 'jp-left-stack')?.fit());
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

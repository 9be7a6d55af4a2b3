// Shows the home page in a tab. The HTML comes from the server (workbook/lab/home.py). The page opens the cell that a
// link names, and updates the progress while the tab is visible.
// JupyterLab loads this plain JavaScript directly, so there's no build step.
(() => {
  const NAME = 'rclpy-workbook-home';
  const COMMAND = 'workbook:home';
  const LOOK_EVERY_MS = 2000;
  const STYLE = new URL('home.css', document.currentScript.src).href;
  const ROBOTS = new URL('../../rclpy-workbook-panel/static/robots.js', document.currentScript.src);
  const common = import(new URL('../../rclpy-workbook/static/common.js', document.currentScript.src));
  let shared = {};

  const addStyle = () => {
    const link = document.createElement('link');
    link.rel = 'stylesheet';
    link.href = STYLE;
    document.head.append(link);
  };

  // Wait until a cell is on the page. JupyterLab adds cells one by one, and stops waiting for one after ten seconds.
  const onPage = (notebook, cell) =>
    new Promise(resolve => {
      const watch = new MutationObserver(() => look());
      const look = () => {
        if (cell.isAttached || notebook.isDisposed) {
          watch.disconnect();
          resolve();
        }
      };
      watch.observe(notebook.node, {childList: true, subtree: true});
      look();
    });

  // Open a notebook, and scroll to the cell with this ID.
  const open = async (app, path, id) => {
    const panel = await app.commands.execute('docmanager:open', {path, factory: 'Notebook'});
    if (!panel || !id) {
      return;
    }
    await panel.context.ready;
    await panel.revealed;
    const notebook = panel.content;
    const place = notebook.widgets.findIndex(cell => cell.model.id === id);
    if (place >= 0) {
      notebook.deselectAll();
      notebook.activeCellIndex = place;
      await onPage(notebook, notebook.widgets[place]);
      await notebook.scrollToItem(place, 'start');
      notebook.activate();
    }
  };

  class Page {
    constructor(app, ask, widget) {
      Object.assign(this, {app, ask, widget, tag: ''});
      // The robot waves when the page is shown. Without the panel's files, the page has no robot.
      const greeter = import(ROBOTS).then(({Greeter}) => new Greeter());
      this.greet = act => greeter.then(act, () => undefined);
      this.node = widget.node;
      this.node.classList.add('wb-home');
      this.node.tabIndex = -1;
      this.node.setAttribute('role', 'region');
      this.node.setAttribute('aria-label', 'Home');
      this.body = document.createElement('div');
      this.node.append(this.body);
      this.node.addEventListener('click', event => this.clicked(event));
      const timer = setInterval(() => this.look(), LOOK_EVERY_MS);
      widget.disposed.connect(() => clearInterval(timer));
    }

    // Poll the server, but only while the page is visible.
    async look() {
      if (this.asking || !this.widget.isVisible || document.hidden) {
        return;
      }
      this.asking = true;
      try {
        const reply = await this.ask('home', {headers: this.tag ? {'If-None-Match': this.tag} : {}});
        if (reply.status === 200) {
          this.tag = reply.headers.get('Etag') || '';
          this.show(await reply.text());
        }
      } catch (error) {
        // The server is temporarily unreachable. JupyterLab reports that, so leave the page unchanged.
      } finally {
        this.asking = false;
      }
    }

    // Replace the page's content, but keep the focus and the scroll position.
    show(html) {
      const focused = this.node.contains(document.activeElement) ? document.activeElement : null;
      const key = focused && focused.dataset.key;
      const said = this.said || '';
      this.body.innerHTML = html;
      const place = this.body.querySelector('.wb-said');
      if (place) {
        place.textContent = said;
      }
      const figure = this.body.querySelector('.wb-figure');
      if (figure) {
        this.greet(greeter => {
          figure.append(greeter.node);
          const {share} = figure.dataset;
          const text = `a humanoid robot with twelve joints; its battery shows that you've completed ${share} % of the course`;
          greeter.take({battery: Number(share), text});
        });
      }
      if (focused) {
        (this.body.querySelector(`[data-key="${key}"]`) || this.node).focus({preventScroll: true});
      }
    }

    async clicked(event) {
      const target = event.target.closest('[data-path], [data-restore], [data-command]');
      if (!target || event.ctrlKey || event.metaKey || event.shiftKey) {
        return;
      }
      event.preventDefault();
      if (target.dataset.path) {
        await open(this.app, target.dataset.path, target.dataset.cell);
      } else if (target.dataset.command) {
        await this.app.commands.execute(target.dataset.command);
      } else {
        await this.restore(target.dataset.restore);
      }
    }

    async restore(exercise) {
      const reply = await this.ask('restore', {method: 'POST', body: JSON.stringify({exercise})});
      this.said = reply.ok ? (await reply.json()).said : `Your best version wasn't restored: ${reply.statusText}.`;
      this.tag = '';
      await this.look();
    }
  }

  const plugin = ({ICommandPalette}, {IMainMenu}, {ILauncher}, {Widget}, {ServerConnection}, {PageConfig, URLExt}) => ({
    id: `${NAME}:plugin`,
    autoStart: true,
    optional: [ICommandPalette, IMainMenu, ILauncher],
    activate: (app, palette, menu, launcher) => {
      addStyle();
      const settings = ServerConnection.makeSettings();
      const ask = (name, init) =>
        ServerConnection.makeRequest(URLExt.join(settings.baseUrl, 'workbook', name), init, settings);
      let page = null;
      const show = () => {
        if (!page || page.widget.isDisposed) {
          const widget = new Widget();
          Object.assign(widget, {id: 'workbook-home'});
          Object.assign(widget.title, {label: 'Home', closable: true, caption: 'Your progress: lessons read, predictions made, exercises solved'});
          page = new Page(app, ask, widget);
          const look = () => {
            page.look();
            page.greet(greeter => greeter.wave());
          };
          widget.onAfterShow = look;
          widget.onAfterAttach = look;
          widget.onActivateRequest = () => widget.node.focus({preventScroll: true});
          app.shell.add(widget, 'main');
        }
        app.shell.activateById(page.widget.id);
      };
      app.commands.addCommand(COMMAND, {label: 'Workbook Home', caption: 'The course map', execute: show});
      if (palette) {
        palette.addItem({command: COMMAND, category: 'Workbook'});
      }
      if (menu) {
        menu.helpMenu.addGroup([{command: COMMAND}], 0);
      }
      if (launcher) {
        launcher.add({command: COMMAND, category: 'Other', rank: 0});
      }
      // If the address doesn't name a notebook, JupyterLab opens the home page.
      app.restored.then(() => {
        if (!PageConfig.getOption('treePath') && PageConfig.getOption('workspace') === 'default') {
          show();
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
      const names = ['apputils', 'mainmenu', 'launcher'].map(name => `@jupyterlab/${name}`);
      const more = ['@lumino/widgets', '@jupyterlab/services', '@jupyterlab/coreutils'];
      return (await common).pluginWith(shared, [...names, ...more], plugin);
    }
  };
})();

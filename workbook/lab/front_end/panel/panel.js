// The panel beside the notebook: the robot that moves, the graph, and the topics with rate and last value. It follows
// the notebook in front, and is connected only while it is on the screen. Plain JavaScript, no build step.
// The other side is workbook/lab/panel.
(() => {
  const NAME = 'rclpy-workbook-panel';
  const TOGGLE = 'rclpy-workbook:robot-panel';
  const TITLE = 'Robot panel';
  const AGAIN_MS = 2000;
  const LINGERS_MS = 1500;
  const ICON =
    '<svg xmlns="http://www.w3.org/2000/svg" width="16" height="16" viewBox="0 0 16 16"><g class="jp-icon3" fill="#616161">' +
    '<path d="M7.5 1h1v2h4A1.5 1.5 0 0 1 14 4.500v6a1.500 1.500 0 0 1-1.500 1.500h-9A1.500 1.500 0 0 1 2 10.500v-6A1.500 1.500 0 0 1 3.500 3h4zM5.500 6a1.300 1.300 0 1 0 .01 0zm5 0a1.300 1.300 0 1 0 .01 0zM5 13h6v2H5z"/></g></svg>';
  const here = document.currentScript && document.currentScript.src; // the sheets and the robot lie next to this file
  let shared = {};

  // A module of JupyterLab itself, of which there is one version.
  const moduleOf = async name => {
    const [version] = Object.values(shared[name] || {});
    if (!version) {
      throw new Error(`${NAME}: this JupyterLab has no ${name}`);
    }
    return (await version.get())();
  };

  const SVG = 'http://www.w3.org/2000/svg';
  const draw = (name, attributes, ...children) => {
    const element = document.createElementNS(SVG, name);
    Object.entries(attributes).forEach(([key, value]) => element.setAttribute(key, value));
    element.append(...children);
    return element;
  };
  const make = (name, attributes = {}, ...children) => {
    const element = document.createElement(name);
    Object.entries(attributes).forEach(([key, value]) => element.setAttribute(key, value));
    element.append(...children);
    return element;
  };

  // The graph in two columns, nodes and topics, which fit beside a notebook; an arrow for each publisher and subscription.
  const ROW = 48;
  const BOX = 38;
  const LETTER = 6.4;
  const NARROW = 1000;
  const drawGraph = ({nodes, topics}, width) => {
    const column = Math.floor(width * 0.43);
    const letters = Math.max(6, Math.floor((column - 12) / LETTER));
    // A name in one line or two, broken before the last / or _ that fits.
    const lines = name => {
      if (name.length <= letters) {
        return [name];
      }
      const at = Math.max(name.lastIndexOf('/', letters - 1), name.lastIndexOf('_', letters - 1));
      const end = at > 0 ? at : letters - 1;
      const rest = name.slice(end);
      return [name.slice(0, end), rest.length <= letters ? rest : `…${rest.slice(1 - letters)}`];
    };
    const height = Math.max(1, nodes.length, topics.length) * ROW;
    const middle = (index, count) => (height / count) * (index + 0.5);
    const names = [...nodes];
    const picture = draw('svg', {viewBox: `0 0 ${width} ${height}`, width, height, role: 'img'});
    const tip = draw('path', {d: 'M0 0L8 4L0 8z', class: 'workbook-arrow'});
    picture.append(
      draw('defs', {}, draw('marker', {id: 'workbook-tip', refX: 8, refY: 4, markerWidth: 8, markerHeight: 8, orient: 'auto'}, tip))
    );
    const said = [];
    const join = (node, topic, up, forward) => {
      const from = [column, middle(names.indexOf(node), names.length) + up];
      const to = [width - column, middle(topic, topics.length) + up];
      const ends = forward ? [...from, ...to] : [...to, ...from];
      picture.append(
        draw('path', {d: `M${ends[0]} ${ends[1]}L${ends[2]} ${ends[3]}`, class: 'workbook-line', 'marker-end': 'url(#workbook-tip)'})
      );
    };
    topics.forEach((topic, index) => {
      const known = list => [...new Set(list)].filter(node => names.includes(node));
      known(topic.publishers).forEach(node => {
        join(node, index, -5, true);
        said.push(`${node} publishes ${topic.name}`);
      });
      known(topic.subscribers).forEach(node => {
        join(node, index, 5, false);
        said.push(`${node} subscribes to ${topic.name}`);
      });
    });
    const box = (name, x, y, radius, kind) =>
      picture.append(
        draw(
          'g',
          {class: kind},
          draw('title', {}, name),
          draw('rect', {x: x + 1, y: y - BOX / 2, width: column - 2, height: BOX, rx: radius}),
          ...lines(name).map((line, at, all) =>
            draw('text', {x: x + column / 2, y: y + 11 - 7 * all.length + 14 * at, 'text-anchor': 'middle'}, line)
          )
        )
      );
    names.forEach((name, index) => box(name, 0, middle(index, names.length), 14, 'workbook-node'));
    topics.forEach((topic, index) => box(topic.name, width - column, middle(index, topics.length), 3, 'workbook-topic'));
    picture.setAttribute('aria-label', `Graph: ${said.join('; ') || names.join(', ') || 'empty'}`);
    return picture;
  };

  const definePanel = (Widget, connect, makeRobot) =>
    class RobotPanel extends Widget {
      constructor() {
        super({node: make('div', {role: 'region', 'aria-label': TITLE, tabindex: '0'})});
        this.id = NAME;
        this.addClass('workbook-panel');
        this.node.style.minWidth = '300px'; // JupyterLab asks for it before the sheet is there
        this._kernel = null;
        this._echo = null;
        this._socket = null;
        this._graph = {nodes: [], topics: []};
        this._rows = new Map();
        this._build();
        document.addEventListener('visibilitychange', () => this._connect());
        this._forget();
      }

      // Watch the domain of this kernel (null: none) of the notebook at this path (null: none is open).
      follow(kernel, path, name) {
        this._notebook = path;
        this._name.textContent = name || 'No notebook';
        if (this._kernel !== kernel) {
          this._kernel = kernel;
          this._domain = undefined;
          this._forget();
          this._send({kernel});
          this._connect();
        } else if (!kernel) {
          this._forget();
        }
      }

      onAfterShow() {
        this._connect();
      }

      onAfterHide() {
        this._connect();
      }

      onAfterAttach() {
        this._connect();
      }

      onBeforeDetach() {
        this._disconnect();
      }

      onResize() {
        this._showGraph();
      }

      _build() {
        this._name = make('h2');
        this._status = make('p', {role: 'status'});
        this._robot = null;
        this._figure = make('div', {class: 'workbook-robot', hidden: ''});
        this._words = make('p', {class: 'workbook-words'});
        this._picture = make('div', {class: 'workbook-graph'});
        this._head = make('thead', {}, make('tr', {}, ...['Topic, last value', 'Rate'].map(word => make('th', {scope: 'col'}, word))));
        this._table = make('table', {}, this._head);
        this._messages = make('pre', {tabindex: '0'});
        this._echoTitle = make('h3');
        this._echoPart = make('section', {hidden: '', class: 'workbook-echo'}, this._echoTitle, this._messages);
        this._parts = make('div', {}, make('h3', {}, 'Graph'), this._picture, make('h3', {}, 'Topics'), this._table, this._echoPart);
        this.node.append(this._name, this._status, this._figure, this._words, this._parts);
      }

      // Without a kernel there is nothing to watch, and no observer runs.
      _wanted() {
        return this._kernel !== null && this.isVisible && document.visibilityState === 'visible';
      }

      // Another theme hides the panel for a moment, and a notebook that comes to the front may have no kernel for a
      // moment: the panel stays connected for a little longer than it is wanted.
      _connect() {
        clearTimeout(this._leaving);
        if (!this._wanted()) {
          this._leaving = setTimeout(() => this._disconnect(), LINGERS_MS);
        } else if (!this._socket) {
          const socket = connect();
          this._socket = socket;
          this._say('Starting …');
          socket.onopen = () => {
            if (this._robot) {
              this._robot.reset();
            }
            this._send({kernel: this._kernel});
          };
          socket.onmessage = event => this._take(JSON.parse(event.data));
          socket.onclose = () => {
            if (this._socket === socket) {
              this._socket = null;
              this._say('Not connected. Trying again …');
              setTimeout(() => this._connect(), AGAIN_MS);
            }
          };
        }
      }

      _disconnect() {
        const socket = this._socket;
        this._socket = null;
        if (socket) {
          socket.close();
        }
      }

      _send(what) {
        if (this._socket && this._socket.readyState === WebSocket.OPEN) {
          this._socket.send(JSON.stringify(what));
        }
      }

      _say(text) {
        this._status.textContent = text;
      }

      // Nothing is known of this notebook yet.
      _forget() {
        this._graph = {nodes: [], topics: []};
        this._choose(null);
        this._figure.hidden = true;
        this._words.textContent = '';
        if (this._robot) {
          this._robot.reset();
        }
        this._parts.hidden = true;
        const none = this._notebook ? 'Its kernel is not running.' : 'Open a notebook to see its robot.';
        this._say(this._kernel ? 'Looking for the domain of this notebook …' : none);
      }

      _take(news) {
        if (news.kind === 'domain') {
          if (news.domain !== this._domain) {
            this._domain = news.domain;
            this._forget();
          }
          if (news.domain !== null) {
            this._say(`ROS domain ${news.domain}`);
            this._send({echo: this._echo});
          }
        } else if (news.kind === 'robot') {
          this._showRobot(news);
        } else if (news.kind === 'graph') {
          this._graph = news;
          this._parts.hidden = false;
          this._parts.classList.toggle('workbook-elsewhere', !news.listening);
          this._showGraph();
          this._showTopics();
        } else if (news.kind === 'news') {
          this._showNews(news);
        }
      }

      async _showRobot(news) {
        const domain = this._domain;
        const robot = await makeRobot();
        if (!this._robot) {
          this._robot = robot;
          this._figure.append(robot.node);
        }
        if (domain === this._domain) {
          this._robot.take(news);
          this._words.textContent = news.words === undefined ? this._words.textContent : news.words;
          this._figure.hidden = false;
        }
      }

      _showGraph() {
        const width = Math.max(200, this._picture.clientWidth || this.node.clientWidth - 24);
        const {nodes, topics} = this._graph;
        this._picture.replaceChildren(
          nodes.length || topics.length ? drawGraph(this._graph, width) : make('p', {}, 'No nodes on this domain.')
        );
      }

      _showTopics() {
        const rows = this._graph.topics.map(({name, type, publishers}) => {
          const kept = this._rows.get(name);
          if (kept) {
            return [name, kept];
          }
          const button = make('button', {type: 'button', title: `${type}: show its messages`, 'aria-pressed': 'false'}, name);
          button.onclick = () => {
            this._choose(this._echo === name ? null : name);
            this._keepChoice();
          };
          const [rate, value] = [make('td'), make('td', {colspan: '2'})];
          rate.textContent = publishers.length ? '–' : 'no publisher';
          const rows = [make('tr', {}, make('th', {scope: 'row'}, button), rate), make('tr', {}, value)];
          return [name, {row: make('tbody', {}, ...rows), button, rate, value}];
        });
        this._rows = new Map(rows);
        if (this._echo && !this._rows.has(this._echo)) {
          this._choose(null);
        }
        const kept = this._keptChoice();
        if (!this._echo && this._rows.has(kept)) {
          this._choose(kept);
        }
        const wanted = rows.map(([, one]) => one.row);
        const present = [...this._table.tBodies];
        if (wanted.length !== present.length || wanted.some((row, at) => row !== present[at])) {
          this._table.replaceChildren(this._head, ...wanted);
        }
        this._table.hidden = !rows.length;
      }

      // Show the messages of a topic (null: of none).
      _choose(topic) {
        this._echo = topic;
        this._rows.forEach((one, name) => one.button.setAttribute('aria-pressed', String(name === topic)));
        this._echoPart.hidden = topic === null;
        this._echoTitle.textContent = topic === null ? '' : `Messages on ${topic}`;
        this._messages.setAttribute('aria-label', this._echoTitle.textContent);
        this._messages.textContent = 'waiting for the next one …';
        this._send({echo: topic});
      }

      // The topic chosen beside a notebook, for as long as the browser's tab lives: it outlives a reload of the page, a
      // restart of the kernel and a look at another notebook.
      _keepChoice() {
        sessionStorage.setItem(`${NAME}:${this._notebook}`, this._echo || '');
      }

      _keptChoice() {
        return sessionStorage.getItem(`${NAME}:${this._notebook}`);
      }

      _showNews({topics, echo, messages}) {
        this._rows.forEach(({rate, value}, name) => {
          const heard = topics[name];
          if (heard) {
            rate.textContent = heard.rate;
            value.textContent = heard.value;
            value.title = heard.value;
          }
        });
        if (echo === this._echo && messages.length) {
          this._messages.textContent = messages.join('\n---\n');
          this._messages.scrollTop = this._messages.scrollHeight;
        }
      }
    };

  const activateWith = (modules, Panel) => (app, tracker, shell, palette, restorer) => {
    const {LabIcon, ToolbarButton} = modules;
    const panel = new Panel();
    const icon = new LabIcon({name: `${NAME}:robot`, svgstr: ICON});
    panel.title.icon = icon;
    panel.title.caption = TITLE;
    shell.add(panel, 'right', {rank: 900, activate: false});
    if (restorer) {
      restorer.add(panel, NAME);
    }
    app.commands.addCommand(TOGGLE, {
      label: TITLE,
      caption: 'Show or hide the robot, the graph and the topics of this notebook',
      icon,
      isToggled: () => panel.isVisible,
      execute: () => {
        if (panel.isVisible) {
          shell.collapseRight();
          return;
        }
        if (window.innerWidth < NARROW) {
          shell.collapseLeft();
        }
        shell.activateById(panel.id);
      }
    });
    // In a narrow window, notebook and panel need the room of the files.
    window.matchMedia(`(max-width: ${NARROW - 1}px)`).addEventListener('change', ({matches}) => {
      if (matches && panel.isVisible) {
        shell.collapseLeft();
      }
    });
    if (palette) {
      palette.addItem({command: TOGGLE, category: 'Robot'});
    }
    let followed = null;
    const follow = () => {
      const notebook = tracker.currentWidget;
      const context = notebook && notebook.sessionContext;
      if (context && context !== followed) {
        followed = context;
        context.kernelChanged.connect(follow);
        context.statusChanged.connect(follow);
      }
      const kernel = context && context.session && context.session.kernel;
      const name = notebook && notebook.title.label.replace(/\.ipynb$/, '');
      panel.follow(kernel ? kernel.id : null, notebook && notebook.context.path, name);
    };
    tracker.currentChanged.connect(follow);
    follow();
    app.docRegistry.addWidgetExtension('Notebook', {
      createNew: notebook => {
        const button = new ToolbarButton({
          icon,
          label: 'Robot',
          tooltip: 'Show or hide the robot panel',
          onClick: () => app.commands.execute(TOGGLE)
        });
        notebook.toolbar.insertAfter('save', 'robot-panel', button) || notebook.toolbar.addItem('robot-panel', button);
        return button;
      }
    });
  };

  // The robot of this panel; its shapes are read when it is first shown.
  const robotMaker = () => {
    let robot = null;
    const read = async () => {
      const [{Robot}, answer] = await Promise.all([import(new URL('rig.js', here)), fetch(new URL('figure.json', here))]);
      return new Robot(await answer.json());
    };
    return () => {
      if (!robot) {
        robot = read();
        robot.catch(() => {
          robot = null; // the next message tries again
        });
      }
      return robot;
    };
  };

  const makePlugin = async () => {
    const names = ['application', 'apputils', 'coreutils', 'notebook', 'services', 'ui-components'];
    const loaded = await Promise.all([...names.map(name => moduleOf(`@jupyterlab/${name}`)), moduleOf('@lumino/widgets')]);
    const [application, apputils, {URLExt}, {INotebookTracker}, {ServerConnection}, components, {Widget}] = loaded;
    const connect = () => {
      const settings = ServerConnection.makeSettings();
      const token = settings.token ? `?token=${encodeURIComponent(settings.token)}` : '';
      return new WebSocket(URLExt.join(settings.wsUrl, 'workbook', 'panel') + token);
    };
    const {ILabShell, ILayoutRestorer} = application;
    return {
      id: `${NAME}:panel`,
      autoStart: true,
      requires: [INotebookTracker, ILabShell],
      optional: [apputils.ICommandPalette, ILayoutRestorer],
      activate: activateWith(components, definePanel(Widget, connect, robotMaker()))
    };
  };

  const addStyle = () => {
    for (const sheet of ['panel.css', 'contrast.css']) {
      document.head.append(make('link', {rel: 'stylesheet', href: new URL(sheet, here).href}));
    }
    return {};
  };

  window._JUPYTERLAB = window._JUPYTERLAB || {};
  window._JUPYTERLAB[NAME] = {
    init: scope => {
      shared = scope;
    },
    get: async name => {
      if (name === './style') {
        return addStyle;
      }
      const plugin = await makePlugin();
      return () => ({__esModule: true, default: plugin});
    }
  };
})();

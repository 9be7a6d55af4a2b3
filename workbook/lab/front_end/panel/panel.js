// Adds the panel next to the notebook: the moving robot, the graph, and each topic's rate and last value. Also adds the
// robots in cells. They all show the messages that the active notebook's programs publish.
// JupyterLab loads this plain JavaScript directly, so there's no build step.
// The server's side is workbook/lab/panel.
(() => {
  const NAME = 'rclpy-workbook-panel';
  const TOGGLE = 'rclpy-workbook:robot-panel';
  const OFFER = 'rclpy-workbook:offer-robot-panel';
  const TITLE = 'Robot panel';
  const ICON =
    '<svg xmlns="http://www.w3.org/2000/svg" width="16" height="16" viewBox="0 0 16 16"><g class="jp-icon3" fill="#616161">' +
    '<path d="M7.5 1h1v2h4A1.5 1.5 0 0 1 14 4.500v6a1.500 1.500 0 0 1-1.500 1.500h-9A1.500 1.500 0 0 1 2 10.500v-6A1.500 1.500 0 0 1 3.500 3h4zM5.500 6a1.300 1.300 0 1 0 .01 0zm5 0a1.300 1.300 0 1 0 .01 0zM5 13h6v2H5z"/></g></svg>';
  const here = document.currentScript && document.currentScript.src; // the style sheets and the robot are there, too
  const common = import(new URL('../../rclpy-workbook/static/common.js', here));
  let shared = {};

  // Show these topic rows in a table. Return whether there are any.
  const fill = (table, rows, ...head) => {
    const wanted = rows.map(([, one]) => one.row);
    const present = [...table.tBodies];
    if (wanted.length !== present.length || wanted.some((row, at) => row !== present[at])) {
      table.replaceChildren(...head, ...wanted);
    }
    return wanted.length > 0;
  };

  // Return whether a topic is the exercise's plumbing: its driver and the judge communicate through it.
  const isPlumbing = name => name === '/clock' || name.startsWith('/driver/');

  // The graph has two columns, nodes and topics, to fit next to a notebook. Publishers and subscriptions are arrows.
  const GAP = 10;
  const LINE = 14;
  const LETTER = 6.4;
  const LETTER_PX = 11.5;
  const NARROW = 1000;
  const drawGraph = ({draw, parts}, {nodes, topics}, width) => {
    const column = Math.floor(width * 0.43);
    const letters = Math.max(6, Math.floor((column - 12) / LETTER));
    // Split a name into lines, each with as many of its parts as fit.
    const lines = name =>
      parts(name).reduce(
        ([...above], part) => {
          const last = above.pop();
          return (last + part).length <= letters || !last ? [...above, last + part] : [...above, last, part];
        },
        ['']
      );
    // A part that's too long for a line gets smaller letters.
    const letterSize = line => LETTER_PX * Math.min(1, letters / line.length);
    const most = Math.max(1, ...[...nodes, ...topics.map(({name}) => name)].map(name => lines(name).length));
    const tall = most * LINE + GAP;
    const height = Math.max(1, nodes.length, topics.length) * (tall + GAP);
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
          draw('rect', {x: x + 1, y: y - tall / 2, width: column - 2, height: tall, rx: radius}),
          ...lines(name).map((line, at, all) =>
            draw(
              'text',
              {
                x: x + column / 2,
                y: y + 11 + LINE * (at - all.length / 2),
                'text-anchor': 'middle',
                style: `font-size: ${letterSize(line)}px`
              },
              line
            )
          )
        )
      );
    names.forEach((name, index) => box(name, 0, middle(index, names.length), 14, 'workbook-node'));
    topics.forEach((topic, index) => box(topic.name, width - column, middle(index, topics.length), 3, 'workbook-topic'));
    picture.setAttribute('aria-label', `Graph: ${said.join('; ') || names.join(', ') || 'empty'}`);
    return picture;
  };

  const definePanel = (Widget, stream, stage, makeStage) => {
    const {make, breakable, sparkline} = stage;
    return class RobotPanel extends Widget {
      constructor() {
        super({node: make('div', {role: 'region', 'aria-label': TITLE, tabindex: '0'})});
        this.id = NAME;
        this.addClass('workbook-panel');
        this.node.style.minWidth = '300px'; // JupyterLab reads this before the style sheet has loaded
        this._kernel = null;
        this._echo = null;
        this._graph = {nodes: [], topics: []};
        this._rows = new Map();
        this._build();
        this._forget();
        stream.add(this);
      }

      // Watch the domain of a notebook's kernel (null if none is running). `path` is null if no notebook is open.
      follow(kernel, path, name) {
        this._notebook = path;
        this._name.replaceChildren(...breakable(name || 'No notebook'));
        if (this._kernel !== kernel) {
          this._kernel = kernel;
          this._domain = undefined;
          this._forget();
        } else if (!kernel) {
          this._forget();
        }
        stream.follow(kernel);
      }

      onAfterShow() {
        stream.look();
      }

      onAfterHide() {
        stream.look();
      }

      onAfterAttach() {
        stream.look();
      }

      onAfterDetach() {
        stream.look();
      }

      onResize() {
        this._showGraph();
      }

      _build() {
        this._name = make('h2');
        this._status = make('p', {role: 'status'});
        this._stage = makeStage();
        this._stage.node.hidden = true;
        this._picture = make('div', {class: 'workbook-graph'});
        this._head = make('thead', {}, make('tr', {}, ...['Topic, last value', 'Rate'].map(word => make('th', {scope: 'col'}, word))));
        this._table = make('table', {}, this._head);
        this._plumbing = make('table');
        this._folded = make('details', {hidden: ''}, make('summary'), this._plumbing);
        this._messages = make('pre', {tabindex: '0'});
        this._echoTitle = make('h3');
        this._echoPart = make('section', {hidden: '', class: 'workbook-echo'}, this._echoTitle, this._messages);
        this._topics = make('h3', {}, 'Topics');
        this._parts = make('div', {}, make('h3', {}, 'Graph'), this._picture, this._topics, this._table, this._folded, this._echoPart);
        this.node.append(this._name, this._status, this._stage.node, this._parts);
      }

      wants() {
        return this.isVisible;
      }

      opened() {
        this._stage.reset();
      }

      say(text) {
        this._status.textContent = text;
      }

      // Clear the panel until it receives data about this notebook.
      _forget() {
        this._graph = {nodes: [], topics: []};
        this._choose(null);
        this._stage.node.hidden = true;
        this._stage.reset();
        this._parts.hidden = true;
        const none = this._notebook ? "This notebook's kernel isn't running." : 'Open a notebook to see its robot.';
        this.say(this._kernel ? "Looking for this notebook's domain …" : none);
      }

      take(news) {
        if (news.kind === 'domain') {
          if (news.domain !== this._domain) {
            this._domain = news.domain;
            this._forget();
          }
          if (news.domain !== null) {
            this.say(`ROS domain ${news.domain}`);
            stream.send({echo: this._echo});
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
        await this._stage.bring();
        if (domain === this._domain) {
          this._stage.take(news);
          this._stage.node.hidden = false;
        }
      }

      _showGraph() {
        const width = Math.max(200, this._picture.clientWidth || this.node.clientWidth - 24);
        const topics = this._graph.topics.filter(({name}) => !isPlumbing(name));
        const nodes = this._graph.nodes.filter(name => name !== '/driver');
        this._picture.replaceChildren(
          nodes.length || topics.length ? drawGraph(stage, {nodes, topics}, width) : make('p', {}, 'No nodes on this domain.')
        );
      }

      _showTopics() {
        const rows = this._graph.topics.map(({name, type, publishers}) => {
          const kept = this._rows.get(name);
          if (kept) {
            return [name, kept];
          }
          const button = make('button', {type: 'button', title: `${type}: show its messages`, 'aria-pressed': 'false'}, ...breakable(name));
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
        const [plumbing, seen] = [true, false].map(kind => rows.filter(([name]) => isPlumbing(name) === kind));
        this._table.hidden = !fill(this._table, seen, this._head);
        this._topics.hidden = !rows.length;
        this._folded.hidden = !fill(this._plumbing, plumbing);
        this._folded.firstChild.textContent = `The exercise's own topics (${plumbing.length})`;
      }

      // Show a topic's messages (null: hide them).
      _choose(topic) {
        this._echo = topic;
        this._rows.forEach((one, name) => one.button.setAttribute('aria-pressed', String(name === topic)));
        this._echoPart.hidden = topic === null;
        this._echoTitle.textContent = topic === null ? '' : `Messages on ${topic}`;
        this._messages.setAttribute('aria-label', this._echoTitle.textContent);
        this._messages.textContent = 'waiting for the next message …';
        stream.send({echo: topic});
      }

      // Store the topic chosen for a notebook until the browser tab is closed. The choice survives page reloads, kernel
      // restarts, and visits to other notebooks.
      _keepChoice() {
        sessionStorage.setItem(`${NAME}:${this._notebook}`, this._echo || '');
      }

      _keptChoice() {
        return sessionStorage.getItem(`${NAME}:${this._notebook}`);
      }

      _showNews({topics, echo, messages}) {
        this._stage.take({kind: 'news', topics});
        this._rows.forEach(({rate, value}, name) => {
          const heard = topics[name];
          if (heard) {
            rate.textContent = heard.rate;
            value.replaceChildren(heard.value, ...(heard.numbers ? [sparkline(heard.numbers)] : []));
            value.title = heard.value;
          }
        });
        if (echo === this._echo && messages.length) {
          this._messages.textContent = messages.join('\n---\n');
          this._messages.scrollTop = this._messages.scrollHeight;
        }
      }
    };
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
      caption: "Show or hide this notebook's robot, graph, and topics",
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
    // In a narrow window, the notebook and the panel need the file browser's space.
    window.matchMedia(`(max-width: ${NARROW - 1}px)`).addEventListener('change', ({matches}) => {
      if (matches && panel.isVisible) {
        shell.collapseLeft();
      }
    });
    if (palette) {
      palette.addItem({command: TOGGLE, category: 'Robot'});
    }
    app.commands.addCommand(OFFER, {
      label: 'Show the robot panel the first time',
      execute: () => {
        if (!sessionStorage.getItem(OFFER) && !panel.isVisible) {
          app.commands.execute(TOGGLE);
        }
        sessionStorage.setItem(OFFER, 'done'); // don't reopen a panel that the reader has closed in this tab
      }
    });
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

  const makeRobot = async () => (await import(new URL('robots.js', here))).makeRobot();

  const makePlugin = async (...modules) => {
    const [application, apputils, {URLExt}, {INotebookTracker}, rendermimes, {ServerConnection}, components, {Widget}] = modules;
    const {IRenderMimeRegistry, htmlRendererFactory} = rendermimes;
    const files = ['stream.js', 'cell.js', 'card.js', 'stage.js'].map(file => import(new URL(file, here)));
    const [{Stream}, {TYPE, defineCellRobot}, {CHECK, defineCheckRobot}, stage] = await Promise.all(files);
    const connect = () => {
      const settings = ServerConnection.makeSettings();
      const token = settings.token ? `?token=${encodeURIComponent(settings.token)}` : '';
      return new WebSocket(URLExt.join(settings.wsUrl, 'workbook', 'panel') + token);
    };
    const stream = new Stream(connect);
    const {ILabShell, ILayoutRestorer} = application;
    const makeStage = () => new stage.Stage(makeRobot);
    const CellRobot = defineCellRobot(Widget, stream, makeStage);
    const CheckRobot = defineCheckRobot(Widget, htmlRendererFactory, makeRobot);
    const cells = {safe: true, mimeTypes: [TYPE], createRenderer: () => new CellRobot()};
    const cards = {safe: true, mimeTypes: [CHECK], createRenderer: options => new CheckRobot(options)};
    const activatePanel = activateWith(components, definePanel(Widget, stream, stage, makeStage));
    return {
      id: `${NAME}:panel`,
      autoStart: true,
      requires: [INotebookTracker, ILabShell, IRenderMimeRegistry],
      optional: [apputils.ICommandPalette, ILayoutRestorer],
      activate: (app, tracker, shell, rendermime, ...more) => {
        rendermime.addFactory(cells, 0);
        rendermime.addFactory(cards, 0);
        activatePanel(app, tracker, shell, ...more);
      }
    };
  };

  const addStyle = () => {
    for (const sheet of ['panel.css', 'card.css', 'contrast.css']) {
      const link = document.createElement('link');
      link.rel = 'stylesheet';
      link.href = new URL(sheet, here).href;
      document.head.append(link);
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
      const names = ['application', 'apputils', 'coreutils', 'notebook', 'rendermime', 'services', 'ui-components'];
      const all = [...names.map(one => `@jupyterlab/${one}`), '@lumino/widgets'];
      return (await common).pluginWith(shared, all, makePlugin);
    }
  };
})();

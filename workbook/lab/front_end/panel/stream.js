// The page's only connection to the server. The panel and the robots in cells share it, because only one observer per
// ROS domain receives the published messages. It follows the active notebook, and is open only while a viewer needs it.
// The server's side is workbook/lab/panel.
const AGAIN_MS = 2000;
const LINGERS_MS = 1500;
const MOMENTS = ['beat', 'touch', 'alert', 'thought', 'nod', 'shake']; // effects that happen once; the others last
const LASTING = ['face', 'alarm', 'battery', 'pose', 'tilt', 'look', 'walk', 'raw', 'image', 'boxes'];
const NOTHING = {awake: false, words: '', ...Object.fromEntries(LASTING.map(name => [name, null]))};

export class Stream {
  // `connect` opens a WebSocket. A viewer has wants(kernel), opened(), take(news), and say(text).
  constructor(connect) {
    this.kernel = null;
    this._open = connect;
    this._socket = null;
    this._viewers = new Map(); // each viewer, and whether it currently gets updates
    this._forget();
    document.addEventListener('visibilitychange', () => this.look());
  }

  // Follow this kernel (null: none).
  follow(kernel) {
    if (this.kernel !== kernel) {
      this.kernel = kernel;
      this._forget();
      this.send({kernel});
    }
    this.look();
  }

  add(viewer) {
    this._viewers.set(viewer, false);
    this.look();
  }

  remove(viewer) {
    this._viewers.delete(viewer);
    this.look();
  }

  // Check again which viewers need updates. A theme change briefly hides the panel, and a notebook that becomes active
  // may briefly have no kernel. So the connection stays open a little longer than needed.
  look() {
    const visible = this.kernel !== null && document.visibilityState === 'visible';
    let wanted = false;
    for (const [viewer, joined] of this._viewers) {
      const wants = visible && viewer.wants(this.kernel);
      this._viewers.set(viewer, wants);
      wanted ||= wants;
      if (wants && !joined && this._socket) {
        this._catchUp(viewer);
      }
    }
    clearTimeout(this._leaving);
    if (!wanted) {
      this._leaving = setTimeout(() => this._disconnect(), LINGERS_MS);
    } else if (!this._socket) {
      this._connect();
    }
  }

  send(what) {
    if (this._socket && this._socket.readyState === WebSocket.OPEN) {
      this._socket.send(JSON.stringify(what));
    }
  }

  _forget() {
    this._last = {}; // the latest update of each kind
    this._robot = {...NOTHING};
  }

  _shown(tell) {
    this._viewers.forEach((joined, viewer) => joined && tell(viewer));
  }

  // Send a viewer that joins later the data that the others already have.
  _catchUp(viewer) {
    const {domain, graph, news} = this._last;
    if (!domain) {
      viewer.say('Starting …');
      return;
    }
    const robot = {kind: 'robot', ...this._robot};
    [domain, robot, graph, news].filter(one => one).forEach(one => viewer.take(one));
  }

  _connect() {
    const socket = this._open();
    this._socket = socket;
    this._shown(viewer => viewer.say('Starting …'));
    socket.onopen = () => {
      this._forget();
      this._shown(viewer => viewer.opened());
      this.send({kernel: this.kernel});
    };
    socket.onmessage = event => this._take(JSON.parse(event.data));
    socket.onclose = () => {
      if (this._socket === socket) {
        this._socket = null;
        this._shown(viewer => viewer.say('Not connected. Trying again …'));
        setTimeout(() => this.look(), AGAIN_MS);
      }
    };
  }

  _disconnect() {
    const socket = this._socket;
    this._socket = null;
    if (socket) {
      socket.close();
    }
  }

  // Ignore updates until the server sends the domain, because they're about the previously followed notebook.
  _take(news) {
    const {kind, ...values} = news;
    if (kind === 'domain') {
      this._forget();
    } else if (!this._last.domain) {
      return;
    }
    if (kind === 'robot') {
      MOMENTS.forEach(moment => delete values[moment]);
      Object.assign(this._robot, values);
    } else {
      this._last[kind] = news;
    }
    this._shown(viewer => viewer.take(news));
  }
}

// The robot, drawn by the page. It glides from message to message at the screen's refresh rate, and needs no CPU time
// while it stands still. figure.json has its shapes, joints, and poses. The table in workbook/lab/panel/reactions.py
// maps topics to effects. This file needs only a document, so any page can show the robot.
const SVG = 'http://www.w3.org/2000/svg';
const GLIDE_MS = 70; // in this time, the rest of a movement shrinks to about a third
const ARRIVED = 0.001;
const BEAT_MS = 500;
const FLINCH_MS = 600;
const ALERT_MS = 3000;
const THOUGHT_MS = 2000;
const REPLY_MS = 900; // a nod or a head shake
const DIP = 9; // px; how far the head moves down in a nod
const SHAKES = 0.22; // rad
const WALK_ENDS_MS = 1500; // without another command
const MOST_TILT = 1.5;
const UPRIGHT_TO = 0.7; // rad; beyond this lean, the feet slip, so that a fallen robot stays in view
const SLIPS = 190; // px
const LIES_HIGH = 58;
const STEPS_PER_M = 2;
const REST = {tilt: 0, look: 0, charge: 0, stride: 0, turn: 0};

const element = ({tag, text, ...attributes}, ...children) => {
  const made = document.createElementNS(SVG, tag);
  Object.entries(attributes).forEach(([name, value]) => made.setAttribute(name, value));
  made.append(...children, ...(text ? [text] : []));
  return made;
};

// Multiply a matrix, in SVG's order, by a rotation of `angle` (rad) around the point (x, y).
const turned = ([a, b, c, d, e, f], angle, x, y) => {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const [g, h] = [x - x * cos + y * sin, y - x * sin - y * cos];
  return [a * cos + c * sin, b * cos + d * sin, c * cos - a * sin, d * cos - b * sin, a * g + c * h + e, b * g + d * h + f];
};
const applied = ([a, b, c, d, e, f], [x, y]) => [a * x + c * y + e, b * x + d * y + f];
const between = (from, to, part) => from.map((value, at) => value + (to[at] - value) * part);
const clamped = (value, most) => Math.max(-most, Math.min(most, value));

export class Robot {
  constructor(figure) {
    this._figure = figure;
    this._stillness = window.matchMedia('(prefers-reduced-motion: reduce)');
    this._parts = figure.parts.map(part => ({...part, node: element({tag: 'g'}, ...part.shapes.map(shape => element(shape)))}));
    this._shadow = element({tag: 'ellipse', cy: figure.ground + 3, fill: '#787878'});
    const [width, height] = figure.size;
    const line = {tag: 'line', x1: 26, x2: width - 26, y1: figure.ground, y2: figure.ground, stroke: '#787878', 'stroke-width': 2};
    this._body = element({tag: 'g', 'font-family': 'sans-serif', 'stroke-linecap': 'round', 'stroke-linejoin': 'round'}, ...this._parts.map(part => part.node));
    this.node = element({tag: 'svg', viewBox: `0 0 ${width} ${height}`, role: 'img'}, this._shadow, element(line), this._body);
    this._signs = Object.fromEntries(this._parts.filter(part => part.sign).map(part => [part.sign, part.node]));
    this._level = this._signs.level.firstChild;
    this._fullWidth = Number(this._level.getAttribute('width'));
    this._chains = new Map(this._parts.concat(figure.touching).map(({joints}) => [joints.join(), joints]));
    this._frame = null;
    this.glide = GLIDE_MS;
    this._signs_on = {alert: null, thought: null}; // timers
    this.reset();
  }

  // Restore the state before the first message: asleep.
  reset() {
    this._state = {awake: false, face: null, alarm: false, battery: null, text: 'a humanoid robot with twelve joints, asleep'};
    this._aim = {...REST, pose: this._figure.neutral};
    this._now = {...REST, pose: this._figure.neutral};
    this._since = {beat: -Infinity, touch: -Infinity, nod: -Infinity, shake: -Infinity};
    this._steps = 0;
    this._beats = 0;
    this._walk(null);
    Object.keys(this._signs_on).forEach(sign => {
      clearTimeout(this._signs_on[sign]);
      this._signs_on[sign] = null;
    });
    this._show();
    this._draw(performance.now());
  }

  // The names of the effects that happen once. All others last.
  get moments() {
    return Object.keys({...this._since, ...this._signs_on});
  }

  // Apply the changed effects. null ends a lasting effect. For a beat, a touch, or the like, the value is a count.
  take(news) {
    const now = performance.now();
    for (const [effect, value] of Object.entries(news)) {
      if (effect === 'pose') {
        this._aim.pose = value || this._figure.neutral;
      } else if (effect === 'tilt') {
        this._aim.tilt = clamped(value || 0, MOST_TILT);
      } else if (effect === 'look') {
        this._aim.look = clamped(value || 0, MOST_TILT);
      } else if (effect === 'walk') {
        this._walk(value);
      } else if (effect in this._since) {
        this._since[effect] = now;
        this._beats += effect === 'beat' ? value : 0;
      } else if (effect in this._signs_on) {
        clearTimeout(this._signs_on[effect]);
        const off = () => {
          this._signs_on[effect] = null;
          this._show();
        };
        this._signs_on[effect] = setTimeout(off, effect === 'alert' ? ALERT_MS : THOUGHT_MS);
      } else if (effect in this._state) {
        this._state[effect] = value;
      }
    }
    this._aim.charge = Math.max(0, Math.min(100, this._state.battery || 0));
    this._show();
    this._wake();
  }

  _walk(speed) {
    clearTimeout(this._walkEnds);
    const [ahead, turn] = speed || [0, 0];
    const walks = ahead !== 0 || turn !== 0;
    this._pace = ahead === 0 ? Math.abs(turn) / 2 : ahead;
    this._aim.stride = walks ? 1 : 0;
    this._aim.turn = clamped(turn, 1);
    if (walks) {
      this._walkEnds = setTimeout(() => {
        this._walk(null);
        this._wake();
      }, WALK_ENDS_MS);
    }
  }

  // Show or hide the parts that depend on the state.
  _show() {
    const {awake, face, alarm, battery, text} = this._state;
    const alarmed = Boolean(alarm) || this._signs_on.alert !== null;
    const shown = awake ? face || (alarmed ? 'error' : 'awake') : 'asleep';
    const signs = {
      heart: this._stillness.matches ? this._beats % 2 === 1 : true,
      battery: battery !== null,
      level: battery !== null,
      alarm: alarmed,
      thought: this._signs_on.thought !== null
    };
    this._parts.forEach(part => {
      const {node, faces, sign} = part;
      const display = (sign ? signs[sign] : !faces || faces.includes(shown)) ? 'inline' : 'none';
      if (part.display !== display) {
        part.display = display;
        node.setAttribute('display', display);
      }
    });
    const said = `${shown} ${text || ''}`;
    if (this._said !== said) {
      this._said = said;
      this.node.setAttribute('aria-label', text || '');
      this.node.setAttribute('data-face', shown);
    }
    if (battery !== null) {
      this._level.setAttribute('fill', this._figure.charge.find(([above]) => battery > above || above === 0)[1]);
    }
  }

  _wake() {
    if (this._frame === null) {
      this._before = performance.now();
      this._frame = requestAnimationFrame(now => this._move(now));
    }
  }

  // Draw one frame, and request the next one while anything moves.
  _move(now) {
    const still = this._stillness.matches;
    const passed = Math.min(100, Math.max(0, now - this._before));
    const part = still ? 1 : 1 - Math.exp(-passed / Math.max(1, this.glide));
    this._before = now;
    let moves = false;
    const glide = (from, to) => {
      const next = from + (to - from) * part;
      moves ||= Math.abs(to - next) > ARRIVED;
      return Math.abs(to - next) > ARRIVED ? next : to;
    };
    Object.keys(REST).forEach(name => {
      this._now[name] = glide(this._now[name], this._aim[name]);
    });
    this._now.pose = this._now.pose.map((angle, at) => glide(angle, this._aim.pose[at]));
    if (!still) {
      this._steps += (passed / 1000) * this._pace * STEPS_PER_M * (this._now.stride > 0 ? 1 : 0);
      moves ||= this._now.stride > 0 || now - this._since.beat < BEAT_MS || now - this._since.touch < FLINCH_MS;
      moves ||= now - Math.max(this._since.nod, this._since.shake) < REPLY_MS;
    }
    this._draw(now);
    this._frame = moves ? requestAnimationFrame(later => this._move(later)) : null;
  }

  _angles(now) {
    const {walk, flinch} = this._figure;
    const {stride, turn, look, pose} = this._now;
    let angles = pose;
    if (stride > 0) {
      const place = (((this._steps / 2) % 1) + 1) % 1 * walk.poses.length;
      const step = this._stillness.matches ? 2 : Math.floor(place);
      const next = walk.poses[(step + 1) % walk.poses.length];
      angles = between(angles, between(walk.poses[step], next, place % 1), stride);
    }
    const touched = (now - this._since.touch) / FLINCH_MS;
    if (touched >= 0 && touched < 1 && !this._stillness.matches) {
      angles = between(angles, flinch, Math.sin(Math.PI * Math.sqrt(touched)));
    }
    const shaken = SHAKES * this._swing('shake', now, 3);
    return angles.map((angle, at) => angle + (at === 0 ? look + shaken : at === 1 ? 0.12 * turn : 0));
  }

  // Swing back and forth around 0, `times` times, with decreasing amplitude. Return 0 afterward.
  _swing(effect, now, times) {
    const part = (now - this._since[effect]) / REPLY_MS;
    return part >= 0 && part < 1 && !this._stillness.matches ? Math.sin(2 * Math.PI * times * part) * (1 - part) : 0;
  }

  _draw(now) {
    const {turns, touching, ground, size, sway, glance} = this._figure;
    const angles = this._angles(now);
    const dip = DIP * Math.abs(this._swing('nod', now, 1));
    const matrices = new Map();
    this._chains.forEach((joints, name) => {
      const matrix = joints.reduce((before, joint) => {
        const [index, factor, x, y] = turns[joint];
        const [a, b, c, d, e, f] = turned(before, factor * angles[index], x, y);
        return joint === 'neck' ? [a, b, c, d, e + c * dip, f + d * dip] : [a, b, c, d, e, f];
      }, [1, 0, 0, 1, 0, 0]);
      matrices.set(name, matrix);
    });
    const deep = ({joints, at, reach}) => applied(matrices.get(joints.join()), at)[1] + reach;
    const up = ground - Math.max(...touching.map(deep));
    const aside = sway * Math.sin(angles[1]);
    const {tilt} = this._now;
    const [middle, lean] = [size[0] / 2, (tilt * 180) / Math.PI];
    const beyond = Math.max(0, Math.abs(tilt) - UPRIGHT_TO) / (MOST_TILT - UPRIGHT_TO);
    const slip = -Math.sign(tilt) * SLIPS * beyond;
    this._body.setAttribute('transform', `translate(${slip} ${-LIES_HIGH * beyond}) rotate(${lean} ${middle} ${ground}) translate(${aside} ${up})`);
    const height = ([upper, lower], side) => {
      const outward = angles[upper] - side * angles[1];
      return -glance.arm[0] * Math.cos(outward) - glance.arm[1] * Math.cos(outward + angles[lower]);
    };
    const [left, right] = [height([2, 3], 1), height([4, 5], -1)];
    const eyes = [glance.most[0] * Math.tanh((left - right) / glance.reach), glance.most[1] * Math.max(0, Math.tanh(Math.max(left, right) / glance.reach))];
    this._parts.forEach(part => {
      const [a, b, c, d, e, f] = matrices.get(part.joints.join());
      const [x, y] = part.glance ? [part.glance[0] * eyes[0], -part.glance[1] * eyes[1]] : [0, 0];
      part.node.setAttribute('transform', `matrix(${a} ${b} ${c} ${d} ${a * x + c * y + e} ${b * x + d * y + f})`);
    });
    this._drawShadow(matrices, aside, up);
    this._level.setAttribute('width', (this._fullWidth * this._now.charge) / 100);
    const beat = (now - this._since.beat) / BEAT_MS;
    const beats = beat >= 0 && beat < 1 && !this._stillness.matches;
    this._signs.heart.setAttribute('opacity', beats ? 1 - beat : this._stillness.matches ? 1 : 0);
    this._signs.heart.firstChild.setAttribute('rx', beats ? 20 + 14 * beat : 21);
    this._signs.heart.firstChild.setAttribute('ry', beats ? 20 + 14 * beat : 21);
  }

  _drawShadow(matrices, aside, up) {
    const {touching, ground, size} = this._figure;
    const of = (wanted) => touching.filter(({joints, reach}) => wanted(joints.join(), reach));
    const xs = of((name, reach) => /knee$/.test(name) && reach > 0).map(({joints, at}) => applied(matrices.get(joints.join()), at)[0]);
    const lowest = Math.max(...of(name => /ankle$/.test(name)).map(({joints, at}) => applied(matrices.get(joints.join()), at)[1]));
    const fade = Math.max(0.35, 1 - Math.max(0, ground - lowest - up) / 200);
    const [from, to] = [Math.min(...xs), Math.max(...xs)];
    const reach = ((to - from) / 2 + 44) * fade;
    const drawn = {cx: (from + to) / 2 + aside, rx: reach, ry: reach / 10, opacity: 0.28 * fade};
    Object.entries(drawn).forEach(([name, value]) => this._shadow.setAttribute(name, value));
  }
}

// A robot and its surroundings: a second robot that shows the encoders' measurements, and the words below both. The
// camera's image has boxes around the detected objects, and each topic that no robot shows has a sparkline. The panel
// and the robots in cells use such stages. This file needs only a document.
const SVG = 'http://www.w3.org/2000/svg';
const MOST_LINES = 4;
const WIDE = 120;
const HIGH = 24;
const RAW_GLIDE_MS = 15; // short, so that the trembling stays visible
const MEASURED = 'a humanoid robot with twelve joints, as its encoders measure it';

export const draw = (name, attributes, ...children) => {
  const element = document.createElementNS(SVG, name);
  Object.entries(attributes).forEach(([key, value]) => element.setAttribute(key, value));
  element.append(...children);
  return element;
};
export const make = (name, attributes = {}, ...children) => {
  const element = document.createElement(name);
  Object.entries(attributes).forEach(([key, value]) => element.setAttribute(key, value));
  element.append(...children);
  return element;
};

// Split a name before each / and after each _. A name may wrap only there.
export const parts = name => name.split(/(?=\/)|(?<=_)/);
export const breakable = name =>
  parts(name).flatMap((part, at) => (at ? [document.createElement('wbr'), part] : [part]));

export const sparkline = numbers => {
  const [least, most] = [Math.min(...numbers), Math.max(...numbers)];
  const y = value => (most > least ? HIGH - 2 - ((HIGH - 4) * (value - least)) / (most - least) : HIGH / 2);
  const points = numbers.map((value, at) => `${((WIDE * at) / (numbers.length - 1)).toFixed(1)},${y(value).toFixed(1)}`);
  const label = `the last ${numbers.length} values, from ${least} to ${most}`;
  const line = draw('polyline', {points: points.join(' '), class: 'workbook-spark-line'});
  return draw('svg', {viewBox: `0 0 ${WIDE} ${HIGH}`, class: 'workbook-spark', role: 'img', 'aria-label': label}, line);
};

export class Stage {
  // `makeRobot` loads a new robot. It's called for the first update.
  constructor(makeRobot) {
    this._make = makeRobot;
    this._robots = {main: null, raw: null};
    this._coming = {};
    this._figure = make('div', {class: 'workbook-robot'});
    this._raw = make('div', {class: 'workbook-robot'});
    this._rawPart = make('figure', {hidden: ''}, this._raw, make('figcaption', {}, 'as measured'));
    this._caption = make('figcaption', {hidden: ''}, 'the robot');
    this._words = make('p', {class: 'workbook-words'});
    this._frame = draw('image', {width: '100%', height: '100%'});
    this._boxes = draw('g', {});
    this._picture = draw('svg', {class: 'workbook-camera', role: 'img'}, this._frame, this._boxes);
    this._view = make('div', {class: 'workbook-view', hidden: ''}); // empty until there is an image
    this._lines = make('div', {class: 'workbook-lines'});
    const main = make('figure', {}, this._figure, this._caption);
    const side = make('div', {class: 'workbook-robots'}, this._rawPart, main, this._view);
    this.node = make('div', {class: 'workbook-stage'}, side, this._words, this._lines);
    this._seen = {image: null, boxes: null};
  }

  get robot() {
    return this._robots.main;
  }

  // Return the robot in a part of the stage (main or raw). Load it first if necessary.
  async bring(part = 'main') {
    if (!this._robots[part]) {
      this._coming[part] ||= this._make();
      const coming = this._coming[part];
      coming.catch(() => {
        this._coming[part] = null; // the next message tries again
      });
      const robot = await coming;
      if (!this._robots[part]) {
        this._robots[part] = robot;
        (part === 'main' ? this._figure : this._raw).replaceChildren(robot.node);
      }
    }
    return this._robots[part];
  }

  // Clear the stage until it receives data about the robot.
  reset() {
    Object.values(this._robots).forEach(robot => robot && robot.reset());
    this._words.textContent = '';
    this._lines.replaceChildren();
    this._showRaw(null);
    this._seen = {image: null, boxes: null};
    this._showView();
  }

  // Show an update from the stream, of the kind robot or news. Call bring() first.
  take(news) {
    if (news.kind === 'news') {
      this._showLines(news.topics);
      return;
    }
    const {words, image, boxes, raw, ...robot} = news;
    this.robot.take(robot);
    if (words !== undefined) {
      this._words.textContent = words;
    }
    if (raw !== undefined) {
      this._showRaw(raw);
    }
    if (image !== undefined || boxes !== undefined) {
      Object.assign(this._seen, image === undefined ? {} : {image}, boxes === undefined ? {} : {boxes});
      this._showView();
    }
  }

  async _showRaw(pose) {
    this._rawPose = pose;
    this._rawPart.hidden = this._caption.hidden = pose === null;
    if (pose !== null) {
      const robot = await this.bring('raw');
      if (this._rawPose === pose) {
        robot.glide = RAW_GLIDE_MS;
        robot.take({awake: true, pose, text: MEASURED});
      }
    }
  }

  _showView() {
    const {image, boxes} = this._seen;
    this._view.hidden = !image;
    if (!image) {
      return;
    }
    if (!this._view.firstChild) {
      this._view.append(this._picture);
    }
    this._frame.setAttribute('href', image.src);
    this._picture.setAttribute('viewBox', `0 0 ${image.width} ${image.height}`);
    const found = (boxes || []).map(([label]) => label);
    this._picture.setAttribute('aria-label', `the camera's image${boxes ? `, with boxes around: ${found.join(', ') || 'nothing'}` : ''}`);
    if (boxes !== this._drawn) {
      this._drawn = boxes;
      const size = image.width / 20;
      const marks = (boxes || []).flatMap(([label, x, y, width, height]) => [
        draw('rect', {x: x - width / 2, y: y - height / 2, width, height, class: 'workbook-box'}),
        draw('text', {x, y: Math.max(size, y - height / 2 - size / 4), 'font-size': size, class: 'workbook-label'}, label)
      ]);
      this._boxes.replaceChildren(...marks);
    }
  }

  _showLines(topics) {
    const shown = Object.entries(topics).filter(([, {numbers, reacts}]) => numbers && !reacts);
    const lines = shown.slice(0, MOST_LINES).map(([name, {numbers, value}]) => {
      const words = make('span', {}, ...breakable(name));
      return make('div', {}, words, sparkline(numbers), make('span', {}, value));
    });
    this._lines.replaceChildren(...lines);
  }
}

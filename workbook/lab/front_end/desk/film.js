// A film player with a button and a slider. The film plays once when it comes into view, but readers who prefer reduced
// motion have to start it. JupyterLab (desk.js) and the site (site.js) use this player, which needs only a document.
// If the browser can't split a film into frames, there's no slider, and the button shows a still instead.
const HEAD = /^data:image\/(?:png|webp);base64,((?:.{4}){1,400})/;
const MOVES = /acTL|ANIM/; // the chunk that only animated PNG and WebP files have
const stillness = window.matchMedia('(prefers-reduced-motion: reduce)');

const make = (tag, properties, ...children) => {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
};
const later = ms => new Promise(resolve => setTimeout(resolve, ms));

// Return whether an image embedded in the page (a data URL) is a film.
export const isFilm = image => MOVES.test(atob(HEAD.exec(image.src)?.[1] || ''));

// Return a film's frame count and `picture(at)`, which decodes one frame, or null without a decoder for the film.
const takeApart = async src => {
  const data = await fetch(src).then(answer => answer.blob());
  if (!('ImageDecoder' in window) || !(await ImageDecoder.isTypeSupported(data.type))) {
    return null;
  }
  const decoder = new ImageDecoder({data: await data.arrayBuffer(), type: data.type});
  await decoder.tracks.ready;
  await decoder.completed;
  const picture = async frameIndex => (await decoder.decode({frameIndex})).image;
  return {count: decoder.tracks.selectedTrack.frameCount, picture};
};

const firstPicture = image => {
  const canvas = make('canvas', {width: image.naturalWidth, height: image.naturalHeight});
  canvas.getContext('2d').drawImage(image, 0, 0);
  return canvas.toDataURL();
};

export class Film {
  constructor(image) {
    this.image = image;
    this.place = image.closest('picture') || image; // a <picture> has a still for reduced motion
    this.plays = !stillness.matches;
    this.inSight = false;
    this.run = 0; // go() increments this, which ends its earlier calls
    this.button = make('button', {type: 'button'});
    this.button.addEventListener('click', () => this.press());
    this.slider = make('input', {type: 'range', min: 0, max: 1, value: this.plays ? 0 : 1, hidden: true});
    this.slider.setAttribute('aria-label', 'Position in the film');
    this.slider.addEventListener('input', () => this.choose(Number(this.slider.value)));
    const controls = make('p', {className: 'wb-controls'}, this.button, this.slider);
    controls.addEventListener('keydown', event => event.stopPropagation()); // the notebook must not handle these keys
    const frame = make('div', {className: 'wb-film'});
    this.place.replaceWith(frame);
    frame.append(this.place, controls);
    this.say();
    const seen = async entries => {
      this.inSight = entries[entries.length - 1].isIntersecting;
      if (this.inSight) {
        await (this.loading ||= this.load());
      }
      this.go();
    };
    new IntersectionObserver(seen, {threshold: 0.5}).observe(frame);
  }

  async load() {
    this.parts = await takeApart(this.image.src).catch(() => null);
    if (!this.parts) {
      const source = this.place.querySelector('source');
      this.moving = this.image.src;
      this.still = source?.srcset || this.image.dataset.still || firstPicture(this.image);
      source?.remove();
      return;
    }
    this.last = this.parts.count - 1;
    this.at = this.plays ? 0 : this.last; // like a still, the last frame shows the whole sequence
    Object.assign(this.slider, {max: this.last, value: this.at, hidden: false});
    this.canvas = make('canvas', {role: 'img', ariaLabel: this.image.alt, className: this.image.className});
    this.canvas.style.width = `${this.image.getAttribute('width')}px`;
    if (this.plays || this.place === this.image) {
      await this.draw();
    }
  }

  // Draw the current frame. Return its duration (ms).
  async draw() {
    const {at} = this;
    const picture = await this.parts.picture(at);
    const shown_ms = (picture.duration || 100000) / 1000;
    if (at === this.at) {
      Object.assign(this.canvas, {width: picture.displayWidth, height: picture.displayHeight});
      this.canvas.getContext('2d').drawImage(picture, 0, 0);
      this.slider.value = at;
      this.place.replaceWith(this.canvas);
    }
    picture.close();
    return shown_ms;
  }

  // Play to the end, but only while the film is in view.
  async go() {
    const run = (this.run += 1);
    const goes = () => run === this.run && this.plays && this.inSight;
    this.say();
    while (this.parts && goes()) {
      const shown_ms = await this.draw();
      if (goes() && this.at === this.last) {
        this.plays = false;
      } else {
        await later(shown_ms);
        this.at += goes() ? 1 : 0;
      }
    }
    this.say();
  }

  press() {
    this.plays = !this.plays;
    if (this.plays && this.at === this.last) {
      this.at = 0;
    }
    this.go();
  }

  choose(at) {
    this.plays = false;
    this.at = at;
    this.draw();
    this.go();
  }

  say() {
    const ended = this.parts && this.at === this.last;
    const pause = this.still ? 'Stop' : 'Pause';
    this.button.textContent = this.plays ? pause : ended ? '↻ Replay' : 'Play';
    const src = this.plays ? this.moving : this.still;
    if (this.still && this.image.getAttribute('src') !== src) {
      this.image.src = src;
    }
  }
}

// Animates the site. The robot comes from the front end (rig.js) and plays recordings of the lessons' programs. The
// site doesn't run programs, so predictions and films also show recordings. Without this script, every page is still
// readable.
import {Film} from './film.js';

const GLIDES = 4; // as in workbook/lesson/robot_in_cell.py
const REST_MS = 1500;
const MOST_RESULTS = 30;

const once = make => {
  let made;
  return (...given) => (made ||= make(...given));
};
const loaded = once(async root => {
  const [{Robot}, figure] = await Promise.all([
    import('./rig.js'),
    fetch(`${root}_static/figure.json`).then(answer => answer.json())
  ]);
  return () => new Robot(figure);
});

// A robot, and the recording that moves it in a loop while it's in view.
class Player {
  constructor(node) {
    this._node = node;
    this._root = node.dataset.root;
    this._names = node.dataset.recordings.split(' ');
    this._button = node.querySelector('.wb-play');
    this._words = node.querySelector('.wb-words');
    this._slider = node.querySelector('input');
    this._at = Number(this._slider?.value || 0);
    this._plays = !window.matchMedia('(prefers-reduced-motion: reduce)').matches;
    this._inSight = false;
    this._timer = null;
    this._button.addEventListener('click', () => {
      this._plays = !this._plays;
      this._go();
    });
    this._slider?.addEventListener('input', () => this._choose());
    new IntersectionObserver(entries => {
      this._inSight = entries[entries.length - 1].isIntersecting;
      this._go();
    }).observe(node);
    this._say();
  }

  _choose() {
    this._at = Number(this._slider.value);
    const value = this._slider.dataset.values.split(' ')[this._at];
    this._node.querySelector('output').textContent = value;
    this._slider.setAttribute('aria-valuetext', value);
    this._plays = true;
    this._stop();
    this._go();
  }

  _say() {
    this._button.textContent = this._plays ? 'Pause' : 'Play';
  }

  _stop() {
    clearTimeout(this._timer);
    this._timer = null;
  }

  async _go() {
    this._say();
    if (!this._inSight || !this._plays) {
      this._stop();
      return;
    }
    if (this._timer !== null) {
      return;
    }
    this._timer = 0;
    const at = this._at;
    try {
      const makeRobot = await loaded(this._root);
      const recording = await fetch(`${this._root}_static/recordings/${this._names[at]}.json`).then(answer => answer.json());
      if (!this._robot) {
        this._robot = makeRobot();
        this._node.querySelector('.wb-stage').replaceChildren(this._robot.node);
      }
      if (this._timer === 0 && at === this._at) {
        this._play(recording);
      }
    } catch (error) {
      this._plays = false;
      this._say();
      this._words.textContent = 'This recording could not be loaded.';
    }
  }

  _play({seconds, events}) {
    const began = performance.now();
    let next = 0;
    this._robot.reset();
    this._robot.glide = Math.max(1, (1000 * Number(this._node.dataset.ease)) / GLIDES);
    this._robot.take({awake: true, text: 'a humanoid robot, moved by a recording'});
    const step = () => {
      const passed = (performance.now() - began) / 1000;
      const news = {};
      while (next < events.length && events[next][0] <= passed) {
        const [, effect, value] = events[next];
        news[effect] = value;
        next += 1;
      }
      if (Object.keys(news).length) {
        this._robot.take(news);
      }
      this._words.textContent = `${Math.min(passed, seconds).toFixed(0)} of ${seconds} s`;
      const wait = next < events.length ? Math.min(1000, 1000 * (events[next][0] - passed)) : 1000 * (seconds - passed);
      if (passed >= seconds) {
        this._timer = setTimeout(() => this._play({seconds, events}), REST_MS);
      } else {
        this._timer = setTimeout(step, Math.max(10, wait));
      }
    };
    step();
  }
}

// A choice shows the recorded run's outcome and disables the buttons. This browser stores the choices.
const told = sealed => JSON.parse(new TextDecoder().decode(Uint8Array.from(atob(sealed), letter => letter.charCodeAt(0))));

const kept = {
  read: name => {
    try {
      return localStorage.getItem(`prediction-${name}`);
    } catch {
      return null;
    }
  },
  write: (name, letter) => {
    try {
      localStorage.setItem(`prediction-${name}`, letter);
    } catch {
      // In private windows, storing may fail.
    }
  }
};

const outcomes = name => [...document.querySelectorAll('.wb-outcome')].filter(one => one.dataset.prediction === name);

const sealCell = (outcome, sealed) => {
  outcome.closest('.cell_output')?.classList.toggle('wb-sealed', sealed);
};

const reveal = (name, letter) => {
  for (const outcome of outcomes(name)) {
    const {happened, html} = told(outcome.dataset.sealed);
    const words = document.createElement('p');
    words.className = 'wb-yours';
    words.textContent = letter === happened ? `✓ You predicted ${letter}. Well done.` : `✗ You predicted ${letter}, but ${happened} happened.`;
    const told_ = document.createElement('div');
    told_.innerHTML = html;
    outcome.replaceChildren(words, told_);
    sealCell(outcome, false);
  }
};

const ask = node => {
  const name = node.dataset.prediction;
  const status = node.querySelector('.wb-status');
  const choose = (letter, again) => {
    node.querySelectorAll('button').forEach(button => {
      button.setAttribute('aria-pressed', String(button.dataset.letter === letter));
      button.disabled = true;
    });
    kept.write(name, letter);
    status.textContent = outcomes(name).length
      ? `Your prediction: ${letter}. ${again ? 'You made it on an earlier visit. ' : ''}The outcome of the recorded run is shown below.`
      : `Your prediction: ${letter}. Read on to see what happens.`;
    reveal(name, letter);
  };
  outcomes(name).forEach(outcome => sealCell(outcome, true));
  node.querySelectorAll('button').forEach(button => button.addEventListener('click', () => choose(button.dataset.letter, false)));
  const earlier = kept.read(name);
  if (earlier && node.querySelector(`[data-letter="${CSS.escape(earlier)}"]`)) {
    choose(earlier, true);
  }
};

// Sphinx's search finds only pages that have every word. But a pasted error contains words from the reader's program:
// paths, names, and numbers. So weight each word by its rarity, and require half of the total weight.
const filesOf = (index, word) => [].concat(Object.hasOwn(index, word) ? index[word] : []);

const ranked = words => {
  const {terms, titleterms, docnames, titles, filenames} = Search._index;
  const scores = new Map();
  let whole = 0;
  words.forEach(word => {
    const inText = new Set(filesOf(terms, word));
    const inTitle = new Set(filesOf(titleterms, word));
    const found = new Set([...inText, ...inTitle]);
    const weight = found.size ? Math.log(1 + docnames.length / found.size) : 0;
    whole += weight;
    found.forEach(file => scores.set(file, (scores.get(file) || 0) + weight * (inTitle.has(file) ? 1.5 : 1)));
  });
  return [...scores]
    .filter(([, score]) => score >= whole / 2)
    .sort(([, one], [, other]) => other - one)
    .slice(0, MOST_RESULTS)
    .map(([file, score]) => [docnames[file], titles[file], '', null, Math.round((100 * score) / whole), filenames[file], 'text']);
};

if (typeof Search !== 'undefined') {
  Search.performTermsSearch = words => ranked([...words]);
}
// The theme has two landmarks of the same kind, so give them names.
document.querySelector('.sidebar-drawer')?.setAttribute('aria-label', 'The site');
document.querySelector('.toc-drawer')?.setAttribute('aria-label', 'This page');
document.querySelectorAll('.wb-predict').forEach(ask);
document.querySelectorAll('.wb-robot').forEach(node => new Player(node));
document.querySelectorAll('.wb-film').forEach(image => new Film(image));
// Wide outputs and tables scroll, so the keyboard must be able to reach them.
const markScrolling = () => {
  document.querySelectorAll('.highlight pre, .table-wrapper, .cell_output').forEach(node => {
    node.tabIndex = node.scrollWidth > node.clientWidth ? 0 : -1;
  });
};
window.addEventListener('resize', markScrolling);
markScrolling();

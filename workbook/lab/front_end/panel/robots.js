// Creates robots, including the one that waves when the home page or a lesson opens.
import {Robot} from './rig.js';

const RAISED = [4, 2.7]; // a joint's index, and its angle (rad) while the arm waves
const WAVES = [5, [0.5, -0.35, 0.5, -0.35, 0.5, -0.35]];
const WAVE_MS = 350;

// Load the shapes once, when the first robot needs them.
let shapes = null;
const readFigure = () => {
  shapes ||= fetch(new URL('figure.json', import.meta.url)).then(answer => answer.json());
  shapes.catch(() => {
    shapes = null; // the next robot tries again
  });
  return shapes;
};

export const makeRobot = async () => new Robot(await readFigure());

const later = ms => new Promise(resolve => setTimeout(resolve, ms));

// A robot that can wave. If it can't be loaded, its place stays empty.
export class Greeter {
  constructor() {
    this.node = document.createElement('div');
    this.waving = false;
    this.stillness = window.matchMedia('(prefers-reduced-motion: reduce)');
    this.ready = this.load();
  }

  async load() {
    const figure = await readFigure();
    this.rest = figure.neutral;
    this.robot = new Robot(figure);
    this.node.append(this.robot.node);
  }

  take(news) {
    this.ready.then(() => this.robot.take({awake: true, ...news}), () => undefined);
  }

  // With reduced motion, the robot just holds its hand up.
  async wave() {
    await this.ready.catch(() => undefined);
    if (!this.robot || this.waving) {
      return;
    }
    this.waving = true;
    const pose = [...this.rest];
    pose[RAISED[0]] = RAISED[1];
    for (const angle of WAVES[1].slice(0, this.stillness.matches ? 1 : WAVES[1].length)) {
      pose[WAVES[0]] = angle;
      this.robot.take({pose: [...pose]});
      await later(WAVE_MS);
    }
    if (!this.stillness.matches) {
      this.robot.take({pose: null});
    }
    this.waving = false;
  }
}

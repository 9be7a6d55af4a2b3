// The robot on a check's card. The output's HTML is rendered as usual, and then the robot replaces the still in it.
// While the judge watches, updates from the kernel move the robot. With full marks, it replays a part of the recording
// when it comes into view, and again on a click. The kernel's side is workbook/magics/robot_on_card.py.
export const CHECK = 'application/vnd.rclpy-workbook.check+json';

export const defineCheckRobot = (Widget, htmlRendererFactory, makeRobot) =>
  class CheckRobot extends Widget {
    constructor(options) {
      super();
      this.addClass('workbook-check');
      this._options = {...options, mimeType: 'text/html'};
      this._stillness = window.matchMedia('(prefers-reduced-motion: reduce)');
      this._place = document.createElement('div');
      this._place.className = 'workbook-robot';
      this._words = document.createElement('p');
      this._words.className = 'workbook-words';
      this._again = document.createElement('button');
      this._again.type = 'button';
      this._again.textContent = '↻ Replay';
      this._again.hidden = true;
      [this._place, this._again].forEach(one => one.addEventListener('click', () => this._play()));
      this._played = '';
      this._sight = new IntersectionObserver(entries => {
        this._inSight = entries[entries.length - 1].isIntersecting;
        this._playFirst();
      });
    }

    // The card never waits for the robot. `news` updates the robot right away. `replay` lists events with times (ms).
    async renderModel(model) {
      const source = String(model.data['text/html'] || '');
      if (source !== this._source) {
        this._source = source;
        const html = htmlRendererFactory.createRenderer(this._options);
        await html.renderModel(model);
        if (source !== this._source || this.isDisposed) {
          html.dispose();
          return;
        }
        this._mount(html.node);
        this.node.replaceChildren(html.node);
        this._html && this._html.dispose();
        this._html = html;
      }
      const {news, replay, glide} = model.data[CHECK];
      this._replay = replay || null;
      this._again.hidden = !replay;
      if (!news && !replay) {
        return;
      }
      this._coming ||= makeRobot();
      let robot = null;
      try {
        robot = await this._coming;
      } catch (error) {
        this._coming = null; // the card stays unchanged, and the next update tries again
        return;
      }
      if (!this._robot) {
        this._robot = robot;
        this._place.append(robot.node);
        this._mount(this.node);
      }
      if (news && !this._replay) {
        robot.glide = glide;
        this._take(news);
      }
      this._playFirst();
    }

    onAfterAttach() {
      this._sight.observe(this._place);
    }

    onBeforeDetach() {
      this._sight.disconnect();
      clearTimeout(this._next);
    }

    // Replace the still with the robot.
    _mount(node) {
      const figure = node.querySelector('.workbook-figure');
      if (figure && this._robot) {
        figure.replaceChildren(this._place, this._again, this._words);
      }
    }

    _take(news) {
      this._robot.take(news);
      this._words.textContent = news.words === undefined ? this._words.textContent : news.words;
    }

    // Play each recording once, when it comes into view. With reduced motion, show only its final state.
    _playFirst() {
      const told = JSON.stringify(this._replay);
      if (!this._replay || !this._robot || !this._inSight || told === this._played) {
        return;
      }
      this._played = told;
      if (!this._stillness.matches) {
        this._play();
        return;
      }
      const end = Object.assign({}, ...this._replay.events.map(([, news]) => news));
      this._robot.moments.forEach(moment => delete end[moment]);
      this._robot.reset();
      this._take(end);
    }

    _play() {
      if (!this._replay) {
        return;
      }
      const {events, glide} = this._replay;
      clearTimeout(this._next);
      this._robot.reset();
      this._robot.glide = glide;
      this._words.textContent = '';
      const began = performance.now();
      const step = from => {
        let at = from;
        for (; at < events.length && events[at][0] <= performance.now() - began; at += 1) {
          this._take(events[at][1]);
        }
        if (at < events.length) {
          this._next = setTimeout(step, events[at][0] - (performance.now() - began), at);
        }
      };
      step(0);
    }
  };

// The robot in a cell, which looks like the panel's. Below %start, messages from the notebook's programs move it while
// it's in view, and it sleeps once its program has been stopped. Below `watch_robot`, the kernel sends its poses.
// The kernel's side is workbook/lesson/robot_in_cell.py.
export const TYPE = 'application/vnd.rclpy-workbook.robot+json';

export const defineCellRobot = (Widget, stream, makeStage) =>
  class CellRobot extends Widget {
    constructor() {
      super();
      this.addClass('workbook-cell-robot');
      this._stage = makeStage();
      this.node.append(this._stage.node);
      this._kernel = null;
      this._inSight = false;
      this._sight = new IntersectionObserver(entries => {
        this._inSight = entries[entries.length - 1].isIntersecting;
        stream.look();
      });
    }

    // `kernel` is the ID of the robot's kernel; null once the program has been stopped. `news` is an update from the
    // kernel itself, and `glide` is the time constant (ms) with which the robot then approaches a pose.
    async renderModel(model) {
      const {kernel, news, glide} = model.data[TYPE];
      const robot = await this._stage.bring();
      this._kernel = kernel;
      if (news) {
        robot.glide = glide;
        this.take({kind: 'robot', ...news});
      } else if (kernel === null) {
        this._rest();
      }
      stream.look();
    }

    onAfterAttach() {
      this._sight.observe(this.node);
      stream.add(this);
    }

    onBeforeDetach() {
      this._sight.disconnect();
      this._inSight = false;
      stream.remove(this);
    }

    wants(kernel) {
      return Boolean(this._stage.robot) && this._inSight && this._kernel === kernel;
    }

    opened() {
      this._rest();
    }

    say() {}

    take(news) {
      if (news.kind === 'domain') {
        this._rest();
      } else if (news.kind === 'robot' || news.kind === 'news') {
        this._stage.take(news);
      }
    }

    _rest() {
      this._stage.reset();
    }
  };

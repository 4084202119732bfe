// Cameras: from where a body in space is seen, without perspective. Lengths are in parts of the size of the body.

const RIGHT_ANGLE = Math.PI / 2;

// Turns around y, and above; the first sees the sides to the right, above and in front under equal angles.
const VIEWS = {
  all: [RIGHT_ANGLE / 2, Math.atan(Math.SQRT1_2)],
  front: [0, 0], back: [2 * RIGHT_ANGLE, 0], left: [-RIGHT_ANGLE, 0], right: [RIGHT_ANGLE, 0],
  top: [0, RIGHT_ANGLE], bottom: [0, -RIGHT_ANGLE],
};
// Room for the numbers around the body, pixels.
const ROOM = [58, 40];

// To the right, upwards, and towards who looks.
function axesOf([around, above]) {
  const [s, c, t, d] = [Math.sin(around), Math.cos(around), Math.sin(above), Math.cos(above)];
  return [[c, 0, -s], [-s * t, d, -c * t], [s * d, t, c * d]];
}

const dotted = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

class Camera {
  constructor() {
    this.look('all');
  }

  // One of the views, so that all of the body is seen.
  look(name) {
    this.angles = [...VIEWS[name]];
    this.fitted = axesOf(this.angles);
    this.shift = [0, 0];
    this.zoom = 1;
  }

  turn(across, down) {
    this.angles = [this.angles[0] - across, clamp(this.angles[1] + down, -RIGHT_ANGLE, RIGHT_ANGLE)];
  }

  // By pixels of the canvas.
  move(across, down) {
    this.shift = [this.shift[0] + across / this.scale, this.shift[1] - down / this.scale];
  }

  // Nearer by a factor; what is at a pixel stays there.
  magnify(factor, x, y) {
    const zoom = clamp(this.zoom * factor, 0.2, 200);
    const away = [x - this.middle[0], this.middle[1] - y].map((pixels) => pixels / this.scale);
    const share = this.zoom / zoom;
    this.shift = this.shift.map((shift, k) => shift + away[k] * (share - 1));
    this.zoom = zoom;
    this.scale /= share;
  }

  // Takes the size of a canvas in pixels, and the half sides of a box around the origin, to see.
  within(width, height, half) {
    const reach = [0, 1].map((k) => 2 * half.reduce((sum, side, c) => sum + side * Math.abs(this.fitted[k][c]), 0));
    const fit = Math.min((width - 2 * ROOM[0]) / reach[0], (height - 2 * ROOM[1]) / reach[1]);
    this.scale = fit * this.zoom;
    this.middle = [width / 2, height / 2];
    this.axes = axesOf(this.angles);
  }

  // A place in pixels, and how near it is.
  to(at) {
    const [right, up, near] = [dotted(this.axes[0], at), dotted(this.axes[1], at), dotted(this.axes[2], at)];
    return [this.middle[0] + this.scale * (right + this.shift[0]), this.middle[1] - this.scale * (up + this.shift[1]), near];
  }
}

// The box around a body that has not moved: its edges, the coordinates at their ends, and the directions of the axes.

const CORNERS = [0, 1, 2, 3, 4, 5, 6, 7].map((n) => [n & 1, (n >> 1) & 1, n >> 2]);

class Box {
  // From its smallest to its largest coordinates, drawn in parts of `unit.size` from `unit.middle`.
  constructor(low, high, unit, length) {
    Object.assign(this, { low, high, length });
    const place = (corner) => corner.map((end, c) => ((end ? high : low)[c] - unit.middle[c]) / unit.size);
    this.corners = CORNERS.map(place);
    this.middle = place([0, 0, 0]).map((at, c) => (at + place([1, 1, 1])[c]) / 2);
    // Edges along each axis, as numbers of corners.
    this.edges = [0, 1, 2].map((axis) => CORNERS.flatMap((corner, n) => (corner[axis] ? [] : [[n, n + (1 << axis)]])));
  }

  // The edges; not those of the nearest corner, which stand before the body.
  lines(camera) {
    const nearness = this.corners.map((corner) => camera.to(corner)[2]);
    const nearest = nearness.indexOf(Math.max(...nearness));
    const behind = this.edges.flat().filter((edge) => !edge.includes(nearest));
    return behind.map((edge) => edge.map((n) => this.corners[n]));
  }

  // The edge along an axis that has its numbers: the lowest one, of upright ones that on the left.
  outer(axis, camera) {
    const ends = this.edges[axis].map((edge) => edge.map((n) => camera.to(this.corners[n])));
    const [[a, b]] = ends;
    const isUpright = Math.abs(a[1] - b[1]) > Math.abs(a[0] - b[0]);
    const outside = ([p, q]) => (isUpright ? -p[0] - q[0] : p[1] + q[1]);
    return ends.reduce((best, edge) => (outside(edge) > outside(best) + 0.5 ? edge : best));
  }

  // Numbers and names along the edges. A text that would lie on another is left out, such as where an edge points at who looks.
  label(ctx, camera, width, height) {
    const taken = [];
    const [mx, my] = camera.to(this.middle);
    ctx.textBaseline = 'middle';
    ctx.textAlign = 'center';
    function write(text, x, y) {
      const half = ctx.measureText(text).width / 2;
      const isFree = taken.every((t) => Math.abs(t.x - x) > t.half + half + 6 || Math.abs(t.y - y) > 14);
      if (!isFree || x < half || x > width - half || y < 8 || y > height - 8) return;
      // Readable also over the body.
      ctx.strokeText(text, x, y);
      ctx.fillText(text, x, y);
      taken.push({ x, y, half });
    }
    [ctx.fillStyle, ctx.strokeStyle, ctx.lineWidth] = [color('faint'), color('paper'), 3];
    const along = [0, 1, 2].map((axis) => {
      const [a, b] = this.outer(axis, camera);
      const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
      const length = Math.hypot(dx, dy);
      const [x, y] = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
      const side = Math.sign(dy * (x - mx) - dx * (y - my)) || 1;
      return { axis, a, b, x, y, length, away: [(side * dy) / length, (-side * dx) / length] };
    });
    const long = along.filter(({ length }) => length > 30);
    const beside = (text, [x, y], [nx, ny], gap) => {
      const half = ctx.measureText(text).width / 2;
      write(text, x + nx * (gap + half * Math.abs(nx)), y + ny * gap);
    };
    long.forEach(({ axis, x, y, away }) => beside(this.length ? `${'xyz'[axis]} [${this.length}]` : 'xyz'[axis], [x, y], away, 14));
    long.forEach(({ axis, a, b, away }) => [[a, this.low], [b, this.high]].forEach(([at, of]) => beside(number(of[axis], 4), at, away, 12)));
  }
}

// The directions of the axes, in the lower left corner; not of one that points at who looks.
function triad(ctx, camera, height) {
  const [x, y, LENGTH] = [38, height - 38, 24];
  ctx.textAlign = 'center';
  ctx.textBaseline = 'middle';
  // Those that point away first.
  const order = [0, 1, 2].sort((a, b) => camera.axes[2][a] - camera.axes[2][b]);
  for (const axis of order) {
    const [dx, dy] = [camera.axes[0][axis], -camera.axes[1][axis]];
    if (Math.hypot(dx, dy) < 0.2) continue;
    ctx.strokeStyle = ctx.fillStyle = series([1, 2, 0][axis]);
    ctx.lineWidth = 2;
    line(ctx, [[x, y], [x + LENGTH * dx, y + LENGTH * dy]]);
    ctx.stroke();
    ctx.fillText('xyz'[axis], x + (LENGTH + 8) * dx, y + (LENGTH + 8) * dy);
  }
}

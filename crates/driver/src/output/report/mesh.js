// Bricks in space, and the sides of them that are seen.

// Numbers of bricks by their places in a box, and the bricks before each, by which `pack.rs` foretells it.
function bricks({ origin, sides, size, spans }) {
  const [columns, rows, layers] = size;
  const numbers = new Int32Array(columns * rows * layers).fill(-1);
  const count = spans.reduce((sum, length, k) => sum + (k % 2 ? length : 0), 0);
  const places = new Int32Array(count);
  let [at, next] = [0, 0];
  spans.forEach((length, k) => {
    if (k % 2) for (let place = at; place < at + length; place++) numbers[(places[next] = place)] = next++;
    at += length;
  });
  const cell = (k) => [places[k] % columns, Math.floor(places[k] / columns) % rows, Math.floor(places[k] / (columns * rows))];
  const number = (i, j, k) =>
    i < 0 || j < 0 || k < 0 || i >= columns || j >= rows || k >= layers ? -1 : numbers[(k * rows + j) * columns + i];
  const before = new Int32Array(3 * count);
  for (let k = 0; k < count; k++) {
    const [i, j, l] = cell(k);
    before.set([number(i - 1, j, l), number(i, j - 1, l), number(i - 1, j - 1, l)], 3 * k);
  }
  // The coordinate of a line of nodes; the last brick may be shorter.
  const line = (axis, node) => origin[axis] + sides[0][axis] * Math.min(node, size[axis] - 1) + (node < size[axis] ? 0 : sides[1][axis]);
  const centre = (k) => cell(k).map((place, axis) => (line(axis, place) + line(axis, place + 1)) / 2);
  return { size, count, cell, number, before, line, centre };
}

// The sides of a brick: axis, which end of it, and the step to the brick beside.
const SIDES = [0, 1, 2].flatMap((axis) => [0, 1].map((end) => [axis, end, [0, 1, 2].map((c) => (c === axis ? 2 * end - 1 : 0))]));

// The sides between bricks that are kept and what is not: four corners each, around, in parts of `unit.size` from `unit.middle`,
// how these move, and the brick. `cut` keeps the bricks below a line across an axis, or above it.
function surface(of, unit, u, cut) {
  const owners = [], base = [], moves = [];
  function kept(place) {
    if (of.number(place[0], place[1], place[2]) < 0) return false;
    return !cut || place[cut.axis] >= cut.line === cut.above;
  }
  // A corner moves with the mean of the bricks around it, also of those that are cut off.
  function corner(node) {
    const sum = [0, 0, 0];
    let found = 0;
    for (let n = 0; n < 8; n++) {
      const other = of.number(node[0] - (n & 1), node[1] - ((n >> 1) & 1), node[2] - (n >> 2));
      if (other < 0) continue;
      found++;
      for (let c = 0; c < 3; c++) sum[c] += u[c][other];
    }
    for (let c = 0; c < 3; c++) {
      base.push((of.line(c, node[c]) - unit.middle[c]) / unit.size);
      moves.push((sum[c] / found) * unit.stretch);
    }
  }
  const beside = [0, 0, 0];
  for (let k = 0; k < of.count; k++) {
    const cell = of.cell(k);
    if (!kept(cell)) continue;
    for (const [axis, end, step] of SIDES) {
      for (let c = 0; c < 3; c++) beside[c] = cell[c] + step[c];
      if (kept(beside)) continue;
      for (const around of AROUND) {
        const node = [...cell];
        node[axis] += end;
        node[(axis + 1) % 3] += around[0];
        node[(axis + 2) % 3] += around[1];
        corner(node);
      }
      owners.push(k);
    }
  }
  return { owners: Uint32Array.from(owners), base: Float32Array.from(base), moves: Float32Array.from(moves) };
}

// All corners in pixels, with how near they are.
function projected(mesh, camera, factor) {
  const to = new Float32Array(mesh.base.length);
  const at = [0, 0, 0];
  for (let k = 0; k < to.length; k += 3) {
    for (let c = 0; c < 3; c++) at[c] = mesh.base[k + c] + factor * mesh.moves[k + c];
    to.set(camera.to(at), k);
  }
  return to;
}

const TRIANGLES = [[3, 6], [6, 9]];

// The nearest side at a pixel; -1 if there is none.
function sideAt(to, x, y) {
  let [best, nearest] = [-1, -Infinity];
  for (let a = 0; a < to.length; a += 12) {
    if (Math.min(to[a], to[a + 3], to[a + 6], to[a + 9]) > x || Math.max(to[a], to[a + 3], to[a + 6], to[a + 9]) < x) continue;
    for (const [b, c] of TRIANGLES) {
      const [bx, by, cx, cy] = [to[a + b] - to[a], to[a + b + 1] - to[a + 1], to[a + c] - to[a], to[a + c + 1] - to[a + 1]];
      const twice = bx * cy - by * cx;
      const s = ((x - to[a]) * cy - (y - to[a + 1]) * cx) / twice;
      const t = (bx * (y - to[a + 1]) - by * (x - to[a])) / twice;
      if (!(s >= 0 && t >= 0 && s + t <= 1)) continue;
      const near = to[a + 2] + s * (to[a + b + 2] - to[a + 2]) + t * (to[a + c + 2] - to[a + 2]);
      if (near > nearest) [best, nearest] = [a / 12, near];
    }
  }
  return best;
}

// Cells of a map: where their corners are and go, what parts them, and which of them stand for the others.

// Corners of a cell, around from the lower left.
const AROUND = [[0, 0], [1, 0], [1, 1], [0, 1]];

// Corners of a cell at the ends of its right and its upper side, and those of the cell beyond.
const FACES = [[[1, 2], [0, 3]], [[3, 2], [0, 1]]];
// The state from which on a crack is there that was there before the first, and one that no body reaches.
const [GIVEN, NEVER] = [-1, 0x7fffffff];
// Arrows along the longer side of a body, about.
const ARROWS = 24;

// Cells in rows: their corners, the cells before each, their corners as they move, and the faces of cracks, in a state.
function inRows({ origin, sides: [along, up], size: [columns, rows], last, runs, torn }, grown) {
  const column = [], row = [];
  const numbers = new Int32Array(columns * rows).fill(-1);
  for (const [j, first, count] of runs) {
    for (let i = first; i < first + count; i++) {
      numbers[j * columns + i] = column.length;
      column.push(i);
      row.push(j);
    }
  }
  const at = (i, j) => (i < 0 || j < 0 || i >= columns || j >= rows ? -1 : numbers[j * columns + i]);
  const count = column.length;
  const before = new Int32Array(3 * count);
  const corners = new Float64Array(8 * count);
  const part = (k, size, end) => Math.min(k, size - 1 + end);
  for (let k = 0; k < count; k++) {
    const [i, j] = [column[k], row[k]];
    [at(i - 1, j), at(i, j - 1), at(i - 1, j - 1)].forEach((other, n) => (before[3 * k + n] = other));
    AROUND.forEach(([right, above], n) => {
      const [a, b] = [part(i + right, columns, last[0]), part(j + above, rows, last[1])];
      for (const c of [0, 1]) corners[8 * k + 2 * n + c] = origin[c] + a * along[c] + b * up[c];
    });
  }
  const since = new Int32Array(2 * count).fill(NEVER);
  grown.forEach(([cell, side, state]) => (since[2 * cell + side] = state));
  torn.forEach(([cell, side]) => (since[2 * cell + side] = GIVEN));
  // A corner moves with the mean of the cells around it that no crack parts from its own.
  function move(ux, uy, state) {
    const joined = (a, b, side) => (b >= 0 && since[2 * Math.min(a, b) + side] > state ? b : -1);
    const moved = new Float64Array(8 * count);
    for (let k = 0; k < count; k++) {
      for (let n = 0; n < 4; n++) {
        const [i, j] = [column[k] + 2 * AROUND[n][0] - 1, row[k] + 2 * AROUND[n][1] - 1];
        const [beside, over, across] = [joined(k, at(i, row[k]), 0), joined(k, at(column[k], j), 1), at(i, j)];
        const reached = across >= 0 && ((beside >= 0 && joined(beside, across, 1) >= 0) || (over >= 0 && joined(over, across, 0) >= 0));
        let [x, y, cells] = [ux[k], uy[k], 1];
        for (const other of [beside, over, reached ? across : -1]) {
          if (other >= 0) [x, y, cells] = [x + ux[other], y + uy[other], cells + 1];
        }
        [moved[8 * k + 2 * n], moved[8 * k + 2 * n + 1]] = [x / cells, y / cells];
      }
    }
    return moved;
  }
  // Both faces of what has grown after some state: cell and two of its corners.
  function faces(state, after) {
    return since.reduce((all, from, place) => {
      if (from > state || from <= after) return all;
      const [k, side] = [place >> 1, place & 1];
      const beyond = side ? at(column[k], row[k] + 1) : at(column[k] + 1, row[k]);
      all.push([k, ...FACES[side][0]]);
      if (beyond >= 0) all.push([beyond, ...FACES[side][1]]);
      return all;
    }, []);
  }
  // The four cells around every corner, from the lower left on, where none is parted from the next in a state.
  function squares(state) {
    const around = (k) => AROUND.map(([i, j]) => at(column[k] + i, row[k] + j));
    const whole = ([k, right, , above]) => [2 * k, 2 * k + 1, 2 * right + 1, 2 * above].every((side) => since[side] > state);
    return column.map((_, k) => around(k)).filter((all) => !all.includes(-1) && whole(all));
  }
  // Cells that have an arrow, and the length of the side of the square around one.
  function chosen() {
    const step = Math.ceil(Math.max(columns, rows) / ARROWS);
    const is = (k) => [column[k], row[k]].every((index) => index % step === step >> 1);
    return { own: column.map((_, k) => k).filter(is), room: step * Math.hypot(...along) };
  }
  return { count, before, corners, move, faces, squares, chosen };
}

// Squares of a list.
function inList({ x, y, side }) {
  const count = x.length;
  const before = Int32Array.from({ length: 3 * count }, (_, k) => (k % 3 ? -1 : k / 3 - 1));
  const corners = new Float64Array(8 * count);
  for (let k = 0; k < 8 * count; k++) {
    const cell = k >> 3;
    const away = AROUND[(k >> 1) & 3][k & 1] - 0.5;
    corners[k] = (k & 1 ? y : x)[cell] + away * side[cell];
  }
  const move = (ux, uy) => Float64Array.from({ length: 8 * count }, (_, k) => (k & 1 ? uy : ux)[k >> 3]);
  function chosen() {
    const step = Math.max(1, Math.ceil(count / ARROWS ** 2));
    return { own: x.map((_, k) => k).filter((k) => k % step === 0), room: Math.sqrt(step) * side[0] };
  }
  return { count, before, corners, move, faces: () => [], squares: () => [], chosen };
}

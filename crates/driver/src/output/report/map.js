// Maps: cells in the plane, coloured by a field, moved by a multiple of their displacements.

// Corners of a cell, around from the lower left.
const AROUND = [[0, 0], [1, 0], [1, 1], [0, 1]];

// Corners of a cell at the ends of its right and its upper side, and those of the cell beyond.
const FACES = [[[1, 2], [0, 3]], [[3, 2], [0, 1]]];
// The state from which on a crack is there that was there before the first, and one that no body reaches.
const [GIVEN, NEVER] = [-1, 0x7fffffff];

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
  return { count, before, corners, move, faces };
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
  return { count, before, corners, move, faces: () => [] };
}

// Where coordinates stand in a box of some width: `to` and the height that is needed. x and y alternate in `points`.
function view(lists, width, tallest) {
  const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
  for (const points of lists) {
    points.forEach((value, k) => {
      low[k & 1] = Math.min(low[k & 1], value);
      high[k & 1] = Math.max(high[k & 1], value);
    });
  }
  const size = [0, 1].map((k) => high[k] - low[k] || 1e-300);
  const scale = Math.min((width - 4) / size[0], tallest / size[1]);
  const left = (width - scale * size[0]) / 2;
  const height = scale * size[1];
  return { scale, height, x: (x) => left + scale * (x - low[0]), y: (y) => height + 2 - scale * (y - low[1]) };
}

// A box around corners, also where these move by the most of any state, but for pieces that fly off.
function reached(corners, { moves, fields }) {
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  corners.forEach((value, k) => {
    box[k & 1] = Math.min(box[k & 1], value);
    box[2 + (k & 1)] = Math.max(box[2 + (k & 1)], value);
  });
  const most = 0.2 * Math.hypot(box[2] - box[0], box[3] - box[1]);
  moves?.fields.forEach((k, c) => {
    const [low, high] = fields[k].range.map((end) => clamp(2 * moves.factor * end, -most, most));
    box[c] += Math.min(0, low);
    box[2 + c] += Math.max(0, high);
  });
  return box;
}

function map(figure, data) {
  const stage = new Stage(figure);
  const cells = data.cells.runs ? inRows(data.cells, data.grown) : inList(data.cells);
  const reach = reached(cells.corners, data);
  const choice = figure.querySelector('.field');
  const slider = figure.querySelector('.scale');
  // All states; the last one has its fields in the list of these.
  const shots = [...data.before, { ...data.state, packed: data.fields.map((field) => field.packed) }];
  const values = (shot, k) => unpack(shot.packed[k], cells.before);
  let shot = shots.at(-1), moved = null, shown = null, seen = null, corners = cells.corners;

  // Cells by the level of their colour.
  function levels(of) {
    const sorted = Array.from({ length: LEVELS }, () => []);
    shown.values.forEach((value, k) => sorted[level(of, value)].push(k));
    return sorted;
  }

  function quad(ctx, at, k) {
    ctx.moveTo(seen.x(at[8 * k]), seen.y(at[8 * k + 1]));
    for (let n = 2; n < 8; n += 2) ctx.lineTo(seen.x(at[8 * k + n]), seen.y(at[8 * k + n + 1]));
    ctx.closePath();
  }

  function fill(ctx, at, list, style) {
    if (!list.length) return;
    ctx.beginPath();
    list.forEach((k) => quad(ctx, at, k));
    ctx.fillStyle = ctx.strokeStyle = style;
    ctx.fill();
    // A thin border in the same colour hides the seams between cells.
    ctx.lineWidth = 1;
    ctx.stroke();
  }

  function draw() {
    if (!shown) return;
    const factor = slider ? Number(slider.value) * data.moves.factor : 0;
    if (slider) slider.nextElementSibling.value = factor ? `× ${number(factor, 3)}` : 'off';
    const ctx = stage.begin((width) => {
      seen = view([reach], width, clamp(0.75 * width, 260, 560));
      return seen.height + BAR + 14;
    });
    if (!ctx) return;
    ctx.save();
    ctx.beginPath();
    ctx.rect(0, 0, stage.width, seen.height + 4);
    ctx.clip();
    corners = factor ? cells.corners.map((at, k) => at + factor * moved[k]) : cells.corners;
    if (factor) fill(ctx, cells.corners, Array.from({ length: cells.count }, (_, k) => k), color('soft'));
    const of = data.fields[choice.value];
    levels(of).forEach((list, k) => fill(ctx, corners, list, css(tint(k))));
    cracks(ctx, factor);
    ctx.restore();
    bar(stage, ctx, of, seen.height + 14);
    [figure.dataset.ready, figure.dataset.state] = [choice.value, shown.state];
  }

  // Cracks as lines where nothing has moved, else as their faces; what has grown always as that.
  function cracks(ctx, factor) {
    const faces = cells.faces(shown.state, factor ? GIVEN - 1 : GIVEN);
    for (const [style, width] of [['#fff', 2.6], ['#333a44', 1.2]]) {
      ctx.beginPath();
      if (!factor) data.lines.forEach((points) => points.forEach(([x, y], k) => (k ? ctx.lineTo(seen.x(x), seen.y(y)) : ctx.moveTo(seen.x(x), seen.y(y)))));
      for (const [k, ...ends] of faces) {
        const [[ax, ay], [bx, by]] = ends.map((n) => [seen.x(corners[8 * k + 2 * n]), seen.y(corners[8 * k + 2 * n + 1])]);
        ctx.moveTo(ax, ay);
        ctx.lineTo(bx, by);
      }
      [ctx.strokeStyle, ctx.lineWidth] = [style, width];
      ctx.stroke();
    }
  }

  const middle = (at, k, c) => (at[8 * k + c] + at[8 * k + 4 + c]) / 2;

  // The cell whose centre is nearest to the pointer, if that is in it or next to it.
  function find(px, py) {
    if (px === null || !shown || !seen) return null;
    let [best, least] = [-1, Infinity];
    for (let k = 0; k < cells.count; k++) {
      const [dx, dy] = [seen.x(middle(corners, k, 0)) - px, seen.y(middle(corners, k, 1)) - py];
      if (dx * dx + dy * dy < least) [best, least] = [k, dx * dx + dy * dy];
    }
    const size = Math.hypot(corners[8 * best + 4] - corners[8 * best], corners[8 * best + 5] - corners[8 * best + 1]);
    if (Math.sqrt(least) > Math.max(4, 0.6 * size * seen.scale)) return null;
    const of = data.fields[choice.value];
    const place = ['x', 'y'].map((name, c) => `${name} ${measured(middle(cells.corners, best, c), data.length)}`);
    return { x: px, y: py, lines: [place.join(', '), worded(of, shown.values[best], shown.packed)] };
  }

  // Shows the chosen field of a state, unless another one has been chosen before it is unpacked.
  async function choose() {
    const [chosen, of] = [choice.value, shot];
    const isNew = data.moves && shown?.state !== of.state;
    const [own, ...u] = await Promise.all([chosen, ...(isNew ? data.moves.fields : [])].map((k) => values(of, k)));
    if (choice.value !== chosen || shot !== of) return;
    if (isNew) moved = cells.move(...u, of.state);
    shown = { values: own, packed: of.packed[chosen], state: of.state };
    draw();
  }

  choice.addEventListener('change', choose);
  slider?.addEventListener('input', draw);
  stage.listen(find);
  if (shots.length > 1) {
    runThrough(figure, shots, (next) => {
      shot = next;
      // What the pointer was told is of another state.
      stage.tell(null);
      return choose();
    });
  }
  choose();
  return draw;
}

kinds.map = map;

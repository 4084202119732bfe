// Maps: cells in the plane, coloured by a field, moved by a multiple of their displacements.

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
  // What arrows and corners need of a state beside the field that is chosen.
  const needed = [...(data.moves?.fields ?? []), ...(data.marks.arrows?.tensor ?? [])];
  let own = [], squares = [];

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
    marks(ctx, of, factor);
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

  // Isolines of the field, and the arrows that tell of it; those of displacements also where the body is drawn at rest.
  function marks(ctx, of, factor) {
    const at = ([x, y]) => [seen.x(x), seen.y(y)];
    const places = (k, list = corners) => [0, 1].map((c) => middle(list, k, c));
    const lines = data.marks.isolines ? isolines(squares, shown.values, places, of.range, data.marks.isolines) : [];
    drawIsolines(ctx, lines, at);
    const asked = data.marks.arrows;
    let arrows = [];
    if (asked?.on.includes(Number(choice.value))) {
      const gone = (k) => places(k, cells.corners).map((v, c) => v + (factor || data.moves.factor) * own[c][k]);
      arrows = asked.tensor
        ? principal(cells.chosen(), own.slice(-3), places)
        : cells.chosen().own.map((k) => [places(k, cells.corners), gone(k)]);
    }
    drawArrows(ctx, arrows, at);
    [figure.dataset.isolines, figure.dataset.arrows] = [lines.map(({ value }) => number(value, 4)).join(' '), arrows.length];
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
    const isNew = shown?.state !== of.state;
    const [first, ...others] = await Promise.all([chosen, ...(isNew ? needed : [])].map((k) => values(of, k)));
    if (choice.value !== chosen || shot !== of) return;
    if (isNew) [own, squares] = [others, data.marks.isolines ? cells.squares(of.state) : []];
    if (isNew && data.moves) moved = cells.move(...own.slice(0, 2), of.state);
    shown = { values: first, packed: of.packed[chosen], state: of.state };
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

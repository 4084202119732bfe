// Solids: bricks in space, coloured by a field, moved by a multiple of their displacements, turned, and cut across an axis.

// Cameras by the bodies that they see: all states of a body are seen from one place.
const cameras = new Map();

// The middle and the size of a box that holds a body also where it moves farthest, and the half sides in parts of the size.
function around(ends, { moves, fields }) {
  const most = moves ? 2 * moves.factor : 0;
  const by = (c, end) => (moves ? most * fields[moves.fields[c]].range[end] : 0);
  const low = ends[0].map((at, c) => at + Math.min(0, by(c, 0)));
  const high = ends[1].map((at, c) => at + Math.max(0, by(c, 1)));
  const size = Math.hypot(...high.map((at, c) => at - low[c]));
  return {
    size,
    middle: low.map((at, c) => (at + high[c]) / 2),
    half: low.map((at, c) => (high[c] - at) / 2 / size),
    stretch: moves ? moves.factor / size : 0,
  };
}

function solid(figure, data) {
  const stage = new Stage(figure);
  const of = bricks(data.bricks);
  const [choice, slider, across, depth, flip] =
    ['field', 'scale', 'across', 'depth', 'flip'].map((name) => figure.querySelector(`.${name}`));
  const ends = [0, 1].map((end) => [0, 1, 2].map((c) => of.line(c, end * of.size[c])));
  const unit = around(ends, data);
  const box = new Box(...ends, unit, data.length);
  const body = JSON.stringify(data.bricks);
  const camera = cameras.get(body) ?? new Camera();
  cameras.set(body, camera);
  const known = [];
  const values = (k) => (known[k] ??= unpack(data.fields[k].packed, of.before));
  let u = null, shown = null, mesh = null, tints = null, to = null, isAbove = false, seen = 0;

  const busy = steer(stage.canvas, figure.querySelectorAll('.views button'), camera, draw);
  const factor = () => (slider ? Number(slider.value) : 0);

  // The sides that are seen where the body is cut.
  function cut() {
    const axis = Number(across.value);
    const isCut = across.value !== '';
    depth.hidden = flip.hidden = !isCut;
    if (isCut) {
      depth.max = of.size[axis] - 1;
      depth.nextElementSibling.value = `${'xyz'[axis]} ${measured(of.line(axis, Number(depth.value)), data.length, 4)}`;
    } else {
      depth.nextElementSibling.value = '';
    }
    mesh = surface(of, unit, u, isCut ? { axis, line: Number(depth.value), above: isAbove } : null);
    paint();
  }

  // Colours of the corners of all sides.
  function paint() {
    const field = data.fields[choice.value];
    const colors = Array.from({ length: LEVELS }, (_, k) => [...tint(k), 255]);
    tints = new Uint8Array(16 * mesh.owners.length);
    mesh.owners.forEach((owner, side) => {
      const rgba = colors[level(field, shown[owner])];
      for (let corner = 0; corner < 4; corner++) tints.set(rgba, 16 * side + 4 * corner);
    });
    draw();
  }

  function draw() {
    if (!mesh) return;
    if (slider) slider.nextElementSibling.value = factor() ? `× ${number(factor() * data.moves.factor, 3)}` : 'off';
    const ctx = stage.begin((width) => {
      seen = clamp(0.62 * width, 300, 560);
      return seen + BAR + 6;
    });
    if (!ctx) return;
    to = null;
    camera.within(stage.width, seen, unit.half);
    const ink = [1, 3, 5].map((at) => parseInt(color('faint').slice(at, at + 2), 16));
    const drawn = { mesh, tints, factor: factor(), lines: box.lines(camera), ink };
    const gpu = graphics();
    figure.querySelector('.slow').hidden = Boolean(gpu);
    ctx.save();
    ctx.beginPath();
    ctx.rect(0, 0, stage.width, seen);
    ctx.clip();
    if (gpu) ctx.drawImage(gpu.draw(drawn, camera, [stage.width, seen], stage.fine), 0, 0, stage.width, seen);
    else paintPlainly(ctx, drawn, places(), camera);
    box.label(ctx, camera, stage.width, seen);
    triad(ctx, camera, seen);
    ctx.restore();
    bar(stage, ctx, data.fields[choice.value], seen + 6);
    figure.dataset.ready = choice.value;
  }

  const places = () => (to ??= projected(mesh, camera, factor()));

  // The brick at a pixel, where it is when it has not moved, and its value.
  function find(x, y) {
    if (x === null || !mesh || busy.is || y > seen) return null;
    const side = sideAt(places(), x, y);
    if (side < 0) return null;
    const brick = mesh.owners[side];
    const place = of.centre(brick).map((at, c) => `${'xyz'[c]} ${measured(at, data.length)}`);
    return { x, y, lines: [place.join(', '), worded(data.fields[choice.value], shown[brick])] };
  }

  async function choose() {
    const chosen = choice.value;
    const still = () => Promise.resolve(new Float64Array(of.count));
    const [own, ...moves] = await Promise.all([values(chosen), ...[0, 1, 2].map((c) => (data.moves ? values(data.moves.fields[c]) : still()))]);
    if (choice.value !== chosen) return;
    [shown, u] = [own, moves];
    if (mesh) paint();
    else cut();
  }

  choice.addEventListener('change', choose);
  slider?.addEventListener('input', draw);
  of.size.forEach((count, axis) => (across.options[axis + 1].disabled = count < 2));
  across.addEventListener('change', () => {
    depth.max = of.size[Number(across.value)] - 1;
    depth.value = Math.ceil(of.size[Number(across.value)] / 2);
    cut();
  });
  depth.addEventListener('input', cut);
  flip.addEventListener('click', () => {
    isAbove = !isAbove;
    cut();
  });
  stage.canvas.tabIndex = 0;
  stage.listen(find);
  stage.canvas.addEventListener('keydown', (event) => {
    if (event.key === 'Enter') stage.tell(find(stage.width / 2, seen / 2));
  });
  choose();
  return draw;
}

kinds.solid = solid;

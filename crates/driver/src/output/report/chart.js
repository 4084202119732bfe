// Charts: lines over an axis, linear or logarithmic.

function range(values) {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values) [low, high] = [Math.min(low, value), Math.max(high, value)];
  return [low, high];
}

// An axis around values, wider by a part of their range.
function axis(kind, [low, high], part, count) {
  if (kind.log) {
    const wider = high > low ? (high / low) ** part : 2;
    return logarithmic(low / wider, high * wider);
  }
  const wider = part * (high - low);
  return linear(low - wider, high + wider, count);
}

// Whether a line goes to the right only, so that it has one value at every x.
const runs = (s) => s.x.every((x, k) => k === 0 || x >= s.x[k - 1]);

// Number of the x nearest to a value.
function nearest(x, value) {
  let best = 0;
  x.forEach((other, k) => {
    if (Math.abs(other - value) < Math.abs(x[best] - value)) best = k;
  });
  return best;
}

function chart(figure, data) {
  const stage = new Stage(figure);
  const all = data.series;
  const corners = data.slopes.flatMap((s) => [[s.x, s.y], [s.to, s.y * (s.to / s.x) ** s.order]]);
  const xs = range([...all.flatMap((s) => s.x), ...corners.map((c) => c[0])]);
  const ys = range([...all.flatMap((s) => s.y), ...corners.map((c) => c[1])]);
  const marked = all.some((s) => s.look === 'marked' || s.look === 'dots');
  const tracks = all.every(runs);
  let place, hovered = null;

  function frame(ctx, width, height) {
    const x = axis(data.x, xs, marked ? 0.05 : 0, clamp(width / 90, 3, 9));
    const y = axis(data.y, ys, 0.07, clamp(height / 55, 3, 7));
    const left = 10 + Math.max(...y.ticks.map((tick) => ctx.measureText(y.text(tick)).width));
    const [right, top, bottom] = [width - 16, 30, height - 42];
    const to = ([a, b]) => [left + x.at(a) * (right - left), bottom - (data.y.turned ? 1 - y.at(b) : y.at(b)) * (bottom - top)];
    ctx.textBaseline = 'middle';
    ctx.strokeStyle = color('rule');
    ctx.fillStyle = color('faint');
    const grid = (from, until, strong) => {
      ctx.lineWidth = strong ? 1 : 0.4;
      line(ctx, [from, until]);
      ctx.stroke();
    };
    y.lines.forEach((tick) => grid([left, to([x.low, tick])[1]], [right, to([x.low, tick])[1]], y.ticks.includes(tick)));
    x.lines.forEach((tick) => grid([to([tick, y.low])[0], top], [to([tick, y.low])[0], bottom], x.ticks.includes(tick)));
    ctx.textAlign = 'right';
    y.ticks.forEach((tick) => ctx.fillText(y.text(tick), left - 6, to([x.low, tick])[1]));
    ctx.textAlign = 'center';
    let end = -Infinity;
    for (const tick of x.ticks) {
      const [at, half] = [to([tick, y.low])[0], ctx.measureText(x.text(tick)).width / 2];
      const shifted = clamp(at, half, width - half);
      if (shifted - half < end + 8) continue;
      ctx.fillText(x.text(tick), shifted, bottom + 13);
      end = shifted + half;
    }
    ctx.fillStyle = color('ink');
    ctx.textAlign = 'left';
    ctx.fillText([data.y.label, y.factor].filter(Boolean).join('  '), 0, 12);
    ctx.textAlign = 'right';
    ctx.fillText([data.x.label, x.factor].filter(Boolean).join('  '), right, bottom + 32);
    if (!data.y.log && y.low < 0 && y.high > 0) {
      ctx.strokeStyle = color('faint');
      grid(to([x.low, 0]), to([x.high, 0]), true);
    }
    return { to, left, right, top, bottom };
  }

  function strokes(ctx, s, k) {
    ctx.strokeStyle = ctx.fillStyle = series(k);
    ctx.lineWidth = s.look === 'thin' ? 1 : 2;
    ctx.setLineDash(s.look === 'dashed' ? [7, 5] : []);
    const points = s.x.map((x, i) => place.to([x, s.y[i]]));
    if (s.look !== 'dots') {
      line(ctx, points);
      ctx.stroke();
    }
    ctx.setLineDash([]);
    if (s.look === 'dots' || s.look === 'marked' || points.length === 1) {
      const step = s.look === 'marked' ? 1 : Math.ceil(points.length / 60);
      points.forEach(([x, y], i) => {
        if (i % step) return;
        dot(ctx, x, y, 3.2);
        ctx.fill();
      });
    }
  }

  // A triangle with its order: one to the right, and as much upwards as the order says.
  function slope(ctx, s) {
    const rise = s.y * (s.to / s.x) ** s.order;
    const [a, b, c] = [[s.x, s.y], [s.to, s.y], [s.to, rise]].map(place.to);
    ctx.strokeStyle = ctx.fillStyle = color('faint');
    ctx.lineWidth = 1;
    line(ctx, [a, b, c, a]);
    ctx.stroke();
    ctx.textAlign = 'left';
    ctx.fillText(number(s.order, 3), b[0] + 5, (b[1] + c[1]) / 2);
    ctx.textAlign = 'center';
    ctx.fillText('1', (a[0] + b[0]) / 2, b[1] + 10);
  }

  // Where the state stands that the page shows.
  function ring(ctx, [x, y]) {
    [ctx.strokeStyle, ctx.lineWidth] = [color('faint'), 1];
    line(ctx, [[x, place.top], [x, place.bottom]]);
    ctx.stroke();
    [ctx.fillStyle, ctx.strokeStyle, ctx.lineWidth] = [color('paper'), color('ink'), 2];
    dot(ctx, x, y, 5);
    ctx.fill();
    ctx.stroke();
  }

  function draw() {
    const ctx = stage.begin((width) => clamp(0.44 * width, 230, 380));
    if (!ctx) return;
    place = frame(ctx, stage.width, stage.height);
    ctx.save();
    ctx.beginPath();
    ctx.rect(place.left - 4, place.top - 4, place.right - place.left + 8, place.bottom - place.top + 8);
    ctx.clip();
    all.forEach((s, k) => strokes(ctx, s, k));
    ctx.restore();
    data.slopes.forEach((s) => slope(ctx, s));
    if (data.marks[states.shown]) ring(ctx, place.to(data.marks[states.shown]));
    if (hovered) {
      ctx.fillStyle = color('paper');
      ctx.lineWidth = 2;
      for (const { k, i } of hovered) {
        const [x, y] = place.to([all[k].x[i], all[k].y[i]]);
        ctx.strokeStyle = series(k);
        dot(ctx, x, y, 4);
        ctx.fill();
        ctx.stroke();
      }
    }
  }

  // The points at the x of the pointer; of lines that turn back the one nearest to it.
  function find(px, py) {
    const before = hovered;
    hovered = null;
    if (px !== null && place && px > place.left - 12 && px < place.right + 12) {
      const pixels = all.map((s) => s.x.map((x, i) => place.to([x, s.y[i]])));
      const distance = ([x, y]) => (tracks ? Math.abs(x - px) : Math.hypot(x - px, y - py));
      const found = pixels.map((points, k) => {
        const i = nearest(points.map(distance), 0);
        return { k, i, far: distance(points[i] || [Infinity, Infinity]) };
      });
      const closest = Math.min(...found.map((f) => f.far));
      hovered = found.filter((f) => f.far <= (tracks ? closest + 6 : closest));
      if (!tracks) hovered.length = 1;
    }
    if (hovered || before) draw();
    if (!hovered) return null;
    const [first] = hovered;
    const [x, y] = place.to([all[first.k].x[first.i], all[first.k].y[first.i]]);
    const name = (k) => (all.length > 1 ? all[k].label : data.y.label);
    const away = (other) => Math.abs(other - all[first.k].x[first.i]) > 1e-6 * (xs[1] - xs[0]);
    const values = hovered.map(({ k, i }) => {
      const own = all[k].x[i];
      return `${name(k)}: ${number(all[k].y[i])}${away(own) ? ` at ${number(own)}` : ''}`;
    });
    return { x, y, lines: [`${data.x.label}: ${number(all[first.k].x[first.i])}`, ...values] };
  }

  stage.listen(find);
  if (data.marks.length) states.follow(draw);
  return draw;
}

kinds.chart = chart;

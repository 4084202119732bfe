// Pictures: lines in the plane, moved by a multiple of their moves.

function picture(figure, data) {
  const stage = new Stage(figure);
  const choice = figure.querySelector('.field');
  const slides = figure.querySelector('.slides');
  const slider = figure.querySelector('.scale');
  let seen, factor, of;

  const points = (s, factor) => s.x.flatMap((x, k) => [x + factor * (s.dx[k] ?? 0), s.y[k] + factor * (s.dy[k] ?? 0)]);
  const pixels = (s, factor) => s.x.map((x, k) => [seen.x(x + factor * (s.dx[k] ?? 0)), seen.y(s.y[k] + factor * (s.dy[k] ?? 0))]);

  const parts = {
    body: (ctx, to) => stroked(ctx, to, 'ink', 2.6),
    ghost: (ctx, to) => stroked(ctx, to, 'faint', 1),
    line: (ctx, to) => stroked(ctx, to, 'c1', 2.4),
    area(ctx, to, from) {
      line(ctx, [...to, ...from.reverse()]);
      ctx.closePath();
      ctx.fillStyle = color('c1');
      ctx.globalAlpha = 0.15;
      ctx.fill();
      ctx.globalAlpha = 1;
      stroked(ctx, to, 'c1', 1.4);
    },
    dots: (ctx, to) => to.forEach(([x, y]) => marked(ctx, x, y, 3, 'ink')),
    circles: (ctx, to) => to.forEach(([x, y]) => marked(ctx, x, y, 4, 'paper')),
  };

  function stroked(ctx, to, name, width) {
    [ctx.strokeStyle, ctx.lineWidth] = [color(name), width];
    line(ctx, to);
    ctx.stroke();
  }

  function marked(ctx, x, y, radius, name) {
    [ctx.fillStyle, ctx.strokeStyle, ctx.lineWidth] = [color(name), color('ink'), 1.4];
    dot(ctx, x, y, radius);
    ctx.fill();
    ctx.stroke();
  }

  // The largest value of every area beside its place, the most important first; one that would lie on another is left out.
  function labels(ctx) {
    const areas = of.shapes.filter((s) => s.part === 'area');
    const largest = Math.max(0, ...areas.flatMap((s) => s.values.map(Math.abs)));
    const found = areas.map((s) => {
      const size = Math.max(...s.values.map(Math.abs));
      const same = s.values.map((_, k) => k).filter((k) => Math.abs(s.values[k]) >= size * (1 - 1e-9));
      return { s, k: same[Math.floor(same.length / 2)], size };
    });
    const taken = [];
    ctx.font = `600 ${ctx.font}`;
    ctx.fillStyle = color('c1');
    ctx.textAlign = 'center';
    ctx.textBaseline = 'middle';
    for (const { s, k, size } of found.sort((a, b) => b.size - a.size)) {
      if (size <= 0.01 * largest) continue;
      const [ax, ay] = pixels(s, 0)[k];
      const [bx, by] = pixels(s, factor)[k];
      const away = Math.hypot(bx - ax, by - ay) || 1;
      const text = number(s.values[k], 4);
      const half = ctx.measureText(text).width / 2;
      const x = clamp(bx + ((half + 7) * (bx - ax)) / away, half, stage.width - half);
      const y = clamp(by + (13 * (by - ay)) / away, 7, stage.height - 7);
      if (taken.some((t) => Math.abs(t.x - x) < t.half + half + 6 && Math.abs(t.y - y) < 16)) continue;
      taken.push({ x, y, half });
      ctx.fillText(text, x, y);
    }
  }

  function draw() {
    of = data.views[choice.value];
    factor = of.factor * (of.slides ? Number(slider.value) : 1);
    if (slides) slides.hidden = !of.slides;
    if (slider) slider.nextElementSibling.value = factor ? `× ${number(factor, 3)}` : 'off';
    // Room for the largest factor, so that nothing jumps while it is chosen.
    const reach = of.shapes.flatMap((s) => [points(s, 0), points(s, of.slides ? 2 * of.factor : of.factor)]);
    const [SIDE, ABOVE] = [clamp(stage.canvas.parentElement.clientWidth / 8, 30, 64), 24];
    const ctx = stage.begin((width) => {
      seen = view(reach, width - 2 * SIDE, clamp(0.6 * width, 220, 460));
      const { x, y } = seen;
      Object.assign(seen, { x: (at) => SIDE + x(at), y: (at) => ABOVE + y(at) });
      return seen.height + 2 * ABOVE + (of.note ? 22 : 0);
    });
    if (!ctx) return;
    of.shapes.forEach((s) => parts[s.part](ctx, pixels(s, factor), pixels(s, 0)));
    ctx.fillStyle = color('faint');
    ctx.textAlign = 'left';
    ctx.textBaseline = 'middle';
    ctx.fillText(of.note, 0, stage.height - 10);
    labels(ctx);
  }

  // The point with a value that is nearest to the pointer.
  function find(px, py) {
    if (px === null || !seen) return null;
    let best = null;
    for (const s of of.shapes.filter((s) => s.values.length)) {
      [0, factor].forEach((f) => pixels(s, f).forEach(([x, y], k) => {
        const far = Math.hypot(x - px, y - py);
        if (far < (best?.far ?? 30)) best = { s, k, far, x, y };
      }));
    }
    if (!best) return null;
    const { s, k, x, y } = best;
    const place = ['x', 'y'].map((name) => `${name} ${measured(s[name][k], data.length)}`).join(', ');
    return { x, y, lines: [s.name, place, `${of.name} ${measured(s.values[k], of.unit)}`] };
  }

  choice.addEventListener('change', draw);
  slider?.addEventListener('input', draw);
  stage.listen(find);
  return draw;
}

kinds.picture = picture;

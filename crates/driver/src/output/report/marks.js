// Marks over the cells of a map: lines of equal values, and arrows.

// Pixels: the head of an arrow, the shortest arrow, the room of a number.
const [HEAD, SHORTEST, LABEL] = [5, 2, [42, 16]];

// Where `values`, linear on the triangles between the `places` of cells, have round values: each with the pieces of its line.
function isolines(squares, values, places, [low, high], count) {
  // As nearly `count` as there can be: steps are rounded up, and finer ones may have the better number.
  const levels = [1, 1.25, 1.6, 2, 2.5].map((f) => linear(low, high, f * count).ticks.filter((tick) => low < tick && tick < high));
  const off = (ticks) => Math.abs(ticks.length - count);
  const inside = levels.reduce((best, ticks) => (off(ticks) < off(best) ? ticks : best));
  const all = inside.map((value) => ({ value, pieces: [] }));
  function cross(corners) {
    const three = corners.map((k) => values[k]);
    const [least, most] = [Math.min(...three), Math.max(...three)];
    // A corner at the value counts as above it, so that every crossed triangle has two ends.
    const crossing = all.filter(({ value }) => least < value && value <= most);
    crossing.forEach(({ value, pieces }) => pieces.push(piece(corners.map((k) => places(k)), three, value)));
  }
  for (const [a, b, c, d] of squares) [[a, b, c], [a, c, d]].forEach(cross);
  return all.filter(({ pieces }) => pieces.length);
}

// The ends of the line through a triangle on which a linear function has a value.
function piece(places, values, value) {
  return [0, 1, 2].flatMap((k) => {
    const [a, b] = [k, (k + 1) % 3];
    if (values[a] < value === values[b] < value) return [];
    const part = (value - values[a]) / (values[b] - values[a]);
    return [places[a].map((v, c) => v + part * (places[b][c] - v))];
  });
}

// Draws isolines, `at(place)` in pixels, and on each its value where that lies on no other one.
function drawIsolines(ctx, all, at) {
  ctx.beginPath();
  for (const [from, to] of all.flatMap(({ pieces }) => pieces)) {
    ctx.moveTo(...at(from));
    ctx.lineTo(...at(to));
  }
  [ctx.strokeStyle, ctx.lineWidth] = ['#333a44', 0.8];
  ctx.stroke();
  const taken = [];
  [ctx.textAlign, ctx.textBaseline] = ['center', 'middle'];
  for (const { value, pieces } of all) {
    const half = pieces.length >> 1;
    const places = [...pieces.slice(half), ...pieces.slice(0, half)].map(([from]) => at(from));
    const free = places.find((place) => taken.every((other) => place.some((v, c) => Math.abs(v - other[c]) > LABEL[c])));
    if (!free) continue;
    taken.push(free);
    // White around the digits keeps them apart from the line below.
    [ctx.strokeStyle, ctx.lineWidth, ctx.fillStyle] = ['#fff', 4, '#111418'];
    ctx.strokeText(number(value, 4), ...free);
    ctx.fillText(number(value, 4), ...free);
  }
}

// Arrows of the principal values of a tensor xx, yy, xy of some cells, the largest as long as cells with arrows are apart.
function principal({ own, room }, [xx, yy, xy], places) {
  const of = (k) => {
    const [mean, half] = [(xx[k] + yy[k]) / 2, (xx[k] - yy[k]) / 2];
    const [radius, angle] = [Math.hypot(half, xy[k]), Math.atan2(xy[k], half) / 2];
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    return [[mean + radius, [c, s]], [mean - radius, [-s, c]]];
  };
  const largest = Math.max(...own.flatMap((k) => of(k).map(([value]) => Math.abs(value)))) || 1;
  const arrows = (k) =>
    of(k).flatMap(([value, along]) =>
      [1, -1].map((sign) => {
        const from = places(k);
        const end = from.map((v, c) => v + (sign * 0.47 * room * Math.abs(value) * along[c]) / largest);
        return value > 0 ? [from, end] : [end, from];
      }));
  return own.flatMap(arrows);
}

// Draws arrows, each from its first place to its second: dark on white, which is seen on every colour.
function drawArrows(ctx, all, at) {
  ctx.beginPath();
  for (const [[ax, ay], [bx, by]] of all.map((ends) => ends.map(at))) {
    const [dx, dy] = [bx - ax, by - ay];
    const length = Math.hypot(dx, dy);
    if (!(length >= SHORTEST)) continue;
    const head = Math.min(HEAD, 0.5 * length) / length;
    const side = (sign) => [bx - head * (dx - sign * 0.5 * dy), by - head * (dy + sign * 0.5 * dx)];
    ctx.moveTo(ax, ay);
    ctx.lineTo(bx, by);
    ctx.moveTo(...side(1));
    ctx.lineTo(bx, by);
    ctx.lineTo(...side(-1));
  }
  for (const [style, width] of [['#fff', 2.2], ['#111418', 1]]) {
    [ctx.strokeStyle, ctx.lineWidth] = [style, width];
    ctx.stroke();
  }
}

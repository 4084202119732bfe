// Fields: values of cells, their colours, and the colour bar.

// Viridis (van der Walt and Smith 2015) at equal steps.
const VIRIDIS = [
  [68, 1, 84], [72, 36, 117], [65, 68, 135], [53, 95, 141], [42, 120, 142], [33, 145, 140], [34, 168, 132],
  [68, 191, 112], [122, 209, 81], [189, 223, 38], [253, 231, 37],
];
const LEVELS = 96;

const [BAR, WIDE] = [58, 420];

// Red, green and blue of a level, 0 to 255.
function tint(level) {
  const at = ((level + 0.5) / LEVELS) * (VIRIDIS.length - 1);
  const low = Math.min(Math.floor(at), VIRIDIS.length - 2);
  return VIRIDIS[low].map((v, k) => Math.round(v + (at - low) * (VIRIDIS[low + 1][k] - v)));
}

const css = (rgb) => `rgb(${rgb.join(' ')})`;

// The level of a value of a field.
function level({ range: [low, high] }, value) {
  // What differs by rounding is even.
  const differs = high - low > 1e-9 * Math.max(Math.abs(low), Math.abs(high));
  const part = differs ? (value - low) / (high - low) : 0.5;
  return clamp(Math.floor(part * LEVELS), 0, LEVELS - 1);
}

// A value of a field in words, with no more digits than its packing kept.
function worded(of, value, { step } = of.packed) {
  const kept = step ? 2 + Math.floor(Math.log10(Math.abs(value) / step)) : 5;
  return `${of.name} ${measured(value, of.unit, clamp(kept, 1, 5))}`;
}

// Values of cells from what `pack.rs` made of them.
async function unpack(packed, before) {
  const deflated = Uint8Array.from(atob(packed.data), (c) => c.charCodeAt(0));
  const stream = new Blob([deflated]).stream().pipeThrough(new DecompressionStream('deflate'));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const count = bytes.length / 2;
  const steps = new Uint16Array(count);
  const values = new Float64Array(count);
  for (let k = 0; k < count; k++) {
    const folded = bytes[k] | (bytes[count + k] << 8);
    const [left, below, corner] = [before[3 * k], before[3 * k + 1], before[3 * k + 2]];
    let foretold = 0;
    if (left >= 0 && below >= 0 && corner >= 0) foretold = steps[left] + steps[below] - steps[corner];
    else if (left >= 0) foretold = steps[left];
    else if (below >= 0) foretold = steps[below];
    steps[k] = foretold + ((folded >> 1) ^ -(folded & 1));
    values[k] = packed.low + packed.step * steps[k];
  }
  return values;
}

// The colour bar with its numbers, BAR high.
function bar(stage, ctx, of, top) {
  const width = clamp(stage.width - 180, 120, WIDE);
  const left = (stage.width - width) / 2;
  for (let k = 0; k < LEVELS; k++) {
    ctx.fillStyle = css(tint(k));
    ctx.fillRect(left + (k * width) / LEVELS, top, width / LEVELS + 0.5, 10);
  }
  const scale = linear(of.range[0], of.range[1], clamp(width / 80, 3, 6));
  ctx.strokeStyle = color('faint');
  ctx.fillStyle = color('ink');
  ctx.lineWidth = 1;
  ctx.textAlign = 'center';
  ctx.textBaseline = 'middle';
  let free = -Infinity;
  for (const tick of scale.ticks) {
    const x = left + scale.at(tick) * width;
    line(ctx, [[x, top + 10], [x, top + 14]]);
    ctx.stroke();
    // Long numbers, of values that are nearly one, would lie on each other.
    const half = ctx.measureText(scale.text(tick)).width / 2;
    if (x - half < free) continue;
    free = x + half + 6;
    ctx.fillText(scale.text(tick), x, top + 22);
  }
  ctx.textAlign = 'right';
  ctx.fillText(number(of.range[0], 4), left - 8, top + 5);
  ctx.textAlign = 'left';
  ctx.fillText(number(of.range[1], 4), left + width + 8, top + 5);
  ctx.textAlign = 'center';
  ctx.fillText([of.name, of.unit && `[${of.unit}]`, scale.factor].filter(Boolean).join(' '), stage.width / 2, top + 40);
}


// Numbers as text, and round numbers for axes.

const raised = (power) => String(power).replace('-', '⁻').replace(/\d/g, (digit) => '⁰¹²³⁴⁵⁶⁷⁸⁹'[digit]);
const trimmed = (text) => (text.includes('.') ? text.replace(/\.?0+$/, '') : text);

// A number with some digits: 0.004, −12.35, 1.234×10⁻⁶.
function number(value, digits = 5) {
  if (value === null || !Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e6) {
    const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
    return trimmed(value.toFixed(decimals)).replace('-', '−');
  }
  const [mantissa, power] = value.toExponential(digits - 1).split('e');
  return `${trimmed(mantissa).replace('-', '−')}×10${raised(Number(power))}`;
}

// A value with a unit, if it has one.
const measured = (value, unit, digits) => (unit ? `${number(value, digits)} ${unit}` : number(value, digits));

// An axis from low to high: ticks, their texts, the power of ten that the texts leave out, and where a value stands, 0 to 1.
function linear(low, high, count) {
  const size = Math.max(Math.abs(low), Math.abs(high));
  if (size === 0) [low, high] = [-1, 1];
  else if (high - low < 1e-9 * size) [low, high] = [low - size / 2, high + size / 2];
  const rough = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].find((lead) => lead * power >= 0.99 * rough) * power;
  const ticks = [];
  for (let k = Math.ceil(low / step - 1e-9); k <= Math.floor(high / step + 1e-9); k++) ticks.push(k * step);
  const largest = Math.max(...ticks.map(Math.abs));
  const plain = largest === 0 || (largest >= 0.01 && largest < 1e4);
  const exponent = plain ? 0 : 3 * Math.floor((Math.log10(largest) + 1e-9) / 3);
  const decimals = Math.min(20, Math.max(0, exponent - Math.floor(Math.log10(step) + 1e-9)));
  const text = (tick) => (tick / 10 ** exponent).toFixed(decimals).replace(/^-(?=[0.]*$)/, '').replace('-', '−');
  const factor = exponent ? `×10${raised(exponent)}` : '';
  return { low, high, ticks, lines: ticks, text, factor, at: (value) => (value - low) / (high - low) };
}

// The same for a logarithmic axis: ticks at powers of ten, or at 1, 2, 5 times these where there are few.
function logarithmic(low, high) {
  const [from, to] = [Math.log10(low), Math.log10(high)];
  const inside = (value) => value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9);
  const decades = [];
  for (let k = Math.floor(from); k <= Math.ceil(to); k++) decades.push(k);
  const skip = Math.ceil(decades.length / 9);
  const all = (leads) => decades.flatMap((k) => leads.map((lead) => Number(`${lead}e${k}`))).filter(inside);
  let ticks = all([1]).filter((tick) => Math.round(Math.log10(tick)) % skip === 0);
  if (ticks.length < 3) ticks = all([1, 2, 5]);
  if (ticks.length < 2) ticks = all([1, 2, 3, 4, 5, 6, 7, 8, 9]);
  const text = (tick) => {
    const [lead, power] = tick.toExponential(0).split('e');
    if (Math.abs(power) < 3) return number(tick, 1);
    return lead === '1' ? `10${raised(Number(power))}` : `${lead}×10${raised(Number(power))}`;
  };
  const lines = skip > 1 ? ticks : all([1, 2, 3, 4, 5, 6, 7, 8, 9]);
  return { low, high, ticks, lines, text, factor: '', at: (value) => (Math.log10(value) - from) / (to - from) };
}

/* What every chart needs: the page's colours, numbers as text, scales and ticks. */

const FONT = 'system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", "Noto Sans", Arial, sans-serif';
const theme = {};

function readTheme() {
  const style = getComputedStyle(document.documentElement);
  for (const name of ['paper', 'ink', 'muted', 'line', 'grid', 'accent', 'shade', 'hatch', 'doubt']) {
    theme[name] = style.getPropertyValue('--' + name).trim();
  }
  theme.series = style.getPropertyValue('--series').trim().split(/\s+/);
}

/** Viridis (van der Walt and Smith 2015, CC0) at 17 even steps, as 255 colours from low to high. */
const VIRIDIS = (() => {
  const hex = '44015448186a472d7b4240863b528b33638d2c728e26828e21918c1fa08828ae803fbc735ec96284d44baddc30d8e219fde725';
  const part = (i, channel) => parseInt(hex.substr(6 * i + 2 * channel, 2), 16);
  const colours = new Uint8ClampedArray(255 * 3);
  for (let level = 0; level < 255; level++) {
    const at = level / 254 * 16, i = Math.min(15, Math.floor(at));
    for (let channel = 0; channel < 3; channel++) {
      colours[3 * level + channel] = part(i, channel) + (at - i) * (part(i + 1, channel) - part(i, channel));
    }
  }
  return colours;
})();

const SUPERSCRIPT = {'-': '⁻', 0: '⁰', 1: '¹', 2: '²', 3: '³', 4: '⁴', 5: '⁵', 6: '⁶', 7: '⁷', 8: '⁸', 9: '⁹'};

function power(exponent) {
  return '10' + String(exponent).replace(/./g, c => SUPERSCRIPT[c]);
}

/** A number with so many decimals, or as mantissa and power of ten if it is very large or small. */
function fixed(value, decimals) {
  return value.toFixed(Math.max(0, Math.min(12, decimals))).replace('-', '−');
}

function readable(value) {
  if (!Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const exponent = Math.floor(Math.log10(Math.abs(value)));
  if (exponent < -4 || exponent > 6) return fixed(value / 10 ** exponent, 2) + '·' + power(exponent);
  return fixed(value, 3 - exponent);
}

/** Moves numbers to pixels and back. */
function scaling(log, low, high, from, to) {
  const f = log ? Math.log10 : v => v;
  const a = f(low), slope = (to - from) / (f(high) - a);
  return {
    log, low, high,
    to: v => from + (f(v) - a) * slope,
    from: p => { const v = a + (p - from) / slope; return log ? 10 ** v : v; },
  };
}

/** Ends of an axis for values from low to high: some room if they are one value, a usual range if there are none. */
function extended(log, low, high) {
  if (!(low <= high)) return log ? [0.1, 1] : [0, 1];
  if (low < high) return [low, high];
  const room = (Math.abs(low) || 1) / 2;
  return log ? [low / 2, high * 2] : [low - room, high + room];
}

function linearTicks(low, high, most) {
  const rough = (high - low) / Math.max(1, most);
  const decade = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map(m => m * decade).find(s => s >= rough * 0.75);
  const exponent = Math.floor(Math.log10(step) + 1e-9);
  const largest = Math.max(Math.abs(low), Math.abs(high));
  const ticks = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 0.002 * (high - low); i++) {
    const value = i * step;
    const text = exponent < -5 || largest >= 1e7 ? readable(value) : fixed(value, -exponent);
    ticks.push({value, text: value === 0 ? '0' : text});
  }
  return {major: ticks, minor: []};
}

/** Names in place of numbers, at 1, 2 and so on. */
const namedTicks = names => ({major: names.map((text, i) => ({value: i + 1, text})), minor: []});

/** Ticks at 1, 2 and 5 of every decade, at decades alone when there are many, at even steps within less than a decade. */
function logTicks(low, high, most) {
  const decades = Math.log10(high / low);
  if (decades < 0.7) return linearTicks(low, high, Math.min(most, 6));
  const every = Math.ceil(decades / Math.max(1, most));
  const plain = low >= 0.00099 && high < 1e5;
  const major = [], minor = [];
  for (let e = Math.floor(Math.log10(low)); e <= Math.ceil(Math.log10(high)); e++) {
    for (let m = 1; m < 10; m++) {
      const value = m * 10 ** e;
      if (value < low * 0.9999 || value > high * 1.0001) continue;
      const labelled = 3 * decades <= most ? m === 1 || m === 2 || m === 5 : m === 1 && e % every === 0;
      const text = plain ? fixed(value, -e) : (m === 1 ? '' : m + '·') + power(e);
      if (labelled) major.push({value, text}); else if (every === 1) minor.push({value});
    }
  }
  return {major, minor};
}

const titleOf = axis => axis.unit ? `${axis.label} [${axis.unit}]` : axis.label;
const withUnit = (text, unit) => unit && text !== '–' ? text + ' ' + unit : text;

/** The first index at which a rising array is not below a value. */
function firstAt(xs, value) {
  let low = 0, high = xs.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (xs[middle] < value) low = middle + 1; else high = middle;
  }
  return low;
}

function nearest(xs, value) {
  const i = firstAt(xs, value);
  return i > 0 && (i === xs.length || value - xs[i - 1] < xs[i] - value) ? i - 1 : i;
}

const positions = data => Array.isArray(data) ? Float64Array.from(data)
  : Float64Array.from({length: data.count}, (_, i) => data.from + i * data.step);
/** Numbers as they stand, or two bytes each in base64: steps above the lowest. */
const values = data => Array.isArray(data) ? Float64Array.from(data, v => v === null ? NaN : v) : unpacked(data);

function unpacked({low, step, codes}) {
  const bytes = atob(codes), count = bytes.length / 2, unpacked = new Float64Array(count);
  for (let i = 0; i < count; i++) {
    const code = (bytes.charCodeAt(2 * i) | bytes.charCodeAt(2 * i + 1) << 8) << 16 >> 16;
    unpacked[i] = code === -32768 ? NaN : low + (code + 32767) * step;
  }
  return unpacked;
}

function make(tag, type, text) {
  const element = document.createElement(tag);
  if (type) element.className = type;
  if (text) element.textContent = text;
  return element;
}

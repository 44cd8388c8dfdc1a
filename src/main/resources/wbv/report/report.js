/*
 * Charts of a report, drawn on canvas from the JSON that stands beside each of them. No library, no network.
 *
 * A View is a range of x that several charts share. A Chart knows its axes, its canvas and the pointer; LineChart and Heatmap
 * know how to paint and what to read out. A new kind of chart is one more subclass, entered in KINDS at the end.
 */
(() => {
  'use strict';

  // ---- Theme ---------------------------------------------------------------------------------------------------------

  const FONT = 'system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", "Noto Sans", Arial, sans-serif';
  const theme = {};

  function readTheme() {
    const style = getComputedStyle(document.documentElement);
    for (const name of ['paper', 'ink', 'muted', 'line', 'grid', 'accent', 'shade', 'hatch']) {
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

  // ---- Numbers and axes ----------------------------------------------------------------------------------------------

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
  const values = data => Float64Array.from(data, v => v === null ? NaN : v);

  function make(tag, type, text) {
    const element = document.createElement(tag);
    if (type) element.className = type;
    if (text) element.textContent = text;
    return element;
  }

  // ---- View: the range of x that a group of charts shares --------------------------------------------------------------

  class View {
    constructor() {
      this.charts = [];
      this.names = [];
      this.hover = null;
      this.pending = false;
    }

    /** The same name has the same colour in all charts of a group. */
    order(name) {
      if (!this.names.includes(name)) this.names.push(name);
      return this.names.indexOf(name);
    }

    add(chart) {
      this.charts.push(chart);
      this.log = chart.data.x.log;
      const ranges = this.charts.map(c => c.extent()).filter(r => r[1] > r[0]);
      this.full = ranges.length ? [Math.min(...ranges.map(r => r[0])), Math.max(...ranges.map(r => r[1]))] : [this.log ? 0.1 : 0, 1];
      this.range = this.full;
    }

    get zoomed() {
      return this.range[0] !== this.full[0] || this.range[1] !== this.full[1];
    }

    forward(x) { return this.log ? Math.log10(x) : x; }

    back(u) { return this.log ? 10 ** u : u; }

    /** Shows a range, given in forward units, as far as it lies within the full one. */
    show(a, b) {
      const low = this.forward(this.full[0]), high = this.forward(this.full[1]);
      const span = Math.min(high - low, Math.max(b - a, 1e-6 * (high - low)));
      let from = (a + b - span) / 2;
      from = Math.max(low, Math.min(high - span, from));
      this.range = span >= (high - low) * 0.9999 ? this.full : [this.back(from), this.back(from + span)];
      this.draw();
    }

    zoom(factor, at) {
      const a = this.forward(this.range[0]), b = this.forward(this.range[1]);
      const u = at === undefined ? (a + b) / 2 : this.forward(at);
      this.show(u + (a - u) * factor, u + (b - u) * factor);
    }

    pan(part) {
      const a = this.forward(this.range[0]), b = this.forward(this.range[1]);
      this.show(a + part * (b - a), b + part * (b - a));
    }

    reset() {
      this.range = this.full;
      this.draw();
    }

    point(x) {
      this.hover = x;
      this.charts.forEach(c => c.paintOverlay());
    }

    draw() {
      if (this.pending) return;
      this.pending = true;
      requestAnimationFrame(() => this.drawNow());
    }

    /** Charts of a group get the same margins, so that equal x stand above each other. */
    drawNow() {
      this.pending = false;
      const shown = this.charts.filter(c => c.prepare());
      const left = Math.max(0, ...shown.map(c => c.leftMargin()));
      const right = Math.max(0, ...shown.map(c => c.rightMargin()));
      shown.forEach(c => c.draw(left, right));
    }
  }

  // ---- Chart: axes, canvas, pointer and keys ---------------------------------------------------------------------------

  class Chart {
    constructor(figure, data, view) {
      this.data = data;
      this.view = view;
      this.plot = figure.querySelector('.plot');
      this.legend = this.plot.appendChild(make('div', 'legend'));
      this.legend.hidden = true;
      this.surface = this.plot.appendChild(make('div', 'surface'));
      this.surface.tabIndex = 0;
      this.surface.setAttribute('role', 'img');
      this.surface.setAttribute('aria-label',
        `Chart: ${data.title}, ${titleOf(data.y)} over ${titleOf(data.x)}. Arrow keys pan, plus and minus zoom, 0 resets.`);
      this.canvas = this.surface.appendChild(make('canvas'));
      this.overlay = this.surface.appendChild(make('canvas', 'overlay'));
      this.readout = this.surface.appendChild(make('div', 'readout'));
      this.readout.hidden = true;
      this.resetButton = figure.querySelector('figcaption').appendChild(make('button', 'reset', 'Reset zoom'));
      this.resetButton.hidden = true;
      this.resetButton.addEventListener('click', () => this.view.reset());
      this.pointers = new Map();
      this.listen();
    }

    /** Measures the canvas and the axes. @returns whether there is anything to draw on */
    prepare() {
      this.width = this.surface.clientWidth;
      this.height = this.surface.clientHeight;
      if (this.width < 60) return false;
      this.ratio = Math.max(document.documentElement.classList.contains('printing') ? 2 : 1, window.devicePixelRatio || 1);
      for (const canvas of [this.canvas, this.overlay]) {
        canvas.width = Math.round(this.width * this.ratio);
        canvas.height = Math.round(this.height * this.ratio);
      }
      this.pen = this.canvas.getContext('2d');
      this.pen.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
      this.pen.font = '12px ' + FONT;
      this.top = this.topMargin();
      this.bottom = this.height - 40;
      const [low, high] = this.yRange();
      this.Y = scaling(this.data.y.log, low, high, this.bottom, this.top);
      const most = Math.max(2, Math.floor((this.bottom - this.top) / (this.data.y.log ? 22 : 28)));
      this.yTicks = (this.data.y.log ? logTicks : linearTicks)(low, high, most);
      return true;
    }

    topMargin() { return 24; }

    leftMargin() {
      return 10 + Math.max(...this.yTicks.major.map(t => this.pen.measureText(t.text).width), 18);
    }

    rightMargin() { return 14; }

    draw(left, right) {
      const pen = this.pen;
      this.left = left;
      this.right = this.width - right;
      this.X = scaling(this.data.x.log, ...this.view.range, this.left, this.right);
      const most = Math.max(2, Math.floor((this.right - this.left) / (this.data.x.log ? 34 : 84)));
      this.xTicks = (this.data.x.log ? logTicks : linearTicks)(...this.view.range, most);
      pen.clearRect(0, 0, this.width, this.height);
      this.inside(pen, () => this.background(pen));
      this.grid(pen);
      this.inside(pen, () => this.paint(pen));
      this.labels(pen);
      this.resetButton.hidden = !this.view.zoomed;
      this.paintOverlay();
    }

    inside(pen, work) {
      pen.save();
      pen.beginPath();
      pen.rect(this.left, this.top, this.right - this.left, this.bottom - this.top);
      pen.clip();
      work();
      pen.restore();
    }

    grid(pen) {
      pen.lineWidth = 1;
      const line = (x1, y1, x2, y2) => { pen.moveTo(x1, y1); pen.lineTo(x2, y2); };
      const sharp = p => Math.round(p) + 0.5;
      for (const [kind, alpha] of [['minor', 0.45], ['major', 1]]) {
        pen.globalAlpha = alpha;
        pen.strokeStyle = theme.grid;
        pen.beginPath();
        this.xTicks[kind].forEach(t => line(sharp(this.X.to(t.value)), this.top, sharp(this.X.to(t.value)), this.bottom));
        this.yTicks[kind].forEach(t => line(this.left, sharp(this.Y.to(t.value)), this.right, sharp(this.Y.to(t.value))));
        pen.stroke();
      }
      pen.globalAlpha = 1;
    }

    labels(pen) {
      pen.strokeStyle = theme.muted;
      pen.lineWidth = 1;
      pen.beginPath();
      pen.moveTo(this.left, Math.round(this.bottom) + 0.5);
      pen.lineTo(this.right, Math.round(this.bottom) + 0.5);
      pen.stroke();
      pen.fillStyle = theme.muted;
      pen.textBaseline = 'middle';
      pen.textAlign = 'right';
      this.yTicks.major.forEach(t => pen.fillText(t.text, this.left - 7, this.Y.to(t.value)));
      pen.textBaseline = 'alphabetic';
      pen.textAlign = 'center';
      let edge = -Infinity;
      for (const tick of this.xTicks.major) {
        const half = pen.measureText(tick.text).width / 2;
        const x = Math.max(half, Math.min(this.width - half, this.X.to(tick.value)));
        if (x - half > edge + 6) {
          pen.fillText(tick.text, x, this.bottom + 16);
          edge = x + half;
        }
      }
      pen.fillText(titleOf(this.data.x), (this.left + this.right) / 2, this.height - 6);
      pen.textAlign = 'left';
      pen.fillText(titleOf(this.data.y), 0, 12);
    }

    background() { }

    // Pointer and keys

    listen() {
      const surface = this.surface;
      const at = event => {
        const box = surface.getBoundingClientRect();
        return {x: event.clientX - box.left, y: event.clientY - box.top};
      };
      surface.addEventListener('pointerdown', event => {
        if (event.button !== 0) return;
        surface.classList.add('pointed'); // no ring about what a finger or a mouse has chosen
        surface.focus({preventScroll: true});
        surface.setPointerCapture(event.pointerId);
        this.pointers.set(event.pointerId, at(event));
        this.start = {...at(event), range: this.view.range.map(x => this.view.forward(x))};
        this.mode = event.pointerType === 'mouse' && !event.shiftKey ? 'select' : 'pan';
        this.startPinch();
      });
      surface.addEventListener('pointermove', event => {
        const p = at(event);
        if (this.pointers.has(event.pointerId)) this.pointers.set(event.pointerId, p);
        if (this.pointers.size === 2) this.pinch();
        else if (this.pointers.size === 1 && this.mode === 'pan') this.drag(p);
        this.cursor = p;
        this.view.point(this.X ? this.X.from(Math.max(this.left, Math.min(this.right, p.x))) : null);
      });
      const lift = event => {
        const p = at(event), wasOne = this.pointers.size === 1;
        if (!this.pointers.delete(event.pointerId)) return;
        if (wasOne && this.mode === 'select' && event.type === 'pointerup' && Math.abs(p.x - this.start.x) > 5) {
          const [a, b] = [p.x, this.start.x].map(x => this.view.forward(this.X.from(x))).sort((u, v) => u - v);
          this.view.show(a, b);
        }
        if (this.pointers.size === 0) this.mode = null;
        this.paintOverlay();
      };
      surface.addEventListener('pointerup', lift);
      surface.addEventListener('pointercancel', lift);
      surface.addEventListener('pointerleave', event => {
        if (event.pointerType === 'mouse' && !this.pointers.size) {
          this.cursor = null;
          this.view.point(null);
          surface.blur();
        }
      });
      surface.addEventListener('dblclick', () => this.view.reset());
      surface.addEventListener('wheel', event => {
        // Without focus or a modifier the wheel scrolls the page, as everywhere else on it.
        if (!event.ctrlKey && !event.metaKey && document.activeElement !== surface) return;
        event.preventDefault();
        const lines = event.deltaMode === 1 ? 16 : 1;
        if (Math.abs(event.deltaX) > Math.abs(event.deltaY)) this.view.pan(event.deltaX * lines / (this.right - this.left));
        else this.view.zoom(Math.exp(Math.max(-120, Math.min(120, event.deltaY * lines)) * 0.003), this.X.from(at(event).x));
      }, {passive: false});
      surface.addEventListener('keydown', event => {
        surface.classList.remove('pointed');
        const act = {
          ArrowLeft: () => this.view.pan(-0.1), ArrowRight: () => this.view.pan(0.1),
          '+': () => this.view.zoom(0.7), '=': () => this.view.zoom(0.7), '-': () => this.view.zoom(1 / 0.7),
          0: () => this.view.reset(), Home: () => this.view.reset(), Escape: () => this.view.point(null),
        }[event.key];
        if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
        event.preventDefault();
        act();
      });
    }

    drag(p) {
      const [a, b] = this.start.range;
      const shift = (this.start.x - p.x) / (this.right - this.left) * (b - a);
      if (this.view.zoomed) this.view.show(a + shift, b + shift);
    }

    startPinch() {
      if (this.pointers.size !== 2) return;
      const [p, q] = [...this.pointers.values()];
      this.start.gap = Math.max(20, Math.abs(p.x - q.x));
      this.start.centre = this.view.forward(this.X.from((p.x + q.x) / 2));
    }

    /** Keeps the x that was between two fingers between them. */
    pinch() {
      const [p, q] = [...this.pointers.values()];
      const [a, b] = this.start.range;
      const span = (b - a) * this.start.gap / Math.max(20, Math.abs(p.x - q.x));
      const part = ((p.x + q.x) / 2 - this.left) / (this.right - this.left);
      this.view.show(this.start.centre - part * span, this.start.centre + (1 - part) * span);
    }

    paintOverlay() {
      if (!this.X) return;
      const pen = this.overlay.getContext('2d');
      pen.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
      pen.clearRect(0, 0, this.width, this.height);
      if (this.mode === 'select' && this.cursor && this.pointers.size) {
        const x = Math.max(this.left, Math.min(this.right, this.cursor.x));
        pen.fillStyle = theme.accent;
        pen.globalAlpha = 0.14;
        pen.fillRect(Math.min(x, this.start.x), this.top, Math.abs(x - this.start.x), this.bottom - this.top);
        pen.globalAlpha = 1;
      }
      const x = this.view.hover;
      if (x === null || x < this.view.range[0] || x > this.view.range[1]) {
        this.readout.hidden = true;
        return;
      }
      for (const [colour, dash] of [[theme.paper, []], [theme.ink, [3, 3]]]) {
        pen.strokeStyle = colour;
        pen.setLineDash(dash);
        pen.beginPath();
        pen.moveTo(Math.round(this.X.to(x)) + 0.5, this.top);
        pen.lineTo(Math.round(this.X.to(x)) + 0.5, this.bottom);
        pen.stroke();
      }
      pen.setLineDash([]);
      const rows = this.read(x, pen);
      this.readout.hidden = !this.cursor;
      if (this.cursor) this.placeReadout(rows);
    }

    placeReadout(rows) {
      const table = make('table');
      for (const [colour, style, name, text] of rows) {
        const row = table.insertRow();
        const swatch = row.insertCell();
        if (style) {
          swatch.appendChild(make('span', 'swatch ' + style)).style.color = colour;
        }
        row.insertCell().textContent = name;
        row.insertCell().textContent = text;
      }
      this.readout.replaceChildren(table);
      const width = this.readout.offsetWidth, x = this.X.to(this.view.hover);
      const left = x + 14 + width > this.width ? x - 14 - width : x + 14;
      this.readout.style.left = Math.max(0, Math.min(this.width - width, left)) + 'px';
      const height = this.readout.offsetHeight;
      // On a narrow screen it would hide the curves under the finger: it goes over the legend there.
      this.readout.style.top = (this.width < 560 ? -height - 2 : Math.max(0, Math.min(this.bottom - height, this.cursor.y - 20))) + 'px';
    }
  }

  // ---- Curves ----------------------------------------------------------------------------------------------------------

  class LineChart extends Chart {
    constructor(figure, data, view) {
      super(figure, data, view);
      const xs = data.xs.map(positions);
      this.series = data.series.map(s => ({
        name: s.name, style: s.style, xs: xs[s.x], ys: values(s.y), order: data.series.length > 1 ? view.order(s.name) : 0, shown: true,
        band: s.band && {kind: s.band.kind, meaning: s.band.meaning, lower: values(s.band.lower), upper: values(s.band.upper)},
      }));
      this.buildLegend();
    }

    topMargin() { return this.data.markers.some(m => m[1]) ? 40 : 24; }

    colour(series) { return theme.series[series.order % theme.series.length]; }

    buildLegend() {
      const reasons = [...new Set(this.data.shades.map(s => s[2]).filter(r => r))];
      this.legend.hidden = this.series.length < 2 && !reasons.length && !this.series.some(s => s.band && s.band.meaning);
      for (const series of this.series) {
        const button = this.legend.appendChild(make('button'));
        button.type = 'button';
        button.title = 'Show or hide ' + series.name;
        button.setAttribute('aria-pressed', 'true');
        series.swatch = button.appendChild(make('span', 'swatch ' + series.style));
        button.appendChild(make('span', '', series.name));
        if (series.band && series.band.meaning) button.appendChild(make('span', 'muted', series.band.meaning));
        button.addEventListener('click', () => {
          series.shown = !series.shown;
          button.setAttribute('aria-pressed', series.shown);
          this.view.draw();
        });
      }
      for (const reason of reasons) {
        const key = this.legend.appendChild(make('span', 'key muted'));
        key.appendChild(make('span', 'swatch shade'));
        key.appendChild(make('span', '', reason));
      }
    }

    extent() {
      let low = Infinity, high = -Infinity;
      for (const {xs} of this.series) {
        const first = this.data.x.log ? firstAt(xs, Number.MIN_VALUE) : 0;
        if (first < xs.length) {
          low = Math.min(low, xs[first]);
          high = Math.max(high, xs[xs.length - 1]);
        }
      }
      return [this.data.x.low ?? low, this.data.x.high ?? high];
    }

    /** Indices of a series that lie in view, with one more on either side. */
    visible(series) {
      return [Math.max(0, firstAt(series.xs, this.view.range[0]) - 1),
        Math.min(series.xs.length, firstAt(series.xs, this.view.range[1]) + 2)];
    }

    yRange() {
      const axis = this.data.y;
      let low = Infinity, high = -Infinity;
      const take = v => {
        if (Number.isFinite(v) && (!axis.log || v > 0)) {
          low = Math.min(low, v);
          high = Math.max(high, v);
        }
      };
      for (const series of this.series.filter(s => s.shown)) {
        const [from, to] = this.visible(series);
        for (let i = from; i < to; i++) take(series.ys[i]);
        if (series.band) this.bandRange(series.band, from, to).forEach(take);
      }
      if (low > high) [low, high] = axis.log ? [0.1, 1] : [0, 1];
      if (low === high) [low, high] = axis.log ? [low / 2, high * 2] : [low - (Math.abs(low) || 1) / 2, high + (Math.abs(high) || 1) / 2];
      const margin = axis.log ? (high / low) ** 0.05 : (high - low) * 0.06;
      low = axis.low ?? (axis.log ? low / margin : low - margin);
      high = axis.high ?? (axis.log ? high * margin : high + margin);
      return low < high ? [low, high] : [low, axis.log ? low * 10 : low + 1];
    }

    /** All of a band of extremes; of an uncertainty all but its widest sixth, so that a start in ignorance hides nothing. */
    bandRange(band, from, to) {
      const end = (limits, part) => {
        const sorted = limits.slice(from, to).filter(Number.isFinite).sort();
        return sorted.length ? sorted[Math.round(part * (sorted.length - 1))] : NaN;
      };
      return band.kind === 'extremes' ? [end(band.lower, 0), end(band.upper, 1)] : [end(band.lower, 0.16), end(band.upper, 0.84)];
    }

    background(pen) {
      for (const [from, to] of this.data.shades) {
        const a = Math.max(this.left, this.X.to(Math.max(from, this.view.range[0])));
        const b = Math.min(this.right, this.X.to(Math.min(to, this.view.range[1])));
        if (!(b > a)) continue;
        pen.save();
        pen.beginPath();
        pen.rect(a, this.top, b - a, this.bottom - this.top);
        pen.clip();
        pen.fillStyle = theme.shade;
        pen.fillRect(a, this.top, b - a, this.bottom - this.top);
        pen.strokeStyle = theme.hatch;
        pen.lineWidth = 1;
        pen.beginPath();
        const rise = this.bottom - this.top;
        for (let x = Math.floor((a - rise) / 9) * 9; x < b; x += 9) {
          pen.moveTo(x, this.bottom);
          pen.lineTo(x + rise, this.top);
        }
        pen.stroke();
        pen.restore();
      }
    }

    paint(pen) {
      for (const series of this.series) series.swatch.style.color = this.colour(series);
      const shown = this.series.filter(s => s.shown);
      shown.filter(s => s.band).forEach(s => this.paintBand(pen, s));
      shown.forEach(s => s.style === 'points' ? this.paintPoints(pen, s) : this.paintLine(pen, s));
      this.paintMarkers(pen);
    }

    /** The samples in view, or four for every column of pixels: first, least, greatest, last. NaN parts two runs. */
    trace(series, low, high, run) {
      const {xs} = series, [from, to] = this.visible(series);
      const dense = to - from > 3 * (this.right - this.left);
      const defined = i => Number.isFinite(low[i]) && (!this.Y.log || low[i] > 0);
      let i = from;
      while (i < to) {
        while (i < to && !defined(i)) i++;
        const points = [];
        while (i < to && defined(i)) {
          const column = Math.floor(this.X.to(xs[i]));
          let first = i, least = i, greatest = i;
          if (dense) {
            while (i + 1 < to && defined(i + 1) && this.X.to(xs[i + 1]) < column + 1) {
              i++;
              if (low[i] < low[least]) least = i;
              if (high[i] > high[greatest]) greatest = i;
            }
          }
          points.push([this.X.to(xs[first]), low[least], high[greatest], low[first], low[i]]);
          i++;
        }
        if (points.length) run(points, dense);
      }
    }

    paintLine(pen, series) {
      // The mean of extremes that fill every pixel says nothing about them.
      if (series.band && series.band.kind === 'extremes' && this.crowded(series)) return;
      pen.strokeStyle = this.colour(series);
      pen.lineWidth = series.style === 'dashed' ? 2 : 1.6;
      pen.lineJoin = 'round';
      pen.setLineDash(series.style === 'dashed' ? [7, 5] : []);
      pen.beginPath();
      this.trace(series, series.ys, series.ys, (points, dense) => {
        points.forEach(([x, least, greatest, first, last], k) => {
          if (k === 0) pen.moveTo(points.length === 1 ? x - 1 : x, this.Y.to(first)); else pen.lineTo(x, this.Y.to(first));
          if (dense) [least, greatest, last].forEach(v => pen.lineTo(x, this.Y.to(v)));
        });
        if (points.length === 1) pen.lineTo(points[0][0] + 1, this.Y.to(points[0][4]));
      });
      if (this.crowded(series)) pen.lineWidth = 1;
      pen.stroke();
      pen.setLineDash([]);
    }

    /** Whether there is more than a sample for each pixel. */
    crowded(series) {
      const [from, to] = this.visible(series);
      return to - from > this.right - this.left;
    }

    paintPoints(pen, series) {
      pen.fillStyle = this.colour(series);
      const [from, to] = this.visible(series);
      const radius = to - from > (this.right - this.left) / 3 ? 1.6 : 2.8;
      for (let i = from; i < to; i++) {
        if (!Number.isFinite(series.ys[i])) continue;
        pen.beginPath();
        pen.arc(this.X.to(series.xs[i]), this.Y.to(series.ys[i]), radius, 0, 2 * Math.PI);
        pen.fill();
      }
    }

    paintBand(pen, series) {
      const extremes = series.band.kind === 'extremes';
      // On a logarithmic axis a band that reaches below zero goes down to the edge.
      const lower = this.Y.log ? series.band.lower.map(v => v <= 0 ? this.Y.low / 2 : v) : series.band.lower;
      pen.fillStyle = pen.strokeStyle = this.colour(series);
      pen.beginPath();
      this.trace(series, lower, series.band.upper, points => {
        points.forEach(([x, least], k) => k ? pen.lineTo(x, this.Y.to(least)) : pen.moveTo(x, this.Y.to(least)));
        for (let k = points.length - 1; k >= 0; k--) pen.lineTo(points[k][0], this.Y.to(points[k][2]));
        pen.closePath();
      });
      pen.globalAlpha = !extremes ? 0.17 : this.crowded(series) ? 0.62 : 0.3;
      pen.fill();
      if (extremes) {
        pen.lineWidth = 0.8;
        pen.stroke();
      }
      pen.globalAlpha = 1;
    }

    paintMarkers(pen) {
      pen.strokeStyle = theme.ink;
      pen.globalAlpha = 0.6;
      pen.lineWidth = 1;
      pen.setLineDash([]);
      pen.beginPath();
      for (const [at] of this.data.markers) {
        const x = Math.round(this.X.to(at)) + 0.5;
        pen.moveTo(x, this.top);
        pen.lineTo(x, this.bottom);
      }
      pen.stroke();
      pen.globalAlpha = 1;
    }

    /** Marker labels stand above their lines where they fit; the others are read out under the pointer. */
    labels(pen) {
      super.labels(pen);
      pen.textAlign = 'left';
      pen.fillStyle = theme.ink;
      let edge = -Infinity;
      for (const [at, label] of [...this.data.markers].sort((a, b) => a[0] - b[0])) {
        const x = this.X.to(at), width = pen.measureText(label).width;
        const from = Math.max(this.left, Math.min(this.right - width, x - width / 2));
        if (!label || x < this.left || x > this.right || from < edge + 10) continue;
        pen.fillText(label, from, this.top - 5);
        edge = from + width;
      }
    }

    read(x, pen) {
      const rows = [['', '', this.data.x.label, withUnit(readable(x), this.data.x.unit)]];
      const reach = 12 * (this.X.from(this.left + 1) - this.X.from(this.left));
      for (const series of this.series.filter(s => s.shown && s.xs.length)) {
        const i = nearest(series.xs, x), y = series.ys[i], colour = this.colour(series);
        const gap = Math.abs(this.X.to(series.xs[i]) - this.X.to(x)) > Math.max(12, reach / 1e9) && (i === 0 || i === series.xs.length - 1);
        let text = gap ? '–' : withUnit(readable(y), this.data.y.unit);
        if (!gap && series.band) {
          text += ` (${readable(series.band.lower[i])} to ${readable(series.band.upper[i])})`;
        }
        rows.push([colour, series.style, series.name, text]);
        const py = this.Y.to(y);
        if (!gap && py >= this.top && py <= this.bottom) {
          pen.beginPath();
          pen.arc(this.X.to(series.xs[i]), py, 3.5, 0, 2 * Math.PI);
          pen.fillStyle = colour;
          pen.fill();
          pen.lineWidth = 1.5;
          pen.strokeStyle = theme.paper;
          pen.stroke();
        }
      }
      for (const [at, label] of this.data.markers) {
        if (label && Math.abs(this.X.to(at) - this.X.to(x)) < 5) rows.push(['', '', label, withUnit(readable(at), this.data.x.unit)]);
      }
      for (const [from, to, reason] of this.data.shades) {
        if (reason && x >= from && x <= to) rows.push(['', 'shade', reason, '']);
      }
      return rows;
    }
  }

  // ---- Heat map --------------------------------------------------------------------------------------------------------

  class Heatmap extends Chart {
    constructor(figure, data, view) {
      super(figure, data, view);
      figure.classList.add('heatmap');
      this.columns = positions(data.columns);
      this.rows = positions(data.rows);
      this.levels = Uint8Array.from(atob(data.levels), c => c.charCodeAt(0));
    }

    step(centres) {
      return centres.length > 1 ? (centres[centres.length - 1] - centres[0]) / (centres.length - 1) : 1;
    }

    edges(centres, axis) {
      const half = this.step(centres) / 2;
      const low = centres[0] - half, high = centres[centres.length - 1] + half;
      return [axis.low ?? (axis.log && low <= 0 ? half : low), axis.high ?? high];
    }

    extent() { return this.edges(this.columns, this.data.x); }

    yRange() { return this.edges(this.rows, this.data.y); }

    rightMargin() {
      const {low, high} = this.data.colour;
      this.colourTicks = linearTicks(low, high, Math.floor((this.bottom - this.top) / 38)).major;
      return 14 + 14 + 7 + Math.max(...this.colourTicks.map(t => this.pen.measureText(t.text).width));
    }

    index(centres, value) {
      const i = Math.round((value - centres[0]) / this.step(centres));
      return i >= 0 && i < centres.length ? i : -1;
    }

    paint(pen) {
      const width = Math.round((this.right - this.left) * this.ratio), height = Math.round((this.bottom - this.top) * this.ratio);
      const image = pen.createImageData(width, height);
      const columns = Int32Array.from({length: width}, (_, i) => this.index(this.columns, this.X.from(this.left + (i + 0.5) / this.ratio)));
      for (let j = 0; j < height; j++) {
        const row = this.index(this.rows, this.Y.from(this.top + (j + 0.5) / this.ratio));
        for (let i = 0; i < width && row >= 0; i++) {
          const level = columns[i] < 0 ? 255 : this.levels[columns[i] * this.rows.length + row];
          if (level === 255) continue;
          image.data.set(VIRIDIS.subarray(3 * level, 3 * level + 3), 4 * (j * width + i));
          image.data[4 * (j * width + i) + 3] = 255;
        }
      }
      const layer = make('canvas');
      layer.width = width;
      layer.height = height;
      layer.getContext('2d').putImageData(image, 0, 0);
      pen.drawImage(layer, this.left, this.top, this.right - this.left, this.bottom - this.top);
    }

    labels(pen) {
      super.labels(pen);
      const left = this.right + 12, height = this.bottom - this.top;
      for (let j = 0; j < height; j++) {
        const level = Math.round((1 - j / (height - 1)) * 254);
        pen.fillStyle = `rgb(${VIRIDIS.subarray(3 * level, 3 * level + 3).join()})`;
        pen.fillRect(left, this.top + j, 12, 1.5);
      }
      const scale = scaling(false, this.data.colour.low, this.data.colour.high, this.bottom, this.top);
      pen.fillStyle = theme.muted;
      pen.textBaseline = 'middle';
      pen.textAlign = 'left';
      this.colourTicks.forEach(t => pen.fillText(t.text, left + 18, scale.to(t.value)));
      pen.textBaseline = 'alphabetic';
      pen.textAlign = 'right';
      pen.fillText(titleOf(this.data.colour), this.width, 12);
    }

    read(x) {
      const rows = [['', '', this.data.x.label, withUnit(readable(x), this.data.x.unit)]];
      if (!this.cursor) return rows;
      const y = this.Y.from(this.cursor.y), row = this.index(this.rows, y), column = this.index(this.columns, x);
      if (row < 0 || column < 0 || this.cursor.y > this.bottom || this.cursor.y < this.top) return rows;
      const {low, high, label, unit} = this.data.colour;
      const level = this.levels[column * this.rows.length + row];
      const sign = level === 0 ? '≤ ' : level === 254 ? '≥ ' : '';
      rows.push(['', '', this.data.y.label, withUnit(readable(this.rows[row]), this.data.y.unit)]);
      rows.push(['', '', label, level === 255 ? '–' : sign + withUnit(fixed(low + level / 254 * (high - low), 1), unit)]);
      return rows;
    }
  }

  // ---- All charts of the page ------------------------------------------------------------------------------------------

  const KINDS = {line: LineChart, heatmap: Heatmap};
  const views = new Map();
  readTheme();
  for (const figure of document.querySelectorAll('figure.chart')) {
    const data = JSON.parse(figure.querySelector('script').textContent);
    const key = data.group || figure;
    if (!views.has(key)) views.set(key, new View());
    const view = views.get(key);
    view.add(new KINDS[data.kind](figure, data, view));
  }
  const all = [...views.values()];
  const redraw = () => {
    readTheme();
    all.forEach(view => view.drawNow());
  };
  const observer = new ResizeObserver(() => all.forEach(view => view.draw()));
  document.querySelectorAll('.plot').forEach(plot => observer.observe(plot));
  addEventListener('pointerdown', event => {
    if (!event.target.closest('.surface')) {
      all.forEach(view => {
        view.charts.forEach(chart => { chart.cursor = null; });
        view.point(null);
      });
    }
  });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw);
  addEventListener('beforeprint', () => {
    document.documentElement.classList.add('printing');
    redraw();
  });
  addEventListener('afterprint', () => {
    document.documentElement.classList.remove('printing');
    redraw();
  });
  if (all.length) {
    document.querySelector('main').appendChild(make('p', 'help', 'Charts: drag to zoom, Shift-drag to pan, double-click to reset; '
      + 'the wheel zooms after a click or with Ctrl; two fingers on a touch screen; arrow keys, + and − with the keyboard. '
      + 'A name in the legend hides its curve.'));
  }
})();

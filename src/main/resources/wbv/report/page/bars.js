/* Values side by side: lying bars in groups, each group under its name, every value written at its end. */

class BarChart extends Chart {
  constructor(figure, data, view) {
    super(figure, data, view);
    this.series = data.bars.map(b => ({name: b.name, values: values(b.values), low: b.low && values(b.low), high: b.high && values(b.high),
      shown: true, order: b.colour}));
    this.legend.hidden = this.series.length < 2;
    for (const series of this.series) this.legendButton(series, 'bar');
    this.surface.setAttribute('aria-label', `Chart: ${data.title}. ` + data.groups.map((g, i) => g + ': '
      + this.series.map(s => `${s.name} ${withUnit(readable(s.values[i]), data.x.unit)}`).join(', ')).join('; '));
  }

  /** There is nothing to zoom in: only the pointer is followed. */
  listen() {
    this.surface.addEventListener('pointermove', event => {
      const box = this.surface.getBoundingClientRect();
      this.cursor = {x: event.clientX - box.left, y: event.clientY - box.top};
      this.paintOverlay();
    });
    this.surface.addEventListener('pointerleave', () => {
      this.cursor = null;
      this.paintOverlay();
    });
  }

  get thickness() { return this.tight ? this.shownSeries.length > 1 ? 7 : 10 : 15; }

  /** Room for the name of a group. */
  get heading() { return this.tight ? 15 : 24; }

  get shownSeries() { return this.series.filter(s => s.shown); }

  get pitch() { return this.heading + 2 + this.shownSeries.length * (this.thickness + 3) + (this.tight ? 2 : 10); }

  prepare() {
    this.surface.style.height = (this.tight ? 30 : 40) + this.topMargin() + this.data.groups.length * this.pitch + 'px';
    return super.prepare();
  }

  topMargin() { return this.data.markers.length ? this.tight ? 16 : 22 : 6; }

  leftMargin() { return 1; }

  /** Room for the longest value beside its bar. */
  rightMargin() {
    const texts = this.shownSeries.flatMap(s => [...s.values]).filter(Number.isFinite).map(v => withUnit(short(v), this.data.x.unit));
    return Math.max(62, 14 + Math.max(0, ...texts.map(t => this.pen.measureText(t).width)));
  }

  yRange() { return [0, 1]; }

  extent() {
    const all = this.series.flatMap(s => [...s.values, ...(s.low ?? []), ...(s.high ?? [])].filter(Number.isFinite));
    all.push(...this.data.markers.map(m => m[0]));
    const high = all.reduce((a, b) => Math.max(a, b), -Infinity);
    return [this.data.x.low ?? Math.min(0, ...all), this.data.x.high ?? (high > 0 ? high : 1)];
  }

  grid(pen) {
    pen.strokeStyle = theme.grid;
    pen.lineWidth = 1;
    pen.beginPath();
    for (const tick of this.xTicks.major) {
      const x = Math.round(this.X.to(tick.value)) + 0.5;
      pen.moveTo(x, this.top);
      pen.lineTo(x, this.bottom);
    }
    pen.stroke();
  }

  bar(group, k) {
    return this.top + group * this.pitch + this.heading + k * (this.thickness + 3);
  }

  paint() { }

  /** Lines at values to point out, each under its name. */
  paintMarkers(pen) {
    pen.strokeStyle = pen.fillStyle = theme.ink;
    pen.lineWidth = 1.2;
    pen.setLineDash([5, 3]);
    let edge = -Infinity;
    for (const [at, label] of [...this.data.markers].sort((a, b) => a[0] - b[0])) {
      const x = Math.round(this.X.to(at)) + 0.5, width = pen.measureText(label).width;
      pen.beginPath();
      pen.moveTo(x, this.top - 4);
      pen.lineTo(x, this.bottom);
      pen.stroke();
      const from = Math.max(this.left, edge + 10, Math.min(this.width - width, x - width / 2));
      pen.fillText(label, from, this.top - (this.tight ? 9 : 12));
      edge = from + width;
    }
    pen.setLineDash([]);
  }

  labels(pen) {
    this.yTicks = {major: [], minor: []};
    const saved = this.data.y.label;
    super.labels(pen);
    this.data.y.label = saved;
    pen.textAlign = 'left';
    pen.textBaseline = 'middle';
    this.paintMarkers(pen);
    const zero = this.X.to(Math.max(this.view.range[0], this.data.x.log ? this.view.range[0] : Math.min(0, this.view.range[1])));
    this.data.groups.forEach((group, g) => {
      pen.fillStyle = theme.ink;
      pen.font = '600 ' + this.font;
      this.parted(pen, this.fitted(pen, group), this.left, this.top + g * this.pitch + this.heading / 2 + 1);
      pen.font = this.font;
      this.shownSeries.forEach((series, k) => {
        const value = series.values[g];
        if (!Number.isFinite(value)) return;
        const end = this.X.to(value), y = this.bar(g, k);
        pen.fillStyle = this.colour(series);
        pen.beginPath();
        pen.roundRect(Math.min(zero, end), y, Math.max(1.5, Math.abs(end - zero)), this.thickness, [0, 2.5, 2.5, 0]);
        pen.fill();
        const far = this.whisker(pen, series, g, y + this.thickness / 2);
        const words = withUnit(short(value), this.data.x.unit), at = Math.max(end, zero, far) + 6;
        this.parted(pen, words, at, y + this.thickness / 2 + 0.5);
      });
    });
    for (const series of this.series) series.swatch.style.color = this.colour(series);
    pen.textBaseline = 'alphabetic';
  }

  /** Words with a pale edge that parts them from a marker behind them. */
  parted(pen, words, x, y) {
    pen.strokeStyle = theme.paper;
    pen.lineWidth = 4;
    pen.lineJoin = 'round';
    pen.strokeText(words, x, y);
    pen.fillStyle = theme.ink;
    pen.fillText(words, x, y);
  }

  /** Draws where a value may lie, with feet at both ends; returns the far end. */
  whisker(pen, series, g, y) {
    if (!series.low || !Number.isFinite(series.low[g]) || !Number.isFinite(series.high[g])) return -Infinity;
    const from = this.X.to(series.low[g]), to = this.X.to(series.high[g]);
    for (const [colour, width] of [[theme.paper, 4], [theme.ink, 1.3]]) { // a pale edge parts it from its bar
      pen.strokeStyle = colour;
      pen.lineWidth = width;
      pen.beginPath();
      pen.moveTo(from, y);
      pen.lineTo(to, y);
      for (const x of [from, to]) {
        pen.moveTo(x, y - 3.5);
        pen.lineTo(x, y + 3.5);
      }
      pen.stroke();
    }
    return to;
  }

  /** A value with where it may lie. */
  told(series, g) {
    const range = series.low && Number.isFinite(series.low[g])
      ? ' (' + readable(series.low[g]) + ' to ' + readable(series.high[g]) + ')' : '';
    return withUnit(readable(series.values[g]), this.data.x.unit) + range;
  }

  fitted(pen, text) {
    let part = text;
    while (part.length > 3 && pen.measureText(part).width > this.width - 8) part = part.slice(0, -2);
    return part === text ? text : part + '…';
  }

  colour(series) { return theme.series[series.order % theme.series.length]; }

  paintOverlay() {
    if (!this.X) return;
    const pen = this.overlay.getContext('2d');
    pen.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    pen.clearRect(0, 0, this.width, this.height);
    const g = this.cursor ? Math.floor((this.cursor.y - this.top) / this.pitch) : -1;
    this.readout.hidden = g < 0 || g >= this.data.groups.length;
    if (this.readout.hidden) return;
    pen.fillStyle = theme.accent;
    pen.globalAlpha = 0.07;
    pen.fillRect(0, this.top + g * this.pitch + 2, this.width, this.pitch - 4);
    pen.globalAlpha = 1;
    this.view.hover = this.X.from(Math.max(this.left, Math.min(this.right, this.cursor.x)));
    this.placeReadout([['', '', this.data.groups[g], ''], ...this.shownSeries.map(s =>
      [this.colour(s), 'bar', s.name, this.told(s, g)])]);
  }
}

/** Three digits, no more: bars are to be compared, not copied. */
function short(value) {
  if (!Number.isFinite(value) || value === 0) return readable(value);
  const exponent = Math.floor(Math.log10(Math.abs(value)));
  return exponent < -4 || exponent > 6 ? readable(value) : fixed(value, 2 - exponent);
}

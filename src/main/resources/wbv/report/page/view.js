/* A View is the range of x that the charts of a group share; they pan and zoom together. */

class View {
  constructor() {
    this.charts = [];
    this.names = [];
    this.explained = new Set();
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
    const ranges = this.charts.map(c => c.extent()).filter(r => r[1] >= r[0]);
    this.full = extended(this.log, Math.min(...ranges.map(r => r[0])), Math.max(...ranges.map(r => r[1])));
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

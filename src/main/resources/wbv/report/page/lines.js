/* Curves over x, with bands, markers and shaded ranges. */

class LineChart extends Chart {
  constructor(figure, data, view) {
    super(figure, data, view);
    const xs = data.xs.map(positions);
    this.series = data.series.map(s => ({
      name: s.name, style: s.style, xs: xs[s.x], ys: values(s.y), shown: true,
      order: data.series.length > 1 && s.style !== 'range' ? view.order(s.name) : 0,
      band: s.band && {kind: s.band.kind, meaning: s.band.meaning, lower: values(s.band.lower), upper: values(s.band.upper)},
    }));
    this.buildLegend();
  }

  topMargin() { return this.data.markers.some(m => m[1]) ? 40 : 24; }

  colour(series) { return series.style === 'range' ? theme.muted : theme.series[series.order % theme.series.length]; }

  buildLegend() {
    // Charts of a group need to be told once.
    const reasons = new Map(this.data.shades.filter(s => s[2] && !this.view.explained.has(s[2])).map(s => [s[2], s[3]]));
    for (const reason of reasons.keys()) this.view.explained.add(reason);
    // The rows of an axis with names are their own legend.
    this.legend.hidden = this.data.y.names && !reasons.size || this.series.length < 2 && !reasons.size && !this.series.some(s => s.band && s.band.meaning);
    for (const series of this.series) {
      const button = this.legendButton(series, series.style);
      button.hidden = !!this.data.y.names;
      if (series.band && series.band.meaning) button.appendChild(make('span', 'muted', series.band.meaning));
    }
    for (const [reason, pattern] of reasons) {
      const key = this.legend.appendChild(make('span', 'key muted'));
      key.appendChild(make('span', 'swatch shade pattern' + pattern));
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
    this.empty = low > high;
    [low, high] = extended(axis.log, low, high);
    const margin = axis.log ? (high / low) ** 0.05 : (high - low) * 0.06;
    low = axis.low ?? (axis.log ? low / margin : low - margin);
    high = axis.high ?? (axis.log ? high * margin : high + margin);
    return low < high ? [low, high] : [low, axis.log ? low * 10 : low + 1];
  }

  /** All of a band of extremes; of an uncertainty all but its widest sixth, so that a start in ignorance hides nothing. */
  bandRange(band, from, to) {
    if (band.kind === 'extremes') {
      let low = Infinity, high = -Infinity;
      for (let i = from; i < to; i++) {
        if (band.lower[i] < low) low = band.lower[i];
        if (band.upper[i] > high) high = band.upper[i];
      }
      return [low, high];
    }
    const end = (limits, part) => {
      const sorted = limits.slice(from, to).filter(Number.isFinite).sort();
      return sorted.length ? sorted[Math.round(part * (sorted.length - 1))] : NaN;
    };
    return [end(band.lower, 0.16), end(band.upper, 0.84)];
  }

  background(pen) {
    for (const [from, to, , pattern] of this.data.shades) {
      const a = Math.max(this.left, this.X.to(Math.max(from, this.view.range[0])));
      const b = Math.min(this.right, this.X.to(Math.min(to, this.view.range[1])));
      if (!(b > a)) continue;
      this.hatch(pen, a, b, pattern);
    }
  }

  paint(pen) {
    for (const series of this.series) series.swatch.style.color = this.colour(series);
    const shown = this.series.filter(s => s.shown);
    shown.filter(s => s.band).forEach(s => this.paintBand(pen, s));
    for (const s of shown) {
      if (s.style === 'points') this.paintPoints(pen, s);
      else if (s.style === 'strip') this.paintStrip(pen, s);
      else if (s.style !== 'range') this.paintLine(pen, s);
    }
    this.paintMarkers(pen);
    if (this.empty) {
      pen.fillStyle = theme.muted;
      pen.textAlign = 'center';
      pen.fillText('no values here', (this.left + this.right) / 2, (this.top + this.bottom) / 2);
    }
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
        if (k === 0) pen.moveTo(x, this.Y.to(first)); else pen.lineTo(x, this.Y.to(first));
        if (dense) [least, greatest, last].forEach(v => pen.lineTo(x, this.Y.to(v)));
      });
      if (points.length === 1) pen.arc(points[0][0], this.Y.to(points[0][3]), 1, 0, 2 * Math.PI); // alone between gaps
    });
    if (this.crowded(series)) pen.lineWidth = 1;
    pen.stroke();
    pen.setLineDash([]);
    if (series.style === 'line') this.paintSamples(pen, series);
  }

  /** Where samples stand far apart, each is seen. */
  paintSamples(pen, series) {
    const [from, to] = this.visible(series);
    if (to - from < 3 || to - from > (this.right - this.left) / 9 || series.xs.length < 1000) return;
    pen.fillStyle = this.colour(series);
    for (let i = from; i < to; i++) {
      if (!Number.isFinite(series.ys[i]) || this.Y.log && series.ys[i] <= 0) continue;
      pen.beginPath();
      pen.arc(this.X.to(series.xs[i]), this.Y.to(series.ys[i]), 2.2, 0, 2 * Math.PI);
      pen.fill();
    }
  }

  /** Bars as thick as their row allows, from the first x of a run to its last, never so short that they vanish. */
  paintStrip(pen, series) {
    pen.fillStyle = this.colour(series);
    const [from, to] = this.visible(series);
    const height = Math.max(2, 0.62 * Math.abs(this.Y.to(1) - this.Y.to(0)));
    for (let i = Math.max(0, from - 2); i < to; i++) {
      if (!Number.isFinite(series.ys[i])) continue;
      let last = i;
      while (last + 1 < series.xs.length && Number.isFinite(series.ys[last + 1])) last++;
      const x = this.X.to(series.xs[i]);
      pen.fillRect(x, this.Y.to(series.ys[i]) - height / 2, Math.max(1.2, this.X.to(series.xs[last]) - x), height);
      i = last;
    }
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
    const inView = this.data.markers.filter(m => m[0] >= this.view.range[0] && m[0] <= this.view.range[1]).length;
    pen.strokeStyle = theme.ink;
    pen.globalAlpha = Math.max(0.15, Math.min(0.6, 15 / inView)); // many lines must not hide the curves
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

  /** Whether a bar of a strip lies over an x. */
  covers(series, x) {
    const i = firstAt(series.xs, x);
    return i > 0 && i < series.xs.length && Number.isFinite(series.ys[i - 1]) && Number.isFinite(series.ys[i]);
  }

  read(x, pen) {
    const rows = [['', '', this.data.x.label, withUnit(readable(x), this.data.x.unit)]];
    for (const series of this.series.filter(s => s.shown && s.xs.length)) {
      if (series.style === 'strip') {
        if (this.covers(series, x)) rows.push([this.colour(series), 'bar', series.name, '']);
        continue;
      }
      const i = nearest(series.xs, x), y = series.ys[i], colour = this.colour(series);
      const beyond = Math.abs(this.X.to(series.xs[i]) - this.X.to(x)) > 12 && (i === 0 || i === series.xs.length - 1);
      let text = beyond ? '–' : withUnit(readable(y), this.data.y.unit);
      if (!beyond && series.band) {
        const between = `${readable(series.band.lower[i])} to ${readable(series.band.upper[i])}`;
        text = series.style === 'range' ? between : text + ` (${between})`;
      }
      rows.push([colour, series.style, series.name, text]);
      const py = this.Y.to(y);
      if (!beyond && py >= this.top && py <= this.bottom) {
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
      const near = Math.abs(this.X.to(at) - this.X.to(x)) < 5;
      if (label && near) rows.push(['', '', label, withUnit(readable(at), this.data.x.unit)]);
    }
    for (const [from, to, reason, pattern] of this.data.shades) {
      if (reason && x >= from && x <= to) rows.push(['', 'shade pattern' + pattern, reason, '']);
    }
    return rows;
  }
}

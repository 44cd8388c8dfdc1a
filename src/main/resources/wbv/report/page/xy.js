/* One quantity over another: clouds, loops, curves and areas. Reads out the point nearest to the pointer. */

class XyChart extends Chart {
  constructor(figure, data, view) {
    super(figure, data, view);
    figure.classList.add('xy');
    this.series = data.series.map(s => ({
      name: s.name, style: s.style, xs: values(s.x), ys: values(s.y), whisker: s.whisker && values(s.whisker), shown: true,
      order: s.colour >= 0 ? s.colour : data.series.length > 1 ? view.order(s.name) : 0,
    }));
    this.buildLegend();
  }

  colour(series) { return theme.series[series.order % theme.series.length]; }

  buildLegend() {
    this.legend.hidden = this.series.length < 2;
    for (const series of this.series) this.legendButton(series, series.style);
  }

  within(series, i) {
    const x = series.xs[i], y = series.ys[i];
    return Number.isFinite(x) && Number.isFinite(y) && (!this.data.x.log || x > 0) && (!this.data.y.log || y > 0);
  }

  extent() {
    const xs = this.series.flatMap(s => Array.from(s.xs.filter((x, i) => this.within(s, i))));
    const low = xs.reduce((a, b) => Math.min(a, b), Infinity), high = xs.reduce((a, b) => Math.max(a, b), -Infinity);
    const room = this.data.x.log ? 0 : 0.03 * (high - low);
    return [this.data.x.low ?? low - room, this.data.x.high ?? high + room];
  }

  yRange() {
    const axis = this.data.y, [from, to] = this.view.range;
    let low = Infinity, high = -Infinity;
    for (const series of this.series.filter(s => s.shown)) {
      for (let i = 0; i < series.xs.length; i++) {
        if (!this.within(series, i) || series.xs[i] < from || series.xs[i] > to) continue;
        low = Math.min(low, series.ys[i]);
        high = Math.max(high, series.ys[i]);
      }
    }
    [low, high] = extended(axis.log, low, high);
    const margin = axis.log ? (high / low) ** 0.05 : (high - low) * 0.05;
    low = axis.low ?? (axis.log ? low / margin : low - margin);
    high = axis.high ?? (axis.log ? high * margin : high + margin);
    return low < high ? [low, high] : [low, axis.log ? low * 10 : low + 1];
  }

  paint(pen) {
    this.zeroLines(pen);
    for (const series of this.series) series.swatch.style.color = this.colour(series);
    const shown = this.series.filter(s => s.shown);
    const depth = s => ['area', 'cloud', 'dashed', 'line', 'points'].indexOf(s.style);
    for (const series of shown.sort((a, b) => depth(a) - depth(b))) {
      pen.strokeStyle = pen.fillStyle = this.colour(series);
      if (series.style === 'cloud' || series.style === 'points') this.paintPoints(pen, series);
      else this.paintPath(pen, series);
    }
  }

  zeroLines(pen) {
    pen.strokeStyle = theme.line;
    pen.lineWidth = 1.5;
    pen.beginPath();
    if (!this.data.x.log) {
      pen.moveTo(Math.round(this.X.to(0)) + 0.5, this.top);
      pen.lineTo(Math.round(this.X.to(0)) + 0.5, this.bottom);
    }
    if (!this.data.y.log) {
      pen.moveTo(this.left, Math.round(this.Y.to(0)) + 0.5);
      pen.lineTo(this.right, Math.round(this.Y.to(0)) + 0.5);
    }
    pen.stroke();
  }

  paintPoints(pen, series) {
    const cloud = series.style === 'cloud';
    pen.globalAlpha = cloud ? (series.xs.length > 800 ? 0.3 : 0.5) : 1;
    for (let i = 0; i < series.xs.length; i++) {
      if (!this.within(series, i)) continue;
      const x = this.X.to(series.xs[i]), y = this.Y.to(series.ys[i]);
      if (cloud) {
        pen.beginPath();
        pen.arc(x, y, 1.7, 0, 2 * Math.PI);
        pen.fill();
        continue;
      }
      if (series.whisker && series.whisker[i] > 0) {
        pen.lineWidth = 1.5;
        pen.beginPath();
        pen.moveTo(x, this.Y.to(series.ys[i] - series.whisker[i]));
        pen.lineTo(x, this.Y.to(series.ys[i] + series.whisker[i]));
        pen.stroke();
      }
      pen.beginPath();
      pen.arc(x, y, 3.4, 0, 2 * Math.PI);
      pen.fill();
      pen.save();
      pen.lineWidth = 1.3;
      pen.strokeStyle = theme.paper; // parts the point from the cloud behind it
      pen.stroke();
      pen.restore();
    }
    pen.globalAlpha = 1;
  }

  paintPath(pen, series) {
    pen.lineWidth = series.style === 'line' ? 2.4 : 1.8;
    pen.lineJoin = 'round';
    pen.setLineDash(series.style === 'dashed' ? [7, 5] : []);
    pen.beginPath();
    let open = false;
    for (let i = 0; i < series.xs.length; i++) {
      if (!this.within(series, i)) {
        open = false;
        continue;
      }
      const x = this.X.to(series.xs[i]), y = this.Y.to(series.ys[i]);
      if (open) pen.lineTo(x, y); else pen.moveTo(x, y);
      open = true;
    }
    if (series.style === 'area') {
      pen.closePath();
      pen.globalAlpha = 0.16;
      pen.fill();
      pen.globalAlpha = 1;
    } else if (series.style === 'line') {
      // A rim keeps the curve apart from the cloud that it runs through.
      pen.save();
      pen.strokeStyle = theme.paper;
      pen.lineWidth = 4.6;
      pen.stroke();
      pen.restore();
    }
    pen.stroke();
    pen.setLineDash([]);
  }

  read(x, pen) {
    const rows = [['', '', this.data.x.label, withUnit(readable(x), this.data.x.unit)]];
    if (!this.cursor) return rows;
    let best = null, least = 24;
    for (const series of this.series.filter(s => s.shown)) {
      for (let i = 0; i < series.xs.length; i++) {
        if (!this.within(series, i)) continue;
        const away = Math.hypot(this.X.to(series.xs[i]) - this.cursor.x, this.Y.to(series.ys[i]) - this.cursor.y);
        // A mean or a law is worth more than one of a thousand points.
        if (away + (series.style === 'cloud' ? 8 : 0) < least) {
          least = away + (series.style === 'cloud' ? 8 : 0);
          best = {series, i};
        }
      }
    }
    if (!best) {
      rows.push(['', '', this.data.y.label, withUnit(readable(this.Y.from(this.cursor.y)), this.data.y.unit)]);
      return rows;
    }
    const {series, i} = best, colour = this.colour(series);
    pen.beginPath();
    pen.arc(this.X.to(series.xs[i]), this.Y.to(series.ys[i]), 4.5, 0, 2 * Math.PI);
    pen.fillStyle = colour;
    pen.fill();
    pen.lineWidth = 1.5;
    pen.strokeStyle = theme.ink;
    pen.stroke();
    rows[0] = ['', '', this.data.x.label, withUnit(readable(series.xs[i]), this.data.x.unit)];
    const error = series.whisker && series.whisker[i] > 0 ? ' ± ' + readable(series.whisker[i]) : '';
    rows.push([colour, series.style, series.name, withUnit(readable(series.ys[i]) + error, this.data.y.unit)]);
    return rows;
  }
}

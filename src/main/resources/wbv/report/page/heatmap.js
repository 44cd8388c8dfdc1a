/* A value over two axes in colour. */

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

  /** What was measured is painted over it: it shows where something is missing. */
  background(pen) { this.hatch(pen, this.left, this.right); }

  paint(pen) {
    const width = Math.round((this.right - this.left) * this.ratio), height = Math.round((this.bottom - this.top) * this.ratio);
    const image = pen.createImageData(width, height);
    const columns = Int32Array.from({length: width},
      (_, i) => this.index(this.columns, this.X.from(this.left + (i + 0.5) / this.ratio)));
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

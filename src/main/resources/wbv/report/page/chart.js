/* A Chart knows its axes, its canvas, the pointer and the keys; its kinds know how to paint and what to read out. */

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

  /** A name in the legend that hides and shows its series. @returns the button */
  legendButton(series, style) {
    const button = this.legend.appendChild(make('button'));
    button.type = 'button';
    button.title = 'Show or hide ' + series.name;
    button.setAttribute('aria-pressed', 'true');
    series.swatch = button.appendChild(make('span', 'swatch ' + style));
    button.appendChild(make('span', '', series.name));
    button.addEventListener('click', () => {
      series.shown = !series.shown;
      button.setAttribute('aria-pressed', series.shown);
      this.view.draw();
    });
    return button;
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
    this.pen.font = this.font;
    this.top = this.topMargin();
    this.bottom = this.height - (this.tight ? 30 : 40);
    const [low, high] = this.yRange();
    this.Y = scaling(this.data.y.log, low, high, this.bottom, this.top);
    const most = Math.max(2, Math.floor((this.bottom - this.top) / (this.tight ? 11 : this.data.y.log ? 22 : 28)));
    this.yTicks = this.data.y.names ? namedTicks(this.data.y.names)
        : (this.data.y.log ? logTicks : linearTicks)(low, high, most);
    return true;
  }

  /** True where one printed page has to hold the chart. */
  get tight() { return document.body.classList.contains('sheet') && document.documentElement.classList.contains('printing'); }

  get font() { return (this.tight ? '9px ' : '12px ') + FONT; }

  topMargin() { return this.tight ? 18 : 24; }

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
        pen.fillText(tick.text, x, this.bottom + (this.tight ? 12 : 16));
        edge = x + half;
      }
    }
    pen.fillText(titleOf(this.data.x), (this.left + this.right) / 2, this.height - (this.tight ? 4 : 6));
    pen.textAlign = 'left';
    pen.fillText(titleOf(this.data.y), 0, this.tight ? 9 : 12);
  }

  background() { }

  /** Hatches what is not to be believed, from one x to another, both in pixels. Patterns are told apart without colour. */
  hatch(pen, a, b, pattern = 0) {
    pen.save();
    pen.beginPath();
    pen.rect(a, this.top, b - a, this.bottom - this.top);
    pen.clip();
    pen.fillStyle = pattern ? theme.doubt : theme.shade;
    pen.fillRect(a, this.top, b - a, this.bottom - this.top);
    pen.strokeStyle = theme.hatch;
    pen.lineWidth = 1;
    pen.beginPath();
    const rise = this.bottom - this.top;
    const step = pattern === 2 ? 18 : 9;
    for (let x = Math.floor((a - rise) / step) * step; x < b; x += step) {
      pen.moveTo(x, pattern ? this.top : this.bottom);
      pen.lineTo(x + rise, pattern ? this.bottom : this.top);
    }
    pen.stroke();
    pen.restore();
  }

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
    const beside = Math.max(0, Math.min(this.bottom - height, this.cursor.y - 20));
    this.readout.style.top = (this.width < 560 ? -height - 2 : beside) + 'px';
  }
}

/*
 * Finds the charts of the page, each beside its data as JSON, and keeps them drawn. No library, no network.
 *
 * All scripts of a page are one: axes, view, chart, the kinds of chart, and this. A new kind is a class in a file of its own.
 */

const KINDS = {line: LineChart, xy: XyChart, bars: BarChart, heatmap: Heatmap};
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
const contents = document.querySelector('nav');
if (contents) { // a heading that is jumped to comes to stand below the contents, whatever room they take
  new ResizeObserver(() => document.documentElement.style.setProperty('--nav', contents.offsetHeight + 12 + 'px')).observe(contents);
}
/** A sheet gets smaller until it fits one page, of A4 or Letter: the shorter of them has 258 mm between its margins. */
function fit() {
  if (!document.body.classList.contains('sheet')) return;
  const room = 258 / 25.4 * 96;
  const height = () => document.querySelector('main > section').getBoundingClientRect().bottom
    - document.body.getBoundingClientRect().top;
  for (let part = 1; part > 0.5 && height() > room; part -= 0.04) {
    document.body.style.setProperty('--fit', part.toFixed(2));
    redraw();
  }
}
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
  fit();
});
addEventListener('afterprint', () => {
  document.documentElement.classList.remove('printing');
  document.body.style.removeProperty('--fit');
  redraw();
});
if (all.length) {
  document.querySelector('main').appendChild(make('p', 'help', 'Charts: drag to zoom, Shift-drag to pan, double-click to '
    + 'reset; the wheel zooms after a click or with Ctrl; two fingers on a touch screen; arrow keys, + and − with the '
    + 'keyboard. A name in the legend hides its curve.'));
}

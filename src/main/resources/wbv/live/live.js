/*
 * The live page: what the server tells, shown as it comes. Words from senders come onto the page as text, never as markup.
 */

const ACTION = 0.5, LIMIT = 1.15, ACTION_DOSE = 9.1, LIMIT_DOSE = 21; // Directive 2002/44/EC [m/s², m/s^1.75]
const WINDOW = 8; // what moves [s]
const MOST_SAMPLES = 20000, MOST_POINTS = 2000, MOST_ALARMS = 60;
const DOSE = 'm/s¹·⁷⁵';
const at = id => document.getElementById(id);

// Numbers in words

function significant(value, digits) {
  if (!Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  return fixed(value, digits - 1 - Math.floor(Math.log10(Math.abs(value)) + 1e-12));
}

/** A value and its two deviations, to the digits that these deserve. */
function within(value, deviation) {
  const decimals = Math.max(0, 1 - Math.floor(Math.log10(2 * deviation)) - (2 * deviation >= 10 ** Math.ceil(Math.log10(2 * deviation) - 0.52) ? 1 : 0));
  return [fixed(value, decimals), '± ' + fixed(2 * deviation, decimals)];
}

function minutes(value) {
  if (value === null || !Number.isFinite(value)) return '–';
  if (value > 1440) return 'over 24 h';
  if (value < 1) return value > 0 ? '< 1 min' : 'reached';
  const whole = Math.round(value), hours = Math.floor(whole / 60);
  return hours ? `${hours} h ${whole % 60 ? String(whole % 60) + ' min' : ''}`.trim() : `${whole} min`;
}

/** A sensor's time: hours, minutes and seconds since its beginning. */
function clockTime(seconds) {
  if (seconds === null || !Number.isFinite(seconds)) return '';
  const s = Math.floor(Math.abs(seconds)), two = n => String(n).padStart(2, '0');
  return (seconds < 0 ? '−' : '') + (s >= 3600 ? `${Math.floor(s / 3600)}:${two(Math.floor(s / 60) % 60)}` : Math.floor(s / 60)) + ':' + two(s % 60);
}

const many = value => value.toLocaleString('en').replace(/,/g, ' ');

// Charts

/** Curves, some of them in the colour of what they stand for. */
class TonedChart extends LineChart {
  colour(series) {
    const tone = this.data.tones && this.data.tones[series.name];
    return tone ? getComputedStyle(document.documentElement).getPropertyValue('--' + tone).trim() : super.colour(series);
  }
}

/** A chart whose curves grow at the right. While someone has zoomed into it, it stands still. */
class Moving {
  constructor(parent, data, group) {
    this.figure = make('figure', 'chart');
    this.figure.appendChild(make('figcaption', '', data.title));
    this.figure.appendChild(make('div', 'plot'));
    at(parent).replaceChildren(this.figure);
    this.view = group || new View();
    this.chart = new TonedChart(this.figure, data, this.view);
    this.view.add(this.chart);
    new ResizeObserver(() => this.view.draw()).observe(this.figure);
    charts.push(this);
  }

  show(full, xs, curves, bands = []) {
    if (this.view.zoomed) return;
    this.chart.series.forEach((series, i) => {
      series.xs = xs;
      series.ys = curves[i] || new Float64Array(xs.length).fill(NaN);
      if (series.band && bands[i]) [series.band.lower, series.band.upper] = bands[i];
    });
    this.view.full = this.view.range = full;
    if (!document.hidden) this.view.draw();
  }

  mark(markers) { this.chart.data.markers = markers; }
}

const charts = [];
const series = (name, style = 'line', band = undefined) => ({name, style, x: 0, y: [], band});
const chartOf = (title, x, y, list) => ({kind: 'line', title, x, y, xs: [[]], series: list, markers: [], shades: []});
const axis = (label, unit, more = {}) => ({label, unit, log: false, ...more});
const deviations = () => ({kind: 'deviation', meaning: '± 2σ', lower: [], upper: []});

// Tiles

const SVG = 'http://www.w3.org/2000/svg';

function shape(parent, tag, attributes, text) {
  const element = parent.appendChild(document.createElementNS(SVG, tag));
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  if (text !== undefined) element.textContent = text;
  return element;
}

/** A small scale, as the report's. */
function gauge(to, ranges, marks, points) {
  const svg = document.createElementNS(SVG, 'svg');
  svg.setAttribute('class', 'gauge');
  svg.setAttribute('viewBox', `-4 0 208 ${marks.length ? 34 : 24}`);
  svg.setAttribute('aria-hidden', 'true');
  const x = value => (200 * Math.max(0, Math.min(to, value)) / to).toFixed(1);
  shape(svg, 'rect', {class: 'scale', x: 0, y: 10, width: 200, height: 10, rx: 2});
  for (const [from, until, kind] of ranges) {
    shape(svg, 'rect', {class: kind, x: x(from), y: 10, width: Math.max(0.4, x(until) - x(from)).toFixed(1), height: 10});
  }
  for (const [value, label] of marks) {
    const half = 2.8 * label.length;
    shape(svg, 'path', {class: 'mark', d: `M${x(value)} 7V22`});
    shape(svg, 'text', {x: Math.max(half - 4, Math.min(204 - half, x(value))), y: 33}, label);
  }
  for (const [value, deviation] of points) {
    if (deviation) shape(svg, 'path', {class: 'whisker', d: `M${x(value - deviation)} 15H${x(value + deviation)}`});
    shape(svg, 'circle', {class: 'point', cx: x(value), cy: 15, r: 5});
  }
  return svg;
}

function tile(title, tone, value, unit, picture, lines) {
  const section = make('section', 'tile ' + tone);
  section.appendChild(make('h3', '', title));
  const reading = section.appendChild(make('p', 'reading'));
  reading.appendChild(make('span', 'value', value));
  if (unit) reading.appendChild(make('span', 'unit', unit));
  if (picture) section.appendChild(picture);
  lines.filter(line => line).forEach(line => section.appendChild(make('p', '', line)));
  return section;
}

const reached = share => share >= LIMIT / ACTION ? 'fault' : share >= 1 ? 'warning' : 'good';

/** What decides an exposure, A(8) or the dose: its share of the action value, and itself in words. */
function deciding(exposure) {
  const a8 = exposure.a8_m_s2 || 0, dose = exposure['vdv_m_s1.75'] || 0;
  // The two scales are alike: 1.15 / 0.5 is 21 / 9.1. So the dose decides where it reaches further, and a value.
  const byDose = dose / ACTION_DOSE > a8 / ACTION && dose >= ACTION_DOSE;
  const share = byDose ? dose / ACTION_DOSE : a8 / ACTION;
  return byDose ? {byDose, share, tone: reached(share), value: significant(dose, 2), unit: DOSE, words: `dose ${significant(dose, 2)} ${DOSE}`}
    : {byDose, share, tone: reached(share), value: significant(a8, 2), unit: 'm/s²', words: `A(8) ${significant(a8, 2)} m/s²`};
}

function exposureTiles(exposure) {
  if (!exposure) return [tile('Exposure so far', 'plain', '–', '', null, ['No acceleration of the seat comes.'])];
  const a8 = exposure.a8_m_s2 || 0, dose = exposure['vdv_m_s1.75'] || 0, by = deciding(exposure), tone = by.tone;
  const end = Math.max(3, 1.1 * by.share), limit = LIMIT / ACTION;
  const key = by.byDose ? 'vdv_m_s1.75' : 'a8_m_s2';
  const worst = exposure.axes.reduce((one, other) => other[key] > one[key] ? other : one, exposure.axes[0]);
  const so = tile('Exposure so far', tone, by.value, by.unit,
    gauge(end, [[0, 1, 'good'], [1, limit, 'warning'], [limit, end, 'fault']],
      by.byDose ? [[1, 'action 9.1'], [limit, 'limit 21']] : [[1, 'action 0.5'], [limit, 'limit 1.15']], [[by.share]]),
    [`${by.byDose ? 'Dose' : 'A(8)'} along ${worst.axis}: ${exposure.verdict}.`,
      `${by.byDose ? `A(8) ${significant(a8, 2)} m/s²` : `Dose ${significant(dose, 2)} ${DOSE}`}; ${minutes(exposure.seconds / 60)} measured${exposure.missing_s > 5 ? `, ${minutes(exposure.missing_s / 60)} missing` : ''}.`,
      `Last second: ${exposure.axes.map(each => `${each.axis} ${significant(each.running_m_s2, 2)}`).join(', ')} m/s².`]);
  const left = exposure.minutes_to_action_value, further = exposure.minutes_to_limit_value;
  const until = tone === 'good' ? left : further;
  const time = tile(tone === 'good' ? 'Time to the action value' : tone === 'warning' ? 'Time to the limit value' : 'Time left', tone,
    tone === 'fault' ? 'none' : until === null ? 'no end' : minutes(until), '', null,
    [tone === 'fault' ? 'The exposure limit value is reached: nobody may be exposed to more.' : 'If the shift goes on as so far.',
      tone === 'good' ? `Limit value: ${further === null ? 'not reached' : further > 1440 ? 'not within a day' : 'in ' + minutes(further)}.` : '',
      by.byDose ? `The dose is ${significant(100 * by.share / (LIMIT / ACTION), 2)} % of its limit value.` : `${significant(100 * (a8 / ACTION) ** 2, 2)} of the action value's 100 points.`]);
  return [so, time];
}

function bodyTile(bodies, plan) {
  const body = bodies && bodies[0];
  if (!body) return tile('Body', 'plain', '–', '', null, ['Nothing that answers a base is measured.']);
  const mode = body.modes[0], share = Math.max(0, body.explained || 0);
  const where = `${body.output}: ${body.explained === null ? 'nothing explained yet' : significant(100 * share, 2) + ' % explained'}.`;
  if (!body.stands) {
    return tile('Body', 'plain', '–', '', gauge(12, [], [[5, '5 Hz'], [10, '10']], []),
      [share < 0.5 ? 'No natural frequency: too little of it is explained yet.' : 'No natural frequency: the last samples do not determine it.', where]);
  }
  const [f, df] = within(mode.natural_frequency_hz, mode.natural_frequency_deviation_hz);
  const [z, dz] = within(mode.damping_ratio, mode.damping_ratio_deviation);
  return tile('Body', 'good', f, `${df} Hz`, gauge(12, [], [[5, '5 Hz'], [10, '10']], [[mode.natural_frequency_hz, 2 * mode.natural_frequency_deviation_hz]]),
    [`Damping ratio ${z} ${dz}.`, where, body.excited ? '' : 'Little moves now: the numbers hold, their doubt grows.']);
}

function stateTile(state) {
  if (!state) return tile('Motion', 'plain', '–', '', null, ['Motion states need vertical acceleration of seat and head, roll and pitch rate, at 60 Hz.']);
  const ahead = Object.entries(state.jerk_within).map(([when, p]) => [when.replace('_s', ''), p]);
  const jolt = ahead[ahead.length - 1];
  return tile('Motion', jolt[1] > 0.5 ? 'warning' : 'good', state.name.replace('-', ' '), '',
    gauge(1, [[0, jolt[1], jolt[1] > 0.5 ? 'fault' : 'share']], [], []),
    [`A jerk within ${jolt[0]} s: ${significant(100 * jolt[1], 2)} %.`, `Sure of it: ${Math.floor(100 * state.probability)} %.`]);
}

function dataTile(data, losses) {
  if (!data) return tile('Data', 'plain', '–', '', null, []);
  const lost = data.missing + data.rows ? data.missing / (data.missing + data.rows) : 0;
  const holes = losses ? losses.values / Math.max(1, data.rows * data.channels) : 0;
  const tone = data.silent ? 'fault' : data.ailing || lost > 0.05 ? 'warning' : 'good';
  const odd = [[data.missing, 'missing'], [data.repeated, 'repeated'], [data.late, 'late'], [data.restarts, data.restarts === 1 ? 'restart' : 'restarts']].filter(([n]) => n);
  return tile('Data', tone, data.silent ? 'silent' : significant(data.rate_hz, 4), data.silent ? '' : 'Hz', null,
    [data.ailing ? `${data.ailing} of ${data.channels} channels stand still or are missing.` : `${data.channels} channels, all alive.`,
      `${many(data.rows)} rows` + (odd.length ? ': ' + odd.map(([n, what]) => `${many(n)} ${what}`).join(', ') : ', none missing') + '.',
      holes > 0 ? `${significant(100 * holes, 2)} % of their cells are empty.` : '']);
}

// The seated person, as in the report

const PARTS = [[128, 34, 'head', 'helmet', 'skull'], [122, 76, 'neck', 'c7'], [142, 124, 'sternum', 'chest', 'stern'], [121, 98, 'shoulder', 'acromion'],
  [99, 118, 't1', 't4', 't8', 't12', 'upper_back', 'thorax', 'spine'], [94, 176, 'lumbar', 'l1', 'l3', 'l5', 'back_low'], [128, 132, 'upper_arm', 'upperarm'],
  [164, 172, 'forearm', 'lower_arm'], [196, 180, 'hand', 'wrist'], [163, 210, 'thigh', 'femur', 'upper_leg', 'upperleg'], [212, 206, 'knee'],
  [214, 262, 'shank', 'tibia', 'lower_leg', 'lowerleg', 'shin'], [236, 322, 'foot', 'ankle', 'toe'], [106, 212, 'pelvis', 'hip', 'sacrum'],
  [62, 130, 'backrest', 'seat_back', 'back'], [140, 238, 'seat', 'cushion'], [52, 336, 'platform', 'base', 'floor', 'cabin']];

function person(places) {
  const taken = [];
  at('sensors').hidden = false;
  at('dots').replaceChildren();
  at('places').replaceChildren();
  places.forEach(({place, ails}, i) => {
    const tone = ails ? 'warning' : 'good', part = PARTS.find(([, , ...words]) => words.some(word => place.includes(word)));
    if (part) {
      const far = place.startsWith('left') || place.startsWith('l_') || place.endsWith('_l') || place.endsWith('_left');
      const spot = [part[0] - (far ? 15 : 0), part[1] - (far ? 12 : 0)];
      for (let k = 0; k < 8 && taken.some(([x, y]) => Math.hypot(x - spot[0], y - spot[1]) < 17); k++) spot[0] += 19;
      taken.push(spot);
      const group = shape(at('dots'), 'g', {class: tone});
      shape(group, 'circle', {cx: spot[0], cy: spot[1], r: 9});
      shape(group, 'text', {x: spot[0], y: spot[1] + 3.7}, i + 1);
    }
    const item = at('places').appendChild(make('li', tone));
    item.appendChild(make('b', '', place));
    item.appendChild(make('span', 'found', ails ? 'stands still or is missing' : 'alive'));
  });
}

// One seat

let seen = null; // what is shown of one seat

function begin(name, plan) {
  charts.length = 0;
  seen = {name, plan, data: null, result: null, samples: {t: [], u: [], y: [], p: []}, history: {}, changes: [], places: ''};
  const input = plan.input || 'seat', unit = plan.unit || 'm/s²', followed = Boolean(plan.output);
  const quantity = unit === 'rad/s' ? 'Angular rate' : 'Acceleration';
  seen.moving = new Moving('moving', chartOf(`The last ${WINDOW} seconds`, axis('Time', 's'), axis(quantity, unit),
    followed ? [series(input), series(plan.output), series(plan.output + ' as foreseen', 'dashed')] : [series(input)]));
  at('frequency').hidden = !followed;
  if (followed) {
    seen.frequency = new Moving('frequency', chartOf(`Natural frequency of ${plan.output}`, axis('Time', 'min'), axis('Natural frequency', 'Hz'),
      [series('natural frequency', 'line', deviations())]));
  }
  at('exposure').hidden = !plan.place;
  if (plan.place) {
    seen.exposure = new Moving('exposure', {tones: {'action value': 'warning', 'limit value': 'fault'}, ...chartOf('Exposure of the shift so far', axis('Time', 'min'), axis('A(8)', 'm/s²', {low: 0}),
      [series('A(8) so far'), series('action value', 'dashed'), series('limit value', 'dashed')])});
  }
  at('sensors').hidden = true;
}

function append(into, news, most) {
  for (const [name, list] of Object.entries(news)) {
    if (!Array.isArray(list)) continue;
    const all = into[name] = (into[name] || []);
    for (const value of list) all.push(value === null ? NaN : value);
    if (all.length > 2 * most) all.splice(0, all.length - most);
  }
}

function drawSamples() {
  const {t, u, y, p} = seen.samples;
  if (t.length < 2) return;
  const end = t[t.length - 1], from = Math.max(0, firstAt(t, end - WINDOW - 1));
  const part = list => Float64Array.from(list.slice(from));
  seen.moving.show([end - WINDOW, end], part(t), [u, y, p].filter(list => list && list.length).map(part));
}

function drawHistory() {
  const {t, f, df, a8} = seen.history;
  if (!t || t.length < 2) return;
  const xs = Float64Array.from(t, each => each / 60), full = [xs[0], xs[xs.length - 1]];
  const of = list => Float64Array.from(list);
  if (seen.frequency) {
    const low = of(f).map((v, i) => v - 2 * df[i]), high = of(f).map((v, i) => v + 2 * df[i]);
    seen.frequency.mark(seen.changes.map(time => [time / 60, '']));
    seen.frequency.show(full, xs, [of(f)], [[low, high]]);
  }
  if (seen.exposure) {
    const most = Math.max(0, ...a8.filter(Number.isFinite)), flat = value => new Float64Array(xs.length).fill(value);
    seen.exposure.chart.data.y.high = 1.08 * Math.max(LIMIT, most);
    seen.exposure.show(full, xs, [of(a8), flat(ACTION), flat(LIMIT)]);
  }
}

function sentence() {
  const {result, plan} = seen, exposure = result && result.exposure, body = result && result.bodies[0];
  const words = [];
  if (exposure) {
    const {tone, words: amount} = deciding(exposure), until = tone === 'good' ? exposure.minutes_to_action_value : exposure.minutes_to_limit_value;
    const goes = tone === 'fault' ? '' : until === null || until > 1440 ? '; as it goes on, it stays so for the day'
      : `; as it goes on, the ${tone === 'good' ? 'action' : 'limit'} value is reached in ${minutes(until)}`;
    words.push(`After ${minutes(exposure.seconds / 60)} the exposure is ${exposure.verdict} (${amount})${goes}.`);
  }
  if (body && body.stands) {
    words.push(`From ${plan.input.split('.')[0]} to ${plan.output.split('.')[0]}: natural frequency ${within(body.modes[0].natural_frequency_hz, body.modes[0].natural_frequency_deviation_hz).join(' ')} Hz.`);
  }
  return words.join(' ');
}

function drawResult() {
  const {result, data} = seen;
  if (!result) return;
  at('lead').textContent = sentence();
  at('tiles').replaceChildren(...exposureTiles(result.exposure), bodyTile(result.bodies, seen.plan), stateTile(result.state), dataTile(data, result.losses));
  const first = shownSeats > 1 ? seen.name + ' · ' : '';
  document.title = first + (result.exposure ? deciding(result.exposure).words + ' · ' : '') + 'wbv live';
}

// All seats

let shownSeats = 0;

function drawTable(news) {
  shownSeats = news.seats;
  at('seats').hidden = news.seats < 2;
  if (news.seats < 2) return;
  at('seats-count').textContent = many(news.seats) + (news.table.length < news.seats ? `, the first ${news.table.length} by attention` : ', by attention');
  const body = at('seats-rows');
  while (body.rows.length > news.table.length) body.deleteRow(-1);
  news.table.forEach((entry, i) => {
    const row = body.rows[i] || newRow(body), exposure = entry.exposure, mode = entry.bodies && entry.bodies[0];
    row.className = entry.tone;
    row.toggleAttribute('aria-current', Boolean(seen && seen.name === entry.seat));
    const link = row.cells[0].firstChild;
    setText(link, entry.seat);
    link.href = '#seat=' + encodeURIComponent(entry.seat);
    setText(row.cells[1].lastChild, entry.attention || (entry.exposure || entry.bodies ? 'none' : 'begins'));
    const by = exposure && deciding(exposure);
    row.cells[2].firstChild.firstChild.style.width = `${by ? Math.min(100, 100 * by.share / 3) : 0}%`;
    setText(row.cells[2].lastChild, by ? `${by.value} ${by.unit}` : '–');
    setText(row.cells[3], exposure ? exposure.minutes_to_action_value === null ? '–' : minutes(exposure.minutes_to_action_value) : '–');
    setText(row.cells[4], mode && mode.stands ? within(mode.modes[0].natural_frequency_hz, mode.modes[0].natural_frequency_deviation_hz).join(' ') + ' Hz' : '–');
    setText(row.cells[5], entry.state ? entry.state.name.replace('-', ' ') : '–');
  });
}

function newRow(body) {
  const row = body.insertRow();
  row.insertCell().appendChild(make('a'));
  const attention = row.insertCell();
  attention.className = 'attention';
  attention.append(make('span', 'dot'), make('span'));
  const level = row.insertCell();
  const meter = level.appendChild(make('span', 'meter'));
  meter.appendChild(make('i'));
  level.className = 'level';
  level.appendChild(make('span'));
  for (let i = 0; i < 3; i++) row.insertCell().className = i < 2 ? 'number' : '';
  return row;
}

function setText(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

// Alarms

function drawAlarms(notices, fresh) {
  const list = at('alarms');
  for (const notice of notices) {
    const before = list.firstChild, key = JSON.stringify([notice.seat, notice.kind, notice.kind === 'unreadable' || notice.over ? notice.number : 0]);
    const times = before && before.dataset.key === key ? Number(before.dataset.times) + 1 : 1;
    if (times > 1) before.remove(); // the same once more: its last words, and how often
    const item = make('li', notice.severity + (notice.over ? ' over' : '') + (fresh || times > 1 ? '' : ' new'));
    item.dataset.key = key;
    item.dataset.times = times;
    item.appendChild(make('time', '', clockTime(notice.t_s) || '–'));
    const words = item.appendChild(make('div'));
    const who = notice.seat && shownSeats > 1 ? notice.seat + ': ' : '';
    words.appendChild(make('p', '', who + notice.reason + '.' + (times > 1 ? ` ${times} times.` : '')));
    if (notice.advice) words.appendChild(make('p', 'advice', notice.advice[0].toUpperCase() + notice.advice.slice(1) + '.'));
    list.prepend(item);
    if (notice.kind === 'body-changed' && seen && notice.seat === seen.name) {
      seen.changes.push(notice.t_s);
      if (seen.changes.length > 500) seen.changes.shift();
    }
  }
  while (list.children.length > MOST_ALARMS) list.lastChild.remove();
  at('no-alarms').hidden = list.children.length > 0;
}

// The stream

let events = null, fresh = true, last = 0, source = '', ended = false, counts = '';

function pulse(tone, words) {
  at('pulse').className = 'pulse ' + tone;
  setText(at('pulse-words'), words);
}

function take(news) {
  if (fresh) { // another connection begins from what the server still knows
    at('alarms').replaceChildren();
    seen = null;
  }
  if (news.table) {
    source = news.source;
    ended = news.ended;
    counts = `${many(news.rows)} rows` + (news.unreadable ? `, ${many(news.unreadable)} lines put aside` : '') + (news.refused ? `, ${many(news.refused)} rows refused` : '');
  }
  if (news.plan) begin(news.shown, news.plan);
  if (news.table) {
    drawTable(news);
    setText(at('title'), seen && news.seats > 1 ? seen.name : 'Live');
    setText(at('source'), `${source} · ${counts}`);
  }
  if (news.notices) drawAlarms(news.notices, fresh);
  fresh = false;
  if (!seen) return;
  at('seat').hidden = false;
  if (news.data) {
    seen.data = news.data;
    const places = JSON.stringify(news.data.places);
    if (places !== seen.places) person(news.data.places);
    seen.places = places;
  }
  if (news.curve) {
    append(seen.samples, news.curve, MOST_SAMPLES);
    drawSamples();
  }
  if (news.history) {
    if (news.history.again) seen.history = {};
    append(seen.history, news.history, MOST_POINTS);
    drawHistory();
  }
  if (news.result) seen.result = news.result;
  if (news.result || news.data) drawResult();
}

function connect() {
  if (events) events.close();
  const chosen = /^#seat=(.*)$/.exec(location.hash);
  events = new EventSource('events' + (chosen ? '?seat=' + chosen[1] : ''));
  events.onopen = () => { fresh = true; last = Date.now(); };
  events.onmessage = event => { last = Date.now(); take(JSON.parse(event.data)); };
  events.onerror = () => {
    pulse('fault', 'connection lost, trying again');
    if (events.readyState === EventSource.CLOSED) setTimeout(connect, 2000);
  };
}

setInterval(() => {
  if (!events || events.readyState !== EventSource.OPEN) return;
  const silent = seen && seen.data && seen.data.silent;
  if (ended) pulse('plain', 'the stream has ended');
  else if (silent) pulse('warning', 'no samples come');
  else if (seen) pulse('good', 'live');
  else pulse('warning', 'waiting for samples');
}, 500);

addEventListener('hashchange', connect);
addEventListener('pointerdown', event => {
  if (!event.target.closest('.surface')) {
    charts.forEach(({view}) => {
      view.charts.forEach(chart => { chart.cursor = null; });
      view.point(null);
    });
  }
});
readTheme();
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
  readTheme();
  charts.forEach(({view}) => view.draw());
});
connect();

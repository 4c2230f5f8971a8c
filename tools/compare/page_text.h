// What does not change in the page of `marrow compare`: its style, and the script that it does without if it must.
#pragma once

namespace marrow::tools {

inline constexpr const char* kPageStyle =
    R"(body{font:15px/1.5 system-ui,sans-serif;max-width:1240px;margin:2rem auto;padding:0 1rem;color:#222;background:#fafafa}
h1{font-size:1.5rem;line-height:1.3}h2{font-size:1.1rem;margin-top:2.2rem}h3{font-size:1rem;margin:1.4rem 0 .4rem}
.wide{overflow-x:auto}table{border-collapse:collapse;background:#fff;font-variant-numeric:tabular-nums}
td,th{padding:.3rem .5rem;text-align:right;border-bottom:1px solid #ddd;white-space:nowrap}
thead th{white-space:normal;vertical-align:bottom;font-size:.85rem}td:first-child,th:first-child{text-align:left}
th button{font:inherit;color:inherit;background:none;border:0;padding:0;text-align:inherit;cursor:pointer}
th button:after{content:"\a0\2195";color:#aaa}th[aria-sort=ascending] button:after{content:"\a0\2191";color:#222}
th[aria-sort=descending] button:after{content:"\a0\2193";color:#222}
td.ugly{color:#b03a2e;font-weight:600}.why{border-left:3px solid #b03a2e;padding-left:.7rem;margin:.5rem 0}
.pose{display:grid;gap:8px}.pose h3{margin-bottom:0}.grid{display:grid;gap:8px;align-items:end;grid-template-columns:repeat(var(--across),1fr)}
.slides{grid-template-columns:1fr 1fr;align-items:start}.slides h3,.slides .shapes~.grid{grid-column:1/-1}.slides .shapes{grid-template-columns:repeat(var(--beside),1fr)}
figure{margin:0}figure img{width:100%;border-radius:4px;display:block}
figcaption,.note,.scale{font-size:.85rem;color:#555}.scale{align-self:start}
.ramp{height:12px;border-radius:2px;margin:.4rem 0 .1rem}.ends{display:flex;justify-content:space-between}
.slider input{width:100%;margin:.3rem 0}.stage{position:relative;touch-action:none;cursor:ew-resize}
.stage img{width:100%;display:block;border-radius:4px;user-select:none;-webkit-user-drag:none}
.stage img+img{position:absolute;inset:0}.stage i{position:absolute;top:0;bottom:0;width:2px;background:#fff;margin-left:-1px;pointer-events:none}
.names{display:flex;justify-content:space-between}
.key label{margin-right:1rem;white-space:nowrap}svg{background:#fff;border:1px solid #ddd;margin:0 8px 8px 0;max-width:100%}
polyline{fill:none;stroke-width:1.5}polyline.off{display:none})";

inline constexpr const char* kAboutFigures =
    "<p class=\"note\">Poses held out are not learnt from. Flipped triangles face against where they would, had each "
    "turned as its weights have it. Bend: by how much the angles between neighbouring triangles are not the bind "
    "pose's, where weights blend. Creases: the share of edges there that turn by more than 60°. Red: more than plain "
    "linear blend skinning (ssd) has. Narrowest ring: of what it is in the bind pose, when a joint is twisted to 170°. "
    "Jumps: how much faster a vertex goes from one frame to the next at 60 Hz, of SSD's. Sharpest edge: how far it is "
    "folded beyond the bind pose. Normals: between those it shades with and those of the mesh it makes, where joints "
    "meet; of animation space by its tangents, of the others, and in all pictures, through the blended matrix.</p>\n";
inline constexpr const char* kAboutCosts =
    "<p class=\"note\">Size: of all geometry, cooked. Time: of positions, on the machine that made this page. GPUs: "
    "by their compilers.</p>\n";

// Tables are sorted by a click on a heading, two pictures of a pose lie over each other under a slider, and lines of
// charts come and go, which are drawn anew so that they fill the chart.
inline constexpr const char* kPageScript = R"((() => {
'use strict';
const all = (selector, root = document) => [...root.querySelectorAll(selector)];
const make = (tag, parent, properties = {}) => parent.appendChild(Object.assign(document.createElement(tag), properties));

for (const table of all('table')) {
  all('thead th', table).forEach((heading, column) => {
    const text = heading.textContent;
    heading.textContent = '';
    make('button', heading, {type: 'button', textContent: text}).onclick = () => {
      const falls = heading.getAttribute('aria-sort') === 'ascending';
      all('th', table).forEach(other => other.removeAttribute('aria-sort'));
      heading.setAttribute('aria-sort', falls ? 'descending' : 'ascending');
      const key = row => row.cells[column].dataset.value;
      const order = (a, b) => {
        const x = key(a), y = key(b);
        if (x === '' || y === '') return (x === '') - (y === '');
        const d = column ? x - y : x < y ? -1 : x > y ? 1 : 0;
        return falls ? -d : d;
      };
      table.tBodies[0].append(...[...table.tBodies[0].rows].sort(order));
    };
  });
}

for (const pose of all('.pose')) {
  const shapes = all('figure[data-name]', pose);
  if (shapes.length < 3) continue;
  const slider = make('div', pose, {className: 'slider'});
  pose.insertBefore(slider, pose.children[1]);
  pose.classList.add('slides');
  const stage = make('div', slider, {className: 'stage'});
  const images = [make('img', stage, {alt: ''}), make('img', stage, {alt: ''})];
  const line = make('i', stage);
  const range = make('input', slider, {type: 'range', min: 0, max: 100, step: 0.1, value: 50});
  range.setAttribute('aria-label', 'how much is seen of the left picture');
  const names = make('div', slider, {className: 'names'});
  const slide = () => {
    images[1].style.clipPath = `inset(0 0 0 ${range.value}%)`;
    line.style.left = range.value + '%';
  };
  [0, shapes.length - 2].forEach((chosen, side) => {
    const select = make('select', names);
    select.setAttribute('aria-label', side ? 'right picture' : 'left picture');
    shapes.forEach((shape, i) => make('option', select, {textContent: shape.dataset.name, value: i}));
    select.onchange = () => { images[side].src = all('img', shapes[select.value])[0].src; };
    select.value = chosen;
    select.onchange();
  });
  range.oninput = slide;
  stage.onpointerdown = stage.onpointermove = event => {
    if (!event.buttons) return;
    const box = stage.getBoundingClientRect();
    range.value = 100 * (event.clientX - box.left) / box.width;
    slide();
  };
  slide();
}

const nice = most => {
  const unit = 10 ** Math.floor(Math.log10(most));
  return unit * [1, 2, 5, 10].find(step => step * unit >= most * 0.999999);
};
const draw = chart => {
  const lines = all('polyline', chart).map(line => ({line, values: line.dataset.mm.split(' ').map(Number)}));
  const seen = lines.filter(({line}) => !line.classList.contains('off'));
  const most = Math.max(0, ...seen.flatMap(({values}) => values));
  if (!(most > 0)) return;
  const top = nice(most), [low, height] = [+chart.dataset.low, +chart.dataset.height];
  for (const {line, values} of lines) {
    const points = line.getAttribute('points').trim().split(' ');
    line.setAttribute('points', points.map((p, i) =>
      `${p.split(',')[0]},${(low - height * values[i] / top).toFixed(1)}`).join(' '));
  }
  all('[data-share]', chart).forEach(tick => {
    tick.textContent = `${+(top * tick.dataset.share).toPrecision(3)} mm`;
  });
};
for (const key of all('.key label')) {
  const name = key.dataset.series, lines = all(`polyline[data-series="${name}"]`);
  const box = document.createElement('input');
  box.type = 'checkbox';
  box.checked = lines.some(line => !line.classList.contains('off'));
  key.prepend(box, ' ');
  box.onchange = () => {
    lines.forEach(line => line.classList.toggle('off', !box.checked));
    all('svg.chart').forEach(draw);
  };
}
})();
)";

}  // namespace marrow::tools

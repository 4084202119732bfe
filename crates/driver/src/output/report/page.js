// The page: its figures, what readers choose, light and dark, and printing.

const drawings = [];
for (const figure of document.querySelectorAll('figure')) {
  const data = JSON.parse(figure.querySelector('script').textContent);
  const draw = kinds[figure.dataset.kind](figure, data);
  drawings.push(draw);
  let width = 0;
  // Also when the figure is shown at last: what is hidden has no width.
  new ResizeObserver(([entry]) => {
    if (Math.round(entry.contentRect.width) === width) return;
    width = Math.round(entry.contentRect.width);
    draw();
  }).observe(figure);
}
const redraw = () => drawings.forEach((draw) => draw());

for (const select of document.querySelectorAll('.choose')) {
  const sets = [...select.closest('.choice').children].filter((child) => child.matches('.set'));
  const show = () => sets.forEach((set, k) => (set.hidden = k !== Number(select.value)));
  select.addEventListener('change', () => {
    show();
    // Where there is a map of states, it has all that the list has.
    if (states.shown !== null) states.show(Number(select.value), follow);
  });
  function follow(state) {
    if (!select.options[state]) return;
    select.value = state;
    show();
  }
  states.follow(follow);
  show();
}

// Tables that are wider than the window say so.
for (const box of document.querySelectorAll('.scroll')) {
  const hint = Object.assign(document.createElement('p'), { className: 'note more', textContent: 'more columns →', hidden: true });
  box.before(hint);
  const tell = () => (hint.hidden = box.scrollLeft + box.clientWidth >= box.scrollWidth - 2);
  box.addEventListener('scroll', tell);
  new ResizeObserver(tell).observe(box);
}

const root = document.documentElement;
const system = matchMedia('(prefers-color-scheme: dark)');
const toggle = document.getElementById('theme');
const isDark = () => (root.dataset.theme ? root.dataset.theme === 'dark' : system.matches);
function told() {
  toggle.textContent = isDark() ? 'light' : 'dark';
  redraw();
}
toggle.hidden = false;
toggle.addEventListener('click', () => {
  root.dataset.theme = isDark() ? 'light' : 'dark';
  told();
});
system.addEventListener('change', told);
told();

// On paper everything is light.
let theme;
addEventListener('beforeprint', () => {
  theme = root.dataset.theme;
  root.dataset.theme = 'light';
  redraw();
});
addEventListener('afterprint', () => {
  if (theme) root.dataset.theme = theme;
  else delete root.dataset.theme;
  redraw();
});

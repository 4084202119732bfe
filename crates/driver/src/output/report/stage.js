// What all figures have: a canvas that follows its width and the colours of the page, and words beside the pointer.

// What draws a figure, by its kind.
const kinds = {};

const clamp = (value, low, high) => Math.min(high, Math.max(low, value));

// A colour of the page by its name in the style sheet.
const color = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
const series = (k) => color(`c${(k % 6) + 1}`);

// The state that the page shows, by its number: maps, curves and lists follow each other.
const states = {
  shown: null,
  followers: [],
  follow(follower) {
    this.followers.push(follower);
  },
  show(state, from) {
    if (state === this.shown) return;
    this.shown = state;
    this.followers.forEach((follower) => follower !== from && follower(state));
  },
};

class Stage {
  constructor(figure) {
    this.canvas = figure.querySelector('canvas');
    this.tip = figure.querySelector('.tip');
    this.width = this.height = 0;
  }

  // A clear canvas as wide as its place, `height(width)` high, in pixels of the page; null where it is not shown.
  begin(height) {
    const width = this.canvas.parentElement.clientWidth;
    if (!width) return null;
    const fine = (this.fine = Math.max(1, window.devicePixelRatio || 1));
    [this.width, this.height] = [width, Math.round(height(width))];
    this.canvas.width = Math.round(width * fine);
    this.canvas.height = Math.round(this.height * fine);
    const ctx = this.canvas.getContext('2d');
    ctx.setTransform(fine, 0, 0, fine, 0, 0);
    ctx.font = '12px system-ui, -apple-system, "Segoe UI", Roboto, Arial, sans-serif';
    ctx.lineJoin = 'round';
    return ctx;
  }

  // Calls `find(x, y)` where the pointer is, and shows the words and the place that it returns, if any.
  listen(find) {
    const show = (event) => {
      const box = this.canvas.getBoundingClientRect();
      this.tell(find(event.clientX - box.left, event.clientY - box.top));
    };
    this.canvas.addEventListener('pointermove', show);
    this.canvas.addEventListener('pointerdown', show);
    this.canvas.addEventListener('pointerleave', () => this.tell(find(null, null)));
  }

  // Shows words beside a place; nothing if there are none.
  tell(found) {
    this.tip.hidden = !found;
    if (!found) return;
    const lines = found.lines.map((line) => Object.assign(document.createElement('div'), { textContent: line }));
    this.tip.replaceChildren(...lines);
    const { offsetWidth: w, offsetHeight: h } = this.tip;
    const beside = found.x + 14 + w > this.width ? found.x - 14 - w : found.x + 14;
    this.tip.style.left = `${clamp(beside, 0, Math.max(0, this.width - w))}px`;
    this.tip.style.top = `${clamp(found.y - h - 8, 0, Math.max(0, this.height - h))}px`;
  }
}

function line(ctx, points) {
  ctx.beginPath();
  points.forEach(([x, y], k) => (k ? ctx.lineTo(x, y) : ctx.moveTo(x, y)));
}

function dot(ctx, x, y, radius) {
  ctx.beginPath();
  ctx.arc(x, y, radius, 0, 2 * Math.PI);
}

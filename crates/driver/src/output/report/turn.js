// How readers turn, move and magnify a body: by pointers, the wheel, keys and buttons.

// Radians per pixel, per press of a key; pixels per press; factor per press.
const [SLOW, PRESS, STEP, NEARER] = [0.008, Math.PI / 24, 24, 1.25];
// A wheel that scrolls the page goes on with it when a body comes below the pointer, until it rests, ms.
const REST = 300;
const scrolled = { at: -Infinity };
addEventListener('wheel', (event) => {
  if (!event.defaultPrevented) scrolled.at = event.timeStamp;
}, { passive: true });

const KEYS = {
  ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1],
};

// Calls `changed` whenever the camera moved; `busy.is` is true while a pointer does that.
function steer(canvas, buttons, camera, changed) {
  const busy = { is: false };
  const held = new Map();
  const middle = () => {
    const all = [...held.values()];
    const mean = (c) => all.reduce((sum, at) => sum + at[c], 0) / all.length;
    return { x: mean('x'), y: mean('y'), wide: all.length > 1 ? Math.hypot(all[0].x - all[1].x, all[0].y - all[1].y) : 0 };
  };
  const inCanvas = (event) => {
    const box = canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };

  canvas.addEventListener('pointerdown', (event) => {
    held.set(event.pointerId, inCanvas(event));
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener('pointermove', (event) => {
    if (!held.has(event.pointerId)) return;
    const from = middle();
    held.set(event.pointerId, inCanvas(event));
    const to = middle();
    const [across, down] = [to.x - from.x, to.y - from.y];
    if (!across && !down && from.wide === to.wide) return;
    busy.is = true;
    if (held.size === 1 && !event.shiftKey && !(event.buttons & 6)) camera.turn(SLOW * across, SLOW * down);
    else camera.move(across, down);
    if (from.wide && to.wide) camera.magnify(to.wide / from.wide, to.x, to.y);
    changed();
  });
  for (const end of ['pointerup', 'pointercancel']) {
    canvas.addEventListener(end, (event) => {
      held.delete(event.pointerId);
      busy.is = held.size > 0;
    });
  }
  canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  canvas.addEventListener('wheel', (event) => {
    if (event.timeStamp - scrolled.at < REST) return;
    event.preventDefault();
    const lines = event.deltaMode ? 30 : 1;
    const at = inCanvas(event);
    camera.magnify(Math.exp(clamp(-0.002 * lines * event.deltaY, -0.5, 0.5)), at.x, at.y);
    changed();
  }, { passive: false });
  canvas.addEventListener('keydown', (event) => {
    const [across, down] = KEYS[event.key] ?? [0, 0];
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (KEYS[event.key] && event.shiftKey) camera.move(-STEP * across, STEP * down);
    else if (KEYS[event.key]) camera.turn(PRESS * across, PRESS * down);
    else if (event.key === '+' || event.key === '=') camera.magnify(NEARER, ...camera.middle);
    else if (event.key === '-') camera.magnify(1 / NEARER, ...camera.middle);
    else if (event.key === 'Home') camera.look('all');
    else return;
    event.preventDefault();
    changed();
  });
  buttons.forEach((button) => button.addEventListener('click', () => {
    camera.look(button.value);
    changed();
  }));
  return busy;
}

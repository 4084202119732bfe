// How readers go through the states of a figure: by a slider, the arrow keys, and a button that plays them.

// A film of all states takes some time, and so does a picture, at least, ms.
const [FILM, PICTURE] = [8000, 60];

// Calls `show` with the chosen one of some states, which may take its time.
function runThrough(figure, shots, show) {
  const [slider, play, told] = ['state', 'play', 'told'].map((name) => figure.querySelector(`.${name}`));
  const canvas = figure.querySelector('canvas');
  const last = shots.length - 1;
  let [at, isPlaying] = [last, false];

  function follow(state) {
    // Of the states that were left out the next one before.
    const next = Math.max(0, shots.findLastIndex((shot) => shot.state <= state));
    return next === at ? null : set(next);
  }

  function set(next) {
    at = clamp(next, 0, last);
    slider.value = at;
    told.value = shots[at].name;
    states.show(shots[at].state, follow);
    return show(shots[at]);
  }

  function stop() {
    isPlaying = false;
    play.textContent = 'play';
  }

  async function run() {
    isPlaying = true;
    play.textContent = 'stop';
    const pause = () => new Promise((done) => setTimeout(done, Math.max(PICTURE, Math.min(400, FILM / shots.length))));
    if (at === last) await Promise.all([set(0), pause()]);
    while (isPlaying && at < last) await Promise.all([set(at + 1), pause()]);
    stop();
  }

  slider.addEventListener('input', () => {
    stop();
    set(Number(slider.value));
  });
  play.addEventListener('click', () => (isPlaying ? stop() : run()));
  canvas.tabIndex = 0;
  canvas.addEventListener('keydown', (event) => {
    const step = { ArrowLeft: -1, ArrowRight: 1, Home: -last, End: last }[event.key];
    if (!step || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    stop();
    set(at + step);
  });
  states.follow(follow);
  told.value = shots[at].name;
  states.shown = shots[at].state;
}


// Time: playing, pausing, seeking; one callback of the browser draws when there is something new.
const player = { playing: false, speed: data.speed, loop: true, before: null, stale: true };
const costs = { last: [], drawn: [], frames: 0 };
const KEPT = 600; // frames whose cost is remembered

const playButton = document.getElementById("play"), slider = document.getElementById("time");
const clock = document.getElementById("clock"), clockNow = document.createElement("b"), clockEnd = document.createElement("span");
clock.append(clockNow, clockEnd);
slider.min = start;
slider.max = end;
const digits = Math.min(6, Math.max(2, 2 - Math.floor(Math.log10(duration))));
clockEnd.textContent = ` / ${end.toFixed(2)} s`;

function invalidate() {
  player.stale = true;
}

/** Show the time `now`. */
function show() {
  arrange();
  updateTrails();
  slider.value = now.time;
  const text = now.time.toFixed(digits);
  if (clockNow.textContent !== text) {
    clockNow.textContent = text;
    slider.setAttribute("aria-valuetext", text + " seconds");
  }
  drawCursor();
  const begin = performance.now();
  draw();
  frameDrawn();
  costs.drawing = performance.now() - begin;
}

function seek(time) {
  locate(Math.min(Math.max(Number(time), start), end));
  invalidate();
}

function setPlaying(on) {
  player.playing = on && end > start;
  player.before = null;
  playButton.classList.toggle("playing", player.playing);
  playButton.setAttribute("aria-label", player.playing ? "Pause" : "Play");
}
function play() {
  if (now.time >= end) seek(start);
  setPlaying(true);
}
function pause() { setPlaying(false); }

function advance(instant) {
  const seconds = player.before === null ? 0 : Math.min((instant - player.before) / 1000, 0.25);
  player.before = instant;
  let time = now.time + seconds * player.speed;
  if (time >= end) {
    if (player.loop) time = start + (time - end) % (end - start);
    else {
      time = end;
      pause();
    }
  }
  seek(time);
}

const SLOW = 45, PATIENCE = 30; // milliseconds from frame to frame; so many of them
const pace = { last: 0, slow: 0 };

function watchPace(instant) {
  const gap = instant - pace.last;
  pace.last = instant;
  pace.slow = gap > SLOW && gap < 1000 ? pace.slow + 1 : 0;
  if (pace.slow > PATIENCE && !simple) simplify();
}

function tick(instant) {
  requestAnimationFrame(tick);
  if (player.playing) watchPace(instant);
  const begin = performance.now();
  if (player.playing) advance(instant);
  if (controls.update()) invalidate();
  if (!player.stale) return;
  player.stale = false;
  show();
  costs.frames += 1;
  costs.last.push(performance.now() - begin);
  costs.drawn.push(costs.drawing);
  if (costs.last.length > KEPT) {
    costs.last.shift();
    costs.drawn.shift();
  }
}

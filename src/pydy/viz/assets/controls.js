// Buttons, keys, legend, help; then everything starts.

const theme = { accent: "" };
function readTheme() {
  theme.accent = cssColour("--accent");
  paint();
  for (const [visual, trail] of trails) trail.line.material.color.copy(visual.painted);
  for (const { members, swatch } of legendParts) swatch.style.background = members[0].painted.getStyle();
  drawStrip();
  invalidate();
}

// -- switches: one table for buttons, keys and help ---------------------------------------------------

const switches = [
  { key: "l", name: "Loop", icon: "M17 2l4 4-4 4M3 11V9a3 3 0 0 1 3-3h15M7 22l-4-4 4-4M21 13v2a3 3 0 0 1-3 3H3",
    get: () => player.loop, set: (on) => { player.loop = on; } },
  { key: "f", name: "Camera follows", icon: "M12 3v3M12 18v3M3 12h3M18 12h3M12 7a5 5 0 1 0 0 10a5 5 0 1 0 0-10M12 11.5v1", only: path !== null,
    get: () => followed.on, set: (on) => { followed.on = on; } },
  { key: "t", name: "Trails", icon: "M3 19c4-12 8 4 12-6M15 13l6-8M17 5h4v4",
    get: () => trails.size > 0, set: (on) => { visuals.forEach((v) => setTrail(v, on && (v.trail || !visuals.some((w) => w.trail)))); fillLegend(); } },
  { key: "g", name: "Ground", icon: "M3 18h18M6 13h12M8.5 9h7M12 9v9M8.5 9L4 18M15.5 9l4.5 9", only: view.ground !== null,
    get: () => ground.visible, set: (on) => { ground.visible = on; } },
  { key: "a", name: "Axes at the origin", icon: "M8 3v13h13M8 16l-5 5", get: () => axes.visible, set: (on) => { axes.visible = on; } },
  { key: "p", name: "Plot", icon: "M4 4v16h16M7 15l4-5 3 3 5-7", only: series.length > 0,
    get: () => !strip.hidden, set: (on) => { strip.hidden = !on; drawStrip(); } },
].filter((entry) => entry.only !== false);

function iconOf(d) {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", "0 0 24 24");
  svg.setAttribute("aria-hidden", "true");
  const shape = document.createElementNS("http://www.w3.org/2000/svg", "path");
  shape.setAttribute("d", d);
  svg.append(shape);
  return svg;
}

function button(parent, label, icon, act) {
  const made = document.createElement("button");
  made.type = "button";
  made.title = label;
  made.setAttribute("aria-label", label.replace(/ \(.*/, ""));
  made.append(iconOf(icon));
  made.addEventListener("click", act);
  parent.append(made);
  return made;
}

const switchBox = document.getElementById("switches");
function flip(entry) {
  entry.set(!entry.get());
  updateSwitches();
  invalidate();
}
function updateSwitches() {
  for (const entry of switches) entry.button.setAttribute("aria-pressed", String(entry.get()));
  for (const entry of actions) entry.button.classList.toggle("recording", entry.key === "v" && video.recorder !== null);
}
for (const entry of switches) entry.button = button(switchBox, `${entry.name} (${entry.key})`, entry.icon, () => flip(entry));
const pictureIcon = "M4 7h3l2-3h6l2 3h3v12H4zM12 9.5a4 4 0 1 0 0 8a4 4 0 1 0 0-8";
const actions = [
  { key: "s", name: "Save a picture", icon: pictureIcon, act: savePicture },
  { key: "v", name: "Record a video", icon: "M3 6h12v12H3zM15 10.5l6-3.5v10l-6-3.5", act: () => (video.recorder ? stopVideo() : startVideo()) },
  { key: "c", name: "Copy a link to this moment", icon: "M10 13.5a4.5 4.5 0 0 0 6.5.5l3-3a4.6 4.6 0 0 0-6.5-6.5l-1.5 1.5M14 10.5a4.5 4.5 0 0 0-6.5-.5l-3 3A4.6 4.6 0 0 0 11 19.500l1.5-1.500", act: copyLink },
];
for (const entry of actions) entry.button = button(switchBox, `${entry.name} (${entry.key})`, entry.icon, entry.act);
button(switchBox, "Reset the view (r)", "M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5", () => { lookFrom(); invalidate(); });
button(switchBox, "Help (?)", "M9 9a3 3 0 1 1 4.2 2.7c-.8.4-1.2 1-1.2 2.3M12 17.5v.5", () => toggleHelp());

// -- speed --------------------------------------------------------------------------------------------

const speeds = [0.1, 0.2, 0.5, 1, 2, 5, 10].map((factor) => Number((factor * data.speed).toPrecision(3)));
const speedSelect = document.getElementById("speed");
for (const speed of speeds) speedSelect.append(new Option(`${speed}×`, speed));
function setSpeed(speed) {
  player.speed = speed;
  speedSelect.value = speed;
}
speedSelect.addEventListener("change", () => setSpeed(Number(speedSelect.value)));
function changeSpeed(step) {
  setSpeed(speeds[Math.min(Math.max(speeds.indexOf(player.speed) + step, 0), speeds.length - 1)]);
}

// -- legend: visuals of one name share a row ------------------------------------------------------------

const rows = new Map();
for (const visual of visuals) {
  if (!rows.has(visual.name)) rows.set(visual.name, []);
  rows.get(visual.name).push(visual);
}

function setVisible(name, on) {
  for (const visual of rows.get(name) || []) visual.object.visible = on;
  fillLegend();
  invalidate();
}

const legendRows = document.getElementById("legend-rows"), legendToggle = document.getElementById("legend-toggle");
const legendParts = [...rows].map(([name, members]) => {
  const row = document.createElement("li"), shown = document.createElement("button"), label = document.createElement("span");
  const swatch = document.createElement("i");
  shown.type = "button";
  shown.className = "shown";
  label.textContent = name;
  shown.title = `Show or hide ${name}`;
  shown.append(swatch, label);
  shown.addEventListener("click", () => setVisible(name, !members[0].object.visible));
  row.append(shown);
  const moving = members.find((v) => v.trail) || members[0];
  const trail = button(row, `Trail of ${name}`, "M3 19c4-12 8 4 12-6M15 13l6-8M17 5h4v4", () => {
    setTrail(moving, !trails.has(moving));
    fillLegend();
    updateSwitches();
    invalidate();
  });
  trail.className = "path";
  const follow = button(row, `Follow ${name}`, "M12 3v3M12 18v3M3 12h3M18 12h3M12 7a5 5 0 1 0 0 10a5 5 0 1 0 0-10M12 11.500v1", () => {
    followBody(followed.body === moving ? null : moving);
    fillLegend();
    invalidate();
  });
  follow.className = "path";
  legendRows.append(row);
  return { members, shown, swatch, trail, follow, moving };
});

function fillLegend() {
  for (const { members, shown, trail, follow, moving } of legendParts) {
    follow.setAttribute("aria-pressed", String(followed.body === moving));
    shown.setAttribute("aria-pressed", String(members[0].object.visible));
    trail.setAttribute("aria-pressed", String(members.some((v) => trails.has(v))));
  }
}
function setLegend(open) {
  legendToggle.setAttribute("aria-expanded", String(open));
}
legendToggle.addEventListener("click", () => setLegend(legendToggle.getAttribute("aria-expanded") !== "true"));

// -- keys -----------------------------------------------------------------------------------------------

function step(count, event) {
  pause();
  if (event.shiftKey) seek(now.time + count * Math.max(1, data.speed));
  else {
    const k = now.k + (count > 0 ? 1 : now.part > 0 ? 0 : -1);
    seek(times[Math.min(Math.max(k, 0), times.length - 1)]);
  }
}

const KEYS = [
  { keys: [" "], show: ["space"], what: "play or pause", act: () => (player.playing ? pause() : play()) },
  { keys: ["ArrowLeft", "ArrowRight"], show: ["←", "→"], what: "one frame back or on, with shift one second",
    act: (event) => step(event.key === "ArrowLeft" ? -1 : 1, event) },
  { keys: ["Home", "End"], show: ["Home", "End"], what: "to the beginning or the end",
    act: (event) => { pause(); seek(event.key === "Home" ? start : end); } },
  { keys: ["+", "=", "-"], show: ["+", "-"], what: "faster or slower", act: (event) => changeSpeed(event.key === "-" ? -1 : 1) },
  { keys: ["r"], show: ["r"], what: "reset the view", act: () => { lookFrom(); invalidate(); } },
  { keys: ["x", "y", "z"], show: ["x", "y", "z"], what: "look along an axis",
    act: (event) => { lookFrom([0, 0, 0].map((_, i) => ("xyz"[i] === event.key ? 1 : 1e-4))); invalidate(); } },
  ...actions.map((entry) => ({ keys: [entry.key], show: [entry.key], what: entry.name.toLowerCase(), act: entry.act })),
  ...switches.map((entry) => ({ keys: [entry.key], show: [entry.key], what: entry.name.toLowerCase(), act: () => flip(entry) })),
  { keys: ["?", "h"], show: ["?"], what: "this help", act: () => toggleHelp() },
];

addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || help.open) return;
  // A focused button is pressed by space, a focused list takes letters and arrows.
  if (event.target === speedSelect || event.target.closest?.("#live") || (event.key === " " && event.target.tagName === "BUTTON" && event.target !== playButton)) return;
  const found = KEYS.find((entry) => entry.keys.includes(event.key.length === 1 ? event.key.toLowerCase() : event.key));
  if (!found) return;
  event.preventDefault();
  found.act(event);
});

const help = document.getElementById("help");
function fillHelp() {
  const title = document.createElement("h2"), list = document.createElement("dl"), close = document.createElement("button");
  title.textContent = "Mouse, touch and keys";
  const entry = (terms, what, asKey) => {
    const term = document.createElement("dt"), text = document.createElement("dd");
    terms.forEach((word, i) => {
      const part = document.createElement(asKey ? "kbd" : "span");
      part.textContent = word;
      if (i) term.append(" ");
      term.append(part);
    });
    text.textContent = what;
    list.append(term, text);
  };
  entry(["drag"], "turn the view");
  entry(["right drag, two fingers"], "move the view");
  entry(["wheel, pinch"], "zoom");
  for (const { show: shown, what } of KEYS) entry(shown, what, true);
  close.type = "button";
  close.textContent = "Close";
  close.addEventListener("click", () => help.close());
  help.append(title, list, close);
}
function toggleHelp() {
  if (help.open) help.close(); else help.showModal();
}

// -- start ----------------------------------------------------------------------------------------------

document.getElementById("heading").textContent = data.title;
playButton.addEventListener("click", () => (player.playing ? pause() : play()));
slider.addEventListener("input", () => { pause(); seek(slider.value); });
controls.addEventListener("change", invalidate);
new ResizeObserver(() => { resize(); drawStrip(); invalidate(); }).observe(canvas.parentElement);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", readTheme);

fillHelp();
setSpeed(data.speed);
setLegend(innerWidth > 640 && rows.size <= 14);
for (const visual of visuals) setTrail(visual, visual.trail);
fillLegend();
updateSwitches();
resize();
arrange();
lookFrom();
readTheme();
const atMoment = goToMoment(location.hash);
addEventListener("hashchange", () => goToMoment(location.hash));
show();
requestAnimationFrame(tick);
// Who asked the system for less motion starts it by hand.
if (renderer && !atMoment && !matchMedia("(prefers-reduced-motion: reduce)").matches) play();

// For tests and for scripts of an embedding page. All read what is really on the stage.
window.pydy = {
  ready: renderer !== null,
  version: data.version,
  times: Array.from(times),
  names: visuals.map((visual) => visual.name),
  get time() { return now.time; },
  get playing() { return player.playing; },
  play, pause, setVisible, setSpeed,
  /** What a link to this moment and view ends in. */
  get moment() { return moment(); },
  /** The last recording, or null. */
  get video() { return video.blob ?? null; },
  /** Let the camera follow the visual of a number, or none. */
  follow(number) { followBody(visuals[number] ?? null); invalidate(); },
  /** Go to a time and draw it before returning. */
  seek(time) { pause(); seek(time); show(); },
  /** Where each visual's point is in the scene: [x, y, z]. */
  positions() {
    scene.updateMatrixWorld();
    return visuals.map((visual) => visual.anchor.getWorldPosition(new THREE.Vector3()).multiplyScalar(unit).toArray());
  },
  /** The pose of each visual: 16 numbers, column by column. */
  matrices() {
    scene.updateMatrixWorld();
    return visuals.map((visual) => visual.anchor.matrixWorld.toArray().map((v, i) => (i >= 12 && i < 15 ? unit * v : v)));
  },
  /** The corners of the box around each visual in the scene: [lowest, highest], or null. */
  boxes() {
    scene.updateMatrixWorld();
    return visuals.map((visual) => {
      const low = new THREE.Vector3(Infinity, Infinity, Infinity), high = low.clone().negate();
      const corner = new THREE.Vector3(), each = new THREE.Matrix4();
      visual.object.traverse((part) => {
        const place = part.isMesh && part.visible && !part.isLine2 && part.geometry.attributes.position;
        for (let n = 0; place && n < (part.count ?? 1); n++) {
          if (part.isInstancedMesh) part.getMatrixAt(n, each);
          for (let i = 0; i < place.count; i++) {
            corner.fromBufferAttribute(place, i).applyMatrix4(each).applyMatrix4(part.matrixWorld);
            low.min(corner);
            high.max(corner);
          }
        }
      });
      return low.x <= high.x ? [low, high].map((end) => end.multiplyScalar(unit).toArray()) : null;
    });
  },
  /** The colours that the visuals have on this page, light or dark: "#rrggbb". */
  colours() { return visuals.map((visual) => `#${visual.painted.getHexString()}`); },
  /** How high the ground is along the upward direction, or null. */
  get ground() { return view.ground === null ? null : unit * view.ground; },
  /** Where the camera is and what it looks at. */
  camera() { return [camera.position, controls.target].map((place) => place.clone().multiplyScalar(unit).toArray()); },
  /** What the last frames cost, medians in milliseconds of script; `drawing` commands are part of `all`. */
  costs() {
    const median = (list) => [...list].sort((a, b) => a - b)[list.length >> 1];
    return { frames: costs.frames, all: median(costs.last), drawing: median(costs.drawn),
      calls: renderer ? renderer.info.render.calls : 0 };
  },
  /** The curves of the strip, with the scale of each, and the places of their points on it. */
  curves() {
    return series.map((one) => ({ label: one.label, low: one.low, high: one.high, times: Array.from(one.times), values: Array.from(one.values),
      places: Array.from(one.values, (value, k) => [atTime(one.times[k]), atValue(one, value)]), now: valueAt(one, now.time) }));
  },
  forgetCosts() { costs.last.length = costs.drawn.length = costs.frames = 0; },
};

// What leaves the page: a picture, a video, a link to a moment and view. And events on the time axis.

const fileName = (data.title || "animation").replace(/[^\p{L}\p{N}]+/gu, "-").replace(/^-|-$/g, "").toLowerCase() || "animation";

function download(blob, suffix) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = fileName + suffix;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

let toastTimer = 0;
function toast(text) {
  const box = document.getElementById("toast");
  box.textContent = text;
  box.hidden = false;
  clearTimeout(toastTimer);
  toastTimer = setTimeout(() => { box.hidden = true; }, 3000);
}

// -- pictures -------------------------------------------------------------------------------------

const sheet = document.createElement("canvas");

/** Paint what is seen onto the sheet: paper, stage, title. The stage must just have been drawn. */
function paintSheet() {
  const ratio = (canvas.width & ~1) / canvas.clientWidth, left = Math.round(picture.left * ratio);
  const width = (canvas.width - left) & ~1, height = canvas.height & ~1; // video wants even numbers
  if (sheet.width !== width || sheet.height !== height) Object.assign(sheet, { width, height });
  const g = sheet.getContext("2d");
  const paper = g.createRadialGradient(width / 2, 0.4 * height, 0, width / 2, 0.4 * height, 0.6 * Math.hypot(width, height));
  paper.addColorStop(0, cssColour("--paper"));
  paper.addColorStop(1, cssColour("--paper-far"));
  g.fillStyle = paper;
  g.fillRect(0, 0, width, height);
  g.drawImage(canvas, -left, 0);
  if (!data.title) return;
  g.fillStyle = cssColour("--ink");
  g.font = `600 ${14 * ratio}px system-ui, sans-serif`;
  g.textBaseline = "top";
  g.fillText(data.title, 16 * ratio, 14 * ratio);
}

function savePicture() {
  draw();
  paintSheet();
  sheet.toBlob((blob) => { if (blob) download(blob, ".png"); }, "image/png");
}

// -- video: one run from the beginning to the end -----------------------------------------------------

const video = { recorder: null, loop: true };

function stopVideo() {
  if (video.recorder && video.recorder.state !== "inactive") video.recorder.stop();
}

function startVideo() {
  const kinds = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm"];
  const kind = typeof MediaRecorder === "undefined" ? undefined : kinds.find((k) => MediaRecorder.isTypeSupported(k));
  if (!kind) {
    toast("This browser cannot record video.");
    return;
  }
  draw();
  paintSheet();
  const parts = [];
  const recorder = new MediaRecorder(sheet.captureStream(60), { mimeType: kind, videoBitsPerSecond: 8e6 });
  recorder.addEventListener("dataavailable", (event) => { if (event.data.size) parts.push(event.data); });
  recorder.addEventListener("stop", () => {
    video.recorder = null;
    player.loop = video.loop;
    updateSwitches();
    video.blob = new Blob(parts, { type: "video/webm" });
    download(video.blob, ".webm");
  });
  Object.assign(video, { recorder, loop: player.loop, blob: null });
  player.loop = false;
  seek(start);
  recorder.start(500);
  setPlaying(true);
  updateSwitches();
}

/** Called when a frame has been drawn. */
function frameDrawn() {
  if (!video.recorder) return;
  paintSheet();
  if (!player.playing) stopVideo(); // at the end, or paused
}

// -- links ------------------------------------------------------------------------------------------

const short = (numbers) => numbers.map((v) => Number(v.toPrecision(5))).join(",");

function moment() {
  const [from, to] = window.pydy.camera();
  const link = { t: short([now.time]), from: short(from), to: short(to) };
  return Object.entries(link).map(([key, value]) => `${key}=${value}`).join("&");
}

/** Go to the moment and view that the address names; returns whether it names a moment. */
function goToMoment(text) {
  const parts = new Map(text.replace(/^#/, "").split("&").map((part) => part.split("=")));
  const read = (key, count) => {
    const numbers = (parts.get(key) || "").split(",").map(Number);
    return numbers.length === count && parts.get(key) && numbers.every(Number.isFinite) ? numbers : null;
  };
  const time = read("t", 1), from = read("from", 3), to = read("to", 3);
  if (time) {
    pause();
    seek(time[0]);
    arrange();
  }
  if (from && to) {
    endSwing();
    camera.position.fromArray(from).divideScalar(unit);
    controls.target.fromArray(to).divideScalar(unit);
    controls.update();
  }
  invalidate();
  return time !== null;
}

function copyLink() {
  const hash = "#" + moment();
  try { history.replaceState(null, "", hash); } catch { /* a page in a frame has no address of its own */ }
  const done = () => toast("The link to this moment and view is copied.");
  const kept = () => toast("The address of this page now leads to this moment and view.");
  if (navigator.clipboard) navigator.clipboard.writeText(location.href.split("#")[0] + hash).then(done, kept);
  else kept();
}

// -- events on the time axis ----------------------------------------------------------------------------

const eventMarks = document.getElementById("events");
function fillEvents() {
  eventMarks.replaceChildren();
  for (const event of data.events) {
    const mark = document.createElement("button");
    mark.type = "button";
    mark.title = `${event.name} at ${written(event.time)} s`;
    mark.setAttribute("aria-label", mark.title);
    mark.style.left = `${100 * (event.time - start) / duration}%`;
    mark.addEventListener("click", () => { pause(); seek(event.time); });
    eventMarks.append(mark);
  }
}
fillEvents();

// -- modes of contacts, from when to when ----------------------------------------------------------------

const modeRows = document.getElementById("modes");
modeRows.hidden = data.modes.length === 0;
for (const contact of data.modes) {
  const row = document.createElement("div");
  for (const span of contact.spans) {
    const part = document.createElement("button");
    part.type = "button";
    part.classList.toggle("open", span.mode === "open");
    part.textContent = `${contact.name} ${span.mode}`;
    part.title = `${part.textContent} from ${written(span.from)} to ${written(span.to)} s`;
    part.style.left = `${100 * (span.from - start) / duration}%`;
    part.style.width = `${100 * (span.to - span.from) / duration}%`;
    if (span.colour) part.style.background = span.colour;
    part.addEventListener("click", () => { pause(); seek(span.from); });
    row.append(part);
  }
  modeRows.append(row);
}

// Trails: the path of a visual's point, as far as time has come.

/** Where a visual's point is at every frame, in the scene. */
function pathOf(visual) {
  const places = new Float32Array(3 * times.length);
  if (!visual.trackOf) {
    const column = new Column(visual.points);
    for (let k = 0; k < times.length; k++)
      for (let i = 0; i < 3; i++) places[3 * k + i] = column.values[column.offset(k) + i];
    return places;
  }
  const { places: p, turns } = visual.trackOf;
  const offset = new THREE.Vector3(), turn = new THREE.Quaternion();
  for (let k = 0; k < times.length; k++) {
    offset.fromArray(visual.offset).applyQuaternion(turn.fromArray(turns.values, turns.offset(k)));
    const o = p.offset(k);
    places[3 * k] = p.values[o] + offset.x;
    places[3 * k + 1] = p.values[o + 1] + offset.y;
    places[3 * k + 2] = p.values[o + 2] + offset.z;
  }
  return places;
}

class Trail {
  constructor(visual) {
    this.visual = visual;
    this.duration = (visual.size && visual.size.duration) || Infinity;
    this.places = pathOf(visual);
    this.line = new WideLine(times.length, legible(visual.colour), 0.85, 2.5);
    this.whole = -1; // segments written so far that are complete
    this.tip = new THREE.Vector3();
    this.tipRow = new Float32Array(3);
    scene.add(this.line);
  }
  update() {
    const { line, places, tipRow } = this, k = now.k;
    this.visual.anchor.getWorldPosition(this.tip).toArray(tipRow);
    let from = 0;
    if (this.duration < Infinity) {
      while (from < k && times[from] < now.time - this.duration) from++;
      this.whole = -1; // segments move up in the buffer
    }
    const first = Math.max(this.whole, from) - from;
    for (let i = first; i + from < k; i++) line.put(i, places, 3 * (i + from), places, 3 * (i + from) + 3);
    line.put(k - from, places, 3 * k, tipRow, 0);
    this.whole = k; // the segment from here on is written anew each time
    line.geometry.instanceCount = times.length < 2 ? 0 : Math.min(k - from + 1, times.length - 1);
    const begin = 6 * Math.min(first, k - from), end = Math.min(6 * (k - from + 1), line.buffer.array.length);
    if (end > begin) line.buffer.addUpdateRange(begin, end - begin);
    line.buffer.needsUpdate = true;
  }
  remove() {
    scene.remove(this.line);
    this.line.geometry.dispose();
    this.line.material.dispose();
  }
}

const trails = new Map();

function setTrail(visual, on) {
  if (on && !trails.has(visual)) {
    trails.set(visual, new Trail(visual));
    trails.get(visual).update();
  } else if (!on && trails.has(visual)) {
    trails.get(visual).remove();
    trails.delete(visual);
  }
}

function updateTrails() {
  for (const trail of trails.values()) {
    trail.line.visible = trail.visual.object.visible;
    if (trail.line.visible) trail.update();
  }
}

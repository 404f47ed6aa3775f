// The three.js scene: visuals on their tracks, light, ground, axes, camera.
const canvas = document.getElementById("stage");
// All lengths here are in units of `unit` metres; see `page_data`.
const view = data.view, unit = view.unit;
const up = new THREE.Vector3().fromArray(view.up), right = new THREE.Vector3().fromArray(view.right);
const depth = new THREE.Vector3().crossVectors(right, up);

const scene = new THREE.Scene();
const camera = new THREE.PerspectiveCamera(32, 1, view.radius / 50, view.radius * 500);
camera.up.copy(up);

// -- visuals ------------------------------------------------------------------------------------

/** A motion that visuals share. */
class BodyTrack extends THREE.Group {
  constructor(entry) {
    super();
    this.places = new Column(entry.p);
    this.turns = new Column(entry.q);
    this.row = new Float32Array(3);
    this.next = new THREE.Quaternion();
    scene.add(this);
  }
  update() {
    this.position.fromArray(this.places.blend(now.k, now.part, this.row));
    const { values } = this.turns;
    this.quaternion.fromArray(values, this.turns.offset(now.k));
    if (!this.turns.fixed && now.part > 0)
      this.quaternion.slerp(this.next.fromArray(values, this.turns.offset(now.k + 1)), now.part);
  }
}

const tracks = data.tracks.map((entry) => new BodyTrack(entry));

/** One visual: `anchor` is at its point; `object` is what is seen and can be hidden. */
const visuals = data.visuals.map((visual) => {
  const track = tracks[visual.track];
  const made = { ...visual, trackOf: track, moving: null, anchor: new THREE.Group() };
  if (track) {
    made.anchor.position.fromArray(visual.offset);
    track.add(made.anchor);
  } else scene.add(made.anchor);
  if (visual.points) {
    made.object = visual.radius === null ? new ThinLine(visual) : new (LINES[visual.kind] ?? RodShape)(visual);
    if (track) {
      made.anchor.add(made.object);
      made.object.update(); // once: its points rest in the track's frame
    } else {
      scene.add(made.object);
      made.moving = () => {
        made.object.update();
        made.anchor.position.fromArray(made.object.row);
      };
    }
  } else if (visual.vectors) {
    const place = new THREE.Vector3();
    made.object = new ArrowShape(visual);
    scene.add(made.object);
    made.moving = () => made.object.update(place.setFromMatrixPosition(made.anchor.matrixWorld));
  } else {
    made.object = visual.kind === "Trace" ? new THREE.Group() : solid(geometryOf(visual), materialOf(visual));
    made.anchor.add(made.object);
  }
  return made;
});

// -- light ----------------------------------------------------------------------------------------

const sky = new THREE.HemisphereLight(0xffffff, 0xb4b6bd, 2.1);
sky.position.copy(up);
const sun = new THREE.DirectionalLight(0xffffff, 1.9);
const sunward = new THREE.Vector3().addScaledVector(up, 2.2).addScaledVector(right, 0.7).addScaledVector(depth, 0.9)
  .setLength(4 * view.radius);
sun.castShadow = true;
sun.shadow.mapSize.set(1024, 1024);
sun.shadow.radius = 4;
sun.shadow.normalBias = 0.01 * view.radius;
sun.shadow.bias = -0.0005;
const reach = 1.5 * view.radius;
Object.assign(sun.shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach, near: view.radius, far: 8 * view.radius });
scene.add(sky, sun, sun.target);

// -- ground and axes --------------------------------------------------------------------------------

const GRID_VERTEX = `
varying vec3 place;
void main() {
  vec4 world = modelMatrix * vec4(position, 1.0);
  place = world.xyz;
  gl_Position = projectionMatrix * viewMatrix * world;
}`;
// Lines as wide as a pixel at any distance, fading out around the middle and where they crowd.
const GRID_FRAGMENT = `
varying vec3 place;
uniform vec3 right, depth, middle, colour;
uniform float cell, far;
float lines(vec2 p) {
  vec2 width = fwidth(p);
  vec2 away = abs(fract(p - 0.5) - 0.5) / width;
  return (1.0 - min(min(away.x, away.y), 1.0)) * clamp(1.5 - 4.0 * max(width.x, width.y), 0.0, 1.0);
}
void main() {
  vec2 p = vec2(dot(place, right), dot(place, depth)) / cell;
  float alpha = max(0.3 * lines(p), 0.55 * lines(p / 5.0));
  gl_FragColor = vec4(colour, alpha * (1.0 - smoothstep(0.25, 1.0, distance(place, middle) / far)));
  #include <colorspace_fragment>
}`;

const far = 7 * view.radius;
const ground = new THREE.Group();
const grid = new THREE.Mesh(new THREE.PlaneGeometry(2 * far, 2 * far), new THREE.ShaderMaterial({
  vertexShader: GRID_VERTEX, fragmentShader: GRID_FRAGMENT,
  transparent: true, depthWrite: false, side: THREE.DoubleSide,
  uniforms: {
    right: { value: right }, depth: { value: depth }, middle: { value: new THREE.Vector3() },
    colour: { value: new THREE.Color() }, cell: { value: view.cell }, far: { value: far },
  },
}));
const floor = new THREE.Mesh(new THREE.PlaneGeometry(2 * far, 2 * far), new THREE.ShadowMaterial({ depthWrite: false }));
floor.receiveShadow = true;
floor.renderOrder = -1;
ground.add(grid, floor);
ground.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), up);
ground.visible = view.ground !== null;
scene.add(ground);

const AXES = [["x", "#e0524d"], ["y", "#3d9e52"], ["z", "#4a7fe0"]];
const axes = new THREE.Group();
AXES.forEach(([, colour], i) => {
  const line = new WideLine(2, colour, 1, 2.5), tip = [0, 0, 0];
  tip[i] = view.axes ?? 0.3 * view.radius;
  line.put(0, [0, 0, 0], 0, tip, 0);
  axes.add(line);
});
scene.add(axes);

// -- camera ---------------------------------------------------------------------------------------

const controls = new THREE.OrbitControls(camera, canvas);
controls.enableDamping = true;
controls.dampingFactor = 0.12;
controls.minDistance = 0.05 * view.radius;
controls.maxDistance = 40 * view.radius;
controls.zoomToCursor = true;

const path = view.path && new Column(view.path);
const followed = { body: null, on: path !== null, at: new THREE.Vector3(), row: new Float32Array(3), next: new THREE.Vector3() };

const FILL = 0.86; // how much of the picture the scene may take at the start

// Pixels at the left of the stage that a panel covers: the picture is what it leaves free.
let coveredWidth = () => 0;
const picture = { left: 0, share: 1 }; // where it begins, and its share of the width

/** How far away the camera must be to see the whole box of the scene along its own direction. */
function fitDistance() {
  const tall = FILL * Math.tan(THREE.MathUtils.degToRad(camera.fov / 2)), wide = tall * camera.aspect * picture.share;
  const turn = camera.quaternion.clone().invert(), corner = new THREE.Vector3();
  let distance = 0;
  for (let i = 0; i < 8; i++) {
    corner.fromArray(view.extent).multiplyScalar(0.5);
    corner.set(i & 1 ? corner.x : -corner.x, i & 2 ? corner.y : -corner.y, i & 4 ? corner.z : -corner.z);
    corner.applyQuaternion(turn);
    distance = Math.max(distance, corner.z + Math.abs(corner.x) / wide, corner.z + Math.abs(corner.y) / tall);
  }
  return distance;
}

/** Do away with what is left of the last swing of the view. */
function endSwing() {
  controls.enableDamping = false;
  controls.update();
  controls.enableDamping = true;
}

/** Look at everything from `direction`, an array, or from where the scene is best seen. */
function lookFrom(direction) {
  endSwing();
  controls.target.fromArray(view.target);
  if (followed.body) controls.target.copy(followed.at.copy(placeFollowed()));
  else if (path && followed.on) controls.target.add(followed.at.fromArray(path.blend(now.k, now.part, followed.row)));
  const away = new THREE.Vector3().fromArray(direction || view.direction).normalize();
  camera.position.copy(controls.target).add(away);
  camera.lookAt(controls.target);
  camera.position.copy(controls.target).addScaledVector(away, fitDistance());
  controls.update();
}

/** Where what the camera follows is: a body, or the middle of what moves. */
function placeFollowed() {
  if (followed.body) return followed.body.anchor.getWorldPosition(followed.next);
  return followed.next.fromArray(path.blend(now.k, now.part, followed.row));
}

/** Let the camera go along with a visual, which moves to the middle; null for none. */
function followBody(visual) {
  followed.body = visual;
  if (visual) {
    const step = placeFollowed().clone().sub(controls.target);
    camera.position.add(step);
    controls.target.add(step);
  }
  if (visual || path) followed.at.copy(placeFollowed());
}

function moveCamera() {
  if (!path && !followed.body) return;
  placeFollowed();
  if (followed.on || followed.body) {
    const step = followed.next.clone().sub(followed.at);
    camera.position.add(step);
    controls.target.add(step);
  }
  followed.at.copy(followed.next);
}

// -- drawing ----------------------------------------------------------------------------------------

let renderer = null;
try {
  renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
  renderer.shadowMap.enabled = true;
} catch (error) {
  const notice = document.getElementById("notice");
  notice.textContent = "This browser cannot draw in three dimensions: WebGL 2 is switched off or missing.";
  notice.hidden = false;
}

let simple = false;

/** Leave out what is dear, where there is no graphics card. */
function simplify() {
  simple = true;
  sun.castShadow = false;
  floor.visible = false;
  resize();
}

function cssColour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

const LUMINANCE = [0.2126, 0.7152, 0.0722];
const luminance = (colour) => LUMINANCE[0] * colour.r + LUMINANCE[1] * colour.g + LUMINANCE[2] * colour.b;
// Least contrast with the page, (lighter + 0.05) / (darker + 0.05); light bodies on a light page have shades too.
const ON_DARK = 2, ON_LIGHT = 1.25;

/** A colour made lighter on a dark page, or darker on a light one, where it would vanish. */
function legible(colour) {
  const made = new THREE.Color(colour), own = luminance(made), paper = luminance(new THREE.Color(cssColour("--paper")));
  const dark = paper < 0.18, limit = dark ? ON_DARK * (paper + 0.05) - 0.05 : (paper + 0.05) / ON_LIGHT - 0.05;
  if (dark && own < limit) made.lerp(new THREE.Color(0xffffff), (limit - own) / (1 - own));
  else if (!dark && own > limit) made.multiplyScalar(limit / own);
  return made;
}

function paint() {
  for (const visual of visuals) {
    visual.painted = legible(visual.colour);
    visual.object.traverse((part) => part.material?.color.copy(visual.painted));
  }
  grid.material.uniforms.colour.value.set(cssColour("--grid"));
  floor.material.opacity = Number(cssColour("--shadow"));
}

function resize() {
  const { clientWidth: width, clientHeight: height } = canvas.parentElement;
  if (!width || !height) return;
  const left = coveredWidth(), fitted = left || picture.left ? fitDistance() : 0;
  picture.left = left;
  picture.share = 1 - left / width;
  camera.aspect = width / height;
  if (left) camera.setViewOffset(width, height, -left / 2, 0, width, height);
  else camera.clearViewOffset(); // which updates the projection too
  if (fitted) {
    // As much nearer or farther as a fit is, so that what filled the picture still does.
    camera.position.sub(controls.target).multiplyScalar(fitDistance() / fitted).add(controls.target);
    controls.update();
  }
  if (renderer) {
    renderer.setPixelRatio(simple ? 1 : Math.min(devicePixelRatio, 2));
    renderer.setSize(width, height, false);
  }
}

/** Bring everything to the time `now`. */
function arrange() {
  for (const track of tracks) {
    track.update();
    track.updateMatrixWorld();
  }
  for (const visual of visuals) if (visual.moving) visual.moving();
  moveCamera();
}

function draw() {
  // Light and ground stay around what is looked at.
  sun.target.position.copy(controls.target);
  sun.position.copy(controls.target).add(sunward);
  if (view.ground !== null) {
    const lift = view.ground - controls.target.dot(up);
    ground.position.copy(controls.target).addScaledVector(up, lift);
    grid.material.uniforms.middle.value.copy(ground.position);
  }
  if (renderer) renderer.render(scene, camera);
  drawGizmo();
}

const gizmo = document.getElementById("gizmo");
const tip = new THREE.Vector3();

/** Which way the axes point, in the corner. */
function drawGizmo() {
  const size = gizmo.clientWidth, ratio = Math.min(devicePixelRatio, 2);
  if (gizmo.width !== size * ratio) gizmo.width = gizmo.height = size * ratio;
  const g = gizmo.getContext("2d");
  g.setTransform(ratio, 0, 0, ratio, 0, 0);
  g.clearRect(0, 0, size, size);
  g.lineWidth = 2.5;
  g.lineCap = "round";
  g.font = "600 12px system-ui, sans-serif";
  g.textAlign = "center";
  g.textBaseline = "middle";
  const inverse = camera.quaternion.clone().invert();
  const tips = AXES.map(([name, colour], i) => {
    tip.set(+(i === 0), +(i === 1), +(i === 2)).applyQuaternion(inverse);
    return { name, colour, x: tip.x, y: -tip.y, z: tip.z };
  });
  const c = size / 2, l = size / 2 - 14;
  for (const { name, colour, x, y } of tips.sort((a, b) => a.z - b.z)) {
    g.strokeStyle = g.fillStyle = colour;
    g.beginPath();
    g.moveTo(c, c);
    g.lineTo(c + l * x, c + l * y);
    g.stroke();
    g.fillText(name, c + (l + 8) * x, c + (l + 8) * y);
  }
}

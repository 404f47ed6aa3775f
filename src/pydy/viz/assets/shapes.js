// Geometry and materials of the shapes. Lengths are along the axes of the shape's own frame.

// x → y → z → x: what lies along y comes to lie along z.
const TURN = new THREE.Matrix4().set(0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1);

function along(geometry, own, axis) {
  const turns = ("xyz".indexOf(axis) - "xyz".indexOf(own) + 3) % 3;
  for (let i = 0; i < turns; i++) geometry.applyMatrix4(TURN);
  return geometry;
}

const GEOMETRIES = {
  Sphere: (s) => new THREE.SphereGeometry(s.radius, 40, 24),
  Box: (s) => new THREE.BoxGeometry(s.x, s.y, s.z),
  Cylinder: (s) => along(new THREE.CylinderGeometry(s.radius, s.radius, s.length, 40), "y", s.axis),
  Cone: (s) => along(new THREE.ConeGeometry(s.radius, s.length, 40), "y", s.axis),
  Capsule: (s) => along(new THREE.CapsuleGeometry(s.radius, s.length, 12, 32), "y", s.axis),
  Torus: (s) => along(new THREE.TorusGeometry(s.radius, s.tube, 18, 72), "z", s.axis),
  // The third argument of a Plane is its normal; its edges are along the other axes in order.
  Plane: (s) => along(s.axis === "y" ? new THREE.PlaneGeometry(s.width, s.length)
    : new THREE.PlaneGeometry(s.length, s.width), "z", s.axis),
};

const geometries = new Map();

/** The triangles that came with a visual. */
function meshOf(visual) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(unpacked(visual.vertices, Float32Array), 3));
  geometry.setIndex(new THREE.BufferAttribute(unpacked(visual.faces, Uint32Array), 1));
  if (visual.smooth) geometry.computeVertexNormals();
  return geometry;
}

/** Return the geometry of a visual; equal shapes share one. */
function geometryOf(visual) {
  if (visual.kind === "Mesh") return meshOf(visual);
  const key = visual.kind + JSON.stringify(visual.size);
  if (!geometries.has(key)) geometries.set(key, GEOMETRIES[visual.kind](visual.size));
  return geometries.get(key);
}

function materialOf(visual) {
  return new THREE.MeshStandardMaterial({
    color: visual.colour, roughness: 0.55, metalness: 0.05,
    transparent: visual.opacity < 1, opacity: visual.opacity, depthWrite: visual.opacity === 1,
    flatShading: visual.kind === "Mesh" && !visual.smooth,
    side: visual.kind === "Plane" || visual.kind === "Mesh" ? THREE.DoubleSide : THREE.FrontSide,
  });
}

function solid(geometry, material) {
  const mesh = new THREE.Mesh(geometry, material);
  mesh.castShadow = material.opacity > 0.3;
  mesh.receiveShadow = true;
  return mesh;
}

/** A line some pixels wide through `count` points, whose ends are written with `put`. */
class WideLine extends THREE.Line2 {
  constructor(count, colour, opacity, width) {
    const geometry = new THREE.LineGeometry();
    geometry.setPositions(new Float32Array(3 * Math.max(count, 2)));
    super(geometry, new THREE.LineMaterial({ color: colour, linewidth: width, transparent: opacity < 1, opacity }));
    this.buffer = geometry.attributes.instanceStart.data; // each segment: its start, its end
    this.frustumCulled = false;
  }
  /** Let segment `i` go from `from[o…]` to `to[p…]`. */
  put(i, from, o, to, p) {
    const a = this.buffer.array;
    for (let j = 0; j < 3; j++) {
      a[6 * i + j] = from[o + j];
      a[6 * i + 3 + j] = to[p + j];
    }
  }
}

// -- shapes that change with time: each is an Object3D with a method `update` -----------------------

const Y = new THREE.Vector3(0, 1, 0);
const HEAD_LENGTH = 6, HEAD_RADIUS = 2.5; // of an arrow, relative to the radius of its shaft

function unitShaft(corners) {
  return new THREE.CylinderGeometry(1, 1, 1, corners).translate(0, 0.5, 0);
}

class ArrowShape extends THREE.Group {
  constructor(visual) {
    super();
    const material = materialOf(visual);
    this.radius = visual.radius;
    this.column = new Column(visual.vectors);
    this.shaft = solid(unitShaft(24), material);
    this.head = solid(new THREE.ConeGeometry(1, 1, 32).translate(0, 0.5, 0), material);
    this.add(this.shaft, this.head);
    this.vector = new Float32Array(3);
    this.direction = new THREE.Vector3();
  }
  update(position) {
    this.position.copy(position);
    const v = this.direction.fromArray(this.column.blend(now.k, now.part, this.vector));
    const length = v.length(), r = this.radius;
    const size = Math.min(1, length / (HEAD_LENGTH * r)), neck = length - size * HEAD_LENGTH * r;
    this.shaft.visible = this.head.visible = size > 1e-6;
    if (size <= 1e-6) return;
    this.quaternion.setFromUnitVectors(Y, v.divideScalar(length));
    this.shaft.scale.set(size * r, Math.max(neck, 1e-9 * r), size * r);
    this.head.position.y = neck;
    this.head.scale.set(size * HEAD_RADIUS * r, size * HEAD_LENGTH * r, size * HEAD_RADIUS * r);
  }
}

class RodShape extends THREE.Group {
  constructor(visual) {
    super();
    const material = materialOf(visual);
    this.column = new Column(visual.points);
    this.count = this.column.width / 3;
    this.radius = visual.radius;
    // All rods in one drawing command, all joints in another; a spoke needs few corners.
    const corners = visual.radius > 0.02 * data.view.radius ? 20 : 8;
    this.joints = many(new THREE.SphereGeometry(1, corners, corners / 2), material, this.count);
    this.rods = many(unitShaft(corners), material, this.count - 1);
    this.joints.castShadow = false; // all but the ends lie in the shadow of the rods
    this.add(this.joints, this.rods);
    this.row = new Float32Array(this.column.width);
    this.end = new THREE.Vector3();
    this.part = new THREE.Object3D();
  }
  update() {
    const { column, row, part, end, radius: r } = this;
    column.blend(now.k, now.part, row);
    for (let i = 0; i < this.count; i++) {
      part.position.fromArray(row, 3 * i);
      part.quaternion.identity();
      part.scale.setScalar(r);
      part.updateMatrix();
      this.joints.setMatrixAt(i, part.matrix);
      if (i + 1 === this.count) break;
      const length = end.fromArray(row, 3 * i + 3).sub(part.position).length();
      if (length > 0) part.quaternion.setFromUnitVectors(Y, end.divideScalar(length));
      part.scale.set(r, Math.max(length, 1e-9 * r), r);
      part.updateMatrix();
      this.rods.setMatrixAt(i, part.matrix);
    }
    this.joints.instanceMatrix.needsUpdate = this.rods.instanceMatrix.needsUpdate = true;
  }
}

/** What lies between two moving points: `axis` is a group whose y axis leads from one to the other. */
class Between extends THREE.Group {
  constructor(visual) {
    super();
    this.column = new Column(visual.points);
    this.row = new Float32Array(this.column.width);
    this.end = new THREE.Vector3();
    this.axis = new THREE.Group();
    this.add(this.axis);
  }
  update() {
    const { axis, row, end } = this;
    this.column.blend(now.k, now.part, row);
    axis.position.fromArray(row);
    const length = end.fromArray(row, 3).sub(axis.position).length();
    if (length > 0) axis.quaternion.setFromUnitVectors(Y, end.divideScalar(length));
    this.stretch(length);
  }
}

class SpringShape extends Between {
  constructor(visual) {
    super(visual);
    this.first = visual.first; // the length of its triangles
    this.axis.add(solid(meshOf(visual), materialOf(visual)));
  }
  stretch(length) {
    this.axis.scale.y = Math.max(length / this.first, 1e-6);
  }
}

class DamperShape extends Between {
  constructor(visual) {
    super(visual);
    const material = materialOf(visual), r = visual.radius;
    this.rod = solid(unitShaft(20), material);
    this.tube = solid(unitShaft(24), material);
    this.axis.add(this.rod, this.tube);
    const [around, longest] = visual.tube;
    this.longest = longest;
    this.rod.scale.set(r, 1, r);
    this.tube.scale.set(around, 1, around);
  }
  stretch(length) {
    const tube = Math.min(this.longest, length);
    this.rod.scale.y = Math.max(length, 1e-9);
    this.tube.scale.y = Math.max(tube, 1e-9);
    this.tube.position.y = length - tube;
  }
}

const LINES = { Spring: SpringShape, Damper: DamperShape };

function many(geometry, material, count) {
  const mesh = new THREE.InstancedMesh(geometry, material, count);
  mesh.castShadow = material.opacity > 0.3;
  mesh.receiveShadow = true;
  mesh.frustumCulled = false;
  return mesh;
}

class ThinLine extends WideLine {
  constructor(visual) {
    const column = new Column(visual.points);
    super(column.width / 3, visual.colour, visual.opacity, 2.5);
    this.column = column;
    this.row = new Float32Array(column.width);
  }
  update() {
    this.column.blend(now.k, now.part, this.row);
    for (let i = 0; i + 1 < this.column.width / 3; i++) this.put(i, this.row, 3 * i, this.row, 3 * i + 3);
    this.buffer.needsUpdate = true;
  }
}

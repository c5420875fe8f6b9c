// The robot, the part and the seam in 3D. Drawn when something changes.
import {
  AxesHelper, Box3, BufferGeometry, DirectionalLight, EdgesGeometry, Float32BufferAttribute, GridHelper, Group,
  HemisphereLight, Line, LineBasicMaterial, LineSegments, Matrix4, Mesh, MeshLambertMaterial, PerspectiveCamera,
  Points, PointsMaterial, Scene, Vector3, WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { Line2 } from 'three/examples/jsm/lines/Line2.js';
import { LineGeometry } from 'three/examples/jsm/lines/LineGeometry.js';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { style } from './dom.js';
import { geometryOf } from './shapes.js';
import { matrixOf } from './kinematics.js';
import { severityColour } from './severity.js';

const kEdgeAngle = 25;  // deg
const kPickRadius = 14;  // pixels
const kSeamWidth = 5;  // pixels
const kLookFrom = new Vector3(1.1, -1.5, 0.9).normalize();

export class View {
  constructor(box, data, chain) {
    Object.assign(this, { box, data, chain });
    this.scene = new Scene();
    this.world = new Group();  // the frame of the chain's first link, which may move
    this.world.matrixAutoUpdate = false;
    this.scene.add(this.world);
    this.camera = new PerspectiveCamera(35, 1, 0.01, 100);
    this.camera.up.set(0, 0, 1);
    this.renderer = new WebGLRenderer({ antialias: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.domElement.setAttribute('role', 'img');
    this.renderer.domElement.setAttribute('aria-label', 'Robot, part and torch in 3D');
    box.append(this.renderer.domElement);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.addEventListener('change', () => this.draw());
    this.#light();
    this.#addBodies();
    this.#addMarks();
    this.recolour();
    new ResizeObserver(() => this.#resize()).observe(box);
    this.#listenToClicks();
  }

  #light() {
    this.scene.add(new HemisphereLight(0xffffff, 0x8a9099, 2.2));
    const sun = new DirectionalLight(0xffffff, 1.6);
    sun.position.set(2, -3, 4);
    this.scene.add(sun);
    this.grid = new GridHelper(4, 8);
    this.grid.rotateX(Math.PI / 2);
    this.scene.add(this.grid);
  }

  #addBodies() {
    const last = this.chain.joints.length - 1;
    this.carriers = this.chain.joints.map(() => new Group());
    for (const carrier of this.carriers) {
      carrier.matrixAutoUpdate = false;
      this.world.add(carrier);
    }
    this.materials = {};
    for (const kind of ['link', 'torch', 'object'])
      this.materials[kind] = new MeshLambertMaterial({ polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
    this.edge = new LineBasicMaterial();
    for (const body of this.data.bodies) {
      const carrier = body.joint < 0 ? this.world : this.carriers[body.joint];
      const kind = body.object ? 'object' : body.joint === last ? 'torch' : 'link';
      for (const shape of body.shapes) {
        const geometry = geometryOf(shape);
        const solid = new Mesh(geometry, this.materials[kind]);
        solid.add(new LineSegments(new EdgesGeometry(geometry, kEdgeAngle), this.edge));
        solid.matrixAutoUpdate = false;
        solid.matrix.copy(matrixOf(shape.pose));
        carrier.add(solid);
      }
    }
  }

  #addMarks() {
    // Where the robot has no shapes the chain itself is drawn.
    this.bones = new Line(new BufferGeometry(), this.edge);
    this.bones.visible = !this.data.bodies.some((body) => !body.object && body.joint >= 0);
    this.tcp = new AxesHelper(0.06);
    this.tcp.matrixAutoUpdate = false;
    this.gap = new Line(new BufferGeometry(), new LineBasicMaterial({ depthTest: false }));
    this.gap.renderOrder = 3;
    this.waypoints = new Points(
      new BufferGeometry().setAttribute('position', new Float32BufferAttribute(this.data.seam.point, 3)),
      new PointsMaterial({ size: 4, sizeAttenuation: false, depthTest: false, transparent: true }));
    this.waypoints.renderOrder = 1;
    this.failed = new Points(
      new BufferGeometry(), new PointsMaterial({ size: 13, sizeAttenuation: false, depthTest: false, transparent: true }));
    this.failed.renderOrder = 4;
    this.failed.frustumCulled = this.bones.frustumCulled = this.gap.frustumCulled = false;
    this.world.add(this.bones, this.tcp, this.gap, this.waypoints, this.failed);
  }

  /** The waypoints (indices) that have a diagnosis. */
  markWaypoints(indices) {
    const points = indices.flatMap((i) => this.data.seam.point.slice(3 * i, 3 * i + 3));
    this.failed.geometry.setAttribute('position', new Float32BufferAttribute(points, 3));
    this.draw();
  }

  /** The motion that is run, its seam coloured by severity; null: none. */
  show(motion, severity) {
    this.motion = motion;
    if (this.seam) {
      this.world.remove(this.seam);
      this.seam.geometry.dispose();
      this.seam = null;
    }
    if (motion && motion.samples.time.length > 1) {
      const geometry = new LineGeometry();
      geometry.setPositions(motion.samples.seam);
      geometry.setColors(severity.worst.flatMap((value) => severityColour(value).map((c) => (c / 255) ** 2.2)));
      this.seam = new Line2(
        geometry, new LineMaterial({ linewidth: kSeamWidth, vertexColors: true, depthTest: false, transparent: true }));
      this.seam.renderOrder = 2;
      this.seam.frustumCulled = false;
      this.world.add(this.seam);
    }
  }

  /** Puts the robot at a posture, with the line between what is nearest ([] for none). */
  place(posture, nearest) {
    const pose = this.chain.at(posture);
    pose.frames.forEach((frame, j) => this.carriers[j].matrix.copy(frame));
    this.tcp.matrix.copy(pose.tcp);
    this.world.matrix.copy(this.chain.standingFrame(pose)).invert();
    this.world.matrixWorldNeedsUpdate = true;
    const joints = [new Matrix4(), ...pose.frames, pose.tcp];
    const points = joints.map((frame) => new Vector3().setFromMatrixPosition(frame));
    this.bones.geometry.setFromPoints(points);
    this.gap.visible = nearest.length > 0;
    if (this.gap.visible) this.gap.geometry.setAttribute('position', new Float32BufferAttribute(nearest, 3));
    const torch = points.at(-1).clone().applyMatrix4(this.world.matrix);
    if (this.follow && this.torch) {
      const step = torch.clone().sub(this.torch);
      this.camera.position.add(step);
      this.controls.target.add(step);
      this.controls.update();
    }
    this.torch = torch;
    this.tcpPoint = points.at(-1).toArray();
    this.draw();
  }

  /** Looks at the 'all', the 'seam' or the 'torch'. */
  fit(what) {
    this.scene.updateMatrixWorld(true);
    const box = new Box3();
    if (what === 'all') {
      for (const carrier of this.carriers) box.union(new Box3().setFromObject(carrier));
      this.#extendBySeam(box);
    } else if (what === 'seam') {
      this.#extendBySeam(box);
      box.expandByScalar(0.08);
    }
    if (what === 'torch' || box.isEmpty()) box.setFromCenterAndSize(this.torch, new Vector3(0.2, 0.2, 0.2));
    const centre = box.getCenter(new Vector3());
    const radius = Math.max(box.getSize(new Vector3()).length() / 2, 0.05);
    const narrow = Math.min(1, this.camera.aspect || 1);
    const distance = radius / Math.sin((this.camera.fov * Math.PI) / 360) / narrow;
    this.controls.target.copy(centre);
    this.camera.position.copy(centre).addScaledVector(what === 'all' ? kLookFrom : this.#fromTheTorch(), distance);
    this.camera.near = distance / 200;
    this.camera.far = distance * 50;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  /** From where the torch comes, and a little from the side, as a welder looks. */
  #fromTheTorch() {
    const back = new Vector3();
    const { torch } = this.data.seam;
    for (let i = 0; i < torch.length; i += 3) back.sub(new Vector3(torch[i], torch[i + 1], torch[i + 2]));
    back.transformDirection(this.world.matrix);
    const side = this.camera.up.clone().cross(back);
    if (!(side.length() > 0.2)) return kLookFrom;  // down from above, or from all around
    return back.addScaledVector(side.normalize(), 0.8).addScaledVector(this.camera.up, 0.3).normalize();
  }

  #extendBySeam(box) {
    const points = this.data.seam.point;
    for (let i = 0; i < points.length; i += 3)
      box.expandByPoint(new Vector3(points[i], points[i + 1], points[i + 2]).applyMatrix4(this.world.matrix));
  }

  recolour() {
    for (const [kind, material] of Object.entries(this.materials)) material.color.set(style(`--${kind}`));
    this.edge.color.set(style('--edge'));
    this.grid.material.vertexColors = false;
    this.grid.material.color.set(style('--grid'));
    this.grid.material.needsUpdate = true;
    this.gap.material.color.set(style('--limit'));
    this.failed.material.color.set(style('--bad'));
    this.waypoints.material.color.set(style('--quiet'));
    this.renderer.setClearColor(style('--view'));
    this.draw();
  }

  draw() {
    this.renderer.render(this.scene, this.camera);
  }

  #resize() {
    const { clientWidth: width, clientHeight: height } = this.box;
    if (width === 0 || height === 0) return;
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.renderer.setSize(width, height);
    this.draw();
  }

  #listenToClicks() {
    let pressed = null;
    const canvas = this.renderer.domElement;
    canvas.addEventListener('pointerdown', (event) => (pressed = [event.clientX, event.clientY]));
    canvas.addEventListener('click', (event) => {
      if (pressed && Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 3) return;
      const time = this.#timeAt(event.offsetX, event.offsetY);
      if (time !== null) this.onPick?.(time);
    });
  }

  /** Of the sample of the seam that is drawn nearest to a pixel. */
  #timeAt(x, y) {
    if (!this.motion) return null;
    const { seam, time } = this.motion.samples;
    let best = { distance: kPickRadius, time: null };
    for (let i = 0; i < time.length; ++i) {
      const p = new Vector3(...seam.slice(3 * i, 3 * i + 3)).applyMatrix4(this.world.matrix).project(this.camera);
      const distance = Math.hypot(((p.x + 1) / 2) * this.box.clientWidth - x, ((1 - p.y) / 2) * this.box.clientHeight - y);
      if (distance < best.distance) best = { distance, time: time[i] };
    }
    return best.time;
  }
}

import { BoxGeometry, BufferGeometry, CylinderGeometry, Float32BufferAttribute, SphereGeometry } from 'three';

/** The geometry of a collision shape in its own frame. */
export function geometryOf(shape) {
  if (shape.box) return new BoxGeometry(...shape.box);
  if (shape.sphere !== undefined) return new SphereGeometry(shape.sphere, 32, 16);
  if (shape.cylinder) {
    const [radius, length] = shape.cylinder;
    return new CylinderGeometry(radius, radius, length, 40).rotateX(Math.PI / 2);  // along z
  }
  const hull = new BufferGeometry();
  hull.setAttribute('position', new Float32BufferAttribute(shape.vertices, 3));
  hull.setIndex(shape.triangles);
  const flat = hull.toNonIndexed();
  flat.computeVertexNormals();
  return flat;
}

import { Matrix4, Quaternion, Vector3 } from 'three';

/** [x, y, z, qx, qy, qz, qw] as a matrix. */
export function matrixOf(pose) {
  const [x, y, z, ...turn] = pose;
  return new Matrix4().compose(new Vector3(x, y, z), new Quaternion(...turn), new Vector3(1, 1, 1));
}

/** Forward kinematics of the chain (F5), in the frame of its first link. */
export class Chain {
  constructor(robot) {
    this.joints = robot.joints.map((joint) => ({
      origin: matrixOf(joint.origin),
      axis: new Vector3(...joint.axis),
      prismatic: joint.prismatic,
    }));
    this.toTcp = matrixOf(robot.tcp);
    this.standing = { joint: robot.standing.joint, pose: matrixOf(robot.standing.pose) };
  }

  /** The frame of each joint after its own motion, and of the TCP. */
  at(posture) {
    const frames = [];
    let frame = new Matrix4();
    this.joints.forEach(({ origin, axis, prismatic }, j) => {
      const motion = new Matrix4();
      if (prismatic) motion.makeTranslation(axis.clone().multiplyScalar(posture[j]));
      else motion.makeRotationAxis(axis, posture[j]);
      frame = frame.clone().multiply(origin).multiply(motion);
      frames.push(frame);
    });
    return { frames, tcp: frame.clone().multiply(this.toTcp) };
  }

  /** Of what stands still, at a posture. */
  standingFrame({ frames }) {
    const { joint, pose } = this.standing;
    return joint < 0 ? pose.clone() : frames[joint].clone().multiply(pose);
  }
}

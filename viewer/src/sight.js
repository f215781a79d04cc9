// What of the path stands on the screen. The projection has no perspective: across and up are two linear functions.
import {Matrix4} from "three";

export class Sight {
  constructor(camera, scene, center) {
    const e = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).elements;
    this.rows = [0, 1].map(r => [e[r], e[4 + r], e[8 + r], e[12 + r] - e[r] * center[0] - e[4 + r] * center[1] - e[8 + r] * center[2]]);
    this.scene = scene;
    this.key = this.rows.join();
  }

  // Whether the box of each block comes within `margin` half widths of the middle of the screen.
  blocks(margin) {
    const q = this.scene.boxes, seen = new Uint8Array(q.length / 6);
    for (let b = 0; b < seen.length; ++b) {
      seen[b] = 1;
      for (const row of this.rows) {
        let middle = row[3], half = 0;
        for (let a = 0; a < 3; ++a) {
          middle += row[a] * (q[6 * b + a] + q[6 * b + 3 + a]) / 2;
          half += Math.abs(row[a]) * (q[6 * b + 3 + a] - q[6 * b + a]) / 2;
        }
        if (Math.abs(middle) - half > margin) seen[b] = 0;
      }
    }
    return seen;
  }

  // Whether a move may be on the screen: not both of its ends are beyond the same edge.
  meets(from, to) {
    const p = this.scene.places;
    for (const r of this.rows) {
      const a = r[0] * p[3 * from] + r[1] * p[3 * from + 1] + r[2] * p[3 * from + 2] + r[3];
      const b = r[0] * p[3 * to] + r[1] * p[3 * to + 1] + r[2] * p[3 * to + 2] + r[3];
      if ((a > 1.02 && b > 1.02) || (a < -1.02 && b < -1.02)) return false;
    }
    return true;
  }
}

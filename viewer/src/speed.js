// How many moves of the path a picture may have: measured, picture by picture, because a page may be drawn by a graphics card
// or by the processor, which other work may keep busy.

const atRest = 150, inMotion = 50; // milliseconds that a picture may take
const frame = 16; // that pass without any work
const fewest = 8000, mostEver = 400000;

export class Speed {
  constructor() {
    this.software = isSoftware();
    this.moves = this.software ? 300 : 1000; // a millisecond, until one was measured
    this.fence = null;
  }

  // `patience` is how many times as long a picture at rest may take.
  most(moving, patience) {
    return Math.min(mostEver, Math.max(fewest, this.moves * (moving ? inMotion : atRest * patience)));
  }

  begin(moves) {
    this.count = moves;
    this.begun = performance.now();
  }

  end(gl) {
    this.fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
  }

  // Whether the last picture is done.
  ready(gl) {
    if (!this.fence) return true;
    const took = performance.now() - this.begun, state = gl.clientWaitSync(this.fence, 0, 0);
    if (state === gl.TIMEOUT_EXPIRED && took < 5000) return false;
    gl.deleteSync(this.fence);
    this.fence = null;
    if (this.count > 2000 && !gl.isContextLost()) this.moves = (this.moves + this.count / Math.max(took - frame, 4)) / 2;
    return true;
  }
}

// Whether the processor draws in the place of a graphics card.
function isSoftware() {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) return true;
  const told = gl.getExtension("WEBGL_debug_renderer_info");
  const name = told ? gl.getParameter(told.UNMASKED_RENDERER_WEBGL) : "";
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

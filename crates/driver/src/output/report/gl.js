// Sides of bricks and lines by WebGL, in one context for all figures of a page, since browsers allow few.

const PLACE = `#version 300 es
in vec3 base, moves;
in vec4 tint;
uniform mat3 turn;
uniform vec2 scale, shift;
uniform float factor;
out vec3 at;
out vec4 own;
out vec2 inside;
void main() {
  at = turn * (base + factor * moves);
  own = tint;
  int corner = gl_VertexID & 3;
  inside = vec2(corner == 1 || corner == 2, corner > 1);
  gl_Position = vec4((at.xy + shift) * scale, -0.5 * at.z, 1.0);
}`;

// Light from above on the left, and darker borders of cells that are more than a few pixels.
const PAINT = `#version 300 es
precision highp float;
in vec3 at;
in vec4 own;
in vec2 inside;
uniform float lit;
out vec4 paint;
void main() {
  vec3 normal = normalize(cross(dFdx(at), dFdy(at)));
  float light = 0.74 + 0.26 * max(0.0, dot(normal.z < 0.0 ? -normal : normal, vec3(-0.35, 0.6, 0.72)));
  vec2 pixel = fwidth(inside);
  vec2 border = smoothstep(vec2(0.0), 1.2 * pixel, min(inside, 1.0 - inside));
  float large = clamp(1.4 - 6.0 * max(pixel.x, pixel.y), 0.0, 1.0);
  float shade = light * (1.0 - 0.35 * large * (1.0 - min(border.x, border.y)));
  // Lines have no normal.
  paint = vec4(lit > 0.5 ? shade * own.rgb : own.rgb, 1.0);
}`;

class Renderer {
  constructor() {
    this.canvas = document.createElement('canvas');
    this.gl = this.canvas.getContext('webgl2', { antialias: true });
    if (!this.gl) throw new Error('no WebGL 2');
    const gl = this.gl;
    this.program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, PLACE], [gl.FRAGMENT_SHADER, PAINT]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(this.program, shader);
    }
    ['base', 'moves', 'tint'].forEach((name, k) => gl.bindAttribLocation(this.program, k, name));
    gl.linkProgram(this.program);
    if (!gl.getProgramParameter(this.program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(this.program));
    this.at = (name) => gl.getUniformLocation(this.program, name);
    this.buffers = ['base', 'moves', 'tint', 'corners', 'lines', 'ink'].map(() => gl.createBuffer());
  }

  fill(buffer, values, target = this.gl.ARRAY_BUFFER) {
    this.gl.bindBuffer(target, this.buffers[buffer]);
    this.gl.bufferData(target, values, this.gl.STATIC_DRAW);
  }

  // Reads an attribute of some numbers per corner from a buffer, or zeros.
  read(attribute, buffer, numbers, kind) {
    const gl = this.gl;
    if (buffer === null) return gl.disableVertexAttribArray(attribute);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[buffer]);
    gl.enableVertexAttribArray(attribute);
    gl.vertexAttribPointer(attribute, numbers, kind, kind === gl.UNSIGNED_BYTE, 0, 0);
  }

  // Brings sides and their colours to the graphics, unless they are there.
  take(mesh, tints) {
    if (this.mesh !== mesh) {
      this.fill(0, mesh.base);
      this.fill(1, mesh.moves);
      const corners = Uint32Array.from({ length: 6 * mesh.owners.length }, (_, k) => 4 * Math.floor(k / 6) + [0, 1, 2, 0, 2, 3][k % 6]);
      this.fill(3, corners, this.gl.ELEMENT_ARRAY_BUFFER);
    }
    if (this.tints !== tints) this.fill(2, tints);
    [this.mesh, this.tints] = [mesh, tints];
  }

  // Draws sides, moved by a factor, and lines of a colour; the canvas holds them until the next drawing.
  draw({ mesh, tints, factor, lines, ink }, camera, [width, height], fine) {
    const gl = this.gl;
    [this.canvas.width, this.canvas.height] = [Math.round(width * fine), Math.round(height * fine)];
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.useProgram(this.program);
    gl.uniformMatrix3fv(this.at('turn'), true, camera.axes.flat());
    gl.uniform2f(this.at('scale'), (2 * camera.scale) / width, (2 * camera.scale) / height);
    gl.uniform2f(this.at('shift'), ...camera.shift);
    gl.uniform1f(this.at('factor'), factor);
    this.take(mesh, tints);
    gl.uniform1f(this.at('lit'), 1);
    this.read(0, 0, 3, gl.FLOAT);
    this.read(1, 1, 3, gl.FLOAT);
    this.read(2, 2, 4, gl.UNSIGNED_BYTE);
    // Behind the lines that lie in them.
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(1, 2);
    gl.drawElements(gl.TRIANGLES, 6 * mesh.owners.length, gl.UNSIGNED_INT, 0);
    gl.uniform1f(this.at('lit'), 0);
    this.fill(4, Float32Array.from(lines.flat(2)));
    this.fill(5, Uint8Array.from(lines.flatMap(() => [...ink, 255, ...ink, 255])));
    this.read(0, 4, 3, gl.FLOAT);
    this.read(1, null);
    this.read(2, 5, 4, gl.UNSIGNED_BYTE);
    gl.drawArrays(gl.LINES, 0, 2 * lines.length);
    return this.canvas;
  }
}

let renderer;

// The context of the page; null where there is none, or where the browser took it away.
function graphics() {
  try {
    if (renderer === undefined) renderer = new Renderer();
  } catch {
    renderer = null;
  }
  return renderer?.gl.isContextLost() ? null : renderer;
}

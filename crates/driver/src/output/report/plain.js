// Sides of bricks on a plain canvas, the farthest first, where there is no WebGL.

function paintPlainly(ctx, { mesh, tints, lines, ink }, to, camera) {
  const near = (side) => to[12 * side + 2] + to[12 * side + 5] + to[12 * side + 8] + to[12 * side + 11];
  const order = Array.from(mesh.owners, (_, side) => side);
  const depth = Float32Array.from(order, near);
  order.sort((a, b) => depth[a] - depth[b]);
  ctx.strokeStyle = css(ink);
  ctx.lineWidth = 1;
  for (const [a, b] of lines) {
    line(ctx, [camera.to(a), camera.to(b)]);
    ctx.stroke();
  }
  for (const side of order) {
    const at = 12 * side;
    line(ctx, [0, 3, 6, 9].map((n) => [to[at + n], to[at + n + 1]]));
    ctx.closePath();
    ctx.fillStyle = ctx.strokeStyle = css([...tints.subarray(16 * side, 16 * side + 3)]);
    ctx.fill();
    // A thin border in the same colour hides the seams between sides.
    ctx.stroke();
  }
}

// Outlines of bodies in their own frames, and how large things are.

const TURN = 2 * Math.PI;

/** Points of an arc of a circle. */
function arc(radius, from, to, count = 48) {
  return Array.from({ length: count + 1 }, (_, k) => {
    const angle = from + (k * (to - from)) / count;
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  });
}

/** What a path goes along: lengths → points. */
const PATHS = {
  to: (x, y) => [[x, y]],
  arc: (radius, from, to) => arc(radius, from, to),
  circle: (radius) => arc(radius, 0, TURN),
  ellipse: (x, y) => arc(1, 0, TURN).map(([p, q]) => [p * x, q * y]),
};

function corners(s) { return Object.keys(s).filter((key) => key.startsWith("x_")).map((key) => [s[key], s[`y_${key.slice(2)}`]]); }

/** The pieces of a shape: {points, closed, look, spoke}; look: body, hole, band, dot, blob. OUTLINES is that of the figures. */
function piecesOf(kind, sizes) {
  const measured = (length) => (Array.isArray(length) ? length[0] * (sizes[length[1]] || 0) : length);
  return (OUTLINES[kind] || OUTLINES.given).map(([look, ...parts]) => {
    const points = parts.flatMap(([way, ...lengths]) => (PATHS[way] ? PATHS[way](...lengths.map(measured)) : corners(sizes)));
    const round = parts[0][0] === "circle" && look !== "hole";
    return { points, look, closed: look === "body" || look === "hole", spoke: round ? measured(parts[0][1]) : 0 };
  });
}

/** A point of a frame in space. */
function carried([x, y], [u, v], angle) {
  const cos = Math.cos(angle), sin = Math.sin(angle);
  return [u + x * cos - y * sin, v + x * sin + y * cos];
}

/** The outlines of a body in space, holes last. */
function outlineOf(body, out) {
  const angle = out[body.angle], at = pick(body.at, out);
  const own = body.parts.length ? body.parts : [body], rims = body.rims.map((place) => out[place]);
  const parts = rims.length && own.every((part) => part.kind === "given") ? [] : own;
  const found = parts.flatMap((part) => partOutline(part, body, out).map((piece) => ({
    ...piece,
    points: piece.points.map((point) => carried(point, at, angle)),
    origin: carried(part === body ? [0, 0] : pick(part.at, out), at, angle),
  })));
  own.filter((part) => part !== body && part.kind === "particle").forEach((part) => {
    const ends = [at, carried(pick(part.at, out), at, angle)];
    found.unshift({ points: ends, look: "light", origin: at });
  });
  rims.sort((a, b) => b - a).forEach((radius, k) => {
    const points = arc(radius, 0, TURN).map((point) => carried(point, at, angle)), solid = !parts.length && k === 0;
    found.push({ points, closed: true, origin: at, look: solid ? "body" : "rim", spoke: solid ? radius : 0 });
  });
  return found.sort((a, b) => (a.look === "hole") - (b.look === "hole"));
}

function partOutline(part, body, out) {
  const sizes = Object.fromEntries(Object.entries(part.sizes).map(([key, place]) => [key, out[place]]));
  const pieces = piecesOf(part.kind, sizes);
  if (part === body) return pieces;
  const at = pick(part.at, out), angle = out[part.angle];
  return pieces.map((piece) => ({
    ...piece,
    look: part.removed ? "hole" : piece.look,
    points: piece.points.map((point) => carried(point, at, angle)),
  }));
}

/** x and y of a pair of places. */
function pick(pair, out) { return [out[pair[0]], out[pair[1]]]; }

/** Left, bottom, right, top of points. */
function boxOf(points) {
  const xs = points.map((p) => p[0]), ys = points.map((p) => p[1]);
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}

function joinBoxes(a, b) {
  return [Math.min(a[0], b[0]), Math.min(a[1], b[1]), Math.max(a[2], b[2]), Math.max(a[3], b[3])];
}

/** All points that must be seen in a frame. */
function seenPoints(motion, frame) {
  const data = motion.data.phases[frame.phase], out = motion.look(frame.phase, frame.y, frame.local);
  const found = data.bodies.flatMap((body) => outlineOf(body, out).flatMap((piece) => piece.points));
  found.push(...(data.points || []).map((point) => pick(point.at, out)));
  for (const link of [...(data.links || []), ...(data.cords || [])]) found.push(...link.ends.map((end) => pick(end, out)));
  for (const circle of data.circles || []) found.push(...round(circle, out));
  for (const turn of (data.cords || []).map((cord) => cord.turn).filter(Boolean)) found.push(...round(turn, out));
  for (const line of (data.lines || []).filter((one) => !one.of)) found.push(pick(line.through, out));
  return found;
}

function round(circle, out) {
  const [x, y] = pick(circle.at, out), r = out[circle.r];
  return [[x - r, y], [x + r, y], [x, y - r], [x, y + r]];
}

/** The size of the system in a frame. */
function extentOf(motion, frame) {
  const [left, bottom, right, top] = boxOf(seenPoints(motion, frame));
  return Math.hypot(right - left, top - bottom) || 1;
}

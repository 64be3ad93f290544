// The system in SVG, drawn to scale; forces as arrows of true length.

const SVG = "http://www.w3.org/2000/svg", XHTML = "http://www.w3.org/1999/xhtml";
const ROOM = 400, MARGIN = 62, TALLEST = 420, LABEL = [40, 24], FOLLOW = 11, EDGE = 22, FARTHEST = 80;

function make(tag, attributes = {}, inside = []) {
  const node = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...inside);
  return node;
}

const fixed = (value) => (Number.isFinite(value) ? value.toFixed(2) : "0");
const path = (points, closed) => "M" + points.map(([x, y]) => `${fixed(x)} ${fixed(y)}`).join("L") + (closed ? "Z" : "");

/** The box of a whole motion, in metres. */
function boxOfMotion(motion) {
  const step = Math.max(1, Math.floor(motion.frames.length / 80));
  let found = boxOf(seenPoints(motion, motion.frames[motion.frames.length - 1]));
  for (let k = 0; k < motion.frames.length; k += step) found = joinBoxes(found, boxOf(seenPoints(motion, motion.frames[k])));
  return found;
}

/** From metres to the units of the picture; the same for all motions that are compared. */
class Scale {
  constructor(whole, size, beyond = [0, 0, 0, 0]) {
    this.follows = Math.hypot(whole[2] - whole[0], whole[3] - whole[1]) > FOLLOW * size;
    const around = [-1, -0.6, 1, 0.6].map((share) => share * 1.5 * size), box = this.follows ? around : whole;
    const [left, bottom, right, top] = box, wide = Math.max(right - left, 1e-9), high = Math.max(top - bottom, 1e-9);
    const across = 2 * MARGIN + beyond[0] + beyond[2], upright = 2 * MARGIN + beyond[1] + beyond[3];
    this.factor = Math.min((ROOM - across) / wide, (TALLEST - upright) / high);
    if (!(wide > 1e-6 || high > 1e-6)) this.factor = 80;
    const shift = [(beyond[2] - beyond[0]) / 2, (beyond[3] - beyond[1]) / 2].map((length) => length / this.factor);
    this.middle = [(left + right) / 2 + shift[0], (bottom + top) / 2 + shift[1]];
    this.height = Math.max(220, Math.min(TALLEST, high * this.factor + upright));
  }

  /** How far the arrows of some motions reach beyond the picture: left, bottom, right, top. */
  beyond(motions, forceScale) {
    const found = [0, 0, 0, 0];
    if (this.follows) return found;
    for (const { data, out } of motions.flatMap(sampled)) {
      for (const force of data.forces) {
        const [x, y] = this.point(pick(force.at, out)), [u, v] = pick(force.vector, out).map((part) => part * forceScale.factor);
        [EDGE - x - u, y - v + EDGE - this.height, x + u + EDGE - ROOM, EDGE - y + v].forEach((over, k) => {
          if (over > found[k]) found[k] = Math.min(over, FARTHEST);
        });
      }
    }
    return found;
  }

  point([x, y]) { return [ROOM / 2 + (x - this.middle[0]) * this.factor, this.height / 2 - (y - this.middle[1]) * this.factor]; }

  /** Where a system that goes far is looked for: the middle of its bodies. */
  look(bodies, out) {
    if (!this.follows) return;
    const places = bodies.map((body) => pick(body.cm, out));
    this.middle = [0, 1].map((axis) => places.reduce((sum, place) => sum + place[axis], 0) / places.length);
  }

  points(list) { return list.map((point) => this.point(point)); }
}

/** The picture of one motion. */
class Drawing {
  constructor(svg, motion, scale, forceScale) {
    Object.assign(this, { svg, motion, scale, forceScale });
    svg.setAttribute("viewBox", `0 0 ${ROOM} ${fixed(scale.height)}`);
  }

  show(moment) {
    const { data, out } = moment, parts = [];
    this.out = out;
    this.thin = [...(data.cords || []), ...(data.links || [])].map((one) => one.ends.map((pair) => pick(pair, out)));
    this.scale.look(data.bodies, out);
    this.grounds = [];
    parts.push(...(data.circles || []).flatMap((circle) => this.circle(circle)));
    parts.push(...(data.lines || []).flatMap((line) => this.line(line, data)));
    parts.push(...(data.cords || []).map((cord, k) => this.cord(cord, data.cords[k + 1])));
    parts.push(...(data.links || []).map((link) => this.link(link)));
    parts.push(...data.bodies.flatMap((body) => this.body(body)));
    parts.push(...(data.coils || []).map((coil) => this.coil(coil)));
    parts.push(...(data.points || []).flatMap((point) => this.mark(point, data)));
    parts.push(...data.bodies.filter((body) => body.kind !== "particle").map((body) => this.dot(pick(body.cm, out), 2.2)));
    this.tips = [];
    this.thin = this.thin.map((ends) => this.scale.points(ends)).concat(this.grounds);
    parts.push(...data.forces.flatMap((force) => this.force(force)));
    parts.push(...layered(this, moment));
    parts.push(...((this.motion.blow(moment.time) || { arrows: [] }).arrows.flatMap((one) => this.impulse(one))));
    this.svg.replaceChildren(...parts, ...this.names());
  }

  body(body) {
    return outlineOf(body, this.out).flatMap((piece) => this.piece(piece));
  }

  piece(piece) {
    const points = this.scale.points(piece.points);
    if (piece.look === "dot") return [make("circle", { cx: fixed(points[0][0]), cy: fixed(points[0][1]), r: 5, class: "particle" })];
    if (piece.look === "blob") return [make("circle", { cx: fixed(points[0][0]), cy: fixed(points[0][1]), r: 22, class: "body" })];
    const d = path(points, piece.closed);
    const drawn = piece.look === "band" ? [make("path", { d, class: "band-edge" }), make("path", { d, class: "band" })] : [make("path", { d, class: piece.look })];
    if (piece.spoke) drawn.push(make("path", { d: path([this.scale.point(piece.origin), points[0]]), class: "spoke" }));
    return drawn;
  }

  dot(point, r, look = "dot") {
    const [x, y] = this.scale.point(point);
    return make("circle", { cx: fixed(x), cy: fixed(y), r, class: look });
  }

  /** A line of the ground with its hatching; one that a body carries only as a thin slot. */
  line(line, data) {
    const out = this.out, of = line.of && data.bodies.find((body) => body.name === line.of);
    if (of && line.normal) return [];
    let [a, b, c] = [out[line.a], out[line.b], out[line.c]];
    if (of) {
      const angle = out[of.angle], [u, v] = pick(of.at, out);
      [a, b] = [a * Math.cos(angle) - b * Math.sin(angle), a * Math.sin(angle) + b * Math.cos(angle)];
      c += a * u + b * v;
    }
    const size = Math.hypot(a, b);
    const piece = this.visible([a / size, b / size, c / size], !line.normal || of ? [] : this.others(line, data));
    if (!piece) return [];
    if (!line.normal) return [make("path", { d: path(piece), class: "slot" })];
    this.grounds.push(...[0, 0.25, 0.5, 0.75].map((share) => [between(...piece, share), between(...piece, share + 0.25)]));
    return [make("path", { d: hatching(piece, this.free(line)), class: "hatch" }), make("path", { d: path(piece), class: "edge" })];
  }

  /** Which side of a line is free: +1 where a x + b y > c. */
  free(line) {
    const out = this.out, [x, y] = pick(line.normal, out);
    return Math.sign(out[line.a] * x + out[line.b] * y) || 1;
  }

  /** The free half planes of the other solid lines: walls end in their corners. */
  others(line, data) {
    const out = this.out;
    return (data.lines || []).filter((other) => other !== line && !other.of && other.normal)
      .map((other) => { const s = this.free(other); return [s * out[other.a], s * out[other.b], s * out[other.c]]; });
  }

  /** The piece of a line in the picture and in some half planes, in picture units; null if there is none. */
  visible([a, b, c], planes) {
    const foot = [a * c, b * c], way = [-b, a], [mx, my] = this.scale.middle;
    const w = (ROOM / 2 - 8) / this.scale.factor, h = (this.scale.height / 2 - 8) / this.scale.factor;
    const limits = [[1, 0, mx - w], [-1, 0, -mx - w], [0, 1, my - h], [0, -1, -my - h], ...planes];
    let low = -Infinity, high = Infinity;
    for (const [p, q, r] of limits) {
      const slope = p * way[0] + q * way[1], rest = r - p * foot[0] - q * foot[1];
      if (Math.abs(slope) < 1e-12) { if (rest > 1e-9) return null; } else if (slope > 0) low = Math.max(low, rest / slope); else high = Math.min(high, rest / slope);
    }
    if (!(low < high)) return null;
    const piece = this.scale.points([low, high].map((s) => [foot[0] + s * way[0], foot[1] + s * way[1]]));
    piece.begins = low * this.scale.factor;
    return piece;
  }

  /** A fixed circle, hatched on the side where nothing moves. */
  circle(circle) {
    const out = this.out, at = pick(circle.at, out), [x, y] = this.scale.point(at), r = out[circle.r] * this.scale.factor;
    const track = make("circle", { cx: fixed(x), cy: fixed(y), r: fixed(r), class: "track" });
    if (!circle.normal || !(r > 12)) return [track];
    const [u, v] = pick(circle.through, out), [p, q] = pick(circle.normal, out), side = (u - at[0]) * p + (v - at[1]) * q < 0 ? 1 : -1;
    const count = Math.round((TURN * r) / 8), strokes = Array.from({ length: count }, (_, k) => {
      const a = (k * TURN) / count, b = a + 5 / r;
      return path([[x + r * Math.cos(a), y + r * Math.sin(a)], [x + (r + 7 * side) * Math.cos(b), y + (r + 7 * side) * Math.sin(b)]]);
    });
    return [make("path", { d: strokes.join(""), class: "hatch" }), track];
  }

  cord(cord, next) {
    const [start, end] = cord.ends.map((pair) => this.scale.point(pick(pair, this.out)));
    let d = path([start, end]);
    if (cord.turn && next) {
      const r = fixed(this.out[cord.turn.r] * this.scale.factor), to = this.scale.point(pick(next.ends[0], this.out));
      const middle = this.scale.point(pick(cord.turn.at, this.out)), large = this.isLarge(end, to, middle, cord.turn.sense);
      d += `A${r} ${r} 0 ${large} ${cord.turn.sense > 0 ? 0 : 1} ${fixed(to[0])} ${fixed(to[1])}`;
    }
    return make("path", { d, class: "cord" });
  }

  isLarge(from, to, middle, sense) {
    const a = Math.atan2(middle[1] - from[1], from[0] - middle[0]), b = Math.atan2(middle[1] - to[1], to[0] - middle[0]);
    const turn = (((b - a) * sense) % TURN + TURN) % TURN;
    return turn > Math.PI && turn < TURN - 1e-6 ? 1 : 0;
  }

  link(link) {
    const [start, end] = link.ends.map((pair) => this.scale.point(pick(pair, this.out)));
    return make("path", { d: link.kind === "spring" ? zigzag(start, end) : dashpot(start, end), class: "link" });
  }

  coil(coil) {
    const [x, y] = this.scale.point(pick(coil.at, this.out));
    const points = Array.from({ length: 40 }, (_, k) => [x + (5 + 0.35 * k) * Math.cos(k / 2.4), y - (5 + 0.35 * k) * Math.sin(k / 2.4)]);
    return make("path", { d: path(points), class: "link" });
  }

  mark(point, data) {
    const at = pick(point.at, this.out), [x, y] = this.scale.point(at);
    if (point.kind === "edge") return [make("path", { d: path([[x, y], [x - 9, y + 18], [x + 9, y + 18]], true), class: "support" })];
    if (point.kind !== "pivot" && !(point.kind === "weld" && point.ground)) return [this.dot(at, point.kind === "pin" ? 4 : 3, point.kind === "pin" ? "joint" : "dot")];
    const body = data.bodies.find((one) => one.name === point.of), first = this.motion.frames[0];
    const then = this.motion.look(first.phase, first.y, 0);
    const away = body && then[body.cm[1]] > then[point.at[1]] + 1e-9 ? 1 : -1;
    const foot = y + 14 * away;
    const ground = path([[x - 15, foot], [x + 15, foot]]);
    return [
      make("path", { d: path([[x, y], [x - 9, foot], [x + 9, foot]], true), class: "support" }),
      make("path", { d: hatching([[x - 15, foot], [x + 15, foot]], away < 0 ? 1 : -1), class: "hatch" }),
      make("path", { d: ground, class: "edge" }),
      this.dot(at, 4, "joint"),
    ];
  }

  /** An arrow of the length that its size has on the scale of forces; an arc for a couple. */
  force(force) {
    const out = this.out, look = force.unknown ? "reaction" : "applied", found = [];
    const [fx, fy] = pick(force.vector, out), size = Math.hypot(fx, fy) * this.forceScale.factor;
    if (size > 1.5) found.push(...this.arrow(force, this.scale.point(pick(force.at, out)), [fx, -fy], size, look));
    const couple = out[force.couple];
    if (Math.abs(couple) * this.forceScale.couple > 0.05) found.push(...this.turning(force, couple, look));
    return found;
  }

  /** An impulse at the place where it acts, on a scale of its own. */
  impulse(one) {
    const [u, v] = one.vector, size = Math.hypot(u, v) * this.forceScale.impulse, at = this.scale.point(one.at);
    if (!(size > 1.5)) return [];
    return [make("circle", { cx: fixed(at[0]), cy: fixed(at[1]), r: 7, class: "strike" }), ...this.pointed(at, [u, -v], size, "impulse", one.math)];
  }

  arrow(force, at, way, size, look) { return this.pointed(at, way, size, look, this.motion.data.forces[keyOf(force)].math); }

  pointed([x, y], [fx, fy], size, look, math) {
    const length = Math.hypot(fx, fy), [u, v] = [fx / length, fy / length], tip = [x + u * size, y + v * size];
    this.tips.push({ math, from: [x, y], at: tip, way: Math.atan2(v, u), look });
    const head = Math.min(9, size), back = [tip[0] - u * head, tip[1] - v * head];
    const sides = [-0.4, 0, 0.4].map((w) => [back[0] + (w ? -w * v * head : u * 0.25 * head), back[1] + (w ? w * u * head : v * 0.25 * head)]);
    return [
      make("path", { d: path([[x, y], back]), class: look }),
      make("path", { d: path([tip, ...sides], true), class: look + "-head" }),
    ];
  }

  turning(force, couple, look) {
    const body = this.motion.data.phases[0].bodies.find((one) => one.name === force.on);
    const [x, y] = this.scale.point(pick(body ? body.cm : force.at, this.out)), turn = couple * this.forceScale.couple, r = 20;
    const points = arc(r, 0, turn, 24).map(([p, q]) => [x + p, y - q]), tip = points[24], s = Math.sign(turn);
    const way = [-Math.sin(turn) * s, -Math.cos(turn) * s];
    const { couple: letter } = this.motion.data.forces[keyOf(force)];
    this.tips.push({ math: letter, from: [x, y], at: points[12], way: Math.atan2(points[12][1] - y, points[12][0] - x), look });
    const sides = [[tip[0] - 3 * way[1], tip[1] + 3 * way[0]], [tip[0] + 3 * way[1], tip[1] - 3 * way[0]]];
    return [
      make("path", { d: path(points), class: look }),
      make("path", { d: path([[tip[0] + 7 * way[0], tip[1] + 7 * way[1]], ...sides], true), class: look + "-head" }),
    ];
  }

  /** The names of the forces, each beside its tip where the others leave room. */
  names() {
    const taken = [];
    return this.tips.map((one) => {
      const spots = [0, 0.8, -0.8, 1.5, -1.5, 2.2, -2.2].map((turn) => this.spot(one, turn));
      const best = spots.map((spot) => [this.crowd(spot, taken), spot]).reduce((a, b) => (b[0] < a[0] ? b : a))[1];
      taken.push(best);
      return this.label(one, best);
    });
  }

  /** A place beside a tip, in a direction that differs by `turn` from that of the arrow, within the picture. */
  spot({ at, way }, turn) {
    const u = Math.cos(way + turn), v = Math.sin(way + turn), away = 5 + Math.abs(u) * LABEL[0] * 0.4 + Math.abs(v) * LABEL[1] * 0.5;
    return [Math.min(Math.max(at[0] + away * u, 20), ROOM - 20), Math.min(Math.max(at[1] + away * v, 13), this.scale.height - 13)];
  }

  /** How much lies in the way of a name: other names, then the shafts of arrows, strings and springs. */
  crowd(spot, taken) {
    const near = ([x, y], share) => Math.abs(x - spot[0]) < LABEL[0] * share && Math.abs(y - spot[1]) < LABEL[1] * share;
    const dotted = ([from, at]) => Array.from({ length: 9 }, (_, k) => between(from, at, k / 8));
    const shafts = this.tips.flatMap(({ from, at }) => dotted([from, at])), thin = this.thin.flatMap(dotted);
    const lying = (points) => points.filter((point) => near(point, 0.45)).length;
    return 10 * taken.filter((other) => near(other, 0.85)).length + lying(shafts) + 0.6 * lying(thin);
  }

  label({ math, look }, [x, y]) {
    const node = make("foreignObject", { x: fixed(x - 32), y: fixed(y - 13), width: 64, height: 26, class: "name " + look });
    const holder = document.createElementNS(XHTML, "div");
    holder.innerHTML = math;
    node.append(holder);
    return node;
  }
}

/** Short strokes on the side of a piece that is not free. */
function hatching(piece, free) {
  const [[x, y], [u, v]] = piece, length = Math.hypot(u - x, v - y) || 1, way = [(u - x) / length, (v - y) / length];
  const side = free > 0 ? [way[1], -way[0]] : [-way[1], way[0]], step = 8;
  const down = side.map((value) => value * 7), first = step - ((((piece.begins || 0) % step) + step) % step);
  return Array.from({ length: Math.max(0, Math.floor((length - first) / step) + 1) }, (_, k) => {
    const s = first + k * step, at = [x + way[0] * s, y + way[1] * s];
    return path([at, [at[0] + down[0] - way[0] * 6, at[1] + down[1] - way[1] * 6]]);
  }).join("");
}

/** A point on the way between two others, moved aside. */
function between([x, y], [u, v], share, aside = 0) {
  const length = Math.hypot(u - x, v - y) || 1;
  return [x + share * (u - x) - (aside * (v - y)) / length, y + share * (v - y) + (aside * (u - x)) / length];
}

function zigzag(start, end) {
  const inner = Array.from({ length: 18 }, (_, k) => between(start, end, 0.12 + (0.76 * (k + 0.5)) / 18, k % 2 ? -6 : 6));
  return path([start, between(start, end, 0.12), ...inner, between(start, end, 0.88), end]);
}

function dashpot(start, end) {
  const at = (share, aside) => between(start, end, share, aside);
  return path([start, at(0.4)]) + path([at(0.62, 7), at(0.4, 7), at(0.4, -7), at(0.62, -7)]) + path([at(0.52, 5), at(0.52, -5)]) + path([at(0.52), end]);
}

// What the parts of an object look like: scales of a wing, pits of a wing case, windows of a car. GLSL.

const common = `
float hash(vec2 p) {
  vec3 q = fract(p.xyx * vec3(0.1031, 0.1030, 0.0973));
  q += dot(q, q.yzx + 33.33);
  return fract((q.x + q.y) * q.z);
}
/** Tilts a normal by the slope of a height over two coordinates of the surface. */
vec3 tilted(vec3 N, vec2 local, vec2 slope) {
  vec3 px = dFdx(at), py = dFdy(at);
  vec2 lx = dFdx(local), ly = dFdy(local);
  float det = lx.x * ly.y - lx.y * ly.x;
  if (abs(det) < 1e-14) return N;
  vec3 a = (px * ly.y - py * lx.y) / det, b = (py * lx.x - px * ly.x) / det;
  return normalize(N - slope.x * a / max(dot(a, a), 1e-12) - slope.y * b / max(dot(b, b), 1e-12));
}
float above(float edge, float value, float soft) { return smoothstep(edge - soft, edge + soft, value); }
float line(float distance_, float width) {
  return smoothstep(1.5 * width + fwidth(distance_), 0.7 * width, abs(distance_));
}
void plain(inout Surface s, int part) {   // 1 matte, 2 gloss, 7 metal
  s.share = 0.0;
  s.albedo = vec3(part == 1 ? 0.022 : 0.008);
  s.f0 = part == 7 ? 0.55 : part == 2 ? 0.05 : 0.012;
  s.roughness = part == 1 ? 0.6 : 0.25;
}`;

/** Rows of scales, each lying on the root of the next, tilted and turned a little; veins, margin, white spots. */
const wing = `
vec3 scaleAt(vec2 q, out float edge) {
  float row = floor(q.y), up = q.y - row, x = q.x + 0.5 * mod(row, 2.0), xBefore = q.x + 0.5 * mod(row - 1.0, 2.0);
  float across_ = 2.0 * fract(xBefore) - 1.0, side = across_ * across_;
  float tip = 0.55 * (1.0 - side * side) * (0.8 + 0.4 * hash(vec2(floor(xBefore), row - 1.0)));
  bool isBefore = up < tip;
  vec2 id = isBefore ? vec2(floor(xBefore), row - 1.0) : vec2(floor(x), row);
  edge = isBefore ? 1.0 - 0.35 * smoothstep(0.8, 1.0, abs(across_)) : 0.45 + 0.55 * smoothstep(tip, tip + 0.35, up);
  return vec3(hash(id) - 0.5, hash(id + 71.0) - 0.5, hash(id + 139.0));
}
void ownPart(inout Surface s) {
  bool isFore = own.z < 1.5;
  float around = own.z - (isFore ? 0.0 : 2.0), way = own.w, edge;
  vec2 from = vec2(abs(own.x) - 0.05, own.y - 0.02), along = isFore ? vec2(0.84, 0.54) : vec2(0.74, -0.67);
  vec2 side = vec2(-along.y, along.x), q = vec2(dot(from, side) * 74.0, dot(from, along) * 46.0);
  float crisp = 1.0 - smoothstep(0.5, 1.6, 0.7 * length(vec4(dFdx(q), dFdy(q))));   // scales larger than pixels
  vec3 scale = scaleAt(q, edge);
  vec2 slope = mix(0.45, 1.0, crisp) * (side * 0.34 * scale.x + along * (0.22 * scale.y + 0.05));
  s.N = tilted(s.N, own.xy, vec2(sign(own.x) * slope.x, slope.y));
  s.roughness = clamp(max(s.roughness, 0.42) + 0.1 * (1.0 - crisp), 0.0, 1.0);
  s.shade = mix(0.85, edge, crisp) * (0.86 + 0.28 * scale.z);
  float count = isFore ? 17.0 : 19.0, fromVein = fract(around * count + 0.5) - 0.5;   // as in objects.ts
  float spread = (isFore ? 2.9 : 2.6) * way / count;
  float cell = line(way - 0.46 - 0.05 * sin(around * 25.0), 0.006);
  float vein = max(line(fromVein * spread, 0.0032) * smoothstep(0.42, 0.5, way),
                   cell * smoothstep(0.08, 0.16, around) * smoothstep(0.62, 0.5, around));
  float bend = isFore ? smoothstep(0.16, 0.44, around) * smoothstep(0.84, 0.6, around)
                      : smoothstep(0.22, 0.42, around) * smoothstep(0.86, 0.62, around);
  float apex = isFore ? exp(-pow((around - 0.44) / 0.09, 2.0)) : 0.0;
  float margin = 0.03 + 0.1 * bend + 0.15 * apex + 0.03 * (abs(fromVein) - 0.25) + 0.02 * (scale.z - 0.5);
  vec2 toSpot = vec2((1.0 - way - 0.055 - 0.05 * apex) * 0.9, (fract(around * count) - 0.5) * spread);
  float spot = smoothstep(0.019, 0.011, length(toSpot)) * smoothstep(0.55, 0.75, max(bend, apex));
  s.share = above(margin, 1.0 - way, 0.025) * (1.0 - 0.85 * vein) * smoothstep(0.03, 0.2, way) * (1.0 - spot);
  s.albedo = mix(vec3(0.014, 0.010, 0.008), vec3(0.55, 0.53, 0.5), spot) * (1.0 - s.share) * (0.7 + 0.6 * scale.z);
  s.f0 = 0.006;
  s.row = way;
}`;

/** Rows of pits along a wing case, and the seam. */
const elytra = `
void ownPart(inout Surface s) {
  vec2 q = vec2(own.x * 44.0, own.y * 10.0 + 0.5);
  float row = floor(q.y), x = q.x + 0.5 * mod(row, 2.0), down = fract(q.y) - 0.5;
  vec2 pit = vec2((fract(x) - 0.5) * 0.75, down * 1.6);
  float inside = exp(-9.0 * dot(pit, pit)), groove = exp(-22.0 * down * down);
  float fade = smoothstep(0.03, 0.1, own.x) * smoothstep(0.985, 0.9, own.x) * smoothstep(0.05, 0.09, own.y);
  fade *= (1.0 - smoothstep(0.5, 1.3, length(fwidth(q)))) * (0.75 + 0.5 * hash(vec2(floor(x), row)));
  vec2 slope = vec2(14.9 * pit.x * inside, 10.1 * pit.y * inside + 18.5 * down * groove);
  s.N = tilted(s.N, own.xy, 0.03 * fade * slope);
  s.shade = (1.0 - 0.45 * inside * fade) * mix(0.12, 1.0, smoothstep(0.0, 0.022, own.y));
  s.row = own.x;
}`;

/** Windows, arches and joints are where they are on the body, in metres. */
const car = `
void ownPart(inout Surface s) {
  vec3 p = vec3(own.xy, abs(own.z));
  float e = 0.7 * fwidth(p.x + p.y) + 0.004, belt = 0.935 + 0.02 * p.x * (p.x - 1.0), high = p.y - belt;
  float side = above(0.5, abs(normalize(turnedNormal * turn).z), e);
  float windows = side * above(-1.36, p.x + 0.5 * high, e) * above(-0.86, -p.x - 0.9 * high, e);
  windows *= (1.0 - line(p.x + 0.33, 0.03)) * above(-1.2, -p.y, e);
  float front = above(0.2, p.x, e) * above(-0.57, -p.z, e);
  float rear = above(0.98, -p.x, e) * above(-0.56, -p.z, e) * above(0.045, high, e);
  float glass = above(0.0, high, e) * max(windows, max(front, rear) * (1.0 - side));
  float arch = length(vec2(abs(p.x) - 1.32, p.y - 0.33));
  float dark = max(above(-0.372, -arch, e) * smoothstep(0.45, 0.55, p.z), above(-0.225, -p.y, e));
  float joint = max(line(p.x - 0.74, 0.005), line(p.x + 0.42, 0.005)) * above(0.29, p.y, 0.01) * above(0.58, p.z, 0.02);
  s.share = (1.0 - glass) * (1.0 - dark) * (1.0 - 0.8 * joint);
  s.f0 = 0.05 * glass;
  s.roughness = mix(s.roughness, 0.05, glass);
  s.albedo = vec3(0.004);
  s.row = clamp((p.y - 0.2) / 1.1, 0.0, 1.0);
}`;

/** A disc's clear middle, its plain ring, its grooves and its clear edge, by the radius. */
const disc = `
void ownPart(inout Surface s) {
  float radius = own.x, e = fwidth(radius), outside = above(0.385, radius, e);
  float ring = above(0.31, radius, e) * (1.0 - outside);
  s.share = outside * above(-0.972, -radius, e);
  s.f0 = mix(0.045, 0.45, ring);
  s.albedo = vec3(0.05) * (1.0 - s.share) * (1.0 - ring);
  s.row = clamp((radius - 0.385) / 0.587, 0.0, 1.0);
  vec3 away = vec3(at.x, 1e-5, at.z);
  s.across = normalize(away - dot(away, s.N) * s.N);
}`;

const own: Record<string, string> = { WING: wing, ELYTRA: elytra, CAR: car, DISC: disc };
/** The functions plain() and ownPart() for an object, in capitals. */
export const partsOf = (name: string): string =>
  common + (own[name] ?? "void ownPart(inout Surface s) {}");

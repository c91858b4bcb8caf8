// What the parts of an object look like: scales of a wing, pits of a wing case, windows of a car. GLSL.

export const parts = `
float hash(vec2 p) {
  vec3 q = fract(vec3(p.xyx) * vec3(0.1031, 0.1030, 0.0973));
  q += dot(q, q.yzx + 33.33);
  return fract((q.x + q.y) * q.z);
}
/** Tilts a normal by the slope of a height over local coordinates, both in the object's units. */
vec3 tilted(vec3 N, vec2 local, vec2 slope) {
  vec3 px = dFdx(at), py = dFdy(at);
  vec2 lx = dFdx(local), ly = dFdy(local);
  float det = lx.x * ly.y - lx.y * ly.x;
  if (abs(det) < 1e-14) return N;
  vec3 first = (px * ly.y - py * lx.y) / det, second = (py * lx.x - px * ly.x) / det;   // along the local axes
  vec3 tiltedN = N - slope.x * first / max(dot(first, first), 1e-12) - slope.y * second / max(dot(second, second), 1e-12);
  return normalize(tiltedN);
}
float line(float distance_, float width) {
  float soft = 0.5 * width + fwidth(distance_);
  return smoothstep(width + soft, width - 0.3 * width, abs(distance_));
}
void plain(inout Surface s, int part) {
  s.share = 0.0;
  s.albedo = vec3(part == 1 ? 0.022 : 0.008);
  s.f0 = part == 7 ? 0.55 : part == 2 ? 0.05 : 0.012;
  s.roughness = part == 1 ? 0.6 : 0.25;
}

#ifdef WING
/** Rows of scales, each lying on the root of the next, tilted and turned a little. */
vec3 scaleAt(vec2 q, out float edge) {
  float row = floor(q.y), up = q.y - row;
  vec2 above = vec2(q.x + 0.5 * mod(row - 1.0, 2.0), row - 1.0);
  float across = 2.0 * fract(above.x) - 1.0;
  float tip = 0.55 * (1.0 - across * across * across * across) * (0.8 + 0.4 * hash(vec2(floor(above.x), above.y)));
  bool isAbove = up < tip;
  vec2 id = isAbove ? vec2(floor(above.x), above.y) : vec2(floor(q.x + 0.5 * mod(row, 2.0)), row);
  float side = isAbove ? across : 2.0 * fract(q.x + 0.5 * mod(row, 2.0)) - 1.0;
  edge = isAbove ? 1.0 - 0.35 * smoothstep(0.8, 1.0, abs(side)) : smoothstep(tip - 0.02, tip + 0.35, up) * 0.55 + 0.45;
  return vec3(hash(id) - 0.5, hash(id + 71.0) - 0.5, hash(id + 139.0));
}
void wing(inout Surface s) {
  bool isFore = own.z < 1.5;
  float around = own.z - (isFore ? 0.0 : 2.0), out_ = own.w;
  // Scales lie along the ways from the body to the margin.
  vec2 from = vec2(abs(own.x) - 0.05, own.y - 0.02);
  vec2 along = isFore ? vec2(0.84, 0.54) : vec2(0.74, -0.67);
  vec2 q = vec2(dot(from, vec2(-along.y, along.x)) * 74.0, dot(from, along) * 46.0);
  float pixel = length(vec2(length(dFdx(q)), length(dFdy(q)))) * 0.7;
  float crisp = 1.0 - smoothstep(0.5, 1.6, pixel);
  float edge;
  vec3 scale = scaleAt(q, edge);
  vec2 lean = mix(0.45, 1.0, crisp) * (vec2(0.34, 0.22) * scale.xy + vec2(0.0, 0.05));
  vec2 slope = along * lean.y + vec2(-along.y, along.x) * lean.x;
  s.N = tilted(s.N, own.xy, vec2(sign(own.x) * slope.x, slope.y));
  s.roughness = clamp(max(s.roughness, 0.42) + 0.1 * (1.0 - crisp), 0.0, 1.0);
  s.shade = mix(0.85, edge, crisp) * (0.86 + 0.28 * scale.z);
  // Veins, the cell between them, and the dark margin with its white spots.
  float count = isFore ? 17.0 : 19.0;
  float inCell = fract(around * count + 0.5) - 0.5;
  float spread = (isFore ? 2.9 : 2.6) * out_ / count;
  float vein = line(inCell * spread, 0.0032) * smoothstep(0.42, 0.5, out_) ;
  vein = max(vein, line((out_ - 0.46 - 0.05 * sin(around * 25.0)), 0.006) * smoothstep(0.08, 0.16, around) * smoothstep(0.62, 0.5, around));
  float bend = isFore ? smoothstep(0.16, 0.44, around) * smoothstep(0.84, 0.6, around)
                      : smoothstep(0.22, 0.42, around) * smoothstep(0.86, 0.62, around);
  float apex = isFore ? exp(-pow((around - 0.44) / 0.09, 2.0)) : 0.0;
  float width = 0.03 + 0.1 * bend + 0.15 * apex;
  float jag = 0.03 * (abs(inCell) - 0.25) + 0.02 * (scale.z - 0.5);
  float lit_ = smoothstep(-0.02, 0.03, 1.0 - out_ - width - jag) * (1.0 - 0.85 * vein) * smoothstep(0.03, 0.2, out_);
  float spotAt = (1.0 - out_ - 0.055 - 0.05 * apex) * (isFore ? 0.95 : 0.8);
  float spotAcross = (fract(around * count) - 0.5) * spread;
  float spot = smoothstep(0.019, 0.011, length(vec2(spotAt, spotAcross))) * smoothstep(0.55, 0.75, max(bend, apex));
  s.share = lit_ * (1.0 - spot);
  s.albedo = mix(vec3(0.014, 0.010, 0.008), vec3(0.55, 0.53, 0.5), spot) * (1.0 - s.share) * (0.7 + 0.6 * scale.z);
  s.f0 = 0.006;
  s.row = out_;
  s.across = normalize(cross(s.N, vec3(0.0, 1.0, 0.1)));
}
#endif

#ifdef ELYTRA
/** Rows of pits along a wing case, and the seam. */
void elytron(inout Surface s) {
  vec2 q = vec2(own.x * 44.0, own.y * 10.0 + 0.5);
  float row = floor(q.y), down = fract(q.y) - 0.5;
  vec2 id = vec2(floor(q.x + 0.5 * mod(row, 2.0)), row);
  vec2 pit = vec2((fract(q.x + 0.5 * mod(row, 2.0)) - 0.5) * 0.75, down * 1.6);
  float inside = exp(-9.0 * dot(pit, pit));
  float groove = exp(-22.0 * down * down);
  float fade = smoothstep(0.03, 0.1, own.x) * smoothstep(0.985, 0.9, own.x) * smoothstep(0.05, 0.09, own.y);
  float pixel = length(fwidth(q));
  fade *= (1.0 - smoothstep(0.5, 1.3, pixel)) * (0.75 + 0.5 * hash(id));
  vec2 slope = vec2(0.10 * 18.0 * pit.x * inside * 0.75, (0.10 * 18.0 * pit.y * inside * 1.6 + 0.12 * 44.0 * down * groove));
  s.N = tilted(s.N, own.xy, 0.03 * fade * slope * vec2(44.0, 10.0) * vec2(0.25, 0.35));
  s.shade = (1.0 - 0.45 * inside * fade) * mix(0.12, 1.0, smoothstep(0.0, 0.022, own.y));
  s.row = own.x;
}
#endif

#ifdef CAR
/** Windows, arches, joints and lamps are where they are on the body, in metres. */
void car(inout Surface s) {
  vec3 p = vec3(own.xy, abs(own.z));
  float e = 0.7 * fwidth(p.x + p.y) + 0.004;
  float belt = 0.935 + 0.02 * p.x * p.x - 0.02 * p.x;
  float side = smoothstep(0.5 - e, 0.5 + e, abs(normalize(turnedNormal * turn).z));
  float above = smoothstep(belt - e, belt + e, p.y);
  float long_ = smoothstep(-1.36 - e, -1.36 + e, p.x + 0.5 * (p.y - belt)) * smoothstep(0.86 + e, 0.86 - e, p.x + 0.9 * (p.y - belt));
  float pillar = 1.0 - line(p.x + 0.33, 0.03);
  float glass = side * above * long_ * pillar * smoothstep(1.2 + e, 1.2 - e, p.y);
  float front = smoothstep(0.2 - e, 0.2 + e, p.x) * smoothstep(0.57 + e, 0.57 - e, p.z) * smoothstep(belt - e, belt + e, p.y - 0.0);
  float rear = smoothstep(-0.98 + e, -0.98 - e, p.x) * smoothstep(0.56 + e, 0.56 - e, p.z) * smoothstep(belt + 0.045 - e, belt + 0.045 + e, p.y);
  glass = max(glass, max(front, rear) * (1.0 - side));
  float arch = min(length(p.xy - vec2(1.32, 0.33)), length(p.xy - vec2(-1.32, 0.33)));
  float dark = smoothstep(0.372 + e, 0.372 - e, arch) * smoothstep(0.45, 0.55, p.z);
  dark = max(dark, smoothstep(0.225 + e, 0.225 - e, p.y));
  float joint = max(line(p.x - 0.74, 0.005), line(p.x + 0.42, 0.005)) * smoothstep(0.28, 0.3, p.y) * smoothstep(0.56, 0.6, p.z);
  s.share = (1.0 - glass) * (1.0 - dark) * (1.0 - 0.8 * joint);
  s.f0 = 0.05 * glass;
  s.roughness = mix(s.roughness, 0.05, glass);
  s.albedo = vec3(0.004);
  s.row = clamp((p.y - 0.2) / 1.1, 0.0, 1.0);
}
#endif

#ifdef DISC
/** A disc's clear middle, its plain ring, its grooves and its clear edge, by the radius. */
void disc(inout Surface s) {
  float radius = own.x, e = fwidth(radius);
  float grooves = smoothstep(0.385 - e, 0.385 + e, radius) * smoothstep(0.972 + e, 0.972 - e, radius);
  float ring = smoothstep(0.31 - e, 0.31 + e, radius) * (1.0 - smoothstep(0.385 - e, 0.385 + e, radius));
  s.share = grooves;
  s.f0 = mix(0.045, 0.45, ring);
  s.albedo = vec3(0.05) * (1.0 - grooves) * (1.0 - ring);
  s.row = clamp((radius - 0.385) / 0.587, 0.0, 1.0);
  s.across = normalize(vec3(at.x, 0.0, at.z) + 1e-5);
  s.across = normalize(s.across - dot(s.across, s.N) * s.N);
}
#endif

void partOf(inout Surface s, int part) {
#ifdef WING
  if (part == 3) wing(s);
#endif
#ifdef ELYTRA
  if (part == 4) elytron(s);
#endif
#ifdef CAR
  if (part == 5) car(s);
#endif
#ifdef DISC
  if (part == 6) disc(s);
#endif
  if (part == 1 || part == 2 || part == 7) plain(s, part);
}`;

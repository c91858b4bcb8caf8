// How the output window's objects and their room are drawn, in GLSL ES 3.00. The LUT is fetched by nacre's own snippet.

import { parts } from "./shader_parts";

/** Room and light. The room is a formula: lights are rectangles far away whose edges a rough surface makes wider, so that
 *  nothing has to be filtered beforehand. Luminances are relative to the brightest light, and chosen by eye. */
const room = `
uniform vec3 light;           // direction to the light
uniform float environment;    // 1: the room is lit
uniform mat2 roomTurn;
uniform float floorAt;
uniform vec2 shadeSize;       // of the object's shade on the floor
uniform mat2 shadeTurn;
const vec3 towards[4] = vec3[](vec3(0.177, 0.984, 0.0), vec3(-0.60, 0.36, 0.713), vec3(0.9975, 0.05, 0.05),
                               vec3(-0.799, 0.04, -0.60));
const vec4 sizes[4] = vec4[](vec4(0.75, 0.42, 0.95, 0.0), vec4(0.40, 0.30, 1.0, 0.0), vec4(0.16, 0.55, 0.75, 0.0),
                             vec4(0.12, 0.70, 0.65, 0.0));   // half across, half along, luminance

float ramp(float t, float width) {
  float x = clamp(t / width, -1.0, 1.0);
  return 0.5 + x * (0.75 - 0.25 * x * x);
}
float box(float t, float half_, float width) { return ramp(t + half_, width) - ramp(t - half_, width); }

float wall(vec3 way) {
  float front = 0.5 + 0.5 * way.z;
  return mix(0.045, 0.5, front * front);
}
float floorSeen(vec3 from, vec3 way) {
  float distance_ = max(from.y - floorAt, 0.0) / max(-way.y, 1e-4);
  vec2 foot = from.xz + distance_ * way.xz;
  vec2 inShade = shadeTurn * foot / max(shadeSize, 1e-3);
  float shade = shadeSize.x > 0.0 ? pow(1.0 + dot(inShade, inShade), -1.5) : 0.0;
  // Close to the foot it gets darker still.
  shade = 1.0 - (1.0 - shade) * (1.0 - 0.75 * exp(-2.5 * pow(dot(inShade, inShade), 1.5)) * step(1e-6, shadeSize.x));
  float far = 1.0 - exp(-dot(foot, foot) / 49.0);
  float lit = mix(0.10, 0.36, ramp((roomTurn * foot).y - 3.0, 3.0));
  return mix(lit * (1.0 - shade), wall(way), far);
}
/** @param blur  standard deviation of the directions that a rough surface mirrors, in radians */
float studio(vec3 from, vec3 way, float blur) {
  float width = sqrt(5.0 * (1.44e-4 + blur * blur));
  vec3 turned = vec3(way.x, way.y, way.z);
  turned.xz = roomTurn * way.xz;
  float sky = wall(turned);
  for (int i = 0; i < 4; ++i) {
    float ahead = dot(turned, towards[i]);
    if (ahead < 0.05) continue;
    vec3 across = normalize(cross(vec3(0.0, 1.0, 0.0), towards[i]));
    vec2 at = vec2(dot(turned, across), dot(turned, cross(towards[i], across))) / ahead / sizes[i].xy;
    float falloff = 1.0 - 0.15 * min(dot(at, at), 2.0);
    sky += sizes[i].z * falloff * box(at.x, 1.0, width / sizes[i].x) * box(at.y, 1.0, width / sizes[i].y);
  }
  float above = ramp(way.y, max(width, 0.03));
  return environment * mix(floorSeen(from, vec3(turned.x, way.y, turned.z)), sky, above);
}
/** What a white matte surface shows. */
float irradiance(vec3 N) {
  vec3 n = N;
  n.xz = roomTurn * N.xz;
  float seen = mix(0.1, 0.13, 0.5 + 0.5 * n.y);
  for (int i = 0; i < 4; ++i) {
    float facing = max(0.25 + 0.75 * dot(n, towards[i]), 0.0);
    seen += sizes[i].z * sizes[i].x * sizes[i].y * 1.27 * facing * facing;
  }
  return environment * seen + 0.5 * max(dot(N, light), 0.0);
}
vec3 backdrop(vec3 from, vec3 way) {
  if (board > 0.5) {
    float depth = 3.0 / max(dot(way, boardFacing), 0.05);
    vec3 at = way * depth;
    vec2 squares = floor(vec2(dot(at, boardAcross), at.y) / 0.48);
    return vec3(mod(squares.x + squares.y, 2.0) < 0.5 ? 0.30 : 0.10);
  }
  return vec3(max(studio(from, way, 0.05), 0.03));
}`;

/** From linear Rec.709 to what the canvas holds. What is brighter than white keeps its hue as long as it can. */
const screen = `
uniform mat3 toGamut;
vec3 encoded(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}
vec3 shown(vec3 c) {
  c = max(toGamut * c, 0.0);
  float most = max(max(c.r, c.g), c.b);
  if (most <= 0.8) return encoded(c);
  float rolled = 1.0 - 0.2 * exp(-(most - 0.8) / 0.2);
  float white = 1.0 - exp(-0.09 * (most - 0.8));
  return encoded(mix(c * rolled / most, vec3(rolled), white));
}`;

const lutCoordinates = `
uniform highp sampler2D lut;
uniform highp sampler2D lutThrough;
uniform float hasThrough;
uniform mat3 toRec709;
uniform ivec2 axes;           // see axisKind in output.ts
uniform vec4 ranges;
uniform float fixedRow;       // of a parameter; negative: it runs over the surface
uniform int quantity;         // 0 mirrored, 1 grating, 2 scattering
struct Seen { float cosine, u, azimuth, scatter, row, roughness; };

float coordinate(int axis, vec2 range, Seen s) {
  switch (axis) {
    case 0: return nacre_sqrt_cos_theta(s.cosine);
    case 1: return nacre_cos_theta(s.cosine);
    case 2: return nacre_theta_deg(s.cosine);
    case 3: return nacre_grating_u(s.u);
    case 4: return nacre_cos_scatter(s.scatter);
    case 5: return nacre_parameter(s.azimuth, range.x, range.y);
    case 6: return nacre_parameter(s.roughness, range.x, range.y);
    default: return fixedRow < 0.0 ? s.row : fixedRow;
  }
}
vec2 placeOf(Seen s) { return vec2(coordinate(axes.x, ranges.xy, s), coordinate(axes.y, ranges.zw, s)); }
vec3 mirrored(Seen s) { vec2 p = placeOf(s); return toRec709 * nacre_fetch(lut, p.x, p.y); }
vec3 letThrough(Seen s, vec3 r) {
  vec2 p = placeOf(s);
  return hasThrough > 0.5 ? toRec709 * nacre_fetch(lutThrough, p.x, p.y) : max(1.0 - max(r, 0.0), 0.0);
}`;

const lit = `
uniform mat3 turn;            // of the object
uniform vec3 eye;
uniform float roughness;
uniform float gain;
uniform int object;           // 1: a bubble, which one sees through
in vec3 at, turnedNormal, still;
flat in float kind;
in vec4 own;
out vec4 colour;

struct Surface { vec3 N; float share; vec3 albedo; float f0; float roughness; float shade; float row; vec3 across; };

float blurOf(float r) { return 0.9 * r * r; }

vec3 ofLight(Surface s, vec3 V, Seen seen) {
  float nl = clamp(dot(s.N, light), 0.0, 1.0), nv = clamp(dot(s.N, V), 1e-3, 1.0);
  vec3 h = normalize(light + V);
  float nh = clamp(dot(s.N, h), 0.0, 1.0);
  float a = max(s.roughness * s.roughness, 0.03);    // the light is a ball of some degrees
  float a2 = a * a;
  float d = a2 / (3.14159265 * pow(nh * nh * (a2 - 1.0) + 1.0, 2.0));
  float smith = nl * sqrt(nv * nv * (1.0 - a2) + a2) + nv * sqrt(nl * nl * (1.0 - a2) + a2);
  seen.cosine = dot(V, h);
  seen.roughness = 0.0;
  return (s.share * mirrored(seen) + s.f0) * d * nl * 0.5 / max(smith, 1e-6);
}
vec3 lampDirection(int i) { vec3 to = towards[i]; to.xz = to.xz * roomTurn; return to; }

/** Gratings and scattering: each lamp is a direction. */
vec3 ofLamps(Surface s, vec3 V, Seen seen) {
  vec3 sum = vec3(0.0);
  vec3 along = cross(s.N, s.across);
  for (int i = 0; i < 5; ++i) {
    vec3 L = i < 4 ? lampDirection(i) : light;
    float strength = i < 4 ? environment * 4.0 * sizes[i].x * sizes[i].y * sizes[i].z : 1.0;
    float nl = clamp(dot(s.N, L), 0.0, 1.0);
    vec3 p = L + V;
    if (quantity == 2) {
      seen.scatter = dot(-L, V);
      sum += mirrored(seen) * strength * nl / (12.566 * (nl + max(dot(s.N, V), 1e-3)));
      continue;
    }
    float u = dot(p, s.across), w = dot(p, along);
    bool rows = axes.y == 5;
    seen.u = rows ? length(vec2(u, w)) : u;
    seen.azimuth = degrees(atan(abs(w), abs(u)));
    float stray = mix(0.13, 0.3, s.roughness);
    float g = rows ? 90.0 : exp(-0.5 * w * w / (stray * stray)) / (2.5066 * stray);
    sum += mirrored(seen) * strength * nl * g;
  }
  return sum;
}
vec3 bubble(Surface s, vec3 V) {
  vec3 away = -V, back = reflect(-s.N, away);
  Seen front = Seen(dot(s.N, V), 0.0, 0.0, -1.0, 0.5 - 0.5 * s.N.y, s.roughness);
  Seen far = front;
  vec3 leaves = at + 2.0 * front.cosine * away;
  far.row = 0.5 - 0.5 * leaves.y;
  vec3 r = max(mirrored(front), 0.0), rFar = max(mirrored(far), 0.0);
  vec3 t = max(letThrough(front, r), 0.0), tFar = max(letThrough(far, rFar), 0.0);
  float b = blurOf(s.roughness);
  vec3 mirror = reflect(away, s.N);
  vec3 inner = reflect(away, -leaves);
  vec3 seen = gain * (r * studio(at, mirror, b) + t * tFar * rFar * studio(leaves, inner, b));
  seen += gain * ofLight(s, V, front);
  s.N = -leaves;
  seen += gain * t * tFar * ofLight(s, V, far);
  return seen + t * tFar / max(1.0 - r * rFar, 1e-3) * backdrop(eye, away);
}
vec3 seenOf(Surface s, vec3 V) {
  Seen seen = Seen(dot(s.N, V), 0.0, 0.0, -1.0, s.row, s.roughness);
  vec3 mirror = reflect(-V, s.N);
  float sky = studio(at, mirror, blurOf(s.roughness));
  float nv = clamp(dot(s.N, V), 0.0, 1.0);
  float f = s.f0 + (1.0 - s.f0) * pow(1.0 - nv, 5.0) * step(1e-4, s.f0) * (1.0 - s.roughness);
  vec3 rest = s.albedo * irradiance(s.N) + f * (1.0 - s.share) * sky;
  s.f0 *= 1.0 - s.share;
  if (quantity == 0) return gain * (s.share * mirrored(seen) * sky + ofLight(s, V, seen)) * s.shade + rest * s.shade;
  vec3 own_ = s.share * gain * ofLamps(s, V, seen);
  float metal = quantity == 1 ? 0.09 * s.share * sky : 0.0;
  return (own_ + metal + rest) * s.shade;
}
void main() {
  vec3 V = normalize(eye - at), N = normalize(turnedNormal);
  if (dot(N, V) < 0.0) N = -N;
  vec3 axis = normalize(vec3(0.18, 0.52, 0.84));    // the grooves of things that are no disc are circles around it
  Surface s = Surface(N, 1.0, vec3(0.0), 0.0, roughness, 1.0, 0.5 - 0.5 * still.y, normalize(axis - dot(axis, N) * N));
  int part = int(kind + 0.5);
  if (part == 1 || part == 2 || part == 7) plain(s, part);
  if (part == 3) wing(s);
  if (part == 4) elytron(s);
  if (part == 5) car(s);
  if (part == 6) disc(s);
  colour = vec4(shown(exp2(exposure) * (object == 1 ? bubble(s, V) : seenOf(s, V))), 1.0);
}`;

const head = `#version 300 es
precision highp float;
precision highp int;
`;
const common = `
uniform float exposure;
uniform float board;
uniform vec3 boardFacing, boardAcross;`;

export const vertexOfObject = `${head}
uniform mat4 view;
uniform mat3 turn;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float part;
layout(location = 3) in vec4 local;
out vec3 at, turnedNormal, still;
flat out float kind;
out vec4 own;
void main() {
  still = position;
  at = turn * position;
  turnedNormal = turn * normal;
  kind = part;
  own = local;
  gl_Position = view * vec4(at, 1.0);
}`;

export const vertexOfScreen = `${head}
out vec2 place;
void main() {
  place = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(place, 0.9999, 1.0);
}`;

export const fragmentOfObject = (snippet: string): string =>
  head + snippet + lutCoordinates + common + room + screen + lit.replace("void main()", `${parts}\nvoid main()`);

export const fragmentOfRoom = `${head}${common}${room}${screen}
uniform vec3 eye;
uniform mat3 camera;          // right and up, as long as half the picture, and forward
in vec2 place;
out vec4 colour;
void main() {
  vec3 c = shown(backdrop(eye, normalize(camera * vec3(place, 1.0))));
  // A little noise, less than a code, hides the steps of the gradient.
  colour = vec4(c + (fract(52.98 * fract(dot(gl_FragCoord.xy, vec2(0.0671, 0.00584)))) - 0.5) / 255.0, 1.0);
}`;

/** The LUT's colour at an angle, on the whole canvas, as it is: no light, no exposure. */
export const fragmentOfFlat = (snippet: string): string => `${head}${snippet}${lutCoordinates}${screen}
uniform float cosine;
out vec4 colour;
void main() {
  Seen s = Seen(cosine, 2.0 * sqrt(max(1.0 - cosine * cosine, 0.0)), 0.0, cosine, 0.5, 0.0);
  colour = vec4(encoded(toGamut * mirrored(s)), 1.0);
}`;

/** Where the light is: a small ring with a soft core. */
export const vertexOfMarker = `${head}
uniform vec3 marker;          // on the screen, and the diameter in pixels
void main() {
  gl_Position = vec4(marker.xy, 0.0, 1.0);
  gl_PointSize = marker.z;
}`;
export const fragmentOfMarker = `${head}
uniform float strength;
out vec4 colour;
void main() {
  float r = 2.0 * length(gl_PointCoord - 0.5);
  float edge = fwidth(r);
  float ring = smoothstep(0.12 + edge, 0.12, abs(r - 0.8)) * 0.8, core = smoothstep(0.42 + edge, 0.42, r);
  float dark = smoothstep(1.0, 0.7, r) * 0.35;
  float a = max(max(ring, core), dark) * strength;
  colour = vec4(vec3(max(ring, core) * strength), a);
}`;

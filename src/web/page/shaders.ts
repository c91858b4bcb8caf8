// How the output window's objects and their room are drawn, in GLSL ES 3.00. The LUT is fetched by nacre's own snippet.

import { partsOf } from "./shader_parts";

/** Room and light. Lights are rectangles far away whose edges a rough surface makes wider, so that nothing has to be
 *  filtered beforehand. Luminances are relative to the brightest light; all is chosen by eye. */
const room = `
uniform vec3 eye, light;      // light: the direction to it
uniform float environment, brightness, floorAt, board;   // environment: 1 if the room is lit
uniform mat3 camera;          // right and up, as long as half the picture, and forward
uniform vec2 shadeSize;       // of the object's shade on the floor
uniform mat2 roomTurn, shadeTurn;
// Lights: across, along, and to the light. A loop over arrays would be slow where no GPU is.
const mat3 overhead = mat3(0.0, 0.0, -1.0, -0.984, 0.177, 0.0, 0.177, 0.984, 0.0);
const mat3 key = mat3(0.766, 0.0, 0.643, 0.232, 0.933, -0.276, -0.6, 0.36, 0.714);
const mat3 rightStrip = mat3(0.05, 0.0, -0.9987, -0.05, 0.9987, -0.0025, 0.9975, 0.05, 0.05);
const mat3 leftStrip = mat3(-0.6, 0.0, 0.8, 0.04, 0.9986, 0.03, -0.799, 0.05, -0.599);
vec2 ramp(vec2 t, vec2 width) {
  vec2 x = clamp(t / width, -1.0, 1.0);
  return 0.5 + x * (0.75 - 0.25 * x * x);
}
float wall(vec3 way) { float front = 0.5 + 0.5 * way.z; return mix(0.045, 0.5, front * front); }
float floorSeen(vec3 from, vec3 way) {
  vec2 foot = from.xz + max(from.y - floorAt, 0.0) / max(-way.y, 1e-4) * way.xz;
  vec2 inShade = shadeTurn * foot / shadeSize;
  float near = dot(inShade, inShade) + 1.0;
  float open = (1.0 - inversesqrt(near) / near) * (1.0 - 0.6 * exp(2.2 - 2.2 * near));
  float lit = mix(0.10, 0.36, ramp(vec2((roomTurn * foot).y - 3.0), vec2(3.0)).x);
  return mix(wall(way), lit * open, exp(-dot(foot, foot) / 49.0));
}
/** @param way  in the light's frame  @param size  half across, half along, luminance */
float softbox(vec3 way, vec3 size, float width) {
  vec2 at = way.xy / (max(way.z, 0.05) * size.xy);
  vec2 inside = ramp(at + 1.0, width / size.xy) - ramp(at - 1.0, width / size.xy);
  return way.z < 0.05 ? 0.0 : size.z * (1.0 - 0.15 * min(dot(at, at), 2.0)) * inside.x * inside.y;
}
/** @param blur  standard deviation of the directions that a rough surface mirrors, in radians */
float studio(vec3 from, vec3 way, float blur) {
  float width = sqrt(5.0 * (1.44e-4 + blur * blur));
  way.xz = roomTurn * way.xz;
  float sky = wall(way);
  sky += softbox(way * overhead, vec3(0.75, 0.42, 0.95), width) + softbox(way * key, vec3(0.4, 0.3, 1.0), width);
  sky += softbox(way * rightStrip, vec3(0.16, 0.55, 0.75), width);
  sky += softbox(way * leftStrip, vec3(0.12, 0.7, 0.65), width);
  return environment * mix(floorSeen(from, way), sky, ramp(vec2(way.y), vec2(max(width, 0.03))).x);
}
/** What a white matte surface shows. */
float irradiance(vec3 N) { return environment * (0.34 + 0.24 * N.y) + 0.5 * max(dot(N, light), 0.0); }
float backdrop(vec3 way) {
  if (board > 0.5) {
    vec3 at = way * camera;
    vec2 squares = floor(at.xy / at.z / vec2(length(camera[0]), length(camera[1])) / 0.05);
    return mod(squares.x + squares.y, 2.0) < 0.5 ? 0.20 : 0.09;
  }
  return max(environment * mix(floorSeen(eye, way), wall(way), ramp(vec2(way.y), vec2(0.1)).x), 0.03);
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
  float most = max(max(c.r, c.g), max(c.b, 0.8));
  float rolled = 1.0 - 0.2 * exp(5.0 * (0.8 - most));
  return encoded(most > 0.8 ? mix(c * rolled / most, vec3(rolled), 1.0 - exp(0.09 * (0.8 - most))) : c);
}`;

/** AXIS_X and AXIS_Y are kinds of axes in graphics.ts; QUANTITY is 0 for mirrors, 1 for gratings, 2 for scattering. */
const lutAxes = `
uniform highp sampler2D lut, lutThrough;
uniform float hasThrough;
uniform mat3 toRec709;
uniform vec4 ranges;
uniform float fixedRow;       // of a parameter; negative: it runs over the surface
struct Seen { float cosine, u, azimuth, scatter, row, roughness; };
float coordinate(int axis, vec2 range, Seen s) {
  if (axis == 0) return nacre_sqrt_cos_theta(s.cosine);
  if (axis == 1) return nacre_cos_theta(s.cosine);
  if (axis == 2) return nacre_theta_deg(s.cosine);
  if (axis == 3) return nacre_grating_u(s.u);
  if (axis == 4) return nacre_cos_scatter(s.scatter);
  if (axis == 5) return nacre_parameter(s.azimuth, range.x, range.y);
  if (axis == 6) return nacre_parameter(s.roughness, range.x, range.y);
  return fixedRow < 0.0 ? s.row : fixedRow;
}
vec3 fetched(highp sampler2D of, Seen s) {
  return toRec709 * nacre_fetch(of, coordinate(AXIS_X, ranges.xy, s), coordinate(AXIS_Y, ranges.zw, s));
}
vec3 mirrored(Seen s) { return fetched(lut, s); }
vec3 letThrough(Seen s, vec3 r) { return max(hasThrough > 0.5 ? fetched(lutThrough, s) : 1.0 - r, 0.0); }`;

const surface = `
uniform mat3 turn;            // of the object
uniform float roughness, gain;
in vec3 at, turnedNormal, still; flat in float kind; in vec4 own;
out vec4 colour;
struct Surface { vec3 N, albedo, across; float share, f0, roughness, shade, row; };`;

const lit = `
/** luts/README.md's punctual light with what the LUT, and what clear coats mirror. */
vec3 ofLight(Surface s, vec3 V, Seen seen) {
  float nl = clamp(dot(s.N, light), 0.0, 1.0), nv = clamp(dot(s.N, V), 1e-3, 1.0);
  vec3 h = normalize(light + V);
  float a = max(s.roughness * s.roughness, 0.03), a2 = a * a;    // the light is a ball of some degrees
  float nh = clamp(dot(s.N, h), 0.0, 1.0), t = nh * nh * (a2 - 1.0) + 1.0;
  float smith = nl * sqrt(nv * nv * (1.0 - a2) + a2) + nv * sqrt(nl * nl * (1.0 - a2) + a2);
  seen.cosine = dot(V, h);
  seen.roughness = 0.0;
  return (s.share * mirrored(seen) + s.f0) * nl * a2 / (6.2832 * t * t * max(smith, 1e-6));
}
/** Gratings and scattering: each lamp is a direction. */
vec3 ofLamp(Surface s, vec3 V, Seen seen, vec3 L, float strength) {
  float nl = clamp(dot(s.N, L), 0.0, 1.0), stray = mix(0.13, 0.3, s.roughness);
  float u = dot(L + V, s.across), w = dot(L + V, cross(s.N, s.across));
  seen.scatter = dot(-L, V);
  seen.u = AXIS_Y == 5 ? length(vec2(u, w)) : u;
  seen.azimuth = degrees(atan(abs(w), abs(u)));
  float g = AXIS_Y == 5 ? 90.0 : exp(-0.5 * w * w / (stray * stray)) / (2.5066 * stray);
  if (QUANTITY == 2) g = 1.0 / (12.566 * (nl + max(dot(s.N, V), 1e-3)));
  return mirrored(seen) * strength * nl * g;
}
vec3 inRoom(vec3 way) { return vec3(way.xz * roomTurn, way.y).xzy; }
vec3 ofLamps(Surface s, vec3 V, Seen seen) {   // as strong as the lights of the room are large
  vec3 sum = ofLamp(s, V, seen, inRoom(overhead[2]), 1.2) + ofLamp(s, V, seen, inRoom(key[2]), 0.48);
  sum += ofLamp(s, V, seen, inRoom(rightStrip[2]), 0.26) + ofLamp(s, V, seen, inRoom(leftStrip[2]), 0.22);
  return environment * sum + ofLamp(s, V, seen, light, 1.0);
}
/** Front and back of a ball, and what is behind it: the way through thin walls is straight. */
#ifdef BUBBLE
vec3 seenOf(Surface s, vec3 V) {
  Seen front = Seen(dot(s.N, V), 0.0, 0.0, -1.0, 0.5 - 0.5 * at.y, s.roughness), far = front;
  vec3 leaves = at - 2.0 * front.cosine * V;
  far.row = 0.5 - 0.5 * leaves.y;
  vec3 r = max(mirrored(front), 0.0), rFar = max(mirrored(far), 0.0);
  vec3 both = letThrough(front, r) * letThrough(far, rFar);
  float blur = 0.9 * s.roughness * s.roughness;
  vec3 seen = r * studio(at, reflect(-V, s.N), blur) + both * rFar * studio(leaves, reflect(-V, leaves), blur);
  seen += ofLight(s, V, front);
  s.N = -leaves;
  seen += both * ofLight(s, V, far);
  return brightness * gain * seen + both / max(1.0 - r * rFar, 1e-3) * backdrop(-V);
}
#else
vec3 seenOf(Surface s, vec3 V) {
  Seen seen = Seen(dot(s.N, V), 0.0, 0.0, -1.0, s.row, s.roughness);
  float sky = studio(at, reflect(-V, s.N), 0.9 * s.roughness * s.roughness);
  float away = 1.0 - clamp(dot(s.N, V), 0.0, 1.0);
  float f = s.f0 + (1.0 - s.f0) * away * away * away * away * away * step(1e-4, s.f0) * (1.0 - s.roughness);
  vec3 rest = s.albedo * irradiance(s.N) + f * (1.0 - s.share) * sky;
  s.f0 *= 1.0 - s.share;
#if QUANTITY == 0
  return brightness * s.shade * (gain * (s.share * mirrored(seen) * sky + ofLight(s, V, seen)) + rest);
#else
  return brightness * s.shade * (s.share * (gain * ofLamps(s, V, seen) + (QUANTITY == 1 ? 0.09 * sky : 0.0)) + rest);
#endif
}
#endif
void main() {
  vec3 V = normalize(eye - at), N = normalize(turnedNormal);
  if (dot(N, V) < 0.0) N = -N;
  vec3 axis = normalize(vec3(0.18, 0.52, 0.84));    // the grooves of things that are no disc are circles around it
  vec3 across_ = normalize(axis - dot(axis, N) * N);
  Surface s = Surface(N, vec3(0.0), across_, 1.0, 0.0, roughness, 1.0, 0.5 - 0.5 * still.y);
  int part = int(kind + 0.5);
  if (part > 2 && part < 7) ownPart(s);
  else if (part > 0) plain(s, part);
  colour = vec4(shown(seenOf(s, V)), 1.0);
}`;

const vertexOfObject = `
uniform mat4 view;
uniform mat3 turn;
layout(location = 0) in vec3 position; layout(location = 1) in vec3 normal;
layout(location = 2) in float part; layout(location = 3) in vec4 local;
out vec3 at, turnedNormal, still; flat out float kind; out vec4 own;
void main() {
  still = position, at = turn * position, turnedNormal = turn * normal, kind = part, own = local;
  gl_Position = view * vec4(at, 1.0);
}`;
/** The whole screen, behind everything. */
const vertexOfScreen = `
out vec2 place;
void main() {
  place = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(place, 0.9999, 1.0);
}`;
const fragmentOfRoom = `
in vec2 place;
out vec4 colour;
void main() {
  vec3 c = shown(vec3(backdrop(normalize(camera * vec3(place, 1.0)))));
  // A little noise, less than a code, hides the steps of the gradient.
  colour = vec4(c + (fract(52.98 * fract(dot(gl_FragCoord.xy, vec2(0.0671, 0.00584)))) - 0.5) / 255.0, 1.0);
}`;
/** The LUT's colour at an angle, on the whole canvas, as it is: no light, no exposure. */
const fragmentOfFlat = `
uniform float cosine;
out vec4 colour;
void main() {
  Seen s = Seen(cosine, 2.0 * sqrt(max(1.0 - cosine * cosine, 0.0)), 0.0, cosine, 0.5, 0.0);
  colour = vec4(encoded(toGamut * mirrored(s)), 1.0);
}`;
/** Where the light is: a small ring with a core. */
const vertexOfMarker = `
uniform vec3 marker;          // on the screen, and the diameter in pixels
void main() { gl_Position = vec4(marker.xy, 0.0, 1.0); gl_PointSize = marker.z; }`;
const fragmentOfMarker = `
uniform float strength;
out vec4 colour;
void main() {
  float r = 2.0 * length(gl_PointCoord - 0.5), edge = fwidth(r);
  float ink = max(0.8 * smoothstep(0.12 + edge, 0.12, abs(r - 0.8)), smoothstep(0.42 + edge, 0.42, r));
  colour = strength * vec4(vec3(ink), max(ink, 0.35 * smoothstep(1.0, 0.7, r)));
}`;

/** Of the vertices and of the fragments.
 *  @param name  ROOM, MARKER, FLAT or an object in capitals
 *  @param defines  that name, and of the LUT AXIS_X, AXIS_Y and QUANTITY: what is not needed is not compiled */
export function sources(name: string, defines: string, snippet: string): [string, string] {
  const head = `#version 300 es\nprecision highp float;\nprecision highp int;\n${defines}`;
  if (name === "MARKER") return [head + vertexOfMarker, head + fragmentOfMarker];
  if (name === "ROOM") return [head + vertexOfScreen, head + room + screen + fragmentOfRoom];
  if (name === "FLAT") return [head + vertexOfScreen, head + snippet + lutAxes + screen + fragmentOfFlat];
  return [head + vertexOfObject, head + snippet + lutAxes + room + screen + surface + partsOf(name) + lit];
}

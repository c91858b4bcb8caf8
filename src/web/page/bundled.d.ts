// What build.mjs puts into the bundle under these names.

declare module "nacre-module" {
  const createNacre: import("./module").CreateNacre;
  export default createNacre;
}
declare module "nacre-wasm" {
  const bytes: Uint8Array;
  export default bytes;
}
declare module "nacre-scenes" {
  const scenes: import("./module").ShippedScene[];
  export default scenes;
}
declare module "nacre-worker" {
  const script: string;
  export default script;
}

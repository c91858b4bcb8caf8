// Reads what nacre writes: EXR of one part, scanlines, no compression, channels B, G, R.

/** { attributes: { name: bytes }, width, height, isHalf, components: the stored bits, row by row, B then G then R } */
export function readExr(file) {
  const bytes = new Uint8Array(file); // a copy: a Buffer of Node lies anywhere in its memory
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = 8; // magic number and version
  const text = () => {
    const end = bytes.indexOf(0, at);
    const result = new TextDecoder().decode(bytes.subarray(at, end));
    at = end + 1;
    return result;
  };
  const attributes = {};
  while (bytes[at] !== 0) {
    const name = text();
    text(); // its type
    const size = view.getInt32(at, true);
    attributes[name] = bytes.slice(at + 4, at + 4 + size);
    at += 4 + size;
  }
  at += 1;
  const window = new DataView(attributes.dataWindow.buffer);
  const width = window.getInt32(8, true) + 1;
  const height = window.getInt32(12, true) + 1;
  const isHalf = attributes.channels[2] === 1; // behind "B" and its zero
  at += 8 * height; // where each row begins
  const components = [];
  for (let y = 0; y < height; ++y) {
    at += 8; // y, and the row's size
    for (let i = 0; i < 3 * width; ++i, at += isHalf ? 2 : 4) {
      components.push(isHalf ? view.getUint16(at, true) : view.getUint32(at, true));
    }
  }
  return { attributes, width, height, isHalf, components };
}

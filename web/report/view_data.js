// One camera's arrays (cli/view_block.h), opened from the bytes of its block, and the row of faces.csv of a face.

const arrayTypes = { u8: Uint8Array, u32: Uint32Array, u64: Uint32Array, f32: Float32Array, f64: Float64Array };
const elementBytes = { u8: 1, u32: 4, u64: 8, f32: 4, f64: 8 };
const facings = ["front", "back", "edge-on", "mixed", "skipped"];

// An object with a typed array per name. A u64 is two numbers, the lower half first.
export function openArrays(buffer) {
  const headBytes = new DataView(buffer).getUint32(0, true);
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, headBytes)));
  const arrays = {};
  let begin = 4 + headBytes;
  for (const { name, type, count } of head) {
    const bytes = count * elementBytes[type];
    const ArrayType = arrayTypes[type];
    arrays[name] = new ArrayType(buffer, begin, bytes / ArrayType.BYTES_PER_ELEMENT);
    begin += Math.ceil(bytes / 8) * 8;
  }
  return arrays;
}

// What was stored as the bits that differ from another column.
function restored(differences, usual) {
  const bits = new Uint32Array(usual.buffer, usual.byteOffset, 2 * usual.length);
  const result = new Float64Array(usual.length);
  const resultBits = new Uint32Array(result.buffer);
  for (let i = 0; i < bits.length; ++i) resultBits[i] = differences[i] ^ bits[i];
  return result;
}

// The block of a camera, with the columns of faces.csv under their names.
export function openView(buffer) {
  const arrays = openArrays(buffer);
  const inView = restored(arrays.face_in_view_area, arrays.face_area);
  const columns = {
    area: arrays.face_area,
    in_view_area: inView,
    visible_area: restored(arrays.face_visible_area, inView),
    image_area: arrays.face_image_area,
    visible_image_area: restored(arrays.face_visible_image_area, arrays.face_image_area),
  };
  return { ...arrays, columns, faceCount: arrays.face_area.length, triangleCount: arrays.triangle_face.length };
}

// [column, value] as faces.csv has them.
export function faceRow(view, face, panelNames) {
  const row = [["face", face], ["facing", facings[view.face_facing[face]]]];
  for (const [name, values] of Object.entries(view.columns)) row.push([name, values[face]]);
  panelNames.forEach((panel, number) => {
    row.push([`reflecting_area:${panel}`, view.face_reflecting_area[number * view.faceCount + face]]);
  });
  return row;
}

// The corners of a triangle, [x, y, z] each.
export function triangleCorners(view, triangle) {
  return [0, 1, 2].map((i) => {
    const begin = 3 * view.corners[3 * triangle + i];
    return [view.positions[begin], view.positions[begin + 1], view.positions[begin + 2]];
  });
}

// Of a face; [begin, end): the triangles of a face follow each other, and the faces are in order.
export function trianglesOfFace(view, face) {
  return [firstTriangle(view, face), firstTriangle(view, face + 1)];
}

function firstTriangle(view, face) {
  let low = 0;
  let high = view.triangleCount;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (view.triangle_face[middle] < face) low = middle + 1;
    else high = middle;
  }
  return low;
}

// The data that the command put into the page: blocks of bytes, one a line, each compressed with gzip and in base64.

function blockTexts() {
  return document.getElementById("page-data").textContent.trim().split("\n");
}

function bytesOfBase64(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

// Resolves to an ArrayBuffer.
export async function unpackedBlock(number) {
  const packed = new Blob([bytesOfBase64(blockTexts()[number])]);
  return new Response(packed.stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}

// Of a block that is JSON.
export async function jsonBlock(number) {
  return JSON.parse(new TextDecoder().decode(await unpackedBlock(number)));
}

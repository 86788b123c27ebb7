// The pages as C++: string literals, in pieces that every compiler takes.

const pieceLength = 8192;

// Bytes beyond ASCII, and what would end or change a literal, as octal escapes of three digits: these end by themselves.
function literal(bytes) {
  let text = "";
  for (const byte of bytes) {
    const plain = byte >= 0x20 && byte < 0x7f && byte !== 0x22 && byte !== 0x5c && byte !== 0x3f;
    text += plain ? String.fromCharCode(byte) : `\\${byte.toString(8).padStart(3, "0")}`;
  }
  return `"${text}"`;
}

function pieces(name, text) {
  const bytes = Buffer.from(text, "utf8");
  const literals = [];
  for (let i = 0; i < bytes.length; i += pieceLength) literals.push(literal(bytes.subarray(i, i + pieceLength)));
  return `constexpr const char* ${name}_pieces[] = {\n${literals.join(",\n")}};\n`;
}

// templates: [{name, text}]; each name is one of PageName.
export function pageSource(templates) {
  const cases = templates.map(({ name }) => `  if (page == PageName::${name}) return ${name}_pieces;\n`);
  return [
    '#include "cli/pages/page_template.h"\n\nnamespace sightline::cli {\n\nnamespace {\n',
    ...templates.map(({ name, text }) => pieces(name, text)),
    "}  // namespace\n\nstd::span<const char* const> page_pieces(PageName page) {\n",
    ...cases,
    "  return {};\n}\n\n}  // namespace sightline::cli\n",
  ].join("\n");
}

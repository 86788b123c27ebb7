// The pages that the command writes: one self-contained HTML file each, bundled from web/ when the command was built.
//
// In:  data, packed: one block, or several with a line end between them. Out: the page with the data in it.
// Holds: packed data has none of HTML's characters, so whatever names are in it stay text.
// Errors: PageError where the command was built without pages.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "geometry/numbers/errors.h"

namespace sightline::cli {

class PageError : public Error {
  using Error::Error;
};

// A folder of this name is in web/.
enum class PageName : std::uint8_t { report, trace };

// To be asked before the work that the page would show.
void require_page(PageName page);

[[nodiscard]] std::string page_with_data(PageName page, std::string_view packed_data);

// Data for a page: compressed with gzip, in base64. The same bytes give the same text with one version of zlib; the text
// is of A-Z a-z 0-9 + / = only. Errors: std::bad_alloc.
[[nodiscard]] std::string packed(std::string_view bytes);

// The parts of it.
[[nodiscard]] std::string gzip(std::string_view bytes);
[[nodiscard]] std::string base64(std::string_view bytes);

// The template in pieces, made by web/build.mjs; none where the command was built without it.
[[nodiscard]] std::span<const char* const> page_pieces(PageName page);

}  // namespace sightline::cli

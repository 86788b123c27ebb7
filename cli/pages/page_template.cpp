#include "cli/pages/page_template.h"

namespace sightline::cli {

namespace {

constexpr std::string_view place_of_data = "@DATA@";

}  // namespace

void require_page(PageName page) {
  if (!page_pieces(page).empty()) return;
  throw PageError(
      "this sightline was built without its pages: install nodejs and npm, and build it again with the network at "
      "hand");
}

std::string page_with_data(PageName page, std::string_view packed_data) {
  require_page(page);
  std::string text;
  for (const char* const piece : page_pieces(page)) text += piece;
  const std::size_t place = text.find(place_of_data);
  if (place == std::string::npos) throw InternalError("the page has no place for its data");
  text.replace(place, place_of_data.size(), packed_data);
  return text;
}

}  // namespace sightline::cli

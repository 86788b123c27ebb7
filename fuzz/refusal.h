// A refusal is part of the interface, too: it must be one line that names the file.
#pragma once

#include <string>

#include "fuzz/checks.h"
#include "geometry/numbers/errors.h"

namespace sightline::fuzz {

// Throws Finding unless the message reads "FILE: cause" or "FILE:LINE: cause" with a line of the text.
void check_refusal(const InputError& refusal, std::string_view text, const std::string& file);

}  // namespace sightline::fuzz

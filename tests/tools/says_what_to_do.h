// Every refusal says what to do: it ends with it, or names what it must be instead.
#pragma once

#include <string>
#include <string_view>

namespace sightline::tests {

// Returns whether the words after the last "; " begin with a verb that asks for something ("; give exactly one"), or
// the message says what must be ("'emits' must be \"front\" or \"both\"").
[[nodiscard]] bool says_what_to_do(std::string_view message);

// Returns what the error says that `call` throws; of another error, or none, nothing.
template <class Error, class Call>
[[nodiscard]] std::string message_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace sightline::tests

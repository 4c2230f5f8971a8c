// The check of every option that takes a time.
#pragma once

#include <charconv>
#include <cmath>
#include <string>

#include <CLI/CLI.hpp>

namespace marrow::tools {

// A finite decimal number; clips decide themselves what lies outside them.
inline CLI::Validator seconds() {
  return {[](const std::string& text) {
            float value = 0;
            const char* const end = text.data() + text.size();
            const auto [stop, error] = std::from_chars(text.data(), end, value);
            const bool good = error == std::errc() && stop == end && std::isfinite(value);
            return good ? std::string() : "not a finite number of seconds: " + text;
          },
          ""};
}

}  // namespace marrow::tools

// Values as they are written, for the options' setters. Each throws tools::Failure (usage) at the value's origin.
#pragma once

#include <string>
#include <string_view>

#include "cook/options/options.h"

namespace marrow::cook {

// For a value that cannot be used: which rule it breaks, and what to do.
[[noreturn]] void refuse(const Value& value, const std::string& rule, const std::string& advice);

// "0.1mm", "3cm", "0.0001m", or a share as in "0.05%".
struct Amount {
  double value = 0;  // metres or, if is_share, 1 for 100 %
  bool is_share = false;
};

// False, and then `out` is of no use, unless text is a positive amount.
bool read_amount(std::string_view text, Amount& out);

// Both ends belong to the range.
double number_between(const Value& given, double least, double most);
int whole_number(const Value& given, int least, int most);

}  // namespace marrow::cook

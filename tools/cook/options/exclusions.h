// What cannot be asked of the cooker together, or alone, said once.
#pragma once

#include "cook/options/options.h"

namespace marrow::cook {

// What is cooked, which the scene decides as well.
enum class Product { character, outfit, pack };

// Throws tools::Failure (usage) at the first option of the table that does not go with the others.
void check_together(const CookOptions& options, const Options& given);

// The same of what `product` cannot have, once the scene says what it is.
void check_for(Product product, const CookOptions& options);

}  // namespace marrow::cook

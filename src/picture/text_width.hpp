#pragma once

#include <string>

namespace wristwise {

/// About how wide a text is in a sans-serif font of this size, px: rather too wide.
double text_width(const std::string& text, double size);

/// The text, its end replaced by an ellipsis where it would be wider than `width` px.
std::string fitted(const std::string& text, double size, double width);

}  // namespace wristwise

#pragma once

#include <cstddef>
#include <vector>

namespace wristwise {

/// Breakpoints chosen among `times` so that neighbours are as near to `spacing` apart as the times
/// allow; the first and the last time are kept.
std::vector<double> choose_breakpoints(const std::vector<double>& times, double spacing);

/// About every n-th of them; the first and the last are kept.
std::vector<double> every_nth(const std::vector<double>& breakpoints, std::size_t n);

/// Splits the spans that hold one of the times `at` (ascending; both ends count), unless a half
/// would be shorter than `shortest` (s): at one of the `preferred` times (ascending) where one lies
/// in the middle half of the span, else in its middle.
std::vector<double> with_split_spans(const std::vector<double>& breakpoints,
                                     const std::vector<double>& at,
                                     const std::vector<double>& preferred, double shortest);

}  // namespace wristwise

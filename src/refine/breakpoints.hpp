#pragma once

#include <cstddef>
#include <vector>

#include "refine/seam_features.hpp"
#include "refine/seam_turning.hpp"

namespace wristwise {

/// Breakpoints chosen among `times` so that neighbours are as near to `spacing` apart as the times
/// allow; the first and the last time are kept.
std::vector<double> choose_breakpoints(const std::vector<double>& times, double spacing);

/// The same, with spans near turns of the seam so short that it turns by no more than `turn` (rad)
/// in each of them, as far as the times allow; neighbouring spans differ by a half at most.
std::vector<double> choose_breakpoints(const std::vector<double>& times, double spacing,
                                       const SeamTurning& turning, double turn);

/// Spans longer than one and a half times `spacing` (s) cut into equal parts of about that length.
std::vector<double> with_long_spans_cut(const std::vector<double>& breakpoints, double spacing);

/// More breakpoints about each feature: the spacing is the feature's there and grows by a half with
/// each span.
std::vector<double> graded(const std::vector<double>& breakpoints,
                           const std::vector<SeamFeature>& features);

/// Each moved to the nearest of `times` (ascending), once.
std::vector<double> moved_to(const std::vector<double>& times,
                             const std::vector<double>& breakpoints);

/// About every n-th of them, more about turns of the seam, as above; the first and the last are
/// kept.
std::vector<double> every_nth(const std::vector<double>& breakpoints, std::size_t n,
                              const SeamTurning& turning, double turn);

/// Splits the spans that hold one of the times `at` (ascending; both ends count) at the one of
/// `places` (ascending) that is nearest to the middle; spans without one inside are kept.
std::vector<double> split_at_places(const std::vector<double>& breakpoints,
                                    const std::vector<double>& at,
                                    const std::vector<double>& places);

/// Splits them in the middle, unless a half would be shorter than `shortest` (s).
std::vector<double> split_in_halves(const std::vector<double>& breakpoints,
                                    const std::vector<double>& at, double shortest);

}  // namespace wristwise

#include <cmath>

#include "io/coordinate_keys.hpp"
#include "io/path_section.hpp"

namespace wristwise {

namespace {

void read_range(const ConfigReader& reader, int coordinate, ToleranceBox& box) {
  const Quantity quantity = coordinate_quantity(coordinate);
  double& lower = box.lower[coordinate];
  double& upper = box.upper[coordinate];
  if (reader.is_word("free")) {
    if (coordinate < 3) reader.fail("'free' is for rotations", "a length or [lower, upper]");
    lower = -ToleranceBox::kFree;
    upper = ToleranceBox::kFree;
  } else if (reader.is_list()) {
    const auto bounds = reader.items(2, "[lower, upper]");
    lower = bounds[0].quantity(quantity);
    upper = bounds[1].quantity(quantity);
    if (lower > upper) reader.fail("the lower bound is above the upper", "[lower, upper]");
  } else {
    upper = reader.not_negative(quantity);
    lower = -upper;
  }
}

/// The short form for a tool that may turn freely about one of its axes.
void read_symmetry_axis(const ConfigReader& reader, const ConfigReader& tolerance,
                        ToleranceBox& box) {
  const std::string axis = reader.choice({"x", "y", "z"});
  const int coordinate = 3 + (axis[0] - 'x');
  const auto range = find_coordinate(tolerance, coordinate);
  if (range && !range->is_word("free"))
    range->fail("contradicts axially_symmetric: " + axis, "'free', or one of the two keys");
  box.lower[coordinate] = -ToleranceBox::kFree;
  box.upper[coordinate] = ToleranceBox::kFree;
}

}  // namespace

ToleranceBox read_tolerance(const ConfigReader& reader, const std::vector<std::string>& others) {
  std::vector<std::string> keys = coordinate_keys();
  keys.insert(keys.begin(), {"frame", "axially_symmetric"});
  keys.insert(keys.end(), others.begin(), others.end());
  reader.expect_keys(keys);

  ToleranceBox box;
  if (const auto frame = reader.find("frame"))
    box.frame =
        frame->choice({"path", "base"}) == "path" ? ToleranceFrame::path : ToleranceFrame::base;
  for (int i = 0; i < 6; ++i)
    if (const auto range = find_coordinate(reader, i)) read_range(*range, i, box);
  if (const auto axis = reader.find("axially_symmetric")) read_symmetry_axis(*axis, reader, box);
  box.validate(reader.where());
  return box;
}

}  // namespace wristwise

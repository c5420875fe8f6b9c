#include "io/path_section.hpp"

namespace wristwise {

namespace {

constexpr const char* kForms = "keep, stop, slow, {stop: time}, {slow: ratio} or {blend: distance}";

CornerOptions named(const ConfigReader& reader) {
  CornerOptions corners;
  if (reader.is_word("keep"))
    corners.kind = CornerOptions::Kind::keep;
  else if (reader.is_word("stop"))
    corners.kind = CornerOptions::Kind::stop;
  else if (reader.is_word("slow"))
    corners.kind = CornerOptions::Kind::slow;
  else
    reader.fail("no way to treat corners", kForms);
  return corners;
}

double read_ratio(const ConfigReader& reader) {
  const double ratio = reader.positive(Quantity::number);
  if (ratio >= 1) reader.fail("not slower than the weld speed", "a ratio between 0 and 1");
  return ratio;
}

}  // namespace

CornerOptions read_corners(const ConfigReader& reader) {
  if (!reader.is_map()) return named(reader);
  CornerOptions corners;
  if (const auto time = reader.find("stop")) {
    reader.expect_keys({"stop", "turn_rate"});
    corners.kind = CornerOptions::Kind::stop;
    corners.ramp_time = time->positive(Quantity::time);
    if (const auto rate = reader.find("turn_rate"))
      corners.turn_rate = rate->positive(Quantity::turn_rate);
  } else if (const auto ratio = reader.find("slow")) {
    reader.expect_keys({"slow", "ramp"});
    corners.kind = CornerOptions::Kind::slow;
    corners.speed_ratio = read_ratio(*ratio);
    if (const auto ramp = reader.find("ramp")) corners.ramp_time = ramp->positive(Quantity::time);
  } else if (const auto distance = reader.find("blend")) {
    reader.expect_keys({"blend"});
    corners.kind = CornerOptions::Kind::blend;
    corners.distance = distance->positive(Quantity::length);
  } else {
    reader.fail("no way to treat corners", kForms);
  }
  return corners;
}

RunDescription read_run(const ConfigReader& reader, const std::string& away) {
  RunDescription run;
  run.where = reader.where();
  if (!reader.is_map()) {
    run.length = reader.positive(Quantity::length);
    return run;
  }
  reader.expect_keys({away, "duration"});
  run.away = reader.at(away).vector(Quantity::length);
  if (const auto duration = reader.find("duration"))
    run.duration = duration->positive(Quantity::time);
  return run;
}

}  // namespace wristwise

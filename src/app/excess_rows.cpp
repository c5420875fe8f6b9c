#include "app/excess_rows.hpp"

namespace wristwise::app {

namespace {

void append(const std::string& where, const Vector6& first, const Vector6& second,
            std::vector<TableRow>& rows) {
  rows.push_back({"outside the tolerance " + where + ", m",
                  short_number(first.head<3>().maxCoeff()),
                  short_number(second.head<3>().maxCoeff())});
  rows.push_back({"  and in orientation, rad", short_number(first.tail<3>().maxCoeff()),
                  short_number(second.tail<3>().maxCoeff())});
}

}  // namespace

void append_excess_rows(const Verification& first, const Verification& second,
                        std::vector<TableRow>& rows) {
  append("at waypoints", first.tolerance_excess, second.tolerance_excess, rows);
  append("between them", first.tolerance_excess_between, second.tolerance_excess_between, rows);
}

}  // namespace wristwise::app

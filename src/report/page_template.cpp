#include "report/page_template.hpp"

#include <cstddef>

extern "C" {
extern const char wristwise_page_template[];      // page_template_bytes.S
extern const char wristwise_page_template_end[];  // likewise
}

namespace wristwise {

std::string_view page_template() {
  return {wristwise_page_template,
          static_cast<std::size_t>(wristwise_page_template_end - wristwise_page_template)};
}

}  // namespace wristwise

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/command_line.hpp"
#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "wristwise/error.hpp"

namespace wristwise::app {

namespace {

void print_error(std::string message, ColourChoice colour) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  fmt::print(stderr, "{} {}\n", Paint(colour, STDERR_FILENO).bad("wristwise:"), message);
}

}  // namespace

int run(int argc, char** argv) {
  catch_interrupts();
  CommandLine line;
  try {
    return line.run({argv + std::min(argc, 1), argv + argc});
  } catch (const InvalidInput& error) {
    print_error(error.what(), line.colour());
    return kInvalidInput;
  } catch (const std::filesystem::filesystem_error& error) {
    print_error(error.path1().string() + ": cannot be read or written: " + error.code().message(),
                line.colour());
    return kInvalidInput;
  } catch (const std::exception& error) {
    print_error(std::string("internal error: ") + error.what(), line.colour());
    return kInternalError;
  } catch (...) {
    print_error("internal error", line.colour());
    return kInternalError;
  }
}

}  // namespace wristwise::app

int main(int argc, char** argv) { return wristwise::app::run(argc, argv); }

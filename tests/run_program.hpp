#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "temporary_folder.hpp"

namespace wristwise::test {

struct ProgramRun {
  int exit_code = -1;
  std::string out, err;
};

/// Runs a program in `folder`; sends it a signal after a while where `signal_after` is set.
inline ProgramRun run_executable(
    std::string program, const std::filesystem::path& folder,
    const std::vector<std::string>& arguments,
    std::chrono::milliseconds signal_after = std::chrono::milliseconds(0), int signal_number = 0) {
  const std::string out_file = folder / "stdout.txt", err_file = folder / "stderr.txt";
  std::vector<char*> argv;
  argv.push_back(program.data());
  std::vector<std::string> copies = arguments;
  for (std::string& argument : copies) argv.push_back(argument.data());
  argv.push_back(nullptr);

  const pid_t child = fork();
  if (child == 0) {
    const int out = open(out_file.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
    const int err = open(err_file.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
    if (out < 0 || err < 0 || dup2(out, 1) < 0 || dup2(err, 2) < 0 || chdir(folder.c_str()) != 0)
      _exit(126);
    execv(argv[0], argv.data());
    _exit(127);
  }
  if (signal_number != 0) {
    std::this_thread::sleep_for(signal_after);
    kill(child, signal_number);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ProgramRun run;
  run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  run.out = file_text(out_file);
  run.err = file_text(err_file);
  std::filesystem::remove(out_file);
  std::filesystem::remove(err_file);
  return run;
}

/// The same with wristwise.
inline ProgramRun run_program(const std::filesystem::path& folder,
                              const std::vector<std::string>& arguments,
                              std::chrono::milliseconds signal_after = std::chrono::milliseconds(0),
                              int signal_number = 0) {
  return run_executable(WRISTWISE_PROGRAM, folder, arguments, signal_after, signal_number);
}

}  // namespace wristwise::test

#include "parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace wristwise {
namespace {

TEST(ParallelFor, VisitsEveryIndexOnce) {
  for (const std::size_t count : {0U, 1U, 2U, 7U, 1000U}) {
    for (const int threads : {1, 2, 5, 16}) {
      std::vector<std::atomic<int>> visits(count);
      std::atomic<bool> is_worker_valid{true};
      parallel_for(count, threads, [&](int worker, std::size_t i) {
        ++visits.at(i);
        if (worker < 0 || worker >= threads) is_worker_valid = false;
      });
      for (const auto& visit : visits) EXPECT_EQ(visit, 1);
      EXPECT_TRUE(is_worker_valid);
    }
  }
}

TEST(ParallelFor, WorkerZeroIsTheCallingThreadAndEachWorkerIsOneThread) {
  constexpr int kThreads = 4;
  std::mutex mutex;
  std::vector<std::set<std::thread::id>> threads_of(kThreads);
  parallel_for(200, kThreads, [&](int worker, std::size_t) {
    std::this_thread::sleep_for(std::chrono::microseconds(50));
    const std::lock_guard<std::mutex> lock(mutex);
    threads_of[static_cast<std::size_t>(worker)].insert(std::this_thread::get_id());
  });
  EXPECT_LE(threads_of[0].size(), 1U);
  if (!threads_of[0].empty()) {
    EXPECT_EQ(*threads_of[0].begin(), std::this_thread::get_id());
  }
  std::set<std::thread::id> all;
  std::size_t sum = 0;
  for (const auto& ids : threads_of) {
    EXPECT_LE(ids.size(), 1U);
    sum += ids.size();
    all.insert(ids.begin(), ids.end());
  }
  EXPECT_EQ(all.size(), sum);
  EXPECT_GT(sum, 1U);
}

TEST(ParallelFor, RethrowsAndLeavesTheRestUndone) {
  for (const int threads : {1, 4}) {
    std::atomic<int> visits{0};
    const auto run = [&] {
      parallel_for(1000000, threads, [&](int, std::size_t i) {
        ++visits;
        if (i == 100) throw std::runtime_error("index 100");
      });
    };
    try {
      run();
      ADD_FAILURE() << "nothing thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "index 100");
    }
    EXPECT_LT(visits, 1000000);
  }
}

TEST(ParallelFor, SurvivesExceptionsOfSeveralThreads) {
  for (int repeat = 0; repeat < 50; ++repeat) {
    EXPECT_THROW(
        parallel_for(100, 4, [](int, std::size_t) { throw std::invalid_argument("each"); }),
        std::invalid_argument);
  }
}

TEST(ThreadCount, IsWhatIsAskedForOrOnePerCore) {
  EXPECT_EQ(thread_count(3), 3);
  EXPECT_GE(thread_count(0), 1);
  EXPECT_EQ(thread_count(-1), thread_count(0));
}

}  // namespace
}  // namespace wristwise

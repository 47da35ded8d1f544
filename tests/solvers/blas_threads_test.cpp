#include "solvers/blas_threads.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

using namespace rfm;

TEST(BlasThreadsDeathTest, NoThreadButTheCallersIsLeft) {
  const std::filesystem::path tasks = "/proc/self/task";  // one entry per thread
  if (!std::filesystem::exists(tasks)) GTEST_SKIP() << "this system does not list threads there";
  // In a process of its own, which no other test has given threads.
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        use_one_thread_in_blas();
        use_one_thread_in_blas();  // a second call changes nothing
        const std::filesystem::directory_iterator threads(tasks);
        std::exit(static_cast<int>(std::distance(begin(threads), end(threads))));
      },
      testing::ExitedWithCode(1), "");
}

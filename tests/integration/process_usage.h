// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <malloc.h>
#include <unistd.h>

namespace dewpoint::tests {

/// Memory, files and threads that this process uses at present.
struct ProcessUsage {
  std::int64_t bytes = 0; ///< resident memory, after free memory was returned
  int handles = 0;        ///< number of open files
  int threads = 0;
};

inline ProcessUsage processUsage() {
  const auto entries = [](const char* folder) {
    const std::filesystem::directory_iterator first(folder);
    return static_cast<int>(std::distance(begin(first), end(first)));
  };
  ::malloc_trim(0);
  std::int64_t all = 0;
  std::int64_t resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  // The iteration itself has the folder open.
  return {resident * ::sysconf(_SC_PAGESIZE), entries("/proc/self/fd") - 1,
          entries("/proc/self/task")};
}

} // namespace dewpoint::tests

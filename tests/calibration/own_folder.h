// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace dewpoint::tests {

/// A folder for the running test alone: tests run side by side.
inline std::filesystem::path ownFolder() {
  const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path(testing::TempDir()) /
                      (std::string(info->test_suite_name()) + "_" + info->name());
  std::filesystem::create_directories(folder);
  return folder;
}

} // namespace dewpoint::tests

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text_file.h"
#include "core/project/project.h"
#include "core/project/project_load.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace dewpoint::tests {

/// A name of its own per test: tests run side by side.
inline std::filesystem::path fileNamed(const std::string& name) {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  return std::filesystem::path(testing::TempDir()) / (std::string(info->name()) + "_" + name);
}

/// The project of a file of this text, with the first `from` in it replaced.
inline Result<Project> load(std::string text, const std::string& from = "",
                            const std::string& to = "") {
  if (const auto at = from.empty() ? std::string::npos : text.find(from); at != std::string::npos) {
    text.replace(at, from.size(), to);
  }
  const auto file = fileNamed("project.toml");
  EXPECT_TRUE(writeTextFile(file, text));
  return loadProject(file);
}

} // namespace dewpoint::tests

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/dewpoint/dewpoint_parameters.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace dewpoint::tests {
namespace {

std::string pageOfTheMethod() {
  std::ifstream file(DEWPOINT_SOURCE_DIR "/docs/method-dewpoint.md");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// A number as a table shows it: "8", "0.05".
std::string shown(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

TEST(DewpointParameters, ThePageDescribesEachWithItsDefault) {
  const std::string page = pageOfTheMethod();
  ASSERT_FALSE(page.empty());
  for (const ParameterDeclaration& declaration : dewpointParameters()) {
    EXPECT_NE(page.find("`" + declaration.key + "`"), std::string::npos) << declaration.key;
    if (declaration.key.rfind("start_", 0) != 0) { // these share a row
      const std::string row =
          "| `" + declaration.key + "` | " + shown(declaration.defaultValue) + " |";
      EXPECT_NE(page.find(row), std::string::npos) << row;
    }
  }
}

TEST(DewpointParameters, FewestFitWithinMostByDefault) {
  const ParameterValues values(dewpointParameters());
  EXPECT_LE(values.at("fewest_particles"), values.at("particles"));
  EXPECT_EQ(values.at("time_budget"), 0.0); // runs repeat bit by bit unless one asks otherwise
  EXPECT_EQ(methodNames().front(), "dewpoint");
}

} // namespace
} // namespace dewpoint::tests

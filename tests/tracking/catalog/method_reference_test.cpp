// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/catalog/method_reference.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(MethodReference, SaysWhatIsDeclared) {
  ParameterDeclaration declaration;
  declaration.key = "sigma";
  declaration.unit = "m";
  declaration.defaultValue = 0.03;
  declaration.maximum = 10.0;
  declaration.description = "How far it moves.";
  EXPECT_EQ(parameterText(declaration), "0.03 m (0 to 10). How far it moves.");
  declaration.unit.clear();
  declaration.isDerivedFromCameras = true;
  EXPECT_EQ(parameterText(declaration),
            "0.03 (0 to 10), unless given as the cameras show. How far it moves.");
}

TEST(MethodReference, HasALineForEachParameter) {
  for (const Method& method : methods()) {
    const std::string text = methodReference(method);
    EXPECT_TRUE(text.starts_with(std::string(method.name) + ": ")) << text;
    EXPECT_EQ(text.find("Paper: ") == std::string::npos, method.text.paper.empty());
    for (const ParameterDeclaration& declaration : method.parameters()) {
      EXPECT_NE(text.find("\n  " + declaration.key + ": "), std::string::npos) << declaration.key;
    }
    EXPECT_TRUE(text.ends_with('\n'));
  }
}

} // namespace
} // namespace dewpoint::tests

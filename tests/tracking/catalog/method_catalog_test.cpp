// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/tracker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

namespace dewpoint::tests {
namespace {

TEST(MethodCatalog, EachMethodIsFoundByItsOwnName) {
  const std::filesystem::path pages = std::filesystem::path(DEWPOINT_SOURCE_DIR) / "docs";
  std::set<std::string_view> names;
  for (const Method& method : methods()) {
    EXPECT_TRUE(names.insert(method.name).second) << method.name << " twice";
    EXPECT_EQ(findMethod(method.name), &method);
    EXPECT_FALSE(method.text.title.empty() || method.text.summary.empty()) << method.name;
    EXPECT_EQ(methodSummary(method.name), method.text.summary);
    EXPECT_EQ(methodManualPage(method.name), method.text.manualPage);
    EXPECT_TRUE(std::filesystem::exists(pages / method.text.manualPage)) << method.name;
    EXPECT_FALSE(headingOf(method).empty()) << method.name;
    EXPECT_FALSE(methodParameters(method.name).empty()) << method.name;
    ASSERT_NE(method.family.describe, nullptr) << method.name;
    ASSERT_NE(method.make, nullptr) << method.name;
  }
  EXPECT_EQ(methodNames().size(), methods().size());
  EXPECT_EQ(findMethod("condensation"), nullptr);
  EXPECT_TRUE(methodParameters("condensation").empty());
  EXPECT_TRUE(methodSummary("condensation").empty());
}

// Project files without a method, and unknown ones, get the first.
TEST(MethodCatalog, TheDefaultComesFirst) {
  EXPECT_EQ(defaultMethod(), "dewpoint");
  EXPECT_EQ(methods().front().name, defaultMethod());
  EXPECT_EQ(methodManualPage("condensation"), methods().front().text.manualPage);
  EXPECT_EQ(methodFamily("condensation").targetSource, methods().front().family.targetSource);
}

TEST(MethodCatalog, PagesOfSeveralMethodsAreListedOnce) {
  const auto pages = methodManualPages();
  EXPECT_EQ(pages.front(), methods().front().text.manualPage);
  EXPECT_EQ(std::set(pages.begin(), pages.end()).size(), pages.size());
  EXPECT_LT(pages.size(), methods().size());
  for (const Method& method : methods()) {
    EXPECT_NE(std::ranges::find(pages, method.text.manualPage), pages.end()) << method.name;
  }
}

TEST(MethodCatalog, MethodsByUseStandUnderOneHeadingEach) {
  const auto all = methodsInDisplayOrder();
  EXPECT_EQ(all.size(), methods().size());
  EXPECT_EQ(all.front(), &methods().front());
  std::vector<std::string_view> headings;
  bool isOfPaper = false;
  for (const Method* method : all) {
    if (headings.empty() || headings.back() != headingOf(*method)) {
      headings.push_back(headingOf(*method));
    }
    EXPECT_TRUE(!isOfPaper || !method->text.paper.empty()) << method->name; // those come last
    isOfPaper = !method->text.paper.empty();
  }
  EXPECT_EQ(headings.size(), 4U);
  EXPECT_EQ(std::set(headings.begin(), headings.end()).size(), headings.size());
}

TEST(MethodCatalog, NamesByFamilyAreAllNamesOnce) {
  std::vector<std::string> all;
  for (const TargetSource from : {TargetSource::Color, TargetSource::Box, TargetSource::Images}) {
    const auto names = methodNames(from);
    EXPECT_FALSE(names.empty());
    all.insert(all.end(), names.begin(), names.end());
  }
  std::vector<std::string> expected = methodNames();
  std::ranges::sort(all);
  std::ranges::sort(expected);
  EXPECT_EQ(all, expected);
}

TEST(MethodCatalog, ATrackerIsMadeOfTheMethodsOwnParametersAlone) {
  const Target ball{"ball", 0.035, {310.0, 350.0, 0.3, 1.0, 0.2, 0.9}};
  const auto unknown =
      makeTracker("condensation", ParameterValues(methodParameters("dewpoint")), {}, {ball});
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::NotFound);
  const auto foreign =
      makeTracker("barrera", ParameterValues(methodParameters("histogram")), {}, {ball});
  ASSERT_FALSE(foreign);
  EXPECT_EQ(foreign.error().code, ErrorCode::MissingKey);
  EXPECT_TRUE(checkParameters("barrera", ParameterValues(methodParameters("barrera"))));
  EXPECT_FALSE(checkParameters("barrera", ParameterValues(methodParameters("histogram"))));
}

TEST(MethodCatalog, MethodsThatFollowBoxesNeedNoCalibration) {
  for (const Method& method : methods()) {
    EXPECT_EQ(method.family.needsCalibration, method.family.targetSource != TargetSource::Box)
        << method.name;
  }
}

} // namespace
} // namespace dewpoint::tests

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/parameters.h"
#include "core/tracking/tracker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dewpoint::tests {
namespace {

ParameterValues barreraValues() {
  return ParameterValues(methodParameters("barrera"));
}

TEST(Parameters, DefaultsAreThePapers) {
  const ParameterValues values = barreraValues();
  // Barrera et al. 2005, section 3: 200 particles, sigma 0.03 m, started at (0.4, 0.1, 0.2).
  EXPECT_EQ(values.at("particles"), 200);
  EXPECT_EQ(values.at("motion_sigma"), 0.03);
  EXPECT_EQ(values.at("start_x"), 0.4);
  EXPECT_EQ(values.at("start_y"), 0.1);
  EXPECT_EQ(values.at("start_z"), 0.2);
  EXPECT_EQ(values.at("iterations_per_frame"), 1);
  EXPECT_EQ(values.at("start_half_x"), 0);
}

TEST(Parameters, EveryDeclarationIsSound) {
  for (const auto& name : methodNames()) {
    ASSERT_FALSE(methodParameters(name).empty()) << name;
    EXPECT_FALSE(methodSummary(name).empty()) << name;
    for (const auto& declaration : methodParameters(name)) {
      EXPECT_LT(declaration.minimum, declaration.maximum) << declaration.key;
      EXPECT_GT(declaration.stepSize, 0.0) << declaration.key;
      EXPECT_FALSE(declaration.label.empty() || declaration.description.empty()) << declaration.key;
      EXPECT_TRUE(!declaration.hasLogarithmicSlider || declaration.minimum > 0.0)
          << declaration.key;
      ParameterValues values(methodParameters(name));
      EXPECT_TRUE(values.set(declaration.key, declaration.defaultValue));
      EXPECT_TRUE(values.set(declaration.key, declaration.minimum));
      EXPECT_TRUE(values.set(declaration.key, declaration.maximum));
    }
  }
  EXPECT_TRUE(methodParameters("nothing").empty());
}

TEST(Parameters, AFewOfEachMethodComeFirst) {
  for (const Method& method : methods()) {
    const auto declarations = method.parameters();
    const auto first =
        std::ranges::count(declarations, ParameterGroup::Essential, &ParameterDeclaration::group);
    EXPECT_GE(first, 1) << method.name;
    EXPECT_LE(first, 3) << method.name;
    for (const ParameterDeclaration& declaration : declarations) {
      EXPECT_FALSE(parameterGroupTitle(declaration.group).empty()) << declaration.key;
      EXPECT_TRUE(declaration.upperLimitKey.empty() ||
                  std::ranges::count(declarations, declaration.upperLimitKey,
                                     &ParameterDeclaration::key) == 1)
          << declaration.key;
    }
  }
}

TEST(Parameters, AValueAboveItsBoundIsNoticed) {
  const auto declarations = methodParameters("dewpoint");
  const auto fewest =
      std::ranges::find(declarations, "fewest_particles", &ParameterDeclaration::key);
  ASSERT_NE(fewest, declarations.end());
  ParameterValues values(declarations);
  EXPECT_FALSE(exceedsUpperLimit(values, *fewest));
  ASSERT_TRUE(values.set("particles", 100.0));
  EXPECT_FALSE(exceedsUpperLimit(values, *fewest)); // as many
  ASSERT_TRUE(values.set("particles", 50.0));
  EXPECT_TRUE(exceedsUpperLimit(values, *fewest));
  EXPECT_FALSE(exceedsUpperLimit(values, declarations.front())); // has no bound
}

TEST(Parameters, WhatWasGivenCanBeLeftToTheCamerasAgain) {
  ParameterValues values = barreraValues();
  ASSERT_TRUE(values.set("start_x", 3.0));
  ASSERT_TRUE(values.set("particles", 300.0));
  values.resetDerivableValues();
  EXPECT_FALSE(values.isGiven("start_x"));
  EXPECT_EQ(values.at("start_x"), barreraValues().at("start_x"));
  EXPECT_EQ(values.at("particles"), 300.0);
}

TEST(Parameters, EveryMethodBelongsToAFamily) {
  EXPECT_EQ(methodFamily("dewpoint").targetSource, TargetSource::Color);
  EXPECT_EQ(methodFamily("sugandi").targetSource, TargetSource::Box);
  EXPECT_EQ(methodFamily("mohedano-ms").targetSource, TargetSource::Images);
  for (const Method& method : methods()) {
    const MethodFamily family = methodFamily(method.name);
    EXPECT_EQ(family.targetSource, method.family.targetSource) << method.name;
    EXPECT_EQ(family.needsCalibration, family.targetSource != TargetSource::Box) << method.name;
    EXPECT_NE(family.describe, nullptr) << method.name;
    EXPECT_TRUE(family.findsTargets() || family.noTargetsText != nullptr) << method.name;
    EXPECT_EQ(family.lacksTargets({}), !family.findsTargets()) << method.name;
    EXPECT_EQ(findMethod(method.name), &method);
  }
  EXPECT_EQ(methodNames(RunTableKind::Boxes), methodNames(TargetSource::Box));
  EXPECT_EQ(methodNames(RunTableKind::People), methodNames(TargetSource::Images));
  EXPECT_EQ(findMethod("nothing"), nullptr);
  EXPECT_TRUE(methodSummary("nothing").empty());
}

TEST(Parameters, AFamilyAnswersWhatMustBeKnownBeforeARun) {
  const MethodFamily spheres = methodFamily("barrera");
  const MethodFamily boxes = methodFamily("histogram");
  const MethodFamily people = methodFamily("people");
  Target boxed;
  boxed.box = TargetBox{.camera = 0, .frame = 7, .box = {}};
  EXPECT_FALSE(spheres.lacksTargets({Target()}));
  EXPECT_TRUE(boxes.lacksTargets({Target()}));
  EXPECT_FALSE(boxes.lacksTargets({Target(), boxed}));
  EXPECT_EQ(spheres.firstFrameFor({boxed}, 20), 20);
  EXPECT_EQ(boxes.firstFrameFor({Target(), boxed}, 20), 7);
  EXPECT_EQ(boxes.firstFrameFor({Target(), boxed}, 5), 5);
  EXPECT_EQ(people.firstFrameFor({}, 20), 0);
  EXPECT_TRUE(spheres.tracksSameTargetsAs(methodFamily("dewpoint")));
  EXPECT_FALSE(spheres.tracksSameTargetsAs(people));
  EXPECT_TRUE(spheres.hasColorMasks() && spheres.hasBestParticle && spheres.writesPositions());
  EXPECT_TRUE(boxes.retracksAfterEdit && !boxes.writesPositions() && !boxes.hasBestParticle);
  EXPECT_TRUE(people.hasMotionMasks && people.writesBodies() && people.writesPositions());
}

TEST(Parameters, BadValuesAreRefusedWithTheirRangeAndChangeNothing) {
  ParameterValues values = barreraValues();
  for (const double bad :
       {9.0, 1000001.0, 20.5, std::nan(""), std::numeric_limits<double>::infinity()}) {
    const Status status = values.set("particles", bad);
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, ErrorCode::BadValue);
    EXPECT_EQ(status.error().field, "particles");
  }
  EXPECT_EQ(values, barreraValues());
  EXPECT_EQ(errorSentence(values.set("particles", 9).error()),
            "particles: not a usable value (9 is not a whole number from 10 to 1000000)");
  EXPECT_EQ(errorSentence(values.set("motion_sigma", 0.7).error()),
            "motion_sigma: not a usable value (0.7 is not a number from 0.001 to 0.5 m)");
}

TEST(Parameters, UnknownKeysAreNamedWithTheKnownOnes) {
  ParameterValues values = barreraValues();
  const Status status = values.set("partikel", 20);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::UnknownKey);
  EXPECT_EQ(status.error().field, "partikel");
  EXPECT_NE(status.error().detail.find("particles, motion_sigma"), std::string::npos);
  EXPECT_EQ(values.setFromText("partikel", "20").error().code, ErrorCode::UnknownKey);
}

TEST(Parameters, TextIsTakenWholeOrNotAtAll) {
  ParameterValues values = barreraValues();
  EXPECT_TRUE(values.setFromText("motion_sigma", "5e-2"));
  EXPECT_EQ(values.at("motion_sigma"), 0.05);
  for (const char* bad : {"", "x", "0.05m", " 0.05", "0,05", "nan", "inf"}) {
    EXPECT_FALSE(values.setFromText("motion_sigma", bad)) << bad;
  }
  EXPECT_EQ(values.at("motion_sigma"), 0.05);
  EXPECT_FALSE(values == barreraValues());
}

TEST(MakeTracker, UnknownMethodOrParametersOfAnotherAreRefused) {
  const auto unknown = makeTracker("kalman", barreraValues(), {}, {});
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::NotFound);
  EXPECT_NE(unknown.error().detail.find("barrera"), std::string::npos);
  EXPECT_FALSE(makeTracker("barrera", ParameterValues(), {}, {}));
}

} // namespace
} // namespace dewpoint::tests

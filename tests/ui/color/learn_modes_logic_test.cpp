// SPDX-License-Identifier: GPL-3.0-or-later
// The hints over the images name clicks that work on every desktop.
#include "ui/color/learn_modes.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(LearnModes, TheHintsNameAClickThatNoDesktopTakes) {
  using SampleAction = ColorLearner::SampleAction;
  LearnModes modes;
  modes.setRefinementEnabled(true, true);
  for (const auto mode : {SampleAction::Replace, SampleAction::Add}) {
    const QString hint = modes.hintOf(mode);
    EXPECT_TRUE(hint.contains(QStringLiteral("Ctrl+Shift: exclude"))) << hint.toStdString();
    EXPECT_FALSE(hint.contains(QStringLiteral("Alt"))) << hint.toStdString();
  }
}

TEST(LearnModes, TheHintsNameOnlyClicksThatWork) {
  using SampleAction = ColorLearner::SampleAction;
  LearnModes modes; // of a target that is added
  EXPECT_EQ(modes.hintOf(SampleAction::Replace),
            QStringLiteral("Click the new target · Esc: stop"));
  modes.setRefinementEnabled(true, false); // its color was given, not learned
  EXPECT_EQ(modes.hintOf(SampleAction::Replace),
            QStringLiteral("Click: learn · Shift: add · Esc: stop"));
  EXPECT_FALSE(modes.hintOf(SampleAction::Add).contains(QStringLiteral("exclude")));
  modes.setRefinementEnabled(true, true);
  EXPECT_TRUE(modes.hintOf(SampleAction::Add).contains(QStringLiteral("exclude")));
}

} // namespace
} // namespace dewpoint::tests

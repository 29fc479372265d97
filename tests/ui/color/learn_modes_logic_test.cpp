// SPDX-License-Identifier: GPL-3.0-or-later
// The hints over the images name clicks that work on every desktop.
#include "ui/color/learn_modes.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(LearnModes, TheHintsNameAClickThatNoDesktopTakes) {
  using SampleAction = ColorLearner::SampleAction;
  for (const auto mode : {SampleAction::Replace, SampleAction::Add}) {
    const QString hint = LearnModes::hintOf(mode);
    EXPECT_TRUE(hint.contains(QStringLiteral("Ctrl+Shift: exclude"))) << hint.toStdString();
    EXPECT_FALSE(hint.contains(QStringLiteral("Alt"))) << hint.toStdString();
  }
}

} // namespace
} // namespace dewpoint::tests

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/manual/nudge_keys.h"

#include <QKeyEvent>
#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

std::optional<KeyNudge> pressed(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier,
                                KeyMode mode = KeyMode::Move) {
  return nudgeForKey(QKeyEvent(QEvent::KeyPress, key, modifiers), mode);
}

void expectNudge(const std::optional<KeyNudge>& nudge, int axis, double factor) {
  ASSERT_TRUE(nudge);
  EXPECT_EQ(nudge->axis, axis);
  EXPECT_DOUBLE_EQ(nudge->stepsOrPercent, factor);
}

TEST(NudgeKeys, ArrowsAndLettersDoTheSame) {
  for (const auto& [arrow, letter] : {std::pair(Qt::Key_Left, Qt::Key_A),
                                      {Qt::Key_Right, Qt::Key_D},
                                      {Qt::Key_Up, Qt::Key_W},
                                      {Qt::Key_Down, Qt::Key_S},
                                      {Qt::Key_PageUp, Qt::Key_E},
                                      {Qt::Key_PageDown, Qt::Key_Q}}) {
    for (const KeyMode mode : {KeyMode::Move, KeyMode::Turn}) {
      const auto byArrow = pressed(arrow, Qt::NoModifier, mode);
      const auto byLetter = pressed(letter, Qt::NoModifier, mode);
      ASSERT_TRUE(byArrow && byLetter);
      EXPECT_EQ(byArrow->axis, byLetter->axis);
      EXPECT_EQ(byArrow->stepsOrPercent, byLetter->stepsOrPercent);
    }
  }
}

TEST(NudgeKeys, MovingGoesSidewaysForwardAndUp) {
  expectNudge(pressed(Qt::Key_Right), 0, 1.0);
  expectNudge(pressed(Qt::Key_Down), 1, -1.0);
  expectNudge(pressed(Qt::Key_PageUp), 2, 1.0);
}

TEST(NudgeKeys, TurningLeftIsCounterclockwiseFromAbove) {
  expectNudge(pressed(Qt::Key_Left, Qt::NoModifier, KeyMode::Turn), 2, 1.0);
  expectNudge(pressed(Qt::Key_Up, Qt::NoModifier, KeyMode::Turn), 0, 1.0);
  expectNudge(pressed(Qt::Key_PageDown, Qt::NoModifier, KeyMode::Turn), 1, -1.0);
}

TEST(NudgeKeys, ShiftIsTenTimesAndControlATenth) {
  expectNudge(pressed(Qt::Key_Left, Qt::ShiftModifier), 0, -10.0);
  expectNudge(pressed(Qt::Key_Left, Qt::ControlModifier), 0, -0.1);
  expectNudge(pressed(Qt::Key_Plus), -1, 1.0);
  expectNudge(pressed(Qt::Key_Plus, Qt::ShiftModifier), -1, 1.0); // plus needs Shift
  expectNudge(pressed(Qt::Key_Minus, Qt::ControlModifier), -1, -0.1);
}

TEST(NudgeKeys, TheWindowKeepsItsShortcuts) {
  EXPECT_FALSE(pressed(Qt::Key_S, Qt::ControlModifier)); // saves
  EXPECT_FALSE(pressed(Qt::Key_Left, Qt::AltModifier));
  EXPECT_FALSE(pressed(Qt::Key_F));
}

} // namespace
} // namespace dewpoint::tests

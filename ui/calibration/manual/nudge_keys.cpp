// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/manual/nudge_keys.h"

#include <QKeyEvent>

namespace dewpoint::ui {
namespace {

enum class Way { Left, Right, Up, Down, Higher, Lower, Longer, Shorter };

std::optional<Way> wayOf(int key, bool letters) {
  switch (key) {
  case Qt::Key_Left:
    return Way::Left;
  case Qt::Key_Right:
    return Way::Right;
  case Qt::Key_Up:
    return Way::Up;
  case Qt::Key_Down:
    return Way::Down;
  case Qt::Key_PageUp:
    return Way::Higher;
  case Qt::Key_PageDown:
    return Way::Lower;
  case Qt::Key_Plus:
  case Qt::Key_Equal:
    return Way::Longer;
  case Qt::Key_Minus:
  case Qt::Key_Underscore:
    return Way::Shorter;
  default:
    break;
  }
  if (!letters) {
    return std::nullopt;
  }
  switch (key) {
  case Qt::Key_A:
    return Way::Left;
  case Qt::Key_D:
    return Way::Right;
  case Qt::Key_W:
    return Way::Up;
  case Qt::Key_S:
    return Way::Down;
  case Qt::Key_E:
    return Way::Higher;
  case Qt::Key_Q:
    return Way::Lower;
  default:
    return std::nullopt;
  }
}

KeyNudge stepOf(Way way, KeyMode mode) {
  const bool moves = mode == KeyMode::Move;
  switch (way) {
  case Way::Left: // turning left is counterclockwise from above
    return moves ? KeyNudge{0, -1.0} : KeyNudge{2, 1.0};
  case Way::Right:
    return moves ? KeyNudge{0, 1.0} : KeyNudge{2, -1.0};
  case Way::Up:
    return moves ? KeyNudge{1, 1.0} : KeyNudge{0, 1.0};
  case Way::Down:
    return moves ? KeyNudge{1, -1.0} : KeyNudge{0, -1.0};
  case Way::Higher:
    return moves ? KeyNudge{2, 1.0} : KeyNudge{1, 1.0};
  case Way::Lower:
    return moves ? KeyNudge{2, -1.0} : KeyNudge{1, -1.0};
  case Way::Longer:
    return {-1, 1.0};
  case Way::Shorter:
    return {-1, -1.0};
  }
  return {};
}

} // namespace

std::optional<KeyNudge> nudgeForKey(const QKeyEvent& event, KeyMode mode) {
  const Qt::KeyboardModifiers modifiers = event.modifiers();
  if (modifiers & (Qt::AltModifier | Qt::MetaModifier)) {
    return std::nullopt;
  }
  const bool fine = modifiers.testFlag(Qt::ControlModifier);
  const auto way = wayOf(event.key(), !fine);
  if (!way) {
    return std::nullopt;
  }
  KeyNudge nudge = stepOf(*way, mode);
  // Plus needs Shift on many keyboards.
  const bool zooms = nudge.axis < 0;
  const bool coarse = modifiers.testFlag(Qt::ShiftModifier) && !zooms;
  nudge.stepsOrPercent *= fine ? 0.1 : coarse ? 10.0 : 1.0;
  return nudge;
}

} // namespace dewpoint::ui

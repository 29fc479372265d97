// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QPushButton>

namespace dewpoint::color {
struct ColorAssessment;
} // namespace dewpoint::color

namespace dewpoint::ui {

class Document;

/// Button that creates targets for all other objects with the color and size of a target, so that
/// all of several equal balls are tracked. Hidden if there are none, or if each already has a
/// target.
class FollowAllButton : public QPushButton {
  Q_OBJECT
public:
  explicit FollowAllButton(Document& document, QWidget* parent = nullptr);

  /// Offers the objects that an assessment of the color of a target found; null: none.
  void offer(const ColorAssessment* assessment, int target);

  /// Whether there are objects to add.
  bool offers() const { return missing_ > 0; }

private:
  void follow();

  Document& document_;
  int target_ = -1;
  int missing_ = 0; ///< number of targets to add
};

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QPushButton>

namespace dewpoint::color {
struct ColorAssessment;
} // namespace dewpoint::color

namespace dewpoint::ui {

class Document;

/// Button that creates a target for each other object with the same color and size as a given
/// target, so that several identical balls are all tracked. Hidden if there are no such objects, or
/// if each already has a target.
class FollowAllButton : public QPushButton {
  Q_OBJECT
public:
  explicit FollowAllButton(Document& document, QWidget* parent = nullptr);

  /// Offers to track the objects that a color assessment of a target found. If `assessment` is
  /// null, offers nothing.
  void offer(const ColorAssessment* assessment, int target);

  /// Returns whether there are objects to add.
  bool isOffering() const { return missing_ > 0; }

private:
  void follow();

  Document& document_;
  int target_ = -1;
  int missing_ = 0; ///< number of targets to add
};

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QPushButton>

namespace dewpoint::color {
struct ColorAssessment;
} // namespace dewpoint::color

namespace dewpoint::ui {

class Document;

/// Makes targets of the other things that have the color and size of one: of several balls alike
/// all can be followed. Hidden while there is none, or while each has its target.
class FollowAllButton : public QPushButton {
  Q_OBJECT
public:
  explicit FollowAllButton(Document& document, QWidget* parent = nullptr);

  /// Offers what this assessment of the color of a target found; null: nothing.
  void offer(const ColorAssessment* assessment, int target);

  /// Whether there is something to add.
  bool offers() const { return missing_ > 0; }

private:
  void follow();

  Document& document_;
  int target_ = -1;
  int missing_ = 0; ///< targets that are to be added
};

} // namespace dewpoint::ui

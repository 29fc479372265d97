// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/new_project/new_project.h"

#include <QWidget>

#include <string>
#include <vector>

class QComboBox;
class QFormLayout;
class QLabel;

namespace dewpoint::ui {

/// Asks how to adapt a calibration file that does not fit the cameras of a new project: which
/// camera of the file belongs to which camera of the project, and how the images were changed if
/// they have another size. Each question is hidden until it is needed.
class CalibrationFit : public QWidget {
  Q_OBJECT
public:
  explicit CalibrationFit(QWidget* parent = nullptr);

  /// Forgets the answers and hides the questions, because another file was chosen.
  void reset();
  /// Asks for the camera in the file of each camera in `cameras`, if the names in the file
  /// (`inFile`) match neither by name nor by order. Answers are kept while both lists stay the
  /// same.
  void setNames(const std::vector<std::string>& cameras, const std::vector<std::string>& inFile);
  /// Returns whether the question about the names is shown.
  bool asksForNames() const { return !choices_.empty(); }
  /// Asks how the images were changed.
  void askFit();
  /// Returns the answers.
  CalibrationAdaptation adaptation() const;
  /// Returns whether every camera has a camera in the file, by the answers or by its own name.
  bool areNamesMatched() const;

Q_SIGNALS:
  void changed();

private:
  void retranslateUi();
  void fillNames();

  QWidget* fitRow_;
  QLabel* fitLabel_;
  QComboBox* fit_;
  QWidget* namesRow_;
  QLabel* namesLabel_;
  QFormLayout* names_;
  std::vector<QComboBox*> choices_; ///< one for each camera, or none
  std::vector<std::string> cameras_;
  std::vector<std::string> inFile_;
};

} // namespace dewpoint::ui

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

  /// Forgets the answers and hides the questions. Call this when another file is chosen.
  void reset();
  /// Asks which camera of the file belongs to each of the project's `cameras`, if the cameras in
  /// the file, `inFile`, match neither by name nor by order. Answers are kept while both lists stay
  /// the same.
  void setCameraNames(const std::vector<std::string>& cameras,
                      const std::vector<std::string>& inFile);
  /// Returns whether the question about the names is shown.
  bool isNameQuestionShown() const { return !choices_.empty(); }
  /// Shows the question how the images were changed since the calibration, for example scaled or
  /// cropped.
  void showImageChangeQuestion();
  /// Returns the user's answers.
  CalibrationAdaptation adaptation() const;
  /// Returns whether every camera of the project has a camera in the file, by the answers or by its
  /// name.
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

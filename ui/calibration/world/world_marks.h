// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/world_step.h"

#include <QObject>
#include <QString>

#include <array>
#include <optional>

namespace dewpoint::ui {

class Document;

/// Three points of the room, A, B and C, that the user marks in the images to set the floor, the
/// origin, the axes and the scale of calibrated cameras. Each change of the world frame is an
/// undoable step of the document. The marks are not part of the project: they stay in the images
/// when the world changes, and are removed when another project is opened.
class WorldMarks : public QObject {
  Q_OBJECT
public:
  static constexpr int kMarkCount = 3;

  explicit WorldMarks(Document& document, QObject* parent = nullptr);

  /// Returns the clicks with which the user placed a mark in camera images.
  const std::vector<PointClick>& clicks(int mark) const;
  /// Returns the letter of a mark: "A", "B" or "C".
  static QString letterOf(int mark);
  /// Returns the position of a mark (world frame, meters) computed from its clicks, or the reason
  /// why it is unknown.
  Result<Gaussian3> positionOf(int mark) const;
  /// Returns the distance between the marks A and B in meters, or nothing while the position of A
  /// or B is unknown.
  std::optional<double> distanceAB() const;

  int selectedMark() const { return chosen_; }
  void selectMark(int mark);
  /// Returns whether the next click in an image places the selected mark.
  bool clicksPlacePoint() const { return clicking_; }
  void setClicksPlacePoint(bool clicking);
  /// Places the selected mark at a pixel of a camera image.
  void setClick(int camera, const Eigen::Vector2d& pixel);
  /// Removes all clicks on all marks.
  void clearClicks();

  /// Returns the indices of the marks from which `step`, a change of the world frame, is computed.
  static std::vector<int> marksUsedBy(WorldStep step);
  /// Returns whether the positions of all marks that `step`, a change of the world frame, uses are
  /// known.
  bool canApply(WorldStep step) const;
  /// Changes the world frame of the project by a step that uses the marks. `meters` is the true
  /// distance between A and B, used only by the step Length.
  void apply(WorldStep step, double meters = 0.0);
  /// Compares the computed distance between the marks A and B with the one that the user measured
  /// (`meters`), and stores both in the project.
  void storeLengthCheck(double meters);
  /// Change the poses of all cameras together. rotateWorld() rotates the cameras by 90 degrees
  /// about a world axis. moveWorld() shifts them by `shift` (meters) and rotates them by `turn`
  /// (radians) about the z axis.
  void rotateWorld(WorldAxis axis);
  void moveWorld(const Eigen::Vector3d& shift, double turn);
  /// Returns whether the images are not upright, and quarter turns of the world frame would make
  /// them upright.
  bool canRotateUpright() const;

  /// Returns a sentence about the last change or the reason why it was impossible, or an empty
  /// string.
  const QString& resultText() const { return resultText_; }

Q_SIGNALS:
  void changed();

private:
  QString resultOf(WorldStep step, const WorldStepResult& result) const;
  void replaceProject(const QString& step, const Project& project);

  Document& document_;
  std::array<MeasuredPoint, kMarkCount> marks_;
  int chosen_ = 0;
  bool clicking_ = false;
  bool applying_ = false; ///< the next change of the document is a step of this page
  QString resultText_;
};

} // namespace dewpoint::ui

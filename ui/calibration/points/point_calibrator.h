// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/manual/measured_points.h"
#include "ui/jobs/background_job.h"

#include <QObject>
#include <QString>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::project {
struct Project;
} // namespace dewpoint::project

namespace dewpoint::ui {

class Document;
class ManualCalibration;

/// Manages the measured points in the project: selects and edits them, records where they are
/// clicked, and solves for the cameras. Every change is an undoable step of the document. Solving
/// runs in another thread.
class PointCalibrator : public QObject {
  Q_OBJECT
public:
  PointCalibrator(Document& document, ManualCalibration& manual, QObject* parent = nullptr);
  ~PointCalibrator() override;

  const std::vector<MeasuredPoint>& points() const;
  /// Returns the index of the selected point, or -1 if none is selected.
  int selectedPoint() const { return chosen_; }
  void selectPoint(int point);
  void addPoint();
  void removePoint();
  /// Rename a point, and set its world position (meters). Both functions return false and change
  /// nothing if the name is empty or already used, or a coordinate is not a number.
  bool renamePoint(int point, const QString& name);
  bool setWorldPosition(int point, const Eigen::Vector3d& world);

  /// Returns whether the next click in an image marks the position of the selected point.
  bool clicksPlacePoint() const { return clicking_; }
  void setClicksPlacePoint(bool clicking);
  /// Sets the pixel at which a camera sees the selected point. `frame` is the number of the
  /// recorded frame in whose image the user clicked; empty for live images.
  void setClick(int camera, const Eigen::Vector2d& pixel, std::optional<std::int64_t> frame);
  /// Removes the pixel at which a camera sees the selected point.
  void removeClick(int camera);

  /// Returns, for each click on a point, its distance from the projection of the point by the
  /// current cameras.
  std::vector<ClickResidual> residuals() const;

  bool isSolving() const { return job_.isRunning(); }
  void solve(bool estimatesFocal);
  /// Returns the report of the last solution, one sentence per line, or an empty string before the
  /// first solution.
  const QString& resultText() const { return resultText_; }
  /// Returns the index of the point that does not fit the others in the last solution; nothing if
  /// all fit, or if that solution is no longer valid.
  std::optional<int> misfitPoint() const { return misfit_; }
  /// Returns the camera whose images are rotated or mirrored according to the last solution;
  /// nothing if there is none, or if the project cannot correct this.
  std::optional<int> proposedCamera() const;
  /// Returns the text of the button that corrects the images of proposedCamera().
  QString proposalText() const;
  void acceptProposal();

Q_SIGNALS:
  void changed();
  void solvingEnded();

private:
  bool edit(const QString& step, const std::function<void(Project&)>& change,
            const std::string& mergeKey = {});
  void applyResult(const PointSolution& solution, bool estimatedFocal);
  QString cameraResultText(const CameraFromPoints& camera) const;
  QString worstPointText(const PointSolution& solution) const;
  void discardSolution();

  Document& document_;
  ManualCalibration& manual_;
  int chosen_ = -1;
  bool clicking_ = false;
  bool applying_ = false; ///< the next change of the document is the solution itself
  QString resultText_;
  std::optional<int> misfit_;
  struct Proposal {
    int camera;
    ImageSymmetry symmetry;
  };
  std::optional<Proposal> proposal_;
  BackgroundJob job_;
};

/// Returns a text about the rotated or mirrored images of a camera, for example "camera 2 is
/// rotated: turn its images clockwise by 90 degrees".
QString symmetryText(const QString& camera, const ImageSymmetry& symmetry);

} // namespace dewpoint::ui

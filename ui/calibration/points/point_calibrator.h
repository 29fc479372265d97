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

/// The measured points of the project: what is chosen, clicked and solved. Every change is a step
/// of the document; solving runs beside the window.
class PointCalibrator : public QObject {
  Q_OBJECT
public:
  PointCalibrator(Document& document, ManualCalibration& hand, QObject* parent = nullptr);
  ~PointCalibrator() override;

  const std::vector<MeasuredPoint>& points() const;
  /// The chosen point, or -1.
  int chosen() const { return chosen_; }
  void choose(int point);
  void add();
  void remove();
  /// False when refused (an empty or used name, a number that is none).
  bool rename(int point, const QString& name);
  bool setWorld(int point, const Eigen::Vector3d& world);

  /// Whether the next click into an image says where the chosen point is.
  bool isClicking() const { return clicking_; }
  void setClicking(bool clicking);
  void setClick(int camera, const Eigen::Vector2d& pixel);
  /// Forgets where the chosen point was clicked in a camera.
  void removeClick(int camera);

  /// Of every click, with the cameras as they are.
  std::vector<ClickResidual> residuals() const;

  bool isSolving() const { return job_.isRunning(); }
  void solve(bool alsoFocal);
  /// What the last solution reports, a sentence per line; empty before there was one.
  const QString& resultText() const { return resultText_; }
  /// The point that the last solution called worst, while it holds.
  std::optional<int> worst() const { return worst_; }
  /// A camera whose pictures lie otherwise, if the last solution found one and it can be set.
  std::optional<int> proposedCamera() const;
  QString proposalText() const;
  void acceptProposal();

Q_SIGNALS:
  void changed();
  void solved();

private:
  bool edit(const QString& step, const std::function<void(Project&)>& change,
            const std::string& mergeKey = {});
  void applyResult(const PointSolution& solution);
  QString cameraSentence(const CameraFromPoints& camera) const;
  QString worstPointSentence(const PointSolution& solution) const;
  void forgetSolution();

  Document& document_;
  ManualCalibration& hand_;
  int chosen_ = -1;
  bool clicking_ = false;
  bool applying_ = false; ///< the change that comes is the solution itself
  QString resultText_;
  std::optional<int> worst_;
  struct Proposal {
    int camera;
    ImageSymmetry symmetry;
  };
  std::optional<Proposal> proposal_;
  BackgroundJob job_;
};

/// "camera 2 is rotated: turn its images clockwise by 90 degrees", "camera 2 is mirrored", or both.
QString symmetryText(const QString& camera, const ImageSymmetry& symmetry);

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/points/point_calibrator.h"

#include "core/base/angle.h"
#include "core/session/run/tracking_run.h"
#include "core/setup/calibration/calibrated_project.h"
#include "ui/calibration/manual_calibration.h"
#include "ui/document/document.h"
#include "ui/text/quantity_text.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {

QString symmetryText(const QString& camera, const ImageSymmetry& symmetry) {
  if (symmetry.isMirrored && symmetry.rotateDegrees != 0) {
    return PointCalibrator::tr("The images of %1 are rotated and mirrored: turn them clockwise by "
                               "%2 degrees, then mirror them")
        .arg(camera)
        .arg(symmetry.rotateDegrees);
  }
  return symmetry.isMirrored
             ? PointCalibrator::tr("The images of %1 are mirrored").arg(camera)
             : PointCalibrator::tr(
                   "The images of %1 are rotated: turn them clockwise by %2 degrees")
                   .arg(camera)
                   .arg(symmetry.rotateDegrees);
}

PointCalibrator::PointCalibrator(Document& document, ManualCalibration& manual, QObject* parent)
    : QObject(parent), document_(document), manual_(manual) {
  connect(&document_, &Document::changed, this, [this](const ProjectChanges& changes) {
    if (changes.pointsChanged || changes.calibrationChanged || changes.sourcesChanged) {
      if (!applying_ && (changes.pointsChanged || changes.sourcesChanged)) {
        discardSolution();
      }
      chosen_ = std::min(chosen_, static_cast<int>(points().size()) - 1);
      Q_EMIT this->changed();
    }
  });
  connect(&document_, &Document::projectReplaced, this, [this] {
    chosen_ = points().empty() ? -1 : 0;
    discardSolution();
    setClicksPlacePoint(false);
    Q_EMIT changed();
  });
}

PointCalibrator::~PointCalibrator() = default;

const std::vector<MeasuredPoint>& PointCalibrator::points() const {
  return document_.project().measuredPoints;
}

bool PointCalibrator::edit(const QString& step, const std::function<void(Project&)>& change,
                           const std::string& mergeKey) {
  return document_.edit(step, change, mergeKey).has_value();
}

void PointCalibrator::discardSolution() {
  resultText_.clear();
  misfit_.reset();
  proposal_.reset();
}

void PointCalibrator::selectPoint(int point) {
  if (point != chosen_) {
    chosen_ = point;
    Q_EMIT changed();
  }
}

void PointCalibrator::addPoint() {
  const auto isUsed = [this](const std::string& name) {
    return std::ranges::any_of(points(),
                               [&](const MeasuredPoint& point) { return point.name == name; });
  };
  std::size_t next = points().size() + 1;
  QString name = tr("point %1").arg(next);
  while (isUsed(name.toStdString())) {
    name = tr("point %1").arg(++next);
  }
  const ReferenceGrid grid = manual_.grid();
  edit(tr("Add measured point"), [&](Project& project) {
    MeasuredPoint& point = project.measuredPoints.emplace_back();
    point.name = name.toStdString();
    point.world = grid.origin;
  });
  selectPoint(static_cast<int>(points().size()) - 1);
}

void PointCalibrator::removePoint() {
  if (chosen_ >= 0 && chosen_ < static_cast<int>(points().size())) {
    edit(tr("Remove measured point"), [this](Project& project) {
      project.measuredPoints.erase(project.measuredPoints.begin() + chosen_);
    });
  }
}

bool PointCalibrator::renamePoint(int point, const QString& name) {
  return edit(tr("Rename measured point"), [&](Project& project) {
    project.measuredPoints[static_cast<std::size_t>(point)].name = name.trimmed().toStdString();
  });
}

bool PointCalibrator::setWorldPosition(int point, const Eigen::Vector3d& world) {
  return edit(tr("Position of %1")
                  .arg(QString::fromStdString(points()[static_cast<std::size_t>(point)].name)),
              [&](Project& project) {
                project.measuredPoints[static_cast<std::size_t>(point)].world = world;
              });
}

void PointCalibrator::setClicksPlacePoint(bool clicking) {
  clicking = clicking && chosen_ >= 0;
  if (clicking != clicking_) {
    clicking_ = clicking;
    Q_EMIT changed();
  }
}

void PointCalibrator::setClick(int camera, const Eigen::Vector2d& pixel,
                               std::optional<std::int64_t> frame) {
  if (chosen_ < 0) {
    return;
  }
  const auto point = static_cast<std::size_t>(chosen_);
  edit(tr("Click %1 in %2")
           .arg(QString::fromStdString(points()[point].name), manual_.nameOf(camera)),
       [&](Project& project) { setClickIn(project.measuredPoints[point], camera, pixel, frame); });
}

void PointCalibrator::removeClick(int camera) {
  if (chosen_ < 0) {
    return;
  }
  const auto point = static_cast<std::size_t>(chosen_);
  edit(tr("Remove %1 in %2")
           .arg(QString::fromStdString(points()[point].name), manual_.nameOf(camera)),
       [&](Project& project) {
         std::erase_if(project.measuredPoints[point].clicks,
                       [&](const PointClick& click) { return click.camera == camera; });
       });
}

std::vector<ClickResidual> PointCalibrator::residuals() const {
  return clickResiduals(rigOf(document_.project()), points());
}

void PointCalibrator::solve(bool estimatesFocal) {
  PointSettings settings;
  settings.estimatesFocal = estimatesFocal;
  const bool begun = job_.start([this, rig = rigOf(document_.project()), all = points(),
                                 settings](const BackgroundJob::Progress&) {
    auto solution = std::make_shared<const PointSolution>(solveFromPoints(rig, all, settings));
    return [this, solution, all, settings] {
      if (all == points() && solution->rig.size() == document_.project().cameras.size()) {
        applyResult(*solution, settings.estimatesFocal);
      }
      Q_EMIT changed();
      Q_EMIT solvingEnded();
    };
  });
  if (begun) {
    Q_EMIT changed();
  }
}

void PointCalibrator::applyResult(const PointSolution& solution, bool estimatedFocal) {
  discardSolution();
  applying_ = true;
  if (solution.hasSolvedCamera()) {
    edit(tr("Compute cameras from measured points"), [&](Project& project) {
      project = withPointSolution(std::move(project), solution, estimatedFocal);
    });
  }
  applying_ = false;
  QStringList lines;
  for (const CameraFromPoints& camera : solution.cameras) {
    lines << cameraResultText(camera);
    if (estimatedFocal && camera.status == PoseStatus::None &&
        camera.clickCount < kFewestPointsOfFocal) {
      lines << tr("%1: the focal length was kept, because computing it needs at least %2 points")
                   .arg(manual_.nameOf(camera.camera))
                   .arg(kFewestPointsOfFocal);
    }
    if (camera.proposal && !proposal_) {
      proposal_ = Proposal{camera.camera, camera.proposal->symmetry};
    }
  }
  if (solution.cameras.empty()) {
    lines << tr(
        "No point has been clicked yet. Press “Click in images”, then click the selected point in "
        "the images");
  }
  misfit_ = solution.isWorstPointWrong ? solution.worstPoint : std::nullopt;
  if (solution.worstPoint && solution.hasSolvedCamera()) {
    lines << worstPointText(solution);
  }
  resultText_ = lines.join(QLatin1Char('\n'));
}

QString PointCalibrator::cameraResultText(const CameraFromPoints& camera) const {
  const QString name = manual_.nameOf(camera.camera);
  QString line;
  switch (camera.status) {
  case PoseStatus::None:
    line = tr("%1: average error %2").arg(name, pixelText(camera.rmsPx, 2));
    break;
  case PoseStatus::TooFew:
    line = tr("%1: %n point(s) clicked, but at least %2 are needed (six are better)", nullptr,
              camera.clickCount)
               .arg(name)
               .arg(kFewestPointsOfPose);
    break;
  case PoseStatus::Collinear:
    line = tr("%1: all points lie on one line. Add a point away from this line").arg(name);
    break;
  case PoseStatus::Ambiguous:
    line = tr("%1: average error %2, but a second pose fits equally well. Add a point outside the "
              "plane of the others")
               .arg(name, pixelText(camera.rmsPx, 2));
    break;
  case PoseStatus::NoPose:
    line = tr("%1: no pose fits the clicked points").arg(name);
    break;
  }
  if (camera.proposal) {
    const QString what = symmetryText(name, camera.proposal->symmetry);
    line += QLatin1Char('\n') +
            (camera.proposal->isBasedOnUprightness
                 ? tr("%1 (ignore this if the camera is mounted that way)").arg(what)
                 : tr("%1. After this correction, the average error is %2")
                       .arg(what, pixelText(camera.proposal->rmsPx, 2)));
  }
  return line;
}

QString PointCalibrator::worstPointText(const PointSolution& solution) const {
  const auto worst = static_cast<std::size_t>(*solution.worstPoint);
  double pixels = 0.0;
  double meters = 0.0;
  for (const ClickResidual& residual : solution.residuals) {
    if (residual.pointIndex == *solution.worstPoint && std::isfinite(residual.imageDistancePx)) {
      pixels = std::max(pixels, residual.imageDistancePx);
      meters = std::max(meters, residual.rayDistance);
    }
  }
  const QString name = QString::fromStdString(points()[worst].name);
  const QString distance = lengthText(meters, LengthScale::Millimeters, 1);
  return solution.isWorstPointWrong
             ? tr("%1 does not fit the other points (%2, %3): measure or click it again")
                   .arg(name, pixelText(pixels), distance)
             : tr("Largest error: %1 (%2, %3)").arg(name, pixelText(pixels, 2), distance);
}

std::optional<int> PointCalibrator::proposedCamera() const {
  const auto& cameras = document_.project().cameras;
  if (!proposal_ || proposal_->camera >= static_cast<int>(cameras.size())) {
    return std::nullopt;
  }
  return canSetImageSymmetry(cameras[static_cast<std::size_t>(proposal_->camera)])
             ? std::optional(proposal_->camera)
             : std::nullopt;
}

QString PointCalibrator::proposalText() const {
  if (!proposal_) {
    return {};
  }
  const QString name = manual_.nameOf(proposal_->camera);
  const ImageSymmetry& symmetry = proposal_->symmetry;
  if (symmetry.rotateDegrees == 0) {
    return tr("Mirror the images of %1").arg(name);
  }
  const QString angle = angleText(symmetry.rotateDegrees * base::kDegree, 0);
  return symmetry.isMirrored
             ? tr("Rotate the images of %1 clockwise by %2, and mirror them").arg(name, angle)
             : tr("Rotate the images of %1 clockwise by %2").arg(name, angle);
}

void PointCalibrator::acceptProposal() {
  if (!proposedCamera()) {
    return;
  }
  const Proposal proposal = *proposal_;
  edit(tr("Set orientation of %1").arg(manual_.nameOf(proposal.camera)), [&](Project& project) {
    project = withImageSymmetry(std::move(project), proposal.camera, proposal.symmetry);
  });
  solve(false);
}

} // namespace dewpoint::ui

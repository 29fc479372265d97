// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/world/world_marks.h"

#include "core/session/run/tracking_run.h"
#include "core/setup/calibration/moved_world.h"
#include "ui/document/document.h"
#include "ui/text/error_sentence.h"
#include "ui/text/quantity_text.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {

WorldMarks::WorldMarks(Document& document, QObject* parent) : QObject(parent), document_(document) {
  for (int mark = 0; mark < kMarkCount; ++mark) {
    marks_[static_cast<std::size_t>(mark)].name = letterOf(mark).toStdString();
  }
  connect(&document_, &Document::changed, this, [this](const ProjectChanges& changes) {
    if (changes.calibrationChanged || changes.sourcesChanged) {
      if (!applying_) {
        resultText_.clear();
      }
      Q_EMIT this->changed();
    }
  });
  connect(&document_, &Document::projectReplaced, this, [this] {
    resultText_.clear();
    clearClicks();
  });
}

const std::vector<PointClick>& WorldMarks::clicks(int mark) const {
  return marks_.at(static_cast<std::size_t>(mark)).clicks;
}

QString WorldMarks::letterOf(int mark) {
  return QString(QLatin1Char(static_cast<char>('A' + mark)));
}

Result<Gaussian3> WorldMarks::positionOf(int mark) const {
  return triangulatePoint(rigOf(document_.project()), marks_.at(static_cast<std::size_t>(mark)));
}

std::optional<double> WorldMarks::distanceAB() const {
  const auto a = positionOf(0);
  const auto b = positionOf(1);
  return a && b ? std::optional((b->mean - a->mean).norm()) : std::nullopt;
}

void WorldMarks::selectMark(int mark) {
  mark = std::clamp(mark, 0, kMarkCount - 1);
  if (mark != chosen_) {
    chosen_ = mark;
    Q_EMIT changed();
  }
}

void WorldMarks::setClicksPlacePoint(bool clicking) {
  if (clicking != clicking_) {
    clicking_ = clicking;
    Q_EMIT changed();
  }
}

void WorldMarks::setClick(int camera, const Eigen::Vector2d& pixel) {
  setClickIn(marks_[static_cast<std::size_t>(chosen_)], camera, pixel);
  resultText_.clear();
  Q_EMIT changed();
}

void WorldMarks::clearClicks() {
  for (MeasuredPoint& mark : marks_) {
    mark.clicks.clear();
  }
  chosen_ = 0;
  Q_EMIT changed();
}

std::vector<int> WorldMarks::marksUsedBy(WorldStep step) {
  switch (step) {
  case WorldStep::Upright:
    return {};
  case WorldStep::Origin:
    return {0};
  case WorldStep::Floor:
    return {0, 1, 2};
  case WorldStep::Level:
  case WorldStep::XAxis:
  case WorldStep::Length:
    break;
  }
  return {0, 1};
}

bool WorldMarks::canApply(WorldStep step) const {
  return std::ranges::all_of(marksUsedBy(step),
                             [this](int mark) { return positionOf(mark).has_value(); });
}

namespace {

QString stepName(WorldStep step) {
  switch (step) {
  case WorldStep::Upright:
    return WorldMarks::tr("Turn the world upright");
  case WorldStep::Floor:
    return WorldMarks::tr("Set the floor");
  case WorldStep::Level:
    return WorldMarks::tr("Make a line level");
  case WorldStep::Origin:
    return WorldMarks::tr("Set the origin");
  case WorldStep::XAxis:
    return WorldMarks::tr("Set the x axis");
  case WorldStep::Length:
    break;
  }
  return WorldMarks::tr("Set a distance");
}

/// The reason why a step is impossible.
QString refusal(const Error& error) {
  if (error.field == "floor") {
    return WorldMarks::tr(
        "A, B and C lie on one line. Mark points that are spread over the floor.");
  }
  if (error.field == "level") {
    return WorldMarks::tr("The line from A to B is far from horizontal.");
  }
  if (error.field == "axis") {
    return WorldMarks::tr(
        "A is directly above or below B, so the x axis cannot point from A to B.");
  }
  return errorText(error);
}

} // namespace

QString WorldMarks::resultOf(WorldStep step, const WorldStepResult& result) const {
  switch (step) {
  case WorldStep::Floor:
    return tr("The floor is set: A is the origin, and the x axis points to B. The world was "
              "rotated by %1.")
        .arg(angleText(result.rotationAngle, 1));
  case WorldStep::Length:
    return tr("All lengths were multiplied by %1.").arg(numberText(result.scale, 4));
  case WorldStep::Origin:
    return tr("A is now the origin.");
  case WorldStep::Upright:
  case WorldStep::Level:
  case WorldStep::XAxis:
    break;
  }
  return tr("The world was rotated by %1.").arg(angleText(result.rotationAngle, 1));
}

void WorldMarks::replaceProject(const QString& step, const Project& project) {
  applying_ = true;
  const auto edited = document_.edit(step, [&](Project& changed) { changed = project; });
  applying_ = false;
  if (!edited) {
    resultText_ = errorText(edited.error());
  }
}

void WorldMarks::apply(WorldStep step, double meters) {
  std::vector<MeasuredPoint> points;
  for (const int mark : marksUsedBy(step)) {
    points.push_back(marks_[static_cast<std::size_t>(mark)]);
  }
  const auto result = withWorldStep(document_.project(), step, points, meters);
  resultText_ = result ? resultOf(step, *result) : refusal(result.error());
  if (result) {
    replaceProject(stepName(step), result->project);
  }
  Q_EMIT changed();
}

void WorldMarks::storeLengthCheck(double meters) {
  const auto result = withLengthCheck(document_.project(), marks_[0], marks_[1], meters);
  if (result) {
    const LengthCheck found = result->worldRecord.lengthCheck.value();
    resultText_ = tr("From A to B, the calibration gives %1; you measured %2. The calibration is "
                     "off by %3 %.")
                      .arg(lengthText(found.calibratedLength, LengthScale::Meters, 4),
                           lengthText(found.measuredLength, LengthScale::Meters, 4),
                           percentAccuracyText(
                               std::abs(found.calibratedLength / found.measuredLength - 1.0)));
    replaceProject(tr("Check a distance"), *result);
  } else {
    resultText_ = refusal(result.error());
  }
  Q_EMIT changed();
}

void WorldMarks::rotateWorld(WorldAxis axis) {
  resultText_.clear();
  replaceProject(tr("Rotate all cameras"),
                 withMovedWorld(document_.project(), calibration::quarterTurns(axis, 1)));
}

void WorldMarks::moveWorld(const Eigen::Vector3d& shift, double turn) {
  resultText_.clear();
  replaceProject(tr("Move all cameras"),
                 withMovedWorld(document_.project(), calibration::rigidMotion(shift, turn)));
}

bool WorldMarks::canRotateUpright() const {
  return setup::canRotateUpright(document_.project());
}

} // namespace dewpoint::ui

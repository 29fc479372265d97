// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/run_plots.h"

#include "core/session/snapshot/snapshot.h"

#include <QCoreApplication>

#include <limits>

namespace dewpoint::ui {

namespace {

/// Columns of the series, then two for each camera.
enum RunColumn : std::size_t {
  kPositionX,
  kPositionY,
  kPositionZ,
  kTruthX,
  kTruthY,
  kTruthZ,
  kBoxWidth,
  kBoxHeight,
  kSpreadX,
  kSpreadY,
  kSpreadZ,
  kSpread,
  kSampleSize,
  kParticles,
  kError,
  kDuration,
  kExistence,
  kFirstCamera,
};
constexpr std::size_t kPerCamera = 2; ///< likelihood, existence

class RunPlots {
  Q_DECLARE_TR_FUNCTIONS(RunPlots)
};

/// For the name of a column: no commas, quotes or spaces.
QString plainName(const QString& name) {
  QString plain;
  for (const QChar letter : name) {
    plain += letter.isLetterOrNumber() ? letter : QLatin1Char('_');
  }
  return plain;
}

PlotDeclaration positionPlot() {
  const auto curve = [](int axis, const char* name) {
    const auto number = static_cast<std::size_t>(axis);
    const QLatin1String letter(name);
    return CurveDeclaration{letter,
                            QStringLiteral("%1_m").arg(letter),
                            kPositionX + number,
                            axis,
                            kSpreadX + number,
                            kTruthX + number,
                            QStringLiteral("true_%1_m").arg(letter)};
  };
  return {QStringLiteral("position"),
          RunPlots::tr("Position"),
          PlotQuantity::Position,
          {curve(0, "x"), curve(1, "y"), curve(2, "z")}};
}

PlotDeclaration sampleSizePlot() {
  return {QStringLiteral("sampleSize"),
          RunPlots::tr("Effective sample size"),
          PlotQuantity::Count,
          {{RunPlots::tr("effective"), QStringLiteral("effective_sample_size"), kSampleSize, 0},
           {RunPlots::tr("particles"), QStringLiteral("particles"), kParticles, -1}}};
}

PlotDeclaration durationPlot() {
  return {QStringLiteral("duration"),
          RunPlots::tr("Time per step"),
          PlotQuantity::Duration,
          {{RunPlots::tr("one iteration"), QStringLiteral("iteration_us"), kDuration, 3}}};
}

std::vector<CurveDeclaration> cameraCurves(const QStringList& cameras, const QString& what,
                                           std::size_t offset) {
  std::vector<CurveDeclaration> curves;
  curves.reserve(static_cast<std::size_t>(cameras.size()));
  for (int camera = 0; camera < cameras.size(); ++camera) {
    curves.push_back({cameras[camera], what + QLatin1Char('_') + plainName(cameras[camera]),
                      kFirstCamera + kPerCamera * static_cast<std::size_t>(camera) + offset,
                      camera});
  }
  return curves;
}

} // namespace

std::vector<PlotDeclaration> plotsOfRun(const QStringList& cameras) {
  std::vector<CurveDeclaration> existence{
      {RunPlots::tr("all cameras"), QStringLiteral("existence"), kExistence, -1}};
  for (CurveDeclaration& curve : cameraCurves(cameras, QStringLiteral("existence"), 1)) {
    existence.push_back(std::move(curve));
  }
  return {
      positionPlot(),
      {QStringLiteral("spread"),
       RunPlots::tr("Spread"),
       PlotQuantity::Length,
       {{QStringLiteral("x"), QStringLiteral("spread_x_mm"), kSpreadX, 0},
        {QStringLiteral("y"), QStringLiteral("spread_y_mm"), kSpreadY, 1},
        {QStringLiteral("z"), QStringLiteral("spread_z_mm"), kSpreadZ, 2}}},
      sampleSizePlot(),
      {QStringLiteral("likelihood"), RunPlots::tr("Log likelihood"), PlotQuantity::LogLikelihood,
       cameraCurves(cameras, QStringLiteral("log_likelihood"), 0)},
      {QStringLiteral("existence"), RunPlots::tr("Existence"), PlotQuantity::Probability,
       std::move(existence)},
      {QStringLiteral("error"),
       RunPlots::tr("Error against ground truth"),
       PlotQuantity::Length,
       {{RunPlots::tr("distance"), QStringLiteral("error_mm"), kError, 1}}},
      durationPlot(),
  };
}

std::vector<PlotDeclaration> plotsOfBoxRun() {
  return {
      {QStringLiteral("position"),
       RunPlots::tr("Position"),
       PlotQuantity::PixelPosition,
       {{QStringLiteral("x"), QStringLiteral("center_x_px"), kPositionX, 0},
        {QStringLiteral("y"), QStringLiteral("center_y_px"), kPositionY, 1},
        {RunPlots::tr("width"), QStringLiteral("width_px"), kBoxWidth, 2},
        {RunPlots::tr("height"), QStringLiteral("height_px"), kBoxHeight, 3}}},
      {QStringLiteral("spread"),
       RunPlots::tr("Spread"),
       PlotQuantity::Pixels,
       {{RunPlots::tr("particles"), QStringLiteral("spread_px"), kSpread, 0}}},
      sampleSizePlot(),
      {QStringLiteral("likelihood"),
       RunPlots::tr("Similarity"),
       PlotQuantity::Probability,
       {{RunPlots::tr("similarity to the reference colors"), QStringLiteral("similarity"),
         kExistence, 1}}},
      durationPlot(),
  };
}

std::size_t columnCountOfRunPlots(int cameraCount) {
  return kFirstCamera + kPerCamera * static_cast<std::size_t>(cameraCount);
}

double particleSpreadOf(const PlotSeries& series, std::size_t row) {
  return series.value(row, kSpread);
}

void appendIteration(PlotSeries& series, const IterationRecord& record) {
  std::vector<float> values(series.columnCount(), std::numeric_limits<float>::quiet_NaN());
  const auto put = [&values](std::size_t column, double value) {
    values[column] = static_cast<float>(value);
  };
  for (int axis = 0; axis < 3; ++axis) {
    put(kPositionX + static_cast<std::size_t>(axis), record.position[axis]);
    put(kTruthX + static_cast<std::size_t>(axis), record.truth[axis]);
  }
  put(kBoxWidth, record.boxWidth);
  put(kBoxHeight, record.boxHeight);
  put(kSpreadX, record.spreadPerAxis.x());
  put(kSpreadY, record.spreadPerAxis.y());
  put(kSpreadZ, record.spreadPerAxis.z());
  put(kSpread, record.spread);
  put(kSampleSize, record.effectiveSampleSize);
  put(kParticles, record.particleCount);
  if (record.distanceToTruth >= 0.0) {
    put(kError, record.distanceToTruth);
  }
  put(kDuration, record.durationMicroseconds);
  put(kExistence, record.similarity.value_or(record.existenceProbability));
  for (std::size_t camera = 0; camera < record.cameraEvidence.size(); ++camera) {
    const CameraEvidence& evidence = record.cameraEvidence[camera];
    const std::size_t column = kFirstCamera + kPerCamera * camera;
    if (evidence.isInView && column + 1 < values.size()) {
      put(column, evidence.logLikelihood);
      put(column + 1, evidence.existenceProbability);
    }
  }
  series.append({record.iteration, record.frame, record.frameTime}, values);
}

} // namespace dewpoint::ui

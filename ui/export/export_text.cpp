// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_text.h"

#include "core/trajectory/export/trajectory_export.h"
#include "ui/text/quantity_text.h"

#include <QCoreApplication>
#include <QLocale>

#include <array>

namespace dewpoint::ui {

namespace {

struct Word {
  std::string_view id;
  const char* text;
};

// As in exportFormats(); a test compares them.
constexpr std::array kFormatNames{
    Word{"csv", QT_TRANSLATE_NOOP("Export", "CSV, one row per target and time")},
    Word{"csv-wide", QT_TRANSLATE_NOOP("Export", "CSV, one row per time (spreadsheets)")},
    Word{"tum", QT_TRANSLATE_NOOP("Export", "TUM (evo)")},
    Word{"trc", QT_TRANSLATE_NOOP("Export", "TRC (OpenSim)")},
    Word{"c3d", QT_TRANSLATE_NOOP("Export", "C3D (motion capture)")},
    Word{"npz", QT_TRANSLATE_NOOP("Export", "NPZ (NumPy)")},
    Word{"vtp", QT_TRANSLATE_NOOP("Export", "VTP (ParaView, paths)")},
    Word{"pvd", QT_TRANSLATE_NOOP("Export", "PVD (ParaView, over time)")},
    Word{"jsonl", QT_TRANSLATE_NOOP("Export", "JSON lines")},
};

QString translatedExport(const char* text, int count = -1) {
  return QCoreApplication::translate("Export", text, nullptr, count);
}

} // namespace

QString exportFormatName(std::string_view id) {
  for (const Word& word : kFormatNames) {
    if (word.id == id) {
      return translatedExport(word.text);
    }
  }
  return QString::fromUtf8(id.data(), static_cast<qsizetype>(id.size()));
}

QString exportUnitsText(const ExportPreview& preview) {
  const QString unit =
      preview.unit == LengthUnit::Meter ? QStringLiteral("m") : QStringLiteral("mm");
  const QString axes =
      preview.axes == WorldAxes::ZUp
          ? translatedExport(QT_TRANSLATE_NOOP("Export", "Z points up, axes as in the project"))
          : translatedExport(QT_TRANSLATE_NOOP(
                "Export", "Y points up: x, y, z of the file are y, z, x of the project"));
  return translatedExport(
             QT_TRANSLATE_NOOP("Export", "Lengths in %1, times in s, covariances in %1². %2."))
      .arg(unit, axes);
}

QString exportSizeText(const ExportPreview& preview) {
  const QLocale locale;
  const QString gaps = preview.gapCount == 0
                           ? translatedExport(QT_TRANSLATE_NOOP("Export", "no gaps"))
                           : translatedExport(QT_TRANSLATE_NOOP("Export", "%1 positions unknown"))
                                 .arg(locale.toString(static_cast<qulonglong>(preview.gapCount)));
  return translatedExport(
             QT_TRANSLATE_NOOP("Export", "Targets: %1, rows: %2 at %3 per second, %4."))
      .arg(locale.toString(static_cast<qulonglong>(preview.targetCount)),
           locale.toString(static_cast<qulonglong>(preview.rowCount)),
           rateText(preview.rowsPerSecond), gaps);
}

QString exportedText(const ExportSummary& summary) {
  const QString name = QString::fromStdString(summary.files.back().string());
  if (summary.rowCount == 0) {
    return QCoreApplication::translate("ExportDialog", "Wrote the figure %1.").arg(name);
  }
  if (summary.files.size() > 1) {
    return QCoreApplication::translate("ExportDialog",
                                       "Exported %1 rows to %2 files; the last is %3.")
        .arg(summary.rowCount)
        .arg(summary.files.size())
        .arg(name);
  }
  return QCoreApplication::translate("ExportDialog", "Exported %1 rows to %2.")
      .arg(summary.rowCount)
      .arg(name);
}

} // namespace dewpoint::ui

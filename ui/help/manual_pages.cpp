// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/manual_pages.h"

#include "core/tracking/catalog/method_catalog.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include <array>
#include <string_view>
#include <utility>

namespace dewpoint::ui {

namespace {

using PageRow = std::pair<const char*, const char*>;

const QString kWindowPage(QStringLiteral("window.md"));

/// Names of docks, or how they begin.
constexpr std::array kPageOfDock{
    PageRow{"cameraListDock", "calibration.md"}, PageRow{"cameraDock", "window.md"},
    PageRow{"birdsEyeDock", "window.md"},        PageRow{"plotDock", "plots.md"},
    PageRow{"trajectoryDock", "plots.md"},       PageRow{"timelineDock", "time-travel.md"},
    PageRow{"targetDock", "window.md"},          PageRow{"colorDock", "color.md"},
    PageRow{"peopleDock", "people.md"},          PageRow{"calibrationDock", "calibration.md"},
    PageRow{"historyDock", "window.md"}};

QString manualPage(std::string_view page) {
  return QString::fromUtf8(page.data(), static_cast<qsizetype>(page.size()));
}

} // namespace

QStringList manualPages() {
  QStringList pages = {QStringLiteral("quick-start.md"),
                       QStringLiteral("first-ten-minutes.md"),
                       kWindowPage,
                       QStringLiteral("tutorial-two-videos.md"),
                       QStringLiteral("tutorial-grid-by-hand.md"),
                       QStringLiteral("tutorial-board.md"),
                       QStringLiteral("tutorial-wand.md"),
                       QStringLiteral("tutorial-one-camera-box.md"),
                       QStringLiteral("tutorial-people.md"),
                       QStringLiteral("tutorial-several-targets.md"),
                       QStringLiteral("tutorial-changing-light.md"),
                       QStringLiteral("many-recordings.md"),
                       QStringLiteral("color.md"),
                       QStringLiteral("calibration.md"),
                       QStringLiteral("people.md"),
                       QStringLiteral("cameras.md"),
                       QStringLiteral("recording.md"),
                       QStringLiteral("live-output.md"),
                       QStringLiteral("time-travel.md"),
                       QStringLiteral("plots.md"),
                       QStringLiteral("export.md"),
                       QStringLiteral("troubleshooting.md"),
                       QStringLiteral("concepts.md"),
                       QStringLiteral("limitations.md"),
                       QStringLiteral("glossary.md"),
                       QStringLiteral("project-file.md"),
                       QStringLiteral("command-line.md"),
                       QStringLiteral("python.md")};
  for (const std::string_view page : methodManualPages()) {
    pages << manualPage(page);
  }
  pages << QStringLiteral("method-calibration.md") << QStringLiteral("method-color.md")
        << QStringLiteral("fidelity.md") << QStringLiteral("measurements-dewpoint.md")
        << QStringLiteral("measurements-people.md") << QStringLiteral("measurements-calibration.md")
        << QStringLiteral("measurements-color.md") << QStringLiteral("accuracy.md")
        << QStringLiteral("speed.md") << QStringLiteral("changelog.md");
  return pages;
}

QString manualPageOfMethod(const QString& method) {
  return manualPage(methodManualPage(method.toStdString()));
}

QString manualPageOf(const QString& dock, const QString& method) {
  if (dock == QStringLiteral("parameterDock")) {
    return manualPageOfMethod(method);
  }
  for (const auto& [name, page] : kPageOfDock) {
    if (dock.startsWith(QLatin1String(name))) {
      return QLatin1String(page);
    }
  }
  return kWindowPage;
}

QStringList manualFolders() {
  const QDir program(QCoreApplication::applicationDirPath());
  return {program.absoluteFilePath(QStringLiteral("../share/dewpoint/docs")),
          QStringLiteral(DEWPOINT_INSTALLED_DOCS), QStringLiteral(DEWPOINT_SOURCE_DOCS),
          program.absoluteFilePath(QStringLiteral("../../../docs"))};
}

QString findManual(const QStringList& folders) {
  for (const QString& folder : folders) {
    if (QFileInfo::exists(QDir(folder).filePath(kWindowPage))) {
      return QDir::cleanPath(folder);
    }
  }
  return {};
}

} // namespace dewpoint::ui

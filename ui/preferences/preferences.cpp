// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/preferences/preferences.h"

#include <QFileInfo>
#include <QSettings>

#include <algorithm>

namespace dewpoint::ui {

namespace {

// Keys stay as they are: people's preferences are read from what earlier versions wrote.
constexpr QLatin1String kTheme("theme");
constexpr QLatin1String kLanguage("language");
constexpr QLatin1String kWindowGeometry("window/geometry");
constexpr QLatin1String kRecentProjects("recentProjects");
constexpr QLatin1String kLastFolder("lastFolder");
constexpr QLatin1String kFilterThreads("filter/threads");
constexpr QLatin1String kSlowUntilTracking("playback/slowUntilHeld");
constexpr QLatin1String kPreRollSeconds("recording/preRollSeconds");
constexpr QLatin1String kExportNotes("export/notes");
constexpr QLatin1String kShortcuts("shortcuts/");
constexpr QLatin1String kPlotsShown("plots/shown");
constexpr QLatin1String kPlotsOverTime("plots/overTime");
constexpr QLatin1String kBoard("calibration/board");
constexpr QLatin1String kBoardModel("calibration/boardModel");
constexpr QLatin1String kBoardLenses("calibration/boardLenses");
constexpr QLatin1String kBoardPlaces("calibration/boardPlaces");
constexpr QLatin1String kBoardLensAccuracy("calibration/boardLensAccuracy");
constexpr QLatin1String kBoardPlaceAccuracy("calibration/boardPlaceAccuracy");

constexpr int kRecentKept = 10;

QVariant read(QAnyStringView key, const QVariant& otherwise = {}) {
  return QSettings().value(key.toString(), otherwise);
}

void write(QAnyStringView key, const QVariant& value) {
  QSettings().setValue(key.toString(), value);
}

} // namespace

Theme Preferences::theme() const {
  return themeFromName(read(kTheme).toString());
}

void Preferences::setTheme(Theme theme) {
  write(kTheme, themeName(theme));
}

QString Preferences::language() const {
  return read(kLanguage).toString();
}

void Preferences::setLanguage(const QString& language) {
  write(kLanguage, language);
}

QByteArray Preferences::windowGeometry() const {
  return read(kWindowGeometry).toByteArray();
}

void Preferences::setWindowGeometry(const QByteArray& geometry) {
  write(kWindowGeometry, geometry);
}

QStringList Preferences::recentProjects() const {
  return read(kRecentProjects).toStringList();
}

void Preferences::addRecentProject(const QString& file) {
  const QString path = QFileInfo(file).absoluteFilePath();
  QStringList files = read(kRecentProjects).toStringList();
  files.removeAll(path);
  files.prepend(path);
  write(kRecentProjects, QStringList(files.mid(0, kRecentKept)));
}

void Preferences::clearRecentProjects() {
  QSettings().remove(kRecentProjects);
}

QString Preferences::lastFolder() const {
  return read(kLastFolder).toString();
}

void Preferences::setLastFolder(const QString& folder) {
  write(kLastFolder, folder);
}

int Preferences::filterThreadCount() const {
  return std::max(0, read(kFilterThreads, 0).toInt());
}

void Preferences::setFilterThreadCount(int threads) {
  write(kFilterThreads, std::max(0, threads));
}

bool Preferences::isSlowUntilTracking() const {
  return read(kSlowUntilTracking, true).toBool();
}

void Preferences::setSlowUntilTracking(bool slow) {
  write(kSlowUntilTracking, slow);
}

int Preferences::preRollSeconds() const {
  return std::max(0, read(kPreRollSeconds, 0).toInt());
}

void Preferences::setPreRollSeconds(int seconds) {
  write(kPreRollSeconds, std::max(0, seconds));
}

bool Preferences::exportsNotes() const {
  return read(kExportNotes, true).toBool();
}

void Preferences::setExportsNotes(bool notes) {
  write(kExportNotes, notes);
}

std::optional<QKeySequence> Preferences::shortcut(const QString& action) const {
  const QVariant chosen = read(kShortcuts + action);
  return chosen.isValid()
             ? std::optional(QKeySequence(chosen.toString(), QKeySequence::PortableText))
             : std::nullopt;
}

void Preferences::setShortcut(const QString& action, const std::optional<QKeySequence>& shortcut) {
  if (shortcut) {
    write(kShortcuts + action, shortcut->toString(QKeySequence::PortableText));
  } else {
    QSettings().remove(kShortcuts + action);
  }
}

std::optional<QStringList> Preferences::shownPlots() const {
  const QVariant shown = read(kPlotsShown);
  return shown.isValid() ? std::optional(shown.toStringList()) : std::nullopt;
}

void Preferences::setShownPlots(const QStringList& plots) {
  write(kPlotsShown, plots);
}

bool Preferences::showsPlotsOverTime() const {
  return read(kPlotsOverTime, true).toBool();
}

void Preferences::setShowsPlotsOverTime(bool time) {
  write(kPlotsOverTime, time);
}

BoardPreferences Preferences::boardPreferences(const BoardPreferences& otherwise) const {
  BoardPreferences board;
  board.boardText = read(kBoard, otherwise.boardText).toString();
  board.lensModel = read(kBoardModel, otherwise.lensModel).toInt();
  board.calibratesIntrinsics = read(kBoardLenses, otherwise.calibratesIntrinsics).toBool();
  board.calibratesPositions = read(kBoardPlaces, otherwise.calibratesPositions).toBool();
  board.intrinsicsAccuracyPx = read(kBoardLensAccuracy, otherwise.intrinsicsAccuracyPx).toDouble();
  board.positionAccuracyMeters =
      read(kBoardPlaceAccuracy, otherwise.positionAccuracyMeters).toDouble();
  return board;
}

void Preferences::setBoardPreferences(const BoardPreferences& board) {
  write(kBoard, board.boardText);
  write(kBoardModel, board.lensModel);
  write(kBoardLenses, board.calibratesIntrinsics);
  write(kBoardPlaces, board.calibratesPositions);
  write(kBoardLensAccuracy, board.intrinsicsAccuracyPx);
  write(kBoardPlaceAccuracy, board.positionAccuracyMeters);
}

Theme themeFromName(const QString& name) {
  return name == QLatin1String("light")  ? Theme::Light
         : name == QLatin1String("dark") ? Theme::Dark
                                         : Theme::System;
}

QString themeName(Theme theme) {
  return theme == Theme::Light  ? QStringLiteral("light")
         : theme == Theme::Dark ? QStringLiteral("dark")
                                : QStringLiteral("system");
}

} // namespace dewpoint::ui

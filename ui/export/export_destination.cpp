// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_destination.h"

#include "core/project/project.h"
#include "core/setup/new_project/new_project.h"
#include "ui/document/document.h"
#include "ui/workbench/workbench.h"

#include <QDir>
#include <QFileInfo>
#include <QLineEdit>
#include <QMainWindow>

namespace dewpoint::ui {

ExportDestination::ExportDestination(const Document& document, QObject* parent)
    : QObject(parent), document_(document) {}

ExportDestination* ExportDestination::forWorkbench(const Workbench& bench) {
  auto* found = bench.window.findChild<ExportDestination*>(QString(), Qt::FindDirectChildrenOnly);
  return found != nullptr ? found : new ExportDestination(bench.document, &bench.window);
}

QString ExportDestination::projectFolder() const {
  const Project& project = document_.project();
  if (!project.file.empty()) {
    return QFileInfo(QString::fromStdString(project.file.string())).absolutePath();
  }
  const auto recorded = proposedProjectFile(project).parent_path();
  return recorded.empty() ? QDir::homePath()
                          : QDir(QString::fromStdString(recorded.string())).absolutePath();
}

QString ExportDestination::folder() const {
  return chosen_.isEmpty() ? projectFolder() : chosen_;
}

QString ExportDestination::proposedFile(const QString& kind) const {
  const Project& project = document_.project();
  const auto named =
      project.name.empty() && !project.file.empty() ? project.file : proposedProjectFile(project);
  return QDir(folder()).filePath(
      QStringLiteral("%1-%2").arg(QString::fromStdString(named.stem().string()), kind));
}

void ExportDestination::rememberFolder(const QString& file) {
  const QString used = QFileInfo(file).absolutePath();
  chosen_ = used == projectFolder() ? QString() : used;
}

void ProposedFile::propose(const QString& file) {
  if (field_.text() == proposed_) {
    reset(file);
  }
}

void ProposedFile::reset(const QString& file) {
  proposed_ = file + suffix_;
  field_.setText(proposed_);
}

void ProposedFile::setSuffix(const QString& suffix, const QStringList& known) {
  QString name = field_.text();
  const bool isProposed = name == proposed_;
  suffix_ = suffix;
  for (const QString& old : known) {
    if (name.endsWith(old)) {
      name.chop(old.size());
      break;
    }
  }
  field_.setText(name + suffix);
  if (isProposed) {
    proposed_ = field_.text();
  }
}

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QObject>
#include <QString>

#include <filesystem>
#include <memory>
#include <string>

class QUndoStack;

namespace dewpoint {

struct Project;

/// The project and its history: the only door through which the window changes it. Changes are
/// undoable commands; each announces what changed.
class Document : public QObject {
  Q_OBJECT
public:
  explicit Document(QObject* parent = nullptr);
  ~Document() override;

  const Project& project() const { return *project_; }
  QUndoStack* undoStack() const { return undoStack_; }
  /// Another project takes the place of this one; the history starts anew.
  void replace(Project project);
  /// Changes a parameter as an undoable step; steps of one slider drag merge. BadValue or
  /// UnknownKey leave everything as it was.
  Status setParameter(const std::string& key, double value);

  Status save();
  Status saveAs(const std::filesystem::path& file);

Q_SIGNALS:
  void replaced();
  void parameterChanged(const QString& key);
  void fileChanged();

private:
  friend class SetParameterCommand;
  void assignParameter(const std::string& key, double value);

  std::unique_ptr<Project> project_;
  QUndoStack* undoStack_;
};

} // namespace dewpoint

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

class ParameterValues;
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

  /// Chooses the method as an undoable step; parameters that it shares keep their values.
  void setMethod(const std::string& method);

  Status save();
  Status saveAs(const std::filesystem::path& file);

Q_SIGNALS:
  void replaced();
  void parameterChanged(const QString& key);
  void methodChanged();
  void fileChanged();

private:
  friend class SetMethodCommand;
  friend class SetParameterCommand;
  void assignParameter(const std::string& key, double value);
  void assignMethod(const std::string& method, const ParameterValues& parameters);

  std::unique_ptr<Project> project_;
  QUndoStack* undoStack_;
};

} // namespace dewpoint

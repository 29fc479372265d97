// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/project_changes.h"

#include <QObject>
#include <QString>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

class QUndoStack;

namespace dewpoint::tracking {
struct MethodFamily;
} // namespace dewpoint::tracking

namespace dewpoint::ui {

struct MethodPresentation;

/// The project and its history. The window changes the project only through this class. Every edit
/// is a named, undoable step and announces what it changed.
class Document : public QObject {
  Q_OBJECT
public:
  explicit Document(QObject* parent = nullptr);
  ~Document() override;

  /// The project; the reference is valid until the next change, so copy what you keep.
  const Project& project() const { return *project_; }
  /// The project as an immutable object that can be kept.
  std::shared_ptr<const Project> state() const { return project_; }
  /// Parameters used for tracking, including those derived from the cameras.
  const ParameterValues& usedParameters() const { return usedParameters_; }
  /// Values that these parameters have when the project sets none: the defaults of the method and
  /// those derived from the cameras.
  const ParameterValues& defaultParameters() const { return defaultParameters_; }
  /// Whether the value in use of a declared parameter differs from its default
  /// (`setup::isChanged()`).
  bool isChanged(const ParameterDeclaration& declaration) const;
  /// Options of the window for the current method; they change with `methodChanged()` or
  /// `replaced()`.
  const MethodPresentation& presentation() const;
  /// Family of the method of the project.
  MethodFamily methodFamily() const;
  QUndoStack* undoStack() const { return undoStack_; }
  /// Replaces the project by another one and clears the history. `unsaved`: no file contains this
  /// state of the project (it was recovered, or just created).
  void replace(Project project, bool unsaved = false);
  /// Whether there are changes that no file contains.
  bool isUnsaved() const;

  /// Changes the project as one undoable step called `name` (an imperative: "Rename camera").
  /// Successive steps with the same `mergeKey` become one, such as the moves of a drag. If
  /// `checkProject()` rejects the new state, nothing changes and its error is returned. A change
  /// without effect makes no step.
  Status edit(const QString& name, const std::function<void(Project&)>& change,
              const std::string& mergeKey = {});
  /// Ends merging: the next step is separate, because a drag has ended.
  void endMerging();

  /// Changes a parameter as an undoable step; the steps of one slider drag are merged. The first
  /// change to a parameter derived from the cameras stores all such parameters with the values in
  /// use. The errors BadValue and UnknownKey change nothing.
  Status setParameter(const std::string& key, double value);
  /// Resets one declared parameter, or all changed ones, to the default as an undoable step.
  void resetParameter(const std::string& key);
  void resetParameters();
  /// Selects the method as an undoable step. Parameters that both methods have keep their values.
  void setMethod(const std::string& method);
  /// Stores the layout of the views. It is saved with the project but is neither an edit nor a
  /// step.
  void setLayout(const std::string& layout);

  /// Reports that `file` now contains this state of the project, and makes it the file of the
  /// project. Later changes stay unsaved. Called by `ProjectSaver`.
  void setSaved(const Project& state, const std::filesystem::path& file);

Q_SIGNALS:
  /// Another project has replaced the previous one.
  void replaced();
  /// An edit, an undo or a redo has happened; the more specific signals follow.
  void changed(const dewpoint::project::ProjectChanges& changes);
  void parameterChanged(const QString& key);
  void methodChanged();
  void targetsChanged();
  void calibrationChanged();
  void emptyRoomsChanged();
  void volumeChanged();
  void peopleChanged();
  void correctionsChanged();
  void sourcesChanged();
  void fileChanged();

private:
  friend class EditCommand;
  /// Makes a state the current one and announces what changed.
  void assign(const std::shared_ptr<const Project>& state);
  void announce(const ProjectChanges& changes);

  std::shared_ptr<const Project> project_;
  ParameterValues usedParameters_;    ///< values in use for the project
  ParameterValues defaultParameters_; ///< values that the project would use if it set none
  QUndoStack* undoStack_;
  std::string mergeSuffix_; ///< changes with each endMerging()
  int drags_ = 0;
  bool unsaved_ = false; ///< unsaved independently of the history
};

} // namespace dewpoint::ui

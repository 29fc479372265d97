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
/// is a named, undoable step and announces its changes.
class Document : public QObject {
  Q_OBJECT
public:
  explicit Document(QObject* parent = nullptr);
  ~Document() override;

  /// Returns the project. The reference is valid until the next change, so make copies of data to
  /// keep.
  const Project& project() const { return *project_; }
  /// Returns the project as an immutable object that can be kept.
  std::shared_ptr<const Project> state() const { return project_; }
  /// Returns the parameters used for tracking, including those derived from the cameras.
  const ParameterValues& usedParameters() const { return usedParameters_; }
  /// Returns the values of these parameters when the project sets none: the method's defaults and
  /// those derived from the cameras.
  const ParameterValues& defaultParameters() const { return defaultParameters_; }
  /// Returns whether the current value of a declared parameter differs from its default
  /// (`setup::isChanged()`).
  bool isChanged(const ParameterDeclaration& declaration) const;
  /// Returns the window options for the current method. They change with `methodChanged()` or
  /// `replaced()`.
  const MethodPresentation& presentation() const;
  /// Returns the family of the project's method.
  MethodFamily methodFamily() const;
  QUndoStack* undoStack() const { return undoStack_; }
  /// Replaces the project by another one and clears the history. `unsaved` is true if no file
  /// contains this state of the project, because it was recovered or just created.
  void replace(Project project, bool unsaved = false);
  /// Returns whether there are changes that no file contains.
  bool isUnsaved() const;

  /// Changes the project in one undoable step called `name` (an imperative, such as "Rename
  /// camera"). Successive steps with the same `mergeKey`, such as the moves of a drag, are merged
  /// into one. If `checkProject()` rejects the new state, nothing changes and its error is
  /// returned. A change without effect creates no step.
  Status edit(const QString& name, const std::function<void(Project&)>& change,
              const std::string& mergeKey = {});
  /// Changes the sources of the cameras, in the same way as edit(), in a step of its own. Live
  /// cameras report more when they have been opened with the new sources (`completeSources()`).
  Status editSources(const QString& name, const std::function<void(Project&)>& change);
  /// Adds what live cameras have reported, such as the size of their images, to the last step if it
  /// is one of `editSources()`. Otherwise this is a step of its own, called `name`.
  Status completeSources(const QString& name, const std::function<void(Project&)>& change);
  /// Ends merging, for example after a drag. The next change is a separate step.
  void endMerging();

  /// Changes a parameter in an undoable step. The steps of one slider drag are merged. The first
  /// change to a parameter derived from the cameras stores all such parameters with their current
  /// values. If the result is the error BadValue or UnknownKey, nothing has changed.
  Status setParameter(const std::string& key, double value);
  /// Resets one declared parameter, or all changed parameters, to the default in an undoable step.
  void resetParameter(const std::string& key);
  void resetParameters();
  /// Selects the method in an undoable step. Parameters shared by both methods keep their values.
  void setMethod(const std::string& method);
  /// Stores the layout of the views. The layout is saved with the project but is neither an edit
  /// nor a step.
  void setLayout(const std::string& layout);

  /// Marks `file` as containing this state of the project, and makes it the project file. Later
  /// changes stay unsaved. Called by `ProjectSaver`.
  void setSaved(const Project& state, const std::filesystem::path& file);

Q_SIGNALS:
  /// Emitted when another project has replaced the previous one.
  void replaced();
  /// Emitted after an edit, an undo or a redo. The more specific signals follow.
  void changed(const dewpoint::project::ProjectChanges& changes);
  void parameterChanged(const QString& key);
  void methodChanged();
  void targetsChanged();
  void calibrationChanged();
  void backgroundImagesChanged();
  void volumeChanged();
  void peopleChanged();
  void correctionsChanged();
  void sourcesChanged();
  void fileChanged();

private:
  friend class EditCommand;
  /// Makes a state the current one and announces the changes.
  void assign(const std::shared_ptr<const Project>& state);
  void emitChanges(const ProjectChanges& changes);

  std::shared_ptr<const Project> project_;
  ParameterValues usedParameters_;    ///< current values for the project
  ParameterValues defaultParameters_; ///< values for a project that sets none
  QUndoStack* undoStack_;
  std::string mergeSuffix_; ///< changes with each endMerging()
  int mergeGroup_ = 0;
  bool unsaved_ = false; ///< unsaved regardless of the history
};

} // namespace dewpoint::ui

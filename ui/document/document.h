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

/// The open project and its undo history. The window changes the project only through this class.
/// Every edit is a named, undoable step, and signals report what has changed.
class Document : public QObject {
  Q_OBJECT
public:
  explicit Document(QObject* parent = nullptr);
  ~Document() override;

  /// Returns the project. The reference is valid until the next change, so make copies of data to
  /// keep.
  const Project& project() const { return *project_; }
  /// Returns the project as an immutable object that can be kept.
  std::shared_ptr<const Project> sharedProject() const { return project_; }
  /// Returns the parameters used for tracking, including those derived from the cameras.
  const ParameterValues& usedParameters() const { return usedParameters_; }
  /// Returns the values that the tracking parameters have if the project sets none: the method's
  /// defaults and those derived from the cameras.
  const ParameterValues& defaultParameters() const { return defaultParameters_; }
  /// Returns whether the current value of a declared parameter differs from its default
  /// (`setup::isChanged()`).
  bool isParameterChanged(const ParameterDeclaration& declaration) const;
  /// Returns the window options for the current method. They can change whenever `methodChanged()`
  /// or `projectReplaced()` is emitted.
  const MethodPresentation& methodPresentation() const;
  /// Returns the properties of the family (the methods of the same kind) of the project's method.
  MethodFamily methodFamily() const;
  QUndoStack* undoStack() const { return undoStack_; }
  /// Replaces the project by another one and clears the history. `unsaved` is true if no file
  /// contains `project`, because it was recovered or just created.
  void replaceProject(Project project, bool unsaved = false);
  /// Returns whether there are changes that no file contains.
  bool isUnsaved() const;

  /// Changes the project in one undoable step called `name` (an imperative, such as "Rename
  /// camera"). Successive steps with the same `mergeKey`, such as the moves of a drag, are merged
  /// into one. If `checkProject()` rejects the new state, nothing changes and its error is
  /// returned. A change without effect creates no step.
  Status edit(const QString& name, const std::function<void(Project&)>& change,
              const std::string& mergeKey = {});
  /// Changes the sources of the cameras in a separate undoable step called `name`. Like edit(), it
  /// changes nothing and returns the error if the new state is invalid. After live cameras have
  /// been opened with their new sources, completeSources() can add what they report to this step.
  Status editSources(const QString& name, const std::function<void(Project&)>& change);
  /// Changes the project to include what live cameras have reported, such as their image sizes. If
  /// the last step was made by `editSources()`, the change becomes part of this step; otherwise, it
  /// is a separate step called `name`.
  Status completeSources(const QString& name, const std::function<void(Project&)>& change);
  /// Ends merging, for example after a drag. The next change is a separate step.
  void endStepMerging();

  /// Changes a parameter in an undoable step. The steps of one slider drag are merged. The first
  /// change to a parameter derived from the cameras stores all such parameters with their current
  /// values. Returns BadValue or UnknownKey, and changes nothing, if the value or the key is
  /// invalid.
  Status setParameter(const std::string& key, double value);
  /// Reset a parameter, or all changed parameters (`resetParameters()`), to the default in an
  /// undoable step.
  void resetParameter(const std::string& key);
  void resetParameters();
  /// Selects the method in an undoable step. Parameters that the previous and the new method share
  /// keep their values.
  void setMethod(const std::string& method);
  /// Stores the layout of the views. The layout is saved with the project but is neither an edit
  /// nor a step.
  void setLayout(const std::string& layout);

  /// Notes that `file` contains the project as it was in `state`, and makes it the project file.
  /// Changes after this state stay unsaved. Called by `ProjectSaver`.
  void markSaved(const Project& state, const std::filesystem::path& file);

Q_SIGNALS:
  /// Emitted when another project has replaced the previous one.
  void projectReplaced();
  /// Emitted after an edit, an undo or a redo. The more specific signals follow.
  void changed(const dewpoint::project::ProjectChanges& changes);
  void parameterChanged(const QString& key);
  void methodChanged();
  void targetsChanged();
  void calibrationChanged();
  void backgroundImagesChanged();
  void volumeChanged();
  void personCorrectionsChanged();
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
  std::string mergeSuffix_; ///< changes with each endStepMerging()
  int mergeGroup_ = 0;
  bool unsaved_ = false; ///< unsaved regardless of the history
};

} // namespace dewpoint::ui

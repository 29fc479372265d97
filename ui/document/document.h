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

/// The project and its history: the only door through which the window changes it. Every edit is a
/// named step that can be undone, and announces what changed.
class Document : public QObject {
  Q_OBJECT
public:
  explicit Document(QObject* parent = nullptr);
  ~Document() override;

  /// Valid until the next change: copy what is to be kept.
  const Project& project() const { return *project_; }
  /// The same, to be kept: it never changes.
  std::shared_ptr<const Project> state() const { return project_; }
  /// The parameters with which it is tracked, also those that come from its cameras.
  const ParameterValues& usedParameters() const { return usedParameters_; }
  /// The same while none is given: the method's defaults, and what the cameras say.
  const ParameterValues& defaultParameters() const { return defaultParameters_; }
  /// Whether a declared parameter in use is otherwise (setup::isChanged()).
  bool isChanged(const ParameterDeclaration& declaration) const;
  /// What the window does for its method; another from methodChanged() or replaced() on.
  const MethodPresentation& presentation() const;
  /// Of the project's method.
  MethodFamily methodFamily() const;
  QUndoStack* undoStack() const { return undoStack_; }
  /// Replaces the project by another one; the history starts from scratch. `unsaved`: the
  /// project is in no file as it is (recovered, or just made).
  void replace(Project project, bool unsaved = false);
  /// Whether there is something that is in no file.
  bool isUnsaved() const;

  /// Changes the project as one undoable step called `name` (an imperative: "Rename camera").
  /// Steps with the same `mergeKey` that follow each other become one: the moves of a drag. A state
  /// that checkProject() refuses changes nothing and returns its error; a change that changes
  /// nothing makes no step.
  Status edit(const QString& name, const std::function<void(Project&)>& change,
              const std::string& mergeKey = {});
  /// From here on nothing merges with what was: a drag has ended.
  void endMerging();

  /// Changes a parameter as an undoable step; steps of one slider drag merge. The first that is
  /// changed of those from the cameras gives all of them as they are in use. BadValue or UnknownKey
  /// leave everything as it was.
  Status setParameter(const std::string& key, double value);
  /// Gives a declared parameter its default again, or all that have another value, as an undoable
  /// step.
  void resetParameter(const std::string& key);
  void resetParameters();
  /// Chooses the method as an undoable step; parameters that it shares keep their values.
  void setMethod(const std::string& method);
  /// How the views are laid out: saved with the project, but no edit and no step.
  void setLayout(const std::string& layout);

  /// This state of the project is in this file now, which is the project's from now on. What was
  /// changed since is still unsaved. Written by ProjectSaver.
  void setSaved(const Project& state, const std::filesystem::path& file);

Q_SIGNALS:
  /// Another project is there.
  void replaced();
  /// An edit, an undo or a redo; the more special signals follow.
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
  /// Makes a state the present one and says what is new.
  void assign(const std::shared_ptr<const Project>& state);
  void announce(const ProjectChanges& changes);

  std::shared_ptr<const Project> project_;
  ParameterValues usedParameters_;    ///< of the project
  ParameterValues defaultParameters_; ///< of the project while it gives none
  QUndoStack* undoStack_;
  std::string mergeSuffix_; ///< differs after each endMerging()
  int drags_ = 0;
  bool unsaved_ = false; ///< whatever the history says
};

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/document.h"

#include "core/project/project.h"
#include "core/project/project_check.h"
#include "core/setup/default_parameters.h"
#include "core/tracking/catalog/method_catalog.h"
#include "ui/document/edit_command.h"
#include "ui/document/method_presentation.h"

#include <QCoreApplication>
#include <QUndoStack>

#include <algorithm>
#include <utility>

namespace dewpoint::ui {

namespace {

const char* const kSourceStep = "sources";

QString labelOf(const Project& project, const std::string& key) {
  const auto all = project.parameters.declarations();
  const auto found = std::ranges::find(all, key, &ParameterDeclaration::key);
  const std::string& text = found == all.end() ? key : found->label;
  return QCoreApplication::translate("Parameter", text.c_str());
}

} // namespace

Document::Document(QObject* parent)
    : QObject(parent), project_(std::make_shared<Project>()), undoStack_(new QUndoStack(this)) {}

Document::~Document() {
  undoStack_->clear(); // commands refer to this document
}

const MethodPresentation& Document::methodPresentation() const {
  return presentationOf(*project_);
}

MethodFamily Document::methodFamily() const {
  return tracking::methodFamily(project_->method);
}

void Document::replaceProject(Project project, bool unsaved) {
  project_ = std::make_shared<Project>(std::move(project));
  usedParameters_ = effectiveParameters(*project_);
  defaultParameters_ = setup::defaultParameters(*project_);
  unsaved_ = unsaved;
  undoStack_->clear();
  Q_EMIT projectReplaced();
}

bool Document::isUnsaved() const {
  return unsaved_ || !undoStack_->isClean();
}

Status Document::edit(const QString& name, const std::function<void(Project&)>& change,
                      const std::string& mergeKey) {
  auto after = std::make_shared<Project>(*project_);
  change(*after);
  if (auto good = checkProject(*after); !good) {
    return good;
  }
  if (changesBetween(*project_, *after).hasAny()) {
    const std::string key = mergeKey.empty() ? mergeKey : mergeKey + mergeSuffix_;
    undoStack_->push(new EditCommand(*this, name, project_, std::move(after), key));
  }
  return {};
}

Status Document::editSources(const QString& name, const std::function<void(Project&)>& change) {
  endStepMerging();
  return edit(name, change, kSourceStep);
}

Status Document::completeSources(const QString& name, const std::function<void(Project&)>& change) {
  // Undone as one step: alone, it would be reported again as soon as it was undone.
  const auto* last = dynamic_cast<const EditCommand*>(undoStack_->command(undoStack_->index() - 1));
  const bool joins = last != nullptr && last->mergeKey() == kSourceStep + mergeSuffix_;
  return edit(joins ? last->text() : name, change, kSourceStep);
}

void Document::endStepMerging() {
  mergeSuffix_ = " #" + std::to_string(++mergeGroup_);
}

void Document::assign(const std::shared_ptr<const Project>& state) {
  const std::shared_ptr<const Project> before = project_;
  project_ = state;
  if (state->file != before->file || state->windowLayout != before->windowLayout) {
    // Neither belongs to the history.
    auto adjusted = std::make_shared<Project>(*state);
    adjusted->file = before->file;
    adjusted->windowLayout = before->windowLayout;
    project_ = std::move(adjusted);
  }
  emitChanges(changesBetween(*before, *project_));
}

void Document::emitChanges(const ProjectChanges& changes) {
  const bool mayDiffer = changes.methodChanged || changes.parametersChanged ||
                         changes.calibrationChanged || changes.sourcesChanged ||
                         changes.volumeChanged;
  const ParameterValues now = mayDiffer ? effectiveParameters(*project_) : usedParameters_;
  const ParameterValues before = std::exchange(usedParameters_, now);
  if (mayDiffer) {
    defaultParameters_ = setup::defaultParameters(*project_);
  }
  Q_EMIT changed(changes);
  if (changes.methodChanged) {
    Q_EMIT methodChanged();
  } else {
    for (const auto& declaration : now.declarations()) {
      const std::string& key = declaration.key;
      if (before.at(key) != now.at(key) || before.isGiven(key) != now.isGiven(key)) {
        Q_EMIT parameterChanged(QString::fromStdString(key));
      }
    }
  }
  if (changes.targetsChanged) {
    Q_EMIT targetsChanged();
  }
  if (changes.calibrationChanged) {
    Q_EMIT calibrationChanged();
  }
  if (changes.backgroundImagesChanged) {
    Q_EMIT backgroundImagesChanged();
  }
  if (changes.volumeChanged) {
    Q_EMIT volumeChanged();
  }
  if (changes.personCorrectionsChanged) {
    Q_EMIT personCorrectionsChanged();
  }
  if (changes.correctionsChanged) {
    Q_EMIT correctionsChanged();
  }
  if (changes.sourcesChanged) {
    Q_EMIT sourcesChanged();
  }
}

Status Document::setParameter(const std::string& key, double value) {
  ParameterValues parameters = project_->parameters;
  if (!parameters.isGiven(key)) {
    // The others stay as the cameras gave them, and as they are shown.
    parameters = usedParameters_;
    parameters.markAllAsGiven();
  }
  if (auto status = parameters.set(key, value); !status) {
    return status;
  }
  return edit(
      tr("Change “%1”").arg(labelOf(*project_, key)),
      [&](Project& project) { project.parameters = parameters; }, "parameter " + key);
}

bool Document::isParameterChanged(const ParameterDeclaration& declaration) const {
  return setup::isChanged(usedParameters_, defaultParameters_, declaration);
}

void Document::resetParameter(const std::string& key) {
  (void)edit(tr("Reset “%1”").arg(labelOf(*project_, key)),
             [&](Project& project) { setup::resetParameter(project, key); });
}

void Document::resetParameters() {
  (void)edit(tr("Reset all parameters"), &setup::resetParameters);
}

void Document::setMethod(const std::string& method) {
  if (methodParameters(method).empty()) {
    return;
  }
  (void)edit(tr("Track with method “%1”").arg(QString::fromStdString(method)),
             [&](Project& project) {
               if (project.method != method) {
                 project.parameters = carryOverParameters(project.parameters, method);
                 project.method = method;
               }
             });
}

void Document::setLayout(const std::string& layout) {
  if (layout != project_->windowLayout) {
    auto changed = std::make_shared<Project>(*project_);
    changed->windowLayout = layout;
    project_ = std::move(changed);
  }
}

void Document::markSaved(const Project& state, const std::filesystem::path& file) {
  auto saved = std::make_shared<Project>(*project_);
  saved->file = file;
  project_ = std::move(saved);
  unsaved_ = false;
  if (changesBetween(state, *project_).hasAny()) {
    undoStack_->resetClean();
  } else {
    undoStack_->setClean();
  }
  Q_EMIT fileChanged();
}

} // namespace dewpoint::ui

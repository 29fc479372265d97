// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/parameter_panel.h"

#include "core/project/project.h"
#include "core/tracking/catalog/method_catalog.h"
#include "ui/document/document.h"
#include "ui/document/method_presentation.h"
#include "ui/panels/method_choice.h"
#include "ui/panels/parameter_row.h"
#include "ui/panels/volume_form.h"
#include "ui/style/type_scale.h"
#include "ui/text/method_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/collapsible_section.h"
#include "ui/widgets/named_widgets.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace dewpoint::ui {

namespace {

QString groupTitle(ParameterGroup group) {
  return QCoreApplication::translate("ParameterGroup",
                                     std::string(tracking::parameterGroupTitle(group)).c_str());
}

QString labelText(const ParameterDeclaration& declaration) {
  return QCoreApplication::translate("Parameter", declaration.label.c_str());
}

/// Groups of a method besides the essential one, in their order.
std::set<ParameterGroup> furtherGroups(const ParameterValues& parameters) {
  std::set<ParameterGroup> groups;
  for (const ParameterDeclaration& declaration : parameters.declarations()) {
    groups.insert(declaration.group);
  }
  groups.erase(ParameterGroup::Essential);
  return groups;
}

QLabel* smallLabel(const char* name, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setObjectName(QLatin1String(name));
  label->setFont(smallerFont(label->font()));
  label->setForegroundRole(QPalette::PlaceholderText);
  label->setWordWrap(true);
  return label;
}

/// What a parameter and the one that bounds it mean together, if the bound counts.
QString boundNote(const ParameterValues& used, const ParameterDeclaration& declaration) {
  const auto declarations = used.declarations();
  if (tracking::exceedsUpperLimit(used, declaration)) {
    const auto bound =
        std::ranges::find(declarations, declaration.upperLimitKey, &ParameterDeclaration::key);
    return ParameterPanel::tr("This value is larger than “%1”, so %2 is used instead.")
        .arg(labelText(*bound), parameterValueText(used.at(declaration.upperLimitKey)));
  }
  const auto bounded = std::ranges::find_if(declarations, [&](const ParameterDeclaration& other) {
    return other.upperLimitKey == declaration.key && tracking::exceedsUpperLimit(used, other);
  });
  return bounded == declarations.end()
             ? QString()
             : ParameterPanel::tr("This value is smaller than “%1”, so “%1” has no effect.")
                   .arg(labelText(*bounded));
}

} // namespace

ParameterPanel::ParameterPanel(Document& document, QWidget* parent)
    : QWidget(parent), document_(document) {
  setObjectName(QStringLiteral("parameterPanel"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  connect(&document_, &Document::projectReplaced, this, &ParameterPanel::rebuild);
  connect(&document_, &Document::methodChanged, this, &ParameterPanel::rebuild,
          Qt::QueuedConnection); // its own choice may be what changed it
  connect(&document_, &Document::parameterChanged, this, &ParameterPanel::showValue);
  connect(&document_, &Document::changed, this, [this](const ProjectChanges& changes) {
    if (changes.methodChanged) {
      return; // it is rebuilt
    }
    if ((changes.calibrationChanged || changes.sourcesChanged) && methods_ != nullptr) {
      methods_->showMethods(document_.project());
    }
    showMarks();
  });
  onRetranslate(this, [this] { rebuild(); });
}

void ParameterPanel::rebuild() {
  delete form_;
  rows_.clear();
  sections_.clear();
  methods_ = nullptr;
  resetAll_ = nullptr;
  form_ = new QWidget(this);
  form_->setObjectName(QStringLiteral("parameterForm"));
  column_ = new QVBoxLayout(form_);
  column_->setContentsMargins(12, 8, 12, 8);
  column_->setSpacing(8);
  if (document_.project().parameters.declarations().empty()) {
    auto* empty = new QLabel(tr("The parameters appear here once a project is open."), form_);
    empty->setWordWrap(true);
    column_->addWidget(empty);
  } else {
    addMethodChoice();
    addEssentialRows();
    addSections();
    showMarks();
  }
  column_->addStretch();
  layout()->addWidget(form_);
}

void ParameterPanel::addMethodChoice() {
  auto* label = new QLabel(tr("&Method"), form_);
  label->setFont(headingFont(label->font()));
  methods_ = new MethodChoice(form_);
  label->setBuddy(methods_);
  methods_->setToolTip(
      tr("Tracking method. Changing it restarts tracking; other settings are kept."));
  methods_->showMethods(document_.project());
  connect(methods_, &QComboBox::activated, this, [this, choice = methods_](int index) {
    document_.setMethod(choice->itemData(index).toString().toStdString());
  });
  column_->addWidget(label);
  column_->addWidget(methods_);
  const Method* method = findMethod(document_.project().method);
  if (method == nullptr) {
    return;
  }
  const MethodTexts words = methodTexts(*method);
  QLabel* sentence = smallLabel("methodSentence", form_);
  sentence->setForegroundRole(QPalette::WindowText);
  sentence->setText(words.description);
  column_->addWidget(sentence);
  // A name as in files and on the command line, and one of a paper: in no language.
  QLabel* name = smallLabel("qt_methodName", form_);
  name->setText(words.paper.isEmpty() ? words.name
                                      : words.name + QStringLiteral(" · ") + words.paper);
  column_->addWidget(name);
}

void ParameterPanel::addEssentialRows() {
  auto* head = new QHBoxLayout;
  auto* title = new QLabel(groupTitle(ParameterGroup::Essential), form_);
  title->setFont(headingFont(title->font()));
  resetAll_ = makeButton("parametersReset", form_);
  resetAll_->setText(tr("Reset all"));
  resetAll_->setToolTip(tr("Reset all parameters of this method to their defaults"));
  resetAll_->setFlat(true);
  connect(resetAll_, &QPushButton::clicked, &document_, &Document::resetParameters);
  head->addWidget(title, 1);
  head->addWidget(resetAll_);
  column_->addSpacing(8);
  column_->addLayout(head);
  for (const ParameterDeclaration& declaration : document_.project().parameters.declarations()) {
    if (declaration.group == ParameterGroup::Essential) {
      column_->addWidget(makeRow(declaration));
      column_->addSpacing(4);
    }
  }
}

void ParameterPanel::addSections() {
  if (document_.methodPresentation().limitsSearchToVolume) {
    addVolume();
  }
  for (const ParameterGroup group : furtherGroups(document_.project().parameters)) {
    const std::string_view title = tracking::parameterGroupTitle(group);
    CollapsibleSection* section =
        addSection(QStringLiteral("group_") +
                       QString::fromUtf8(title.data(), static_cast<qsizetype>(title.size())),
                   groupTitle(group));
    for (const ParameterDeclaration& declaration : document_.project().parameters.declarations()) {
      if (declaration.group == group) {
        section->addWidget(makeRow(declaration));
      }
    }
    sections_.emplace_back(group, section);
  }
}

void ParameterPanel::addVolume() {
  CollapsibleSection* section =
      addSection(QStringLiteral("group_volume"), tr("Volume of interest"));
  section->addWidget(new VolumeForm(document_, section));
  const auto show = [this, section] {
    const bool isSet = document_.project().volumeOfInterest.has_value();
    section->setAttentionHint(isSet ? tr("Targets are searched for only inside a box.")
                                    : QString());
    if (isSet) {
      section->setOpen(true);
    }
  };
  show();
  connect(&document_, &Document::volumeChanged, section, show);
}

CollapsibleSection* ParameterPanel::addSection(const QString& name, const QString& title) {
  auto* section = new CollapsibleSection(title, form_);
  section->setObjectName(name);
  section->setOpen(open_.contains(name));
  connect(section, &CollapsibleSection::openedByUser, this,
          [this, name](bool open) { open ? (void)open_.insert(name) : (void)open_.erase(name); });
  column_->addWidget(section);
  return section;
}

ParameterRow* ParameterPanel::makeRow(const ParameterDeclaration& declaration) {
  auto* row = new ParameterRow(declaration, form_);
  row->setValue(document_.usedParameters().at(declaration.key));
  connect(row, &ParameterRow::valueEdited, this, [this, key = declaration.key](double value) {
    if (!document_.setParameter(key, value)) {
      showValue(QString::fromStdString(key)); // refused: show what holds
    }
  });
  connect(row, &ParameterRow::resetRequested, this,
          [this, key = declaration.key] { document_.resetParameter(key); });
  rows_.push_back(row);
  return row;
}

ParameterRow* ParameterPanel::rowOf(const std::string& key) const {
  const auto found =
      std::ranges::find_if(rows_, [&](const ParameterRow* row) { return row->key() == key; });
  return found == rows_.end() ? nullptr : *found;
}

void ParameterPanel::showValue(const QString& key) {
  if (ParameterRow* row = rowOf(key.toStdString())) {
    row->setValue(document_.usedParameters().at(row->key()));
  }
}

void ParameterPanel::showMarks() {
  std::set<ParameterGroup> marked;
  for (const ParameterDeclaration& declaration : document_.usedParameters().declarations()) {
    ParameterRow* row = rowOf(declaration.key);
    if (row == nullptr) {
      continue; // of a method whose form is still to come
    }
    const bool isChanged = document_.isParameterChanged(declaration);
    row->setChanged(isChanged, document_.defaultParameters().at(declaration.key));
    row->setNote(boundNote(document_.usedParameters(), declaration));
    if (isChanged) {
      marked.insert(declaration.group);
    }
  }
  for (const auto& [group, section] : sections_) {
    section->setAttentionHint(marked.contains(group)
                                  ? tr("Some values in this group differ from their defaults.")
                                  : QString());
  }
  if (resetAll_ != nullptr) {
    resetAll_->setEnabled(!marked.empty());
  }
}

} // namespace dewpoint::ui

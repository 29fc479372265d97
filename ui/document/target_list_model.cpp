// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/target_list_model.h"

#include "core/project/project.h"
#include "ui/document/document.h"
#include "ui/style/target_colors.h"
#include "ui/style/theme.h"
#include "ui/widgets/named_widgets.h"

#include <QGuiApplication>

#include <utility>

namespace dewpoint::ui {

TargetListModel::TargetListModel(const Document& document, QObject* parent)
    : NameListModel(parent), document_(document) {
  connect(&document_, &Document::projectReplaced, this, &TargetListModel::refresh);
  connect(&document_, &Document::changed, this, &TargetListModel::refresh);
  refresh();
}

QVariant TargetListModel::data(const QModelIndex& index, int role) const {
  if (role == Qt::DecorationRole && checkIndex(index, CheckIndexOption::IndexIsValid)) {
    const auto& colors = isDarkPalette(QGuiApplication::palette()) ? onDark_ : onLight_;
    const auto target = static_cast<std::size_t>(index.row());
    return target < colors.size() ? makeColorChip(colors[target], 14) : QVariant();
  }
  return NameListModel::data(index, role);
}

void TargetListModel::refresh() {
  QStringList names;
  for (const Target& target : document_.project().targets) {
    names << QString::fromStdString(target.name);
  }
  const auto sources = displayColorSources(document_.project().targets, document_.methodFamily());
  onLight_ = targetColors(sources, DisplayBackground::Light);
  const auto before = std::exchange(onDark_, targetColors(sources, DisplayBackground::Dark));
  setNames(names);
  if (before != onDark_ && !names.isEmpty()) {
    Q_EMIT dataChanged(index(0), index(static_cast<int>(names.size()) - 1), {Qt::DecorationRole});
  }
}

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QLatin1String>
#include <QtGlobal>

namespace dewpoint::tests::test {

/// A dialog that a test fills in. `Holder` is a pointer to the dialog, owning or not.
template <class Holder> class DialogFields {
protected:
  /// The widget of the dialog with this object name.
  template <class Field> Field* field(const char* name) const {
    auto* found = dialog_->template findChild<Field*>(QLatin1String(name));
    Q_ASSERT(found != nullptr);
    return found;
  }

  Holder dialog_ = nullptr;
};

} // namespace dewpoint::tests::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/retranslation.h"

#include <QEvent>
#include <QWidget>

#include <utility>

namespace dewpoint::ui {

namespace {

class LanguageChangeFilter : public QObject {
public:
  LanguageChangeFilter(QWidget* widget, std::function<void()> retranslate)
      : QObject(widget), retranslate_(std::move(retranslate)) {
    widget->installEventFilter(this);
  }

  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched == parent() && event->type() == QEvent::LanguageChange) {
      retranslate_();
    }
    return false;
  }

private:
  std::function<void()> retranslate_;
};

} // namespace

void onRetranslate(QWidget* widget, std::function<void()> retranslate) {
  retranslate();
  new LanguageChangeFilter(widget, std::move(retranslate)); // the widget owns it
}

} // namespace dewpoint::ui

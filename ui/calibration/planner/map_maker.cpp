// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/planner/map_maker.h"

#include <QMetaObject>

#include <utility>

namespace dewpoint::ui {

MapMaker::MapMaker(QObject* parent)
    : QObject(parent), thread_([this](const std::stop_token& stop) { work(stop); }) {}

MapMaker::~MapMaker() {
  thread_.request_stop();
  thread_.join();
}

void MapMaker::ask(const Order& order) {
  if (last_ == order) {
    return;
  }
  last_ = order;
  {
    const std::scoped_lock lock(mutex_);
    waiting_ = order;
  }
  asked_.notify_one();
}

void MapMaker::work(const std::stop_token& stop) {
  RigMapper mapper;
  while (true) {
    Order order;
    {
      std::unique_lock lock(mutex_);
      if (!asked_.wait(lock, stop, [this] { return waiting_.has_value(); })) {
        return;
      }
      order = *std::exchange(waiting_, std::nullopt);
    }
    auto map = std::make_shared<const RigMap>(mapper.map(order.grid, order.pixelSigma, order.rig));
    QMetaObject::invokeMethod(
        this, [this, map] { Q_EMIT made(map); }, Qt::QueuedConnection);
  }
}

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jobs/long_job.h"

#include <QSignalSpy>
#include <QTest>
#include <QThread>

namespace dewpoint::tests {

class LongJobTest : public QObject {
  Q_OBJECT
private Q_SLOTS:
  void givesWhatItFoundInTheWindowsThread();
  void cancelledItChangesNothing();
  void runsAnotherOneAfterwards();
};

void LongJobTest::givesWhatItFoundInTheWindowsThread() {
  LongJob job;
  QSignalSpy ended(&job, &LongJob::ended);
  int answer = 0;
  QThread* where = nullptr;
  QVERIFY(job.start([&](const LongJob::Progress& progress) -> std::function<void()> {
    progress(0.5);
    return [&] {
      answer = 42;
      where = QThread::currentThread();
    };
  }));
  QVERIFY(!job.start([](const LongJob::Progress&) { return nullptr; })); // one at a time
  QVERIFY(ended.wait());
  QCOMPARE(answer, 42);
  QCOMPARE(where, QThread::currentThread());
  QVERIFY(!ended.at(0).at(0).toBool());
  QVERIFY(!job.isRunning());
}

void LongJobTest::cancelledItChangesNothing() {
  LongJob job;
  QSignalSpy ended(&job, &LongJob::ended);
  bool changed = false;
  job.start([&](const LongJob::Progress& progress) -> std::function<void()> {
    while (progress(-1.0)) {
      QThread::msleep(1);
    }
    return [&] { changed = true; };
  });
  job.cancel();
  QVERIFY(ended.wait());
  QVERIFY(ended.at(0).at(0).toBool());
  QVERIFY(!changed);
}

void LongJobTest::runsAnotherOneAfterwards() {
  LongJob job;
  int sum = 0;
  for (int k = 1; k <= 3; ++k) {
    QSignalSpy ended(&job, &LongJob::ended);
    QVERIFY(job.start([&sum, k](const LongJob::Progress&) -> std::function<void()> {
      return [&sum, k] { sum += k; };
    }));
    QVERIFY(ended.wait());
  }
  QCOMPARE(sum, 6);
}

} // namespace dewpoint::tests

QTEST_GUILESS_MAIN(dewpoint::tests::LongJobTest)
#include "long_job_test.moc"

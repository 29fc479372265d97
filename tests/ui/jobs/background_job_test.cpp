// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/gate.h"
#include "tests/ui/wait.h"
#include "tests/ui/window_test.h"
#include "ui/jobs/background_job.h"
#include "ui/jobs/job_queue.h"
#include "ui/jobs/latest_job.h"

#include <QSignalSpy>
#include <QTest>
#include <QThread>

#include <atomic>
#include <chrono>
#include <memory>
#include <utility>
#include <vector>

namespace dewpoint::tests {

using test::Gate;

class BackgroundJobTest : public QObject, private test::Waiting {
  Q_OBJECT
private Q_SLOTS:
  void givesWhatItFoundInTheWindowsThread();
  void canceledItChangesNothing();
  void runsAnotherOneAfterwards();
  void whoeverDropsItDoesNotWait();
  void whoeverDropsWhatWaitsDoesNotWait();
  void abandonedItMakesRoom();
  void ofThoseThatWaitOnlyTheNewestIsBegun();
  void whatIsOvertakenIsDroppedOrKept();
  void whatDoesNotNoticeIsLeftBehind();
  void theQueueWorksInOrderAndToTheEnd();

private:
  static bool allEnded() {
    return waitFor([] { return waitForDetachedJobs(std::chrono::milliseconds(0)); });
  }
};

void BackgroundJobTest::givesWhatItFoundInTheWindowsThread() {
  BackgroundJob job;
  QSignalSpy ended(&job, &BackgroundJob::ended);
  int answer = 0;
  QThread* where = nullptr;
  QVERIFY(job.start([&](const BackgroundJob::Progress& progress) -> std::function<void()> {
    progress(0.5);
    return [&] {
      answer = 42;
      where = QThread::currentThread();
    };
  }));
  QVERIFY(!job.start([](const BackgroundJob::Progress&) { return nullptr; })); // one at a time
  QVERIFY(ended.wait());
  QCOMPARE(answer, 42);
  QCOMPARE(where, QThread::currentThread());
  QVERIFY(!ended.at(0).at(0).toBool());
  QVERIFY(!job.isRunning());
}

void BackgroundJobTest::canceledItChangesNothing() {
  BackgroundJob job;
  QSignalSpy ended(&job, &BackgroundJob::ended);
  bool changed = false;
  job.start([&](const BackgroundJob::Progress& progress) -> std::function<void()> {
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

void BackgroundJobTest::runsAnotherOneAfterwards() {
  BackgroundJob job;
  int sum = 0;
  for (int k = 1; k <= 3; ++k) {
    QSignalSpy ended(&job, &BackgroundJob::ended);
    QVERIFY(job.start([&sum, k](const BackgroundJob::Progress&) -> std::function<void()> {
      return [&sum, k] { sum += k; };
    }));
    QVERIFY(ended.wait());
  }
  QCOMPARE(sum, 6);
}

/// With a destructor that joins, this test would never end.
void BackgroundJobTest::whoeverDropsItDoesNotWait() {
  const auto gate = std::make_shared<Gate>();
  const auto heard = std::make_shared<std::atomic<bool>>(false);
  auto job = std::make_unique<BackgroundJob>();
  QVERIFY(job->start([gate, heard](const BackgroundJob::Progress&) -> std::function<void()> {
    gate->pass();
    return [heard] { *heard = true; };
  }));
  QVERIFY(waitFor([&] { return gate->waiting() == 1; }));
  job.reset();
  QVERIFY(!waitForDetachedJobs(std::chrono::milliseconds(0)));
  gate->open();
  QVERIFY(allEnded());
  QCoreApplication::processEvents();
  QVERIFY(!*heard);
}

namespace {

/// Its destructor waits, as one that joins a thread does.
struct SlowToGo {
  explicit SlowToGo(std::shared_ptr<Gate> until) : gate(std::move(until)) {}
  ~SlowToGo() { gate->pass(); }
  SlowToGo(const SlowToGo&) = delete;
  SlowToGo& operator=(const SlowToGo&) = delete;

  std::shared_ptr<Gate> gate;
};

} // namespace

void BackgroundJobTest::whoeverDropsWhatWaitsDoesNotWait() {
  const auto gate = std::make_shared<Gate>();
  std::unique_ptr<SlowToGo, DetachedDeleter> one(new SlowToGo(gate));
  std::shared_ptr<SlowToGo> other(new SlowToGo(gate), DetachedDeleter());
  const auto copy = std::make_unique<std::shared_ptr<SlowToGo>>(other);
  one.reset();
  other.reset();
  QVERIFY(waitFor([&] { return gate->waiting() == 1; }));
  copy->reset(); // the last owner
  QVERIFY(waitFor([&] { return gate->waiting() == 2; }));
  QVERIFY(!waitForDetachedJobs(std::chrono::milliseconds(0)));
  gate->open();
  QVERIFY(allEnded());
}

void BackgroundJobTest::abandonedItMakesRoom() {
  const auto gate = std::make_shared<Gate>();
  BackgroundJob job;
  QSignalSpy ended(&job, &BackgroundJob::ended);
  int first = 0;
  int second = 0;
  job.start([gate, &first](const BackgroundJob::Progress&) -> std::function<void()> {
    gate->pass();
    return [&first] { ++first; };
  });
  job.abandon();
  QCOMPARE(ended.size(), 1);
  QVERIFY(ended.at(0).at(0).toBool());
  QVERIFY(job.start([&second](const BackgroundJob::Progress&) -> std::function<void()> {
    return [&second] { ++second; };
  }));
  QVERIFY(waitFor([&] { return second == 1; }));
  gate->open();
  QVERIFY(allEnded());
  QCoreApplication::processEvents();
  QCOMPARE(first, 0);
  QCOMPARE(ended.size(), 2);
}

void BackgroundJobTest::ofThoseThatWaitOnlyTheNewestIsBegun() {
  const auto gate = std::make_shared<Gate>();
  LatestJob job(LatestJob::SupersededJob::Kept);
  QSignalSpy idle(&job, &LatestJob::becameIdle);
  std::vector<int> done;
  for (const int number : {1, 2, 3}) {
    job.start([gate, number, &done](const BackgroundJob::Progress&) {
      gate->pass();
      return [number, &done] { done.push_back(number); };
    });
  }
  QVERIFY(job.isRunning());
  gate->open();
  QVERIFY(waitFor([&] { return idle.size() == 1; }));
  QCOMPARE(done, (std::vector<int>{1, 3}));
  QVERIFY(!job.isRunning());
}

void BackgroundJobTest::whatIsOvertakenIsDroppedOrKept() {
  const auto gate = std::make_shared<Gate>();
  LatestJob job(LatestJob::SupersededJob::Dropped);
  QSignalSpy idle(&job, &LatestJob::becameIdle);
  std::vector<int> done;
  const auto order = [&](int number) {
    job.start([gate, number, &done](const BackgroundJob::Progress&) {
      gate->pass();
      return [number, &done] { done.push_back(number); };
    });
  };
  order(1);
  order(2);
  gate->open();
  QVERIFY(waitFor([&] { return idle.size() == 1; }));
  QCOMPARE(done, (std::vector<int>{2}));
  order(3);
  job.cancel();
  QVERIFY(waitFor([&] { return idle.size() == 2; }));
  QCOMPARE(done, (std::vector<int>{2}));
}

void BackgroundJobTest::whatDoesNotNoticeIsLeftBehind() {
  const auto gate = std::make_shared<Gate>(); // stays closed
  LatestJob job(LatestJob::SupersededJob::Dropped);
  bool done = false;
  job.start([gate](const BackgroundJob::Progress&) -> std::function<void()> {
    gate->pass();
    return nullptr;
  });
  job.start([&done](const BackgroundJob::Progress&) { return [&done] { done = true; }; });
  QVERIFY(waitFor([&] { return done; }));
  gate->open();
  QVERIFY(allEnded());
}

void BackgroundJobTest::theQueueWorksInOrderAndToTheEnd() {
  const auto gate = std::make_shared<Gate>();
  const auto worked = std::make_shared<std::vector<int>>(); // in the queue's thread alone
  const auto told = std::make_shared<std::vector<int>>();
  auto queue = std::make_unique<JobQueue>();
  for (const int number : {1, 2, 3}) {
    queue->add([gate, worked, told, number]() -> std::function<void()> {
      if (number == 2) {
        gate->pass();
      }
      worked->push_back(number);
      return [told, number] { told->push_back(number); };
    });
  }
  QVERIFY(waitFor([&] { return !told->empty(); }));
  queue.reset(); // nobody listens any more, and all is done all the same
  gate->open();
  QVERIFY(allEnded());
  QCoreApplication::processEvents();
  QCOMPARE(*worked, (std::vector<int>{1, 2, 3}));
  QCOMPARE(*told, (std::vector<int>{1}));
}

DEWPOINT_CORE_TEST(BackgroundJobTest)

} // namespace dewpoint::tests

#include "background_job_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// The states of methods, as far as they are quick to compute; tests/cli has one of the suite.
#include "core/experiment/studies/box_fingerprint.h"
#include "core/experiment/studies/people_fingerprint.h"
#include "core/experiment/suite/suite_fingerprint.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(MethodFingerprints, OfBoxesAreOfTheMethodAlone) {
  const auto both = boxFingerprints({});
  ASSERT_TRUE(both) << errorSentence(both.error());
  ASSERT_EQ(both->size(), 6U); // histogram, sugandi and OpenCV's four
  EXPECT_NE(both->at("histogram"), both->at("sugandi"));
  EXPECT_EQ(both->at("sugandi").size(), 8U);
  EXPECT_NE(both->at("camshift-box"), both->at("meanshift-box"));
  const auto one = boxFingerprints({"sugandi"});
  ASSERT_TRUE(one);
  EXPECT_EQ(one->at("sugandi"), both->at("sugandi"));
}

TEST(MethodFingerprints, AMethodThatIsNotThereIsNamed) {
  for (const auto& none :
       {suiteFingerprints({"magic"}), boxFingerprints({"magic"}), peopleFingerprints({"magic"})}) {
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::NotFound);
    EXPECT_NE(errorSentence(none.error()).find("magic"), std::string::npos);
  }
}

} // namespace
} // namespace dewpoint::tests

#include "limes/adapt/marking.h"

#include <gtest/gtest.h>

#include <bit>
#include <random>

namespace limes {
namespace {

using Numbers = std::vector<int>;

TEST(Marking, DoerflerTakesTheWorstUntilTheyHaveTheShare) {
  const std::vector<double> squares{1, 4, 2, 3};
  EXPECT_EQ(marked(squares, MarkingKind::doerfler, 0.4), (Numbers{1}));
  EXPECT_EQ(marked(squares, MarkingKind::doerfler, 0.41), (Numbers{1, 3}));
  EXPECT_EQ(marked(squares, MarkingKind::doerfler, 0.7), (Numbers{1, 3}));
  EXPECT_EQ(marked(squares, MarkingKind::doerfler, 0.8), (Numbers{1, 2, 3}));
  EXPECT_EQ(marked(squares, MarkingKind::doerfler, 1), (Numbers{0, 1, 2, 3}));
}

// No smaller set has the share, over all subsets.
TEST(Marking, NoFewerPartsHaveTheShareThanDoerflersDo) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(0, 1);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<double> squares(10);
    for (double& x : squares)
      x = number(random);
    const double share = 0.05 + 0.9 * number(random);
    const auto sum_of = [&](unsigned set) {
      double sum = 0;
      for (unsigned i = 0; i < squares.size(); ++i)
        if ((set >> i & 1U) != 0) sum += squares[i];
      return sum;
    };
    const double whole = sum_of(1023);
    int least = 10;
    for (unsigned set = 1; set < 1024; ++set)
      if (sum_of(set) >= share * whole) least = std::min(least, std::popcount(set));
    const Numbers chosen = marked(squares, MarkingKind::doerfler, share);
    unsigned set = 0;
    for (const int i : chosen)
      set |= 1U << static_cast<unsigned>(i);
    EXPECT_EQ(static_cast<int>(chosen.size()), least);
    EXPECT_GE(sum_of(set), share * whole);
  }
}

// Errors 1, 2, 1.41, 1.73: the share is one of the largest error, not of its square.
TEST(Marking, MaximumComparesErrorsNotTheirSquares) {
  const std::vector<double> squares{1, 4, 2, 3};
  EXPECT_EQ(marked(squares, MarkingKind::maximum, 1), (Numbers{1}));
  EXPECT_EQ(marked(squares, MarkingKind::maximum, 0.8), (Numbers{1, 3}));
  EXPECT_EQ(marked(squares, MarkingKind::maximum, 0.6), (Numbers{1, 2, 3}));
  EXPECT_EQ(marked(squares, MarkingKind::maximum, 0.5), (Numbers{0, 1, 2, 3}));
}

TEST(Marking, AFractionIsRoundedUp) {
  const std::vector<double> squares{1, 5, 4, 2, 3};
  EXPECT_EQ(marked(squares, MarkingKind::fraction, 0.01), (Numbers{1}));
  EXPECT_EQ(marked(squares, MarkingKind::fraction, 0.2), (Numbers{1}));
  EXPECT_EQ(marked(squares, MarkingKind::fraction, 0.21), (Numbers{1, 2}));
  EXPECT_EQ(marked(squares, MarkingKind::fraction, 1), (Numbers{0, 1, 2, 3, 4}));
  // 0.07 * 100 is more than 7 in floating point
  EXPECT_EQ(marked(std::vector<double>(100, 1.0), MarkingKind::fraction, 0.07).size(), 7U);
}

TEST(Marking, OfEqualErrorsTheLowerNumbersAreFirst) {
  const std::vector<double> equal(6, 0.1);
  EXPECT_EQ(marked(equal, MarkingKind::doerfler, 0.5), (Numbers{0, 1, 2}));
  EXPECT_EQ(marked(equal, MarkingKind::fraction, 0.5), (Numbers{0, 1, 2}));
  EXPECT_EQ(marked(equal, MarkingKind::maximum, 1), (Numbers{0, 1, 2, 3, 4, 5}));
  const std::vector<double> pairs{1, 2, 1, 2, 1};
  EXPECT_EQ(marked(pairs, MarkingKind::doerfler, 5.0 / 7), (Numbers{0, 1, 3}));
  EXPECT_EQ(marked(pairs, MarkingKind::fraction, 0.6), (Numbers{0, 1, 3}));
}

TEST(Marking, NoErrorMarksNothing) {
  for (const MarkingKind kind :
       {MarkingKind::doerfler, MarkingKind::maximum, MarkingKind::fraction}) {
    EXPECT_EQ(marked(std::vector<double>(4, 0.0), kind, 1), Numbers{});
    EXPECT_EQ(marked(std::vector<double>{}, kind, 1), Numbers{});
  }
  EXPECT_EQ(marked(std::vector<double>{0, 1, 0}, MarkingKind::doerfler, 1), (Numbers{1}));
}

}  // namespace
}  // namespace limes
